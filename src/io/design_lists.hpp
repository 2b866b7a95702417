// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The lists of the section `design`, the parts of a body, and what a design
/// asks of a scene.

#pragma once

#include "brachisto/study/design_plan.hpp"
#include "io/findings.hpp"
#include "io/key_spec.hpp"
#include "io/yaml_tree.hpp"

namespace brachisto::io {

/// `free`: names of properties, each once, or maps with a part and its key.
[[nodiscard]] Binding free_list();

/// scene.body.parts: parts as `brachisto body` takes them.
[[nodiscard]] Binding parts_list();

/// Makes parts of the texts that were read, now that the radius is known, and
/// from them the body.
void read_body_parts(const YamlValue& root, Draft& problem, Findings& findings);

/// `bounds.KEY`: the least and the greatest value.
[[nodiscard]] Binding bounds_list(BodyKey key);

/// Refuses designs without a best body, and ways of solving that a design does
/// not go.
void check_design(const YamlValue& root, const Draft& problem,
                  Findings& findings);

}  // namespace brachisto::io
