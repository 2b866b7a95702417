// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A scalar equation around a nonlinear program.

#pragma once

#include <span>
#include <vector>

#include "brachisto/math/index.hpp"

namespace brachisto::nlp {

/// Nonzeros of a row or column; positions are fixed for life.
struct SparseVector {
  std::vector<int> index;
  std::vector<double> value;
};

/// One parameter φ on which the values of a problem's fixed variables depend,
/// and the equation F(x, λ, φ) = 0 that determines it. The smooth contact at B
/// is one: φ moves the end of the path, and the end slope has to be φ.
class TangencyCondition {
 public:
  /// F and its derivatives.
  struct Linearisation {
    double residual = 0.0;
    SparseVector by_x, by_lambda;
    double by_parameter = 0.0;

    /// F_x u + F_λ v of the vector (u, v) with `num_variables` components of u.
    [[nodiscard]] long double times(std::span<const double> y,
                                    int num_variables) const {
      long double sum = 0.0L;
      const auto add = [&](const SparseVector& part, int offset) {
        for (std::size_t i = 0; i < part.index.size(); ++i) {
          sum += static_cast<long double>(part.value[i]) *
                 y[at(offset + part.index[i])];
        }
      };
      add(by_x, 0);
      add(by_lambda, num_variables);
      return sum;
    }
  };

  virtual ~TangencyCondition() = default;

  /// Gives the problem's fixed variables their values at φ.
  virtual void set_parameter(double phi) = 0;
  /// d(value)/dφ of the fixed variables that move, at the last set_parameter().
  [[nodiscard]] const SparseVector& fixed_rates() const { return fixed_rates_; }
  /// F at (x, λ) and the last set_parameter(). The reference stays valid until
  /// the next call.
  [[nodiscard]] virtual const Linearisation& linearise(
      std::span<const double> x, std::span<const double> lambda) = 0;

 protected:
  TangencyCondition() = default;
  TangencyCondition(const TangencyCondition&) = default;
  TangencyCondition& operator=(const TangencyCondition&) = default;

  SparseVector fixed_rates_;
  Linearisation at_;  ///< what linearise() refers to
};

}  // namespace brachisto::nlp
