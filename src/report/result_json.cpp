// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// result_fields(): every key of a result document, once. The document, its
/// reference in docs/results.md and its schema are made from it.

#include "brachisto/report/result.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "io/effective_input.hpp"
#include "report/provenance.hpp"
#include "report/result_field.hpp"
#include "study/answer_kinds.hpp"

namespace brachisto::report {

namespace {

using Texts = std::optional<std::vector<std::string>>;

/// The answer, which there is only if it is verified.
const Motion* answer_of(const Solution& solution) {
  return solution.verified() ? solution.motion() : nullptr;
}
const PathDiagnostics* diagnostics_of(const Solution& solution) {
  return solution.verified() ? &*solution.diagnostics : nullptr;
}
const PathDiagnostics* rolling_diagnostics_of(const Solution& solution) {
  return solution.scene.body.rolls() ? diagnostics_of(solution) : nullptr;
}
const Certificate* certificate_of(const Solution& solution) {
  return &solution.certificate;
}
template <class Whole>
const Whole* itself(const Whole& whole) {
  return &whole;
}

/// The cross-check if it can be compared with the answer.
const CrossCheck* comparable(const Solution& solution) {
  const bool both = solution.extremal && solution.extremal->solved &&
                    solution.motion() != nullptr;
  return both ? &*solution.extremal : nullptr;
}

Fields<Solution> verdict_fields() {
  using S = const Solution&;
  return {
      value<Solution>("schema_version", "", "of the layout of this document",
                      [](S) { return kSchemaVersion; }),
      value<Solution>("status", "",
                      "how the solver stopped: solved, or why not",
                      [](S s) { return name(s.status); }),
      value<Solution>("message", "", "what failed, where, and what to try",
                      &Solution::message),
      value<Solution>("warnings", "",
                      "what the problem file says but hardly means",
                      &Solution::warnings),
      value<Solution>("verified", "",
                      "every check of the certificate passed: the answer is an "
                      "extremal to the wanted accuracy",
                      &Solution::verified),
      value<Solution>("not_verified_because", "",
                      "the checks that failed, with values and thresholds",
                      [](S s) {
                        const bool judged =
                            s.motion() != nullptr || s.discrete() != nullptr;
                        return judged ? Texts(s.not_verified_because())
                                      : Texts();
                      }),
      value<Solution>("feasible", "",
                      "the body can do what the answer asks for: it does not "
                      "lift off, and the track does not fold",
                      [](S s) {
                        return s.verified() ? std::optional(s.feasible())
                                            : std::nullopt;
                      }),
      value<Solution>("infeasible_because", "", "why not", [](S s) {
        return s.verified() ? Texts(s.infeasible_because()) : Texts();
      })};
}

Fields<Motion> motion_fields() {
  return {value<Motion>("tau", "", "τ = T √(2g/H), transit time without units",
                        &Motion::tau),
          value<Motion>("transit_time", "s", "T", &Motion::transit_time),
          value<Motion>("centre_path_length", "m",
                        "S, length of the path of the centre",
                        &Motion::centre_path_length),
          value<Motion>("rail_length", "m",
                        "S + r (β₀ − β_end), signed length of the track",
                        &Motion::rail_length),
          value<Motion>("start_angle", "rad", "β₀, slope angle at A",
                        &Motion::start_angle),
          value<Motion>("end_angle", "rad", "β_end, slope angle at B",
                        &Motion::end_angle),
          value<Motion>("rotation", "rad", "θ_end − θ_m; null for a bead",
                        &Motion::rotation)};
}

/// A range over u > 0. What is not finite is null in JSON: no bound.
Fields<PathDiagnostics> range_fields(std::string_view unit,
                                     Extreme PathDiagnostics::*min,
                                     Extreme PathDiagnostics::*max,
                                     Extreme PathDiagnostics::*after_rise) {
  using D = const PathDiagnostics&;
  return {
      value<PathDiagnostics>("min", unit, "smallest value, the start left out",
                             [=](D d) { return (d.*min).value; }),
      value<PathDiagnostics>("max", unit, "greatest value, the start left out",
                             [=](D d) { return (d.*max).value; }),
      value<PathDiagnostics>("min_at_start", "",
                             "the smallest is the limit at the start",
                             [=](D d) { return (d.*min).at_start; }),
      value<PathDiagnostics>("max_at_start", "",
                             "the greatest is the limit at the start",
                             [=](D d) { return (d.*max).at_start; }),
      value<PathDiagnostics>("min_after_rise", unit,
                             "smallest value after the first rise",
                             [=](D d) { return (d.*after_rise).value; })};
}

void add_diagnostics(Fields<Solution>& fields) {
  using D = PathDiagnostics;
  Fields<D> force =
      range_fields("m g", &D::min_normal_force, &D::max_normal_force,
                   &D::normal_force_after_rise);
  force.push_back(value<D>("x_at_max", "m", "x of the track at the greatest",
                           [](const D& d) { return d.max_normal_force.x; }));
  fields.push_back(object<Solution>("normal_force", "m g",
                                    "R_n, which presses body and track",
                                    diagnostics_of, std::move(force)));
  fields.push_back(object<Solution>(
      "friction", "",
      "shares of the transit time in which the body needs a friction "
      "coefficient above",
      rolling_diagnostics_of,
      {value<D>("share_above_0.3", "", "0.3", &D::friction_above_0_3),
       value<D>("share_above_0.5", "", "0.5", &D::friction_above_0_5),
       value<D>("share_above_1", "", "1", &D::friction_above_1)}));
  fields.push_back(object<Solution>(
      "curvature", "1/m", "κ_b of the track; null: no bound, it folds",
      diagnostics_of,
      range_fields("1/m", &D::min_curvature, &D::max_curvature,
                   &D::curvature_after_rise)));
  fields.push_back(object<Solution>(
      "at_start", "", "limits at the start", diagnostics_of,
      {value<D>("normal_force", "m g", "of R_n",
                [](const D& d) { return d.at_start.normal_force; }),
       value<D>("curvature", "1/m", "of κ_b; null: −∞",
                [](const D& d) { return d.at_start.curvature; })}));
  splice(
      fields, rolling_diagnostics_of,
      {value<D>("fold_margin", "", "smallest 1 − r κ_c; the track folds at 0",
                [](const D& d) { return d.min_fold_margin.value; })});
}

void add_size(Fields<Solution>& fields) {
  using S = const Solution&;
  const auto program = [](S s) { return s.program(); };
  fields.push_back(value<Solution>("estimated_error", "", "relative, of T",
                                   &Solution::estimated_error));
  splice(fields, program,
         {value<ProgramSize>("nodes", "", "of the mesh, N p + 1",
                             &ProgramSize::nodes),
          value<ProgramSize>("variables", "", "of the nonlinear program",
                             &ProgramSize::variables),
          value<ProgramSize>("constraints", "", "its rows",
                             &ProgramSize::constraints)});
  fields.push_back(object<Solution>(
      "mesh", "", "on which the answer was computed",
      [](S s) { return s.program() ? &s : nullptr; },
      {value<Solution>(
           "degree", "", "p; null for straight pieces",
           [](S s) {
             return trajectory_of(s)
                        ? std::optional(trajectory_of(s)->curve().mesh().degree)
                        : std::nullopt;
           }),
       value<Solution>("elements", "", "N, or pieces", [](S s) {
         return trajectory_of(s)
                    ? trajectory_of(s)->curve().mesh().num_elements()
                    : s.program()->nodes - 1;
       })}));
}

Fields<Effort> effort_fields() {
  using Step = ContinuationStep;
  using Record = MeshRecord;
  return {
      value<Effort>("iterations", "", "of Ipopt, in all passes on all meshes",
                    &Effort::iterations),
      value<Effort>(
          "first_iterations", "", "of the first pass on the final mesh",
          [](const Effort& e) { return e.final_mesh().first_iterations; }),
      value<Effort>("closure_passes", "",
                    "solves between fixed end points on the final mesh",
                    [](const Effort& e) { return e.final_mesh().passes; }),
      value<Effort>("passes", "", "the same on all meshes", &Effort::passes),
      value<Effort>("newton_steps", "", "of continuation, polishing and checks",
                    &Effort::newton_steps),
      list("continuation", "from the uniform cylinder to the body",
           &Effort::continuation,
           {value<Step>("eta_m", "", "η_m of the step", &Step::eta_m),
            value<Step>("phi", "rad", "slope angle at B", &Step::phi),
            value<Step>("newton_steps", "", "to get there",
                        &Step::newton_steps)}),
      list("refinement", "meshes in the order in which they were tried",
           &Effort::meshes,
           {value<Record>("degree", "", "p", &Record::degree),
            value<Record>("elements", "", "N", &Record::elements),
            value<Record>("estimated_error", "", "relative, of T",
                          &Record::estimated_error),
            value<Record>("passes", "", "solves between fixed end points",
                          &Record::passes),
            value<Record>("iterations", "", "of Ipopt", &Record::iterations),
            value<Record>("newton_steps", "", "of polishing and the check",
                          &Record::newton_steps)})};
}

/// Of Search::Global; τ is null unless verified.
Field<Solution> branches_field() {
  using B = Branch;
  return list(
      "branches", "smooth contacts that search: global found, fastest first",
      &Solution::branches,
      {value<B>("tau", "", "τ",
                [](const B& b) {
                  return b.verified ? std::optional(b.tau) : std::nullopt;
                }),
       value<B>("estimated_error", "", "relative", &B::estimated_error),
       value<B>("end_angle", "rad", "β_end", &B::end_angle),
       value<B>("centre_path_length", "m", "S", &B::centre_path_length),
       value<B>("principal", "", "continues from the cycloid", &B::principal),
       value<B>("verified", "", "passed every check", &B::verified),
       value<B>("minimum", "", "a minimum between its fixed ends", &B::minimum),
       value<B>("feasible", "", "without lift-off and folds", &B::feasible),
       value<B>("remarks", "", "checks that failed, why infeasible",
                &B::remarks)});
}

template <class Value>
std::optional<Value> only_if(bool there, const Value& value) {
  return there ? std::optional(value) : std::nullopt;
}

/// Not under the answer's keys: these are numbers of another problem.
Field<Solution> discrete_field() {
  using A = DiscreteAnswer;
  Fields<Solution> fields;
  const auto if_solved = [](double A::*member) {
    return [=](const A& a) { return only_if(a.solved(), a.*member); };
  };
  splice(
      fields, [](const Solution& s) { return s.discrete(); },
      {value<A>("solved", "", "its equations hold", &A::solved),
       value<A>("nodes", "", "n", &A::nodes),
       value<A>("unknowns", "", "of the system", &A::unknowns),
       value<A>("residual", "", "Euclidean norm, lengths in H", &A::residual),
       value<A>("iterations", "", "of the solver", &A::iterations),
       value<A>("evaluations", "", "of the residual", &A::evaluations),
       value<A>("jacobians", "", "computed", &A::jacobians),
       value<A>("refused_points", "", "without a real residual",
                &A::refused_points),
       value<A>("cpu_seconds", "s", "processor time", &A::cpu_seconds),
       value<A>("memory_bytes", "bytes", "of matrices and factors",
                &A::memory_bytes),
       value<A>("tau", "", "its τ", if_solved(&A::tau)),
       value<A>("transit_time", "s", "its T", if_solved(&A::transit_time)),
       value<A>("centre_path_length", "m", "its S",
                if_solved(&A::centre_path_length)),
       value<A>("start_angle", "rad", "slope of the first chord",
                if_solved(&A::start_angle)),
       value<A>("end_angle", "rad", "slope of the last chord",
                if_solved(&A::end_angle))});
  fields.push_back(value<Solution>(
      "error", "", "of its τ, relative to the extremal", [](const Solution& s) {
        const bool compared =
            s.discrete()->solved() && s.extremal && s.extremal->solved;
        return compared
                   ? std::optional(s.discrete()->tau / s.extremal->tau - 1.0)
                   : std::nullopt;
      }));
  return object<Solution>(
      "discrete_system", "",
      "what the paper's discrete system came to with method: fsolve",
      [](const Solution& s) { return s.discrete() ? &s : nullptr; },
      std::move(fields));
}

void add_search(Fields<Solution>& fields) {
  using S = const Solution&;
  using E = CrossCheck;
  const auto if_solved = [](double E::*member) {
    return [=](const E& e) { return only_if(e.solved, e.*member); };
  };
  const Fields<Solution> more{
      value<Solution>("folds", "",
                      "η_m at which the branch from the cycloid turned",
                      &Solution::folds),
      object<Solution>(
          "cold_start", "", "where guess: straight or random led",
          [](S s) { return s.cold_start ? &*s.cold_start : nullptr; },
          {value<ColdStart>("status", "", "how it ended",
                            [](const ColdStart& c) { return name(c.status); }),
           value<ColdStart>("tau_coarse", "", "τ on the coarse mesh",
                            &ColdStart::tau),
           value<ColdStart>("principal", "", "it led to the principal branch",
                            &ColdStart::principal)}),
      branches_field(),
      value<Solution>("search_remark", "", "what the search left undone",
                      [](S s) {
                        return only_if(!s.search_remark.empty(),
                                       s.search_remark);
                      }),
      object<Solution>("extremal", "", "cross-check by multiple shooting",
                       [](S s) { return s.extremal ? &*s.extremal : nullptr; },
                       {value<E>("solved", "", "it has an answer", &E::solved),
                        value_if<E>("message", "", "why not",
                                    [](const E& e) {
                                      return only_if(!e.solved, e.message);
                                    }),
                        value_if<E>("tau", "", "its τ", if_solved(&E::tau)),
                        value_if<E>("error_estimate", "", "relative, of its τ",
                                    if_solved(&E::error_estimate)),
                        value_if<E>("difference", "", "relative, of both τ",
                                    if_solved(&E::difference))}),
      discrete_field()};
  fields.insert(fields.end(), more.begin(), more.end());
}

Field<Solution> seconds_field() {
  Fields<PhaseSeconds> phases;
  for (std::size_t i = 0; i < kNumPhases; ++i) {
    phases.push_back(value<PhaseSeconds>(
        name(static_cast<Phase>(i)), "s", "in this part",
        [=](const PhaseSeconds& p) { return p.seconds[i]; }));
  }
  return object<Solution>(
      "seconds", "s", "wall clock, where nothing else is said",
      [](const Solution& s) { return &s.effort; },
      {value<Effort>("total", "s", "all", &Effort::seconds),
       value<Effort>(
           "solve", "s", "without the certificate",
           [](const Effort& e) { return e.seconds - e.certificate_seconds; }),
       value<Effort>("certificate", "s", "of the certificate",
                     &Effort::certificate_seconds),
       value<Effort>("cpu", "s",
                     "processor time without certificate and cross-checks",
                     &Effort::cpu_seconds),
       object<Effort>(
           "phases", "s", "processor time by part",
           [](const Effort& e) { return &e.phases; }, std::move(phases))});
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
    splice(fixed, certificate_of,
           {value<Certificate>(check, "", meaning, [=](const Certificate& c) {
             const Check* found = c.find(check);
             return found ? std::optional(found->value) : std::nullopt;
           })});
  }
  fixed.push_back(value<Solution>(
      "tau", "", "τ by multiple shooting, if it was cross-checked",
      [](const Solution& s) {
        return comparable(s) ? std::optional(s.motion()->tau()) : std::nullopt;
      }));
  splice(fixed, comparable,
         {value<CrossCheck>("extremal_tau", "", "its τ", &CrossCheck::tau),
          value<CrossCheck>("extremal_difference", "", "relative, of both τ",
                            &CrossCheck::difference)});
  const Field<Certificate> checks = list(
      "checks", "all checks", &Certificate::checks,
      {value<Check>("name", "", "also a key of the certificate", &Check::name),
       value<Check>("value", "", "what was found", &Check::value),
       value<Check>("threshold", "", "passed if the value is not greater",
                    &Check::threshold),
       value<Check>("passed", "", "whether it is", &Check::passed),
       value_if<Check>("where", "", "on the path", [](const Check& c) {
         return only_if(!c.where.empty(), c.where);
       })});
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

Fields<Provenance> version_fields() {
  using P = Provenance;
  return {value<P>("brachisto", "", "version of this program", &P::brachisto),
          value<P>("ipopt", "", "version", &P::ipopt),
          value<P>("mumps", "", "version", &P::mumps),
          value<P>("blas", "", "file or configuration", &P::blas),
          value<P>("suitesparse", "", "version", &P::suitesparse),
          value<P>("compiler", "", "and its version", &P::compiler)};
}

void add_origin(Fields<Solution>& fields) {
  const auto input = [](const Solution& s) {
    return io::effective_input(s.scene, s.options);
  };
  Fields<Solution> made_with;
  splice(
      made_with,
      [](const Solution&) {
        static const Provenance made = provenance();
        return &made;
      },
      version_fields());
  made_with.push_back({{"options", "object", "", "as in input", {}, true},
                       [=](const Solution& s) {
                         Json options = input(s);
                         options.erase("scene");
                         return options;
                       }});
  made_with.push_back(
      value<Solution>("linear_solver", "", "that Ipopt used on the final mesh",
                      [](const Solution& s) {
                        const auto used = s.effort.final_mesh().linear_solver;
                        return used ? std::optional(name(*used)) : std::nullopt;
                      }));
  fields.push_back(object<Solution>("provenance", "", "what made the result",
                                    itself<Solution>, std::move(made_with)));
  fields.push_back({{"scene", "object", "", "as in input", {}, true},
                    [=](const Solution& s) { return input(s)["scene"]; }});
  fields.push_back({{"input",
                     "object",
                     "",
                     "the effective input, defaults filled in: a problem file",
                     {},
                     true},
                    input});
}

const Fields<Solution>& result_fields() {
  static const Fields<Solution> table = [] {
    Fields<Solution> fields = verdict_fields();
    splice(fields, answer_of, motion_fields());
    add_diagnostics(fields);
    add_size(fields);
    splice(
        fields, [](const Solution& s) { return &s.effort; }, effort_fields());
    add_search(fields);
    fields.push_back(seconds_field());
    fields.push_back(certificate_field());
    add_origin(fields);
    return fields;
  }();
  return table;
}

void add_rows(std::string& text, const std::vector<FieldText>& fields,
              const std::string& path) {
  for (const FieldText& field : fields) {
    const bool items = field.type == "array" && !field.parts.empty();
    const std::string name =
        fmt::format("{}{}{}", path, field.name, items ? "[]" : "");
    text += fmt::format("| `{}` | {} | {} | {} |\n", name, field.type,
                        field.unit, field.meaning);
    add_rows(text, field.parts, name + ".");
  }
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

}  // namespace

std::string result_json(const Solution& solution) {
  return written(result_fields(), solution).dump(2) + "\n";
}

std::string input_json(const Scene& scene, const SolveOptions& options) {
  Json json = {{"schema_version", kSchemaVersion}, {"valid", true}};
  json.update(io::effective_input(scene, options));
  return json.dump(2) + "\n";
}

std::string provenance_json() {
  return written(version_fields(), provenance()).dump();
}

std::string result_reference_markdown() {
  std::string text =
      "| key | type | unit | meaning |\n"
      "| --- | --- | --- | --- |\n";
  add_rows(text, texts_of(result_fields()), "");
  return text;
}

std::string result_schema() {
  Json schema = {{"$schema", "http://json-schema.org/draft-07/schema#"},
                 {"title", "Result of brachisto solve"}};
  schema.update(schema_of(texts_of(result_fields()), false));
  return schema.dump(2) + "\n";
}

}  // namespace brachisto::report
