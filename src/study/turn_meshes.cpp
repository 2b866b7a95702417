// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "study/turn_meshes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "brachisto/transcription/discretisation.hpp"

namespace brachisto {

namespace {

// The continuation only has to tell branches apart; degree 5 with this many
// elements per turn of the body keeps its τ right to six digits or so.
constexpr int kCoarseDegree = 5;
constexpr double kCoarseElementsPerTurn = 7.0;
constexpr int kFewestCoarseElements = 8;
// Where an extremal is sampled instead of solved for, there have to be enough
// elements to represent it.
constexpr double kSampledElementsPerTurn = 12.0;
constexpr double kFineElementsPerTurn = 16.0;

/// Turns of the body along a path of its centre of length s. None matter to a
/// body that is not off-centred.
double turns(const Body& body, double s) {
  return body.off_centred() ? s / (2.0 * std::numbers::pi * body.radius) : 0.0;
}

/// Elements for so many turns, the half turn for the stretch at the start.
int elements_for(double turns, double per_turn) {
  return std::max(kFewestCoarseElements,
                  static_cast<int>(std::ceil(per_turn * (turns + 0.5))));
}

}  // namespace

Mesh coarse_mesh(const Scene& scene, const CycloidArc& arc) {
  return uniform_mesh(
      kCoarseDegree,
      elements_for(turns(scene.body, arc.arc_length(arc.psi_end)),
                   kCoarseElementsPerTurn));
}

Mesh sampled_mesh(const Body& body, double length) {
  return uniform_mesh(kCoarseDegree, elements_for(turns(body, length),
                                                  kSampledElementsPerTurn));
}

Mesh fine_mesh(const Body& body, double length) {
  return uniform_mesh(kMaxDegree,
                      elements_for(turns(body, length), kFineElementsPerTurn));
}

}  // namespace brachisto
