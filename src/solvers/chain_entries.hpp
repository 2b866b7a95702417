// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Which entries of a matrix belong to which link of a chain.

#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "brachisto/nlp/problem.hpp"
#include "solvers/chain_map.hpp"

namespace brachisto {

/// The entries of one link after the other.
class EntriesByLink {
 public:
  /// An entry: the array, the place in it, and its position in the matrix.
  struct Place {
    std::size_t array, entry;
    int row, col;
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

  /// Entries of an array that the last next() went through, listed or not, and
  /// where it ended.
  /// \pre Order::AsTheyStand
  [[nodiscard]] std::size_t taken(std::size_t array) const {
    return taken_[array];
  }
  [[nodiscard]] std::size_t position(std::size_t array) const {
    return next_[array];
  }
  /// How many of these were of an absent unknown.
  [[nodiscard]] std::size_t num_absent() const { return absent_.size(); }
  /// Leaves out as many, which are known to be the next link's but for those
  /// that are where the last link had one of an absent unknown. False, and
  /// nothing is left out, if the unknown of one of these is not absent.
  [[nodiscard]] bool skip_as_many();

  /// Those of the border alone that were met so far.
  [[nodiscard]] const std::vector<Place>& of_border() const { return border_; }
  /// Those of one absent unknown that were met, array by array.
  [[nodiscard]] std::vector<ChainMap::Coupling> couplings() const;

 private:
  void sort();
  [[nodiscard]] Place place(std::size_t array, std::size_t entry) const;
  /// First and last link that an entry may belong to; both negative if it
  /// belongs to none.
  struct Links {
    int first, last;
  };
  [[nodiscard]] Links links_of(const Place& place) const;
  void note_coupling(const Place& place);
  /// Where an entry of any order is.
  struct Sorted {
    unsigned array, entry;
  };

  const nlp::ChainStructure* chain_;
  std::span<const EntryPositions> positions_;
  Order order_;
  std::vector<std::size_t> next_, taken_;  ///< by array
  std::vector<Sorted> sorted_;             ///< by link
  std::vector<std::size_t> starts_;        ///< of the links in sorted_
  std::vector<Place> border_;
  std::vector<Place> absent_;  ///< of absent unknowns, in the last link
  std::vector<std::vector<ChainMap::Coupling>> couplings_;  ///< by array
  bool is_chain_ = true;
};

}  // namespace brachisto
