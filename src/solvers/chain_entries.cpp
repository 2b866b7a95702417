// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "solvers/chain_entries.hpp"

#include <algorithm>
#include <numeric>

#include "brachisto/math/stop_condition.hpp"
#include "math/index.hpp"

namespace brachisto {

namespace {

using nlp::ChainStructure;

// What stands for a link where there is none.
constexpr int kBorderAlone = -1;
constexpr int kAbsent = -2;
constexpr int kNoChain = -3;

}  // namespace

EntriesByLink::Links EntriesByLink::links_of(std::size_t array,
                                             std::size_t entry) const {
  const EntryPositions& position = positions_[array];
  const int a = chain_->block[at(position.rows[entry] + position.row_offset)];
  const int b = chain_->block[at(position.cols[entry])];
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

std::optional<EntriesByLink> EntriesByLink::make(
    const ChainStructure& chain, std::span<const EntryPositions> positions) {
  EntriesByLink entries(chain, positions);
  if (!entries.find_ranges() && !entries.sort()) return std::nullopt;
  return entries;
}

/// False if an array goes back to an earlier link.
bool EntriesByLink::find_ranges() {
  const std::size_t num_links = at(chain_->num_links);
  starts_.assign(positions_.size(), {});
  for (std::size_t a = 0; a < positions_.size(); ++a) {
    std::vector<std::size_t>& starts = starts_[a];
    starts.reserve(num_links + 1);
    starts.push_back(0);
    const std::size_t size = positions_[a].rows.size();
    int now = 0;
    for (std::size_t e = 0; e < size; ++e) {
      check_stop(e);
      const Links links = links_of(a, e);
      if (links.first == kBorderAlone) border_.push_back({a, e});
      if (links.first < 0) {
        if (links.first == kNoChain) return false;
        continue;
      }
      if (links.last < now) return false;
      for (; now < links.first; ++now) starts.push_back(e);
    }
    starts.resize(num_links + 1, size);
  }
  return true;
}

bool EntriesByLink::sort() {
  border_.clear();
  std::vector<std::size_t> starts(at(chain_->num_links) + 1, 0);
  const auto each = [&](auto&& visit) {
    for (std::size_t a = 0; a < positions_.size(); ++a) {
      for (std::size_t e = 0; e < positions_[a].rows.size(); ++e) {
        check_stop(e);
        if (!visit(Place{a, e}, links_of(a, e).first)) return false;
      }
    }
    return true;
  };
  const bool chain = each([&](const Place& place, int link) {
    if (link == kBorderAlone) border_.push_back(place);
    if (link >= 0) ++starts[at(link) + 1];
    return link != kNoChain;
  });
  if (!chain) return false;
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  sorted_.resize(starts.back());
  std::vector<std::size_t> next(starts.begin(), starts.end() - 1);
  each([&](const Place& place, int link) {
    if (link >= 0) sorted_[next[at(link)]++] = place;
    return true;
  });
  starts_.assign(1, std::move(starts));
  return true;
}

void EntriesByLink::collect(int link, std::vector<Place>& places) const {
  places.clear();
  if (!in_order()) {
    const Range r = range(0, link);
    places.assign(sorted_.begin() + static_cast<std::ptrdiff_t>(r.begin),
                  sorted_.begin() + static_cast<std::ptrdiff_t>(r.end));
    return;
  }
  for (std::size_t a = 0; a < positions_.size(); ++a) {
    const Range r = range(a, link);
    for (std::size_t e = r.begin; e < r.end; ++e) {
      if (links_of(a, e).first >= 0) places.push_back({a, e});
    }
  }
}

}  // namespace brachisto
