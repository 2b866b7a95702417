// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Pontryagin's conditions as a system of equations for the states where arcs
/// meet and a few global unknowns, and where to start solving it.

#pragma once

#include "brachisto/extremal/shooting.hpp"
#include "brachisto/math/stop_condition.hpp"
#include "brachisto/model/scene.hpp"
#include "brachisto/model/units.hpp"
#include "extremal/chain_elimination.hpp"

namespace brachisto::shooting {

/// Positions in Globals.
enum Global : Eigen::Index { kU, kPX, kPZ, kPhi, kEta };

/// Residuals and derivatives at one point.
struct Linearisation {
  ChainRows residual;
  ChainJacobian jacobian;
  double transit_time = 0.0;  ///< Σ ∫√A du over the arcs
  double end_slope = 0.0;     ///< β at the end
  int steps = 0;              ///< of the integration
  int arc = 0;                ///< the one evaluated last, from 0
};

/// The equations for a scene in natural units; η is an unknown.
class ShootingSystem {
 public:
  /// \param stop  once met, evaluations fail from the next arc on
  ShootingSystem(const Scene& natural, int num_arcs, StopCondition stop = {})
      : scene_(natural), num_arcs_(num_arcs), stop_(stop) {}

  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] int num_arcs() const { return num_arcs_; }
  [[nodiscard]] bool stopped() const { return stop_.met(); }

  /// false if an arc, out.arc, cannot be integrated from there.
  [[nodiscard]] bool evaluate(const ChainVector& point,
                              const StepControl& control,
                              Linearisation& out) const;

  /// The path through the nodes' arcs, for output; empty if it fails.
  [[nodiscard]] std::vector<ExtremalPath::Knot> path(
      const ChainVector& point, const StepControl& control) const;

  /// What the matching errors left make T come out too small, to the first
  /// order: p = −∂T/∂y says what a gap of the path saves. Errors in costates
  /// count in the second order only.
  [[nodiscard]] double time_missing(const ChainVector& point,
                                    const ChainRows& residual) const;

 private:
  [[nodiscard]] CanonicalFlow flow(const ChainVector& point) const;

  Scene scene_;
  int num_arcs_;
  StopCondition stop_;
};

/// Scales that make changes of the unknowns comparable: each is divided by its
/// natural size before norms are taken.
struct ChainScale {
  Globals globals;
  Vector6 node;

  /// Largest scaled entry.
  [[nodiscard]] double norm(const ChainVector& change) const;
  [[nodiscard]] double norm(const ChainRows& residual) const;
};

/// point + factor · change.
[[nodiscard]] ChainVector moved(const ChainVector& point, double factor,
                                const ChainVector& change);

/// Number of arcs: `wanted`, or if that is 0 three for each turn of the body,
/// the natural length of all that varies along the path, but at least four.
[[nodiscard]] int choose_arcs(const Scene& natural, const ExtremalGuess& guess,
                              int wanted);

/// The guess where arcs meet. θ of a bead counts arc length, on which nothing
/// depends: it is left at zero here, and Newton's first step corrects it.
[[nodiscard]] ChainVector to_chain(const Scene& natural, const Units& units,
                                   const ExtremalGuess& guess, int num_arcs);

/// Natural sizes: those of the guess for U and (p_x, p_z), r for p_θ (which is
/// r times a costate of arc length), 1 for lengths, speeds and angles.
[[nodiscard]] ChainScale scale_of(const Scene& natural,
                                  const ChainVector& point);

}  // namespace brachisto::shooting
