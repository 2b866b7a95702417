// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// result_fields(): every key of a result document, once. The document, its
/// reference in docs/results.md and its schema are made from it.

#include "brachisto/report/result.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "brachisto/io/problem_file.hpp"
#include "brachisto/study/forecast.hpp"
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
const Solution* itself(const Solution& solution) {
  return &solution;
}

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

Fields<Motion> motion_fields() {
  return {
      {"tau", "", "τ = T √(2g/H), transit time without units", &Motion::tau},
      {"transit_time", "s", "T", &Motion::transit_time},
      {"centre_path_length", "m", "S, length of the path of the centre",
       &Motion::centre_path_length},
      {"rail_length", "m", "S + r (β₀ − β_end), signed length of the track",
       &Motion::rail_length},
      {"start_angle", "rad", "β₀, slope angle at A", &Motion::start_angle},
      {"end_angle", "rad", "β_end, slope angle at B", &Motion::end_angle},
      {"rotation", "rad", "θ_end − θ_m; null for a bead", &Motion::rotation}};
}

/// A range over u > 0. What is not finite is null in JSON: no bound.
Fields<PathDiagnostics> range_fields(std::string_view unit,
                                     Extreme PathDiagnostics::*min,
                                     Extreme PathDiagnostics::*max,
                                     Extreme PathDiagnostics::*after_rise) {
  using D = const PathDiagnostics&;
  return {{"min", unit, "smallest value, the start left out",
           [=](D d) { return (d.*min).value; }},
          {"max", unit, "greatest value, the start left out",
           [=](D d) { return (d.*max).value; }},
          {"min_at_start", "", "the smallest is the limit at the start",
           [=](D d) { return (d.*min).at_start; }},
          {"max_at_start", "", "the greatest is the limit at the start",
           [=](D d) { return (d.*max).at_start; }},
          {"min_after_rise", unit, "smallest value after the first rise",
           [=](D d) { return (d.*after_rise).value; }}};
}

Fields<Solution> diagnostics_fields() {
  using D = PathDiagnostics;
  Fields<D> force =
      range_fields("m g", &D::min_normal_force, &D::max_normal_force,
                   &D::normal_force_after_rise);
  force.push_back({"x_at_max", "m", "x of the track at the greatest",
                   [](const D& d) { return d.max_normal_force.x; }});
  return {
      object<Solution>("normal_force", "m g",
                       "R_n, which presses body and track", diagnostics_of,
                       std::move(force)),
      object<Solution>(
          "friction", "",
          "shares of the transit time in which the body needs a friction "
          "coefficient above",
          rolling_diagnostics_of,
          {{"share_above_0.3", "", "0.3", &D::friction_above_0_3},
           {"share_above_0.5", "", "0.5", &D::friction_above_0_5},
           {"share_above_1", "", "1", &D::friction_above_1}}),
      object<Solution>(
          "grip", "",
          "friction coefficient that rolling needs; null for a bead",
          rolling_diagnostics_of,
          {list("least_after", "from shares of the transit time on: 0, 1, 5 %",
                &D::least_grip,
                {{"share_of_time", "", "of T", &LeastGrip::share_of_time},
                 {"mu", "",
                  "greatest R_t/R_n from there on, in absolute value; null: no "
                  "friction would "
                  "do, as where R_n → 0 and R_t does not, at a start from rest",
                  &LeastGrip::mu}})}),
      object<Solution>("curvature", "1/m",
                       "κ_b of the track; null: no bound, it folds",
                       diagnostics_of,
                       range_fields("1/m", &D::min_curvature, &D::max_curvature,
                                    &D::curvature_after_rise)),
      object<Solution>("at_start", "", "limits at the start", diagnostics_of,
                       {{"normal_force", "m g", "of R_n",
                         [](const D& d) { return d.at_start.normal_force; }},
                        {"curvature", "1/m", "of κ_b; null: −∞",
                         [](const D& d) { return d.at_start.curvature; }}}),
      of_part<Solution>(
          rolling_diagnostics_of,
          {"fold_margin", "", "smallest 1 − r κ_c; the track folds at 0",
           [](const D& d) { return d.min_fold_margin.value; }}),
      {"estimated_error", "", "relative, of T", &Solution::estimated_error}};
}

/// Of the answer, as are its numbers; no key of a scene without limits.
Field<Solution> limits_field() {
  const auto interval = [](std::string_view name, std::string_view unit,
                           std::string_view meaning,
                           Interval ActiveArc::*member) {
    return object<ActiveArc>(name, unit, meaning, member,
                             {{"from", unit, "begins", &Interval::from},
                              {"to", unit, "ends", &Interval::to}});
  };
  using L = LimitOnPath;
  const Field<Solution> all = list(
      "limits", "bounds of scene.limits on the path; no key without any",
      &Solution::limits,
      {{"name", "", "key below scene.limits", &L::name},
       {"bound", "", "as the scene states it; null: has none", &L::bound},
       list("active", "arcs on which it holds as an equation", &L::active,
            {interval("u", "s", "rolling time", &ActiveArc::u),
             interval("t", "s", "time", &ActiveArc::t),
             interval("x", "m", "x of the track", &ActiveArc::x)}),
       {"least_slack", "", "distance from the bound, in its unit",
        &L::least_slack},
       {"share_of_time", "", "of T, on these arcs", &L::share_of_time},
       {"price", "", "dτ/d(bound): the slope of τ over the bound", &L::price},
       {"price_at_fixed_contacts", "",
        "the same with the contacts held: its multiplier",
        &L::price_at_fixed_contacts}});
  return {all.text,
          [all](const Solution& s) {
            if (!s.scene.limits.any()) return Json();
            return s.verified() ? all.write(s) : Json::array();
          },
          true};
}

/// No key unless they were asked for; empty if there are none.
Field<Solution> sensitivities_field() {
  struct Row {
    SceneParameter parameter;
    std::string_view per, seconds_per, meaning;
  };
  static constexpr std::array<Row, kNumSceneParameters> kRows{
      {{SceneParameter::EtaM, "", "s", "by η_m; null: the body has none"},
       {SceneParameter::ThetaM, "1/rad", "s/rad", "by θ_m"},
       {SceneParameter::K, "", "s", "by k"},
       {SceneParameter::Radius, "1/m", "s/m", "by r"},
       {SceneParameter::L, "1/m", "s/m", "by L"},
       {SceneParameter::H, "1/m", "s/m", "by H"}}};
  using D = TimeDerivatives;
  using S = Sensitivities;
  const auto derivatives = [](std::string_view name, std::string_view per,
                              std::string_view seconds_per,
                              std::string_view meaning, auto of) {
    return object<S>(
        name, "", meaning,
        [=](const S& all) -> const D* {
          const D& found = of(all);
          return std::isnan(found.tau) ? nullptr : &found;
        },
        {{"tau", per, "dτ: the slope of τ, the contacts moving along", &D::tau},
         {"transit_time", seconds_per, "dT", &D::transit_time},
         {"tau_at_fixed_contacts", per, "dτ with the slopes at A and B held",
          &D::tau_at_fixed_contacts},
         {"transit_time_at_fixed_contacts", seconds_per, "dT likewise",
          &D::transit_time_at_fixed_contacts}});
  };
  Fields<S> fields;
  for (const Row& row : kRows) {
    fields.push_back(derivatives(
        name(row.parameter), row.per, row.seconds_per, row.meaning,
        [p = row.parameter](const S& s) -> const D& { return s.by[p]; }));
  }
  fields.push_back(derivatives(
      "eta_m_cos_theta_m", "", "s", "by the offset at the start in x",
      [](const S& s) -> const D& { return s.by_offset[0]; }));
  fields.push_back(derivatives(
      "eta_m_sin_theta_m", "", "s", "and in z, both regular at η_m = 0",
      [](const S& s) -> const D& { return s.by_offset[1]; }));
  fields.push_back({"second", "",
                    "∂²τ, rows and columns in the order above from η_m to H; "
                    "null: not asked for, or not found",
                    [](const S& s) {
                      using Rows = std::vector<std::vector<double>>;
                      if (!s.second) return std::optional<Rows>();
                      Rows rows;
                      for (const auto& row : *s.second) {
                        rows.emplace_back(row.begin(), row.end());
                      }
                      return std::optional(std::move(rows));
                    },
                    true});
  const Field<Solution> all = object<Solution>(
      "sensitivities", "",
      "how the time changes with the scene; no key unless it was asked for, "
      "empty where the conditions of the answer are singular",
      &Solution::sensitivities, std::move(fields));
  return {all.text,
          [all](const Solution& s) {
            if (s.options.or_default<Collocation>().sensitivities ==
                SensitivityOrder::None) {
              return Json();
            }
            return s.sensitivities ? all.write(s) : Json::object();
          },
          true};
}

/// On which the answer was computed.
Field<Solution> mesh_field() {
  return object<Solution>(
      "mesh", "", "on which the answer was computed", &Solution::program,
      {{"degree", "", "p; null for straight pieces", &ProgramSize::degree},
       {"elements", "", "N, or pieces", &ProgramSize::elements}});
}

Fields<Effort> effort_fields() {
  using Step = ContinuationStep;
  using Record = MeshRecord;
  return {
      {"iterations", "", "of Ipopt, in all passes on all meshes",
       &Effort::iterations},
      {"first_iterations", "", "of the first pass on the final mesh",
       [](const Effort& e) { return e.final_mesh().first_iterations; }},
      {"closure_passes", "",
       "solves between fixed end points on the final mesh",
       [](const Effort& e) { return e.final_mesh().passes; }},
      {"passes", "", "the same on all meshes", &Effort::passes},
      {"newton_steps", "", "of continuation, polishing and checks",
       &Effort::newton_steps},
      list("continuation", "from the uniform cylinder to the body",
           &Effort::continuation,
           {{"eta_m", "", "η_m of the step", &Step::eta_m},
            {"phi", "rad", "slope angle at B", &Step::phi},
            {"newton_steps", "", "to get there", &Step::newton_steps}}),
      list("refinement", "meshes in the order in which they were tried",
           &Effort::meshes,
           {{"degree", "", "p", &Record::degree},
            {"elements", "", "N", &Record::elements},
            {"estimated_error", "", "relative, of T", &Record::estimated_error},
            {"passes", "", "solves between fixed end points", &Record::passes},
            {"iterations", "", "of Ipopt", &Record::iterations},
            {"newton_steps", "", "of polishing and the check",
             &Record::newton_steps}})};
}

/// Of Search::Global; τ is null unless verified.
Field<Solution> branches_field() {
  using B = Branch;
  return list(
      "branches", "smooth contacts that search: global found, fastest first",
      &Solution::branches,
      {{"tau", "", "τ",
        [](const B& b) {
          return b.verified ? std::optional(b.tau) : std::nullopt;
        }},
       {"estimated_error", "", "relative", &B::estimated_error},
       {"end_angle", "rad", "β_end", &B::end_angle},
       {"centre_path_length", "m", "S", &B::centre_path_length},
       {"principal", "", "continues from the cycloid", &B::principal},
       {"verified", "", "passed every check", &B::verified},
       {"minimum", "", "a minimum between its fixed ends", &B::minimum},
       {"feasible", "", "without lift-off and folds", &B::feasible},
       {"remarks", "", "checks that failed, why infeasible", &B::remarks}});
}

Json numbers_json(const NamedNumbers& numbers) {
  Json json = Json::object();
  for (const auto& [name, value] : numbers) json[name] = value;
  return json;
}

/// Numbers by the names of what is free.
Field<DesignMinimum> numbers_field(std::string_view name,
                                   std::string_view meaning,
                                   NamedNumbers DesignMinimum::*numbers) {
  return {{name, "object", "", meaning, {}, true},
          [=](const DesignMinimum& m) { return numbers_json(m.*numbers); }};
}

/// What is told of the best body at the top, and of each minimum.
Fields<DesignMinimum> choice_fields() {
  using B = BoundOfDesign;
  return {
      numbers_field("values", "of what is free, in SI units and rad",
                    &DesignMinimum::values),
      list("bounds_active", "bounds that hold", &DesignMinimum::bounds_active,
           {{"name", "", "of what, or of which margin", &B::name},
            {"bound", "", "its value", &B::bound},
            {"multiplier", "", "dτ/d(bound), the contacts moving along",
             &B::multiplier}}),
      numbers_field("gradient", "dτ/d(value), the contacts moving along",
                    &DesignMinimum::gradient),
      {"curvatures", "",
       "eigenvalues of the second derivative of τ along the bounds that hold; "
       "all positive at a strict minimum",
       &DesignMinimum::curvatures}};
}

/// Of `brachisto design`; no key of another result.
Field<Solution> design_field() {
  using A = DesignAnswer;
  using M = DesignMinimum;
  const Field<Solution> all = object<Solution>(
      "design", "", "the choice of the body; no key without a design",
      &Solution::design,
      joined<A>(
          {of_part<A>(&A::best, choice_fields()),
           {list("minima",
                 "bodies that none near them is quicker than, and others that "
                 "are not stationary, quickest first; the first that is "
                 "verified and, if that is required, feasible is the best",
                 &A::minima,
                 joined<M>({{{"tau", "", "τ", &M::tau},
                             {"stationary", "",
                              "first-order conditions hold; if not, the "
                              "quickest body that a search has passed before "
                              "it was lost at the edge of a fold",
                              &M::stationary},
                             {"feasible", "",
                              "the body can run on its track, with the grip "
                              "that is asked for",
                              &M::feasible},
                             {"verified", "",
                              "solved anew from the cycloid, its track passed "
                              "every check and has this τ",
                              &M::verified},
                             {"remarks", "", "why not feasible or verified",
                              &M::remarks}},
                            choice_fields(),
                            {{"found_from", "", "so many searches led here",
                              &M::found_from}}})),
            {"searches", "", "that ended", &A::searches},
            {"stopped", "",
             "the limit of time was reached before all had ended, or before "
             "the map was done: the best body is the best so far",
             &A::stopped},
            {"starts", "",
             "bodies that they began at, also in place of lost "
             "ones",
             &A::starts},
            list("lost", "starts that led nowhere", &A::lost,
                 {{"search", "", "its number", &LostSearch::search},
                  {"reason", "", "in words", &LostSearch::reason}}),
            {"solves", "", "closed solutions in all searches", &A::solves},
            {"cpu_seconds", "s", "processor time of them", &A::cpu_seconds}}}));
  return {all.text, all.write, true};
}

template <class Value>
std::optional<Value> only_if(bool there, const Value& value) {
  return there ? std::optional(value) : std::nullopt;
}

/// Not under the answer's keys: these are numbers of another problem.
Field<Solution> discrete_field() {
  using A = DiscreteAnswer;
  const auto if_solved = [](double A::*member) {
    return [=](const A& a) { return only_if(a.solved(), a.*member); };
  };
  Fields<Solution> fields = of_part<Solution>(
      &Solution::discrete,
      Fields<A>{
          {"solved", "", "its equations hold", &A::solved},
          {"nodes", "", "n", &A::nodes},
          {"unknowns", "", "of the system", &A::unknowns},
          {"residual", "", "Euclidean norm, lengths in H", &A::residual},
          {"iterations", "", "of the solver", &A::iterations},
          {"evaluations", "", "of the residual", &A::evaluations},
          {"jacobians", "", "computed", &A::jacobians},
          {"refused_points", "", "without a real residual", &A::refused_points},
          {"cpu_seconds", "s", "processor time", &A::cpu_seconds},
          {"memory_bytes", "bytes", "of matrices and factors",
           &A::memory_bytes},
          {"tau", "", "its τ", if_solved(&A::tau)},
          {"transit_time", "s", "its T", if_solved(&A::transit_time)},
          {"centre_path_length", "m", "its S",
           if_solved(&A::centre_path_length)},
          {"start_angle", "rad", "slope of the first chord",
           if_solved(&A::start_angle)},
          {"end_angle", "rad", "slope of the last chord",
           if_solved(&A::end_angle)}});
  fields.push_back(
      {"error", "", "of its τ, relative to the extremal",
       [](const Solution& s) {
         const bool compared =
             s.discrete()->solved() && s.extremal && s.extremal->solved;
         return compared
                    ? std::optional(s.discrete()->tau / s.extremal->tau - 1.0)
                    : std::nullopt;
       }});
  return object<Solution>(
      "discrete_system", "",
      "what the paper's discrete system came to with method: fsolve",
      [](const Solution& s) { return s.discrete() ? &s : nullptr; },
      std::move(fields));
}

Fields<Solution> search_fields() {
  using S = const Solution&;
  using E = CrossCheck;
  const auto if_solved = [](double E::*member) {
    return [=](const E& e) { return only_if(e.solved, e.*member); };
  };
  return {
      {"folds", "", "η_m at which the branch from the cycloid turned",
       &Solution::folds},
      {"continued_from_L", "m",
       "L at which the way left the cycloid, to come back in L; null: it is "
       "the "
       "scene's own",
       &Solution::continued_from_L},
      object<Solution>(
          "cold_start", "", "where guess: straight or random led",
          &Solution::cold_start,
          {{"status", "", "how it ended",
            [](const ColdStart& c) { return name(c.status); }},
           {"tau_coarse", "", "τ on the coarse mesh", &ColdStart::tau},
           {"principal", "", "it led to the principal branch",
            &ColdStart::principal}}),
      branches_field(),
      {"search_remark", "", "what the search left undone",
       [](S s) { return only_if(!s.search_remark.empty(), s.search_remark); }},
      object<Solution>(
          "extremal", "", "cross-check by multiple shooting",
          &Solution::extremal,
          {{"solved", "", "it has an answer", &E::solved},
           {"message", "", "why not",
            [](const E& e) { return only_if(!e.solved, e.message); }, true},
           {"tau", "", "its τ", if_solved(&E::tau), true},
           {"error_estimate", "", "relative, of its τ",
            if_solved(&E::error_estimate), true},
           {"difference", "", "relative, of both τ", if_solved(&E::difference),
            true},
           {"of_slopes", "rad",
            "of a limited track, largest difference of the slopes at A and B",
            &E::of_slopes, true},
           {"of_junctions", "",
            "and of the places where arcs meet, as shares of U",
            &E::of_junctions, true}}),
      discrete_field()};
}

Field<Solution> seconds_field() {
  Fields<PhaseSeconds> phases;
  for (std::size_t i = 0; i < kNumPhases; ++i) {
    phases.push_back({name(static_cast<Phase>(i)), "s", "in this part",
                      [=](const PhaseSeconds& p) { return p.seconds[i]; }});
  }
  return object<Solution>(
      "seconds", "s", "wall clock, where nothing else is said",
      &Solution::effort,
      {{"total", "s", "all", &Effort::seconds},
       {"solve", "s", "without the certificate",
        [](const Effort& e) { return e.seconds - e.certificate_seconds; }},
       {"certificate", "s", "of the certificate", &Effort::certificate_seconds},
       {"cpu", "s", "processor time without certificate and cross-checks",
        &Effort::cpu_seconds},
       object<Effort>("phases", "s", "processor time by part", &Effort::phases,
                      std::move(phases))});
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

Fields<Solution> origin_fields() {
  const auto input = [](const Solution& s) {
    Json document = io::effective_input(s.scene, s.options);
    // Parts, which a design may move, are not echoed.
    if (s.design && s.design->plan.free_parts.empty()) {
      io::ProblemFile problem;
      problem.scene = s.scene;
      problem.design = s.design->plan;
      document["design"] = io::effective_section(problem, "design");
    }
    return document;
  };
  const auto made = [](const Solution&) {
    static const Provenance here = provenance();
    return &here;
  };
  const auto as_in_input = [](std::string_view name, std::string_view meaning,
                              std::function<Json(const Solution&)> write) {
    return Field<Solution>({name, "object", "", meaning, {}, true},
                           std::move(write));
  };
  return {object<Solution>(
              "provenance", "", "what made the result", itself,
              joined<Solution>(
                  {of_part<Solution>(made, version_fields()),
                   {as_in_input("options", "as in input",
                                [=](const Solution& s) {
                                  Json options = input(s);
                                  options.erase("scene");
                                  options.erase("design");
                                  return options;
                                }),
                    {"linear_solver", "", "that Ipopt used on the final mesh",
                     [](const Solution& s) {
                       const auto used = s.effort.final_mesh().linear_solver;
                       return used ? std::optional(name(*used)) : std::nullopt;
                     }}}})),
          as_in_input("scene", "as in input",
                      [=](const Solution& s) { return input(s)["scene"]; }),
          as_in_input("input",
                      "the effective input, defaults filled in: a problem file",
                      input)};
}

/// All but where the result comes from.
const Fields<Solution>& outcome_fields() {
  static const Fields<Solution> table = joined<Solution>(
      {verdict_fields(),
       of_part<Solution>(answer_of, motion_fields()),
       diagnostics_fields(),
       {limits_field(), sensitivities_field()},
       of_part<Solution>(
           &Solution::program,
           Fields<ProgramSize>{
               {"nodes", "", "of the mesh, N p + 1", &ProgramSize::nodes},
               {"variables", "", "of the nonlinear program",
                &ProgramSize::variables},
               {"constraints", "", "its rows", &ProgramSize::constraints}}),
       {mesh_field()},
       of_part<Solution>(&Solution::effort, effort_fields()),
       search_fields(),
       {design_field(), seconds_field(), certificate_field()}});
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

const Fields<Solution>& result_fields() {
  static const Fields<Solution> table =
      joined<Solution>({outcome_fields(), {forecast_field()}, origin_fields()});
  return table;
}

}  // namespace

std::string result_json(const Solution& solution) {
  return written(result_fields(), solution).dump(2) + "\n";
}

Json outcome_document(const Solution& solution) {
  return written(outcome_fields(), solution);
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
  return schema.dump(2) + "\n";
}

}  // namespace brachisto::report
