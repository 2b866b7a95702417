// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A solution of a limited_time problem as functions of σ.

#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "brachisto/math/index.hpp"
#include "brachisto/nlp/problem.hpp"
#include "model/path_inequality.hpp"
#include "model/world_hamiltonian.hpp"
#include "transcription/limited_time.hpp"

namespace brachisto {

/// What is known at one σ, in the units of the problem's scene.
struct LimitedPoint {
  TurningPoint<double> state;
  Costates p = {};
  double p_beta = 0.0;
  /// Of each limit per unit of u, minus dT by its bound: ≥ 0 where a value is
  /// at its upper bound, ≤ 0 at its lower one.
  std::vector<double> multipliers;
};

/// The limit that is exceeded most, and where: at t ∈ [0, 1] of an element.
struct ExcessAt : Excess {
  int element = 0;
  double t = 0.0;
};

/// The state without slope and control.
[[nodiscard]] inline MovingState moving(const TurningPoint<double>& at) {
  return {{at.x, at.z}, at.theta, at.w};
}

/// The collocation polynomials of a solution: states of degree p through the
/// left end and the Radau points of an element, control, costates and
/// multipliers of degree p − 1 through the points alone.
class LimitedCurve {
 public:
  /// Of a copy of the problem.
  LimitedCurve(const LimitedTime& problem, PrimalDual point)
      : LimitedCurve(std::make_shared<LimitedTime>(problem), std::move(point)) {
  }
  /// Of the problem itself, which stays as it is for as long as this lives.
  LimitedCurve(std::shared_ptr<LimitedTime> problem, PrimalDual point);

  [[nodiscard]] const LimitedTime& problem() const { return *problem_; }
  [[nodiscard]] const PrimalDual& point() const { return *point_; }
  [[nodiscard]] double rolling_time() const {
    return point_->x[static_cast<std::size_t>(problem_->layout().last())];
  }
  [[nodiscard]] double transit_time() const { return transit_time_; }
  /// On an element.
  [[nodiscard]] double time_on(int element) const;
  /// Of all limits' multipliers, without sign and per unit of u, at the
  /// collocation points of the elements first … end − 1.
  [[nodiscard]] double largest_multiplier(int first, int end) const;
  /// Places of an element at which to look at limits: its points, so many more
  /// at equal distances, and where it is next to each disc, which may be
  /// smaller than these distances are.
  [[nodiscard]] std::vector<double> places(int element, int count) const;
  /// Of the limits along an element, at its points and where they are exceeded
  /// most between them; at rest of those that do not hold from there on. The
  /// control between points is the slope of β: both polynomials agree.
  [[nodiscard]] ExcessAt excess_on(int element) const;
  /// The largest one along the path, not a number if any is; ≤ 0: it keeps all.
  [[nodiscard]] ExcessAt largest_excess() const;
  /// The slope at the end by transversality with the costates there [rad]; see
  /// Transcription::end_slope().
  [[nodiscard]] double transverse_slope() {
    return problem_->end_slope(point_->x, point_->lambda);
  }
  /// Slope at A: where a body is pushed and no limit holds the control the one
  /// that the costates there ask for, NaN if there is none; otherwise the one
  /// the path begins with [rad].
  [[nodiscard]] double start_slope() const;
  /// What the corner at A is off its bound, the control of a push being that of
  /// the path.
  /// \pre the ends have a corner, as for the next one
  [[nodiscard]] double off_corner() const;
  /// What T grows by with the slope at A as that turns away from the bound of
  /// the corner, what holds the control going on to, or from rest with that
  /// bound: not negative in a minimum.
  [[nodiscard]] double corner_multiplier() const;
  /// The one at A from rest, where a limit on forces holds there and another
  /// one turns the path behind it: at an inequality, or what exceeds its bound
  /// by more than `exceeded` where those that hold are equations.
  [[nodiscard]] std::optional<StartCorner> corner_at_rest(
      double exceeded) const;
  /// Next to rest p_β, which a corner gives a value there, may ask for the
  /// opposite of the control that is held.
  struct Misled {
    double until = 0.0;  ///< σ
    /// What T may change by, as a share, if the corner's limit held the control
    /// up to there: with its change Δq, ∫ |p_β Δq| du/T; with smooth contacts,
    /// where T is not stationary and they go with the slope, ∫ |Δq| du.
    double cost = 0.0;
  };
  [[nodiscard]] Misled misled_from_rest() const;
  /// At the place t ∈ [0, 1] of an element: the state alone, and all.
  [[nodiscard]] TurningPoint<double> state_at(int element, double t) const;
  [[nodiscard]] LimitedPoint at(int element, double t) const;
  [[nodiscard]] LimitedPoint at(double sigma) const;

  /// Whether a limit is held as an equation at a collocation point.
  [[nodiscard]] bool active(int point, int limit) const;
  /// At which bound, if it does.
  /// \pre limits are inequalities
  [[nodiscard]] nlp::Held held(int point, int limit) const;
  /// Whether a limit of the control is one there.
  [[nodiscard]] bool holds_control(int point) const;

 private:
  // Copies share them. Nothing but the point that the program was evaluated at
  // last changes.
  std::shared_ptr<LimitedTime> problem_;
  std::shared_ptr<const PrimalDual> point_;
  double transit_time_ = 0.0;
  std::vector<nlp::Held> held_;     ///< inequalities, by point and limit
  std::vector<nlp::Held> at_rest_;  ///< those there, by limit on forces
};

/// States, controls, costates and multipliers given as a function of the place
/// in an element, at whose ends they may jump, as unknowns of a problem. A
/// multiplier is left out where the problem has no bound on its side.
[[nodiscard]] PrimalDual sample_at_mesh(
    const LimitedTime& problem, double rolling_time,
    const std::function<LimitedPoint(Mesh::Place)>& path);
/// The same of a function of σ ∈ [0, 1].
[[nodiscard]] PrimalDual sample_at_mesh(
    const LimitedTime& problem, double rolling_time,
    const std::function<LimitedPoint(double sigma)>& path);

/// The same states, controls and multipliers on another mesh, or under other
/// bounds of the same limits.
[[nodiscard]] PrimalDual prolong(const LimitedCurve& curve,
                                 const LimitedTime& problem);

/// Whether two paths, in natural units, are nowhere further apart than what
/// coarse meshes err by.
[[nodiscard]] bool alike(const LimitedCurve& a, const LimitedCurve& b);

}  // namespace brachisto
