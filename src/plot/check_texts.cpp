// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "plot/check_texts.hpp"

#include <algorithm>
#include <iterator>

namespace brachisto::plot {

namespace {

constexpr CheckText kTexts[] = {
    {"kkt_residual",
     "the optimality conditions, computed anew outside the solver"},
    {"defects", "the equations of motion at the collocation points, likewise"},
    {"contact_error", "how far the ends of the track are off A and B"},
    {"closure",
     "the slope at the end, against the one that the place of the end "
     "was built from"},
    {"shooting",
     "what the path misses at its end that was shot, with others side "
     "by side"},
    {"closure_at_A",
     "the same at the start, which an initial speed leaves open"},
    {"end_slope", "the slope at B, against the one that is given"},
    {"slope_angle", "the track has no loop: the largest slope angle"},
    {"speed", "the body moves forward everywhere"},
    {"hamiltonian", "𝓗 between the nodes, which is zero on an extremal"},
    {"slope",
     "∂𝓗/∂β between the nodes, which is zero where no slope beside it "
     "is better"},
    {"legendre", "the slope is a minimum of 𝓗, not a maximum"},
    {"weierstrass", "no direction at all is better than the track's"},
    {"start_angle", "the slope at the start, against the law for leaving rest"},
    {"start_corner",
     "where two limits hold at the start, how far the second one is off its "
     "bound"},
    {"start_corner_sign",
     "that the time grows where the slope there turns to the side "
     "left open"},
    {"energy_drift", "the energy is what the fall has given"},
    {"turning_costate",
     "in a field about a centre, the quantity that turning about it "
     "conserves"},
    {"surface",
     "how far a path that was shot with the law of one side of a planet's "
     "surface goes beyond it"},
    {"second_order",
     "a strict minimum of the discrete problem: eigenvalues of the "
     "wrong sign"},
    {"reintegrated_time",
     "the body let go on this track, integrated in time: its time"},
    {"reintegration_error", "the same: its arrival, speed and rotation"},
    {"agreement",
     "the same scene with polynomials of a higher degree: the relative "
     "difference of T"},
    {"extremal",
     "the same scene by multiple shooting, a method that shares only "
     "the physics: the relative difference of T"},
    {"extremal_slopes", "the same: the slopes at A and B"},
    {"extremal_junctions", "the same: where limits begin and cease to hold"},
    {"complementarity",
     "a limit has a price only where it holds as an equation"},
    {"multiplier_signs", "no limit holds that would better give way"},
    {"limits", "by how much a limit is exceeded, between points too"},
    {"reintegrated_limits",
     "by how much the motion integrated in time exceeds a limit"},
    {"quadrature_error", "of the time along the path that was given"},
    {"discrete_residual", "the equations of the paper's system"},
    {"discretisation", "its time, against that of the extremal"}};

}  // namespace

std::span<const CheckText> check_texts() {
  return kTexts;
}

std::string_view check_meaning(std::string_view check) {
  const auto found = std::ranges::find(kTexts, check, &CheckText::check);
  return found == std::end(kTexts) ? std::string_view{} : found->meaning;
}

}  // namespace brachisto::plot
