// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The least time under limits along the path as a nonlinear program in the
/// rolling time.

#pragma once

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "brachisto/math/index.hpp"
#include "brachisto/math/jet.hpp"
#include "model/start_under_limits.hpp"
#include "nlp/active_set.hpp"
#include "rolling/rolling_body.hpp"
#include "transcription/collocated_time.hpp"
#include "transcription/program_formulas.hpp"

namespace brachisto {

/// A limit that is reached at A alone, where another one holds the control from
/// there on: the slope there lets both hold. From rest it is one on forces, and
/// the other one is not.
struct StartCorner {
  std::size_t limit;
  nlp::Held at;
};

/// What is fixed at the two contacts.
struct LimitedEnds {
  /// Both slopes are unknowns, tied to the places of the centre above A and B.
  bool free_contacts = false;
  double phi = 0.0;  ///< slope at B that C_B is built from; else without effect
  /// Slope at A that C_A is built from; nothing: the start angle of the body.
  std::optional<double> start = {};
  /// The path leaves with the slope `start`; otherwise β(0) is an unknown.
  bool start_slope_fixed = false;
  std::optional<StartCorner> corner = {};
};

/// Which limits hold as equations, and at which of their bounds.
struct HeldLimits {
  std::vector<std::vector<nlp::Held>> in_element;  ///< by element, then limit
  std::vector<nlp::Held> at_rest;                  ///< by limit
  /// By element, of its last point besides; nothing where empty or absent.
  std::vector<std::vector<nlp::Held>> at_end;
};

/// Radau IIA collocation of
///
///     minimise T = U ∫₀¹ √A dσ  subject to
///     y' = U f(y, q),  y = (x, z, θ, w, β),  ' = d/dσ,
///     lower ≤ c(y, q) ≤ upper for each limit,
///
/// cost, rates and limits being those of rolling::Turning in any world, and the
/// control q = dβ/du = w κ_c: the force of the track and its
/// curvature are affine in it. With Gauss's points β as a state would have a
/// null mode; here β(0) enters nothing but the first element's defects.
///
/// All of that is ocp::Collocation's of that body; what is added are the bounds
/// and the rows at the ends.
class LimitedTime final : public CollocatedTime<rolling::Turning> {
 public:
  /// \param scene   valid, in units of the caller's choice
  /// \param limits  in the same units
  /// \param held    nothing: all limits are inequalities; otherwise those that
  ///                are held are equations, and the others are not asked for
  LimitedTime(const Scene& scene, std::vector<PathInequality> limits, Mesh mesh,
              const LimitedEnds& ends, std::optional<HeldLimits> held = {});

  [[nodiscard]] const CollocationScheme& scheme() const {
    return collocation().scheme();
  }
  [[nodiscard]] const std::vector<PathInequality>& limits() const {
    return body().limits();
  }
  [[nodiscard]] const LimitedEnds& ends() const { return ends_; }
  [[nodiscard]] bool free_contacts() const { return ends_.free_contacts; }
  /// Whether the body starts with a speed.
  [[nodiscard]] bool pushed() const { return scene().world.start_speed > 0.0; }
  /// The same with all limits as inequalities.
  [[nodiscard]] LimitedTime as_inequalities() const {
    LimitedTime out(scene(), limits(), mesh(), ends_);
    out.draw_in(margins_);
    return out;
  }
  /// Draws the bounds of limits in at the points of each element, from A on as
  /// the place in the first one grows: between the points a path that keeps
  /// them just there may exceed them.
  ///
  /// \param margins  by element, then limit, ≥ 0; or none
  /// \pre no limit is held as an equation
  void draw_in(std::vector<std::vector<double>> margins) {
    margins_ = std::move(margins);
  }
  /// By which the bounds of a limit are drawn in at a point.
  [[nodiscard]] double margin(int point, int limit) const;
  /// The same program with other bounds of its limits, lengths of its elements
  /// and ends of the same kind.
  void change(std::vector<PathInequality> limits, Mesh mesh,
              const LimitedEnds& ends);
  /// The body at rest at A on a slope, where the limits on forces there hold.
  template <class Scalar>
  [[nodiscard]] TurningPoint<Scalar> resting(const Scalar& slope) const {
    TurningPoint<Scalar> out = resting_at(scene(), slope);
    if (!free_contacts()) {  // the centre is fixed, whatever β(0)
      const auto given = [&](StateComponent of) {
        return Scalar(variable_range(layout().state(0, of)).lower);
      };
      out.x = given(StateComponent::X);
      out.z = given(StateComponent::Z);
    }
    return out;
  }
  /// The rows behind those of the points, in their order: the contacts' and
  /// the push's where the slopes are free, then limits at rest. Each is of the
  /// unknowns at one node, at_end_row().
  [[nodiscard]] int num_end_rows() const {
    return layout().num_contact_rows() + layout().num_start_rows();
  }
  [[nodiscard]] bool is_at_start(int end_row) const {
    return end_row < 2 || end_row >= 4 || !free_contacts();
  }
  template <class Scalar>
  [[nodiscard]] Scalar at_end_row(int number, const Scalar& x, const Scalar& z,
                                  const Scalar& w, const Scalar& beta) const {
    const int contacts = layout().num_contact_rows();
    if (number >= contacts) {
      return value_of(limits()[at(number - contacts)], scene(), resting(beta));
    }
    if (number == 4) return w - pushed_w(scene(), beta);
    const bool at_A = number < 2;
    const OffContact<Scalar> off =
        off_contact(x, z, scene().body.radius, at_A ? 0.0 : scene().L,
                    at_A ? 0.0 : scene().H, beta);
    return number % 2 == 0 ? off.x : off.z;
  }
  /// Keeps |β| below a bound [rad] wherever it is not fixed.
  void bound_slopes(double steepest) { steepest_ = steepest; }
  [[nodiscard]] nlp::Range variable_range(int index) const override;
  [[nodiscard]] nlp::Range constraint_range(int index) const override;
  [[nodiscard]] double weight(int index) const override {
    return ocp::element_weight(layout(), scheme(), mesh(), index);
  }
  /// Adds rate times the derivative of ∇ₓL (n values), then g (m), by the
  /// length of an element, at the current point.
  void add_rates_by_length(int element, double rate,
                           std::span<const double> lambda,
                           std::span<double> out) const;
  [[nodiscard]] const std::optional<HeldLimits>& held() const { return held_; }
  /// Whether and where a limit is an equation at a collocation point. A limit
  /// of the place alone is one from the end of the element before on, since
  /// between the points of an element it does not see its first node.
  [[nodiscard]] nlp::Held held_at(int point, int limit) const;

  /// Contacts and limits at rest stand with their node.
  [[nodiscard]] nlp::ChainStructure chain_structure() const override;

  /// Costates at the end node, p = −∂L/∂(x, z)_N.
  [[nodiscard]] std::optional<End> end(std::span<const double> x,
                                       std::span<const double> lambda) override;
  [[nodiscard]] Costates end_costates(
      std::span<const double> lambda) const override;
  /// At the start, likewise p = ∂L/∂(x, z, w)_0.
  [[nodiscard]] Costates start_costates(std::span<const double> lambda) const;

 private:
  void fix_ends();
  [[nodiscard]] const ocp::Collocation<rolling::Turning>& collocation() const {
    return std::get<0>(collocation_);
  }
  [[nodiscard]] const rolling::Turning& body() const {
    return collocation().description();
  }
  /// By x, z, w and β of their node.
  using EndJet = math::Jet2<double, 4>;
  static constexpr std::array kOfEnds{StateComponent::X, StateComponent::Z,
                                      StateComponent::W, StateComponent::Beta};
  /// Calls with(row, node, value, dependence) for each of them.
  template <class With>
  void each_end_row(With&& with) const;

  /// What is held or an inequality.
  [[nodiscard]] bool asks_for(int point, int limit) const override {
    return !held_ || held_at(point, limit) != nlp::Held::No;
  }
  void do_eval_g(std::span<double> g) const override;
  void put_jac_g(Entries& put) const override;
  void put_hess_lag(double objective_factor, std::span<const double> lambda,
                    Entries& put) const override;

  LimitedEnds ends_;
  std::optional<HeldLimits> held_;
  std::vector<std::vector<double>> margins_;  ///< see draw_in()
  double steepest_ = std::numeric_limits<double>::infinity();
};

}  // namespace brachisto
