// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Validated integration: every solution that starts in a box of balls ends in
/// the box that comes out, and its derivatives in theirs.

#pragma once

#include <array>
#include <functional>
#include <vector>

#include "proof/equations.hpp"
#include "proof/tails.hpp"

namespace brachisto::proof {

/// How finely it is computed; no choice of it makes a result wrong.
struct Accuracy {
  int bits = 160;
  /// N, terms of a Taylor series.
  int terms = 40;
  /// h/ρ, a step over the radius of the disc on which bounds are known.
  double share = 0.18;
  /// Of every step only the middles are kept: numbers near, which enclose
  /// nothing.
  bool near = false;
};

/// Values of the components, then of their derivatives.
using State = std::vector<Real>;

/// One step: y(u) for |u| ≤ ρ from its series and the bound of what is left,
/// Σ_{k > N} |c_k| |u|^k ≤ E (|u|/ρ)^{N+1}.
class Step {
 public:
  Step(const TaylorSeries& series, const Tails& tails, double rho)
      : series_(series), tails_(tails), rho_(rho) {}

  /// \param u  in [−ρ, ρ]
  /// \param drop  j: (y_i(u) − at_zero)/u^j, where c_0 − at_zero, c_1 … c_{j−1}
  ///              are to vanish
  /// \throws NotProven  if one of these does not
  [[nodiscard]] Real value(std::size_t i, const Real& u, int drop = 0,
                           double at_zero = 0.0) const;
  /// Of the first so many inputs.
  [[nodiscard]] State values(const Real& u, std::size_t count) const;
  /// Of a node.
  [[nodiscard]] Real value(const Node& node, const Real& u, int drop = 0,
                           double at_zero = 0.0) const;
  /// Its derivative by u, |u| ≤ ρ/2.
  [[nodiscard]] Real rate(const Node& node, const Real& u) const;

  double begin = 0.0;  ///< u where the step starts, in its direction
  Real length;         ///< h ≥ 0

 private:
  const TaylorSeries& series_;
  const Tails& tails_;
  double rho_;
};

/// Of y' = f(y), f being nodes of a tape whose inputs are y.
class Integration {
 public:
  Integration(const Tape& tape, const std::vector<Node>& rates,
              const Accuracy& accuracy);

  /// Goes from a state over a length ≥ 0 of u.
  ///
  /// \param  state     [in,out]
  /// \param  backward  towards smaller u
  /// \param  look      is shown every step
  /// \return the number of steps
  /// \throws NotProven  if the boxes grow too wide for a step
  int go(State& state, const Real& length, bool backward = false,
         const std::function<void(const Step&)>& look = {});

 private:
  Accuracy accuracy_;
  TaylorSeries series_;
  Tails tails_;
};

/// Of Hamilton's equations on a free arc.
class Flow {
 public:
  Flow(const Scene& scene, int directions, const Accuracy& accuracy);

  /// See Integration.
  int go(State& state, const Real& length, bool backward = false,
         const std::function<void(const Step&)>& look = {}) {
    return integration_.go(state, length, backward, look);
  }

  [[nodiscard]] const Equations& equations() const { return equations_; }
  /// Rates of the components at a state.
  [[nodiscard]] State rates(const State& state) const;

 private:
  Equations equations_, plain_;
  Integration integration_;
};

}  // namespace brachisto::proof
