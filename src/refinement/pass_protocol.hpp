// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The protocol of a refinement while it is written.

#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>

#include "brachisto/run/solve_options.hpp"
#include "refinement/refinement.hpp"

namespace brachisto {

/// What passes report to. They add to one record until it is kept, those that
/// failed on the way included.
struct PassProtocol : RefinementProtocol {
  MeshRecord record;      ///< of the passes since the last one was kept
  ProgressHook progress;  ///< may be empty

  explicit PassProtocol(ProgressHook hook) : progress(std::move(hook)) {}

  /// \return false, for callers that tell so whether they found anything
  bool fail(Status why, std::string text) {
    status = why;
    message = std::move(text);
    return false;
  }
  /// Adds a pass of Ipopt.
  void add(const SolverResult& result) {
    record.iterations += result.iterations;
    ++record.passes;
    record.linear_solver = result.linear_solver;
    log += result.log;
  }
  /// Ends the record of a mesh on which the transit time is T.
  void keep_record(const char* phase, double T) {
    meshes.push_back(std::exchange(record, {}));
    if (progress) {
      progress(phase, fmt::format("{} elements, T = {:.10g}",
                                  meshes.back().elements, T));
    }
  }
  /// With the record of passes that led nowhere, if there are such.
  [[nodiscard]] RefinementProtocol finished() && {
    if (record.passes > 0) meshes.push_back(record);
    return std::move(*this);
  }
};

}  // namespace brachisto
