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
using Affine = ChainMap::Affine;
using Run = ChainMap::Run;

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

/// What the next link of a run has to look like, entry by entry in the order in
/// which they stand: as the last one, every array by its own stride, with
/// entries of the border alone where that has them.
class Period {
 public:
  /// \pre run.num_links ≥ 2, and its entries are the last that were read
  Period(const Run& run, const ChainStructure& chain,
         std::span<const EntryPositions> positions,
         const EntriesByLink& by_link)
      : arrays_(positions.size()) {
    for (const ChainMap::Entry& entry : run.entries) {
      Array& array = arrays_[at(entry.array)];
      const auto stride = static_cast<std::size_t>(entry.source.stride);
      if (array.stride == 0) array.stride = stride;
      regular_ = regular_ && array.stride == stride;
    }
    auto entry = run.entries.begin();  // by array, then by place
    const int last = run.num_links - 1;
    for (std::size_t a = 0; regular_ && a < arrays_.size(); ++a) {
      const auto& [rows, cols, offset] = positions[a];
      const std::size_t end = by_link.position(a);
      if (end < arrays_[a].stride) regular_ = false;
      for (std::size_t e = end - arrays_[a].stride; regular_ && e < end; ++e) {
        Expected one{rows[e] + offset, 0, cols[e], 0};
        const bool listed = entry != run.entries.end() &&
                            at(entry->array) == a &&
                            entry->source.at(last) == e;
        if (listed) {
          const Affine* row = &run.unknowns[at(entry->row)];
          const Affine* col = &run.unknowns[at(entry->col)];
          if (col->at(last) != at(one.col)) std::swap(row, col);
          one.row_stride = static_cast<int>(row->stride);
          one.col_stride = static_cast<int>(col->stride);
          ++entry;
        } else {
          const auto of_border = [&](int unknown) {
            return chain.block[at(unknown)] == ChainStructure::kBorder;
          };
          regular_ = of_border(one.row) && of_border(one.col);
          arrays_[a].not_listed.push_back(arrays_[a].expected.size());
        }
        arrays_[a].expected.push_back(one);
      }
    }
    regular_ = regular_ && entry == run.entries.end();
  }

  /// Reads the next link if it is what is expected.
  [[nodiscard]] bool goes_on(std::span<const EntryPositions> positions,
                             EntriesByLink& by_link) {
    if (!regular_) return false;
    for (std::size_t a = 0; a < arrays_.size(); ++a) {
      const auto& [rows, cols, offset] = positions[a];
      const Array& array = arrays_[a];
      const std::size_t begin = by_link.position(a);
      if (begin + array.stride > rows.size()) return false;
      for (std::size_t k = 0; k < array.stride; ++k) {
        const Expected& one = array.expected[k];
        if (rows[begin + k] + offset != one.row + one.row_stride * links_ ||
            cols[begin + k] != one.col + one.col_stride * links_) {
          return false;
        }
      }
    }
    ++links_;
    for (std::size_t a = 0; a < arrays_.size(); ++a) {
      by_link.skip(a, arrays_[a].stride, arrays_[a].not_listed);
    }
    return true;
  }

 private:
  struct Expected {
    int row, row_stride, col, col_stride;
  };
  struct Array {
    std::size_t stride = 0;
    std::vector<Expected> expected;
    std::vector<std::size_t> not_listed;  ///< of the border alone
  };
  std::vector<Array> arrays_;
  int links_ = 1;  ///< from the one that was read last to the next
  bool regular_ = true;
};

/// What `place` of the run's `all` is in `some`, which may lack unknowns of
/// separators: −1 if it is lacking. Nothing if `some` has others.
std::optional<std::vector<int>> places_in(const Run& some, const Run& all,
                                          int place) {
  if (some.interior != all.interior) return std::nullopt;
  std::vector<int> out(all.unknowns.size(), -1);
  std::size_t next = 0;
  for (std::size_t k = 0; k < out.size(); ++k) {
    if (next == some.unknowns.size()) break;
    const Affine& one = all.unknowns[k];
    if (some.unknowns[next].first != one.first + one.stride * place) continue;
    out[k] = static_cast<int>(next++);
  }
  const auto absent = std::ranges::find(out, -1);
  if (next != some.unknowns.size() || absent - out.begin() < all.interior) {
    return std::nullopt;
  }
  return out;
}

/// Takes the link before or after a run into it, if it is one of its links but
/// for unknowns that are absent.
bool take_in(Run& run, const Run& end, bool before) {
  if (run.num_links < 2 || end.num_links != 1) return false;
  const int place = before ? -1 : run.num_links;
  const auto places = places_in(end, run, place);
  if (!places) return false;
  std::vector<char> lacking(run.entries.size());
  std::size_t next = 0;
  for (std::size_t k = 0; k < lacking.size(); ++k) {
    const ChainMap::Entry& entry = run.entries[k];
    const int row = (*places)[at(entry.row)];
    const int col = (*places)[at(entry.col)];
    lacking[k] = row < 0 || col < 0 ? 1 : 0;
    if (lacking[k] != 0) continue;
    if (next == end.entries.size()) return false;
    const ChainMap::Entry& here = end.entries[next++];
    if (here.row != std::max(row, col) || here.col != std::min(row, col) ||
        here.array != entry.array ||
        here.source.first != entry.source.first + entry.source.stride * place) {
      return false;
    }
  }
  if (next != end.entries.size()) return false;
  const auto extend = [&](Affine& what, bool lacks) {
    if (before) what.first -= what.stride;
    (before ? what.not_in_first : what.not_in_last) = lacks;
  };
  for (std::size_t k = 0; k < run.unknowns.size(); ++k) {
    extend(run.unknowns[k], (*places)[k] < 0);
  }
  for (std::size_t k = 0; k < run.entries.size(); ++k) {
    extend(run.entries[k].source, lacking[k] != 0);
  }
  ++run.num_links;
  return true;
}

}  // namespace

std::optional<ChainMap> ChainMap::make(
    const ChainStructure& structure, std::span<const EntryPositions> positions,
    int join_to) {
  const ChainStructure chain =
      joined(structure, links_to_join(structure, join_to));
  ChainMap map;
  using Order = EntriesByLink::Order;
  for (const Order order : {Order::AsTheyStand, Order::Any}) {
    EntriesByLink by_link(chain, positions, order);
    if (map.read(chain, positions, by_link, order == Order::AsTheyStand)) {
      return map;
    }
    map = {};
  }
  return std::nullopt;
}

bool ChainMap::read(const ChainStructure& chain,
                    std::span<const EntryPositions> positions,
                    EntriesByLink& by_link, bool in_order) {
  const Members members(chain);
  num_links_ = chain.num_links;
  std::vector<int> place = members.place;
  for (std::size_t i = 0; i < chain.block.size(); ++i) {
    if (chain.block[i] != ChainStructure::kAbsent) ++num_unknowns_;
    if (chain.block[i] != ChainStructure::kBorder) continue;
    place[i] = static_cast<int>(border_.size());
    border_.push_back(static_cast<int>(i));
  }
  const auto row_of = [&](std::size_t array, std::size_t e) {
    return at(positions[array].rows[e] + positions[array].row_offset);
  };

  const auto fits = [](const Run& run, const Affine& old, const Affine& here) {
    return run.num_links == 1 ||
           old.at(run.num_links) == static_cast<std::size_t>(here.first);
  };
  Run now;
  std::optional<Period> period;  // of the last run
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
    for (const int unknown : border_) now.unknowns.push_back({unknown, 0});

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
    const bool alike = !runs_.empty() && same_unknowns(runs_.back());
    if (alike && in_order && runs_.back().num_links > 1) {
      Run& run = runs_.back();
      if (!period) period.emplace(run, chain, positions, by_link);
      if (period->goes_on(positions, by_link)) {
        ++run.num_links;
        continue;
      }
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
    if (!by_link.next(link, places)) return false;
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
    if (alike && continues(runs_.back())) {
      ++runs_.back().num_links;
    } else {
      runs_.push_back(now);
    }
    period.reset();
  }
  // What comes after the last link is of the border alone.
  if (in_order && !(by_link.next(num_links_ - 1, places) && places.empty())) {
    return false;
  }
  for (const auto& [a, e] : by_link.of_border()) {
    border_entries_.push_back({place[row_of(a, e)],
                               place[at(positions[a].cols[e])],
                               static_cast<int>(a),
                               {static_cast<std::ptrdiff_t>(e), 0}});
  }
  const std::size_t last = runs_.size() - 1;
  if (last > 0 && take_in(runs_[last - 1], runs_[last], false)) {
    runs_.pop_back();
  }
  if (runs_.size() > 1 && take_in(runs_[1], runs_[0], true)) {
    runs_.erase(runs_.begin());
  }
  return true;
}

}  // namespace brachisto
