// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Keys of a result document that are of the answer: its motion, forces,
/// limits and derivatives, and its mesh.

#include "report/result_field.hpp"

#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "io/effective_input.hpp"
#include "report/arc_structure.hpp"

namespace brachisto::report {

namespace {

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
                  "greatest R_t/R_n from there on, in absolute value, of a "
                  "ball with R_n R/r_e for R_n; null: no "
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

/// No key but of a ball.
Field<Solution> rolls_as_field() {
  Field<Solution> field = object<Solution>(
      "rolls_as", "",
      "the cylinder that rolls like the ball; no key of other bodies",
      [](const Solution& s) {
        return s.scene.body.ball ? &s.scene.body : nullptr;
      },
      {{"r_e", "m", "distance of the axis from the contacts", &Body::radius},
       {"eta_e", "", "η_m R/r_e", &Body::eta_m},
       {"k_e", "", "k (R/r_e)²", &Body::k},
       {"walls", "",
        "R/r_e: what the walls press in sum, over R_n; friction, grip and "
        "rolling resistance are told of it",
        &Body::wall_ratio}});
  field.may_lack = true;
  return field;
}

/// Where an arc is.
Fields<ActiveArc> place_fields() {
  const auto interval = [](std::string_view name, std::string_view unit,
                           std::string_view meaning,
                           Interval ActiveArc::*member) {
    return object<ActiveArc>(name, unit, meaning, member,
                             {{"from", unit, "begins", &Interval::from},
                              {"to", unit, "ends", &Interval::to}});
  };
  return {interval("u", "s", "rolling time", &ActiveArc::u),
          interval("t", "s", "time", &ActiveArc::t),
          interval("x", "m", "x of the track", &ActiveArc::x)};
}

/// Of the answer, as are its numbers; no key of a scene without limits.
Field<Solution> of_limited(const Field<Solution>& all) {
  return {all.text,
          [all](const Solution& s) {
            if (!s.scene.limits.any()) return Json();
            return s.verified() ? all.write(s) : Json::array();
          },
          true};
}

Field<Solution> limits_field() {
  using L = LimitOnPath;
  return of_limited(list(
      "limits", "bounds of scene.limits on the path; no key without any",
      &Solution::limits,
      {{"name", "", "key below scene.limits", &L::name},
       {"bound", "", "as the scene states it; null: has none", &L::bound},
       list("active", "arcs on which it holds as an equation", &L::active,
            place_fields()),
       {"least_slack", "", "distance from the bound, in its unit",
        &L::least_slack},
       {"share_of_time", "", "of T, on these arcs", &L::share_of_time},
       {"price", "", "dτ/d(bound): the slope of τ over the bound", &L::price},
       {"price_at_fixed_contacts", "",
        "the same with the contacts held: its multiplier",
        &L::price_at_fixed_contacts}}));
}

Field<Solution> structure_field() {
  const Fields<PathArc> fields = joined<PathArc>(
      {{{"holds", "", "names of the limits that hold as equations; none: free",
         &PathArc::holds}},
       of_part<PathArc>(
           [](const PathArc& arc) {
             return &static_cast<const ActiveArc&>(arc);
           },
           place_fields())});
  return of_limited(
      {{"structure", "array", "",
        "the arcs of the path from A to B, free ones too; a place that is "
        "touched is an arc without length; no key without limits",
        texts_of(fields)},
       [fields](const Solution& s) {
         Json json = Json::array();
         for (const PathArc& arc : arc_structure(s)) {
           json.push_back(written(fields, arc));
         }
         return json;
       }});
}

/// No key unless there is one.
Field<Solution> relaxed_field() {
  Fields<Solution> fields = of_part<Solution>(
      answer_of,
      {{"tau", "", "τ = T √(2g/H), transit time without units", &Motion::tau},
       {"transit_time", "s", "T", &Motion::transit_time}});
  fields.push_back(
      {"estimated_error", "", "relative, of T", &Solution::estimated_error});
  fields.insert(fields.begin(),
                {{"limits", "object", "", "as in input", {}, true},
                 [](const Solution& s) {
                   return io::effective_input(s.scene,
                                              s.options)["scene"]["limits"];
                 }});
  Field<Solution> field = object<Solution>(
      "relaxed", "",
      "where the limits were not reached: the verified answer under limits "
      "that ask for less, tightened as far as a path was found",
      [](const Solution& s) { return s.relaxed.get(); }, fields);
  field.may_lack = true;
  return field;
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
      "empty where the conditions of the answer are singular, its arcs are not "
      "known, or turns of a uniform body are too many to resolve",
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

Fields<ProgramSize> size_fields() {
  return {
      {"nodes", "", "of the mesh, N p + 1", &ProgramSize::nodes},
      {"variables", "", "of the nonlinear program", &ProgramSize::variables},
      {"constraints", "", "its rows", &ProgramSize::constraints}};
}

}  // namespace

Fields<Solution> answer_fields() {
  return joined<Solution>({of_part<Solution>(answer_of, motion_fields()),
                           diagnostics_fields(),
                           {limits_field(), structure_field(), relaxed_field(),
                            sensitivities_field(), rolls_as_field()},
                           of_part<Solution>(&Solution::program, size_fields()),
                           {mesh_field()}});
}

}  // namespace brachisto::report
