// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Which entries of a matrix belong to which link of a chain.

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "brachisto/nlp/problem.hpp"
#include "solvers/chain_map.hpp"

namespace brachisto {

/// The entries of one link after the other.
class EntriesByLink {
 public:
  /// An entry: the array and the place in it.
  struct Place {
    std::size_t array, entry;
  };
  enum class Order {
    AsTheyStand,  ///< every array lists them link by link
    Any           ///< they are sorted
  };

  EntriesByLink(const nlp::ChainStructure& chain,
                std::span<const EntryPositions> positions, Order order);

  /// The entries of the next link, by ascending place. False if one of them is
  /// of an earlier link, or couples unknowns that do not belong to one link.
  [[nodiscard]] bool next(int link, std::vector<Place>& places);

  /// Where the next link begins in an array.
  /// \pre Order::AsTheyStand
  [[nodiscard]] std::size_t position(std::size_t array) const {
    return next_[array];
  }
  /// Leaves out entries of an array, which are known to be the next link's but
  /// for some of the border alone, numbered from position() on.
  void skip(std::size_t array, std::size_t count,
            std::span<const std::size_t> of_border) {
    for (const std::size_t k : of_border) {
      border_.push_back({array, next_[array] + k});
    }
    next_[array] += count;
  }

  /// Those of the border alone that were met so far.
  [[nodiscard]] const std::vector<Place>& of_border() const { return border_; }

 private:
  void sort();
  /// First and last link that an entry may belong to; both negative if it
  /// belongs to none.
  struct Links {
    int first, last;
  };
  [[nodiscard]] Links links_of(std::size_t array, std::size_t entry) const;

  const nlp::ChainStructure* chain_;
  std::span<const EntryPositions> positions_;
  Order order_;
  std::vector<std::size_t> next_;    ///< by array, or of sorted_
  std::vector<Place> sorted_;        ///< by link
  std::vector<std::size_t> starts_;  ///< of the links in sorted_
  std::vector<Place> border_;
  bool is_chain_ = true;
};

}  // namespace brachisto
