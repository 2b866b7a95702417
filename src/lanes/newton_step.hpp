// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Small systems of linear equations, one in each lane.

#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "lanes/lane.hpp"

namespace brachisto::lanes {

/// Newton's step of each, by elimination with pivots of its own, and the sign
/// of the determinant.
template <class Number, std::size_t Size>
struct NewtonStep {
  std::array<Number, Size> step;
  Number sign;
};
template <class Number, std::size_t Size>
[[nodiscard]] NewtonStep<Number, Size> newton_step(
    const std::array<std::array<Number, Size>, Size>& jacobian,
    const std::array<Number, Size>& residual) {
  NewtonStep<Number, Size> out;
  for (std::size_t lane = 0; lane < Number::kCount; ++lane) {
    double rows[Size][Size + 1];
    for (std::size_t i = 0; i < Size; ++i) {
      for (std::size_t j = 0; j < Size; ++j) {
        rows[i][j] = jacobian[i][j][lane];
      }
      rows[i][Size] = -residual[i][lane];
    }
    double sign = 1.0;
    for (std::size_t j = 0; j < Size; ++j) {
      std::size_t pivot = j;
      for (std::size_t i = j + 1; i < Size; ++i) {
        if (std::abs(rows[i][j]) > std::abs(rows[pivot][j])) pivot = i;
      }
      if (pivot != j) sign = -sign;
      for (std::size_t k = 0; k <= Size; ++k) {
        const double kept = rows[j][k];
        rows[j][k] = rows[pivot][k];
        rows[pivot][k] = kept;
      }
      if (rows[j][j] < 0.0) sign = -sign;
      for (std::size_t i = j + 1; i < Size; ++i) {
        const double factor = rows[i][j] / rows[j][j];
        for (std::size_t k = j; k <= Size; ++k) {
          rows[i][k] -= factor * rows[j][k];
        }
      }
    }
    for (std::size_t back = Size; back-- > 0;) {
      double sum = rows[back][Size];
      for (std::size_t k = back + 1; k < Size; ++k) {
        sum -= rows[back][k] * out.step[k][lane];
      }
      out.step[back].set(lane, sum / rows[back][back]);
    }
    out.sign.set(lane, sign);
  }
  return out;
}

}  // namespace brachisto::lanes
