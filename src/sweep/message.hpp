// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What manager and workers say to each other: lines of JSON.

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "search/continuation.hpp"
#include "sweep/outcome.hpp"

namespace brachisto::sweep {

/// To a worker: solve these scenes in order. The first one starts from `state`
/// if there is one, cold otherwise.
struct Request {
  std::size_t first = 0, last = 0;  ///< scenes first … last − 1
  std::string state;                ///< of scene first − 1, or empty
  /// What is left for all of them together, if that is limited.
  std::optional<double> seconds = {};
};

/// From a worker, or about it: what came out for a scene.
struct Answer {
  std::size_t scene = 0;
  std::string result;  ///< JSON document on one line
  /// What the next scene starts from; empty: the cycloid. Nothing if that is
  /// not known or not wanted.
  std::optional<std::string> state;
  /// What is read of the result, on the side of those who read it.
  SweepOutcome outcome = {};
};

/// One line each, its end included.
[[nodiscard]] std::string to_line(const Request& request);
[[nodiscard]] std::string to_line(const Answer& answer);

/// \throws std::exception  of nlohmann::json, if the line is no request
[[nodiscard]] Request request_from_line(std::string_view line);
/// Nothing if the line is no answer: what a worker writes is not trusted.
[[nodiscard]] std::optional<Answer> answer_from_line(std::string_view line);

/// A neighbour without its scene as JSON; doubles survive bit for bit.
[[nodiscard]] std::string to_state(const Neighbour& neighbour);
/// \throws std::exception  if the state is not one of a scene like `scene`
[[nodiscard]] Neighbour neighbour_from_state(const std::string& state,
                                             const Scene& scene);

}  // namespace brachisto::sweep
