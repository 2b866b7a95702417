// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Newton's and Krawczyk's methods for as many equations as unknowns, all
/// numbers being balls.

#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "proof/tape.hpp"

namespace brachisto::proof {

using Vector = std::vector<Real>;
using Matrix = std::vector<Vector>;

/// Of a matrix near the middle of one, without any promise.
/// \throws NotProven  if that is singular
[[nodiscard]] Matrix inverse_of_middle(const Matrix& of);

[[nodiscard]] Vector product(const Matrix& a, const Vector& v);

/// In units of these, powers of two.
[[nodiscard]] double largest(const Vector& of,
                             const std::vector<double>& units);

[[nodiscard]] Vector middle_of(const Vector& box);

/// Krawczyk's operator on a box X about m:
///
///     K = m − C F(m) + (1 − C F'(X)) (X − m),
///
/// \param inverse  C, any matrix
/// \param missed   encloses F(m)
/// \param slopes   enclose F'(X)
/// \return K, which holds every root that X holds
[[nodiscard]] Vector krawczyk_operator(const Vector& box, const Matrix& inverse,
                                       const Vector& missed,
                                       const Matrix& slopes);

/// The same.
/// \return K, which lies in the interior of X: then it holds exactly one root
/// \throws TooFewBits  if it does not
[[nodiscard]] Vector krawczyk_image(const Vector& box, const Matrix& inverse,
                                    const Vector& missed, const Matrix& slopes);

using KrawczykOperator = Vector (*)(const Vector& box, const Matrix& inverse,
                                    const Vector& missed, const Matrix& slopes);

/// Newton's method with one inverse, to the digits of half the bits.
/// \param at     [in,out] middles alone
/// \param units  of each
/// \param miss   F there, nearly
template <class Miss>
void converge(Vector& at, const std::vector<double>& units,
              const Matrix& inverse, int bits, const Miss& miss) {
  constexpr int kMostSteps = 12;
  const double enough = std::ldexp(1.0, -bits / 2);
  double step = 1.0;
  for (int i = 0; i < kMostSteps && step > enough; ++i) {
    const Vector by = product(inverse, miss(at));
    step = largest(by, units);
    if (!(step < 1.0)) throw NotProven("Newton's method does not converge");
    for (std::size_t k = 0; k < at.size(); ++k) {
      at[k] = (at[k] - by[k]).middle();
    }
  }
  if (!(step <= enough)) {
    throw TooFewBits("Newton's method stops short of the precision");
  }
}

/// shown(box) of a box about a point: the usual one, or where wrapping is bad
/// one that is not much wider than what one integration leaves open.
template <class Open, class Shown>
[[nodiscard]] auto in_a_box(const Vector& at, const std::vector<double>& units,
                            int bits, const Open& open, const Shown& shown) {
  constexpr double kTimes = 1024.0;
  const auto box_about = [&](double radius) {
    Vector box;
    for (std::size_t k = 0; k < at.size(); ++k) {
      box.push_back(at[k].widened(Real(radius * units[k])));
    }
    return box;
  };
  const double usual = std::ldexp(1.0, -(2 * bits) / 5);
  try {
    return shown(box_about(usual));
  } catch (const NotProven&) {
    const double radius = kTimes * largest(open(), units);
    if (!(radius < usual)) throw;
    return shown(box_about(radius));
  }
}

}  // namespace brachisto::proof
