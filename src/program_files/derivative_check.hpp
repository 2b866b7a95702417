// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Derivatives of a program against differences of what they derive.

#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "brachisto/nlp/problem.hpp"
#include "solvers/inertia.hpp"

namespace brachisto::program_files {

/// One array of derivatives D, tried on random directions d: D d against
///
///     (8 (F(x + h d) − F(x − h d)) − (F(x + 2 h d) − F(x − 2 h d))) / (12 h),
///
/// F what it derives. The formula errs by some h⁴ F⁽⁵⁾ and by rounding over h:
/// of some steps h the one that agrees best is taken, row by row, for an entry
/// that is wrong or missing disagrees with all. Directions touch all free
/// variables at once, each in proportion to its size but by no more than h.
struct DerivativeCheck {
  std::string name;         ///< "gradient", "Jacobian", "Hessian"
  std::size_t entries = 0;  ///< of the pattern
  int rows = 0, columns = 0;
  double largest = 0.0;        ///< of D d, and of what differences give
  double difference = 0.0;     ///< the largest, relative to the row's terms
  std::string worst_row = {};  ///< where

  /// What differences can tell.
  static constexpr double kAllowed = 1e-8;
  [[nodiscard]] bool agrees() const { return difference <= kAllowed; }
};

/// Of a program at a point.
struct ProgramCheck {
  int variables = 0, fixed = 0, constraints = 0, inequalities = 0;
  std::vector<DerivativeCheck> derivatives;
  int links = 0, largest_link = 0, border = 0;  ///< of the chain; 0: none
  Inertia inertia;                              ///< of the KKT matrix
  int wanted_positive = 0, wanted_negative = 0;

  [[nodiscard]] bool agrees() const;
  /// Whether the point is a strict minimum of the program, if it is stationary.
  [[nodiscard]] bool minimum() const;
  [[nodiscard]] std::string in_words() const;
  [[nodiscard]] nlohmann::ordered_json to_json() const;
};

/// \throws std::domain_error  if the problem is not evaluable next to the point
[[nodiscard]] ProgramCheck check_program(nlp::Problem& problem,
                                         const PrimalDual& point);

}  // namespace brachisto::program_files
