// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Matrices and vectors of a program at a point, as Matrix Market files.

#pragma once

#include <span>
#include <vector>

#include "brachisto/nlp/problem.hpp"
#include "program_files/text_stream.hpp"

namespace brachisto::program_files {

/// First and second derivatives at x and λ, in the program's order. Entries at
/// one place are added up; those that are zero there are kept, so that the
/// pattern is that of all points.
class ProgramMatrices {
 public:
  /// \throws std::runtime_error  if the program is not defined there
  ProgramMatrices(nlp::Problem& problem, const PrimalDual& point);

  void put_jacobian(TextStream& out) const;
  /// Of the Lagrangian f + λᵀg, lower triangle.
  void put_hessian(TextStream& out) const;
  /// The lower triangle of
  ///
  ///     H  Jᵀ
  ///     J  0
  ///
  /// with all variables and constraints, the fixed and the open ones too.
  void put_kkt(TextStream& out) const;

  [[nodiscard]] std::span<const double> gradient() const { return gradient_; }
  [[nodiscard]] std::span<const double> constraints() const {
    return constraints_;
  }

 private:
  struct Entry {
    int row, col;
    double value;
  };
  using Entries = std::vector<Entry>;
  [[nodiscard]] static Entries gathered(const nlp::SparsityPattern& pattern,
                                        const std::vector<double>& values);
  static void put_entries(const Entries& entries, int down, TextStream& out);

  int num_variables_, num_constraints_;
  std::vector<double> gradient_, constraints_;
  Entries jacobian_, hessian_;
};

void put_vector(std::span<const double> values, TextStream& out);

}  // namespace brachisto::program_files
