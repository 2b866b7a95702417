// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The least time between fixed end points as a nonlinear program in the
/// rolling time.

#pragma once

#include <span>
#include <vector>

#include "math/jet2.hpp"
#include "transcription/collocation.hpp"
#include "transcription/transcription.hpp"

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
/// In another world the start has w = v₀ √A, and w' is U speed_gain(), which
/// may depend on the place. Its derivatives and those of the Lagrangian are
/// then those of one point function of (x, z, θ, w, β); rows and unknowns are
/// the same.
///
/// A point is refused unless U > 0 and, at every collocation point, w > 0 and
/// A > 0: the body moves on and its kinetic energy is positive.
class RollingTime final : public Transcription {
 public:
  /// \param scene  valid, in units of the caller's choice
  /// \param phi    end angle φ [rad]; without effect with Contact::Centre
  RollingTime(const Scene& scene, Mesh mesh, double phi);

  [[nodiscard]] const CollocationScheme& scheme() const { return *scheme_; }

  /// Becomes the program of another scene, whose unknowns and kind of world are
  /// the same, on as many elements of the same degree: bounds and values
  /// change, patterns do not.
  void move_to(const Scene& scene, Mesh mesh, double phi);

  /// From now on element e takes the law of sides[e] of a sphere for its field,
  /// wherever its points lie: so all is smooth in its ends and in the scene. A
  /// point is forgotten.
  ///
  /// \param sides  of as many elements, or none: each point by its place
  void hold_sides(std::vector<SphereSide> sides);
  [[nodiscard]] const std::vector<SphereSide>& sides() const { return sides_; }

  /// Moves the start of the centre to C_A(α), with the w that v₀ means there.
  void set_start_slope(double alpha);

  /// Along the path: β, node and multipliers of one collocation point after the
  /// other, U last. The pivots are the defects for the node they lead to.
  [[nodiscard]] nlp::EliminationOrder elimination_order() const override;

  /// p_x = −λ_x/b and p_z likewise, read at the last collocation point; in a
  /// field that depends on the place as end_costates().
  [[nodiscard]] std::optional<End> end(std::span<const double> x,
                                       std::span<const double> lambda) override;
  /// The same at all collocation points, averaged over σ: they are constant but
  /// for the solver's residual. In a field that depends on the place they are
  /// not, and are those that the last element's points, at the places c_j, and
  /// the rates −∂𝓗/∂x there say of the end, Σ_j b_j (p_j − c_j hU ∂𝓗/∂x).
  [[nodiscard]] Costates end_costates(
      std::span<const double> lambda) const override;

 private:
  /// What f, g and their derivatives share, one entry per collocation point.
  struct Points {
    std::vector<double> w, cos_beta, sin_beta;
    std::vector<double> root;    ///< √A
    std::vector<double> d_root;  ///< ∂√A/∂β = −∂√A/∂θ
    std::vector<double> d2_root;  ///< ∂²√A/∂β² = ∂²√A/∂θ² = −∂²√A/∂θ∂β
    std::vector<double> eta_cos_theta, eta_sin_theta;
  };

  void fix_start();
  bool evaluate() override;
  [[nodiscard]] double do_eval_f() const override;
  void do_eval_grad_f(std::span<double> grad_f) const override;
  void do_eval_g(std::span<double> g) const override;
  void put_jac_g(Entries& put) const override;
  void put_hess_lag(double objective_factor, std::span<const double> lambda,
                    Entries& put) const override;

  /// In other worlds: x, z, θ, w, β.
  static constexpr int kLocals = 5;
  using Jet = math::Jet2<double, kLocals>;
  struct WorldPoint {
    Jet root;  ///< √A
    Jet gain;  ///< dw/du
  };
  [[nodiscard]] bool changes_rates() const { return !world_points_.empty(); }
  /// Whether the field depends on the place, so that p_x and p_z are not
  /// constant.
  [[nodiscard]] bool place_matters() const {
    return scene().world.sphere.has_value();
  }
  [[nodiscard]] bool has_local(int number) const {
    return number < 2 ? place_matters() : number > 2 || layout().has_theta();
  }
  [[nodiscard]] static StateComponent component_of(int local);
  [[nodiscard]] double interpolated(int point, StateComponent component) const;
  /// \param seen  the scene with the field of the point's element
  void evaluate_world(const Scene& seen, int point, double theta, double beta);
  void put_world_gain(int point, Entries& put) const;
  void put_world_hess_lag(double objective_factor,
                          std::span<const double> lambda, Entries& put) const;
  [[nodiscard]] End world_end(std::span<const double> lambda) const;

  const CollocationScheme* scheme_;
  Points points_;
  std::vector<WorldPoint> world_points_;  ///< empty in an ordinary world
  std::vector<SphereSide> sides_;         ///< held, by element, or none
};

}  // namespace brachisto
