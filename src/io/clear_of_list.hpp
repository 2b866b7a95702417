// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What the body has to keep clear of.

#pragma once

#include "io/key_spec.hpp"

namespace brachisto::io {

/// The key scene.limits.clear_of: a list of {disc: {x, z, radius}} and
/// {half_plane: {x, z, normal}}.
[[nodiscard]] Binding clear_of_list();

}  // namespace brachisto::io
