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
#include "model/contact.hpp"
#include "model/hamiltonian.hpp"
#include "ocp/entries.hpp"
#include "ocp/mesh.hpp"
#include "transcription/variable_layout.hpp"

namespace brachisto {

/// The least time of a scene between fixed end points of the centre, on a mesh.
///
/// An instance says what the unknowns and constraints are (VariableLayout), how
/// f and g follow from them, and the stencils of their derivatives, link by
/// link. Bounds, patterns, the chain of the KKT matrix, names and refusals
/// follow from that, and so does the tangency condition at B.
class Transcription : public nlp::Problem {
 public:
  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] const Mesh& mesh() const { return mesh_; }
  [[nodiscard]] const VariableLayout& layout() const { return layout_; }

  /// Moves the end of the centre to C_B(φ).
  void set_end_angle(double phi);

  [[nodiscard]] int num_variables() const final {
    return layout_.num_variables();
  }
  [[nodiscard]] int num_constraints() const final {
    return layout_.num_constraints();
  }
  [[nodiscard]] std::span<const double> lower() const final { return lower_; }
  [[nodiscard]] std::span<const double> upper() const final { return upper_; }
  [[nodiscard]] const nlp::SparsityPattern& jac_g_pattern() const final {
    return jac_g_pattern_;
  }
  [[nodiscard]] const nlp::SparsityPattern& hess_lag_pattern() const final {
    return hess_lag_pattern_;
  }
  /// A link is an element. Its separators are its end nodes, the right one with
  /// the multipliers of the last point, which determine that node; the interior
  /// is the rest. The global unknown is the border.
  [[nodiscard]] nlp::ChainStructure chain_structure() const override;
  [[nodiscard]] std::string variable_name(int index) const final {
    return layout_.variable_name(index);
  }
  [[nodiscard]] std::string constraint_name(int index) const final {
    return layout_.constraint_name(index);
  }
  [[nodiscard]] std::string refusal() const final;

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
  void fix(int variable, double value);
  void bound(int variable, double lower, double upper);
  void release(int variable);
  void forget_point();
  /// As many elements of other lengths. The current point is forgotten.
  void change_lengths(Mesh mesh);
  /// Another scene with the same unknowns and patterns, likewise.
  void change_scene(const Scene& scene);
  /// Once all that stencils need has its size.
  void build_patterns();
  /// \param place  negative: none
  bool refuse(int place, const char* reason);
  /// The current point.
  [[nodiscard]] const std::vector<double>& x() const { return x_; }
  [[nodiscard]] double x(int index) const {
    return x_[static_cast<std::size_t>(index)];
  }

 private:
  bool do_set_point(std::span<const double> x) final;
  [[nodiscard]] std::span<const double> current_point() const final {
    return x_;
  }
  void do_eval_jac_g(std::span<double> values) const final;
  void do_eval_hess_lag(double objective_factor, std::span<const double> lambda,
                        std::span<double> values) const final;

  /// What f, g and their derivatives share at the current point; false after
  /// refuse().
  virtual bool evaluate() = 0;
  /// The stencils.
  virtual void put_jac_g(Entries& put) const = 0;
  virtual void put_hess_lag(double objective_factor,
                            std::span<const double> lambda,
                            Entries& put) const = 0;

  Scene scene_;
  Mesh mesh_;
  VariableLayout layout_;
  Point origin_;
  std::vector<double> lower_, upper_;
  nlp::SparsityPattern jac_g_pattern_, hess_lag_pattern_;
  std::vector<double> x_;
  const char* place_;
  int refused_place_ = -1;
  const char* refused_because_ = "";
};

}  // namespace brachisto
