// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The paper's closing question: the quickest of all bodies between two points.

#pragma once

#include <optional>
#include <vector>

#include "brachisto/study/design_answer.hpp"
#include "reproduction/cases.hpp"

namespace brachisto::reproduction {

/// Starts of each search: the reference body and random ones.
inline constexpr int kDesignStarts = 5;

/// Over all places of the centre of mass, the radius being given.
struct QuickestBody {
  double L = 0.0;      ///< [H]
  bool any_k = false;  ///< else that of the reference case
  /// The fastest that was found and that can run on its track, on the principal
  /// branch; nothing if the searches ended otherwise.
  std::optional<DesignMinimum> found;
};

/// For L = 2, 3 and 4.
/// \throws Interrupted
[[nodiscard]] std::vector<QuickestBody> quickest_bodies(
    Scene reference, const Interrupt& interrupt);

}  // namespace brachisto::reproduction
