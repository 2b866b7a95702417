// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Scenes of a sweep that are solved side by side.

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "brachisto/io/problem_file.hpp"
#include "brachisto/study/solution.hpp"

namespace brachisto::sweep {

/// Whether any scene of a sweep may be.
[[nodiscard]] bool asks_for_lanes(const io::SweepFile& file);

/// What lanes make of scenes, many at a time, in the order of these.
class Lanes {
 public:
  /// \param asked  whether anything may be solved so
  Lanes(const io::SweepFile& file, bool asked, std::size_t first,
        std::size_t last)
      : file_(file), asked_(asked), next_(first), last_(last) {}

  /// The solution of the next scene, or nothing.
  [[nodiscard]] std::optional<Solution> next();

 private:
  static constexpr std::size_t kAtOnce = 64;

  void look_ahead();

  const io::SweepFile& file_;
  bool asked_;
  std::size_t next_, last_, place_ = 0;
  std::vector<std::optional<Solution>> found_;
};

}  // namespace brachisto::sweep
