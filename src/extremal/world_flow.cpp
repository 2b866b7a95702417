// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "extremal/world_flow.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "math/roots.hpp"
#include "model/field.hpp"

namespace brachisto::worlds {

namespace {

constexpr std::size_t kTime = kSize;      // position of t
constexpr std::size_t kPath = kSize + 1;  // states, costates and t

/// \tparam Columns  of derivatives by the start, kSize or none
template <std::size_t Columns>
struct WorldRates {
  /// The path, then its derivatives by each component of the start.
  using Stack = std::array<double, kPath*(1 + Columns)>;

  const WorldFlow& flow;
  double beta;  ///< near which the next slope is searched
  bool failed = false;

  void operator()(const Stack& stack, Stack& rates, double) {
    State y;
    std::copy_n(stack.begin(), kSize, y.begin());
    PhaseJet h;
    if (failed || !flow.find_slope(y, beta, h)) {
      failed = true;
      rates.fill(0.0);
      return;
    }
    const State f = WorldFlow::rates(h);
    std::copy(f.begin(), f.end(), rates.begin());
    rates[kTime] = flow.time_rate(y, beta);
    for (std::size_t j = 0; j < Columns; ++j) {
      const std::size_t offset = kPath * (1 + j);
      State v;
      std::copy_n(stack.begin() + offset, kSize, v.begin());
      const State df = WorldFlow::variation(h, v);
      std::copy(df.begin(), df.end(), rates.begin() + offset);
      rates[offset + kTime] = flow.time_variation(y, beta, h, v);
    }
  }

  /// Of the path alone; p_θ is measured in units of r, its natural size.
  [[nodiscard]] double relative_error(const Stack& now, const Stack& error,
                                      double tolerance) const {
    constexpr double kRounding = 4.0 * std::numeric_limits<double>::epsilon();
    double largest = 0.0;
    for (std::size_t i = 0; i < kPath; ++i) {
      const double weight = i == kPTheta ? flow.inverse_radius() : 1.0;
      const double ratio = std::abs(error[i]) * weight /
                           (tolerance + kRounding * std::abs(now[i]) * weight);
      if (!std::isfinite(ratio)) return std::numeric_limits<double>::infinity();
      largest = std::max(largest, ratio);
    }
    return largest;
  }
};

template <std::size_t Columns>
typename WorldRates<Columns>::Stack stack_of(const State& y, double t = 0.0) {
  typename WorldRates<Columns>::Stack stack{};
  std::copy(y.begin(), y.end(), stack.begin());
  stack[kTime] = t;
  for (std::size_t j = 0; j < Columns; ++j) stack[kPath * (1 + j) + j] = 1.0;
  return stack;
}

/// Where a way has led.
template <std::size_t Columns>
struct Arrived {
  typename WorldRates<Columns>::Stack now, slope;
  double beta;
};

/// Derivatives beyond the surface. A neighbour passes it later by du and has
/// had the rates f⁻ so long in place of f⁺,
///
///     v⁺ = v⁻ + (f⁻ − f⁺) du,  du = −(∇h·v)/(∇h·f),
///
/// in which only the costates' rates differ; h and √A have none that do.
template <std::size_t Columns>
void pass_surface(const WorldFlow& here, const WorldFlow& there, double beta,
                  typename WorldRates<Columns>::Stack& now) {
  State y;
  std::copy_n(now.begin(), kSize, y.begin());
  PhaseJet h_here, h_there;
  double same = beta;
  if (!here.find_slope(y, same, h_here) || !there.find_slope(y, same, h_there))
    return;
  const State before = WorldFlow::rates(h_here);
  const State after = WorldFlow::rates(h_there);
  for (std::size_t j = 0; j < Columns; ++j) {
    double* const v = now.data() + kPath * (1 + j);
    State change;
    std::copy_n(v, kSize, change.begin());
    const double du =
        -here.height_variation(y, change) / here.height_variation(y, before);
    for (std::size_t i = 0; i < kSize; ++i) v[i] += (before[i] - after[i]) * du;
  }
}

/// Goes from 0 to `span`, in pieces that end where the surface of a sphere is
/// passed; tells `on_step` of every step.
template <std::size_t Columns, class OnStep>
std::optional<Arrived<Columns>> travel(const WorldFlow& flow,
                                       const State& start, double near,
                                       double span,
                                       const shooting::StepControl& control,
                                       double& step, OnStep&& on_step) {
  using Rates = WorldRates<Columns>;
  using Path = shooting::AdaptiveIntegration<Rates>;
  if (!flow.has_surface()) {
    Path path(Rates{flow, near}, stack_of<Columns>(start));
    if (!shooting::advance(path, span, control, step, [&](double u) {
          on_step(u, path.now(), path.beta());
        })) {
      return std::nullopt;
    }
    return Arrived<Columns>{path.now(), path.slope(), path.beta()};
  }
  constexpr int kMostPassages = 50;
  const auto height = [&](const typename Rates::Stack& stack) {
    State y;
    std::copy_n(stack.begin(), kSize, y.begin());
    return flow.height(y);
  };
  // The last place that is known to be on the side of a piece.
  double u = 0.0;
  typename Rates::Stack now = stack_of<Columns>(start);
  double beta = near;
  bool outside = height(now) > 0.0;
  for (int passages = 0; passages <= kMostPassages; ++passages) {
    const WorldFlow here =
        flow.on_side(outside ? SphereSide::Outside : SphereSide::Inside);
    const double from = u;
    double beyond = 0.0;  // length of the step that led over the surface
    Path path(Rates{here, beta}, now);
    const bool went =
        u >= span ||
        shooting::advance(path, span - from, control, step, [&](double v) {
          if ((height(path.now()) > 0.0) != outside) {
            beyond = from + v - u;
            return false;
          }
          u = from + v;
          now = path.now();
          beta = path.beta();
          on_step(u, now, beta);
          return true;
        });
    if (!went) return std::nullopt;
    if (beyond == 0.0) return Arrived<Columns>{now, path.slope(), beta};
    const auto after = [&](double h) {
      Path part(Rates{here, beta}, now);
      part.step_unchecked(h);
      return part;
    };
    // At its beginning a piece may lie on the surface but for rounding.
    const double side = outside ? 1.0 : -1.0;
    const double at_first = std::max(0.0, side * height(now));
    if (at_first > 0.0) {
      const double h = math::find_root(
          [&](double part) { return side * height(after(part).now()); }, 0.0,
          beyond, at_first, std::min(0.0, side * height(path.now())));
      const Path on_surface = after(h);
      u += h;
      now = on_surface.now();
      beta = on_surface.beta();
      on_step(u, now, beta);
      pass_surface<Columns>(
          here,
          flow.on_side(outside ? SphereSide::Inside : SphereSide::Outside),
          beta, now);
    }
    outside = !outside;
  }
  return std::nullopt;
}

template <class Stack>
Passed passed(double u, const Stack& stack, double beta) {
  Passed out{u, {}, stack[kTime], beta};
  std::copy_n(stack.begin(), kSize, out.y.begin());
  return out;
}

}  // namespace

WorldFlow WorldFlow::on_side(SphereSide side) const {
  Scene there = scene_;
  there.world.side = side;
  return WorldFlow(std::move(there));
}

// n·(v_x − r η v_θ sin θ, v_z + r η v_θ cos θ)
double WorldFlow::height_variation(const State& y, const State& v) const {
  const Point heavy = mass_centre(scene_.body, {y[kX], y[kZ]}, y[kTheta]);
  const Point centre = scene_.world.sphere->centre;
  const double turn = scene_.body.radius * scene_.body.eta_m * v[kTheta];
  return ((heavy.x - centre.x) * (v[kX] - turn * std::sin(y[kTheta])) +
          (heavy.z - centre.z) * (v[kZ] + turn * std::cos(y[kTheta]))) /
         std::hypot(heavy.x - centre.x, heavy.z - centre.z);
}

double WorldFlow::height(const State& y) const {
  return height_above_surface(
      scene_, mass_centre(scene_.body, {y[kX], y[kZ]}, y[kTheta]));
}

bool WorldFlow::find_slope(const State& y, double& beta, PhaseJet& h) const {
  beta = minimising_slope(scene_, {{y[kX], y[kZ]}, y[kTheta], y[kW]},
                          {y[kPX], y[kPZ], y[kPTheta], y[kPW]}, beta);
  if (!std::isfinite(beta)) return false;
  h = hamiltonian_jet(scene_, inverse_radius_,
                      {y[kX], y[kZ], y[kTheta], y[kW], y[kPX], y[kPZ],
                       y[kPTheta], y[kPW], beta});
  return h.hessian[PhaseJet::pair(kPhaseBeta, kPhaseBeta)] > 0.0;
}

State WorldFlow::rates(const PhaseJet& h) {
  State f;
  for (std::size_t i = 0; i < kStates; ++i) {
    f[i] = h.gradient[kStates + i];
    f[kStates + i] = -h.gradient[i];
  }
  return f;
}

double WorldFlow::slope_variation(const PhaseJet& h, const State& v) {
  double change = 0.0;
  for (std::size_t i = 0; i < kSize; ++i) {
    change += h.hessian[PhaseJet::pair(kPhaseBeta, static_cast<int>(i))] * v[i];
  }
  return -change / h.hessian[PhaseJet::pair(kPhaseBeta, kPhaseBeta)];
}

State WorldFlow::variation(const PhaseJet& h, const State& v) {
  const double d_beta = slope_variation(h, v);
  State gradient;
  for (int i = 0; i < static_cast<int>(kSize); ++i) {
    double sum = h.hessian[PhaseJet::pair(kPhaseBeta, i)] * d_beta;
    for (int j = 0; j < static_cast<int>(kSize); ++j) {
      sum += h.hessian[PhaseJet::pair(std::max(i, j), std::min(i, j))] *
             v[static_cast<std::size_t>(j)];
    }
    gradient[static_cast<std::size_t>(i)] = sum;
  }
  State out;
  for (std::size_t i = 0; i < kStates; ++i) {
    out[i] = gradient[kStates + i];
    out[kStates + i] = -gradient[i];
  }
  return out;
}

double WorldFlow::time_rate(const State& y, double beta) const {
  return root_of_inertia(scene_.body, y[kTheta], beta);
}

double WorldFlow::time_variation(const State& y, double beta, const PhaseJet& h,
                                 const State& v) const {
  // ∂√A/∂β = −∂√A/∂θ = η cos(θ − β)/√A
  const double slope =
      scene_.body.eta_m * std::cos(y[kTheta] - beta) / time_rate(y, beta);
  return slope * (slope_variation(h, v) - v[kTheta]);
}

bool integrate_arc(const WorldFlow& flow, const State& start, double near,
                   double span, const shooting::StepControl& control,
                   double& step, ArcEnd& end) {
  end.steps = 0;
  const auto arrived =
      travel<kSize>(flow, start, near, span, control, step,
                    [&](double, const auto&, double) { ++end.steps; });
  if (!arrived) return false;
  const Passed last = passed(span, arrived->now, arrived->beta);
  end.y = last.y;
  end.t = last.t;
  end.beta = last.beta;
  std::copy_n(arrived->slope.begin(), kSize, end.rates.begin());
  end.time_rate = arrived->slope[kTime];
  for (std::size_t j = 0; j < kSize; ++j) {
    const auto column = static_cast<Eigen::Index>(j);
    const double* derivatives = arrived->now.data() + kPath * (1 + j);
    end.by_start.col(column) =
        Eigen::Map<const Eigen::Matrix<double, ArcEnd::kWidth, 1>>(derivatives);
    end.time_by_start(column) = derivatives[kTime];
  }
  return true;
}

bool follow_arc(const WorldFlow& flow, const State& start, double near,
                double span, const shooting::StepControl& control,
                const std::function<void(const Passed&)>& tell) {
  PhaseJet unused;
  double beta = near;
  if (!flow.find_slope(start, beta, unused)) return false;
  tell(passed(0.0, stack_of<0>(start), beta));
  double step = 0.0;
  return travel<0>(flow, start, near, span, control, step,
                   [&](double u, const auto& stack, double slope) {
                     tell(passed(u, stack, slope));
                   })
      .has_value();
}

Passed step_from(const WorldFlow& flow, const Passed& from, double span) {
  using Rates = WorldRates<0>;
  shooting::AdaptiveIntegration<Rates> path(Rates{flow, from.beta},
                                            stack_of<0>(from.y, from.t));
  path.step_unchecked(span);
  return passed(from.u + span, path.now(), path.beta());
}

}  // namespace brachisto::worlds
