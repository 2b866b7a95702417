// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "proof/theorems.hpp"

#include <fmt/format.h>

#include <memory>
#include <utility>

#include "brachisto/math/jet.hpp"
#include "model/field.hpp"
#include "proof/along.hpp"

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
// −(√A + m) n/w; by θ, A being a function of θ − β, like (c t + m n)/w; by w
// like (√A t + c n)/w². In a uniform field w δw = g r η cos θ δθ.
State family_at_end(const Scene& scene, const State& end, bool by_energy) {
  State state((by_energy ? 3 : 4) * kComponents);
  for (std::size_t i : {kX, kZ, kTheta, kW, kBeta}) state[i] = end[i];
  const Real &theta = end[kTheta], &w = end[kW], &beta = end[kBeta];
  const auto [root, c, m] = root_by_slope(scene, theta, beta);
  const Real t_x = cos(beta), t_z = sin(beta), n_x = -t_z, n_z = t_x;
  state[kPx] = -(root * t_x + c * n_x) / w;
  state[kPz] = -(root * t_z + c * n_z) / w;
  const auto at = [](std::size_t component, std::size_t direction) {
    return Equations::place(component, direction);
  };
  const Real by_w_x = -state[kPx] / w, by_w_z = -state[kPz] / w;
  state[at(kTheta, 0)] = Real(1.0);
  state[at(kPx, 0)] = (c * t_x + m * n_x) / w;
  state[at(kPz, 0)] = (c * t_z + m * n_z) / w;
  state[at(kBeta, 1)] = Real(1.0);
  state[at(kPx, 1)] = -(root + m) * n_x / w;
  state[at(kPz, 1)] = -(root + m) * n_z / w;
  if (by_energy) {
    const Real gain = Real(scene.body.eta_m) * cos(theta) / (Real(2.0) * w);
    state[at(kW, 0)] = gain;
    state[at(kPx, 0)] += by_w_x * gain;
    state[at(kPz, 0)] += by_w_z * gain;
  } else {
    state[at(kW, 2)] = Real(1.0);
    state[at(kPx, 2)] = by_w_x;
    state[at(kPz, 2)] = by_w_z;
  }
  return state;
}

using Column3 = std::array<Real, 3>;
Real determinant(const Column3& a, const Column3& b, const Column3& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) -
         a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}
using Column4 = std::array<Real, 4>;
Real determinant(const Column4& a, const Column4& b, const Column4& c,
                 const Column4& d) {
  Real out;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto without = [i](const Column4& of) {
      Column3 left;
      for (std::size_t k = 0, j = 0; k < 4; ++k) {
        if (k != i) left[j++] = of[k];
      }
      return left;
    };
    const Real minor = a[i] * determinant(without(b), without(c), without(d));
    out = i % 2 == 0 ? out + minor : out - minor;
  }
  return out;
}

}  // namespace

void Theorem::meet(Sign sign, std::string_view what, double u,
                   std::size_t arc) {
  if (sign == Sign::Positive || refuted) return;
  const std::string where =
      fmt::format("near u = {:.4f}", u) +
      (arc > 0 ? fmt::format(" of arc {}", arc) : std::string());
  if (sign == Sign::Refuted) {
    refuted = true;
    why_not = fmt::format("{} is false {}", what, where);
  } else if (holds) {
    why_not =
        fmt::format("{} is not shown {}: more bits may help", what, where);
  }
  holds = false;
}

Theorem no_conjugate_point(const Scene& scene, const State& end,
                           const Real& length, const Accuracy& accuracy) {
  Theorem out{.holds = true};
  const bool by_energy = is_plain(scene);
  const Real eta(scene.body.eta_m);
  std::unique_ptr<Flow> flow;
  bool first = true;
  double sign = 0.0;
  const auto look = [&](const Step& step) {
    // Divided by u on the first step: the column of β is zero at the end.
    const int drop = first ? 1 : 0;
    const auto jacobian = [&](const Real& u) {
      const auto by = [&](std::size_t component, std::size_t direction) {
        return step.value(Equations::place(component, direction), u,
                          direction == 1 ? drop : 0);
      };
      if (!by_energy) {
        const auto column = [&](std::size_t direction) {
          return Column4{by(kX, direction), by(kZ, direction),
                         by(kTheta, direction), by(kW, direction)};
        };
        const std::vector<Node>& rates = flow->equations().rates;
        return determinant(
            column(0), column(1), column(2),
            Column4{step.value(rates[kX], u), step.value(rates[kZ], u),
                    step.value(rates[kTheta], u), step.value(rates[kW], u)});
      }
      const Real theta = step.value(kTheta, u), w = step.value(kW, u),
                 beta = step.value(kBeta, u);
      const auto column = [&](std::size_t direction) {
        return Column3{by(kX, direction), by(kTheta, direction),
                       by(kW, direction)};
      };
      return determinant(column(0), column(1),
                         Column3{w * cos(beta), w,
                                 (sin(beta) + eta * cos(theta)) * Real(0.5)});
    };
    // Its sign where the way begins is kept. Behind the first step u, which is
    // negative, is no longer divided by.
    if (first) {
      const Real there = jacobian(Real(0.0));
      if (there.has_zero()) {
        throw TooFewBits("the sign of the determinant at the end is not shown");
      }
      sign = there.positive() ? 1.0 : -1.0;
    }
    const Real own(first ? sign : -sign);
    Real where;
    const Sign shown = sign_along(
        Real(0.0), -step.length,
        [&](const Real& u) { return own * jacobian(u); }, where);
    out.meet(shown, "that no point is conjugate to the end",
             length.near() - step.begin + where.near());
    first = false;
  };
  try {
    flow = std::make_unique<Flow>(scene, by_energy ? 2 : 3, accuracy);
    State state = family_at_end(scene, end, by_energy);
    flow->go(state, length, true, look);
  } catch (const NotProven& error) {
    return {.why_not = error.what()};
  }
  return out;
}

FreeExtremal as_free(const PlainSystem& system, const Root& root) {
  const Scene& scene = system.scene();
  const State& end = root.ends.front();
  FreeExtremal out;
  out.start = system.start(root.found, 0);
  out.end = end;
  out.length = root.found.back();
  out.per_H = system.unit() / Real(scene.H);
  out.start_place = system.start_place();
  out.enclosed = {end[kTime] * sqrt(out.per_H), system.start_angle(),
                  end[kBeta], end[kLength] * out.per_H,
                  end[kTheta] - Real(scene.body.theta_m)};
  return out;
}

Theorems prove_theorems(const Scene& scene, const FreeExtremal& extremal,
                        const Accuracy& accuracy) {
  const Bits bits(accuracy.bits);
  Theorems out;
  for (Theorem* each :
       {&out.legendre, &out.presses, &out.no_fold, &out.no_loop}) {
    each->holds = true;
  }
  Flow flow(scene, 0, accuracy);
  const Equations& equations = flow.equations();
  const Real pi = Real::pi();
  ExcessAlong slopes(scene);
  std::vector<FrictionAlong> friction;
  for (const double share : kShares) {
    if (!scene.body.rolls()) break;  // a bead does not need any
    friction.emplace_back(equations, share, extremal.end[kTime]);
  }
  bool first = true;
  const auto look = [&](const Step& step) {
    const auto meet = [&](Theorem& theorem, const char* what,
                          const auto& value) {
      Real where;
      const Sign sign = sign_along(Real(0.0), step.length, value, where);
      theorem.meet(sign, what, step.begin + where.near());
    };
    const auto along = [&](const Node& node, int drop = 0) {
      return [&step, node, drop](const Real& u) {
        return step.value(node, u, drop);
      };
    };
    meet(out.legendre, "h_ββ > 0", along(equations.legendre));
    meet(out.no_fold, "r κ_c < 1", along(equations.unfolded));
    // R_n is 0 at rest, by the equation of the start angle.
    const bool at_rest = first && extremal.rests;
    meet(out.presses, "R_n > 0", along(equations.normal, at_rest ? 1 : 0));
    meet(out.no_loop, "|β| < π",
         [&](const Real& u) { return pi - step.value(kBeta, u).abs(); });
    slopes.look(step);
    for (FrictionAlong& each : friction) each.look(step);
    first = false;
  };
  State state = extremal.start;
  flow.go(state, extremal.length, false, look);
  out.enclosed = extremal.enclosed;
  out.excess = slopes.found();
  for (const FrictionAlong& each : friction) {
    Friction found = each.found();
    found.place = (found.place + extremal.start_place) * extremal.per_H;
    out.friction.push_back(std::move(found));
  }
  out.no_conjugate_point =
      no_conjugate_point(scene, extremal.end, extremal.length, accuracy);
  return out;
}

}  // namespace brachisto::proof
