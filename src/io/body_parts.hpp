// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The parts of a body, in problem files and on the command line.

#pragma once

#include <string>
#include <string_view>

#include "brachisto/model/body.hpp"
#include "io/findings.hpp"
#include "io/key_spec.hpp"
#include "io/yaml_tree.hpp"

namespace brachisto::io {

/// A part from words such as "point:m=1,at=0.9@-30 deg", "ring", or
/// "disc:radius=1/2,x=0.3,z=0.1": a kind, then names and values, each once.
/// Values are expressions of constants; a place is DISTANCE@ANGLE as seen from
/// the axis, angles from +x towards +z (down). What is not said: m = 1, on the
/// axis, as large as the cylinder.
///
/// \param radius  of the cylinder, in the unit of length of the part
/// \return the part, named by its text
/// \throws std::invalid_argument  says what is wrong and what is allowed, but
///         not in which part
[[nodiscard]] MassPart read_mass_part(std::string_view text, double radius);

/// What a part may be, one kind per line, for help and messages.
[[nodiscard]] std::string mass_part_grammar();

inline constexpr const char* kPartsKey = "scene.body.parts";

/// Makes parts of the texts that were read, now that the radius is known, and
/// from them the body.
void read_body_parts(const YamlValue& root, Draft& problem, Findings& findings);

}  // namespace brachisto::io
