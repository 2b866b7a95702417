// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/io/problem_file.hpp"

#include "io/consistency.hpp"
#include "io/findings.hpp"
#include "io/input_bytes.hpp"
#include "io/input_tree.hpp"
#include "io/path_points.hpp"
#include "io/problem_reader.hpp"

namespace brachisto::io {

ProblemFile read_problem_file(const std::filesystem::path& path,
                              const std::vector<std::string>& overrides) {
  return read_problem_text(read_problem_bytes(path), path.string(), overrides);
}

ProblemFile read_problem_text(std::string_view text, const std::string& name,
                              const std::vector<std::string>& overrides) {
  Findings findings;
  const InputTree input = read_input_tree(text, name, overrides, findings);
  ProblemFile problem = ProblemReader(findings).read(input.root);
  read_path_points(input, nullptr, problem, findings);
  check_body(input.root, problem, findings);
  check_mesh(input.root, problem, findings);
  check_solver(input.root, problem, findings);
  check_scene(input.root, problem, findings);
  findings.throw_if_any(input.sources);
  problem.warnings = findings.warnings(input.sources);
  return problem;
}

}  // namespace brachisto::io
