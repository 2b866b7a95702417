// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "transcription/held_control.hpp"

#include <algorithm>

#include "brachisto/math/index.hpp"

namespace brachisto {

using nlp::Held;

bool is_free(const std::vector<Held>& held) {
  return std::all_of(held.begin(), held.end(),
                     [](Held h) { return h == Held::No; });
}

int held_of_control(const std::vector<Held>& held,
                    const std::vector<PathInequality>& limits) {
  for (std::size_t i = 0; i < held.size(); ++i) {
    if (held[i] != Held::No && limits[i].bounds_control()) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

bool holds_from_above(const LimitedTime& problem, int limit, Held where,
                      TurningPoint<double> place) {
  const auto value = [&](double q) {
    place.q = q;
    return value_of(problem.limits()[at(limit)], problem.scene(), place);
  };
  const bool grows = value(1.0) > value(0.0);
  return grows == (where == Held::AtUpper);
}

bool opposite(const LimitedTime& problem, const std::vector<Held>& one,
              const std::vector<Held>& other,
              const TurningPoint<double>& place) {
  const int l = held_of_control(one, problem.limits());
  const int r = held_of_control(other, problem.limits());
  return l >= 0 && r >= 0 &&
         holds_from_above(problem, l, one[at(l)], place) !=
             holds_from_above(problem, r, other[at(r)], place);
}

}  // namespace brachisto
