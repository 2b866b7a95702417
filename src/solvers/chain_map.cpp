// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "solvers/chain_map.hpp"

#include <algorithm>
#include <numeric>

#include "brachisto/math/stop_condition.hpp"
#include "math/index.hpp"
#include "solvers/chain_entries.hpp"

namespace brachisto {

namespace {

using nlp::ChainStructure;

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

  const std::optional<EntriesByLink> by_link =
      EntriesByLink::make(chain, positions);
  if (!by_link) return std::nullopt;
  const auto row_of = [&](std::size_t array, std::size_t e) {
    return at(positions[array].rows[e] + positions[array].row_offset);
  };
  for (const auto& [a, e] : by_link->of_border()) {
    map.border_entries_.push_back({place[row_of(a, e)],
                                   place[at(positions[a].cols[e])],
                                   static_cast<int>(a),
                                   {static_cast<std::ptrdiff_t>(e), 0}});
  }

  const auto fits = [](const Run& run, const Affine& old, const Affine& here) {
    return run.num_links == 1 ||
           old.at(run.num_links) == static_cast<std::size_t>(here.first);
  };
  // Whether the entries of `link` lie where those of the run would go on to,
  // all of an array by the same stride, so that none is met twice.
  std::vector<std::size_t> count;
  std::vector<std::ptrdiff_t> stride;
  const auto goes_on = [&](const Run& run, int link) {
    const int i = run.num_links;
    if (!by_link->in_order() || i < 2) return false;
    count.assign(positions.size(), 0);
    stride.assign(positions.size(), 0);
    for (const Entry& entry : run.entries) {
      const std::size_t a = at(entry.array);
      const EntriesByLink::Range range = by_link->range(a, link);
      const std::size_t e = entry.source.at(i);
      if (e < range.begin || e >= range.end) return false;
      if (count[a]++ == 0) stride[a] = entry.source.stride;
      if (entry.source.stride != stride[a]) return false;
      const std::size_t row = row_of(a, e);
      const std::size_t col = at(positions[a].cols[e]);
      const std::size_t high = run.unknowns[at(entry.row)].at(i);
      const std::size_t low = run.unknowns[at(entry.col)].at(i);
      const bool same =
          (row == high && col == low) || (row == low && col == high);
      if (!same) return false;
    }
    for (std::size_t a = 0; a < positions.size(); ++a) {
      const EntriesByLink::Range range = by_link->range(a, link);
      if (count[a] != range.end - range.begin) return false;
    }
    return true;
  };

  Run now;
  std::vector<EntriesByLink::Place> places;
  for (int link = 0; link < chain.num_links; ++link) {
    check_stop(link);

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

    // The second link of a run sets the strides of its unknowns.
    const auto same_unknowns = [&](const Run& run) {
      if (run.interior != now.interior || run.left != now.left ||
          run.right != now.right ||
          run.unknowns.size() != now.unknowns.size()) {
        return false;
      }
      for (std::size_t k = 0; k < now.unknowns.size(); ++k) {
        if (!fits(run, run.unknowns[k], now.unknowns[k])) return false;
      }
      return true;
    };
    const bool alike = !map.runs_.empty() && same_unknowns(map.runs_.back());
    if (alike && goes_on(map.runs_.back(), link)) {
      ++map.runs_.back().num_links;
      continue;
    }

    const auto local = [&](std::size_t unknown) {
      const int block = chain.block[unknown];
      int offset = 0;
      if (block != 2 * link + 1) offset += now.interior;
      if (block == 2 * link + 2 || block < 0) offset += now.left;
      if (block < 0) offset += now.right;
      return offset + place[unknown];
    };
    now.entries.clear();
    by_link->collect(link, places);
    for (const auto& [a, e] : places) {
      const int i = local(row_of(a, e));
      const int j = local(at(positions[a].cols[e]));
      now.entries.push_back({std::max(i, j),
                             std::min(i, j),
                             static_cast<int>(a),
                             {static_cast<std::ptrdiff_t>(e), 0}});
    }

    const auto continues = [&](Run& run) {
      if (run.entries.size() != now.entries.size()) return false;
      for (std::size_t k = 0; k < now.entries.size(); ++k) {
        const Entry& old = run.entries[k];
        const Entry& here = now.entries[k];
        if (old.row != here.row || old.col != here.col ||
            old.array != here.array || !fits(run, old.source, here.source)) {
          return false;
        }
      }
      if (run.num_links > 1) return true;
      for (std::size_t k = 0; k < now.unknowns.size(); ++k) {
        run.unknowns[k].stride = now.unknowns[k].first - run.unknowns[k].first;
      }
      for (std::size_t k = 0; k < now.entries.size(); ++k) {
        run.entries[k].source.stride =
            now.entries[k].source.first - run.entries[k].source.first;
      }
      return true;
    };
    if (alike && continues(map.runs_.back())) {
      ++map.runs_.back().num_links;
    } else {
      map.runs_.push_back(now);
    }
  }
  return map;
}

}  // namespace brachisto
