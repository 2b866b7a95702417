// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Derivatives of formulas that are smooth in a number.

#pragma once

#include <cmath>

namespace brachisto::math {

/// f'(0) to order six: with D(h) = (f(h) − f(−h))/2h
///
///     f'(0) = 3/2 D(h) − 3/5 D(2h) + 1/10 D(3h) − h⁶ f⁽⁷⁾/140.
///
/// Calls add(step, share) for each of the three steps. Rounding ε of f leaves
/// up to 11/6 ε/h.
template <class Add>
void central_difference(double h, Add&& add) {
  add(h, 3.0 / 2.0);
  add(2.0 * h, -3.0 / 5.0);
  add(3.0 * h, 1.0 / 10.0);
}

/// The same place by place: calls add(place, weight), f'(0) = Σ weight
/// f(place).
template <class Add>
void central_difference_by_place(double h, Add&& add) {
  central_difference(h, [&](double step, double share) {
    for (const double place : {-step, step}) {
      add(place, share / (2.0 * place));
    }
  });
}

/// A weight of central_difference_by_place() less that of order four,
/// f'(0) = 4/3 D(h) − 1/3 D(2h) + h⁴ f⁽⁵⁾/30: Σ of it times f(place) tells how
/// much orders above four matter.
[[nodiscard]] inline double less_order_four(double h, double place,
                                            double weight) {
  const double step = std::abs(place);
  const double share = step < 1.5 * h   ? 4.0 / 3.0
                       : step < 2.5 * h ? -1.0 / 3.0
                                        : 0.0;
  return weight - share / (2.0 * place);
}

}  // namespace brachisto::math
