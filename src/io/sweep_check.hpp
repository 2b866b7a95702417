// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Checks of the scenes of a sweep.

#pragma once

#include "io/draft.hpp"
#include "io/findings.hpp"
#include "io/sweep_scenes.hpp"
#include "io/yaml_tree.hpp"

namespace brachisto::io {

/// How many scenes with a mistake in the same key are told; others are counted.
inline constexpr std::size_t kShownScenes = 3;

/// Checks what all scenes share, as far as it does not depend on keys that
/// vary.
///
/// \param root  tree of the file that has an entry for each key that varies
/// \param base  the problem as far as it does not vary
void check_shared(const SweepSection& section, const YamlValue& root,
                  const Draft& base, Findings& findings);

/// Checks each scene as if it were a problem file of its own.
void check_scenes(const SweepScenes& scenes, const YamlValue& root,
                  const Draft& base, Findings& findings);

}  // namespace brachisto::io
