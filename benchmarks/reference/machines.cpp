// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <cmath>
#include <numbers>

#include "reference/classic.hpp"
#include "reference/second_methods.hpp"

namespace brachisto::benchmarks {

namespace {

using ocp::Sizes;

struct VanDerPol : Sizes<2, 1> {
  template <class S>
  [[nodiscard]] Rates<S> rates(const Point<S>& at) const {
    const auto& [x1, x2] = at.states;
    const S& u = at.controls[0];
    return {x1 * x1 + x2 * x2 + u * u, {(S(1.0) - x2 * x2) * x1 - x2 + u, x1}};
  }
};

/// Temperatures in 100 K.
struct Reactor : Sizes<2, 1> {
  template <class S>
  [[nodiscard]] Rates<S> rates(const Point<S>& at) const {
    const auto& [x1, x2] = at.states;
    const S k1 = exp(S(-25.0) / at.controls[0]) * 4000.0;
    const S k2 = exp(S(-50.0) / at.controls[0]) * 620000.0;
    const S first = k1 * x1 * x1;
    return {S(0.0), {-first, first - k2 * x2}};
  }
  template <class S>
  [[nodiscard]] S end_cost(const Ends<S>& ends) const {
    return -ends.end[1];
  }
};

struct Catalyst : Sizes<2, 1> {
  template <class S>
  [[nodiscard]] Rates<S> rates(const Point<S>& at) const {
    const auto& [x1, x2] = at.states;
    const S& u = at.controls[0];
    const S forth = u * (x2 * 10.0 - x1);
    return {S(0.0), {forth, -forth - (S(1.0) - u) * x2}};
  }
  template <class S>
  [[nodiscard]] S end_cost(const Ends<S>& ends) const {
    return ends.end[0] + ends.end[1] - 1.0;
  }
};

struct RobotArm : Sizes<6, 3> {
  template <class S>
  [[nodiscard]] Rates<S> rates(const Point<S>& at) const {
    const auto& [rho, theta, phi, rho_dot, theta_dot, phi_dot] = at.states;
    const auto& [u_rho, u_theta, u_phi] = at.controls;
    const S behind = S(5.0) - rho, s = sin(phi);
    const S inertia =
        (behind * behind * behind + rho * rho * rho) * (1.0 / 3.0);
    return {S(1.0),
            {rho_dot, theta_dot, phi_dot, u_rho * 0.2,
             u_theta / (inertia * s * s), u_phi / inertia}};
  }
};

/// Heights in 1e5 ft, speeds in 1e4 ft/s, times in 100 s; Betts (2010).
struct Shuttle : Sizes<5, 2> {
  template <class S>
  [[nodiscard]] Rates<S> rates(const Point<S>& at) const {
    constexpr double kHeight = 1e5, kSpeed = 1e4, kTime = 100.0;
    constexpr double kEarth = 20902900.0, kMu = 0.14076539e17;
    constexpr double kMass = 203000.0 / 32.174, kArea = 2690.0;
    constexpr double kDensity = 0.002378, kScale = 23800.0;
    constexpr double kDegrees = 180.0 / std::numbers::pi;
    const auto& [height, latitude, speed, gamma, psi] = at.states;
    const auto& [alpha, beta] = at.controls;
    const S r = height * kHeight + kEarth, v = speed * kSpeed;
    const S g = S(kMu) / (r * r);
    const S a = alpha * kDegrees;
    const S push = exp(height * (-kHeight / kScale)) * v * v *
                   (0.5 * kDensity * kArea / kMass);
    const S drag = push * (a * a * 0.000621408 - a * 0.0061592 + 0.07854);
    const S lift = push * (a * 0.029244 - 0.20704);
    const S cg = cos(gamma), sg = sin(gamma);
    return {S(0.0),
            {v * sg * (kTime / kHeight), v / r * cg * cos(psi) * kTime,
             (-drag - g * sg) * (kTime / kSpeed),
             (lift / v * cos(beta) + cg * (v / r - g / v)) * kTime,
             (lift * sin(beta) / (v * cg) +
              v / r * cg * sin(psi) * sin(latitude) / cos(latitude)) *
                 kTime}};
  }
  template <class S>
  [[nodiscard]] S end_cost(const Ends<S>& ends) const {
    return -ends.end[1];
  }
};

ocp::Variable torque(const char* name) {
  return {.name = name, .lower = -1.0, .upper = 1.0};
}

Classic robot() {
  constexpr double kQuarter = std::numbers::pi / 4.0,
                   kTurn = 2.0 * std::numbers::pi / 3.0;
  Classic out = classic(
      "min T, 5 ρ'' = u_ρ, I sin²φ θ'' = u_θ, I φ'' = u_φ, I = ((5 − ρ)³ + "
      "ρ³)/3, |u| ≤ 1, from rest at (4.5, 0, π/4) to rest at (4.5, 2π/3, π/4)",
      RobotArm{},
      {.name = "robot arm",
       .states = {{.name = "rho",
                   .lower = 0.0,
                   .upper = 5.0,
                   .start = 4.5,
                   .end = 4.5},
                  {.name = "theta", .start = 0.0, .end = kTurn},
                  {.name = "phi",
                   .lower = 0.1,
                   .upper = 3.0,
                   .start = kQuarter,
                   .end = kQuarter},
                  {.name = "rho_dot", .start = 0.0, .end = 0.0},
                  {.name = "theta_dot", .start = 0.0, .end = 0.0},
                  {.name = "phi_dot", .start = 0.0, .end = 0.0}},
       .controls = {torque("u_rho"), torque("u_theta"), torque("u_phi")},
       .duration = {.guess = 9.0}});
  out.second = {"half of the way by symmetry, integrated", robot_arm()};
  out.literature = {"COPS, 200 intervals", 9.14138};
  return out;
}

Classic cross_range() {
  constexpr double kDegree = std::numbers::pi / 180.0;
  Classic out = classic(
      "max θ(T) of Betts' lifting vehicle, h, θ, v, γ, ψ steered by α and β, "
      "from (260 000 ft, 0, 25 600 ft/s, −1°, 90°) to (80 000 ft, –, 2 500 "
      "ft/s, −5°, –), without a limit of heating",
      Shuttle{},
      {.name = "shuttle's cross range",
       .states = {{.name = "h",
                   .unit = "1e5 ft",
                   .lower = 0.0,
                   .upper = 3.0,
                   .start = 2.6,
                   .end = 0.8},
                  {.name = "theta",
                   .unit = "rad",
                   .lower = -1.5,
                   .upper = 1.5,
                   .start = 0.0,
                   .guess = [](double t) { return 0.6 * t; }},
                  {.name = "v",
                   .unit = "1e4 ft/s",
                   .lower = 0.1,
                   .upper = 4.0,
                   .start = 2.56,
                   .end = 0.25},
                  {.name = "gamma",
                   .unit = "rad",
                   .lower = -1.5,
                   .upper = 1.5,
                   .start = -kDegree,
                   .end = -5.0 * kDegree},
                  {.name = "psi",
                   .unit = "rad",
                   .start = 90.0 * kDegree,
                   .guess = [](double t) { return 1.57 * (1.0 - t); }}},
       .controls = {{.name = "alpha",
                     .unit = "rad",
                     .lower = -1.5,
                     .upper = 1.5,
                     .guess = 0.3},
                    {.name = "beta",
                     .unit = "rad",
                     .lower = -1.55,
                     .upper = kDegree,
                     .guess = [](double t) { return -1.3 * (1.0 - t); }}},
       .duration = {.lower = 1.0, .upper = 40.0, .guess = 20.0},
       .time_unit = "100 s"});
  out.factor = -1.0 / kDegree;
  out.second = {"shooting", shuttle()};
  out.literature = {"Betts, 2010, Section 6.1", 34.1412};
  out.by.elements = 20;
  return out;
}

}  // namespace

std::vector<Classic> machines() {
  std::vector<Classic> out;

  out.push_back(classic(
      "min ∫ x₁² + x₂² + u² dt, x₁' = (1 − x₂²) x₁ − x₂ + u, x₂' = x₁, −0.3 ≤ "
      "u ≤ 1, from (0, 1), T = 5",
      VanDerPol{},
      {.name = "van der Pol",
       .states = {{.name = "x1", .start = 0.0}, {.name = "x2", .start = 1.0}},
       .controls = {{.name = "u", .lower = -0.3, .upper = 1.0}},
       .duration = ocp::Duration::fixed(5.0)}));
  out.back().second = {"shooting", van_der_pol()};
  out.back().literature = {"PROPT's manual", 2.8672595};

  out.push_back(classic(
      "max x₂(1), x₁' = −k₁ x₁², x₂' = k₁ x₁² − k₂ x₂, k₁ = 4000 exp(−2500/Θ), "
      "k₂ = 620 000 exp(−5000/Θ), 298 ≤ Θ ≤ 398, from (1, 0), T = 1",
      Reactor{},
      {.name = "batch reactor",
       .states = {{.name = "x1", .start = 1.0}, {.name = "x2", .start = 0.0}},
       .controls = {{.name = "temperature",
                     .unit = "100 K",
                     .lower = 2.98,
                     .upper = 3.98,
                     .guess = [](double t) { return 3.9 - 0.6 * t; }}},
       .duration = ocp::Duration::fixed(1.0)}));
  out.back().factor = -1.0;
  out.back().second = {"shooting", batch_reactor()};
  out.back().literature = {"PROPT's manual", 0.6107994};

  out.push_back(classic(
      "min x₁(1) + x₂(1) − 1, x₁' = u (10 x₂ − x₁), x₂' = −x₁' − (1 − u) x₂, "
      "0 ≤ u ≤ 1, from (1, 0), T = 1",
      Catalyst{},
      {.name = "catalyst: singular arc",
       .states = {{.name = "x1", .start = 1.0}, {.name = "x2", .start = 0.0}},
       .controls = {{.name = "u",
                     .lower = 0.0,
                     .upper = 1.0,
                     .guess = [](double t) { return 1.0 - t; }}},
       .duration = ocp::Duration::fixed(1.0)}));
  out.back().second = {"bang, singular, bang: two switches", catalyst()};
  out.back().literature = {"COPS, 100 intervals", -0.0480556};

  out.push_back(robot());
  out.push_back(cross_range());
  return out;
}

}  // namespace brachisto::benchmarks
