// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/ruler.hpp"

#include <algorithm>

namespace brachisto::io {

Ruler::Ruler(std::string_view text, int source) : text_(text), source_(source) {
  lines_.push_back({0, 0});
  int characters = 0;
  for (std::size_t i = 0; i < text_.size(); ++i) {
    if (begins_character(i)) ++characters;
    if (text_[i] == '\n') lines_.push_back({i + 1, characters});
  }
}

Position Ruler::position(std::size_t offset) {
  offset = std::min(offset, text_.size());
  for (; offset_ < offset; ++offset_) {
    if (begins_character(offset_)) ++characters_;
  }
  for (; offset_ > offset; --offset_) {
    if (begins_character(offset_ - 1)) --characters_;
  }
  const auto next = std::ranges::upper_bound(lines_, offset, {}, &Line::offset);
  const auto number = static_cast<int>(next - lines_.begin());
  return {source_, number, characters_ - std::prev(next)->characters + 1};
}

}  // namespace brachisto::io
