// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Many scenes, each by the method that its file asks for, in one table.

#pragma once

#include <string>
#include <vector>

#include "comparison/comparison.hpp"
#include "comparison/measurement.hpp"
#include "report/text_table.hpp"

namespace brachisto::comparison {

struct SolvedScene {
  std::string file;
  Measurement run;
};

/// Each in a process of its own, one after the other. A file with mistakes is
/// one that is refused.
/// \param seconds  wall-clock limit of each
/// \throws io::IoError, Interrupted
[[nodiscard]] std::vector<SolvedScene> solve_scenes(
    const std::vector<std::string>& files,
    const std::vector<std::string>& overrides, double seconds,
    const Hooks& hooks);

/// A row for each scene, and how many are verified.
[[nodiscard]] std::string summary(
    const std::vector<SolvedScene>& scenes,
    report::TableForm form = report::TableForm::Text);
[[nodiscard]] std::string to_json(const std::vector<SolvedScene>& scenes);

}  // namespace brachisto::comparison
