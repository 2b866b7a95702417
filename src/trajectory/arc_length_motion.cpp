// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "trajectory/arc_length_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/contact.hpp"
#include "model/cubic_spline.hpp"
#include "model/start_angle.hpp"
#include "transcription/arc_length.hpp"

namespace brachisto {

namespace {

/// The nodes of the curve: three wide pieces at the start, the first of which
/// is continued to it, then narrow ones, the last a bit wider.
std::vector<int> nodes_of_curve(int n) {
  constexpr double kMostNarrow = 4000.0;
  const double root = std::sqrt(static_cast<double>(n));
  const int wide = std::max(1, static_cast<int>(std::lround(0.5 * root)));
  const int narrow = std::max(
      {1, static_cast<int>(std::lround(std::sqrt(root) / 1.5)),
       static_cast<int>(std::ceil(static_cast<double>(n) / kMostNarrow))});
  std::vector<int> nodes{wide, 2 * wide, 3 * wide};
  while (nodes.back() + 2 * narrow <= n) {
    nodes.push_back(nodes.back() + narrow);
  }
  if (nodes.back() < n) nodes.push_back(n);
  return nodes;
}

/// The last node and every second one before it.
std::vector<int> thinned(const std::vector<int>& nodes) {
  std::vector<int> few;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if ((nodes.size() - 1 - i) % 2 == 0) few.push_back(nodes[i]);
  }
  return few;
}

/// Places σ, and how far the centre is there from its start.
struct Distances {
  std::vector<double> sigma;
  std::vector<Point> offsets;
};

Distances places_of(const std::vector<int>& nodes, const ArcLength& problem,
                    std::span<const double> x, const Units& units) {
  Distances out;
  for (const int node : nodes) {
    const auto i = static_cast<std::size_t>(
        problem.layout().state(node, StateComponent::X));
    out.sigma.push_back(problem.sigma(node));
    out.offsets.push_back({x[i] * units.length, x[i + 1] * units.length});
  }
  return out;
}

PlaneCurvePtr curve_through(const Distances& places, double length,
                            double end_angle, const Scene& scene) {
  // s = σ² length.
  const double beta = start_angle(scene.body), twice = 2.0 * length;
  return curve_from_rest(
      start_of_centre(scene),
      {{length * std::cos(beta), length * std::sin(beta)},
       Point{twice * std::cos(end_angle), twice * std::sin(end_angle)}},
      places.sigma, places.offsets);
}

/// The direction of the cubic through (x, z)/σ² of the first four places,
/// continued to the start.
double angle_at_start(const Distances& places) {
  const std::size_t count = std::min<std::size_t>(4, places.sigma.size());
  const std::vector<double> sigma(
      places.sigma.begin(),
      places.sigma.begin() + static_cast<std::ptrdiff_t>(count));
  const auto continued = [&](double Point::*which) {
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i) {
      values.push_back(places.offsets[i].*which / (sigma[i] * sigma[i]));
    }
    return CubicSpline(sigma, values).at(0, 0.0).f;
  };
  return std::atan2(continued(&Point::z), continued(&Point::x));
}

/// What a figure of two motions differs by about the place where it is least,
/// the first tenth of the way, where it may rise from zero, left out.
template <class Figure>
double difference(const Motion& motion, const Motion& other, int num_pieces,
                  Figure&& figure) {
  constexpr double kFirst = 0.1;
  const double about = 4.0 / num_pieces;
  const std::vector<TrajectoryPoint> rows = motion.fine_sample(0);
  const TrajectoryPoint* least = &rows.back();
  for (const TrajectoryPoint& row : rows) {
    if (row.sigma > kFirst && figure(row.motion) < figure(least->motion)) {
      least = &row;
    }
  }
  double largest = 0.0;
  for (const TrajectoryPoint& row : rows) {
    if (std::abs(row.sigma - least->sigma) > about || row.sigma < kFirst) {
      continue;
    }
    largest = std::max(largest, std::abs(figure(row.motion) -
                                         figure(other.at(row.sigma).motion)));
  }
  return largest;
}

}  // namespace

ArcLengthMotion::ArcLengthMotion(const ArcLength& problem,
                                 std::span<const double> x, double T,
                                 double end_angle, const Scene& scene,
                                 const Units& units)
    : ArcLengthMotion(nodes_of_curve(problem.num_intervals()), problem, x, T,
                      end_angle, scene, units) {}

ArcLengthMotion::ArcLengthMotion(const std::vector<int>& nodes,
                                 const ArcLength& problem,
                                 std::span<const double> x, double T,
                                 double end_angle, const Scene& scene,
                                 const Units& units)
    : on_curve_(scene,
                curve_through(places_of(nodes, problem, x, units),
                              x.back() * units.length, end_angle, scene)),
      coarser_(curve_through(places_of(thinned(nodes), problem, x, units),
                             x.back() * units.length, end_angle, scene)),
      transit_time_(T * units.time),
      length_(x.back() * units.length),
      end_angle_(end_angle),
      continued_start_angle_(
          angle_at_start(places_of(nodes, problem, x, units))),
      num_pieces_(problem.num_intervals()) {}

PathDiagnostics ArcLengthMotion::diagnose() const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  PathDiagnostics out = Motion::diagnose();
  out.normal_force_error = out.fold_margin_error = kInfinity;
  const PrescribedMotion coarser(scene(), coarser_);
  if (coarser.stall()) return out;
  const PathDiagnostics other = coarser.diagnose();
  // The sign of dR_n/du at the start decides whether it lifts off and folds.
  const double rate = out.at_start.normal_force_rate;
  if (!(std::abs(rate - other.at_start.normal_force_rate) < std::abs(rate))) {
    return out;
  }
  const double of_nodes = 1.0 / (1.0 * num_pieces_ * num_pieces_);
  const auto error = [&](auto&& figure, const Extreme& least,
                         const Extreme& least_of_other) {
    return of_nodes + std::max(std::abs(least.value - least_of_other.value),
                               difference(*this, coarser, num_pieces_, figure));
  };
  out.normal_force_error =
      error([](const Kinematics& at) { return at.R_n; },
            out.normal_force_after_rise, other.normal_force_after_rise);
  out.fold_margin_error =
      error([](const Kinematics& at) { return at.fold_margin; },
            out.min_fold_margin, other.min_fold_margin);
  return out;
}

double ArcLengthMotion::start_angle() const {
  return brachisto::start_angle(scene().body);
}

StartLimits ArcLengthMotion::at_start() const {
  return start_limits(scene().body, start_angle(),
                      on_curve_.start_slope_rate());
}

}  // namespace brachisto
