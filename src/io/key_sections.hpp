// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The parts of the table of keys.

#pragma once

#include <vector>

#include "io/key_spec.hpp"

namespace brachisto::io {

[[nodiscard]] std::vector<KeySpec> scene_keys();
[[nodiscard]] std::vector<KeySpec> discretisation_keys();
[[nodiscard]] std::vector<KeySpec> solver_keys();
[[nodiscard]] std::vector<KeySpec> fsolve_keys();
[[nodiscard]] std::vector<KeySpec> work_precision_keys();

}  // namespace brachisto::io
