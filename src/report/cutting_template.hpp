// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A track to be built: sheets with its pieces, whose upper edge is rolled on,
/// and with the body; and how they are put together.

#pragma once

#include <span>
#include <vector>

#include "brachisto/model/body.hpp"
#include "brachisto/study/solution.hpp"
#include "report/cutting_build.hpp"
#include "report/cutting_drawing.hpp"

namespace brachisto::report::cutting {

/// What can be refused before a scene is solved: holes that a strip has no room
/// for, a body that is larger than a sheet, a model of a scene whose model
/// would roll otherwise.
/// \throws TemplateError
void check_build(const Build& build, const Scene& scene);

/// The sheets to cut, "sheet-01" and so on, then those that tell how parts are
/// put together, "assembly-01" and so on. All of them tell the body, the grip
/// that it needs, where it presses least and most, and what an error of 1 mm
/// does to the time, each as it is built: of a model of scale λ in a uniform
/// field, times are √λ of those of the scene. docs/building.md says the rest.
///
/// \param solution  verified
/// \param made_of   the body, in metres; may be empty
/// \throws TemplateError
[[nodiscard]] std::vector<Drawing> cutting_template(
    const Solution& solution, std::span<const MassPart> made_of,
    const Build& build);

}  // namespace brachisto::report::cutting
