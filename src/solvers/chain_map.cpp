// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "solvers/chain_map.hpp"

#include <algorithm>
#include <numeric>

namespace brachisto {

namespace {

using nlp::ChainStructure;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// Joins `group` links to one: separators within a group turn interior.
ChainStructure joined(const ChainStructure& fine, int group) {
  ChainStructure coarse = fine;
  coarse.num_links = (fine.num_links + group - 1) / group;
  for (int& block : coarse.block) {
    if (block < 0) continue;
    const int link = block / 2;
    const bool separator = block % 2 == 0;
    if (separator && link == fine.num_links) {
      block = 2 * coarse.num_links;
    } else {
      block = 2 * (link / group) + (separator && link % group == 0 ? 0 : 1);
    }
  }
  return coarse;
}

int links_to_join(const ChainStructure& structure, int join_to) {
  const auto inside =
      std::count_if(structure.block.begin(), structure.block.end(),
                    [](int block) { return block >= 0; });
  const auto per_link =
      std::max(1, static_cast<int>(inside / structure.num_links));
  return std::clamp(join_to / per_link, 1, structure.num_links);
}

/// The unknowns of every block, by ascending number.
struct Members {
  std::vector<int> start, unknown;
  std::vector<int> place;  ///< of every unknown within its block

  explicit Members(const ChainStructure& chain)
      : start(at(2 * chain.num_links) + 2, 0), place(chain.block.size(), 0) {
    for (const int block : chain.block) {
      if (block >= 0) ++start[at(block) + 1];
    }
    std::partial_sum(start.begin(), start.end(), start.begin());
    unknown.resize(at(start.back()));
    std::vector<int> next(start.begin(), start.end() - 1);
    for (std::size_t i = 0; i < chain.block.size(); ++i) {
      const int block = chain.block[i];
      if (block < 0) continue;
      place[i] = next[at(block)] - start[at(block)];
      unknown[at(next[at(block)]++)] = static_cast<int>(i);
    }
  }
  [[nodiscard]] int count(int block) const {
    return start[at(block) + 1] - start[at(block)];
  }
};

/// The link an entry belongs to: −1 for the border's own, −2 where the entry
/// is absent, −3 where the structure does not allow it.
int link_of(int block_a, int block_b, int num_links) {
  constexpr int kBorderEntry = -1;
  constexpr int kAbsentEntry = -2;
  constexpr int kNoChain = -3;
  if (block_a == ChainStructure::kAbsent ||
      block_b == ChainStructure::kAbsent) {
    return kAbsentEntry;
  }
  const int low = std::min(block_a, block_b);
  const int high = std::max(block_a, block_b);
  if (high < 0) return kBorderEntry;
  // Of one block alone: its own interior, or as the right separator.
  if (low < 0 || low == high) {
    return high % 2 != 0 ? high / 2 : std::max(0, high / 2 - 1);
  }
  const int link = low / 2;
  const bool neighbours = high <= 2 * link + 2 && link < num_links;
  return neighbours ? link : kNoChain;
}

}  // namespace

std::optional<ChainMap> ChainMap::make(
    const ChainStructure& structure, std::span<const EntryPositions> positions,
    int join_to) {
  const ChainStructure chain =
      joined(structure, links_to_join(structure, join_to));
  const Members members(chain);
  ChainMap map;
  map.num_links_ = chain.num_links;
  std::vector<int> place = members.place;
  for (std::size_t i = 0; i < chain.block.size(); ++i) {
    if (chain.block[i] != ChainStructure::kAbsent) ++map.num_unknowns_;
    if (chain.block[i] != ChainStructure::kBorder) continue;
    place[i] = static_cast<int>(map.border_.size());
    map.border_.push_back(static_cast<int>(i));
  }

  // Entries sorted by link, in their order within a link. Numbers of entries
  // run through all arrays.
  std::vector<std::size_t> first_of_array;
  std::size_t num_entries = 0;
  for (const EntryPositions& array : positions) {
    first_of_array.push_back(num_entries);
    num_entries += array.rows.size();
  }
  const auto row_of = [&](std::size_t array, std::size_t e) {
    return at(positions[array].rows[e] + positions[array].row_offset);
  };
  std::vector<std::size_t> starts(at(chain.num_links) + 1, 0);
  for (std::size_t a = 0; a < positions.size(); ++a) {
    for (std::size_t e = 0; e < positions[a].rows.size(); ++e) {
      const int row_block = chain.block[row_of(a, e)];
      const int col_block = chain.block[at(positions[a].cols[e])];
      const int link = link_of(row_block, col_block, chain.num_links);
      if (link < -2) return std::nullopt;
      if (link >= 0) ++starts[at(link) + 1];
      if (link != -1) continue;
      Entry entry;
      entry.row = place[row_of(a, e)];
      entry.col = place[at(positions[a].cols[e])];
      entry.array = static_cast<int>(a);
      entry.source = {static_cast<std::ptrdiff_t>(e), 0};
      map.border_entries_.push_back(entry);
    }
  }
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  std::vector<unsigned> order(starts.back());
  {
    std::vector<std::size_t> next(starts.begin(), starts.end() - 1);
    for (std::size_t a = 0; a < positions.size(); ++a) {
      for (std::size_t e = 0; e < positions[a].rows.size(); ++e) {
        const int row_block = chain.block[row_of(a, e)];
        const int col_block = chain.block[at(positions[a].cols[e])];
        const int link = link_of(row_block, col_block, chain.num_links);
        if (link < 0) continue;
        order[next[at(link)]++] = static_cast<unsigned>(first_of_array[a] + e);
      }
    }
  }

  Run now;
  for (int link = 0; link < chain.num_links; ++link) {
    now.first_link = link;
    now.num_links = 1;
    now.interior = members.count(2 * link + 1);
    now.left = members.count(2 * link);
    now.right = members.count(2 * link + 2);
    now.unknowns.clear();
    for (const int block : {2 * link + 1, 2 * link, 2 * link + 2}) {
      for (int i = 0; i < members.count(block); ++i) {
        const int unknown = members.unknown[at(members.start[at(block)] + i)];
        now.unknowns.push_back({unknown, 0});
      }
    }
    for (const int unknown : map.border_) now.unknowns.push_back({unknown, 0});

    const auto local = [&](std::size_t unknown) {
      const int block = chain.block[unknown];
      int offset = 0;
      if (block != 2 * link + 1) offset += now.interior;
      if (block == 2 * link + 2 || block < 0) offset += now.left;
      if (block < 0) offset += now.right;
      return offset + place[unknown];
    };
    now.entries.clear();
    for (std::size_t k = starts[at(link)]; k < starts[at(link) + 1]; ++k) {
      const std::size_t number = order[k];
      const std::size_t a = static_cast<std::size_t>(
                                std::upper_bound(first_of_array.begin(),
                                                 first_of_array.end(), number) -
                                first_of_array.begin()) -
                            1;
      const std::size_t e = number - first_of_array[a];
      const int i = local(row_of(a, e));
      const int j = local(at(positions[a].cols[e]));
      now.entries.push_back({std::max(i, j),
                             std::min(i, j),
                             static_cast<int>(a),
                             {static_cast<std::ptrdiff_t>(e), 0}});
    }

    // Does it continue the run? The second link of a run sets the strides.
    const auto continues = [&](Run& run) {
      if (run.interior != now.interior || run.left != now.left ||
          run.right != now.right ||
          run.unknowns.size() != now.unknowns.size() ||
          run.entries.size() != now.entries.size()) {
        return false;
      }
      const int i = run.num_links;
      const auto fits = [&](const Affine& old, const Affine& here) {
        return i == 1 || old.at(i) == static_cast<std::size_t>(here.first);
      };
      for (std::size_t k = 0; k < now.unknowns.size(); ++k) {
        if (!fits(run.unknowns[k], now.unknowns[k])) return false;
      }
      for (std::size_t k = 0; k < now.entries.size(); ++k) {
        const Entry& old = run.entries[k];
        const Entry& here = now.entries[k];
        if (old.row != here.row || old.col != here.col ||
            old.array != here.array || !fits(old.source, here.source)) {
          return false;
        }
      }
      if (i > 1) return true;
      for (std::size_t k = 0; k < now.unknowns.size(); ++k) {
        run.unknowns[k].stride = now.unknowns[k].first - run.unknowns[k].first;
      }
      for (std::size_t k = 0; k < now.entries.size(); ++k) {
        run.entries[k].source.stride =
            now.entries[k].source.first - run.entries[k].source.first;
      }
      return true;
    };
    if (!map.runs_.empty() && continues(map.runs_.back())) {
      ++map.runs_.back().num_links;
    } else {
      map.runs_.push_back(now);
    }
  }
  return map;
}

}  // namespace brachisto
