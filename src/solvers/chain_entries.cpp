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

EntriesByLink::EntriesByLink(const nlp::ChainStructure& chain,
                             std::span<const EntryPositions> positions,
                             Order order)
    : chain_(&chain),
      positions_(positions),
      order_(order),
      next_(positions.size(), 0) {
  if (order == Order::Any) sort();
}

bool EntriesByLink::next(int link, std::vector<Place>& places) {
  places.clear();
  if (order_ == Order::Any) {
    if (!is_chain_) return false;
    const auto from = [&](int i) {
      return sorted_.begin() + static_cast<std::ptrdiff_t>(starts_[at(i)]);
    };
    places.assign(from(link), from(link + 1));
    return true;
  }
  for (std::size_t a = 0; a < positions_.size(); ++a) {
    const std::size_t size = positions_[a].rows.size();
    for (std::size_t& e = next_[a]; e < size; ++e) {
      const Links links = links_of(a, e);
      if (links.first > link) break;
      if (links.first == kBorderAlone) border_.push_back({a, e});
      if (links.first == kNoChain) return false;
      if (links.first < 0) continue;
      if (links.last < link) return false;
      places.push_back({a, e});
    }
  }
  return true;
}

void EntriesByLink::sort() {
  starts_.assign(at(chain_->num_links) + 1, 0);
  const auto each = [&](auto&& visit) {
    for (std::size_t a = 0; a < positions_.size(); ++a) {
      for (std::size_t e = 0; e < positions_[a].rows.size(); ++e) {
        check_stop(e);
        visit(Place{a, e}, links_of(a, e).first);
      }
    }
  };
  each([&](const Place& place, int link) {
    if (link == kBorderAlone) border_.push_back(place);
    if (link == kNoChain) is_chain_ = false;
    if (link >= 0) ++starts_[at(link) + 1];
  });
  std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
  sorted_.resize(starts_.back());
  std::vector<std::size_t> free(starts_.begin(), starts_.end() - 1);
  each([&](const Place& place, int link) {
    if (link >= 0) sorted_[free[at(link)]++] = place;
  });
}

}  // namespace brachisto
