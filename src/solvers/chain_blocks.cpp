// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "solvers/chain_blocks.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "brachisto/math/index.hpp"

namespace brachisto {

namespace {

using nlp::ChainStructure;

/// Calls visit(first, count, block) for neighbours of the same block.
template <class Visit>
void for_each_range(const std::vector<int>& block, Visit&& visit) {
  for (std::size_t first = 0, end = 0; first < block.size(); first = end) {
    while (end < block.size() && block[end] == block[first]) ++end;
    visit(static_cast<int>(first), static_cast<int>(end - first), block[first]);
  }
}

}  // namespace

void join_links(ChainStructure& chain, int join_to) {
  const auto inside = std::count_if(chain.block.begin(), chain.block.end(),
                                    [](int block) { return block >= 0; });
  const auto per_link = std::max(1, static_cast<int>(inside / chain.num_links));
  const int group = std::clamp(join_to / per_link, 1, chain.num_links);
  if (group == 1) return;
  const int last_separator = 2 * chain.num_links;
  chain.num_links = (chain.num_links + group - 1) / group;
  const auto joined = [&](int block) {
    if (block < 0) return block;
    if (block == last_separator) return 2 * chain.num_links;
    const int link = block / 2;
    const bool separator = block % 2 == 0 && link % group == 0;
    return 2 * (link / group) + (separator ? 0 : 1);
  };
  int fine = ChainStructure::kAbsent, coarse = fine;
  for (int& block : chain.block) {
    if (block != fine) {
      fine = block;
      coarse = joined(block);
    }
    block = coarse;
  }
}

ChainBlocks::ChainBlocks(const ChainStructure& chain)
    : num_links_(chain.num_links), start_(at(2 * chain.num_links) + 2, 0) {
  for_each_range(chain.block, [&](int first, int count, int block) {
    if (block != ChainStructure::kAbsent) num_unknowns_ += count;
    if (block >= 0) ++start_[at(block) + 1];
    if (block != ChainStructure::kBorder) return;
    for (int i = 0; i < count; ++i) border_.push_back(first + i);
  });
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  ranges_.resize(at(start_.back()));
  std::vector<int> next(start_.begin(), start_.end() - 1);
  for_each_range(chain.block, [&](int first, int count, int block) {
    if (block >= 0) ranges_[at(next[at(block)]++)] = {first, count};
  });
}

std::span<const ChainBlocks::Range> ChainBlocks::of(int block) const {
  const int begin = start_[at(block)];
  return {ranges_.data() + begin, at(start_[at(block) + 1] - begin)};
}

}  // namespace brachisto
