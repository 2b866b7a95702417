// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "solvers/mumps.hpp"

#include <stdexcept>
#include <string>
#include <utility>

namespace brachisto {

Mumps::Mumps(Call call) : call_(call) {
  data_.par = 1;
  data_.sym = 2;
  data_.comm_fortran = -987654;  // MPI_COMM_WORLD, in MUMPS' own words
  run(-1);
  if (std::string_view(data_.version_number) != MUMPS_VERSION) {
    const std::string other = data_.version_number;
    run(-2);
    throw std::runtime_error("MUMPS " MUMPS_VERSION " is needed, and this is " +
                             other);
  }
  // No output; QAMD ordering, as in the solver; rows and columns scaled
  // together, which keeps the inertia and lets pivots next to a start where
  // lengths vanish be told from null ones; report these; room for delayed
  // pivots.
  icntl(1) = icntl(2) = icntl(3) = -1;
  icntl(4) = 0;
  icntl(6) = 0;
  icntl(7) = 6;
  icntl(8) = 7;
  icntl(13) = 1;  // count negative pivots of the root exactly
  icntl(14) = 100;
  icntl(24) = 1;
}

Mumps::~Mumps() {
  run(-2);
}

void Mumps::run(int job) {
  data_.job = job;
  call_(&data_);
}

Inertia Mumps::factorise(int size, std::vector<int> rows, std::vector<int> cols,
                         std::vector<double> values) {
  rows_ = std::move(rows);
  cols_ = std::move(cols);
  values_ = std::move(values);
  data_.n = size;
  data_.nz = static_cast<int>(rows_.size());
  data_.irn = rows_.data();
  data_.jcn = cols_.data();
  data_.a = values_.data();
  run(4);
  // Pivots that are put off, as in a singular matrix, need more room than the
  // analysis foresees.
  constexpr int kTooFewIntegers = -8, kTooLittleRoom = -9, kMostTries = 4;
  MUMPS_INT& room = icntl(14);  // in per cent
  const MUMPS_INT first = room;
  for (int i = 0; i < kMostTries && (data_.infog[0] == kTooLittleRoom ||
                                     data_.infog[0] == kTooFewIntegers);
       ++i) {
    room *= 4;
    run(2);
  }
  room = first;
  Inertia inertia;
  inertia.known = data_.infog[0] >= 0;
  inertia.negative = data_.infog[12 - 1];
  inertia.zero = data_.infog[28 - 1];
  inertia.positive = size - inertia.negative - inertia.zero;
  return inertia;
}

void Mumps::solve(std::span<double> x) {
  data_.rhs = x.data();
  run(3);
}

}  // namespace brachisto
