// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Which inequalities hold as equations.

#pragma once

#include <vector>

#include "brachisto/nlp/problem.hpp"

namespace brachisto::nlp {

/// The bound at which a variable is held, or to which a constraint is an
/// equation. Fixed variables and equations count as held at their lower bound.
enum class Held : signed char { No, AtLower, AtUpper };
/// The bound of a range at which something is held.
[[nodiscard]] inline double held_value(const Range& range, Held held) {
  return held == Held::AtUpper ? range.upper : range.lower;
}

/// Of every variable and every constraint. A constraint that is not held has
/// no part in the optimality conditions, and no multiplier.
struct ActiveSet {
  std::vector<Held> variables, constraints;

  bool operator==(const ActiveSet&) const = default;
  /// Rows and columns of the KKT matrix that is left: variables that are not
  /// held, constraints that are.
  [[nodiscard]] int num_free() const;
  [[nodiscard]] int num_equations() const;
};

/// Fixed variables and equations alone.
[[nodiscard]] ActiveSet equations_only(const Problem& problem);

/// The inequalities whose multiplier, over its weight, is at least the distance
/// from the bound. At a point of an interior-point method the product of the
/// two is the barrier parameter, so that one is small and the other is not,
/// unless both vanish at the solution (no strict complementarity); then the
/// guess is as good as any. The problem is moved to the point if it has
/// inequalities.
///
/// \throws std::domain_error if such a problem is not evaluable there
[[nodiscard]] ActiveSet active_set(Problem& problem, const PrimalDual& point);

/// Gives the variables held at a bound, and not fixed, the multipliers that
/// make the Lagrangian stationary in them, and all others zero. The problem has
/// been moved to the point. A multiplier < 0 tells that the variable should not
/// be held.
void set_bound_multipliers(const Problem& problem, const ActiveSet& active,
                           PrimalDual& point);

}  // namespace brachisto::nlp
