// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The least time between fixed end points as a nonlinear program in the
/// rolling time.

#pragma once

#include <span>
#include <vector>

#include "brachisto/ocp/mesh.hpp"
#include "rolling/rolling_body.hpp"
#include "transcription/collocated_time.hpp"

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
/// may depend on the place; rows and unknowns are the same. All follows from
/// the description of the steered body, ocp::Collocation.
///
/// A point is refused unless U > 0 and, at every collocation point, w > 0 and
/// A > 0: the body moves on and its kinetic energy is positive.
class RollingTime final
    : public CollocatedTime<rolling::SteeredFalling, rolling::Steered> {
 public:
  /// \param scene  valid, in units of the caller's choice
  /// \param phi    end angle φ [rad]; without effect with Contact::Centre
  RollingTime(const Scene& scene, Mesh mesh, double phi);

  [[nodiscard]] const CollocationScheme& scheme() const {
    return gauss_scheme(mesh().degree);
  }
  /// Cost and rates by u at a collocation point, with their first two
  /// derivatives by x, z, θ, w and β, those of no other matter being 0.
  using Jet = ocp::Collocation<rolling::Steered>::Jet;
  [[nodiscard]] ocp::Rates<Jet, 4> rates(std::span<const double> x,
                                         int point) const;

  /// Becomes the program of another scene, whose unknowns and kind of world are
  /// the same, on as many elements of the same degree: bounds and values
  /// change, patterns do not.
  void move_to(const Scene& scene, Mesh mesh, double phi);

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
  void fix_start();
  /// Whether the field depends on the place, so that p_x and p_z are not
  /// constant.
  [[nodiscard]] bool place_matters() const {
    return scene().world.field_varies();
  }
  [[nodiscard]] End world_end(std::span<const double> lambda) const;
};

}  // namespace brachisto
