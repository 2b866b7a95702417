// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "trajectory/prescribed_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "brachisto/math/stop_condition.hpp"
#include "math/gauss.hpp"
#include "math/polynomial_basis.hpp"
#include "model/energy.hpp"
#include "model/inertia.hpp"

namespace brachisto {

namespace {

constexpr int kGaussPoints = 12;
constexpr int kFewestCells = 16;
constexpr double kTolerance = 1e-13;  // of T, relative
constexpr int kFineSamplesPerCell = 8;
constexpr double kNextToStart = 1e-8;  // q there has the limits of the start

const math::QuadratureRule& rule() {
  static const math::QuadratureRule gauss = math::gauss_legendre(kGaussPoints);
  return gauss;
}

/// Row i integrates a polynomial given at the points, from 0 to point i.
const math::SmallMatrix& integration_to_points() {
  static const math::SmallMatrix matrix =
      math::LagrangeBasis(rule().points).integrals_to(rule().points, rule());
  return matrix;
}

/// θ once the centre has come the length s.
double theta_after(const Body& body, double s) {
  return body.rolls() ? body.theta_m + s / body.radius : body.theta_m;
}

/// ∫ f dq from `from` to `to`.
template <class Function>
double integral(double from, double to, Function&& f) {
  double sum = 0.0;
  for (std::size_t i = 0; i < rule().points.size(); ++i) {
    sum += rule().weights[i] * f(from + (to - from) * rule().points[i]);
  }
  return (to - from) * sum;
}

}  // namespace

std::string Stall::message() const {
  const std::string place = fmt::format(
      "the centre is at x = {:.6g} m, z = {:.6g} m", centre.x, centre.z);
  switch (reason) {
    case Reason::DoesNotStart:
      return "released from rest the body does not start to move along the "
             "given path";
    case Reason::Stops:
      return "the body stalls: its energy is used up where " + place;
    case Reason::DoesNotFit:
      return "the body does not fit into a valley of the given track; " + place;
  }
  return {};
}

PrescribedMotion::PrescribedMotion(const Scene& scene, PlaneCurvePtr centre)
    : scene_(scene), curve_(std::move(centre)), start_(curve_->at(0.0)) {
  const Body& body = scene_.body;
  // s = ½ s'' q² and E = a s at the start, so that w = q √(g a s'').
  const double a = energy_slope(body, body.theta_m, start_.beta);
  const double s_bend = curve_->pace(kNextToStart).speed / kNextToStart;
  if (!(s_bend > 0.0)) {
    stall_ = Stall{Stall::Reason::DoesNotFit, 0.0, curve_->start()};
  } else if (!(a > 0.0)) {
    stall_ = Stall{Stall::Reason::DoesNotStart, 0.0, curve_->start()};
  }
  if (stall_) return;
  start_rate_ = std::sqrt(s_bend / (scene_.gravity * a));

  const auto pieces = static_cast<int>(curve_->joints().size()) + 1;
  int cells = std::max(1, kFewestCells / pieces);
  integrate(cells);
  error_ = std::numeric_limits<double>::infinity();
  while (!stall_ && error_ > kTolerance) {
    cells *= 2;
    const double before = cells_.back().t;
    integrate(cells);
    const double change = std::abs(cells_.back().t / before - 1.0) +
                          std::numeric_limits<double>::epsilon();
    const bool rounding_rules = !(change < 0.5 * error_);
    error_ = change;
    if (rounding_rules) break;
  }
}

double PrescribedMotion::energy(const CurvePlace& place, double s) const {
  return energy_height(scene_.body, place.offset.z,
                       theta_after(scene_.body, s));
}

std::variant<PrescribedMotion::Sums, Stall> PrescribedMotion::advance(
    const Sums& from, double q) const {
  const Body& body = scene_.body;
  const math::SmallMatrix& to_point = integration_to_points();
  const double width = q - from.q;
  std::array<CurvePlace, kGaussPoints> places;
  for (std::size_t i = 0; i < places.size(); ++i) {
    places[i] = curve_->at(from.q + width * rule().points[i]);
  }
  Sums to = from;
  to.q = q;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const CurvePlace& place = places[i];
    double length = 0.0;
    for (std::size_t j = 0; j < places.size(); ++j) {
      length +=
          to_point(static_cast<int>(i), static_cast<int>(j)) * places[j].speed;
    }
    const double s = from.s + width * length;
    const double E = energy(place, s);
    const bool fits = place.speed > 0.0;
    if (!fits || !(E > 0.0)) {
      return Stall{fits ? Stall::Reason::Stops : Stall::Reason::DoesNotFit,
                   from.q + width * rule().points[i], point_of(*curve_, place)};
    }
    const double A = inertia_factor(body, theta_after(body, s), place.beta);
    const double du =
        rule().weights[i] * width * place.speed / fall_speed(scene_.gravity, E);
    to.u += du;
    to.t += std::sqrt(A) * du;
    to.s += rule().weights[i] * width * place.speed;
  }
  return to;
}

void PrescribedMotion::integrate(int cells_per_piece) {
  std::vector<double> ends = curve_->joints();
  ends.push_back(1.0);
  cells_ = {Sums{}};
  double from = 0.0;
  for (const double to : ends) {
    for (int i = 1; i <= cells_per_piece; ++i) {
      check_stop();
      const double q =
          i == cells_per_piece ? to : from + (to - from) * i / cells_per_piece;
      const std::variant<Sums, Stall> next = advance(cells_.back(), q);
      if (const Stall* stall = std::get_if<Stall>(&next)) {
        stall_ = *stall;
        return;
      }
      cells_.push_back(std::get<Sums>(next));
    }
    from = to;
  }
}

PrescribedMotion::Sums PrescribedMotion::sums_at(double q) const {
  const auto after = std::upper_bound(
      cells_.begin() + 1, cells_.end() - 1, q,
      [](double value, const Sums& cell) { return value < cell.q; });
  const Sums& from = *(after - 1);
  // Where the cells were passed no place between their nodes can stop the body
  // but for rounding.
  const std::variant<Sums, Stall> at = advance(from, q);
  return std::holds_alternative<Sums>(at) ? std::get<Sums>(at) : from;
}

double PrescribedMotion::place_at_length(double s) const {
  const auto after = std::upper_bound(
      cells_.begin() + 1, cells_.end() - 1, s,
      [](double value, const Sums& cell) { return value < cell.s; });
  const Sums& from = *(after - 1);
  const Sums& to = *after;
  // s grows like q², and q by Newton's method from there.
  const double share = std::clamp((s - from.s) / (to.s - from.s), 0.0, 1.0);
  double q = std::sqrt(std::lerp(from.q * from.q, to.q * to.q, share));
  constexpr int kMostSteps = 20;
  for (int i = 0; i < kMostSteps; ++i) {
    const double speed = curve_->pace(q).speed;
    if (!(speed > 0.0)) break;
    const double length = from.s + integral(from.q, q, [&](double p) {
                            return curve_->pace(p).speed;
                          });
    const double step = (s - length) / speed;
    q = std::clamp(q + step, from.q, to.q);
    // The next step would be the square of this one, over the length on which
    // the speed changes: q next to the start, a cell elsewhere.
    if (std::abs(step) <= 1e-8 * std::min(q, to.q - from.q)) break;
  }
  return q;
}

TrajectoryPoint PrescribedMotion::point_at(const Sums& sums) const {
  const Body& body = scene_.body;
  const CurvePlace place = curve_->at(sums.q);
  TrajectoryPoint out;
  out.sigma = sums.q;
  out.u = sums.u;
  out.t = sums.t;
  out.s = sums.s;
  out.centre = point_of(*curve_, place);
  out.theta = theta_after(body, sums.s);
  out.beta = place.beta;
  PathState state{out.centre, out.theta, place.beta, 0.0, 0.0};
  const double E = energy(place, sums.s);
  const bool moves = sums.q > 0.0 && E > 0.0;
  if (moves) state.w = fall_speed(scene_.gravity, E);
  // dβ/du; at the start the limit of dq/du.
  state.beta_rate =
      moves ? place.turning * state.w / place.speed : start_slope_rate();
  out.motion = kinematics(body, scene_.gravity, state);
  return out;
}

StartLimits PrescribedMotion::at_start() const {
  if (start_.turning != 0.0) {
    return start_limits(scene_.body, start_.beta, start_slope_rate());
  }
  const CurvePlace next = curve_->at(kNextToStart);
  return start_limits_of_curvature(scene_, {{}, 0.0, start_.beta, 0.0, 0.0},
                                   next.turning / next.speed);
}

std::vector<TrajectoryPoint> PrescribedMotion::at_nodes() const {
  std::vector<TrajectoryPoint> rows;
  rows.reserve(cells_.size());
  for (const Sums& cell : cells_) rows.push_back(point_at(cell));
  return rows;
}

std::vector<TrajectoryPoint> PrescribedMotion::fine_sample(int least) const {
  const int per_cell = std::max(kFineSamplesPerCell, least / num_cells() + 1);
  std::vector<TrajectoryPoint> rows{point_at(cells_.front())};
  for (std::size_t c = 1; c < cells_.size(); ++c) {
    check_stop();
    const double from = cells_[c - 1].q;
    for (int i = 1; i <= per_cell; ++i) {
      rows.push_back(at(from + (cells_[c].q - from) * i / per_cell));
    }
  }
  return rows;
}

}  // namespace brachisto
