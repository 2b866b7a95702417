// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The parts of a body.

#pragma once

#include "io/findings.hpp"
#include "io/key_spec.hpp"
#include "io/yaml_tree.hpp"

namespace brachisto::io {

inline constexpr const char* kPartsKey = "scene.body.parts";

/// Makes parts of the texts that were read, now that the radius is known, and
/// from them the body.
void read_body_parts(const YamlValue& root, Draft& problem, Findings& findings);

}  // namespace brachisto::io
