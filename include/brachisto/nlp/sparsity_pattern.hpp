// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Where a sparse matrix has entries.

#pragma once

#include <cstddef>
#include <initializer_list>
#include <vector>

namespace brachisto::nlp {

/// Positions of the entries of a sparse matrix, 0-based, fixed for life. The
/// value arrays of a matrix follow the same order. A position may occur more
/// than once; its values then add up, as Ipopt and MUMPS have it.
///
/// Positions are stored one by one as they are added; what a mesh repeats from
/// element to element need not be, see repeat().
class SparsityPattern {
 public:
  struct Position {
    int row = 0, col = 0;
    friend bool operator==(const Position&, const Position&) = default;
  };
  /// Entries from `begin` to before end(): `length` of them, then the same
  /// with every row and column farther on by a constant of its own, and so on.
  struct Repetition {
    std::size_t begin = 0;   ///< the first entry
    std::size_t length = 0;  ///< how many there are each time
    std::size_t times = 0;   ///< all times, the first one too
    std::size_t stored = 0;  ///< place of the first one in memory
    [[nodiscard]] std::size_t end() const { return begin + length * times; }
    friend bool operator==(const Repetition&, const Repetition&) = default;
  };

  SparsityPattern() = default;
  SparsityPattern(std::initializer_list<Position> entries) : stored_(entries) {}

  void add(int row, int col) { stored_.push_back({row, col}); }
  /// Room for so many entries that are added one by one.
  void reserve(std::size_t entries) { stored_.reserve(entries); }
  /// The last `length` entries, each as far from the one `length` before it as
  /// its row and its column say, go on like that `times` more often. Memory and
  /// time are those of `length` entries.
  ///
  /// \throws std::invalid_argument  unless the last 2 `length` entries were
  ///                                added one by one
  void repeat(std::size_t length, std::size_t times);

  [[nodiscard]] std::size_t num_entries() const {
    return stored_.size() + not_stored_;
  }
  /// Position of one entry. Quick, but for_each() is quicker.
  [[nodiscard]] Position operator[](std::size_t entry) const;
  /// The repetition in which an entry is; null if it is in none.
  [[nodiscard]] const Repetition* repetition_of(std::size_t entry) const;

  /// Calls visit(entry, row, col) for all entries in their order.
  template <class Visit>
  void for_each(Visit&& visit) const;

  /// Stored alike.
  friend bool operator==(const SparsityPattern&,
                         const SparsityPattern&) = default;

 private:
  /// The last repetition that begins at or before an entry.
  [[nodiscard]] const Repetition* last_begun(std::size_t entry) const;

  /// Entries in their order; of a repetition those of the first time, then by
  /// how much each advances.
  std::vector<Position> stored_;
  std::vector<Repetition> repetitions_;
  std::size_t not_stored_ = 0;
};

template <class Visit>
void SparsityPattern::for_each(Visit&& visit) const {
  std::size_t entry = 0;
  const Position* next = stored_.data();
  const auto visit_until = [&](std::size_t end) {
    for (; entry < end; ++entry, ++next) visit(entry, next->row, next->col);
  };
  for (const Repetition& repetition : repetitions_) {
    visit_until(repetition.begin);
    const Position* const stride = next + repetition.length;
    std::vector<Position> now(next, stride);
    for (std::size_t i = 0; i < repetition.times; ++i) {
      for (std::size_t k = 0; k < now.size(); ++k, ++entry) {
        visit(entry, now[k].row, now[k].col);
      }
      for (std::size_t k = 0; k < now.size(); ++k) {
        now[k].row += stride[k].row;
        now[k].col += stride[k].col;
      }
    }
    next += 2 * repetition.length;
  }
  visit_until(num_entries());
}

}  // namespace brachisto::nlp
