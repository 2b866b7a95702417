// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "proof/linear.hpp"

#include <arb_mat.h>

namespace brachisto::proof {

Matrix inverse_of_middle(const Matrix& of) {
  const auto size = static_cast<slong>(of.size());
  arb_mat_t a, b;
  arb_mat_init(a, size, size);
  arb_mat_init(b, size, size);
  for (slong i = 0; i < size; ++i) {
    for (slong j = 0; j < size; ++j) {
      const Real& entry =
          of[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
      arb_set(arb_mat_entry(a, i, j), entry.middle().get());
    }
  }
  const bool regular = arb_mat_inv(b, a, working_bits) != 0;
  Matrix out(of.size(), Vector(of.size()));
  for (slong i = 0; regular && i < size; ++i) {
    for (slong j = 0; j < size; ++j) {
      Real& entry =
          out[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
      arb_set(entry.get(), arb_mat_entry(b, i, j));
      entry = entry.middle();
    }
  }
  arb_mat_clear(a);
  arb_mat_clear(b);
  if (!regular) throw NotProven("the equations of the ends are singular");
  return out;
}

Vector product(const Matrix& a, const Vector& v) {
  Vector out(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < v.size(); ++j) out[i] += a[i][j] * v[j];
  }
  return out;
}

double largest(const Vector& of, const std::vector<double>& units) {
  double out = 0.0;
  for (std::size_t i = 0; i < of.size(); ++i) {
    out = std::max(out, of[i].abs().upper() / units[i]);
  }
  return out;
}

Vector middle_of(const Vector& box) {
  Vector out;
  for (const Real& each : box) out.push_back(each.middle());
  return out;
}

Vector krawczyk_operator(const Vector& box, const Matrix& inverse,
                         const Vector& missed, const Matrix& slopes) {
  const std::size_t size = box.size();
  const Vector step = product(inverse, missed);
  Vector out(size);
  for (std::size_t i = 0; i < size; ++i) {
    Real rest;
    for (std::size_t k = 0; k < size; ++k) {
      Real contracts(i == k ? 1.0 : 0.0);
      for (std::size_t j = 0; j < size; ++j) {
        if (arb_is_zero(slopes[j][k].get()) != 0) continue;
        contracts = contracts - inverse[i][j] * slopes[j][k];
      }
      rest += contracts * (box[k] - box[k].middle());
    }
    out[i] = box[i].middle() - step[i] + rest;
  }
  return out;
}

Vector krawczyk_image(const Vector& box, const Matrix& inverse,
                      const Vector& missed, const Matrix& slopes) {
  Vector out = krawczyk_operator(box, inverse, missed, slopes);
  for (std::size_t i = 0; i < box.size(); ++i) {
    if (!out[i].finite() || !out[i].inside(box[i])) {
      throw TooFewBits(
          "Krawczyk's operator does not map the box into itself: it holds no "
          "root, or the precision is too low");
    }
  }
  return out;
}

}  // namespace brachisto::proof
