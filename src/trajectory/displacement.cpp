// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "trajectory/displacement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "brachisto/math/index.hpp"
#include "brachisto/math/jet.hpp"
#include "brachisto/math/polynomial_basis.hpp"
#include "model/field.hpp"
#include "model/inertia.hpp"
#include "trajectory/braking.hpp"

namespace brachisto {

namespace {

/// Of Radau in each panel, whose last one is its end: what relaxes within a
/// panel, as the speed in thick air, is gone at its end.
constexpr int kInPanel = 4;

/// A point of a rule along the motion.
struct Sample {
  double s, ds, dt;             ///< place, weights
  double s_in_panel[kInPanel];  ///< of Δs' at the points of its panel, to here
  double beta, kappa, theta, A, half_w2, drag;
  Point centre;
};

/// The place that the centre reaches after the length s, between two rows.
TrajectoryPoint row_at_length(const Motion& motion, double s) {
  double low = 0.0, high = 1.0;
  for (int i = 0; i < std::numeric_limits<double>::digits; ++i) {
    const double middle = 0.5 * (low + high);
    (motion.at(middle).s < s ? low : high) = middle;
  }
  return motion.at(high);
}

/// The motion between rows that no feature lies between, and that the ends of
/// stretches are among.
class SampledMotion {
 public:
  SampledMotion(const Motion& motion, const std::vector<TrajectoryPoint>& ends)
      : scene_(motion.scene()) {
    constexpr int kPerStretch = 40;
    std::vector<TrajectoryPoint> rows =
        motion.fine_sample(kPerStretch * (static_cast<int>(ends.size()) - 1));
    rows.insert(rows.end(), ends.begin(), ends.end());
    std::ranges::sort(rows, {}, &TrajectoryPoint::s);
    const math::QuadratureRule rule = math::radau_right(kInPanel);
    // Lengths and times between two rows as polynomials through the first and
    // the points.
    std::vector<double> places{0.0};
    places.insert(places.end(), rule.points.begin(), rule.points.end());
    const math::SmallMatrix slopes =
        math::LagrangeBasis(places).slopes_at(rule.points);
    const math::SmallMatrix sums =
        math::LagrangeBasis(rule.points).integrals_to(rule.points, rule);
    for (std::size_t i = 1; i < rows.size(); ++i) {
      add_panel(motion, rows[i - 1], rows[i], rule, slopes, sums);
    }
  }

  /// ΔT; see displaced_stretches().
  [[nodiscard]] double change(double from, double to, double height) const {
    const double half = 0.5 * (to - from), middle = 0.5 * (from + to);
    // Beyond the stretch the body may be turned otherwise, or be slower.
    const bool to_the_end = scene_.body.off_centred() || scene_.world.air.any();
    double sum = 0.0, longer = 0.0, lost = 0.0;
    auto panel = static_cast<std::size_t>(
        std::ranges::partition_point(
            samples_, [&](const Sample& at) { return at.s <= from; }) -
        samples_.begin());
    for (; panel < samples_.size(); panel += kInPanel) {
      const std::span<const Sample> points =
          std::span(samples_).subspan(panel, kInPanel);
      const bool within = points.front().s < to;
      if (!within && !to_the_end) break;
      std::array<Bend, kInPanel> bends;
      if (within) {
        for (int i = 0; i < kInPanel; ++i) {
          bends[at(i)] = bend_at(
              points[at(i)], (points[at(i)].s - middle) / half, height, half);
        }
      }
      std::array<Displaced, kInPanel> displaced;
      for (int i = 0; i < kInPanel; ++i) {
        const Sample& here = points[at(i)];
        double behind = longer;
        for (int j = 0; j < kInPanel; ++j) {
          behind += here.s_in_panel[j] * (bends[at(j)].stretch - 1.0);
        }
        displaced[at(i)] = displaced_at(here, bends[at(i)], behind);
      }
      if (scene_.world.air.any()) brake(points, bends, displaced, lost);
      for (int i = 0; i < kInPanel; ++i) {
        const Sample& here = points[at(i)];
        const auto& [A, half_w2] = displaced[at(i)];
        const double slower = bends[at(i)].stretch *
                              std::sqrt(A / here.A * here.half_w2 / half_w2);
        sum += (slower - 1.0) * here.dt;
      }
      for (int i = 0; i < kInPanel; ++i) {
        longer += points[at(i)].ds * (bends[at(i)].stretch - 1.0);
      }
    }
    return std::isnan(sum) ? std::numeric_limits<double>::infinity() : sum;
  }

 private:
  /// What a displacement does at a place.
  struct Bend {
    double height = 0.0, stretch = 1.0, turn = 0.0;  ///< ε, ds*/ds, β* − β
  };
  /// A* and ½ w*².
  struct Displaced {
    double A, half_w2;
  };

  void add_panel(const Motion& motion, const TrajectoryPoint& from,
                 const TrajectoryPoint& to, const math::QuadratureRule& rule,
                 const math::SmallMatrix& slopes,
                 const math::SmallMatrix& sums) {
    const double width = to.sigma - from.sigma;
    if (!(width > 0.0)) return;
    std::vector<TrajectoryPoint> rows{from};
    for (int i = 0; i + 1 < kInPanel; ++i) {
      rows.push_back(motion.at(from.sigma + rule.points[at(i)] * width));
    }
    // As it is on this side of a junction of arcs.
    rows.push_back(to);
    double s_slope[kInPanel];
    for (int i = 0; i < kInPanel; ++i) {
      const TrajectoryPoint& row = rows[at(i + 1)];
      double t_slope = 0.0;
      s_slope[i] = 0.0;
      for (int j = 0; j < kInPanel + 1; ++j) {
        s_slope[i] += slopes(i, j) * (rows[at(j)].s - from.s);
        t_slope += slopes(i, j) * (rows[at(j)].t - from.t);
      }
      const double A = inertia_factor(scene_.body, row.theta, row.beta);
      const double weight = rule.weights[at(i)];
      samples_.push_back({row.s,
                          weight * s_slope[i],
                          weight * t_slope,
                          {},
                          row.beta,
                          curvature_of_centre(scene_.body, row.motion),
                          row.theta,
                          A,
                          0.5 * row.motion.v_c * row.motion.v_c * A,
                          drag(scene_.world.air, row.motion.v_c),
                          row.centre});
    }
    for (int i = 0; i < kInPanel; ++i) {
      Sample& sample = samples_[samples_.size() - kInPanel + at(i)];
      for (int j = 0; j < kInPanel; ++j) {
        sample.s_in_panel[j] = sums(i, j) * s_slope[j];
      }
    }
  }

  static Bend bend_at(const Sample& here, double x, double height,
                      double half) {
    const double q = 1.0 - x * x;
    const double epsilon = height * q * q * q;
    const double slope = -6.0 * height * x * q * q / half;
    const double along = 1.0 - here.kappa * epsilon;
    return {epsilon, std::hypot(along, slope), std::atan2(slope, along)};
  }

  /// As if there were no air.
  [[nodiscard]] Displaced displaced_at(const Sample& here, const Bend& bend,
                                       double behind) const {
    const Body& body = scene_.body;
    const double theta =
        body.rolls() ? here.theta + behind / body.radius : here.theta;
    const Point centre{here.centre.x - bend.height * std::sin(here.beta),
                       here.centre.z + bend.height * std::cos(here.beta)};
    const double fall =
        potential_fall(scene_, mass_centre(body, here.centre, here.theta),
                       mass_centre(body, centre, theta));
    return {inertia_factor(body, theta, here.beta + bend.turn),
            here.half_w2 + fall};
  }

  /// Takes from the energies at the points of a panel what more than on the
  /// path itself is lost to air until there, NaN where it stops the body.
  ///
  /// \param lost  until the panel; on return until its end
  void brake(std::span<const Sample> points,
             const std::array<Bend, kInPanel>& bends,
             std::array<Displaced, kInPanel>& displaced, double& lost) const {
    constexpr double kConverged = 1e-9;
    using Jet = math::Jet1<double, 1>;
    Eigen::Vector<double, kInPanel> w, known;
    for (int i = 0; i < kInPanel; ++i) {
      const Sample& here = points[at(i)];
      w[i] = std::sqrt(2.0 * here.half_w2);
      known[i] = displaced[at(i)].half_w2 - lost;
      for (int j = 0; j < kInPanel; ++j) {
        known[i] += here.s_in_panel[j] * points[at(j)].drag;
      }
    }
    const auto found = braked_speeds(
        w, known, [&](int i, int j) { return points[at(i)].s_in_panel[j]; },
        [&](int i, double w_i) {
          const Jet speed =
              Jet::variable(w_i, 0) * (1.0 / std::sqrt(displaced[at(i)].A));
          const Jet loss = drag(scene_.world.air, speed);
          const double stretch = -bends[at(i)].stretch;
          return std::pair(stretch * loss.value, stretch * loss.gradient[0]);
        },
        kConverged);
    if (!found) {
      displaced.fill({1.0, std::numeric_limits<double>::quiet_NaN()});
      return;
    }
    for (int i = 0; i < kInPanel; ++i) {
      const Sample& here = points[at(i)];
      displaced[at(i)].half_w2 = 0.5 * found->w[i] * found->w[i];
      lost += here.ds * (-found->rate[i] - here.drag);
    }
  }

  const Scene& scene_;
  std::vector<Sample> samples_;
};

}  // namespace

double DisplacedStretch::dearer() const {
  return std::abs(raised) > std::abs(lowered) ? raised : lowered;
}

std::vector<DisplacedStretch> displaced_stretches(const Motion& motion,
                                                  int count, double height) {
  if (motion.scene().world.losses.any()) return {};
  const double length = motion.centre_path_length();
  std::vector<TrajectoryPoint> ends;
  for (int i = 0; i <= count; ++i) {
    ends.push_back(i == 0       ? motion.at(0.0)
                   : i == count ? motion.at(1.0)
                                : row_at_length(motion, length * i / count));
  }
  const SampledMotion sampled(motion, ends);
  std::vector<DisplacedStretch> out;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const TrajectoryPoint &from = ends[i - 1], &to = ends[i];
    // The normal dt/dβ points downwards.
    out.push_back({from, row_at_length(motion, 0.5 * (from.s + to.s)), to,
                   sampled.change(from.s, to.s, -height),
                   sampled.change(from.s, to.s, height)});
  }
  return out;
}

}  // namespace brachisto
