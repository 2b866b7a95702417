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

namespace brachisto::proof {

/// How finely it is computed; no choice of it makes a result wrong.
struct Accuracy {
  int bits = 160;
  /// N, terms of a Taylor series.
  int terms = 48;
  /// h/ρ, a step over the radius of the disc on which bounds are known.
  double share = 0.16;
};

/// Values of the components, then of their derivatives.
using State = std::vector<Real>;

/// One step: y(u) for |u| ≤ h from its series and the bound of what is left.
///
/// On the disc |u| ≤ ρ solutions from all complex starts within σ_j of the box
/// stay analytic, with |y_i'| ≤ B_i: Flow::encloses(). So, by Cauchy's
/// estimates,
///
///     |c_k| ≤ B ρ^{1−k}/k,   |∂c_k/∂y_j(0)| ≤ B ρ^{1−k}/(k σ_j).
class Step {
 public:
  Step(const TaylorSeries& series, std::size_t size, double rho,
       std::vector<double> bounds, std::vector<double> shifts)
      : series_(series),
        size_(size),
        rho_(rho),
        bounds_(std::move(bounds)),
        shifts_(std::move(shifts)) {}

  /// \param u  in [−ρ, ρ]
  /// \param drop  j: (y_i(u) − c_0 − … − c_{j−1} u^{j−1})/u^j
  [[nodiscard]] Real value(std::size_t i, const Real& u, int drop = 0) const;
  /// Of the first, the components: all of them, or with the derivatives.
  [[nodiscard]] State values(const Real& u, bool derivatives) const;
  /// A node's series without its first coefficient, over u, whose values are
  /// bounded on the disc.
  [[nodiscard]] Real slope(const Node& node, double bound, const Real& u) const;
  /// Largest modulus of a node on the disc.
  [[nodiscard]] double rho() const { return rho_; }
  [[nodiscard]] const TaylorSeries& series() const { return series_; }

  double begin = 0.0;         ///< u where the step starts, in its direction
  Real length;                ///< h ≥ 0
  double normal_bound = 0.0;  ///< |R_n| on the disc

 private:
  const TaylorSeries& series_;
  std::size_t size_;
  double rho_;
  std::vector<double> bounds_, shifts_;
};

class Flow {
 public:
  Flow(const Scene& scene, int directions, const Accuracy& accuracy);

  /// Goes from a state over a length ≥ 0 of u.
  ///
  /// \param  state     [in,out]
  /// \param  backward  towards smaller u
  /// \param  look      is shown every step
  /// \return the number of steps
  /// \throws NotProven  if the boxes grow too wide for a step
  int go(State& state, const Real& length, bool backward = false,
         const std::function<void(const Step&)>& look = {});

  [[nodiscard]] const Equations& equations() const { return equations_; }
  /// Without derivatives.
  [[nodiscard]] const Equations& plain() const { return plain_; }
  /// Rates of the components at a state.
  [[nodiscard]] State rates(const State& state) const;

 private:
  struct Disc {
    double rho = 0.0, tried = 0.0;
    std::vector<double> bounds, shifts;
    double normal = 0.0;
  };
  [[nodiscard]] bool encloses(const State& rates, double wide,
                              Disc& disc) const;

  Accuracy accuracy_;
  Equations equations_, plain_;
  TaylorSeries series_;
};

}  // namespace brachisto::proof
