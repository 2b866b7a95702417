// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Bodies that consist of parts, some of which may move or change their mass.

#pragma once

#include <vector>

#include "design/design_space.hpp"

namespace brachisto {

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
  PartsSpace(const DesignPlan& plan, const Body& body);

  [[nodiscard]] Traits traits(const Eigen::VectorXd& y) const override;
  [[nodiscard]] Eigen::Matrix4Xd traits_jacobian(
      const Eigen::VectorXd& y) const override;
  [[nodiscard]] Eigen::VectorXd row_values(
      const Eigen::VectorXd& y) const override;
  [[nodiscard]] Eigen::MatrixXd row_jacobian(
      const Eigen::VectorXd& y) const override;
  [[nodiscard]] Stated stated(std::size_t row, bool upper,
                              const Eigen::VectorXd& y) const override;
  [[nodiscard]] NamedNumbers values(const Eigen::VectorXd& y) const override;
  [[nodiscard]] NamedNumbers slopes(const Eigen::VectorXd& y,
                                    const Traits& gradient) const override;
  [[nodiscard]] Eigen::VectorXd first() const override;
  [[nodiscard]] Eigen::VectorXd nearer_to_the_axis(
      const Eigen::VectorXd& y) const override;
  [[nodiscard]] Eigen::VectorXd random(SplitMix64& random) const override;

 private:
  enum class Axis { X, Z, Mass };
  struct Coordinate {
    Axis axis;
    std::size_t part;
    double unit;  ///< of the coordinate, in m or kg
  };

  void add(Axis axis, const FreePart& free, double unit, DesignBounds bounds);
  [[nodiscard]] std::vector<MassPart> moved(const Eigen::VectorXd& y) const;

  std::vector<MassPart> parts_;
  double radius_;
  std::vector<Coordinate> coordinates_;
  /// Of each row the first of the two coordinates of a place.
  std::vector<Eigen::Index> places_;
};

}  // namespace brachisto
