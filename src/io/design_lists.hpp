// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The lists of the section `design`.

#pragma once

#include "brachisto/study/design_plan.hpp"
#include "io/key_spec.hpp"

namespace brachisto::io {

/// `free`: names of properties, each once, or maps with a part and its key.
[[nodiscard]] Binding free_list();

/// `bounds.KEY`: the least and the greatest value.
[[nodiscard]] Binding bounds_list(BodyKey key);

}  // namespace brachisto::io
