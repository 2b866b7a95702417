// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The Newton system of a problem that is a chain, with the unknowns whose
// values are given and its tangency condition around the symmetric chain.

#pragma once

#include <memory>
#include <span>
#include <vector>

#include "solvers/kkt_system.hpp"

namespace brachisto {

class ChainLdlt;

/// With u the free variables and the multipliers of constraints that are held,
/// v the unknowns whose values are given and φ the parameter, the Jacobian of a
/// KktSystem is
///
///     K u + C v        = b_u
///           v − ρ φ    = b_v
///     qᵀu + sᵀv + d φ  = b_φ,
///
/// K symmetric and a chain. It is solved by block elimination: two solutions
/// with K, and one pivot σ = d + sᵀρ − qᵀK⁻¹Cρ. Refinement of the whole makes
/// up for a K that is nearer to singular than the system.
class BorderedChain {
 public:
  /// Null if the problem is no chain. `system` must outlive this.
  [[nodiscard]] static std::unique_ptr<BorderedChain> make(
      const KktSystem& system);
  ~BorderedChain();

  /// At the point of the last KktSystem::evaluate_jacobian(). False if the
  /// system is singular, or K is although the system is not.
  [[nodiscard]] bool factorise();
  /// For a problem whose mesh has changed, before that: unknowns are scaled by
  /// the lengths of its elements.
  void rescale();

  /// For another try, after factorise() or solve() refused: pivots chosen for
  /// this very matrix.
  void forget_pivots();

  /// Sign of the determinant of the system.
  [[nodiscard]] int determinant_sign() const;

  /// Solves for a step of Newton's method, with refinement where it is needed,
  /// residuals in long double. False if that does not help: then the
  /// factorisation is worthless.
  ///
  /// \param enough  what may be left of b. A step of Newton's method need not
  ///                be more exact than this: what it leaves of the residual is
  ///                seen, and taken on, by the next.
  [[nodiscard]] bool solve(std::span<const double> b, std::span<double> x,
                           double enough = 1e-6);
  /// The same for a right-hand side of which less depends. It is not checked
  /// where the last one was found at once, by the same factors.
  [[nodiscard]] bool solve_alike(std::span<const double> b, std::span<double> x,
                                 double enough);

 private:
  BorderedChain(const KktSystem& system, std::unique_ptr<ChainLdlt> chain);
  template <class Rounded>
  void couple(std::span<const double> x, std::span<double> rhs,
              Rounded&& rounded) const;
  void solve_once(std::span<double> x) const;
  void residual(std::span<const double> b, std::span<const double> x,
                std::span<double> out) const;
  [[nodiscard]] long double tangency_product(std::span<const double> x) const;

  const KktSystem& system_;
  std::unique_ptr<ChainLdlt> chain_;
  std::vector<double> column_;  ///< K⁻¹Cρ, and −ρ for v
  double pivot_ = 1.0;          ///< σ
  bool at_once_ = false;        ///< the last solution, without refinement
};

}  // namespace brachisto
