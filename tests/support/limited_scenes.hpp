// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Fastest tracks under limits by methods that share no code with this project,
// L = 3, H = 1, r = 1/3, k = 1/2.
//
//   IndirectArcs  Pontryagin's conditions on a given sequence of arcs, by
//                 multiple shooting in the rolling time; boundary residuals
//                 below 2e-13, so that τ is given to half a unit of its twelfth
//                 decimal.
//   ClosedForm    incline or floor and cycloid; see ClosedTrack.

#pragma once

#include <cmath>
#include <numbers>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "support/scenes.hpp"

namespace brachisto::testing {

struct LimitedReference {
  enum class Source { IndirectArcs, ClosedForm };

  std::string name;
  Scene scene;
  double tau;
  std::optional<double> start_angle, end_angle;
  Source source = Source::IndirectArcs;
};

inline std::ostream& operator<<(std::ostream& out,
                                const LimitedReference& row) {
  return out << row.name;
}

[[nodiscard]] inline Scene under(Scene scene, const PathLimits& limits,
                                 Contact contact = Contact::Smooth) {
  scene.limits = limits;
  scene.contact = contact;
  return scene;
}
[[nodiscard]] inline PathLimits friction(double mu) {
  PathLimits limits;
  limits.friction = mu;
  return limits;
}
[[nodiscard]] inline PathLimits least_force(double R_n) {
  PathLimits limits;
  limits.normal_min = R_n;
  return limits;
}
[[nodiscard]] inline PathLimits floor_at(double D) {
  PathLimits limits;
  limits.floor = D;
  return limits;
}
/// Bounds on the curvature of the centre's path.
[[nodiscard]] inline PathLimits bends(std::optional<double> hump,
                                      std::optional<double> valley) {
  PathLimits limits;
  limits.curvature = {hump, valley, CurvatureLimit::Of::Centre};
  return limits;
}

[[nodiscard]] inline std::vector<LimitedReference> limited_references() {
  using enum LimitedReference::Source;
  const Scene base = off_centred_scene();
  const Scene uniform = uniform_scene();
  const Scene bead = bead_scene();
  const double r = base.body.radius;
  const double vertical = 0.5 * std::numbers::pi;
  const auto optimal = [](const char* name, const Scene& scene,
                          const PathLimits& limits, double tau, double phi) {
    return LimitedReference{
        name, under(scene, limits, Contact::Optimal), tau, {}, phi};
  };
  const auto closed = [](const char* name, const Scene& scene, double tau) {
    return LimitedReference{name, scene, tau, {}, {}, ClosedForm};
  };
  return {
      {"friction_3", under(base, friction(3.0)), 5.084500171265, 1.494549892212,
       -0.092422377907},
      {"friction_1", under(base, friction(1.0)), 5.077121444734, 1.356136175036,
       -0.067202851461},
      {"friction_0.6", under(base, friction(0.6)), 5.080083167369,
       1.247273887969, -0.050066423770},
      {"friction_0.5", under(base, friction(0.5)), 5.083389161786,
       1.203721632596, -0.044789516518},
      {"friction_0.3", under(base, friction(0.3)), 5.079285150051,
       1.081817145094, -0.086810459134},
      {"normal_min_0.1", under(base, least_force(0.1)), 5.079008834130,
       1.419105953824, -0.078204021204},
      {"valley_4", under(base, bends({}, 4.0)), 5.077567831269, 1.289456156481,
       -0.058630595614},
      {"valley_2", under(base, bends({}, 2.0)), 5.092138147942, 1.128308078711,
       -0.040834795178},
      {"floor_0.9", under(base, floor_at(0.9 + r)), 5.191820076733, vertical,
       0.022778580320},
      {"floor_0.8", under(base, floor_at(0.8 + r)), 5.346466468522, vertical,
       0.152305248317},
      optimal("optimal_K2", base, bends(2.0, 2.0), 4.820765906897,
              -0.858333371),
      optimal("optimal_K4", base, bends(2.9, 4.0), 4.735922218563,
              -1.100851830),
      optimal("optimal_uniform_K2", uniform, bends(2.0, 2.0), 4.914517643914,
              -1.124803726),
      closed("uniform_friction_1", under(uniform, friction(1.0)),
             5.108997549198),
      closed("uniform_friction_0.5", under(uniform, friction(0.5)),
             5.218123394903),
      closed("uniform_friction_0.3", under(uniform, friction(0.3)),
             5.528298050285),
      closed("uniform_normal_min_0.1", under(uniform, least_force(0.1)),
             5.103524508231),
      closed("uniform_floor_1.1", under(uniform, floor_at(1.1)),
             5.288005645793),
      closed("bead_floor_1.0", under(bead, floor_at(1.0)), 4.570796326795),
      closed("bead_floor_1.1", under(bead, floor_at(1.1)), 4.527567924154),
      closed("bead_normal_min_0.1", under(bead, least_force(0.1)),
             4.510937589511),
  };
}

[[nodiscard]] inline LimitedReference limited_reference(std::string_view name) {
  for (const LimitedReference& row : limited_references()) {
    if (row.name == name) return row;
  }
  throw std::out_of_range(std::string(name));
}

/// Tracks of an axisymmetric body in closed form. The centre of a body
/// with A = 1 + k falls E below its start with w² = E where 2 g = 1, and rolls
/// along a cycloid of generating radius a from ψ₀ to ψ, slope β = π/2 − ψ/2, in
/// the rolling time √(2 a)(ψ − ψ₀); T = √A u, and τ = T/√H there.
struct ClosedTrack {
  double tau, end_angle;
};

/// The root of a function that changes its sign between low and high.
template <class Function>
[[nodiscard]] long double bisected(const Function& f, long double low,
                                   long double high) {
  const bool rises = f(low) < 0.0L;
  for (int i = 0; i < 80; ++i) {
    const long double middle = 0.5L * (low + high);
    ((f(middle) < 0.0L) == rises ? low : high) = middle;
  }
  return 0.5L * (low + high);
}

/// Down a cycloid to the floor, along it, up the same cycloid to where its
/// slope is that of the contact at B. The contact at A is vertical.
///
/// \param depth  of the floor for the centre, below the centre's start
[[nodiscard]] inline ClosedTrack closed_on_floor(const Scene& scene,
                                                 double depth) {
  using std::cos;
  using std::sin;
  using std::sqrt;
  const long double r = scene.body.radius;
  const long double a = 0.5L * depth;
  const long double pi = std::numbers::pi_v<long double>;
  // a (1 − cos ψ) = H − r cos φ with φ = π/2 − ψ/2. Where the floor is as deep
  // as B the root is π itself, to be missed by √ε of it from one side alone.
  const auto deeper = [&](long double psi) {
    return a * (1.0L - cos(psi)) - scene.H + r * sin(0.5L * psi);
  };
  const long double psi =
      deeper(pi) > 0.0L ? bisected(deeper, pi, 2.0L * pi) : pi;
  const long double phi = 0.5L * (pi - psi);
  const long double line = scene.L + r * sin(phi) - r - a * (psi - sin(psi));
  const long double u = sqrt(2.0L * a) * psi + line / sqrt(2.0L * a);
  return {static_cast<double>(sqrt((1.0L + scene.body.k) / scene.H) * u),
          static_cast<double>(phi)};
}

/// Down the incline of the slope β₀, on along a cycloid that leaves it with its
/// slope, to where the slope is that of the contact at B. It is the fastest
/// track from rest under a limit of force: with q = 0 at the edge of the static
/// cone, R_n = cos β and R_t = −sin β k/(1 + k) keep their limit as they are.
[[nodiscard]] inline ClosedTrack closed_incline(const Scene& scene,
                                                double beta_0) {
  using std::cos;
  using std::sin;
  using std::sqrt;
  const long double r = scene.body.radius;
  const long double pi = std::numbers::pi_v<long double>;
  const long double b = beta_0;
  const long double psi_0 = pi - 2.0L * b;
  struct Shape {
    long double a, incline;
  };
  const auto shape = [&](long double psi) {
    // Drop of the centre, and the part of it on the incline.
    const long double drop = scene.H - r * sin(0.5L * psi) + r * cos(b);
    const long double a = drop / (1.0L - cos(psi));
    return Shape{a, a * (1.0L - cos(psi_0)) / sin(b)};
  };
  const auto beyond = [&](long double psi) {
    const auto [a, incline] = shape(psi);
    return r * sin(b) + incline * cos(b) +
           a * (psi - sin(psi) - psi_0 + sin(psi_0)) - scene.L -
           r * cos(0.5L * psi);
  };
  const long double psi = bisected(beyond, psi_0 + 1e-3L, 2.0L * pi - 1e-2L);
  const auto [a, incline] = shape(psi);
  const long double u =
      2.0L * sqrt(incline / sin(b)) + sqrt(2.0L * a) * (psi - psi_0);
  return {static_cast<double>(sqrt(1.0L + scene.body.k) * u),
          static_cast<double>(0.5L * (pi - psi))};
}

/// Slope of the incline on which an axisymmetric cylinder just does not slip.
[[nodiscard]] inline double static_slope(const Body& body, double mu) {
  return std::atan(mu * (1.0 + body.k) / body.k);
}

}  // namespace brachisto::testing
