// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "reference/rows.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <limits>
#include <stdexcept>

#include "brachisto/study/solve.hpp"
#include "math/cpu_clock.hpp"
#include "peers/nl_program.hpp"
#include "posed/guess.hpp"
#include "program_files/nl_file.hpp"
#include "support/limited_scenes.hpp"
#include "support/reference_values.hpp"

namespace brachisto::benchmarks {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kWanted = 1e-10;

std::string file_name(std::string name) {
  std::string out;
  for (const char c : name) {
    const auto letter = static_cast<unsigned char>(c);
    if (std::isalnum(letter) != 0) {
      out += static_cast<char>(std::tolower(letter));
    } else if (!out.empty() && out.back() != '_') {
      out += '_';
    }
  }
  return out + ".nl";
}

void write_nl(const Classic& classic, const Mesh& mesh,
              const nlp::Problem& program, const std::filesystem::path& path) {
  const auto formulas = classic.in_formulas(mesh);
  const program_files::NlNumbering order(program, *formulas);
  std::ofstream file(path);
  program_files::TextStream out(
      [&file](std::string_view text) { file << text; });
  program_files::put_nl(program, *formulas, order,
                        ocp::guess(*classic.problem, mesh), out);
}

/// The file by AMPL's library if it is there, else the program itself.
void ask_peer(const Classic& classic, const Mesh& mesh,
              const std::filesystem::path& path, ClassicRow& row) {
  NlProgram read;
  if (reads_nl_files()) {
    read = read_nl_file(path);
  } else {
    read = {classic.problem->on(mesh), ocp::guess(*classic.problem, mesh)};
  }
  read.start.lambda.clear();
  IpoptOptions options;
  options.tolerance = 1e-9;
  options.complementarity = 1e-12;
  options.linear_solver = LinearSolver::Mumps;
  constexpr double kSeconds = 20.0;
  options.stop = StopCondition(kSeconds, nullptr);
  const double began = thread_cpu_seconds();
  const SolverResult result =
      solve_with_ipopt(*read.problem, read.start, options);
  row.peer_seconds = thread_cpu_seconds() - began;
  row.peer_status = name(result.status);
  row.peer_value = kNone;
  if (!result.point.x.empty() && read.problem->set_point(result.point.x)) {
    row.peer_value = classic.reported(read.problem->eval_f());
  }
}

}  // namespace

ClassicRow measured(const Classic& classic,
                    const std::filesystem::path& folder) {
  if (classic.second.by.empty()) {
    throw std::logic_error(classic.name + ": no second method is named");
  }
  ocp::SolveBy by = classic.by;
  by.tolerance = kWanted;
  const ocp::Answer answer = ocp::solve(*classic.problem, by);
  const Mesh& mesh = answer.made_of.mesh;
  ClassicRow row{.classic = &classic,
                 .value = classic.reported(answer.cost),
                 .estimate = std::abs(classic.factor) * answer.estimated_error,
                 .seconds = answer.seconds,
                 .verified = answer.verified(),
                 .why_not = answer.why_not(),
                 .elements = mesh.num_elements(),
                 .variables = 0,
                 .constraints = 0,
                 .junctions = answer.junctions,
                 .work = {},
                 .peer_status = {},
                 .peer_value = kNone,
                 .peer_seconds = kNone,
                 .nl_file = file_name(classic.name)};
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
    by.tolerance = tolerance;
    const ocp::Answer here = ocp::solve(*classic.problem, by);
    row.work.push_back(
        {tolerance,
         std::abs(classic.reported(here.cost) - classic.second.value),
         std::abs(classic.factor) * here.estimated_error, here.seconds,
         here.verified()});
  }
  if (mesh.boundaries.empty()) return row;
  const auto program = classic.problem->on(mesh);
  row.variables = program->num_variables();
  row.constraints = program->num_constraints();
  write_nl(classic, mesh, *program, folder / row.nl_file);
  ask_peer(classic, mesh, folder / row.nl_file, row);
  return row;
}

std::vector<RollingRow> rolling_rows() {
  std::vector<RollingRow> out;
  const auto add = [&](const std::string& name, const Scene& scene, double tau,
                       const char* by, bool limited) {
    SolveOptions options;
    options.use<Collocation>().discretisation.tolerance =
        limited ? 1e-10 : 1e-11;
    const double began = thread_cpu_seconds();
    const Solution solution = solve(scene, options);
    out.push_back({name, by, limited,
                   solution.verified() ? solution.motion()->tau() : kNone, tau,
                   thread_cpu_seconds() - began, solution.verified()});
  };
  for (const testing::ReferenceValue& row : testing::kReferenceValues) {
    add(row.name, row.scene(), row.tau,
        row.source == testing::Source::ClosedForm ? "cycloid" : "shooting",
        false);
  }
  for (const testing::LimitedReference& row : testing::limited_references()) {
    add(row.name, row.scene, row.tau,
        row.source == testing::LimitedReference::Source::ClosedForm
            ? "closed form"
            : "shooting over arcs",
        true);
  }
  return out;
}

}  // namespace brachisto::benchmarks
