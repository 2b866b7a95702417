// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/contours.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace brachisto::report {

namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

/// The crossings of one level with the edges of the grid and how they are
/// joined. The edge from node (i, j) towards i + 1 is number 2 at(i, j), that
/// towards j + 1 the next.
class Marching {
 public:
  Marching(const Lattice& lattice, double level)
      : lattice_(lattice),
        level_(level),
        joined_(2 * lattice.values.size(), {kNone, kNone}) {
    for (std::size_t i = 0; i + 1 < lattice.nx; ++i) {
      for (std::size_t j = 0; j + 1 < lattice.ny; ++j) march(i, j);
    }
  }

  [[nodiscard]] std::vector<std::vector<Pixel>> lines() {
    std::vector<std::vector<Pixel>> found;
    // Open lines from an end of theirs, then what is left: closed ones.
    for (const bool open : {true, false}) {
      for (std::size_t edge = 0; edge < joined_.size(); ++edge) {
        const bool end =
            (joined_[edge][0] == kNone) != (joined_[edge][1] == kNone);
        const bool inner = joined_[edge][0] != kNone && !end;
        if (open ? end : inner) found.push_back(follow(edge));
      }
    }
    return found;
  }

 private:
  [[nodiscard]] bool above(std::size_t node) const {
    return lattice_.values[node] >= level_;
  }

  void join(std::size_t a, std::size_t b) {
    joined_[a][joined_[a][0] == kNone ? 0 : 1] = b;
    joined_[b][joined_[b][0] == kNone ? 0 : 1] = a;
  }

  void march(std::size_t i, std::size_t j) {
    // Corners in turn, and the edges from each to the next.
    const std::array<std::size_t, 4> corners{
        lattice_.at(i, j), lattice_.at(i + 1, j), lattice_.at(i + 1, j + 1),
        lattice_.at(i, j + 1)};
    const std::array<std::size_t, 4> edges{2 * corners[0], 2 * corners[1] + 1,
                                           2 * corners[3], 2 * corners[0] + 1};
    double mean = 0.0;
    for (const std::size_t node : corners) {
      mean += 0.25 * lattice_.values[node];
    }
    if (!std::isfinite(mean)) return;
    std::vector<std::size_t> crossed;
    for (std::size_t c = 0; c < 4; ++c) {
      if (above(corners[c]) != above(corners[(c + 1) % 4])) {
        crossed.push_back(edges[c]);
      }
    }
    if (crossed.size() == 2) join(crossed[0], crossed[1]);
    if (crossed.size() != 4) return;
    // A line cuts off each corner that the middle does not agree with.
    const bool first = above(corners[0]) != (mean >= level_);
    join(crossed[0], crossed[first ? 3 : 1]);
    join(crossed[2], crossed[first ? 1 : 3]);
  }

  [[nodiscard]] Pixel crossing(std::size_t edge) const {
    const std::size_t a = edge / 2;
    const std::size_t b = a + (edge % 2 == 0 ? lattice_.ny : 1);
    const double t = (level_ - lattice_.values[a]) /
                     (lattice_.values[b] - lattice_.values[a]);
    return {std::lerp(lattice_.nodes[a].x, lattice_.nodes[b].x, t),
            std::lerp(lattice_.nodes[a].y, lattice_.nodes[b].y, t)};
  }

  /// The line through an edge, which is taken out of the joints.
  std::vector<Pixel> follow(std::size_t edge) {
    std::vector<Pixel> line{crossing(edge)};
    while (true) {
      std::size_t& next = joined_[edge][joined_[edge][0] == kNone ? 1 : 0];
      if (next == kNone) return line;
      const std::size_t reached = next;
      next = kNone;
      auto& back = joined_[reached];
      back[back[0] == edge ? 0 : 1] = kNone;
      line.push_back(crossing(reached));
      edge = reached;
    }
  }

  const Lattice& lattice_;
  double level_;
  std::vector<std::array<std::size_t, 2>> joined_;
};

}  // namespace

std::vector<std::vector<Pixel>> contour_lines(const Lattice& lattice,
                                              double level) {
  return Marching(lattice, level).lines();
}

}  // namespace brachisto::report
