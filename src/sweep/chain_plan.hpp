// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How a sweep is cut into chains, the units of scheduling, sharding and
/// resuming.

#pragma once

#include <cstddef>
#include <string>

#include "brachisto/io/problem_file.hpp"

namespace brachisto::sweep {

/// Neighbouring scenes that one worker solves in order.
struct Chain {
  std::size_t id = 0;
  std::size_t first = 0, last = 0;  ///< scenes first … last − 1
};

/// The chains of a sweep: rows along its last axis, long ones in pieces of
/// nearly equal length. Depends on the sweep alone.
class ChainPlan {
 public:
  /// With warm starts a first scene costs almost twice what the next ones do,
  /// so that longer pieces gain little.
  static constexpr std::size_t kLongestWarm = 16;
  /// Without, shorter pieces share the work more evenly.
  static constexpr std::size_t kLongestCold = 4;
  /// Side by side, eight scenes are solved at a time at most.
  static constexpr std::size_t kLongestInLanes = 32;

  explicit ChainPlan(const io::SweepFile& file)
      : ChainPlan(file.num_scenes(),
                  file.axes().empty() ? 1 : file.axes().back().count,
                  longest(file)) {}
  ChainPlan(std::size_t num_scenes, std::size_t row, std::size_t longest)
      : row_(row),
        pieces_((row + longest - 1) / longest),
        rows_(num_scenes / row) {}

  [[nodiscard]] std::size_t size() const { return rows_ * pieces_; }
  [[nodiscard]] Chain operator[](std::size_t id) const {
    const std::size_t start = id / pieces_ * row_;
    const std::size_t piece = id % pieces_;
    return {id, start + piece * row_ / pieces_,
            start + (piece + 1) * row_ / pieces_};
  }
  /// The chain that a scene belongs to.
  [[nodiscard]] Chain of_scene(std::size_t scene) const {
    std::size_t id = scene / row_ * pieces_ + scene % row_ * pieces_ / row_;
    while ((*this)[id].last <= scene) ++id;
    return (*this)[id];
  }

 private:
  [[nodiscard]] static std::size_t longest(const io::SweepFile& file);

  std::size_t row_, pieces_, rows_;
};

/// The part of a sweep that one machine does: every N-th chain.
struct Shard {
  std::size_t index = 1, count = 1;  ///< 1 ≤ index ≤ count

  [[nodiscard]] bool has(std::size_t chain) const {
    return chain % count == index - 1;
  }
  [[nodiscard]] std::string name() const {
    return std::to_string(index) + "/" + std::to_string(count);
  }
  /// \throws std::invalid_argument  unless the text is "i/N"
  [[nodiscard]] static Shard parse(const std::string& text);
};

}  // namespace brachisto::sweep
