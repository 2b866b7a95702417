// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Keys of a result document that tell how the answer was sought: the work,
/// the time, and what else was found.

#include <fmt/format.h>

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "design/design_record.hpp"
#include "report/result_field.hpp"
#include "report/text_table.hpp"

namespace brachisto::report {

namespace {

/// Of Search::Global; τ is null unless verified.
Field<Solution> branches_field() {
  using B = Branch;
  return list(
      "branches",
      "extremals, or paths under limits, that search: global found, "
      "fastest first",
      &Solution::branches,
      {{"tau", "", "τ",
        [](const B& b) {
          return b.verified ? std::optional(b.tau) : std::nullopt;
        }},
       {"estimated_error", "", "relative", &B::estimated_error},
       {"end_angle", "rad", "β_end", &B::end_angle},
       {"centre_path_length", "m", "S", &B::centre_path_length},
       {"principal", "",
        "continues from the cycloid; under limits the answer without this "
        "search",
        &B::principal},
       {"verified", "", "passed every check", &B::verified},
       {"minimum", "", "a minimum between its fixed ends", &B::minimum},
       {"feasible", "", "without lift-off and folds", &B::feasible},
       {"remarks", "", "checks that failed, why infeasible", &B::remarks}});
}

/// Left out unless it was asked for.
Field<Solution> proof_field() {
  using P = Proof;
  using Of = P::Statement;
  const auto if_proven = [](auto P::*member) {
    return [=](const P& p) {
      return only_if(p.not_proven_because.empty(), p.*member);
    };
  };
  Field<Solution> field = object<Solution>(
      "proof", "", "enclosures, if certify: proof was asked for",
      &Solution::proof,
      {{"proven", "", "the extremal exists, once in the box of its certificate",
        [](const P& p) { return p.not_proven_because.empty(); }},
       {"message", "", "why not",
        [](const P& p) {
          return only_if(!p.not_proven_because.empty(), p.not_proven_because);
        },
        true},
       {"tau_lower", "", "τ is no less", if_proven(&P::tau_lower), true},
       {"tau_upper", "", "and no more", if_proven(&P::tau_upper), true},
       {"off_at_most", "", "the result's τ is no further from the extremal's",
        if_proven(&P::off_at_most), true},
       {"within_estimate", "", "nor further than its estimated error",
        if_proven(&P::within_estimate), true},
       list(
           "theorems", "each by itself", &P::statements,
           {{"name", "", "as in proof.json", &Of::name},
            {"holds", "", "it is proven", &Of::holds},
            {"why_not", "", "why not",
             [](const Of& s) { return only_if(!s.why_not.empty(), s.why_not); },
             true}}),
       {"bits", "", "of its precision", if_proven(&P::bits), true},
       {"cpu_seconds", "s", "processor time", &P::cpu_seconds}});
  field.may_lack = true;
  return field;
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

}  // namespace

Fields<Solution> effort_fields() {
  using Step = ContinuationStep;
  using Record = MeshRecord;
  const Fields<Effort> fields{
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
  return of_part<Solution>(&Solution::effort, fields);
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
      proof_field(),
      discrete_field()};
}

std::string in_words(const Proof& proof) {
  if (!proof.not_proven_because.empty()) {
    return "none: " + proof.not_proven_because;
  }
  std::string out = fmt::format(
      "one extremal with τ in [{}, {}]; the τ above is off by at most {}, "
      "{} its estimated error",
      proof.tau_lower, proof.tau_upper, at_most(proof.off_at_most),
      proof.within_estimate ? "within" : "more than");
  for (const Proof::Statement& each : proof.statements) {
    if (each.why_not.empty()) continue;
    out += fmt::format("; not proven: {} ({})", each.name, each.why_not);
  }
  return out;
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

namespace {

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

}  // namespace

Field<DesignAnswer> design_field() {
  using A = DesignAnswer;
  using M = DesignMinimum;
  Field<A> field = object<A>(
      "design", "", "the choice of the body; no key without a design",
      [](const A& design) { return &design; },
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
  field.may_lack = true;
  return field;
}

}  // namespace brachisto::report
