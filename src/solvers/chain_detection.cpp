// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "solvers/chain_detection.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

#include "brachisto/math/index.hpp"

namespace brachisto {

namespace {

using nlp::ChainStructure;

constexpr int kNone = -1;

/// The border and the levels of the others: neighbours are in one level or in
/// levels next to each other.
class Levels {
 public:
  explicit Levels(const MatrixGraph& graph)
      : graph_(graph), level_(at(graph.size()), kNone) {
    constexpr std::size_t kFewest = 32, kTimesTheMean = 10;
    const std::size_t mean =
        graph.neighbour.size() / std::max<std::size_t>(1, level_.size());
    const std::size_t many = std::max(kFewest, kTimesTheMean * mean);
    for (int i = 0; i < graph.size(); ++i) {
      if (graph.of(i).size() > many) level_[at(i)] = ChainStructure::kAbsent;
    }
    for (int i = 0; i < graph.size(); ++i) {
      if (level_[at(i)] == kNone) add_component(i);
    }
  }

  [[nodiscard]] bool in_border(int unknown) const {
    return level_[at(unknown)] == ChainStructure::kAbsent;
  }
  [[nodiscard]] int of(int unknown) const { return level_[at(unknown)]; }
  [[nodiscard]] const std::vector<std::vector<int>>& all() const {
    return members_;
  }

 private:
  /// From an unknown that is as far from others as any found.
  void add_component(int any) {
    constexpr int kMostTries = 8;
    std::vector<std::vector<int>> best = spread(any);
    for (int i = 0; i < kMostTries; ++i) {
      const int end = *std::ranges::min_element(
          best.back(), {}, [&](int j) { return graph_.of(j).size(); });
      std::vector<std::vector<int>> other = spread(end);
      const bool farther = other.size() > best.size();
      if (i == 0 || farther) best = std::move(other);
      if (i > 0 && !farther) break;
    }
    for (std::vector<int>& level : best) {
      std::ranges::sort(level);
      for (const int i : level)
        level_[at(i)] = static_cast<int>(members_.size());
      members_.push_back(std::move(level));
    }
  }
  /// By distance; what is reached is as it was before.
  std::vector<std::vector<int>> spread(int from) {
    constexpr int kSeen = -3;
    std::vector<std::vector<int>> levels{{from}};
    level_[at(from)] = kSeen;
    for (;;) {
      std::vector<int> next;
      for (const int i : levels.back()) {
        for (const int j : graph_.of(i)) {
          if (level_[at(j)] != kNone) continue;
          level_[at(j)] = kSeen;
          next.push_back(j);
        }
      }
      if (next.empty()) break;
      levels.push_back(std::move(next));
    }
    for (const std::vector<int>& level : levels) {
      for (const int i : level) level_[at(i)] = kNone;
    }
    return levels;
  }

  const MatrixGraph& graph_;
  std::vector<int> level_;
  std::vector<std::vector<int>> members_;
};

/// A matching of some unknowns, the left ones, with others.
class Matching {
 public:
  explicit Matching(int size) : partner_(at(size), kNone), seen_(at(size), 0) {}

  [[nodiscard]] int partner(int unknown) const { return partner_[at(unknown)]; }

  /// Whether a left one can have a partner too, others changing theirs.
  /// \param may  whether an unknown may be a partner
  template <class May>
  bool add(const MatrixGraph& graph, int left, May&& may) {
    ++round_;
    // Depth first, without recursion: paths may be long.
    struct Step {
      int left;
      std::size_t next;
    };
    std::vector<Step> path{{left, 0}};
    std::vector<int> through;
    while (!path.empty()) {
      Step& here = path.back();
      const std::span<const int> all = graph.of(here.left);
      int found = kNone;
      while (here.next < all.size() && found == kNone) {
        const int j = all[here.next++];
        if (may(j) && seen_[at(j)] != round_) found = j;
      }
      if (found == kNone) {
        path.pop_back();
        if (!through.empty()) through.pop_back();
        continue;
      }
      seen_[at(found)] = round_;
      through.push_back(found);
      const int other = partner_[at(found)];
      if (other != kNone) {
        path.push_back({other, 0});
        continue;
      }
      for (std::size_t i = path.size(); i-- > 0;) {
        partner_[at(path[i].left)] = through[i];
        partner_[at(through[i])] = path[i].left;
      }
      return true;
    }
    return false;
  }
  /// For another one between the same unknowns.
  void forget(std::span<const int> unknowns) {
    for (const int i : unknowns) partner_[at(i)] = kNone;
  }

 private:
  std::vector<int> partner_;
  std::vector<unsigned> seen_;
  unsigned round_ = 0;
};

/// The smallest set of unknowns of a level and the next one that all entries
/// between them have a part in; of several the one farthest to the right.
std::vector<int> cut_behind(const MatrixGraph& graph, const Levels& levels,
                            int level, Matching& matching) {
  const std::vector<int>& left = levels.all()[at(level)];
  const std::vector<int>& right = levels.all()[at(level + 1)];
  const auto is_right = [&](int j) { return levels.of(j) == level + 1; };
  matching.forget(left);
  matching.forget(right);
  for (const int i : left) matching.add(graph, i, is_right);
  // What can be reached by alternating paths from a left one without partner:
  // of the left ones the others are in the set, of the right ones these.
  std::vector<int> reached;
  std::vector<int> lefts;
  for (const int i : left) {
    if (matching.partner(i) == kNone) lefts.push_back(i);
  }
  for (std::size_t k = 0; k < lefts.size(); ++k) {
    for (const int j : graph.of(lefts[k])) {
      if (!is_right(j) || std::ranges::find(reached, j) != reached.end()) {
        continue;
      }
      reached.push_back(j);
      lefts.push_back(matching.partner(j));
    }
  }
  std::vector<int> cut = std::move(reached);
  for (const int i : left) {
    if (std::ranges::find(lefts, i) == lefts.end()) cut.push_back(i);
  }
  return cut;
}

}  // namespace

std::span<const int> MatrixGraph::of(int unknown) const {
  const int begin = start[at(unknown)];
  return {neighbour.data() + begin, at(start[at(unknown) + 1] - begin)};
}

MatrixGraph MatrixGraph::of_pattern(int size,
                                    const nlp::SparsityPattern& pattern) {
  MatrixGraph graph;
  graph.start.assign(at(size) + 1, 0);
  pattern.for_each([&](std::size_t, int i, int j) {
    if (i == j) return;
    ++graph.start[at(i) + 1];
    ++graph.start[at(j) + 1];
  });
  std::partial_sum(graph.start.begin(), graph.start.end(), graph.start.begin());
  graph.neighbour.resize(at(graph.start.back()));
  std::vector<int> next(graph.start.begin(), graph.start.end() - 1);
  pattern.for_each([&](std::size_t, int i, int j) {
    if (i == j) return;
    graph.neighbour[at(next[at(i)]++)] = j;
    graph.neighbour[at(next[at(j)]++)] = i;
  });
  // Each once.
  std::size_t end = 0;
  for (int i = 0; i < size; ++i) {
    const auto begin = graph.neighbour.begin() + graph.start[at(i)];
    const auto last = graph.neighbour.begin() + graph.start[at(i) + 1];
    std::sort(begin, last);
    const auto unique = std::unique(begin, last);
    graph.start[at(i)] = static_cast<int>(end);
    end = at(static_cast<int>(
        std::copy(begin, unique,
                  graph.neighbour.begin() + static_cast<std::ptrdiff_t>(end)) -
        graph.neighbour.begin()));
  }
  graph.start.back() = static_cast<int>(end);
  graph.neighbour.resize(end);
  return graph;
}

std::optional<ChainStructure> find_chain(const MatrixGraph& graph,
                                         const std::vector<bool>& no_diagonal) {
  constexpr std::size_t kLink = 24;  ///< unknowns in a link, at least
  constexpr std::size_t kLargest = 1000;
  constexpr int kFewest = 4;
  const Levels levels(graph);
  const int num_levels = static_cast<int>(levels.all().size());
  ChainStructure chain;
  chain.block.assign(at(graph.size()), ChainStructure::kBorder);
  Matching matching(graph.size());

  // Links from cut to cut; separators 0 and N are empty.
  const auto put = [&](int from, int to, int block) {
    for (int l = from; l < to; ++l) {
      for (const int i : levels.all()[at(l)]) {
        if (chain.block[at(i)] == ChainStructure::kBorder) {
          chain.block[at(i)] = block;
        }
      }
    }
  };
  int begin = 0, link = 0;
  while (begin < num_levels) {
    std::size_t count = 0;
    std::vector<int> best;
    int best_level = kNone;
    for (int l = begin; l + 1 < num_levels && count < 2 * kLink; ++l) {
      count += levels.all()[at(l)].size();
      if (count < kLink) continue;
      std::vector<int> cut = cut_behind(graph, levels, l, matching);
      if (!cut.empty() && (best.empty() || cut.size() < best.size())) {
        best = std::move(cut);
        best_level = l;
      }
    }
    if (best_level == kNone) break;
    for (const int i : best) chain.block[at(i)] = 2 * (link + 1);
    put(begin, best_level + 1, 2 * link + 1);
    begin = best_level + 1;
    ++link;
  }
  put(begin, num_levels, 2 * link + 1);
  chain.num_links = link + 1;
  if (chain.num_links < kFewest) return std::nullopt;

  // What cannot be eliminated within its link.
  std::vector<std::vector<int>> interior(at(chain.num_links));
  for (int i = 0; i < graph.size(); ++i) {
    const int block = chain.block[at(i)];
    if (block >= 0 && block % 2 == 1) interior[at(block / 2)].push_back(i);
  }
  matching = Matching(graph.size());
  for (int e = 0; e < chain.num_links; ++e) {
    std::vector<int>& inside = interior[at(e)];
    if (inside.size() > kLargest) return std::nullopt;
    const int behind = e + 1 < chain.num_links ? 2 * (e + 1) : 2 * e;
    const auto touches = [&](int i) {
      return std::ranges::any_of(
          graph.of(i), [&](int j) { return chain.block[at(j)] == behind; });
    };
    // Those that touch it last: they can determine what is there.
    std::ranges::stable_partition(inside, [&](int i) { return !touches(i); });
    const auto may = [&](int j) {
      return chain.block[at(j)] == 2 * e + 1 && !no_diagonal[at(j)];
    };
    for (const int i : inside) {
      if (no_diagonal[at(i)] && !matching.add(graph, i, may)) {
        chain.block[at(i)] = behind;
      }
    }
  }
  return chain;
}

}  // namespace brachisto
