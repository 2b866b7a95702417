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
  /// \param times  as many neighbours as the mean are those of the border
  Levels(const MatrixGraph& graph, std::size_t times)
      : graph_(graph), level_(at(graph.size()), kNone) {
    constexpr std::size_t kFewest = 32;
    const std::size_t mean =
        graph.neighbour.size() / std::max<std::size_t>(1, level_.size());
    const std::size_t many = std::max(kFewest, times * mean);
    for (int i = 0; i < graph.size(); ++i) {
      if (graph.of(i).size() > many) level_[at(i)] = ChainStructure::kAbsent;
    }
    for (int i = 0; i < graph.size(); ++i) {
      if (level_[at(i)] == kNone) add_component(i);
    }
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

/// A matching of unknowns, the left ones, with neighbours, the right ones. An
/// unknown may be both, as a row and as a column.
class Matching {
 public:
  explicit Matching(int size)
      : of_left_(at(size), kNone),
        of_right_(at(size), kNone),
        seen_(at(size)) {}

  [[nodiscard]] bool has_partner(int left) const {
    return of_left_[at(left)] != kNone;
  }
  [[nodiscard]] int of_right(int right) const { return of_right_[at(right)]; }

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
      if (const int other = of_right_[at(found)]; other != kNone) {
        path.push_back({other, 0});
        continue;
      }
      for (std::size_t i = path.size(); i-- > 0;) {
        of_left_[at(path[i].left)] = through[i];
        of_right_[at(through[i])] = path[i].left;
      }
      return true;
    }
    return false;
  }
  /// For another one between the same unknowns.
  void forget(std::span<const int> unknowns) {
    for (const int i : unknowns) of_left_[at(i)] = of_right_[at(i)] = kNone;
  }

 private:
  std::vector<int> of_left_, of_right_;
  std::vector<unsigned> seen_;
  unsigned round_ = 0;
};

/// The smallest set of unknowns of a level and the next one that all entries
/// between them have a part in; of several the one farthest to the left.
class Cuts {
 public:
  Cuts(const MatrixGraph& graph, const Levels& levels)
      : graph_(graph),
        levels_(levels),
        matching_(graph.size()),
        reached_(at(graph.size()), 0) {}

  [[nodiscard]] std::vector<int> behind(int level) {
    const std::vector<int>& left = levels_.all()[at(level)];
    const std::vector<int>& right = levels_.all()[at(level + 1)];
    const auto is_right = [&](int j) { return levels_.of(j) == level + 1; };
    matching_.forget(left);
    matching_.forget(right);
    for (const int i : left) matching_.add(graph_, i, is_right);
    // What can be reached by alternating paths from a left one without partner:
    // of the left ones the others are in the set, of the right ones these.
    std::vector<int> reached, cut;
    const auto reach = [&](int i) {
      reached_[at(i)] = 1;
      reached.push_back(i);
    };
    for (const int i : left) {
      if (!matching_.has_partner(i)) reach(i);
    }
    for (std::size_t k = 0; k < reached.size(); ++k) {
      const int i = reached[k];
      if (is_right(i)) {
        cut.push_back(i);
        const int partner = matching_.of_right(i);
        if (reached_[at(partner)] == 0) reach(partner);
        continue;
      }
      for (const int j : graph_.of(i)) {
        if (is_right(j) && reached_[at(j)] == 0) reach(j);
      }
    }
    for (const int i : left) {
      if (reached_[at(i)] == 0) cut.push_back(i);
    }
    for (const int i : reached) reached_[at(i)] = 0;
    return cut;
  }

 private:
  const MatrixGraph& graph_;
  const Levels& levels_;
  Matching matching_;
  std::vector<char> reached_;
};

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

namespace {

constexpr std::size_t kLargest = 1000;  ///< unknowns of a level or an interior

/// Links from cut to cut; separators 0 and N are empty.
std::optional<ChainStructure> links_of(const MatrixGraph& graph,
                                       const Levels& levels) {
  constexpr std::size_t kLink = 24;  ///< unknowns in a link, at least
  const int num_levels = static_cast<int>(levels.all().size());
  ChainStructure chain;
  chain.block.assign(at(graph.size()), ChainStructure::kBorder);
  const auto is_new = [&](int i) {
    return chain.block[at(i)] == ChainStructure::kBorder;
  };
  const auto put = [&](int from, int to, int block) {
    for (int l = from; l < to; ++l) {
      for (const int i : levels.all()[at(l)]) {
        if (is_new(i)) chain.block[at(i)] = block;
      }
    }
  };
  Cuts cuts(graph, levels);
  for (int begin = 0; begin < num_levels; ++chain.num_links) {
    std::size_t count = 0;
    std::vector<int> best;
    int best_level = kNone;
    for (int l = begin;
         l + 1 < num_levels && (count < 2 * kLink || best_level == kNone);
         ++l) {
      if (levels.all()[at(l)].size() > kLargest) return std::nullopt;
      count += levels.all()[at(l)].size();
      if (count < kLink) continue;
      std::vector<int> cut = cuts.behind(l);
      // Those of the cut before are taken.
      if ((best_level == kNone || cut.size() < best.size()) &&
          std::ranges::all_of(cut, is_new)) {
        best = std::move(cut);
        best_level = l;
      }
    }
    const int end = best_level == kNone ? num_levels : best_level + 1;
    for (const int i : best) chain.block[at(i)] = 2 * (chain.num_links + 1);
    put(begin, end, 2 * chain.num_links + 1);
    begin = end;
  }
  return chain;
}

/// Takes what cannot be eliminated within its link out of it; false if a link
/// is too large.
bool make_interiors_regular(const MatrixGraph& graph,
                            const std::vector<bool>& no_diagonal,
                            ChainStructure& chain) {
  std::vector<std::vector<int>> interior(at(chain.num_links));
  for (int i = 0; i < graph.size(); ++i) {
    const int block = chain.block[at(i)];
    if (block >= 0 && block % 2 == 1) interior[at(block / 2)].push_back(i);
  }
  Matching matching(graph.size());
  for (int e = 0; e < chain.num_links; ++e) {
    std::vector<int>& inside = interior[at(e)];
    if (inside.size() > kLargest) return false;
    const int behind = e + 1 < chain.num_links ? 2 * (e + 1) : 2 * e;
    const auto touches = [&](int i) {
      return std::ranges::any_of(
          graph.of(i), [&](int j) { return chain.block[at(j)] == behind; });
    };
    // Those that touch it last: they can determine what is there.
    std::ranges::stable_partition(inside, [&](int i) { return !touches(i); });
    // One with a diagonal entry is its own partner.
    const auto may = [&](int j) { return chain.block[at(j)] == 2 * e + 1; };
    for (const int i : inside) {
      if (no_diagonal[at(i)] && !matching.add(graph, i, may)) {
        chain.block[at(i)] = behind;
      }
    }
  }
  return true;
}

}  // namespace

std::optional<ChainStructure> find_chain(const MatrixGraph& graph,
                                         const std::vector<bool>& no_diagonal) {
  constexpr int kFewest = 4;
  for (const std::size_t times : {10, 5, 3}) {
    const Levels levels(graph, times);
    auto chain = links_of(graph, levels);
    if (chain && chain->num_links >= kFewest &&
        make_interiors_regular(graph, no_diagonal, *chain)) {
      return chain;
    }
  }
  return std::nullopt;
}

}  // namespace brachisto
