// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "design/design_space.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace brachisto {

namespace {

constexpr std::string_view kSuffixes[] = {"x", "z", "mass"};

/// Bodies of the plan's parts. With M = Σ m_i, (e_x, e_z) the centre of mass
/// and j_i own inertias [radii²], all places in radii,
///
///     e_x = Σ m_i x_i / M,  e_z = Σ m_i z_i / M,
///     k = Σ m_i (j_i + (x_i − e_x)² + (z_i − e_z)²) / M,
///
/// whose derivatives are simple because Σ m_i (x_i − e_x) = 0. Coordinates are
/// places in radii, and masses as multiples of the stated ones.
class PartsSpace final : public DesignSpace {
 public:
  PartsSpace(const DesignPlan& plan, const Body& body)
      : DesignSpace(body), parts_(plan.parts), radius_(body.radius) {
    like_.theta_m = 0.0;
    for (const FreePart& free : plan.free_parts) {
      const MassPart& part = parts_[free.part];
      if (free.key == FreePart::Key::Mass) {
        add(Axis::Mass, free, part.mass,
            {free.bounds.lower / part.mass, free.bounds.upper / part.mass});
        continue;
      }
      const double room = 1.0 - part.extent() / radius_;
      places_.push_back(static_cast<Eigen::Index>(coordinates_.size()));
      add(Axis::X, free, radius_, {-room, room});
      add(Axis::Z, free, radius_, {-room, room});
      rows_.push_back({fmt::format("part_{}.at", free.part + 1),
                       -std::numeric_limits<double>::infinity(), room * room});
    }
  }

  [[nodiscard]] double unit(std::size_t coordinate) const override {
    return coordinates_[coordinate].unit;
  }

  [[nodiscard]] Traits traits(const Eigen::VectorXd& y) const override {
    try {
      const MassProperties found = mass_properties(moved(y), radius_);
      return traits_of(
          Body::cylinder(radius_, found.eta_m, found.theta_m, found.k));
    } catch (const std::invalid_argument&) {
      // Beyond the cylinder there is no body, which whoever solves for it sees.
      return Traits::Constant(std::numeric_limits<double>::quiet_NaN());
    }
  }

  [[nodiscard]] Eigen::Matrix4Xd traits_jacobian(
      const Eigen::VectorXd& y) const override {
    const std::vector<MassPart> parts = moved(y);
    const Traits t = traits(y);
    double mass = 0.0;
    for (const MassPart& part : parts) mass += part.mass;
    Eigen::Matrix4Xd out = Eigen::Matrix4Xd::Zero(4, size());
    for (std::size_t i = 0; i < coordinates_.size(); ++i) {
      const auto& [axis, index, unit] = coordinates_[i];
      const MassPart& part = parts[index];
      // From the centre of mass, in radii.
      const double x = part.centre.x / radius_ - t[0];
      const double z = part.centre.z / radius_ - t[1];
      const double j = part.own_inertia / (radius_ * radius_);
      const double share = part.mass / mass;
      auto column = out.col(static_cast<Eigen::Index>(i));
      switch (axis) {
        case Axis::X:
          column << share, 0.0, 2.0 * share * x, 0.0;
          break;
        case Axis::Z:
          column << 0.0, share, 2.0 * share * z, 0.0;
          break;
        case Axis::Mass:
          column << x, z, j + x * x + z * z - t[2], 0.0;
          column *= unit / mass;
          break;
      }
    }
    return out;
  }

  [[nodiscard]] Eigen::VectorXd row_values(
      const Eigen::VectorXd& y) const override {
    Eigen::VectorXd out(static_cast<Eigen::Index>(places_.size()));
    for (Eigen::Index i = 0; i < out.size(); ++i) {
      out[i] = y.segment<2>(places_[static_cast<std::size_t>(i)]).squaredNorm();
    }
    return out;
  }

  [[nodiscard]] Eigen::MatrixXd row_jacobian(
      const Eigen::VectorXd& y) const override {
    Eigen::MatrixXd out = Eigen::MatrixXd::Zero(
        static_cast<Eigen::Index>(places_.size()), size());
    for (Eigen::Index i = 0; i < out.rows(); ++i) {
      const Eigen::Index at = places_[static_cast<std::size_t>(i)];
      out.block<1, 2>(i, at) = 2.0 * y.segment<2>(at).transpose();
    }
    return out;
  }

  [[nodiscard]] Stated stated(std::size_t row, bool /*upper*/,
                              const Eigen::VectorXd& /*y*/) const override {
    // The row bounds the square of a distance in radii.
    const double room = std::sqrt(rows_[row].upper);
    return {room * radius_, 2.0 * room / radius_};
  }

  [[nodiscard]] NamedNumbers values(const Eigen::VectorXd& y) const override {
    NamedNumbers out;
    for (std::size_t i = 0; i < coordinates_.size(); ++i) {
      out.push_back(
          {names_[i], coordinates_[i].unit * y[static_cast<Eigen::Index>(i)]});
    }
    return out;
  }

  [[nodiscard]] NamedNumbers slopes(const Eigen::VectorXd& y,
                                    const Traits& gradient) const override {
    const Eigen::VectorXd by_y = traits_jacobian(y).transpose() * gradient;
    NamedNumbers out;
    for (std::size_t i = 0; i < coordinates_.size(); ++i) {
      out.push_back({names_[i], by_y[static_cast<Eigen::Index>(i)] /
                                    coordinates_[i].unit});
    }
    return out;
  }

  [[nodiscard]] Eigen::VectorXd first() const override {
    Eigen::VectorXd y(size());
    for (std::size_t i = 0; i < coordinates_.size(); ++i) {
      const auto& [axis, index, unit] = coordinates_[i];
      const MassPart& part = parts_[index];
      y[static_cast<Eigen::Index>(i)] = (axis == Axis::X   ? part.centre.x
                                         : axis == Axis::Z ? part.centre.z
                                                           : part.mass) /
                                        unit;
    }
    return y;
  }

  [[nodiscard]] Eigen::VectorXd nearer_to_the_axis(
      const Eigen::VectorXd& y) const override {
    Eigen::VectorXd out = y;
    for (const Eigen::Index at : places_) out.segment<2>(at) *= 0.5;
    return out;
  }

  [[nodiscard]] Eigen::VectorXd random(SplitMix64& random) const override {
    Eigen::VectorXd y = first();
    for (std::size_t i = 0; i < coordinates_.size(); ++i) {
      if (coordinates_[i].axis != Axis::Mass) continue;
      y[static_cast<Eigen::Index>(i)] = random.uniform(lower_[i], upper_[i]);
    }
    for (const Eigen::Index at : places_) {
      // Uniform in the disc of the room.
      const double distance =
          upper_[static_cast<std::size_t>(at)] * std::sqrt(random.uniform());
      const double angle = random.uniform(-std::numbers::pi, std::numbers::pi);
      y[at] = distance * std::cos(angle);
      y[at + 1] = distance * std::sin(angle);
    }
    return y;
  }

 private:
  enum class Axis { X, Z, Mass };
  struct Coordinate {
    Axis axis;
    std::size_t part;
    double unit;  ///< of the coordinate, in m or kg
  };

  void add(Axis axis, const FreePart& free, double unit, DesignBounds bounds) {
    coordinates_.push_back({axis, free.part, unit});
    names_.push_back(fmt::format("part_{}.{}", free.part + 1,
                                 kSuffixes[static_cast<std::size_t>(axis)]));
    lower_.push_back(bounds.lower);
    upper_.push_back(bounds.upper);
  }

  [[nodiscard]] std::vector<MassPart> moved(const Eigen::VectorXd& y) const {
    std::vector<MassPart> parts = parts_;
    for (std::size_t i = 0; i < coordinates_.size(); ++i) {
      const auto& [axis, index, unit] = coordinates_[i];
      const double value = unit * y[static_cast<Eigen::Index>(i)];
      MassPart& part = parts[index];
      (axis == Axis::X   ? part.centre.x
       : axis == Axis::Z ? part.centre.z
                         : part.mass) = value;
      part.reach =
          std::hypot(part.centre.x, part.centre.z) + parts_[index].extent();
    }
    return parts;
  }

  std::vector<MassPart> parts_;
  double radius_;
  std::vector<Coordinate> coordinates_;
  /// Of each row the first of the two coordinates of a place.
  std::vector<Eigen::Index> places_;
};

}  // namespace

std::unique_ptr<DesignSpace> parts_space(const DesignPlan& plan,
                                         const Body& body) {
  return std::make_unique<PartsSpace>(plan, body);
}

}  // namespace brachisto
