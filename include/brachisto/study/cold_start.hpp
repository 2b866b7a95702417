// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Where a start other than the cycloid led.

#pragma once

#include <optional>

#include "brachisto/solvers/status.hpp"

namespace brachisto {

/// A start other than the cycloid, and where it led on a coarse mesh.
struct ColdStart {
  Status status = Status::NotConverged;
  std::optional<double> tau;  ///< on the coarse mesh, if it converged
  bool principal = false;     ///< it led to the principal branch
};

}  // namespace brachisto
