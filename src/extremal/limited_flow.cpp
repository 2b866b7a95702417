// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "extremal/limited_flow.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "math/jet2.hpp"

namespace brachisto::limited {

namespace {

/// A point whose coordinates and control are independent variables.
template <class Scalar>
TurningPoint<math::Jet1<Scalar, 6>> variable_point(const Values<Scalar>& y,
                                                   const Scalar& q) {
  using On = math::Jet1<Scalar, 6>;
  return {On::variable(y[kX], 0),     On::variable(y[kZ], 1),
          On::variable(y[kTheta], 2), On::variable(y[kW], 3),
          On::variable(y[kBeta], 4),  On::variable(q, 5)};
}

/// How the boundary of a limit of the place lies at a point: its normal, and
/// by how much it turns along (cos β, sin β).
template <class Scalar>
struct Boundary {
  Scalar normal_x, normal_z;  ///< ∂c/∂x, ∂c/∂z
  Scalar bend;                ///< tᵀ ∂²c/∂(x, z)² t
  Scalar across;              ///< ∂c·(−sin β, cos β)
};

template <class Scalar>
Boundary<Scalar> boundary_at(const PathInequality& limit, const Body& body,
                             const Values<Scalar>& y) {
  using std::cos;
  using std::sin;
  using On = math::Jet2<Scalar, 2>;
  const On c =
      value_of(limit, body, 1.0,
               TurningPoint<On>{On::variable(y[kX], 0), On::variable(y[kZ], 1),
                                On(0.0), On(0.0), On(0.0), On(0.0)});
  const Scalar cos_beta = cos(y[kBeta]);
  const Scalar sin_beta = sin(y[kBeta]);
  const auto by = [&](int i, int j) { return c.hessian[On::pair(i, j)]; };
  return {c.gradient[0], c.gradient[1],
          by(0, 0) * cos_beta * cos_beta +
              by(1, 0) * cos_beta * sin_beta * Scalar(2.0) +
              by(1, 1) * sin_beta * sin_beta,
          c.gradient[1] * cos_beta - c.gradient[0] * sin_beta};
}

}  // namespace

double rotation_per_length(const Body& body) {
  return body.off_centred() ? 1.0 / body.radius : 0.0;
}

/// 𝓗, and what its derivatives by θ, w and β make of the motion.
template <class Scalar>
struct LimitedFlow::Slopes {
  Scalar hamiltonian, root, w_rate;
  Scalar by_theta, by_w, by_beta, by_beta_beta;
  /// d/du ∂𝓗/∂β but for what q and ν add.
  Scalar drift;
};

LimitedFlow::LimitedFlow(const Scene& scene, std::optional<HeldLimit> held)
    : body_(scene.body),
      g_(scene.gravity),
      rotation_per_length_(limited::rotation_per_length(scene.body)),
      held_(std::move(held)),
      kind_(!held_                          ? Kind::Free
            : held_->limit.bounds_control() ? Kind::Control
                                            : Kind::Place) {}

template <class Scalar>
auto LimitedFlow::slopes(const Values<Scalar>& y) const -> Slopes<Scalar> {
  using std::cos;
  using On = math::Jet2<Scalar, 3>;
  const On theta = On::variable(y[kTheta], 0);
  const On w = On::variable(y[kW], 1);
  const On beta = On::variable(y[kBeta], 2);
  const On root = sqrt(inertia_factor(body_, theta, beta));
  const On w_rate = energy_slope(body_, theta, beta) * g_;
  const On h = root +
               w * (cos(beta) * On(y[kPX]) + sin(beta) * On(y[kPZ]) +
                    On(y[kPTheta] * Scalar(rotation_per_length_))) +
               w_rate * On(y[kPW]);
  const auto second = [&](int i, int j) { return h.hessian[On::pair(i, j)]; };
  return {h.value,
          root.value,
          w_rate.value,
          h.gradient[0],
          h.gradient[1],
          h.gradient[2],
          second(2, 2),
          second(2, 0) * y[kW] * Scalar(rotation_per_length_) +
              second(2, 1) * w_rate.value - w_rate.gradient[2] * h.gradient[1]};
}

template <class Scalar>
Scalar LimitedFlow::control(const Values<Scalar>& y) const {
  switch (kind_) {
    case Kind::Free: {
      const Slopes<Scalar> h = slopes(y);
      return -h.drift / h.by_beta_beta;
    }
    case Kind::Control: {
      const auto c =
          value_of(held_->limit, body_, g_, variable_point(y, Scalar(0.0)));
      return (Scalar(held_->bound) - c.value) / c.gradient[5];
    }
    case Kind::Place:
      break;
  }
  const Boundary<Scalar> edge = boundary_at(held_->limit, body_, y);
  return -(y[kW] * edge.bend / edge.across);
}

template <class Scalar>
std::array<Scalar, kStates> LimitedFlow::state_rates(
    const Values<Scalar>& y) const {
  using std::cos;
  using std::sin;
  return {y[kW] * cos(y[kBeta]), y[kW] * sin(y[kBeta]),
          y[kW] * Scalar(rotation_per_length_),
          energy_slope(body_, y[kTheta], y[kBeta]) * Scalar(g_), control(y)};
}

template <class Scalar>
auto LimitedFlow::rates(const Values<Scalar>& y) const -> Rates<Scalar> {
  const Slopes<Scalar> h = slopes(y);
  const std::array<Scalar, kStates> f = state_rates(y);
  Rates<Scalar> out{{}, h.root, Scalar(0.0)};
  std::copy(f.begin(), f.end(), out.y.begin());
  out.y[kPX] = out.y[kPZ] = out.y[kPBeta] = Scalar(0.0);
  out.y[kPTheta] = -h.by_theta;
  out.y[kPW] = -h.by_w;
  if (kind_ == Kind::Control) {
    const auto c =
        value_of(held_->limit, body_, g_, variable_point(y, f[kBeta]));
    out.nu = y[kPBeta] / c.gradient[5];
    out.y[kPBeta] = -h.by_beta;
    for (std::size_t i = 0; i < kStates; ++i) {
      out.y[kPX + i] += out.nu * c.gradient[i];
    }
  } else if (kind_ == Kind::Place) {
    const Boundary<Scalar> edge = boundary_at(held_->limit, body_, y);
    out.nu = -((h.drift + h.by_beta_beta * f[kBeta]) / (y[kW] * edge.across));
    out.y[kPX] = out.nu * edge.normal_x;
    out.y[kPZ] = out.nu * edge.normal_z;
  }
  return out;
}

template <class Scalar>
Scalar LimitedFlow::hamiltonian(const Values<Scalar>& y) const {
  const Scalar h = slopes(y).hamiltonian;
  return kind_ == Kind::Control ? h + y[kPBeta] * control(y) : h;
}

template <class Scalar>
Scalar LimitedFlow::slope_condition(const Values<Scalar>& y) const {
  return slopes(y).by_beta;
}

double LimitedFlow::legendre(const State& y) const {
  return slopes(y).by_beta_beta;
}

template <class Scalar>
Scalar LimitedFlow::value(const PathInequality& limit,
                          const Values<Scalar>& y) const {
  return value_of(limit, body_, g_,
                  TurningPoint<Scalar>{y[kX], y[kZ], y[kTheta], y[kW], y[kBeta],
                                       control(y)});
}

template <class Scalar>
std::array<Scalar, kStates> LimitedFlow::gradient(
    const PathInequality& limit, const Values<Scalar>& y) const {
  using On = math::Jet1<Scalar, static_cast<int>(kStates)>;
  Values<On> moved;
  for (std::size_t i = 0; i < kSize; ++i) {
    moved[i] = i < kStates ? On::variable(y[i], static_cast<int>(i)) : On(y[i]);
  }
  return value(limit, moved).gradient;
}

template <class Scalar>
Scalar LimitedFlow::rate_of(const PathInequality& limit,
                            const Values<Scalar>& y) const {
  const std::array<Scalar, kStates> f = state_rates(y);
  const std::array<Scalar, kStates> by = gradient(limit, y);
  Scalar sum(0.0);
  for (std::size_t i = 0; i < kStates; ++i) sum += by[i] * f[i];
  return sum;
}

double LimitedFlow::by_control(const PathInequality& limit,
                               const State& y) const {
  return value_of(limit, body_, g_, variable_point(y, control(y))).gradient[5];
}

#define BRACHISTO_INSTANTIATE(Scalar)                                        \
  template LimitedFlow::Rates<Scalar> LimitedFlow::rates(                    \
      const Values<Scalar>&) const;                                          \
  template Scalar LimitedFlow::control(const Values<Scalar>&) const;         \
  template Scalar LimitedFlow::hamiltonian(const Values<Scalar>&) const;     \
  template Scalar LimitedFlow::slope_condition(const Values<Scalar>&) const; \
  template Scalar LimitedFlow::value(const PathInequality&,                  \
                                     const Values<Scalar>&) const;           \
  template std::array<Scalar, kStates> LimitedFlow::gradient(                \
      const PathInequality&, const Values<Scalar>&) const;                   \
  template Scalar LimitedFlow::rate_of(const PathInequality&,                \
                                       const Values<Scalar>&) const;
BRACHISTO_INSTANTIATE(double)
BRACHISTO_INSTANTIATE(Jet)
#undef BRACHISTO_INSTANTIATE

}  // namespace brachisto::limited
