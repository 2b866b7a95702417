// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// result_fields(): every key of a result document, once, those of the answer
/// and of the search in files of their own. The document, its reference in
/// docs/results.md and its schema are made from it.

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "brachisto/io/problem_file.hpp"
#include "brachisto/report/result.hpp"
#include "brachisto/study/solve.hpp"
#include "io/effective_input.hpp"
#include "report/provenance.hpp"
#include "report/result_field.hpp"

namespace brachisto::report {

namespace {

using Texts = std::optional<std::vector<std::string>>;

/// What a document tells of.
struct Told {
  const Solution* solution;
  const DesignAnswer* design;  ///< that chose the body; null: none did
};

/// The cross-check if it can be compared with the answer.
const CrossCheck* comparable(const Solution& solution) {
  const bool both = solution.extremal && solution.extremal->solved &&
                    solution.motion() != nullptr;
  return both ? &*solution.extremal : nullptr;
}

Fields<Solution> verdict_fields() {
  using S = const Solution&;
  return {{"schema_version", "", "of the layout of this document",
           [](S) { return kSchemaVersion; }},
          {"status", "", "how the solver stopped: solved, or why not",
           [](S s) { return name(s.status); }},
          {"message", "", "what failed, where, and what to try",
           &Solution::message},
          {"warnings", "", "what the problem file says but hardly means",
           &Solution::warnings},
          {"verified", "",
           "every check of the certificate passed: the answer is an "
           "extremal to the wanted accuracy",
           &Solution::verified},
          {"not_verified_because", "",
           "the checks that failed, with values and thresholds",
           [](S s) {
             const bool judged =
                 s.motion() != nullptr || s.discrete() != nullptr;
             return judged ? Texts(s.not_verified_because()) : Texts();
           }},
          {"feasible", "",
           "the body can do what the answer asks for: it does not "
           "lift off, and the track does not fold",
           [](S s) {
             return s.verified() ? std::optional(s.feasible()) : std::nullopt;
           }},
          {"infeasible_because", "", "why not",
           [](S s) {
             return s.verified() ? Texts(s.infeasible_because()) : Texts();
           }},
          {"undecided_because", "",
           "what of it is smaller than the error of this mesh, so that a finer "
           "one has to decide; it counts as feasible",
           [](S s) {
             return s.verified() ? Texts(s.undecided_because()) : Texts();
           }}};
}

/// The checks stand in it twice: by name, and in their list with thresholds.
Field<Solution> certificate_field() {
  Fields<Solution> fixed;
  for (const auto& [check, meaning] :
       {std::pair{"kkt_residual", "scaled KKT residual, computed anew"},
        std::pair{"reintegration_error", "of the motion integrated in time"},
        std::pair{"energy_drift", "of the energy along it"},
        std::pair{"contact_error", "of both contacts"},
        std::pair{"second_order", "0: a minimum between the fixed ends"}}) {
    fixed.push_back({check, "", meaning, [check = check](const Solution& s) {
                       const Check* found = s.certificate.find(check);
                       return found ? std::optional(found->value)
                                    : std::nullopt;
                     }});
  }
  fixed.push_back({"tau", "", "τ by multiple shooting, if it was cross-checked",
                   [](const Solution& s) {
                     return comparable(s) ? std::optional(s.motion()->tau())
                                          : std::nullopt;
                   }});
  fixed.push_back(of_part<Solution>(
      comparable, {"extremal_tau", "", "its τ", &CrossCheck::tau}));
  fixed.push_back(of_part<Solution>(
      comparable, {"extremal_difference", "", "relative, of both τ",
                   &CrossCheck::difference}));
  const Field<Certificate> checks =
      list("checks", "all checks", &Certificate::checks,
           {{"name", "", "also a key of the certificate", &Check::name},
            {"value", "", "what was found", &Check::value},
            {"threshold", "", "passed if the value is not greater",
             &Check::threshold},
            {"passed", "", "whether it is", &Check::passed},
            {"where", "", "on the path",
             [](const Check& c) { return only_if(!c.where.empty(), c.where); },
             true}});
  std::vector<FieldText> texts = texts_of(fixed);
  texts.push_back(checks.text);
  return {{"certificate", "object", "",
           "values of the checks, of which there may be more", texts, true},
          [=](const Solution& s) {
            Json json = written(fixed, s);
            for (const Check& check : s.certificate.checks) {
              json[check.name] = check.value;
            }
            json["checks"] = checks.write(s.certificate);
            return json;
          }};
}

Json effective_input(const Solution& solution) {
  return io::effective_input(solution.scene, solution.options);
}

Fields<Told> origin_fields() {
  const auto input = [](const Told& told) {
    Json document = effective_input(*told.solution);
    // Parts, which a design may move, are not echoed.
    if (told.design != nullptr && told.design->plan.free_parts.empty()) {
      io::ProblemFile problem;
      problem.scene = told.solution->scene;
      problem.design = told.design->plan;
      document["design"] = io::effective_section(problem, "design");
    }
    return document;
  };
  const auto made = [](const Solution&) {
    static const Provenance here = provenance();
    return &here;
  };
  const auto as_in_input = [](std::string_view name, std::string_view meaning) {
    return FieldText{name, "object", "", meaning, {}, true};
  };
  return {
      object<Told>(
          "provenance", "", "what made the result", &Told::solution,
          joined<Solution>(
              {of_part<Solution>(made, version_fields()),
               {{as_in_input("options", "as in input"),
                 [](const Solution& s) {
                   Json options = effective_input(s);
                   options.erase("scene");
                   return options;
                 }},
                {"linear_solver", "", "that Ipopt used on the final mesh",
                 [](const Solution& s) {
                   const auto used = s.effort.final_mesh().linear_solver;
                   return used ? std::optional(name(*used)) : std::nullopt;
                 }}}})),
      {as_in_input("scene", "as in input"),
       [](const Told& told) {
         return effective_input(*told.solution)["scene"];
       }},
      {as_in_input("input",
                   "the effective input, defaults filled in: a problem file"),
       input}};
}

/// All but where the result comes from.
const Fields<Told>& outcome_fields() {
  static const Fields<Told> table = joined<Told>(
      {of_part<Told>(&Told::solution,
                     joined<Solution>({verdict_fields(), answer_fields(),
                                       effort_fields(), search_fields()})),
       {of_part<Told>(&Told::design, design_field())},
       of_part<Told>(&Told::solution, {seconds_field(), certificate_field()})});
  return table;
}

/// A function of the input, and of the machine, as seconds are.
Field<Solution> forecast_field() {
  const Fields<Forecast> fields{
      {"nodes", "", "of the mesh; a bound where it follows from the tolerance",
       &Forecast::nodes},
      {"memory_bytes", "bytes", "largest resident set of the process",
       &Forecast::bytes},
      {"seconds", "s", "processor time on this machine", &Forecast::seconds}};
  return {{"forecast", "object", "",
           "what the solve was to take, to a factor of two or so",
           texts_of(fields)},
          [=](const Solution& s) {
            if (!validate(s.scene).empty()) return Json();
            const auto size = forecast(s.scene, s.options);
            return size ? written(fields, *size) : Json();
          }};
}

const Fields<Told>& result_fields() {
  static const Fields<Told> table =
      joined<Told>({outcome_fields(),
                    {of_part<Told>(&Told::solution, forecast_field())},
                    origin_fields()});
  return table;
}

}  // namespace

std::string result_json(const Solution& solution, const DesignAnswer* design) {
  return written(result_fields(), {&solution, design}).dump(2) + "\n";
}

Json outcome_document(const Solution& solution) {
  return written(outcome_fields(), {&solution, nullptr});
}

std::vector<FieldText> result_texts() {
  return texts_of(result_fields());
}

std::string input_json(const Scene& scene, const SolveOptions& options) {
  Json json = {{"schema_version", kSchemaVersion}, {"valid", true}};
  json.update(io::effective_input(scene, options));
  return json.dump(2) + "\n";
}

std::string result_reference_markdown() {
  const std::string text =
      "| key | type | unit | meaning |\n"
      "| --- | --- | --- | --- |\n";
  return text + markdown_rows(result_texts());
}

std::string result_schema() {
  Json schema = {{"$schema", "http://json-schema.org/draft-07/schema#"},
                 {"title", "Result of brachisto solve"}};
  schema.update(schema_of(result_texts(), false));
  // Of a document that has nothing else but a status and a message: apart from
  // the properties, which are the keys of a result.
  Json mistake;
  for (const char* text : {"file", "key", "message"}) {
    mistake[text] = {{"type", "string"}};
  }
  for (const char* number : {"line", "column"}) {
    mistake[number] = {{"type", "integer"}};
  }
  schema["patternProperties"]["^errors$"] = {
      {"type", "array"},
      {"description", "of input that is refused: its mistakes"},
      {"items", {{"type", "object"}, {"properties", std::move(mistake)}}}};
  return schema.dump(2) + "\n";
}

std::string markdown_rows(const std::vector<FieldText>& fields,
                          const std::string& path) {
  std::string text;
  for (const FieldText& field : fields) {
    const bool items = field.type == "array" && !field.parts.empty();
    const std::string name =
        fmt::format("{}{}{}", path, field.name, items ? "[]" : "");
    text += fmt::format("| `{}` | {} | {} | {} |\n", name, field.type,
                        field.unit, field.meaning) +
            markdown_rows(field.parts, name + ".");
  }
  return text;
}

Json schema_of(const std::vector<FieldText>& fields, bool open) {
  Json properties = Json::object();
  for (const FieldText& field : fields) {
    Json schema = {{"type", {field.type, "null"}}};
    if (field.type == "object" && !field.parts.empty()) {
      schema.update(schema_of(field.parts, field.open));
      schema["type"] = {"object", "null"};
    } else if (!field.parts.empty()) {
      schema["items"] = schema_of(field.parts, field.open);
    }
    schema["description"] =
        field.unit.empty() ? std::string(field.meaning)
                           : fmt::format("{} [{}]", field.meaning, field.unit);
    properties[field.name] = std::move(schema);
  }
  return {{"type", "object"},
          {"properties", std::move(properties)},
          {"additionalProperties", open}};
}

}  // namespace brachisto::report
