// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "math/machine_speed.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include "math/cpu_clock.hpp"

namespace brachisto {

namespace {

constexpr std::size_t kSize = 24;
using Square = std::array<double, kSize * kSize>;

void multiply(const Square& a, const Square& b, Square& product) {
  for (std::size_t i = 0; i < kSize; ++i) {
    for (std::size_t j = 0; j < kSize; ++j) {
      double sum = 0.0;
      for (std::size_t k = 0; k < kSize; ++k) {
        sum += a[i * kSize + k] * b[k * kSize + j];
      }
      product[i * kSize + j] = sum;
    }
  }
}

/// Of a row of products, each of which waits for the one before.
double seconds_of_products() {
  constexpr int kPairs = 5;
  Square a, b, c;
  // Rows that add up to 1: products do too.
  a.fill(1.0 / kSize);
  b = a;
  const double begin = thread_cpu_seconds();
  for (int i = 0; i < kPairs; ++i) {
    multiply(a, b, c);
    multiply(c, a, b);
  }
  const volatile double result = b[0];
  static_cast<void>(result);
  return thread_cpu_seconds() - begin;
}

double measured() {
  constexpr double kReferenceSeconds = 3.6e-5;
  constexpr int kRounds = 3;  // the least is of a core that nobody shares
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kRounds; ++i) {
    least = std::min(least, seconds_of_products());
  }
  return kReferenceSeconds / std::max(least, 1e-3 * kReferenceSeconds);
}

}  // namespace

double machine_speed() {
  static const double speed = measured();
  return speed;
}

}  // namespace brachisto
