// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/nlp/problem.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>

namespace brachisto::nlp {

void SparsityPattern::repeat(std::size_t length, std::size_t times) {
  std::size_t of_repetitions = 0;
  if (!repetitions_.empty()) {
    const Repetition& last = repetitions_.back();
    of_repetitions = last.stored + 2 * last.length;
  }
  if (stored_.size() - of_repetitions < 2 * length) {
    throw std::invalid_argument(
        "SparsityPattern::repeat: too few entries to repeat");
  }
  if (length == 0 || times == 0) return;
  const std::size_t stored = stored_.size() - 2 * length;
  for (std::size_t k = stored; k < stored + length; ++k) {
    stored_[k + length].row -= stored_[k].row;
    stored_[k + length].col -= stored_[k].col;
  }
  repetitions_.push_back(
      {num_entries() - 2 * length, length, times + 2, stored});
  not_stored_ += length * times;
}

const SparsityPattern::Repetition* SparsityPattern::last_begun(
    std::size_t entry) const {
  const auto after =
      std::ranges::upper_bound(repetitions_, entry, {}, &Repetition::begin);
  return after == repetitions_.begin() ? nullptr : &*std::prev(after);
}

const SparsityPattern::Repetition* SparsityPattern::repetition_of(
    std::size_t entry) const {
  const Repetition* const last = last_begun(entry);
  return last != nullptr && entry < last->end() ? last : nullptr;
}

SparsityPattern::Position SparsityPattern::operator[](std::size_t entry) const {
  const Repetition* const last = last_begun(entry);
  if (last == nullptr) return stored_[entry];
  if (entry >= last->end()) {
    return stored_[last->stored + 2 * last->length + (entry - last->end())];
  }
  const std::size_t from_begin = entry - last->begin;
  const auto i = static_cast<int>(from_begin / last->length);
  const std::size_t k = last->stored + from_begin % last->length;
  const Position& stride = stored_[k + last->length];
  return {stored_[k].row + i * stride.row, stored_[k].col + i * stride.col};
}

}  // namespace brachisto::nlp
