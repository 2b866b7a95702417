// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/transcription/variable_layout.hpp"

#include <fmt/format.h>

namespace brachisto {

namespace {

const char* component_name(int offset, int num_states) {
  if (offset == 0) return "x";
  if (offset == 1) return "z";
  return offset == num_states - 1 ? "w" : "theta";
}

}  // namespace

std::string VariableLayout::variable_name(int index) const {
  if (index == rolling_time()) return "U";
  const int offset = index % stride();
  const int group = index / stride();
  if (offset == num_states_) return fmt::format("beta[{}]", group);
  return fmt::format("{}[{}]", component_name(offset, num_states_), group);
}

std::string VariableLayout::constraint_name(int index) const {
  return fmt::format("defect of {}[{}]",
                     component_name(index % num_states_, num_states_),
                     index / num_states_);
}

}  // namespace brachisto
