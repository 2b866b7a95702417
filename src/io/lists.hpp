// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Keys that are lists.

#pragma once

#include "brachisto/study/design.hpp"
#include "io/key_spec.hpp"

namespace brachisto::io {

/// scene.body.parts: texts, which stand for parts until the radius is known.
[[nodiscard]] Binding parts_list();

/// scene.path.points: a list of [x, z].
[[nodiscard]] Binding points_list();

/// scene.limits.clear_of: discs and half planes, each a map with its one key.
[[nodiscard]] Binding clear_of_list();

/// design.free: names of quantities of a body, or maps {part: 2, key: at}.
[[nodiscard]] Binding free_list();

/// design.bounds.eta_m and so on: two numbers, or two angles.
[[nodiscard]] Binding bounds_list(BodyKey key);

/// work_precision.methods: names, or a map of one of them with its degrees.
[[nodiscard]] Binding methods_list();

/// work_precision.meshes and .tolerances: numbers, each once, from coarse to
/// fine.
[[nodiscard]] Binding meshes_list();
[[nodiscard]] Binding tolerances_list();

}  // namespace brachisto::io
