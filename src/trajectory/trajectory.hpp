// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The motion that was found.

#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "brachisto/trajectory/motion.hpp"
#include "model/units.hpp"
#include "transcription/extremal_curve.hpp"
#include "transcription/limited_curve.hpp"

namespace brachisto {

/// A solution on a mesh on its way out, and the units it was solved in. Its
/// places are σ = u / U.
class MeshMotion : public Motion {
 public:
  [[nodiscard]] const Scene& scene() const override { return scene_; }
  [[nodiscard]] double transit_time() const override { return transit_time_; }
  [[nodiscard]] double centre_path_length() const override {
    return place(mesh_.num_elements() - 1, 1.0).s * units_.length;
  }
  [[nodiscard]] double start_angle() const override {
    return place(0, 0.0).state.beta;
  }
  [[nodiscard]] double end_angle() const override {
    return place(mesh_.num_elements() - 1, 1.0).state.beta;
  }
  [[nodiscard]] StartLimits at_start() const override;
  [[nodiscard]] TrajectoryPoint at(double sigma) const override;
  /// At every node of the mesh.
  [[nodiscard]] std::vector<TrajectoryPoint> at_nodes() const override {
    return at_places(nodes_);
  }
  [[nodiscard]] std::vector<TrajectoryPoint> fine_sample(
      int least) const override;
  /// `per_element` places in each element, the element's start left out; the
  /// first entry is the start of the path.
  [[nodiscard]] std::vector<TrajectoryPoint> sample(int per_element) const;

 protected:
  /// A place and what has passed up to there, in natural units.
  struct Place {
    PathState state;
    double t = 0.0, s = 0.0;
  };
  /// \param natural       the scene of the solution
  /// \param nodes         the places 0 < t ≤ 1 of an element's nodes
  /// \param rolling_time  U, in natural units
  /// \param scene         in SI units; its θ_m may differ from the solution's
  ///                      by whole turns
  /// \param transit_time  T [s]
  MeshMotion(const Scene& natural, const Mesh& mesh,
             std::span<const double> nodes, double rolling_time,
             const Scene& scene, const Units& units, double transit_time);

  /// At the place t of an element.
  [[nodiscard]] virtual Place place(int element, double t) const = 0;
  /// at_start() in natural units.
  [[nodiscard]] virtual StartLimits limits_at_start() const;

  [[nodiscard]] const Scene& natural() const { return natural_; }

 private:
  [[nodiscard]] TrajectoryPoint row(int element, double t, double sigma) const;
  /// At the start, and at the same places 0 < t ≤ 1 of all elements.
  [[nodiscard]] std::vector<TrajectoryPoint> at_places(
      std::span<const double> places) const;

  Scene natural_;
  Mesh mesh_;
  std::vector<double> nodes_;
  double rolling_time_;
  Scene scene_;
  Units units_;
  double transit_time_;
};

/// Without limits.
class Trajectory final : public MeshMotion {
 public:
  /// \param scene         see MeshMotion
  /// \param transit_time  T [s], if it is known better than from the curve
  Trajectory(ExtremalCurve curve, const Scene& scene, const Units& units,
             std::optional<double> transit_time = std::nullopt);

  [[nodiscard]] const ExtremalCurve& curve() const { return curve_; }

  /// From rest the one that leaving it demands.
  [[nodiscard]] double start_angle() const override;

 private:
  [[nodiscard]] Place place(int element, double t) const override;

  ExtremalCurve curve_;
};

/// Under limits.
class LimitedMotion final : public MeshMotion {
 public:
  /// As for Trajectory.
  LimitedMotion(LimitedCurve curve, const Scene& scene, const Units& units,
                std::optional<double> transit_time = std::nullopt);

  [[nodiscard]] const LimitedCurve& curve() const { return curve_; }

  /// Where arcs meet, if they are known.
  [[nodiscard]] std::vector<double> joints() const override;
  /// Where arcs are not known, with what their junctions may hide.
  [[nodiscard]] PathDiagnostics diagnose() const override;

 private:
  /// The least R_n and 1 − r κ_c, if a limit of the control holds that begins
  /// or ceases to do so within an element of there.
  struct AtJunctions {
    double normal_force = std::numeric_limits<double>::infinity();
    double fold_margin = std::numeric_limits<double>::infinity();
  };
  [[nodiscard]] AtJunctions at_junctions() const;
  /// Time and length of the centre's path, in natural units.
  struct Passed {
    double t = 0.0, s = 0.0;
  };
  /// From the start of an element to its place t.
  [[nodiscard]] Passed within(int element, double t) const;
  [[nodiscard]] Place place(int element, double t) const override;
  /// Where a limit of curvature or force holds from the start the curvature of
  /// the centre's path is finite there, otherwise dβ/du is not zero.
  [[nodiscard]] StartLimits limits_at_start() const override;

  LimitedCurve curve_;
  math::QuadratureRule rule_;
  std::vector<Passed> begins_;  ///< of elements
};

}  // namespace brachisto
