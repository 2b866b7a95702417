// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Programs of many small elements, as other people have them, with exact
/// derivatives, for Ipopt's C interface.

#pragma once

#include <array>
#include <string>
#include <vector>

#include "brachisto/math/jet.hpp"

namespace brachisto::benchmarks {

/// minimise Σ cost_e(x) subject to rows_e(x) = 0 and bounds, each element of at
/// most kWidth variables.
struct SeparableProgram {
  static constexpr int kWidth = 8, kRows = 2;
  using Number = math::Jet2<double, kWidth>;

  struct Element {
    std::array<int, kWidth> variables{};
    int count = 0;  ///< of variables
    int rows = 0;   ///< of constraints
    double data = 0.0;
  };
  /// What one element adds; `rows` has room for kRows.
  using Formulas = void (*)(const Element&, double step, const Number* x,
                            Number& cost, Number* rows);

  std::vector<double> lower, upper, start;
  std::vector<Element> elements;
  Formulas formulas = nullptr;
  double step = 0.0;

  [[nodiscard]] int size() const { return static_cast<int>(start.size()); }
  /// \return its index
  int add_variable(double at, double least = -1e20, double most = 1e20);
};

/// How a solve ended.
struct ProgramRun {
  int status = -1;  ///< Ipopt's
  int iterations = 0;
  double cost = 0.0;
  double cpu = 0.0;  ///< of the solve without evaluations [s]
};

/// \param solver  linear_solver of Ipopt
[[nodiscard]] ProgramRun solve(const SeparableProgram& program,
                               const std::string& solver);

/// The families that are chains: direct collocation of van der Pol's
/// oscillator, multiple shooting of a pendulum, a band of seven diagonals, and
/// blocks that share four parameters; and five that are none: grids in two and
/// three dimensions, random elements, a dense matrix, a tree.
[[nodiscard]] const std::vector<std::string>& chain_families();
[[nodiscard]] const std::vector<std::string>& other_families();
/// \param size  the least number of variables
[[nodiscard]] SeparableProgram make_program(const std::string& family,
                                            int size);

}  // namespace brachisto::benchmarks
