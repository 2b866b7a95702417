// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Keys of a result document, part by part.

#pragma once

#include "report/result_field.hpp"

namespace brachisto::report {

/// Of the answer: its motion, forces, limits and derivatives, and its mesh.
[[nodiscard]] Fields<Solution> answer_fields();
/// The work that a solve took.
[[nodiscard]] Fields<Solution> effort_fields();
/// Where the solve came by, and answers beside the answer.
[[nodiscard]] Fields<Solution> search_fields();
/// Of `brachisto design`; no key of another result.
[[nodiscard]] Field<Solution> design_field();
[[nodiscard]] Field<Solution> seconds_field();

}  // namespace brachisto::report
