// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A picture of the path.

#pragma once

#include <string>

#include "brachisto/trajectory/motion.hpp"

namespace brachisto::report {

/// The track, the path of the centre and, for an off-centred body, that of the
/// centre of mass, to scale, z down, with the body drawn at both ends. A
/// self-contained SVG document that stays legible in grey.
[[nodiscard]] std::string path_svg(const Motion& motion);

}  // namespace brachisto::report
