// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What a campaign says as a whole.

#pragma once

#include <string>
#include <vector>

#include "campaign/record.hpp"

namespace brachisto::benchmarks {

struct Examined {
  int index = 0;
  Scene scene;
  Record record;
};

/// Share of scenes with a cycloid that must be solved and verified.
inline constexpr double kWantedShare = 0.995;

struct Verdicts {
  int with_cycloid = 0;  ///< what shares refer to
  int verified = 0;
  int disagreeing = 0;

  [[nodiscard]] double share() const {
    return with_cycloid == 0 ? 0.0
                             : static_cast<double>(verified) / with_cycloid;
  }
  [[nodiscard]] bool passed() const {
    return share() >= kWantedShare && disagreeing == 0;
  }
};

[[nodiscard]] Verdicts count(const std::vector<Examined>& all);

/// Tables of shares, differences and times, and every scene that is not a plain
/// success, by name and reason. Markdown.
[[nodiscard]] std::string summary(const std::vector<Examined>& all);

}  // namespace brachisto::benchmarks
