// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "model/cycloid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/roots.hpp"

namespace brachisto {

namespace {

constexpr double kPi = std::numbers::pi;

/// (ψ − sin ψ)/ψ² without cancellation for small ψ.
double psi_minus_sin_over_square(double psi) {
  if (psi > 0.5) return (psi - std::sin(psi)) / (psi * psi);
  // Taylor series; ten terms leave less than an ulp for ψ ≤ 1/2.
  const double square = psi * psi;
  double term = psi / 6.0;
  double sum = term;
  for (int i = 4; i < 24; i += 2) {
    term *= -square / (i * (i + 1));
    sum += term;
  }
  return sum;
}

/// ψ − sin ψ likewise.
double psi_minus_sin(double psi) {
  return psi > 0.5 ? psi - std::sin(psi)
                   : psi * psi * psi_minus_sin_over_square(psi);
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
    const double chord = psi > 0.0 ? std::sin(0.5 * psi) / psi : 0.5;
    return dz * psi_minus_sin_over_square(psi) - 2.0 * dx * chord * chord;
  };
  const double psi =
      math::find_root(mismatch, 0.0, 2.0 * kPi, -0.5 * dx, dz / (2.0 * kPi));
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
  // (L − r)² + H² ≤ r²
  if (H * H <= L * (2.0 * r - L)) return std::nullopt;
  // With the angle α by which the track at B is off the vertical, so that
  // cos φ = sin α, and ψ = π − 2φ is 2α where it leads steeply down, 2π − 2α
  // where it leads steeply up: digits of φ − π/2 and φ + π/2 are kept.
  const auto psi_of = [](double alpha, bool up) {
    return up ? 2.0 * (kPi - alpha) : 2.0 * alpha;
  };
  const auto reach_of = [&](double alpha, bool up) {
    const double bulge = r * one_minus_cos(alpha);
    return up ? L - 2.0 * r + bulge : L - bulge;
  };
  const auto drop_of = [&](double alpha) { return H - r * std::sin(alpha); };
  // The equation divided by α², which keeps the sign of the limit at α = 0
  // where the track leads down.
  const auto second_term = [&](double alpha, bool up) {
    const double ratio = alpha > 0.0 ? std::sin(alpha) / alpha : 1.0;
    return -2.0 * ratio * ratio * reach_of(alpha, up);
  };
  const auto mismatch = [&](double alpha, bool up) {
    const double psi = psi_of(alpha, up);
    const double share = up ? psi_minus_sin(psi) / (alpha * alpha)
                            : 4.0 * psi_minus_sin_over_square(psi);
    return drop_of(alpha) * share + second_term(alpha, up);
  };
  // To where the track is level, or where the end is as high as the start: then
  // the first term vanishes.
  const bool below = r < H;
  const double last = below ? 0.5 * kPi : std::asin(H / r);
  const bool up = below ? mismatch(last, false) < 0.0 : L > r;
  const double at_last = below ? mismatch(last, false) : second_term(last, up);
  // Upwards the first term grows like 2π H/α²: here it is ¾ π H/α² ≥ 3 L or
  // more, and the second 2 L or less.
  const double first =
      up ? std::min({0.5 * last, 0.5 * H / r, std::sqrt(0.25 * kPi * H / L)})
         : 0.0;
  const auto of_alpha = [&](double alpha) { return mismatch(alpha, up); };
  const double alpha =
      math::find_root(of_alpha, first, last, of_alpha(first), at_last);
  const double psi = psi_of(alpha, up);
  // The better conditioned of the two equations gives the radius.
  const double a = up ? reach_of(alpha, up) / psi_minus_sin(psi)
                      : drop_of(alpha) / one_minus_cos(psi);
  return CycloidArc{{r, 0.0}, a, psi};
}

}  // namespace brachisto
