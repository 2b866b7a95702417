// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What those are called that race.

#pragma once

#include <string>
#include <vector>

namespace brachisto::plot {

/// A name for each problem file: "uniform cylinder" of uniform_cylinder.yaml,
/// with as many of its folders before it as tell it from the others,
/// "steep/uniform cylinder". Files that no folder tells apart, such as
/// a.yaml and a.yml, are called as they are given.
[[nodiscard]] std::vector<std::string> racer_names(
    const std::vector<std::string>& files);

}  // namespace brachisto::plot
