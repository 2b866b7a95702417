// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The lists of the section `work_precision`.

#pragma once

#include "io/key_spec.hpp"

namespace brachisto::io {

/// `methods`: names, of which rolling_time and fsolve may be followed by a list
/// of degrees and of arms.
[[nodiscard]] Binding methods_list();

/// `meshes` and `tolerances`.
[[nodiscard]] Binding meshes_list();
[[nodiscard]] Binding tolerances_list();

}  // namespace brachisto::io
