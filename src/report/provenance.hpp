// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What a result was made with.

#pragma once

#include <string>

#include "report/result_field.hpp"

namespace brachisto::report {

/// Versions of this program and of everything numbers depend on.
struct Provenance {
  std::string brachisto;
  std::string ipopt;
  std::string mumps;
  std::string blas;  ///< file that dgemm was loaded from, or what it says
  std::string suitesparse;
  std::string compiler;
};

[[nodiscard]] Provenance provenance();

/// Its keys in documents.
[[nodiscard]] Fields<Provenance> version_fields();

/// The same as a JSON document.
[[nodiscard]] std::string provenance_json();

}  // namespace brachisto::report
