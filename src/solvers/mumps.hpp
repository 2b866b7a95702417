// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Symmetric matrices of any structure, by MUMPS.

#pragma once

#include <dmumps_c.h>

#include <span>
#include <vector>

#include "solvers/inertia.hpp"

namespace brachisto {

/// A sequential MUMPS instance for one general symmetric matrix.
class Mumps {
 public:
  using Call = void (*)(DMUMPS_STRUC_C*);

  /// \param call  dmumps_c(), of the release whose header this was built with
  /// \throws std::runtime_error  if it is another release
  explicit Mumps(Call call);
  ~Mumps();
  Mumps(const Mumps&) = delete;
  Mumps& operator=(const Mumps&) = delete;

  /// Lower or upper triangle by 1-based coordinates.
  Inertia factorise(int size, std::vector<int> rows, std::vector<int> cols,
                    std::vector<double> values);
  /// Replaces the right side by the solution.
  /// \pre factorised
  void solve(std::span<double> x);

 private:
  MUMPS_INT& icntl(int number) { return data_.icntl[number - 1]; }
  void run(int job);

  Call call_;
  std::vector<int> rows_, cols_;
  std::vector<double> values_;
  DMUMPS_STRUC_C data_ = {};
};

}  // namespace brachisto
