// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "solvers/chain_map.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "brachisto/math/clock.hpp"
#include "brachisto/math/index.hpp"
#include "solvers/chain_blocks.hpp"
#include "solvers/chain_entries.hpp"

namespace brachisto {

namespace {

using Affine = ChainMap::Affine;
using Entry = ChainMap::Entry;
using Run = ChainMap::Run;

/// The unknowns of a link but for those of the border, by local number.
class LinkUnknowns {
 public:
  void read(const ChainBlocks& blocks, int link) {
    ranges_.clear();
    interior_ = add(blocks.of(2 * link + 1));
    left_ = add(blocks.of(2 * link));
    right_ = add(blocks.of(2 * link + 2));
  }
  [[nodiscard]] int count() const { return interior_ + left_ + right_; }
  /// The local number of an unknown; count() if it is none of these.
  [[nodiscard]] int local(int unknown) const {
    int before = 0;
    for (const auto& [first, count] : ranges_) {
      const int place = unknown - first;
      if (place >= 0 && place < count) return before + place;
      before += count;
    }
    return before;
  }
  /// Ranges as long as those of another link.
  [[nodiscard]] bool alike(const LinkUnknowns& other) const {
    return interior_ == other.interior_ && left_ == other.left_ &&
           right_ == other.right_ &&
           std::ranges::equal(ranges_, other.ranges_, {},
                              &ChainBlocks::Range::count,
                              &ChainBlocks::Range::count);
  }
  /// Whether holds(local number, unknown) of the first one of each range.
  template <class Holds>
  [[nodiscard]] bool all_first(Holds&& holds) const {
    int before = 0;
    for (const auto& [first, count] : ranges_) {
      if (!holds(before, first)) return false;
      before += count;
    }
    return true;
  }
  /// Calls visit(local number, unknown) for all.
  template <class Visit>
  void for_each(Visit&& visit) const {
    int local = 0;
    for (const auto& [first, count] : ranges_) {
      for (int i = 0; i < count; ++i) visit(local++, first + i);
    }
  }
  /// The link as a run of its own.
  [[nodiscard]] Run run(const std::vector<int>& border,
                        std::vector<Entry> entries) const {
    Run out{.num_links = 1,
            .interior = interior_,
            .left = left_,
            .right = right_,
            .entries = std::move(entries)};
    for_each([&](int, int unknown) { out.unknowns.push_back({unknown, 0}); });
    for (const int unknown : border) out.unknowns.push_back({unknown, 0});
    return out;
  }

 private:
  int add(std::span<const ChainBlocks::Range> ranges) {
    int sum = 0;
    for (const ChainBlocks::Range& range : ranges) {
      ranges_.push_back(range);
      sum += range.count;
    }
    return sum;
  }

  int interior_ = 0, left_ = 0, right_ = 0;
  std::vector<ChainBlocks::Range> ranges_;
};

/// Whether the next link of a run may have `next` where others have `what`. The
/// second link sets the strides.
bool fits(const Run& run, const Affine& what, std::ptrdiff_t next) {
  return run.num_links == 1 || what.first + what.stride * run.num_links == next;
}

/// Whether the next link of a run may have these unknowns, which are alike.
bool fits(const Run& run, const LinkUnknowns& next) {
  return next.all_first([&](int local, int unknown) {
    return fits(run, run.unknowns[at(local)], unknown);
  });
}

bool fits(const Run& run, const std::vector<Entry>& next) {
  return std::ranges::equal(
      run.entries, next, [&](const Entry& old, const Entry& here) {
        return old.row == here.row && old.col == here.col &&
               old.array == here.array &&
               fits(run, old.source, here.source.first);
      });
}

/// \param source_stride  of an entry, by its number in the run
/// \pre the link fits
template <class SourceStride>
void add_link(Run& run, const LinkUnknowns& unknowns,
              SourceStride&& source_stride) {
  if (run.num_links++ > 1) return;
  unknowns.for_each([&](int local, int unknown) {
    Affine& of_run = run.unknowns[at(local)];
    of_run.stride = unknown - of_run.first;
  });
  for (std::size_t k = 0; k < run.entries.size(); ++k) {
    run.entries[k].source.stride = source_stride(k);
  }
}

/// For how many links after the last one of a run its entries go on by the
/// repetitions of the patterns.
///
/// \param last  entries of that link
/// \param next  unknowns of the one after it, which fit
int links_ahead(const Run& run, const std::vector<EntriesByLink::Place>& last,
                const LinkUnknowns& next,
                std::span<const EntryPositions> positions,
                const EntriesByLink& by_link) {
  std::size_t ahead = std::numeric_limits<int>::max();
  std::size_t taken = 0;
  for (std::size_t a = 0; a < positions.size(); ++a) {
    const nlp::SparsityPattern& pattern = positions[a].pattern;
    const std::size_t count = by_link.taken(a), end = by_link.position(a);
    taken += count;
    if (count == 0 && end == pattern.num_entries()) continue;
    const auto* const repetition =
        count == 0 ? nullptr : pattern.repetition_of(end - 1);
    if (repetition == nullptr || count % repetition->length != 0 ||
        end - repetition->begin < count) {
      return 0;
    }
    ahead = std::min(ahead, (repetition->end() - end) / count);
  }
  // An entry of the border alone may turn into one of a link.
  if (ahead == 0 || taken != last.size() + by_link.num_absent()) return 0;
  // Positions have to go where the unknowns go.
  std::vector<int> to;
  next.for_each([&](int, int unknown) { to.push_back(unknown); });
  const auto goes_to = [&](int local, int unknown) {
    return local < next.count() ? to[at(local)] == unknown
                                : run.unknowns[at(local)].at(0) == at(unknown);
  };
  for (std::size_t k = 0; k < last.size(); ++k) {
    const auto& [array, entry, row, col] = last[k];
    const auto& [pattern, row_offset] = positions[array];
    const std::size_t count = by_link.taken(array);
    const auto [next_row, next_col] = pattern[entry + count];
    const Entry& of_run = run.entries[k];
    int of_row = of_run.row, of_col = of_run.col;
    if (run.unknowns[at(of_row)].at(run.num_links - 1) != at(row)) {
      std::swap(of_row, of_col);
    }
    if (!fits(run, of_run.source, static_cast<std::ptrdiff_t>(entry + count)) ||
        !goes_to(of_row, next_row + row_offset) || !goes_to(of_col, next_col)) {
      return 0;
    }
  }
  return static_cast<int>(ahead);
}

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

/// Takes the link at an end of the chain into a run, if it is one of its links
/// but for unknowns that are absent.
bool take_in(Run& run, const Run& end) {
  if (run.num_links < 2 || end.num_links != 1) return false;
  const int place = end.position - run.position;
  const bool before = place < 0;
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
  const int shift = before ? -place : 0;  // of the numbers of its links
  const auto extend = [&](Affine& what, bool lacks) {
    what.first -= what.stride * shift;
    (before ? what.not_in_first : what.not_in_last) = lacks;
  };
  for (std::size_t k = 0; k < run.unknowns.size(); ++k) {
    extend(run.unknowns[k], (*places)[k] < 0);
  }
  for (std::size_t k = 0; k < run.entries.size(); ++k) {
    extend(run.entries[k].source, lacking[k] != 0);
  }
  for (ChainMap::Links& links : run.stretches) {
    links.begin += shift;
    links.end += shift;
  }
  run.position -= shift;
  run.num_links = before ? run.num_links + shift : place + 1;
  const int number = before ? 0 : place;
  run.stretches.insert(before ? run.stretches.begin() : run.stretches.end(),
                       {number, number + 1});
  return true;
}

/// Calls visit(place in one, place in the other) for all unknowns and sources
/// of runs of the same shape until it answers false, which is the answer.
template <class Some, class Visit>
bool all_places(Some& one, const Run& other, Visit&& visit) {
  for (std::size_t k = 0; k < one.unknowns.size(); ++k) {
    if (!visit(one.unknowns[k], other.unknowns[k])) return false;
  }
  for (std::size_t k = 0; k < one.entries.size(); ++k) {
    if (!visit(one.entries[k].source, other.entries[k].source)) return false;
  }
  return true;
}

/// Takes the links of a later run as its own, if they are such.
bool unite(Run& run, const Run& later) {
  const int ahead = later.position - run.position;
  const bool alike =
      run.interior == later.interior && run.left == later.left &&
      run.right == later.right &&
      run.unknowns.size() == later.unknowns.size() &&
      std::ranges::equal(
          run.entries, later.entries, [](const Entry& a, const Entry& b) {
            return a.row == b.row && a.col == b.col && a.array == b.array;
          });
  if (!alike) return false;
  // A single link has no stride yet.
  const auto stride_of = [&](const Affine& own, const Affine& of_later) {
    if (run.num_links > 1) return own.stride;
    if (later.num_links > 1) return of_later.stride;
    return (of_later.first - own.first) / ahead;
  };
  const bool go_on =
      all_places(run, later, [&](const Affine& own, const Affine& of_later) {
        const std::ptrdiff_t stride = stride_of(own, of_later);
        return own.first + stride * ahead == of_later.first &&
               (later.num_links == 1 || of_later.stride == stride);
      });
  if (!go_on) return false;
  all_places(run, later, [&](Affine& own, const Affine& of_later) {
    own.stride = stride_of(own, of_later);
    return true;
  });
  run.num_links = ahead + later.num_links;
  run.stretches.push_back({ahead, run.num_links});
  return true;
}

}  // namespace

std::optional<ChainMap> ChainMap::make(
    nlp::ChainStructure structure, std::span<const EntryPositions> positions,
    int join_to) {
  join_links(structure, join_to);
  const ChainBlocks blocks(structure);
  ChainMap map;
  using Order = EntriesByLink::Order;
  for (const Order order : {Order::AsTheyStand, Order::Any}) {
    EntriesByLink by_link(structure, positions, order);
    if (map.read(blocks, positions, by_link, order == Order::AsTheyStand)) {
      return map;
    }
    map = {};
  }
  return std::nullopt;
}

bool ChainMap::read(const ChainBlocks& blocks,
                    std::span<const EntryPositions> positions,
                    EntriesByLink& by_link, bool in_order) {
  num_links_ = blocks.num_links();
  num_unknowns_ = blocks.num_unknowns();
  border_ = blocks.border();
  const auto in_border = [&](int unknown) {
    return static_cast<int>(std::ranges::lower_bound(border_, unknown) -
                            border_.begin());
  };

  LinkUnknowns here, of_run;
  std::vector<EntriesByLink::Place> places;
  constexpr int kUnknown = -1;
  int ahead = kUnknown;  // links that go on as the last one
  for (int link = 0; link < num_links_; ++link) {
    check_stop(link);
    here.read(blocks, link);
    const bool alike =
        !runs_.empty() && here.alike(of_run) && fits(runs_.back(), here);
    if (alike && in_order && ahead == kUnknown) {
      ahead = links_ahead(runs_.back(), places, here, positions, by_link);
    }
    if (alike && ahead > 0 && by_link.skip_as_many()) {
      add_link(runs_.back(), here, [&](std::size_t k) {
        const auto array = at(runs_.back().entries[k].array);
        return static_cast<std::ptrdiff_t>(by_link.taken(array));
      });
      --ahead;
      continue;
    }

    const auto local = [&](int unknown) {
      const int one = here.local(unknown);
      return one < here.count() ? one : one + in_border(unknown);
    };
    if (!by_link.next(link, places)) return false;
    std::vector<Entry> entries;
    entries.reserve(places.size());
    for (const auto& [array, entry, row, col] : places) {
      const auto [low, high] = std::minmax({local(row), local(col)});
      entries.push_back({high,
                         low,
                         static_cast<int>(array),
                         {static_cast<std::ptrdiff_t>(entry), 0}});
    }
    ahead = kUnknown;
    if (alike && fits(runs_.back(), entries)) {
      add_link(runs_.back(), here, [&](std::size_t k) {
        return entries[k].source.first - runs_.back().entries[k].source.first;
      });
    } else {
      runs_.push_back(here.run(border_, std::move(entries)));
      std::swap(of_run, here);
    }
  }
  // What comes after the last link is of the border alone.
  if (in_order && !(by_link.next(num_links_ - 1, places) && places.empty())) {
    return false;
  }
  for (const auto& [array, entry, row, col] : by_link.of_border()) {
    border_entries_.push_back({in_border(row),
                               in_border(col),
                               static_cast<int>(array),
                               {static_cast<std::ptrdiff_t>(entry), 0}});
  }
  couplings_ = by_link.couplings();
  unite_runs();
  return true;
}

void ChainMap::unite_runs() {
  constexpr std::size_t kKinds = 32;  // of which a run may be, or a new one
  std::vector<Run> united;
  int position = 0;
  for (Run& run : runs_) {
    run.position = position;
    run.stretches = {{0, run.num_links}};
    position += run.num_links;
    const auto known = std::span(united).last(std::min(kKinds, united.size()));
    if (std::ranges::none_of(known,
                             [&](Run& one) { return unite(one, run); })) {
      united.push_back(std::move(run));
    }
  }
  runs_ = std::move(united);
  for (const int end : {num_links_ - 1, 0}) {
    const auto own = std::ranges::find_if(runs_, [&](const Run& run) {
      return run.num_links == 1 && run.position == end;
    });
    if (own == runs_.end()) continue;
    const bool taken = std::any_of(runs_.begin(), runs_.end(), [&](Run& run) {
      return &run != &*own && take_in(run, *own);
    });
    if (taken) runs_.erase(own);
  }
}

std::vector<ChainMap::Stretch> ChainMap::along_chain() const {
  std::vector<Stretch> out;
  for (std::size_t r = 0; r < runs_.size(); ++r) {
    for (const Links& links : runs_[r].stretches) out.push_back({r, links});
  }
  std::ranges::sort(out, {}, [&](const Stretch& one) {
    return runs_[one.run].position + one.links.begin;
  });
  return out;
}

std::vector<int> ChainMap::Run::links() const {
  std::vector<int> out;
  for (const auto& [begin, end] : stretches) {
    for (int link = begin; link < end; ++link) out.push_back(link);
  }
  return out;
}

}  // namespace brachisto
