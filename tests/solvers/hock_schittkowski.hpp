// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Problems with inequalities by Hock and Schittkowski, Test Examples for
/// Nonlinear Programming Codes (1981), with the solutions printed there.
/// Constraints are written as there, so that those ≥ 0 have λ ≤ 0. kDigit is
/// one unit of the last digit of f that is printed (not all are rounded), or a
/// bound on the solver's error where f is a fraction.

#pragma once

#include <array>
#include <vector>

#include "solvers/inequality_problems.hpp"

namespace brachisto::testing {

using Bounds = nlp::Range;

/// Bounds on all variables, an inequality and an equation. The multipliers are
/// those of Ipopt's documentation, which solves it as its first example.
struct Hs71 {
  static constexpr int kVariables = 4, kConstraints = 2;
  static constexpr std::array<Bounds, 4> kBounds{
      {{1.0, 5.0}, {1.0, 5.0}, {1.0, 5.0}, {1.0, 5.0}}};
  static constexpr std::array<Bounds, 2> kRanges{
      {{25.0, kNoBound}, {40.0, 40.0}}};
  static inline const std::vector<double> kStart{1.0, 5.0, 5.0, 1.0};
  static inline const std::vector<double> kSolution{1.0, 4.7429994, 3.8211503,
                                                    1.3794082};
  static inline const std::vector<double> kMultipliers{-0.5522937, 0.1614686};
  static constexpr double kLeast = 17.0140173;
  static constexpr double kDigit = 1e-7;
  static constexpr int kEquations = 2;  ///< constraints that hold as such
  static constexpr int kFree = 3;

  template <class X>
  static auto f(const X& x) {
    return x[0] * x[3] * (x[0] + x[1] + x[2]) + x[2];
  }
  template <class X>
  static auto g(const X& x) {
    return std::array{x[0] * x[1] * x[2] * x[3],
                      x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + x[3] * x[3]};
  }
};

/// Beale's problem: x = (4/3, 7/9, 4/9), f = 1/9; from ∂f/∂x₀ = −2/9, λ = 2/9.
struct Hs35 {
  static constexpr int kVariables = 3, kConstraints = 1;
  static constexpr std::array<Bounds, 3> kBounds{
      {{0.0, kNoBound}, {0.0, kNoBound}, {0.0, kNoBound}}};
  static constexpr std::array<Bounds, 1> kRanges{{{-kNoBound, 3.0}}};
  static inline const std::vector<double> kStart{0.5, 0.5, 0.5};
  static inline const std::vector<double> kSolution{4.0 / 3.0, 7.0 / 9.0,
                                                    4.0 / 9.0};
  static inline const std::vector<double> kMultipliers{2.0 / 9.0};
  static constexpr double kLeast = 1.0 / 9.0;
  static constexpr double kDigit = 1e-10;
  static constexpr int kEquations = 1;
  static constexpr int kFree = 3;

  template <class X>
  static auto f(const X& x) {
    return 9.0 - 8.0 * x[0] - 6.0 * x[1] - 4.0 * x[2] + 2.0 * x[0] * x[0] +
           2.0 * x[1] * x[1] + x[2] * x[2] + 2.0 * x[0] * x[1] +
           2.0 * x[0] * x[2];
  }
  template <class X>
  static auto g(const X& x) {
    return std::array{x[0] + x[1] + 2.0 * x[2]};
  }
};

/// Rosen and Suzuki's: x = (0, 1, 2, −1), f = −44; ∇f = (−5, −3, −13, 5) there
/// is ∇g₀ + 2 ∇g₂, and g₁ = 1 does not hold as an equation.
struct Hs43 {
  static constexpr int kVariables = 4, kConstraints = 3;
  static constexpr std::array<Bounds, 4> kBounds{{{-kNoBound, kNoBound},
                                                  {-kNoBound, kNoBound},
                                                  {-kNoBound, kNoBound},
                                                  {-kNoBound, kNoBound}}};
  static constexpr std::array<Bounds, 3> kRanges{
      {{0.0, kNoBound}, {0.0, kNoBound}, {0.0, kNoBound}}};
  static inline const std::vector<double> kStart{0.0, 0.0, 0.0, 0.0};
  static inline const std::vector<double> kSolution{0.0, 1.0, 2.0, -1.0};
  static inline const std::vector<double> kMultipliers{-1.0, 0.0, -2.0};
  static constexpr double kLeast = -44.0;
  static constexpr double kDigit = 1e-10;
  static constexpr int kEquations = 2;
  static constexpr int kFree = 4;

  template <class X>
  static auto f(const X& x) {
    return x[0] * x[0] + x[1] * x[1] + 2.0 * x[2] * x[2] + x[3] * x[3] -
           5.0 * x[0] - 5.0 * x[1] - 21.0 * x[2] + 7.0 * x[3];
  }
  template <class X>
  static auto g(const X& x) {
    return std::array{8.0 - x[0] * x[0] - x[1] * x[1] - x[2] * x[2] -
                          x[3] * x[3] - x[0] + x[1] - x[2] + x[3],
                      10.0 - x[0] * x[0] - 2.0 * x[1] * x[1] - x[2] * x[2] -
                          2.0 * x[3] * x[3] + x[0] + x[3],
                      5.0 - 2.0 * x[0] * x[0] - x[1] * x[1] - x[2] * x[2] -
                          2.0 * x[0] + x[1] + x[3]};
  }
};

/// A quadratic program: x = (3, 23, 0, 6)/11, f = −103/22. g₀ holds, g₁ and g₂
/// do not; ∂f/∂x₁ = 23/11 − 3 = 2 λ₀.
struct Hs76 {
  static constexpr int kVariables = 4, kConstraints = 3;
  static constexpr std::array<Bounds, 4> kBounds{
      {{0.0, kNoBound}, {0.0, kNoBound}, {0.0, kNoBound}, {0.0, kNoBound}}};
  static constexpr std::array<Bounds, 3> kRanges{
      {{0.0, kNoBound}, {0.0, kNoBound}, {0.0, kNoBound}}};
  static inline const std::vector<double> kStart{0.5, 0.5, 0.5, 0.5};
  static inline const std::vector<double> kSolution{3.0 / 11.0, 23.0 / 11.0,
                                                    0.0, 6.0 / 11.0};
  static inline const std::vector<double> kMultipliers{-5.0 / 11.0, 0.0, 0.0};
  static constexpr double kLeast = -103.0 / 22.0;
  static constexpr double kDigit = 1e-10;
  static constexpr int kEquations = 1;
  static constexpr int kFree = 3;

  template <class X>
  static auto f(const X& x) {
    return x[0] * x[0] + 0.5 * x[1] * x[1] + x[2] * x[2] + 0.5 * x[3] * x[3] -
           x[0] * x[2] + x[2] * x[3] - x[0] - 3.0 * x[1] + x[2] - x[3];
  }
  template <class X>
  static auto g(const X& x) {
    return std::array{5.0 - x[0] - 2.0 * x[1] - x[2] - x[3],
                      4.0 - 3.0 * x[0] - x[1] - 2.0 * x[2] + x[3],
                      x[1] + 4.0 * x[2] - 1.5};
  }
};

/// Colville's third: two-sided constraints, and bounds on all variables.
struct Hs83 {
  static constexpr int kVariables = 5, kConstraints = 3;
  static constexpr std::array<Bounds, 5> kBounds{
      {{78.0, 102.0}, {33.0, 45.0}, {27.0, 45.0}, {27.0, 45.0}, {27.0, 45.0}}};
  static constexpr std::array<Bounds, 3> kRanges{
      {{0.0, 92.0}, {90.0, 110.0}, {20.0, 25.0}}};
  static inline const std::vector<double> kStart{78.0, 33.0, 27.0, 27.0, 27.0};
  static inline const std::vector<double> kSolution{78.0, 33.0, 29.99526, 45.0,
                                                    36.77581};
  static inline const std::vector<double> kMultipliers{};
  static constexpr double kLeast = -30665.53867;
  static constexpr double kDigit = 1e-5;
  static constexpr int kEquations = 2;
  static constexpr int kFree = 2;

  template <class X>
  static auto f(const X& x) {
    return 5.3578547 * x[2] * x[2] + 0.8356891 * x[0] * x[4] +
           37.293239 * x[0] - 40792.141;
  }
  template <class X>
  static auto g(const X& x) {
    return std::array{85.334407 + 0.0056858 * x[1] * x[4] +
                          0.0006262 * x[0] * x[3] - 0.0022053 * x[2] * x[4],
                      80.51249 + 0.0071317 * x[1] * x[4] +
                          0.0029955 * x[0] * x[1] + 0.0021813 * x[2] * x[2],
                      9.300961 + 0.0047026 * x[2] * x[4] +
                          0.0012547 * x[0] * x[2] + 0.0019085 * x[2] * x[3]};
  }
};

/// Seven variables without bounds, four constraints of degree up to four.
struct Hs100 {
  static constexpr int kVariables = 7, kConstraints = 4;
  static constexpr std::array<Bounds, 7> kBounds{{{-kNoBound, kNoBound},
                                                  {-kNoBound, kNoBound},
                                                  {-kNoBound, kNoBound},
                                                  {-kNoBound, kNoBound},
                                                  {-kNoBound, kNoBound},
                                                  {-kNoBound, kNoBound},
                                                  {-kNoBound, kNoBound}}};
  static constexpr std::array<Bounds, 4> kRanges{
      {{0.0, kNoBound}, {0.0, kNoBound}, {0.0, kNoBound}, {0.0, kNoBound}}};
  static inline const std::vector<double> kStart{1.0, 2.0, 0.0, 4.0,
                                                 0.0, 1.0, 1.0};
  static inline const std::vector<double> kSolution{
      2.330499, 1.951372, -0.4775414, 4.365726, -0.6244870, 1.038131, 1.594227};
  static inline const std::vector<double> kMultipliers{};
  static constexpr double kLeast = 680.6300573;
  static constexpr double kDigit = 1e-7;
  static constexpr int kEquations = 2;
  static constexpr int kFree = 7;

  template <class X>
  static auto f(const X& x) {
    const auto square = [](const auto& a) { return a * a; };
    return square(x[0] - 10.0) + 5.0 * square(x[1] - 12.0) +
           square(square(x[2])) + 3.0 * square(x[3] - 11.0) +
           10.0 * square(x[4]) * square(square(x[4])) + 7.0 * square(x[5]) +
           square(square(x[6])) - 4.0 * x[5] * x[6] - 10.0 * x[5] - 8.0 * x[6];
  }
  template <class X>
  static auto g(const X& x) {
    const auto square = [](const auto& a) { return a * a; };
    return std::array{
        127.0 - 2.0 * square(x[0]) - 3.0 * square(square(x[1])) - x[2] -
            4.0 * square(x[3]) - 5.0 * x[4],
        282.0 - 7.0 * x[0] - 3.0 * x[1] - 10.0 * square(x[2]) - x[3] + x[4],
        196.0 - 23.0 * x[0] - square(x[1]) - 6.0 * square(x[5]) + 8.0 * x[6],
        -4.0 * square(x[0]) - square(x[1]) + 3.0 * x[0] * x[1] -
            2.0 * square(x[2]) - 5.0 * x[5] + 11.0 * x[6]};
  }
};

}  // namespace brachisto::testing
