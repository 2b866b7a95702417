// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The least time between fixed end points as a nonlinear program in the
/// rolling time.

#pragma once

#include <span>
#include <string>
#include <vector>

#include "brachisto/model/contact.hpp"
#include "brachisto/model/scene.hpp"
#include "brachisto/nlp/problem.hpp"
#include "brachisto/transcription/collocation.hpp"
#include "brachisto/transcription/mesh.hpp"
#include "brachisto/transcription/variable_layout.hpp"

namespace brachisto {

/// Gauss–Legendre collocation of
///
///     minimise T = U ∫₀¹ √A dσ  subject to
///     x' = U w cos β      z' = U w sin β
///     r θ' = U w          w' = U g (sin β + η cos θ),      ' = d/dσ,
///
/// where dt = U √A dσ and w = √(2 g E). The start (x, z, θ, w) = (C_A, θ_m, 0)
/// and the end (x, z) = C_B(φ) are fixed, θ and w are free at the end. Nothing
/// is singular at the start. r θ' = U w is the no-slip relation (eq. (6)); it
/// and θ are left out for a body whose centre of mass lies on its axis.
///
/// The defects of element e, D X − h_e U f with X at the nodes and f at the
/// collocation points, are in integral form: a tolerance on them means the
/// same on every mesh. VariableLayout tells the order of all of them.
///
/// A point is refused unless U > 0 and, at every collocation point, w > 0 and
/// A > 0: the body moves on and its kinetic energy is positive.
class RollingTime final : public nlp::Problem {
 public:
  /// \param scene  valid, in units of the caller's choice
  /// \param phi    end angle φ [rad]; without effect with Contact::Centre
  RollingTime(const Scene& scene, Mesh mesh, double phi);

  /// Moves the end of the centre to C_B(φ).
  void set_end_angle(double phi);

  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] const Mesh& mesh() const { return mesh_; }
  [[nodiscard]] const VariableLayout& layout() const { return layout_; }
  [[nodiscard]] const CollocationScheme& scheme() const { return *scheme_; }

  [[nodiscard]] int num_variables() const override {
    return layout_.num_variables();
  }
  [[nodiscard]] int num_constraints() const override {
    return layout_.num_constraints();
  }
  [[nodiscard]] std::span<const double> lower() const override {
    return lower_;
  }
  [[nodiscard]] std::span<const double> upper() const override {
    return upper_;
  }
  [[nodiscard]] const nlp::SparsityPattern& jac_g_pattern() const override {
    return jac_g_pattern_;
  }
  [[nodiscard]] const nlp::SparsityPattern& hess_lag_pattern() const override {
    return hess_lag_pattern_;
  }
  /// Along the path: β, node and multipliers of one collocation point after the
  /// other, U last. The pivots are the defects for the node they lead to.
  [[nodiscard]] nlp::EliminationOrder elimination_order() const override;
  /// A link is an element. Its separators are its end nodes, the right one with
  /// the multipliers of the last collocation point, which determine that node;
  /// the interior is the rest: β, inner nodes and the multipliers that
  /// determine them. U is the border.
  [[nodiscard]] nlp::ChainStructure chain_structure() const override;
  [[nodiscard]] std::string variable_name(int index) const override {
    return layout_.variable_name(index);
  }
  [[nodiscard]] std::string constraint_name(int index) const override {
    return layout_.constraint_name(index);
  }
  [[nodiscard]] std::string refusal() const override;

 private:
  /// What f, g and their derivatives share, one entry per collocation point.
  struct Points {
    std::vector<double> w, cos_beta, sin_beta;
    std::vector<double> root;    ///< √A
    std::vector<double> d_root;  ///< ∂√A/∂β = −∂√A/∂θ
    std::vector<double> d2_root;  ///< ∂²√A/∂β² = ∂²√A/∂θ² = −∂²√A/∂θ∂β
    std::vector<double> eta_cos_theta, eta_sin_theta;
  };

  bool do_set_point(std::span<const double> x) override;
  [[nodiscard]] std::span<const double> current_point() const override {
    return x_;
  }
  [[nodiscard]] double do_eval_f() const override;
  void do_eval_grad_f(std::span<double> grad_f) const override;
  void do_eval_g(std::span<double> g) const override;
  void do_eval_jac_g(std::span<double> values) const override;
  void do_eval_hess_lag(double objective_factor, std::span<const double> lambda,
                        std::span<double> values) const override;

  void fix(int variable, double value);
  void build_patterns();
  bool refuse(int point, const char* reason);

  /// The stencils. Each calls put(row, col, value) for every entry, always in
  /// the same order, so that pattern and values cannot drift apart.
  template <class Put>
  void visit_jac_g(Put&& put) const;
  template <class Put>
  void visit_hess_lag(double objective_factor, std::span<const double> lambda,
                      Put&& put) const;

  Scene scene_;
  Mesh mesh_;
  VariableLayout layout_;
  const CollocationScheme* scheme_;
  std::vector<double> lower_, upper_;
  nlp::SparsityPattern jac_g_pattern_, hess_lag_pattern_;

  std::vector<double> x_;  ///< the current point
  Points points_;
  int refused_point_ = -1;
  const char* refused_because_ = "";
};

}  // namespace brachisto
