// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The points of a given path, which stand in a file of their own.

#pragma once

#include <cstddef>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "io/draft.hpp"
#include "io/findings.hpp"
#include "io/input_tree.hpp"

namespace brachisto::io {

/// Most points that a path may have.
inline constexpr std::size_t kMostPoints = 100'000;

/// Longest file of points that is read [bytes].
inline constexpr std::size_t kMaxPointsSize = std::size_t{1} << 24U;

/// A text does not hold points; what() begins with line:column.
class PointsError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Points of a text: a line `x,z`, then two numbers per line, in metres.
/// \throws PointsError
[[nodiscard]] std::vector<Point> parse_points(std::string_view text);

/// Puts the points of a file into a problem whose scene.path has that shape and
/// no points yet; checks those that are there. Mistakes go
/// to the findings, with file and line.
///
/// \param known  the points if they were read before; nullptr: the file that
///               scene.path names is read
/// \throws IoError  if it cannot be
void read_path_points(const InputTree& input, const std::vector<Point>* known,
                      Draft& problem, Findings& findings);

}  // namespace brachisto::io
