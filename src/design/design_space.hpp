// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The bodies that a design chooses from: coordinates, bounds of single ones,
/// and rows that bound several together.

#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "brachisto/model/scene.hpp"
#include "brachisto/study/design.hpp"
#include "math/portable_random.hpp"

namespace brachisto {

/// All that τ depends on of a cylinder: (η cos θ_m, η sin θ_m, k, r). In these
/// numbers τ is smooth, also where η = 0 and θ_m has no meaning.
using Traits = Eigen::Vector4d;

/// The angle of a direction that lies next to another angle.
[[nodiscard]] double angle_next_to(double angle, double other);

[[nodiscard]] Traits traits_of(const Body& body);
/// \param like  has what traits do not say; of all θ_m that are the same
///              direction the one next to its is taken
[[nodiscard]] Body body_of(const Traits& traits, const Body& like);

/// Bodies as points y of a box, some with rows c_l ≤ c(y) ≤ c_u besides.
class DesignSpace {
 public:
  struct Row {
    std::string name;
    double lower = 0.0, upper = 0.0;  ///< of c
  };

  virtual ~DesignSpace() = default;

  [[nodiscard]] int size() const { return static_cast<int>(lower_.size()); }
  [[nodiscard]] const std::vector<double>& lower() const { return lower_; }
  [[nodiscard]] const std::vector<double>& upper() const { return upper_; }
  /// Of each coordinate, as messages and bounds call it.
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  /// What 1 of a coordinate is in the unit of its file.
  [[nodiscard]] virtual double unit(std::size_t /*coordinate*/) const {
    return 1.0;
  }
  [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }

  /// The body, θ_m as its bounds have it or from −π to π.
  [[nodiscard]] Body body(const Eigen::VectorXd& y) const {
    return body_of(traits(y), like_);
  }
  [[nodiscard]] virtual Traits traits(const Eigen::VectorXd& y) const = 0;
  /// ∂(traits)/∂y.
  [[nodiscard]] virtual Eigen::Matrix4Xd traits_jacobian(
      const Eigen::VectorXd& y) const = 0;
  /// Nonzero for those traits that y moves.
  [[nodiscard]] Traits moved_traits(const Eigen::VectorXd& y) const {
    return traits_jacobian(y).cwiseAbs().rowwise().sum();
  }
  /// c(y), one value per row.
  [[nodiscard]] virtual Eigen::VectorXd row_values(
      const Eigen::VectorXd& y) const = 0;
  [[nodiscard]] virtual Eigen::MatrixXd row_jacobian(
      const Eigen::VectorXd& y) const = 0;
  /// The bound that a user stated, of a row at its lower or upper bound, and
  /// d(c_l or c_u)/d(that bound).
  struct Stated {
    double bound = 0.0, slope = 1.0;
  };
  [[nodiscard]] virtual Stated stated(std::size_t row, bool upper,
                                      const Eigen::VectorXd& y) const = 0;

  /// Bounds of a direction meet on the axis, where there is none, and both
  /// hold: then it is the offset that ends there, and this is dτ/dη along the
  /// bound where it is less. Nothing elsewhere.
  [[nodiscard]] virtual std::optional<double> corner_on_axis(
      const std::vector<double>& /*lambda*/) const {
    return std::nullopt;
  }

  /// What is free, as its file has it, and dτ/d(that) from dτ/d(traits).
  [[nodiscard]] virtual NamedNumbers values(const Eigen::VectorXd& y) const = 0;
  [[nodiscard]] virtual NamedNumbers slopes(const Eigen::VectorXd& y,
                                            const Traits& gradient) const = 0;

  /// The coordinates of the body that the scene has; if it lies outside, of one
  /// nearby and inside.
  [[nodiscard]] virtual Eigen::VectorXd first() const = 0;
  /// Halfway from a body to one whose centre of mass lies on its axis, as far
  /// as it is free.
  [[nodiscard]] virtual Eigen::VectorXd nearer_to_the_axis(
      const Eigen::VectorXd& y) const = 0;
  /// A body of the box that keeps the rows, away from them.
  [[nodiscard]] virtual Eigen::VectorXd random(SplitMix64& random) const = 0;

 protected:
  /// \param like  has what is not free
  explicit DesignSpace(const Body& like) : like_(like) {}
  DesignSpace(const DesignSpace&) = default;
  DesignSpace& operator=(const DesignSpace&) = default;

  Body like_;
  std::vector<double> lower_, upper_;
  std::vector<std::string> names_;
  std::vector<Row> rows_;
};

/// Bodies by their offset, its direction, their inertia and radius: those that
/// a plan without parts chooses from.
/// \param body  what is not free
[[nodiscard]] std::unique_ptr<DesignSpace> offset_space(const DesignPlan& plan,
                                                        const Body& body);

/// Bodies that consist of parts, some of which may move or change their mass.
/// \param body  what is not free
[[nodiscard]] std::unique_ptr<DesignSpace> parts_space(const DesignPlan& plan,
                                                       const Body& body);

/// The space of a plan: one of them.
/// \param body  what is not free
[[nodiscard]] std::unique_ptr<DesignSpace> design_space(const DesignPlan& plan,
                                                        const Body& body);

}  // namespace brachisto
