// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What a track and its scene are, in words.

#pragma once

#include <string>
#include <string_view>

#include "brachisto/model/scene.hpp"

namespace brachisto::report {

/// "smooth-contact extremal", "given path", …: how titles and summaries call
/// the track of a scene. A smooth contact is a root and no minimum: where the
/// body rolls, bending the track next to B makes it faster still
/// (docs/theory.md, section 3), as far as limits let it. The fastest one is
/// that of a bead, or what the contact of the scene asks for (section 11).
[[nodiscard]] std::string_view track_kind(const Scene& scene);

/// Body and scene in one line: "cylinder r = 0.5 m, η_m = …; L = 3 m, …".
[[nodiscard]] std::string in_words(const Scene& scene);

/// "|R_t| ≤ 0.5 R_n, R_n from 0.1 to 5 m g, clear of 2 discs"; empty without
/// limits.
[[nodiscard]] std::string limits_in_words(const Scene& scene);

}  // namespace brachisto::report
