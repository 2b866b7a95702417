// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/input_tree.hpp"

#include <fmt/format.h>

#include "brachisto/io/problem_file.hpp"
#include "io/overrides.hpp"
#include "io/source_text.hpp"

namespace brachisto::io {

namespace {

/// The tree of a file, which has to contain something.
YamlValue read_tree(std::string_view text, const std::string& name,
                    Findings& findings) {
  try {
    YamlValue root = parse_yaml(prepared_text(text, 0), 0, findings);
    if (root.kind == YamlValue::Kind::Null) {
      throw SyntaxError({0, 1, 1},
                        "the file is empty; expected at least the "
                        "key scene");
    }
    return root;
  } catch (const SyntaxError& error) {
    throw InputError(
        {{name, error.position.line, error.position.column, "", error.what()}});
  }
}

}  // namespace

InputTree read_input_tree(std::string_view text, const std::string& name,
                          const std::vector<std::string>& overrides,
                          Findings& findings) {
  InputTree input{read_tree(text, name, findings), {name}};
  for (const std::string& change : overrides) {
    input.sources.push_back("--set " + printable(change));
    apply_override(input.root, change,
                   static_cast<int>(input.sources.size()) - 1, findings);
  }
  return input;
}

}  // namespace brachisto::io
