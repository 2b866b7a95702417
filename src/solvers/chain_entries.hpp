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

/// The entries of each link. Where every array lists them link by link, as a
/// transcription does, they are ranges of these arrays; else they are sorted.
class EntriesByLink {
 public:
  /// An entry: the array and the place in it.
  struct Place {
    std::size_t array, entry;
  };

  /// Nothing if an entry couples unknowns that do not belong to one link.
  [[nodiscard]] static std::optional<EntriesByLink> make(
      const nlp::ChainStructure& chain,
      std::span<const EntryPositions> positions);

  /// Whether the entries of a link are range(array, link) in every array.
  [[nodiscard]] bool in_order() const { return sorted_.empty(); }

  struct Range {
    std::size_t begin, end;
  };
  /// Entries of absent unknowns and of the border alone may lie between.
  /// \pre in_order()
  [[nodiscard]] Range range(std::size_t array, int link) const {
    const auto i = static_cast<std::size_t>(link);
    return {starts_[array][i], starts_[array][i + 1]};
  }

  /// The entries of a link, by ascending place.
  void collect(int link, std::vector<Place>& places) const;

  /// Those of the border alone.
  [[nodiscard]] const std::vector<Place>& of_border() const { return border_; }

 private:
  EntriesByLink(const nlp::ChainStructure& chain,
                std::span<const EntryPositions> positions)
      : chain_(&chain), positions_(positions) {}
  bool find_ranges();
  bool sort();
  /// First and last link that an entry may belong to; both negative if it
  /// belongs to none.
  struct Links {
    int first, last;
  };
  [[nodiscard]] Links links_of(std::size_t array, std::size_t entry) const;

  const nlp::ChainStructure* chain_;
  std::span<const EntryPositions> positions_;
  std::vector<std::vector<std::size_t>> starts_;  ///< by array and link
  std::vector<Place> sorted_;                     ///< by link; starts_[0]
  std::vector<Place> border_;
};

}  // namespace brachisto
