// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A result for a person to read.

#pragma once

#include <string>

#include "brachisto/study/solve.hpp"

namespace brachisto::report {

/// A dozen lines: the scene, the answer if it is verified, how it was found,
/// and what each check of the certificate said if one failed.
[[nodiscard]] std::string summary(const Solution& solution);

}  // namespace brachisto::report
