// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Newton's step of the discrete system with exact derivatives (ε → 0), by two
/// ways of linear algebra.

#pragma once

#include <memory>
#include <span>

#include "paper/discrete_variations.hpp"
#include "solvers/sparse_lu.hpp"

namespace brachisto::paper {

/// The system as it stands: a dense matrix of 2n + 1 columns, for θ_j depends
/// on every node before it. Each column is one sweep along the path with the
/// derivatives of its chords; LU with partial pivoting. O(n³).
class DenseNewtonStep {
 public:
  explicit DenseNewtonStep(const DiscreteVariations& system)
      : system_(system) {}

  /// Solves F' step = −F; false if F' is not finite or singular.
  [[nodiscard]] bool operator()(std::span<const double> unknowns,
                                std::span<const double> residual,
                                std::span<double> step) const;

  /// Bytes of the matrix and of its factors.
  [[nodiscard]] static double memory_bytes(int num_nodes);

 private:
  const DiscreteVariations& system_;
};

/// The lifted system: θ_j and their multipliers λ_j are unknowns too, 4n − 1 in
/// all, and each row has the few entries of its own chords, S and z_1. Sparse
/// LU, O(n). θ and λ follow the path exactly, which makes the residuals of
/// their rows zero and the step in x, z and S that of DenseNewtonStep.
class LiftedNewtonStep {
 public:
  explicit LiftedNewtonStep(const DiscreteVariations& system);
  ~LiftedNewtonStep();

  /// Solves F' step = −F; false if F' is not finite or singular.
  [[nodiscard]] bool operator()(std::span<const double> unknowns,
                                std::span<const double> residual,
                                std::span<double> step);

  /// 4n − 1.
  [[nodiscard]] static int num_unknowns(int num_nodes);
  /// Bytes of pattern, values and factors of the last step.
  [[nodiscard]] double memory_bytes() const;

 private:
  const DiscreteVariations& system_;
  std::unique_ptr<SparseLu> lu_;
  std::size_t num_entries_ = 0;
};

}  // namespace brachisto::paper
