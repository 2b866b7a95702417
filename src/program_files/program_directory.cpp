// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "program_files/program_directory.hpp"

#include <functional>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <utility>

#include "brachisto/math/index.hpp"
#include "brachisto/version.hpp"
#include "program_files/matrix_files.hpp"
#include "program_files/nl_file.hpp"
#include "report/in_full.hpp"
#include "transcription/arc_length.hpp"
#include "transcription/limited_time.hpp"

namespace brachisto::program_files {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// A file, and what is said of it.
struct DescribedFile {
  std::string name;
  const char* text;
  std::function<void(TextStream& out)> tell;
};

const char* formulation_of(const Transcription& problem) {
  if (dynamic_cast<const ArcLength*>(&problem) != nullptr) return "arc_length";
  if (dynamic_cast<const LimitedTime*>(&problem) != nullptr) {
    return "rolling_time, under limits";
  }
  return "rolling_time";
}

Json description(const SolvedProgram& program, const ProgramOutput& output,
                 double objective, const std::vector<DescribedFile>& files) {
  Transcription& problem = *program.problem;
  Json fixed = Json::array();
  for (int i = 0; i < problem.num_variables(); ++i) {
    if (problem.variable_range(i).single()) {
      fixed.push_back(word_of(problem.variable_name(i)));
    }
  }
  Json out = {{"brachisto", BRACHISTO_VERSION},
              {"formulation", formulation_of(problem)},
              {"elements", problem.mesh().num_elements()},
              {"degree", problem.mesh().degree},
              {"variables", problem.num_variables()},
              {"constraints", problem.num_constraints()},
              {"fixed_variables", std::move(fixed)},
              {"unit_of_length", program.units.length},
              {"unit_of_time", program.units.time},
              {"end_slope", nullptr},
              {"objective", objective},
              {"transit_time", objective * program.units.time}};
  if (program.end_slope) out["end_slope"] = *program.end_slope;
  if (output.format == ProgramFormat::Nl) {
    out["start"] = output.start == ProgramStart::Answer ? "answer" : "guess";
  }
  for (const DescribedFile& file : files) out["files"][file.name] = file.text;
  return out;
}

/// The program's own order.
NlNumbering own_order(const Transcription& problem) {
  NlNumbering out;
  out.variables.resize(at(problem.num_variables()));
  std::iota(out.variables.begin(), out.variables.end(), 0);
  out.constraints.resize(at(problem.num_constraints()));
  std::iota(out.constraints.begin(), out.constraints.end(), 0);
  return out;
}

}  // namespace

fs::path ProgramOutput::directory() const {
  if (format == ProgramFormat::Matrices) return path;
  const fs::path parent = path.parent_path();
  return parent.empty() ? fs::path(".") : parent;
}

std::vector<std::string> ProgramOutput::names() const {
  if (format == ProgramFormat::Matrices) {
    return {"jacobian.mtx",    "hessian.mtx", "kkt.mtx",    "gradient.mtx",
            "constraints.mtx", "x.mtx",       "lambda.mtx", "program.row",
            "program.col",     "program.json"};
  }
  fs::path stub = path.has_filename() ? path.filename() : "program.nl";
  if (stub.extension() == ".nl") stub.replace_extension();
  return {stub.string() + ".row", stub.string() + ".col",
          stub.string() + ".json", stub.string() + ".nl"};
}

nlohmann::ordered_json write_program(const SolvedProgram& program,
                                     const ProgramOutput& output) {
  Transcription& problem = *program.problem;
  const double objective = program.objective();
  const std::vector<std::string> names = output.names();
  std::vector<DescribedFile> files;
  const auto add = [&](const char* text,
                       std::function<void(TextStream & out)> tell) {
    files.push_back({names[files.size()], text, std::move(tell)});
  };
  Json described;
  const auto say = [&described](TextStream& out) {
    out << described.dump(2) << '\n';
    out.flush();
  };

  std::unique_ptr<ProgramInFormulas> formulas;
  std::optional<ProgramMatrices> matrices;
  NlNumbering order;
  if (output.format == ProgramFormat::Nl) {
    formulas = in_formulas(problem);
    order = NlNumbering(problem, *formulas);
  } else {
    matrices.emplace(problem, program.answer);
    order = own_order(problem);
  }
  const auto rows = [&](TextStream& out) {
    put_row_names(problem, order, out);
  };
  const auto cols = [&](TextStream& out) {
    put_col_names(problem, order, out);
  };
  if (output.format == ProgramFormat::Nl) {
    add("names of the constraints and of the objective", rows);
    add("names of the variables", cols);
    add("this description", say);
    add("the program", [&](TextStream& out) {
      put_nl(
          problem, *formulas, order,
          output.start == ProgramStart::Answer ? program.answer : program.guess,
          out);
    });
  } else {
    add("first derivatives of the constraints",
        [&](TextStream& out) { matrices->put_jacobian(out); });
    add("second derivatives of the Lagrangian, lower triangle",
        [&](TextStream& out) { matrices->put_hessian(out); });
    add("both as one matrix, [H, Jᵀ; J, 0], lower triangle",
        [&](TextStream& out) { matrices->put_kkt(out); });
    add("first derivatives of the objective",
        [&](TextStream& out) { put_vector(matrices->gradient(), out); });
    add("values of the constraints",
        [&](TextStream& out) { put_vector(matrices->constraints(), out); });
    add("the answer",
        [&](TextStream& out) { put_vector(program.answer.x, out); });
    add("its multipliers, of the Lagrangian f + λᵀg",
        [&](TextStream& out) { put_vector(program.answer.lambda, out); });
    add("names of the rows of the Jacobian, and of the objective", rows);
    add("names of its columns", cols);
    add("this description", say);
  }
  described = description(program, output, objective, files);

  std::vector<report::StreamedFile> streamed;
  for (const DescribedFile& file : files) {
    streamed.push_back({file.name, [&file](const report::TextSink& put) {
                          TextStream out(put);
                          file.tell(out);
                        }});
  }
  report::write_streamed_files(output.directory(), streamed, output.force);
  return described;
}

}  // namespace brachisto::program_files
