// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "sweep/chain_plan.hpp"

#include <charconv>
#include <stdexcept>

namespace brachisto::sweep {

std::size_t ChainPlan::longest(const io::SweepFile& file) {
  if (file.num_scenes() > 0) {
    const io::ProblemFile first = file.problem(0);
    if (first.options.or_default<Collocation>().in_lanes &&
        first.design.free.empty()) {
      return kLongestInLanes;
    }
  }
  return file.warm_start() ? kLongestWarm : kLongestCold;
}

Shard Shard::parse(const std::string& text) {
  Shard shard;
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, shard.index);
  bool good = first.ec == std::errc{} && first.ptr != end && *first.ptr == '/';
  if (good) {
    const auto second = std::from_chars(first.ptr + 1, end, shard.count);
    good = second.ec == std::errc{} && second.ptr == end;
  }
  if (!good || shard.index < 1 || shard.index > shard.count) {
    throw std::invalid_argument(
        "a shard is i/N with 1 ≤ i ≤ N, such as 2/8; "
        "read '" +
        text + "'");
  }
  return shard;
}

}  // namespace brachisto::sweep
