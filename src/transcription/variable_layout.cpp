// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "transcription/variable_layout.hpp"

#include <fmt/format.h>

#include <array>

namespace brachisto {

const char* VariableLayout::state_name(int offset) const {
  if (offset == 0) return "x";
  if (offset == 1) return "z";
  if (offset == 2 && has_theta()) return "theta";
  return offset == (has_theta() ? 3 : 2) ? "w" : "beta";
}

std::string VariableLayout::variable_name(int index) const {
  if (index == last()) return has_controls() ? "U" : "S";
  return fmt::format("{}[{}]",
                     is_state(index)    ? state_name(index % stride())
                     : slope_is_state() ? "h q"
                                        : "beta",
                     node_of(index));
}

std::string VariableLayout::constraint_name(int index) const {
  const int row = index % num_rows();
  const int point = point_of(index);
  if (index >= start_row(0)) {
    return fmt::format("limit {} at rest", index - start_row(0));
  }
  if (point >= num_points()) {
    constexpr std::array kNames{"x at A", "z at A", "x at B", "z at B",
                                "w at A"};
    return kNames.at(static_cast<std::size_t>(index - contact_row(0)));
  }
  if (slope_is_state() && row >= num_states()) {
    return fmt::format("limit {}[{}]", row - num_states(), point);
  }
  if (has_controls()) {
    return fmt::format("defect of {}[{}]", state_name(row), point);
  }
  return fmt::format("{}[{}]", row == 0 ? "no slip" : "place", point + 1);
}

}  // namespace brachisto
