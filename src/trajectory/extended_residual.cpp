// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "trajectory/extended_residual.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "brachisto/math/clock.hpp"
#include "brachisto/math/index.hpp"
#include "brachisto/math/jet.hpp"
#include "math/nearby_sines.hpp"
#include "model/energy.hpp"
#include "rolling/rolling_body.hpp"
#include "trajectory/acceleration.hpp"

namespace brachisto {

namespace {

using enum StateComponent;
using Real = long double;

/// Keeps the largest absolute value and its index; a NaN stays.
struct Worst {
  long double value = 0.0L;
  int index = -1;

  void see(long double candidate, int i) {
    if (std::isnan(value) || std::abs(candidate) <= value) return;
    value = std::abs(candidate);
    index = i;
  }
};

/// Looks at the residuals of a point, one variable and one row after the other.
class Judge {
 public:
  Judge(const nlp::Problem& problem, const PrimalDual& point)
      : problem_(problem), point_(point) {}

  /// The Lagrangian's derivative has to be zero by a free variable, and a fixed
  /// one has to have its value.
  void see_slope(int variable, Real slope) {
    const nlp::Range range = problem_.variable_range(variable);
    if (range.single()) {
      fixed_value_.see(static_cast<Real>(point_.x[at(variable)]) - range.lower,
                       variable);
    } else {
      stationarity_.see(slope, variable);
    }
  }
  void see_defect(int row, Real defect) { defect_.see(defect, row); }

  [[nodiscard]] ExtendedResidual residual() const {
    ExtendedResidual out{static_cast<double>(stationarity_.value),
                         static_cast<double>(defect_.value),
                         static_cast<double>(fixed_value_.value),
                         {},
                         {}};
    if (stationarity_.index >= 0) {
      out.worst_variable = problem_.variable_name(stationarity_.index);
    }
    if (defect_.index >= 0) {
      out.worst_constraint = problem_.constraint_name(defect_.index);
    }
    return out;
  }

 private:
  const nlp::Problem& problem_;
  const PrimalDual& point_;
  Worst stationarity_, fixed_value_, defect_;
};

/// The gradient of the Lagrangian, of which only those components are kept that
/// the present element or piece adds to.
class GradientAlongPath {
 public:
  /// \param width  so many variables change with one of them
  GradientAlongPath(Judge& judge, int width)
      : judge_(judge), window_(at(width)) {}

  [[nodiscard]] Real& operator[](int variable) {
    return window_[at(variable - first_)];
  }
  /// Nothing is added any more to the variables before `next`.
  void leave_for(int next) {
    const auto left = window_.begin() + (next - first_);
    for (auto slope = window_.begin(); slope != left; ++slope) {
      judge_.see_slope(first_++, *slope);
    }
    std::fill(std::copy(left, window_.end(), window_.begin()), window_.end(),
              0.0L);
  }

 private:
  Judge& judge_;
  std::vector<Real> window_;
  int first_ = 0;
};

/// Place, rotation and √(2 g E) of a node.
struct Node {
  Real x = 0.0L, z = 0.0L, turned = 0.0L;
  /// By z and the rotation; 0 at the start, where it is given.
  math::Jet1<Real, 2> w;
};

/// Nodes in the order of the path.
class Nodes {
 public:
  Nodes(const ArcLength& problem, std::span<const double> x)
      : layout_(problem.layout()),
        scene_(problem.scene()),
        x_(x),
        sin_start_(std::sin(static_cast<Real>(scene_.body.theta_m))),
        cos_start_(std::cos(static_cast<Real>(scene_.body.theta_m))) {}

  [[nodiscard]] Node next(int number) {
    using Jet = math::Jet1<Real, 2>;
    Node out;
    out.x = x_[at(layout_.state(number, X))];
    out.z = x_[at(layout_.state(number, Z))];
    if (layout_.has_theta()) out.turned = x_[at(layout_.state(number, Theta))];
    const Jet half = Jet::variable(out.turned, 1) * 0.5L;
    const auto [sine, cosine] = sines_.at(half.value);
    const Real sin_mean = sin_start_ * cosine + cos_start_ * sine;
    const Real cos_mean = cos_start_ * cosine - sin_start_ * sine;
    out.w = sqrt(energy_height_halfway(scene_.body, Jet::variable(out.z, 0),
                                       half.chain(sine, cosine),
                                       half.chain(cos_mean, -sin_mean)) *
                 (2.0L * scene_.gravity));
    return out;
  }

 private:
  const VariableLayout& layout_;
  const Scene& scene_;
  std::span<const double> x_;
  Real sin_start_, cos_start_;
  math::NearbySines sines_;
};

/// \tparam First  the first of x, z, θ, w that rates depend on
template <std::size_t First>
ExtendedResidual collocation_residual(const RollingTime& problem,
                                      const PrimalDual& point) {
  // Derivatives by the states from there on, β and U.
  using Jet = math::Jet1<Real, 6 - First>;
  constexpr std::array kStates{X, Z, Theta, W};
  const VariableLayout& layout = problem.layout();
  const Mesh& mesh = problem.mesh();
  const CollocationScheme& scheme = problem.scheme();
  const int p = mesh.degree;
  const bool has_theta = layout.has_theta();
  const rolling::Steered steered(problem.scene(), {},
                                 rotation_per_length(problem.scene().body));
  const auto x = [&](int i) { return static_cast<Real>(point.x[at(i)]); };
  Judge judge(problem, point);
  GradientAlongPath gradient(judge, layout.state(p, W) + 1);
  Real by_U = 0.0L;

  for (int e = 0; e < mesh.num_elements(); ++e) {
    check_stop(e);
    const Real h = static_cast<Real>(mesh.boundaries[at(e + 1)]) -
                   static_cast<Real>(mesh.boundaries[at(e)]);
    for (int j = 0; j < p; ++j) {
      const int c = e * p + j;
      std::array<Jet, 5> yu{};
      for (std::size_t i = First; i < kStates.size(); ++i) {
        if (kStates[i] == Theta && !has_theta) continue;
        Real value = 0.0L;
        for (int n = 0; n <= p; ++n) {
          value += static_cast<Real>(scheme.interpolation(j, n)) *
                   x(layout.state(e * p + n, kStates[i]));
        }
        yu[i] = Jet::variable(value, static_cast<int>(i - First));
      }
      yu.back() = Jet::variable(x(layout.beta(c)), 4 - First);
      const Jet U = Jet::variable(x(layout.rolling_time()), 5 - First);
      const auto [root, f] = steered.rates(yu);

      // Lagrangian of the point: h (b U √A − Σ λ_i U f_i) + λᵀ D X.
      Jet lagrangian = U * root * scheme.rule.weights[at(j)];
      for (std::size_t i = 0; i < kStates.size(); ++i) {
        if (kStates[i] == Theta && !has_theta) continue;
        const int row = layout.defect(c, kStates[i]);
        const Real lambda = point.lambda[at(row)];
        const Jet rate = U * f[i];
        lagrangian += rate * -lambda;
        Real difference = 0.0L;
        for (int n = 0; n <= p; ++n) {
          const int k = layout.state(e * p + n, kStates[i]);
          const Real slope = scheme.derivative(j, n);
          difference += slope * x(k);
          gradient[k] += lambda * slope;
        }
        judge.see_defect(row, difference - h * rate.value);
      }
      for (int n = 0; n <= p; ++n) {
        const Real weight = h * static_cast<Real>(scheme.interpolation(j, n));
        for (std::size_t i = First; i < kStates.size(); ++i) {
          if (kStates[i] == Theta && !has_theta) continue;
          gradient[layout.state(e * p + n, kStates[i])] +=
              weight * lagrangian.gradient[i - First];
        }
      }
      gradient[layout.beta(c)] += h * lagrangian.gradient[4 - First];
      by_U += h * lagrangian.gradient[5 - First];
    }
    gradient.leave_for(layout.state((e + 1) * p, X));
  }
  gradient.leave_for(layout.rolling_time());
  judge.see_slope(layout.rolling_time(), by_U);
  return judge.residual();
}

}  // namespace

ExtendedResidual extended_residual(const RollingTime& problem,
                                   const PrimalDual& point) {
  return problem.scene().world.changes_rates()
             ? collocation_residual<0>(problem, point)
             : collocation_residual<2>(problem, point);
}

ExtendedResidual extended_residual(const ArcLength& problem,
                                   const PrimalDual& point) {
  // Derivatives with respect to Δx, Δz, r Δθ and the rotation in the middle of
  // a piece and the sum of w at its ends.
  using Jet = math::Jet1<Real, 5>;
  enum : std::uint8_t { kDx, kDz, kLength, kTheta, kSumOfW };
  const VariableLayout& layout = problem.layout();
  const Body& body = problem.scene().body;
  const Real r = body.radius;
  const Real eta = body.eta_m;
  const bool has_theta = layout.has_theta();
  const Real S = point.x[at(layout.arc_length())];
  const Real n = problem.num_intervals();
  Judge judge(problem, point);
  GradientAlongPath gradient(judge, layout.num_states());
  Real by_S = 0.0L;
  Nodes nodes(problem, point.x);
  math::NearbySines sines;

  // The start is given.
  Node before;
  for (int j = 1; j <= problem.num_intervals(); ++j) {
    check_stop(j);
    const Node own = nodes.next(j);
    const Real turn = own.turned - before.turned;
    const Real share = (2.0L * j - 1.0L) / (n * n);
    const Real middle = (j - 0.75L) / (2.0L * j - 1.0L);
    const Jet dx = Jet::variable(own.x - before.x, kDx);
    const Jet dz = Jet::variable(own.z - before.z, kDz);
    const Jet length = Jet::variable(has_theta ? r * turn : S * share, kLength);
    const Jet theta =
        Jet::variable(body.theta_m + before.turned + middle * turn, kTheta);
    const Jet sum = Jet::variable(own.w.value + before.w.value, kSumOfW);
    // The direction is (Δx, Δz)/(r Δθ), of modulus one at a solution only.
    const auto [sine, cosine] = sines.at(theta.value);
    const Jet A =
        Jet(1.0L + eta * eta + body.k) -
        (theta.chain(sine, cosine) * dx - theta.chain(cosine, -sine) * dz) /
            length * (2.0L * eta);
    Jet lagrangian = length * sqrt(A) * 2.0L / sum;
    const int row = layout.no_slip(j);
    const Jet slip = (dx * dx + dz * dz - length * length) *
                     (0.5L / problem.reference_length(j));
    judge.see_defect(row, slip.value);
    lagrangian += slip * static_cast<Real>(point.lambda[at(row)]);

    // By the unknowns of a node, at this end of the piece or at the other.
    const std::array<Real, 5>& by = lagrangian.gradient;
    const auto add = [&](int number, const Node& node, Real sign, Real part) {
      gradient[layout.state(number, X)] += sign * by[kDx];
      gradient[layout.state(number, Z)] +=
          sign * by[kDz] + by[kSumOfW] * node.w.gradient[0];
      if (!has_theta) return;
      gradient[layout.state(number, Theta)] += sign * r * by[kLength] +
                                               part * by[kTheta] +
                                               by[kSumOfW] * node.w.gradient[1];
    };
    if (j > 1) {
      add(j - 1, before, -1.0L, 1.0L - middle);
      gradient.leave_for(layout.state(j, X));
    }
    add(j, own, 1.0L, middle);
    if (has_theta) {
      const int place = layout.place(j);
      const Real sigma = j / n;
      const Real lambda = point.lambda[at(place)];
      judge.see_defect(place, own.turned * r - S * sigma * sigma);
      gradient[layout.state(j, Theta)] += lambda * r;
      by_S -= lambda * sigma * sigma;
    } else {
      by_S += by[kLength] * share;
    }
    before = own;
  }
  gradient.leave_for(layout.arc_length());
  judge.see_slope(layout.arc_length(), by_S);
  return judge.residual();
}

}  // namespace brachisto
