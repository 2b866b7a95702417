// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/transcription/arc_length_layout.hpp"

#include <fmt/format.h>

#include <array>

namespace brachisto {

std::string ArcLengthLayout::variable_name(int index) const {
  constexpr std::array kNames{"x", "z", "theta"};
  if (index == arc_length()) return "S";
  const int per_node = variables_per_node();
  return fmt::format("{}[{}]",
                     kNames[static_cast<std::size_t>(index % per_node)],
                     index / per_node + 1);
}

std::string ArcLengthLayout::constraint_name(int index) const {
  const int per_node = constraints_per_node();
  return fmt::format("{}[{}]", index % per_node == 0 ? "no slip" : "place",
                     index / per_node + 1);
}

}  // namespace brachisto
