// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// fsolve_keys(): how the paper's discrete system is read and solved.

#include "io/key_sections.hpp"

namespace brachisto::io {

namespace {

using Quadrature = DiscreteReading::Quadrature;
using Datum = DiscreteReading::Datum;
using Slopes = DiscreteReading::Slopes;

DiscreteReading& reading(ProblemFile& problem) {
  return problem.options.fsolve.reading;
}

}  // namespace

std::vector<KeySpec> fsolve_keys() {
  return {
      {.path = "solver.fsolve",
       .type = KeyType::Map,
       .description = "of method: fsolve, what the paper leaves open"},
      {.path = "solver.fsolve.quadrature",
       .type = KeyType::Choice,
       .fallback = "vmean",
       .description = "time of a chord of length l: vmean, 2 l/(v + v') with "
                      "the speeds at its ends; midpoint, l/v halfway; "
                      "trapezoid, l (1/v + 1/v')/2",
       .choices = {{"vmean",
                    [](ProblemFile& p) {
                      reading(p).quadrature = Quadrature::MeanSpeed;
                    }},
                   {"midpoint",
                    [](ProblemFile& p) {
                      reading(p).quadrature = Quadrature::Midpoint;
                    }},
                   {"trapezoid",
                    [](ProblemFile& p) {
                      reading(p).quadrature = Quadrature::Trapezoid;
                    }}}},
      {.path = "solver.fsolve.datum",
       .type = KeyType::Choice,
       .fallback = "release",
       .description = "zero level of the energy: release, the first node; "
                      "rest, A as printed but at rest in the first node; "
                      "printed, A, which leaves no real speed there",
       .choices =
           {{"release",
             [](ProblemFile& p) { reading(p).datum = Datum::Release; }},
            {"rest", [](ProblemFile& p) { reading(p).datum = Datum::Rest; }},
            {"printed",
             [](ProblemFile& p) { reading(p).datum = Datum::Printed; }}}},
      {.path = "solver.fsolve.slopes",
       .type = KeyType::Choice,
       .fallback = "literal",
       .description = "end slopes: literal, by Δz/Δx, which turns round with "
                      "Δx; smooth, by Δx/l and Δz/l",
       .choices =
           {{"literal",
             [](ProblemFile& p) { reading(p).slopes = Slopes::Literal; }},
            {"smooth",
             [](ProblemFile& p) { reading(p).slopes = Slopes::Smooth; }}}},
      {.path = "solver.fsolve.epsilon",
       .type = KeyType::Number,
       .fallback = "1e-3",
       .bounds = "from 0 to 0.1",
       .description = "half width of the central differences in units of H, "
                      "of variant hybrid; 0: exact derivatives",
       .interval = {0.0, kLargestEpsilon},
       .set = [](ProblemFile& p, double v) { reading(p).epsilon = v; }},
      {.path = "solver.fsolve.variant",
       .type = KeyType::Choice,
       .fallback = "hybrid",
       .description = "hybrid: Powell's method with a dense Jacobian by "
                      "differences, as fsolve; newton: exact derivatives, "
                      "dense; lifted: the same steps from a sparse system",
       .choices = {{"hybrid",
                    [](ProblemFile& p) {
                      p.options.fsolve.variant = FsolveVariant::Hybrid;
                    }},
                   {"newton",
                    [](ProblemFile& p) {
                      p.options.fsolve.variant = FsolveVariant::Newton;
                    }},
                   {"lifted",
                    [](ProblemFile& p) {
                      p.options.fsolve.variant = FsolveVariant::Lifted;
                    }}}},
  };
}

}  // namespace brachisto::io
