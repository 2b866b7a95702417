// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "proof/theorems.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "brachisto/math/jet.hpp"
#include "model/field.hpp"
#include "proof/excess.hpp"
#include "proof/friction.hpp"

namespace brachisto::proof {

namespace {

// From where on least friction is told, shares of T; at the start itself R_n
// is 0 and R_t is not.
constexpr std::array kShares{0.01, 0.05};

/// √A with its first two derivatives by β.
std::array<Real, 3> root_by_slope(const Scene& scene, const Real& theta,
                                  const Real& beta) {
  using Jet = math::Jet2<Node, 1>;
  Tape tape;
  const Tape::Recording recording(tape);
  const Jet root = root_of_inertia(scene.body, Jet(tape.input(0)),
                                   Jet::variable(tape.input(1), 0));
  const std::vector<Real> at = tape.values({theta, beta});
  const auto value = [&](const Node& node) {
    return at[static_cast<std::size_t>(node.id)];
  };
  // A constant root leaves nodes that were written all the same.
  return {value(root.value), value(root.gradient[0]), value(root.hessian[0])};
}

// With t = (cos β, sin β) and n = (−sin β, cos β), 𝓗 = 0 and h_β = 0 at the end
// are p = −(√A t + c n)/w, c = ∂√A/∂β; m = ∂²√A/∂β². By β p changes like
// −(√A + m) n/w; by θ, with w δw = g r η cos θ, like
// (c t + m n)/w + (√A t + c n) δw/w².
State family_at_end(const Scene& scene, const State& end) {
  State state(3 * kComponents);
  for (std::size_t i : {kX, kZ, kTheta, kW, kBeta}) state[i] = end[i];
  const Real &theta = end[kTheta], &w = end[kW], &beta = end[kBeta];
  const auto [root, c, m] = root_by_slope(scene, theta, beta);
  const Real t_x = cos(beta), t_z = sin(beta), n_x = -t_z, n_z = t_x;
  const Real gain = Real(scene.body.eta_m) * cos(theta) / (Real(2.0) * w);
  state[kPx] = -(root * t_x + c * n_x) / w;
  state[kPz] = -(root * t_z + c * n_z) / w;
  const auto at = [](std::size_t component, std::size_t direction) {
    return Equations::place(component, direction);
  };
  state[at(kTheta, 0)] = Real(1.0);
  state[at(kW, 0)] = gain;
  state[at(kPx, 0)] =
      (c * t_x + m * n_x) / w + (root * t_x + c * n_x) * gain / (w * w);
  state[at(kPz, 0)] =
      (c * t_z + m * n_z) / w + (root * t_z + c * n_z) * gain / (w * w);
  state[at(kBeta, 1)] = Real(1.0);
  state[at(kPx, 1)] = -(root + m) * n_x / w;
  state[at(kPz, 1)] = -(root + m) * n_z / w;
  return state;
}

}  // namespace

void Theorem::meet(Sign sign, const char* what, const Step& step,
                   const Real& u) {
  if (sign == Sign::Positive || refuted) return;
  if (sign == Sign::Refuted) {
    refuted = true;
    why_not = fmt::format("{} is false near u = {:.4f}", what,
                          step.begin + std::fabs(u.near()));
  } else if (holds) {
    why_not = fmt::format("{} is not shown near u = {:.4f}: more bits may help",
                          what, step.begin);
  }
  holds = false;
}

Theorem no_conjugate_point(const Scene& scene, const State& end,
                           const Real& length, const Accuracy& accuracy) {
  Theorem out{.holds = true};
  const Real eta(scene.body.eta_m);
  bool first = true;
  double sign = 0.0;
  const auto look = [&](const Step& step) {
    // Divided by u on the first step: the column of β is zero at the end.
    const int drop = first ? 1 : 0;
    const auto determinant = [&](const Real& u) {
      const auto by = [&](std::size_t component, std::size_t direction) {
        return step.value(Equations::place(component, direction), u,
                          direction == 1 ? drop : 0);
      };
      const Real theta = step.value(kTheta, u), w = step.value(kW, u),
                 beta = step.value(kBeta, u);
      const std::array a{by(kX, 0), by(kTheta, 0), by(kW, 0)};
      const std::array b{by(kX, 1), by(kTheta, 1), by(kW, 1)};
      const std::array f{w * cos(beta), w,
                         (sin(beta) + eta * cos(theta)) * Real(0.5)};
      return a[0] * (b[1] * f[2] - b[2] * f[1]) -
             a[1] * (b[0] * f[2] - b[2] * f[0]) +
             a[2] * (b[0] * f[1] - b[1] * f[0]);
    };
    // Its sign where the way begins is kept. Behind the first step u, which is
    // negative, is no longer divided by.
    if (first) {
      const Real there = determinant(Real(0.0));
      if (there.has_zero()) {
        throw TooFewBits("the sign of the determinant at the end is not shown");
      }
      sign = there.positive() ? 1.0 : -1.0;
    }
    const Real own(first ? sign : -sign);
    Real where;
    const Sign shown = sign_along(
        Real(0.0), -step.length,
        [&](const Real& u) { return own * determinant(u); }, where);
    out.meet(shown, "that no point is conjugate to the end", step, where);
    first = false;
  };
  try {
    Flow flow(scene, 2, accuracy);
    State state = family_at_end(scene, end);
    flow.go(state, length, true, look);
  } catch (const NotProven& error) {
    return {.why_not = error.what()};
  }
  return out;
}

Theorems prove_theorems(const Scene& scene, const Root& root,
                        const Accuracy& accuracy) {
  const Bits bits(accuracy.bits);
  Theorems out;
  for (Theorem* each :
       {&out.legendre, &out.presses, &out.no_fold, &out.no_loop}) {
    each->holds = true;
  }
  const Ends ends(scene);
  Flow flow(scene, 0, accuracy);
  const Equations& equations = flow.equations();
  const Real pi = Real::pi();
  ExcessAlong slopes(scene);
  std::vector<FrictionAlong> friction;
  for (const double share : kShares) {
    if (!scene.body.rolls()) break;  // a bead does not need any
    friction.emplace_back(equations, share, root.end[kTime]);
  }
  bool first = true;
  const auto look = [&](const Step& step) {
    const auto meet = [&](Theorem& theorem, const char* what,
                          const auto& value) {
      Real where;
      const Sign sign = sign_along(Real(0.0), step.length, value, where);
      theorem.meet(sign, what, step, where);
    };
    const auto along = [&](const Node& node, int drop = 0) {
      return [&step, node, drop](const Real& u) {
        return step.value(node, u, drop);
      };
    };
    meet(out.legendre, "h_ββ > 0", along(equations.legendre));
    meet(out.no_fold, "r κ_c < 1", along(equations.unfolded));
    // R_n is 0 at the start, by the equation of the start angle.
    meet(out.presses, "R_n > 0", along(equations.normal, first ? 1 : 0));
    meet(out.no_loop, "|β| < π",
         [&](const Real& u) { return pi - step.value(kBeta, u).abs(); });
    slopes.look(step);
    for (FrictionAlong& each : friction) each.look(step);
    first = false;
  };
  State state = ends.start(root.found, 0);
  flow.go(state, root.found.back(), false, look);

  const Real heights = ends.unit() / Real(scene.H);
  const State& end = root.end;
  out.enclosed = {end[kTime] * sqrt(heights), ends.start_angle(), end[kBeta],
                  end[kLength] * heights,
                  end[kTheta] - Real(scene.body.theta_m)};
  out.excess = slopes.found();
  for (const FrictionAlong& each : friction) {
    Friction found = each.found();
    found.place = (found.place + ends.start_place()) * heights;
    out.friction.push_back(std::move(found));
  }
  out.no_conjugate_point =
      no_conjugate_point(scene, end, root.found.back(), accuracy);
  return out;
}

}  // namespace brachisto::proof
