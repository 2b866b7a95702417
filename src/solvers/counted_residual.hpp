// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Book-keeping that solvers of square systems share.

#pragma once

#include <cmath>

#include "brachisto/solvers/square_system.hpp"

namespace brachisto {

/// A residual that counts its evaluations and remembers the best point.
class CountedResidual {
 public:
  /// \param result  keeps counts and the best point; outlives this
  CountedResidual(const SquareResidual& residual, std::vector<double> start,
                  SquareResult& result);

  /// The norm of F(x); NaN if F is not defined there.
  double operator()(std::span<const double> x, std::span<double> residual);

 private:
  const SquareResidual& residual_;
  SquareResult& result_;
};

/// The status of an iteration that ended for a reason of its own: by the best
/// residual, then by what stopped it.
void conclude(const SquareOptions& options, std::string reason,
              SquareResult& result);

}  // namespace brachisto
