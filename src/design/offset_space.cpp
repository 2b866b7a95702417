// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "design/design_space.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "brachisto/model/body.hpp"

namespace brachisto {

namespace {

constexpr double kOpenEnd = std::numeric_limits<double>::infinity();

/// Bodies by their offset, inertia and radius. An offset that is free in size
/// and direction has the coordinates e_x = η cos θ_m and e_z = η sin θ_m, or η
/// = 0 would be a place that no search leaves in the right direction.
class OffsetSpace final : public DesignSpace {
 public:
  OffsetSpace(const DesignPlan& plan, const Body& body)
      : DesignSpace(body), plan_(plan), body_(body) {
    if (plan.is_free(BodyKey::ThetaM)) {
      const DesignBounds angle = plan.bounds_of(BodyKey::ThetaM);
      like_.theta_m =
          std::isfinite(angle.lower) ? 0.5 * (angle.lower + angle.upper) : 0.0;
    }
    const bool eta = plan.is_free(BodyKey::EtaM);
    const bool theta = plan.is_free(BodyKey::ThetaM);
    if (eta && theta) {
      // Its row bounds the offset; a box that touched it would hold twice.
      constexpr double kBeyond = 1.1;
      const double largest = kBeyond * plan.bounds_of(BodyKey::EtaM).upper;
      add(Axis::X, "eta_m cos theta_m", {-largest, largest});
      add(Axis::Z, "eta_m sin theta_m", {-largest, largest});
      add_offset_rows();
    } else if (eta) {
      add(Axis::Eta, "eta_m", plan.bounds_of(BodyKey::EtaM));
    } else if (theta) {
      add(Axis::Theta, "theta_m", plan.bounds_of(BodyKey::ThetaM));
    }
    if (plan.is_free(BodyKey::K)) {
      add(Axis::K, "k", plan.bounds_of(BodyKey::K));
    }
    if (plan.is_free(BodyKey::Radius)) {
      add(Axis::Radius, "r", plan.bounds_of(BodyKey::Radius));
    }
    if (eta || plan.is_free(BodyKey::K)) {
      rows_.push_back({"rim", -kOpenEnd, 1.0});
      kinds_.push_back(Kind::Rim);
    }
  }

  [[nodiscard]] Traits traits(const Eigen::VectorXd& y) const override {
    Body body = body_;
    Traits out = traits_of(body);
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      const double value = y[at(i)];
      if (is_trait(axes_[i])) {
        out[trait(axes_[i])] = value;
      } else {
        (axes_[i] == Axis::Eta ? body.eta_m : body.theta_m) = value;
        out.head<2>() = traits_of(body).head<2>();
      }
    }
    return out;
  }

  [[nodiscard]] Eigen::Matrix4Xd traits_jacobian(
      const Eigen::VectorXd& y) const override {
    Eigen::Matrix4Xd out = Eigen::Matrix4Xd::Zero(4, size());
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      auto column = out.col(at(i));
      if (is_trait(axes_[i])) {
        column[trait(axes_[i])] = 1.0;
      } else if (axes_[i] == Axis::Eta) {
        column.head<2>() << std::cos(body_.theta_m), std::sin(body_.theta_m);
      } else {
        column.head<2>() << -body_.eta_m * std::sin(y[at(i)]),
            body_.eta_m * std::cos(y[at(i)]);
      }
    }
    return out;
  }

  [[nodiscard]] Eigen::VectorXd row_values(
      const Eigen::VectorXd& y) const override {
    const Traits t = traits(y);
    Eigen::VectorXd out(at(rows_.size()));
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const auto [square, slope] = form(kinds_[i]);
      out[at(i)] = square * t.head<2>().squaredNorm() +
                   (slope[0] * t[0] + slope[1] * t[1] + slope[2] * t[2]);
    }
    return out;
  }
  [[nodiscard]] Eigen::MatrixXd row_jacobian(
      const Eigen::VectorXd& y) const override {
    const Traits t = traits(y);
    Eigen::MatrixX4d by_traits(at(rows_.size()), 4);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      auto [square, slope] = form(kinds_[i]);
      slope.head<2>() += 2.0 * square * t.head<2>();
      by_traits.row(at(i)) = slope.transpose();
    }
    return by_traits * traits_jacobian(y);
  }

  [[nodiscard]] Stated stated(std::size_t row, bool upper,
                              const Eigen::VectorXd& y) const override {
    const DesignBounds eta = plan_.bounds_of(BodyKey::EtaM);
    const DesignBounds angle = plan_.bounds_of(BodyKey::ThetaM);
    const double size = traits(y).head<2>().norm();
    switch (kinds_[row]) {
      case Kind::Size: {
        const double bound = upper ? eta.upper : eta.lower;
        return {bound, 2.0 * bound};
      }
      // Turning the bound by dθ moves the row by −η dθ, as a bound of η dθ
      // would.
      case Kind::From:
        return {angle.lower, size};
      case Kind::To:
        return {angle.upper, -size};
      case Kind::Rim:
        return {1.0, 1.0};
    }
    return {};
  }

  /// With −λ_l and −λ_u as forces of both bounds, dτ/dη at the angle θ is
  /// −λ_l sin(θ − θ_l) − λ_u sin(θ_u − θ), least at an end.
  [[nodiscard]] std::optional<double> corner_on_axis(
      const std::vector<double>& lambda) const override {
    double least = kOpenEnd;
    for (std::size_t i = 0; i < kinds_.size(); ++i) {
      if (kinds_[i] != Kind::From && kinds_[i] != Kind::To) continue;
      least = std::min(least, -lambda[i]);
    }
    if (!(least > 0.0) || least == kOpenEnd) return std::nullopt;
    const DesignBounds angle = plan_.bounds_of(BodyKey::ThetaM);
    return least * std::sin(angle.upper - angle.lower);
  }

  [[nodiscard]] NamedNumbers values(const Eigen::VectorXd& y) const override {
    const Body body = this->body(y);
    NamedNumbers out;
    for (const BodyKey key : kBodyKeys) {
      if (!plan_.is_free(key)) continue;
      const double value = key == BodyKey::EtaM     ? body.eta_m
                           : key == BodyKey::ThetaM ? body.theta_m
                           : key == BodyKey::K      ? body.k
                                                    : body.radius;
      out.push_back({std::string(name(key)), value});
    }
    return out;
  }

  [[nodiscard]] NamedNumbers slopes(const Eigen::VectorXd& y,
                                    const Traits& gradient) const override {
    const Body body = this->body(y);
    const double c = std::cos(body.theta_m), s = std::sin(body.theta_m);
    NamedNumbers out;
    for (const BodyKey key : kBodyKeys) {
      if (!plan_.is_free(key)) continue;
      const double slope =
          key == BodyKey::EtaM ? gradient[0] * c + gradient[1] * s
          : key == BodyKey::ThetaM
              ? body.eta_m * (gradient[1] * c - gradient[0] * s)
          : key == BodyKey::K ? gradient[2]
                              : gradient[3];
      out.push_back({std::string(name(key)), slope});
    }
    return out;
  }

  [[nodiscard]] Eigen::VectorXd first() const override {
    return coordinates(within_bounds(body_));
  }

  [[nodiscard]] Eigen::VectorXd nearer_to_the_axis(
      const Eigen::VectorXd& y) const override {
    Eigen::VectorXd out = y;
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      const Axis axis = axes_[i];
      if (axis == Axis::X || axis == Axis::Z || axis == Axis::Eta) {
        out[at(i)] = std::max(0.5 * y[at(i)], lower_[i]);
      }
    }
    return out;
  }

  [[nodiscard]] Eigen::VectorXd coordinates(const Body& body) const {
    Eigen::VectorXd y(size());
    const Traits t = traits_of(body);
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      const double value = is_trait(axes_[i])      ? t[trait(axes_[i])]
                           : axes_[i] == Axis::Eta ? body.eta_m
                                                   : body.theta_m;
      y[at(i)] = std::clamp(value, lower_[i], upper_[i]);
    }
    return y;
  }

  [[nodiscard]] Eigen::VectorXd random(SplitMix64& random) const override {
    // Of the room below the rim, η² + k ≤ 1, about this share is taken.
    constexpr double kAwayFromRim = 0.95;
    const auto within = [&](DesignBounds bounds, double room) {
      return random.uniform(
          bounds.lower, std::max(bounds.lower, std::min(bounds.upper, room)));
    };
    Body body = body_;
    if (plan_.is_free(BodyKey::Radius)) {
      body.radius = within(plan_.bounds_of(BodyKey::Radius), kOpenEnd);
    }
    if (plan_.is_free(BodyKey::EtaM)) {
      const double k = plan_.is_free(BodyKey::K)
                           ? plan_.bounds_of(BodyKey::K).lower
                           : body.k;
      body.eta_m = within(plan_.bounds_of(BodyKey::EtaM),
                          kAwayFromRim * std::sqrt(std::max(0.0, 1.0 - k)));
    }
    if (plan_.is_free(BodyKey::K)) {
      body.k = within(plan_.bounds_of(BodyKey::K),
                      kAwayFromRim * largest_k(body.eta_m));
    }
    if (plan_.is_free(BodyKey::ThetaM)) {
      DesignBounds angle = plan_.bounds_of(BodyKey::ThetaM);
      if (!std::isfinite(angle.lower)) {
        angle = {-std::numbers::pi, std::numbers::pi};
      }
      body.theta_m = within(angle, kOpenEnd);
    }
    return coordinates(body);
  }

 private:
  /// The body, or one nearby that keeps all bounds but the rim's.
  [[nodiscard]] Body within_bounds(Body body) const {
    const auto keep = [&](BodyKey key, double& value) {
      const DesignBounds bounds = plan_.bounds_of(key);
      if (!plan_.is_free(key)) return;
      value = std::clamp(value, bounds.lower, bounds.upper);
    };
    const DesignBounds angle = plan_.bounds_of(BodyKey::ThetaM);
    if (body.theta_m < angle.lower || body.theta_m > angle.upper) {
      body.theta_m = angle_next_to(body.theta_m, like_.theta_m);
    }
    keep(BodyKey::EtaM, body.eta_m);
    keep(BodyKey::ThetaM, body.theta_m);
    keep(BodyKey::K, body.k);
    keep(BodyKey::Radius, body.radius);
    return body;
  }

  /// Traits, then what the offset is in polar coordinates.
  enum class Axis { X, Z, K, Radius, Eta, Theta };
  [[nodiscard]] static bool is_trait(Axis axis) { return axis < Axis::Eta; }
  [[nodiscard]] static Eigen::Index trait(Axis axis) {
    return static_cast<Eigen::Index>(axis);
  }

  enum class Kind { Size, From, To, Rim };

  /// A row as a function of the traits: square · (e_x² + e_z²) + slope ·
  /// traits.
  struct Form {
    double square;
    Traits slope;
  };
  /// η² ≤ the square of its bound; a direction that turns from θ_l to θ_u, less
  /// than half a turn, −e_x sin θ_l + e_z cos θ_l ≥ 0 and e_x sin θ_u − e_z cos
  /// θ_u ≥ 0; the rim, e_x² + e_z² + k ≤ 1.
  [[nodiscard]] Form form(Kind kind) const {
    const DesignBounds angle = plan_.bounds_of(BodyKey::ThetaM);
    switch (kind) {
      case Kind::Size:
        return {1.0, Traits::Zero()};
      case Kind::From:
        return {0.0, {-std::sin(angle.lower), std::cos(angle.lower), 0.0, 0.0}};
      case Kind::To:
        return {0.0, {std::sin(angle.upper), -std::cos(angle.upper), 0.0, 0.0}};
      case Kind::Rim:
        break;
    }
    return {1.0, {0.0, 0.0, 1.0, 0.0}};
  }

  [[nodiscard]] static Eigen::Index at(std::size_t i) {
    return static_cast<Eigen::Index>(i);
  }

  void add(Axis axis, std::string name, DesignBounds bounds) {
    axes_.push_back(axis);
    names_.push_back(std::move(name));
    lower_.push_back(bounds.lower);
    upper_.push_back(bounds.upper);
  }

  void add_offset_rows() {
    const DesignBounds eta = plan_.bounds_of(BodyKey::EtaM);
    const double least = eta.lower > 0.0 ? eta.lower * eta.lower : -kOpenEnd;
    rows_.push_back({"eta_m", least, eta.upper * eta.upper});
    kinds_.push_back(Kind::Size);
    if (!std::isfinite(plan_.bounds_of(BodyKey::ThetaM).lower)) return;
    for (const Kind kind : {Kind::From, Kind::To}) {
      rows_.push_back({"theta_m", 0.0, kOpenEnd});
      kinds_.push_back(kind);
    }
  }

  DesignPlan plan_;
  Body body_;
  std::vector<Axis> axes_;
  std::vector<Kind> kinds_;
};

}  // namespace

std::unique_ptr<DesignSpace> offset_space(const DesignPlan& plan,
                                          const Body& body) {
  return std::make_unique<OffsetSpace>(plan, body);
}

}  // namespace brachisto
