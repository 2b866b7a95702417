// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Statements of the paper, and whether they are borne out.

#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "math/enum_table.hpp"
#include "reproduction/printed_numbers.hpp"

namespace brachisto::reproduction {

enum class Verdict { Holds, HoldsInPart, Fails };

[[nodiscard]] inline const char* name(Verdict verdict) {
  constexpr auto kNames =
      table_by<Verdict>("holds", "holds in part", "does not hold");
  return kNames[verdict];
}

/// A statement of the paper in words, and what is found.
struct Claim {
  std::string place;
  std::string statement;
  Verdict verdict = Verdict::Holds;
  std::string evidence;
};

/// All of them in the order of the paper.
[[nodiscard]] std::vector<Claim> judge(const Results& found);

/// Those on how tracks and times depend on the body and on L, sections III.B to
/// III.G.
[[nodiscard]] std::vector<Claim> claims_of_shapes(const Results& found);
/// Those on θ_m, and on what is faster than the bead, section III.H.
[[nodiscard]] std::vector<Claim> claims_of_orientation(const Results& found);

/// The greatest less the least of numbers.
template <class Number = std::identity>
[[nodiscard]] double spread(const auto& items, Number number = {}) {
  const auto [least, most] = std::ranges::minmax_element(items, {}, number);
  return std::invoke(number, *most) - std::invoke(number, *least);
}

/// By how many percent the second is less than the first.
[[nodiscard]] inline double percent_less(double first, double second) {
  return 100.0 * (first - second) / first;
}

}  // namespace brachisto::reproduction
