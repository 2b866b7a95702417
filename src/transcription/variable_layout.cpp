// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "transcription/variable_layout.hpp"

#include <fmt/format.h>

namespace brachisto {

const char* VariableLayout::state_name(int offset) const {
  if (offset == 0) return "x";
  if (offset == 1) return "z";
  return has_slopes() && offset == num_states_ - 1 ? "w" : "theta";
}

std::string VariableLayout::variable_name(int index) const {
  if (index == last()) return has_slopes() ? "U" : "S";
  return fmt::format("{}[{}]",
                     is_state(index) ? state_name(index % stride()) : "beta",
                     node_of(index));
}

std::string VariableLayout::constraint_name(int index) const {
  const int row = index % num_rows_;
  const int point = point_of(index);
  if (has_slopes()) {
    return fmt::format("defect of {}[{}]", state_name(row), point);
  }
  return fmt::format("{}[{}]", row == 0 ? "no slip" : "place", point + 1);
}

}  // namespace brachisto
