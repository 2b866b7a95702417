// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How an attempt by the indirect method ends, whatever its equations.

#pragma once

#include <string_view>
#include <utility>

#include "extremal/shooting.hpp"

namespace brachisto::shooting {

/// A solution in the making.
class ExtremalAttempt {
 public:
  [[nodiscard]] ExtremalSolution take() { return std::move(solution_); }

  /// Runs `ways` of it within its own stop condition.
  template <class Ways>
  [[nodiscard]] ExtremalSolution within_its_stop(Ways&& ways) {
    const StopScope scope(options_.stop);
    try {
      ways();
    } catch (const Stopped&) {
      if (!options_.stop.met()) throw;
      stop("within an arc");
    }
    return take();
  }

 protected:
  /// \param options  must outlive this
  explicit ExtremalAttempt(const ExtremalOptions& options)
      : options_(options) {}

  void fail(ExtremalStatus status, std::string_view details);
  void stop(std::string_view where);
  /// What a path that meets the equations is worth, once it is part of the
  /// solution, with its error.
  void judge();

  const ExtremalOptions& options_;
  ExtremalSolution solution_;
};

}  // namespace brachisto::shooting
