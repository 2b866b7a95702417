// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Where the entries and the unknowns of each link of a chain lie in the arrays
// of the caller.

#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "brachisto/nlp/problem.hpp"

namespace brachisto {

class ChainBlocks;
class EntriesByLink;

/// Positions of part of the entries of a symmetric matrix, either triangle,
/// each pair of unknowns from one side only. Repeated positions add up.
struct EntryPositions {
  const nlp::SparsityPattern& pattern;
  int row_offset = 0;  ///< added to each row
};

/// The links of a chain in runs of those that look alike: the same entries at
/// the same places of the link, with unknowns and values at places of the
/// caller's arrays that advance by a constant from link to link of the chain,
/// perhaps with links of other runs between them. A link at the end of the
/// chain is part of a run if it is such a link but for unknowns that are
/// absent. A uniform problem thus has one run, and needs memory for one link;
/// the worst case, a run for each link, is linear in the number of entries.
class ChainMap {
 public:
  /// The place first + stride i for link i of a run.
  struct Affine {
    std::ptrdiff_t first = 0;
    std::ptrdiff_t stride = 0;
    bool not_in_first = false, not_in_last = false;  ///< links of the run
    [[nodiscard]] std::size_t at(int i) const {
      return static_cast<std::size_t>(first + stride * i);
    }
  };
  /// Links from `begin` to before `end`.
  struct Links {
    int begin, end;
  };
  /// An entry by local unknowns, row ≥ col, and the place of its value.
  struct Entry {
    int row = 0;
    int col = 0;
    int array = 0;  ///< which EntryPositions
    Affine source;
  };
  /// Local unknowns are numbered: interior, left separator, right separator,
  /// border. A separator's own entries belong to one of the links beside it.
  struct Run {
    int position = 0;   ///< in the chain, of its link 0
    int num_links = 0;  ///< to the last one, as if all between were its own
    std::vector<Links> stretches = {};  ///< those that are
    int interior = 0, left = 0, right = 0;
    std::vector<Affine> unknowns = {};  ///< places in vectors of the caller
    std::vector<Entry> entries;
    [[nodiscard]] int size() const { return static_cast<int>(unknowns.size()); }
    /// The numbers of its own links.
    [[nodiscard]] std::vector<int> links() const;
    /// Those of some links that have an unknown or an entry.
    [[nodiscard]] Links having(const Affine& what, Links among) const {
      return {
          what.not_in_first ? std::max(among.begin, 1) : among.begin,
          what.not_in_last ? std::min(among.end, num_links - 1) : among.end};
    }
    [[nodiscard]] bool has(const Affine& what, int link) const {
      return !(what.not_in_first && link == 0) &&
             !(what.not_in_last && link == num_links - 1);
    }
  };

  /// An entry of one unknown that is absent.
  struct Coupling {
    int unknown, absent;
    int array, entry;  ///< where its value is
  };

  /// Nothing if an entry couples unknowns that do not belong to one link. The
  /// time is linear in the number of unknowns and that of the entries that the
  /// patterns store one by one.
  ///
  /// Links are joined until their interiors have about `join_to` unknowns.
  [[nodiscard]] static std::optional<ChainMap> make(
      nlp::ChainStructure structure, std::span<const EntryPositions> positions,
      int join_to);

  [[nodiscard]] int num_links() const { return num_links_; }
  [[nodiscard]] int num_unknowns() const { return num_unknowns_; }
  [[nodiscard]] const std::vector<Run>& runs() const { return runs_; }
  /// The stretches of all runs along the chain.
  struct Stretch {
    std::size_t run;
    Links links;
  };
  [[nodiscard]] std::vector<Stretch> along_chain() const;
  /// Unknowns of the border, and its own entries by number in the border.
  [[nodiscard]] const std::vector<int>& border() const { return border_; }
  [[nodiscard]] const std::vector<Entry>& border_entries() const {
    return border_entries_;
  }
  /// With the unknowns that are absent: by ascending `unknown`, then in the
  /// order of the arrays.
  [[nodiscard]] const std::vector<Coupling>& couplings() const {
    return couplings_;
  }

 private:
  /// False if the entries are in another order, or the matrix is no such chain.
  [[nodiscard]] bool read(const ChainBlocks& blocks,
                          std::span<const EntryPositions> positions,
                          EntriesByLink& by_link, bool in_order);
  void unite_runs();

  int num_links_ = 0;
  int num_unknowns_ = 0;  ///< without absent ones
  std::vector<Run> runs_;
  std::vector<int> border_;
  std::vector<Entry> border_entries_;
  std::vector<Coupling> couplings_;
};

}  // namespace brachisto
