// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What the names in the expressions of a sweep stand for.

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "io/findings.hpp"
#include "io/quantities.hpp"
#include "io/sweep_section.hpp"
#include "io/yaml_tree.hpp"

namespace brachisto::io {

/// How the values of a scene follow from each other.
struct SweepNames {
  std::vector<std::size_t> order;  ///< entries, each behind those it depends on
  QuantityValues fixed{};          ///< of the quantities that do not vary
};

/// Finds the value of each name: that of the key in the same scene, from the
/// sweep if the key varies, else from the file.
///
/// \param root  tree of the file; what it has for keys that vary is not used
/// \return nothing if a value is missing or depends on itself; the reason is
///         among the findings
[[nodiscard]] std::optional<SweepNames> resolve_names(
    const SweepSection& section, const YamlValue& root, Findings& findings);

}  // namespace brachisto::io
