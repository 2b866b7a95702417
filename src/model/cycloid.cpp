// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/model/cycloid.hpp"

#include <cmath>
#include <numbers>

#include "brachisto/math/roots.hpp"

namespace brachisto {

namespace {

constexpr double kPi = std::numbers::pi;

/// ψ − sin ψ without cancellation for small ψ.
double psi_minus_sin(double psi) {
  if (psi > 0.5) return psi - std::sin(psi);
  // Taylor series; ten terms leave less than an ulp for ψ ≤ 1/2.
  const double square = psi * psi;
  double term = psi * square / 6.0;
  double sum = term;
  for (int i = 4; i < 24; i += 2) {
    term *= -square / (i * (i + 1));
    sum += term;
  }
  return sum;
}

/// 1 − cos ψ without cancellation.
double one_minus_cos(double psi) {
  const double s = std::sin(0.5 * psi);
  return 2.0 * s * s;
}

}  // namespace

Point CycloidArc::at(double psi) const {
  return {start.x + a * psi_minus_sin(psi), start.z + a * one_minus_cos(psi)};
}

double CycloidArc::slope_angle(double psi) const {
  return 0.5 * (kPi - psi);
}

double CycloidArc::arc_length(double psi) const {
  return 4.0 * a * one_minus_cos(0.5 * psi);
}

double CycloidArc::rolling_time(double gravity) const {
  return psi_end * std::sqrt(a / gravity);
}

double CycloidArc::fall_speed(double gravity, double psi) const {
  return 2.0 * std::sqrt(gravity * a) * std::sin(0.5 * psi);
}

std::optional<CycloidArc> cycloid_between(Point start, Point end) {
  const double dx = end.x - start.x;
  const double dz = end.z - start.z;
  if (!(dx > 0.0) || !(dz > 0.0)) return std::nullopt;

  // dz (ψ − sin ψ) − dx (1 − cos ψ) falls first, then rises to 2π dz > 0 at
  // 2π; divided by ψ² it is −dx/2 < 0 at 0 and has one sign change.
  const auto mismatch = [&](double psi) {
    if (psi == 0.0) return -0.5 * dx;
    return (dz * psi_minus_sin(psi) - dx * one_minus_cos(psi)) / (psi * psi);
  };
  const double psi = math::find_root(mismatch, 0.0, 2.0 * kPi);
  // The better conditioned of the two equations gives the radius.
  const double a =
      psi < kPi ? dz / one_minus_cos(psi) : dx / psi_minus_sin(psi);
  return CycloidArc{start, a, psi};
}

std::optional<CycloidArc> axisymmetric_optimum(const Scene& scene) {
  if (scene.contact == Contact::Centre) {
    return cycloid_between({0.0, 0.0}, {scene.L, scene.H});
  }
  const double r = scene.body.radius;
  const double L = scene.L;
  const double H = scene.H;
  if (std::hypot(L - r, H) <= r) return std::nullopt;
  // The end lies below the start only where cos φ < H/r: for a large radius an
  // end slope either steeply up or, if B is left of the centre, steeply down.
  double first = -0.5 * kPi;
  double last = 0.5 * kPi;
  if (r >= H) (L > r ? last : first) = std::copysign(std::acos(H / r), r - L);
  // In terms of ψ = π − 2φ: sin 2φ = sin ψ, so π − 2φ − sin 2φ = ψ − sin ψ, and
  // cos φ = sin ψ/2. Divided by sin²(ψ/2), which keeps the sign of the limit at
  // φ = π/2.
  const auto mismatch = [&](double phi) {
    const double psi = kPi - 2.0 * phi;
    const double c = std::cos(phi);
    const double reach = L - r + r * std::sin(phi);
    if (psi < 1e-8) return -2.0 * reach;
    return (H - r * c) * psi_minus_sin(psi) / (c * c) - 2.0 * reach;
  };
  // At φ = −π/2 the first term grows like 2π H / cos²φ: step in from there.
  if (first == -0.5 * kPi) {
    first = 0.5 * (first + last);
    while (mismatch(first) < 0.0) first = 0.5 * (first - 0.5 * kPi);
  }
  const double phi = math::find_root(mismatch, first, last);
  const double c = std::cos(phi);
  return CycloidArc{{r, 0.0}, (H - r * c) / (2.0 * c * c), kPi - 2.0 * phi};
}

}  // namespace brachisto
