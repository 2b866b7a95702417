// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "solvers/chain_entries.hpp"

#include <algorithm>
#include <numeric>

#include "brachisto/math/clock.hpp"
#include "brachisto/math/index.hpp"

namespace brachisto {

namespace {

using nlp::ChainStructure;

// What stands for a link where there is none.
constexpr int kBorderAlone = -1;
constexpr int kAbsent = -2;
constexpr int kNoChain = -3;

}  // namespace

EntriesByLink::Place EntriesByLink::place(std::size_t array,
                                          std::size_t entry) const {
  const auto& [pattern, row_offset] = positions_[array];
  const auto [row, col] = pattern[entry];
  return {array, entry, row + row_offset, col};
}

EntriesByLink::Links EntriesByLink::links_of(const Place& place) const {
  const int a = chain_->block[at(place.row)];
  const int b = chain_->block[at(place.col)];
  if (a == ChainStructure::kAbsent || b == ChainStructure::kAbsent) {
    return {kAbsent, kAbsent};
  }
  const int low = std::min(a, b);
  const int high = std::max(a, b);
  if (high < 0) return {kBorderAlone, kBorderAlone};
  if (low < 0 || low == high) {
    // One block alone: a separator belongs to the links on both its sides.
    const int link = high / 2;
    if (high % 2 != 0) return {link, link};
    return {std::max(0, link - 1), std::min(link, chain_->num_links - 1)};
  }
  const int link = low / 2;
  if (high > 2 * link + 2 || link >= chain_->num_links) {
    return {kNoChain, kNoChain};
  }
  return {link, link};
}

EntriesByLink::EntriesByLink(const nlp::ChainStructure& chain,
                             std::span<const EntryPositions> positions,
                             Order order)
    : chain_(&chain),
      positions_(positions),
      order_(order),
      next_(positions.size()),
      taken_(positions.size()),
      couplings_(positions.size()) {
  if (order == Order::Any) sort();
}

bool EntriesByLink::next(int link, std::vector<Place>& places) {
  places.clear();
  if (order_ == Order::Any) {
    if (!is_chain_) return false;
    const auto from = [&](int i) {
      return sorted_.begin() + static_cast<std::ptrdiff_t>(starts_[at(i)]);
    };
    for (auto it = from(link); it != from(link + 1); ++it) {
      places.push_back(place(it->array, it->entry));
    }
    return true;
  }
  absent_.clear();
  for (std::size_t a = 0; a < positions_.size(); ++a) {
    const std::size_t begin = next_[a];
    const std::size_t size = positions_[a].pattern.num_entries();
    for (std::size_t& e = next_[a]; e < size; ++e) {
      const Place one = place(a, e);
      const Links links = links_of(one);
      if (links.first > link) break;
      if (links.first == kBorderAlone) border_.push_back(one);
      if (links.first == kAbsent) absent_.push_back(one);
      if (links.first == kNoChain) return false;
      if (links.first < 0) continue;
      if (links.last < link) return false;
      places.push_back(one);
    }
    taken_[a] = next_[a] - begin;
  }
  for (const Place& one : absent_) note_coupling(one);
  return true;
}

bool EntriesByLink::skip_as_many() {
  const auto next = [&](const Place& last) {
    return place(last.array, last.entry + taken_[last.array]);
  };
  if (std::ranges::any_of(absent_, [&](const Place& last) {
        return links_of(next(last)).first != kAbsent;
      })) {
    return false;
  }
  for (Place& one : absent_) {
    one = next(one);
    note_coupling(one);
  }
  for (std::size_t a = 0; a < next_.size(); ++a) next_[a] += taken_[a];
  return true;
}

void EntriesByLink::note_coupling(const Place& place) {
  const auto absent = [&](int unknown) {
    return chain_->block[at(unknown)] == ChainStructure::kAbsent;
  };
  const auto note = [&](int unknown, int of_absent) {
    if (absent(unknown) || !absent(of_absent)) return;
    couplings_[place.array].push_back({unknown, of_absent,
                                       static_cast<int>(place.array),
                                       static_cast<int>(place.entry)});
  };
  note(place.row, place.col);
  note(place.col, place.row);
}

std::vector<ChainMap::Coupling> EntriesByLink::couplings() const {
  std::vector<ChainMap::Coupling> all;
  for (const auto& of_array : couplings_) {
    all.insert(all.end(), of_array.begin(), of_array.end());
  }
  std::ranges::stable_sort(all, {}, &ChainMap::Coupling::unknown);
  return all;
}

void EntriesByLink::sort() {
  starts_.assign(at(chain_->num_links) + 1, 0);
  const auto each = [&](auto&& visit) {
    for (std::size_t a = 0; a < positions_.size(); ++a) {
      positions_[a].pattern.for_each([&](std::size_t entry, int row, int col) {
        check_stop(entry);
        const Place place{a, entry, row + positions_[a].row_offset, col};
        visit(place, links_of(place).first);
      });
    }
  };
  each([&](const Place& place, int link) {
    if (link == kBorderAlone) border_.push_back(place);
    if (link == kAbsent) note_coupling(place);
    if (link == kNoChain) is_chain_ = false;
    if (link >= 0) ++starts_[at(link) + 1];
  });
  std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
  sorted_.resize(starts_.back());
  std::vector<std::size_t> free(starts_.begin(), starts_.end() - 1);
  each([&](const Place& place, int link) {
    if (link < 0) return;
    sorted_[free[at(link)]++] = {static_cast<unsigned>(place.array),
                                 static_cast<unsigned>(place.entry)};
  });
}

}  // namespace brachisto
