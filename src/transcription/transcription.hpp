// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What all nonlinear programs for the least time have in common.

#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "brachisto/model/scene.hpp"
#include "brachisto/nlp/problem.hpp"
#include "brachisto/ocp/mesh.hpp"
#include "brachisto/ocp/program.hpp"
#include "model/contact.hpp"
#include "model/hamiltonian.hpp"
#include "transcription/variable_layout.hpp"

namespace brachisto {

/// The least time of a scene between fixed end points of the centre, on a mesh.
///
/// An instance says what the unknowns and constraints are (VariableLayout), how
/// f and g follow from them, and the stencils of their derivatives. The chain
/// of the KKT matrix and names follow from that, and so does the tangency
/// condition at B.
class Transcription : public ocp::Program {
 public:
  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] const VariableLayout& layout() const { return layout_; }

  /// Moves the end of the centre to C_B(φ).
  void set_end_angle(double phi);

  [[nodiscard]] nlp::ChainStructure chain_structure() const override {
    return ocp::element_chain(layout_, mesh(), num_constraints());
  }
  [[nodiscard]] std::string variable_name(int index) const final {
    return layout_.variable_name(index);
  }
  [[nodiscard]] std::string constraint_name(int index) const final {
    return layout_.constraint_name(index);
  }

  /// State and costates at the end, and by which unknowns and multipliers they
  /// change. Costates are `by_lambda` and `by_x` of numerators over a common
  /// divisor.
  struct End {
    RollingState state;
    Costates p;  ///< p_x and p_z alone
    double divisor = 1.0;
    struct Rate {
      int index;
      double theta, w, p_x, p_z;
    };
    std::vector<Rate> by_x, by_lambda;
    double last_slope = 0.0;  ///< known without costates, in [−π, π]
  };
  /// At a point to which an instance may move for it; nothing if it is refused.
  [[nodiscard]] virtual std::optional<End> end(
      std::span<const double> x, std::span<const double> lambda) = 0;

  /// Costates at the end as exactly as multipliers tell them: minus the
  /// gradient of the least time with respect to the end point.
  /// \pre at the current point, if they depend on it
  [[nodiscard]] virtual Costates end_costates(
      std::span<const double> lambda) const = 0;

  /// β_end from transversality: with θ, w and the costates at the end the
  /// minimum of 𝓗 nearest to the last slope,
  ///
  ///     η cos(θ − β_end)/√A + w (p_z cos β_end − p_x sin β_end) = 0,
  ///
  /// so that it has the order of T; extrapolated slopes would not. NaN if there
  /// is none.
  ///
  /// \param x, lambda  a solution
  [[nodiscard]] double end_slope(std::span<const double> x,
                                 std::span<const double> lambda);

  /// What rounding leaves of residuals at x. A defect of collocation is a sum
  /// of some p + 1 unknowns times matrix entries of order p, and θ runs to
  /// thousands on the way of a small body.
  [[nodiscard]] virtual double rounding(std::span<const double> x) const;

 protected:
  /// \param origin  from which the centre's place is measured
  /// \param place   what a refusal names: "node"
  Transcription(const Scene& scene, Mesh mesh, VariableLayout layout,
                Point origin, const char* place);

  /// From now on the scene's start is built from the slope α at A.
  void choose_start_slope(double alpha) { scene_.world.start_slope = alpha; }
  /// w and θ of the last node, and how they change with their unknowns.
  [[nodiscard]] End end_of_states(std::span<const double> x) const;
  /// Another scene with the same unknowns and patterns. The current point is
  /// forgotten.
  void change_scene(const Scene& scene);

 private:
  Scene scene_;
  VariableLayout layout_;
  Point origin_;
};

}  // namespace brachisto
