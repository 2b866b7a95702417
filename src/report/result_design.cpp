// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Keys of a result document that are of the design of a body.

#include "report/result_field.hpp"

#include <string_view>

namespace brachisto::report {

namespace {

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

}  // namespace

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

}  // namespace brachisto::report
