// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The formulas of the nonlinear programs, each for numbers and for whatever
/// else is computed with: of pieces and contacts, what a program evaluates and
/// what is written down of it are one text. Rates are written down from that of
/// the rolling body.

#pragma once

#include <cmath>

#include "brachisto/model/body.hpp"

namespace brachisto {

/// (r Δθ)² A of a straight piece, with its slope's sine and cosine written out.
///
/// \param length                r Δθ
/// \param sin_theta, cos_theta  in the middle of the piece
template <class Scalar>
[[nodiscard]] Scalar piece_square(const Body& body, const Scalar& dx,
                                  const Scalar& dz, const Scalar& length,
                                  const Scalar& sin_theta,
                                  const Scalar& cos_theta) {
  const double eta = body.eta_m;
  return length * ((1.0 + eta * eta + body.k) * length -
                   2.0 * eta * (sin_theta * dx - cos_theta * dz));
}

/// By what r Δθ √A is multiplied for the time of a piece: one over the mean of
/// the speeds at its ends.
template <class Scalar>
[[nodiscard]] Scalar inverse_mean_speed(const Scalar& before,
                                        const Scalar& after) {
  return 2.0 / (before + after);
}

/// No slip of a piece: the error of its length.
template <class Scalar>
[[nodiscard]] Scalar slip(const Scalar& dx, const Scalar& dz,
                          const Scalar& length, double reference_length) {
  return 0.5 * (dx * dx + dz * dz - length * length) / reference_length;
}

/// The place of a node, r θ − S σ².
template <class Scalar>
[[nodiscard]] Scalar misplacement(double radius, const Scalar& turned,
                                  const Scalar& S, double sigma) {
  return radius * turned - S * sigma * sigma;
}

/// By how far the centre is off its place above a contact, where the slope is
/// β: eqs. (11)–(12).
template <class Scalar>
struct OffContact {
  Scalar x, z;
};
template <class Scalar>
[[nodiscard]] OffContact<Scalar> off_contact(const Scalar& x, const Scalar& z,
                                             double radius, double contact_x,
                                             double contact_z,
                                             const Scalar& beta) {
  using std::cos;
  using std::sin;
  return {x - contact_x - radius * sin(beta),
          z - contact_z + radius * cos(beta)};
}

}  // namespace brachisto
