// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/yaml_writer.hpp"

#include <yaml-cpp/emitter.h>

#include <nlohmann/json.hpp>

#include "io/effective_input.hpp"
#include "io/findings.hpp"
#include "io/input_tree.hpp"

namespace brachisto::io {

namespace {

namespace fs = std::filesystem;

/// Maps in lines, lists within one.
void emit(YAML::Emitter& out, const Json& value) {
  if (value.is_object()) {
    out << YAML::BeginMap;
    for (const auto& [key, item] : value.items()) {
      out << YAML::Key << key << YAML::Value;
      emit(out, item);
    }
    out << YAML::EndMap;
  } else if (value.is_array()) {
    out << YAML::Flow << YAML::BeginSeq;
    for (const Json& item : value) emit(out, item);
    out << YAML::EndSeq;
  } else if (value.is_string()) {
    out << value.get_ref<const std::string&>();
  } else if (value.is_null()) {
    out << YAML::Null;
  } else {
    // Numbers with the digits that they need, and true and false.
    out << value.dump();
  }
}

}  // namespace

std::string problem_yaml(std::string_view text, const std::string& name,
                         const std::vector<std::string>& overrides,
                         const fs::path& directory) {
  Findings findings;
  const InputTree input = read_input_tree(text, name, overrides, findings);
  findings.throw_if_any(input.sources);
  Json document = stated_input(input.root);
  const Json::json_pointer points("/scene/path/file");
  if (document.contains(points)) {
    const fs::path file =
        fs::path(name).parent_path() / document.at(points).get<std::string>();
    document[points] = fs::absolute(file)
                           .lexically_proximate(fs::absolute(directory))
                           .string();
  }
  YAML::Emitter out;
  emit(out, document);
  return std::string(out.c_str()) + "\n";
}

}  // namespace brachisto::io
