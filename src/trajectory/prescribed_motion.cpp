// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "trajectory/prescribed_motion.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "brachisto/math/clock.hpp"
#include "brachisto/math/index.hpp"
#include "brachisto/math/jet.hpp"
#include "brachisto/math/polynomial_basis.hpp"
#include "math/roots.hpp"
#include "model/energy.hpp"
#include "model/path_inequality.hpp"

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
    case Reason::NotFollowed:
      return "the body is braked too hard to be followed; " + place;
  }
  return {};
}

struct PrescribedMotion::Points {
  std::array<CurvePlace, kGaussPoints> places;
  std::array<double, kGaussPoints> s;       ///< arc lengths [m]
  std::array<double, kGaussPoints> energy;  ///< ½ w² [m²/s²]
};

PrescribedMotion::PrescribedMotion(const Scene& scene, PlaneCurvePtr centre)
    : scene_(scene), curve_(std::move(centre)), start_(curve_->at(0.0)) {
  const double w = pushed_w(scene_, start_.beta);
  start_energy_ = 0.5 * w * w;
  const double pushed =
      root_of_inertia(scene_.body, scene_.body.theta_m, start_.beta) *
      scene_.world.start_speed;
  start_kinetic_ = 0.5 * pushed * pushed;
  // s = ½ s'' q² and ½ w² = w' s at the start: from rest w = q √(w' s'').
  const double gain = gain_at_rest(start_, 0.0);
  const double s_bend = curve_->pace(kNextToStart).speed / kNextToStart;
  if (!(s_bend > 0.0)) {
    stall_ = Stall{Stall::Reason::DoesNotFit, 0.0, curve_->start()};
  } else if (!(gain > 0.0 || w > 0.0)) {
    stall_ = Stall{Stall::Reason::DoesNotStart, 0.0, curve_->start()};
  }
  if (stall_) return;
  start_rate_ = std::sqrt(s_bend / gain);
  end_pieces();
  if (stall_) return;

  const auto pieces = static_cast<int>(ends_.size());
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
  const Body& body = scene_.body;
  const double theta = theta_after(body, s);
  // The way of the centre of mass, r η (cos θ − cos θ_m) as a product.
  const double half = 0.5 * (theta - body.theta_m);
  const Point by{place.offset.x - 2.0 * body.radius * body.eta_m *
                                      std::sin(half) *
                                      std::sin(half + body.theta_m),
                 energy_height(body, place.offset.z, theta)};
  const Point from = mass_centre(body, curve_->start(), body.theta_m);
  return start_kinetic_ +
         potential_fall(scene_, from, {from.x + by.x, from.z + by.z}, by);
}

double PrescribedMotion::gain_at_rest(const CurvePlace& place, double s) const {
  const Point centre = point_of(*curve_, place);
  const double theta = theta_after(scene_.body, s);
  return speed_gain(scene_, TurningPoint<double>{centre.x, centre.z, theta, 0.0,
                                                 place.beta, 0.0});
}

double PrescribedMotion::start_w() const {
  return std::sqrt(2.0 * start_energy_);
}

double PrescribedMotion::start_curvature() const {
  const PlaneCurve::Pace next = curve_->pace(kNextToStart);
  return next.turning / next.speed;
}

/// Puts the energies with what brakes in place of those without, NaN if it
/// stops the body; returns that at the end.
double PrescribedMotion::brake(const Sums& from, double width,
                               Points& points) const {
  constexpr int kMostSteps = 60;
  constexpr double kConverged = 1e-10;  // relative; the next step squares it
  using Jet = math::Jet1<double, 1>;
  using Vector = Eigen::Vector<double, kGaussPoints>;
  const Body& body = scene_.body;
  const math::SmallMatrix& to_point = integration_to_points();
  const Vector weights = Eigen::Map<const Vector>(rule().weights.data());
  Vector w = Eigen::Map<const Vector>(points.energy.data());
  w = (2.0 * w).cwiseSqrt().eval();
  Vector gain, by_w;
  for (int step = 0; step < kMostSteps && w.allFinite(); ++step) {
    for (int i = 0; i < kGaussPoints; ++i) {
      const CurvePlace& place = points.places[brachisto::at(i)];
      const double theta = theta_after(body, points.s[brachisto::at(i)]);
      const Point centre = point_of(*curve_, place);
      const Jet found =
          speed_gain(scene_, Jet(centre.x), Jet(centre.z), Jet(theta),
                     Jet::variable(w[i], 0), Jet(place.beta),
                     Jet(root_of_inertia(scene_, theta, place.beta)));
      gain[i] = width * place.speed * found.value;
      by_w[i] = width * place.speed * found.gradient[0];
    }
    // ½ w_i² = ½ w² + Σ a_ij gain_j: quadratic in w, so that Newton's method
    // comes down from above.
    Eigen::Matrix<double, kGaussPoints, kGaussPoints> matrix;
    Vector miss;
    for (int i = 0; i < kGaussPoints; ++i) {
      miss[i] = from.energy - 0.5 * w[i] * w[i];
      for (int j = 0; j < kGaussPoints; ++j) {
        miss[i] += to_point(i, j) * gain[j];
        matrix(i, j) = -to_point(i, j) * by_w[j];
      }
      matrix(i, i) += w[i];
    }
    const Vector by = matrix.partialPivLu().solve(miss);
    const double change = (by.array() / w.array()).abs().maxCoeff();
    w = (w + by).cwiseMax(0.1 * w).eval();
    if (!(change <= kConverged)) continue;
    Eigen::Map<Vector>(points.energy.data()) = 0.5 * w.cwiseAbs2();
    return from.energy + weights.dot(gain + by_w.cwiseProduct(by));
  }
  points.energy.fill(std::numeric_limits<double>::quiet_NaN());
  return points.energy.back();
}

std::variant<PrescribedMotion::Sums, Stall> PrescribedMotion::advance(
    const Sums& from, double q) const {
  const math::SmallMatrix& to_point = integration_to_points();
  const double width = q - from.q;
  Points points;
  auto& [places, s, energies] = points;
  bool fits = true;
  for (std::size_t i = 0; i < places.size(); ++i) {
    places[i] = curve_->at(from.q + width * rule().points[i]);
    fits = fits && places[i].speed > 0.0;
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    double length = 0.0;
    for (std::size_t j = 0; j < places.size(); ++j) {
      length +=
          to_point(static_cast<int>(i), static_cast<int>(j)) * places[j].speed;
    }
    s[i] = from.s + width * length;
    energies[i] = energy(places[i], s[i]);
  }
  Sums to = from;
  to.q = q;
  if (fits && scene_.world.brakes()) to.energy = brake(from, width, points);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const CurvePlace& place = places[i];
    const bool fits_here = place.speed > 0.0;
    if (!fits_here || !(energies[i] > 0.0)) {
      return Stall{fits_here ? Stall::Reason::Stops : Stall::Reason::DoesNotFit,
                   from.q + width * rule().points[i], point_of(*curve_, place)};
    }
    const double du =
        rule().weights[i] * width * place.speed / std::sqrt(2.0 * energies[i]);
    to.u += du;
    const double theta = theta_after(scene_.body, s[i]);
    to.t += root_of_inertia(scene_, theta, place.beta) * du;
    to.s += rule().weights[i] * width * place.speed;
  }
  return to;
}

/// Joints of the curve, passages of a surface, and what divide() adds.
void PrescribedMotion::end_pieces() {
  ends_ = curve_->joints();
  ends_.push_back(1.0);
  if (scene_.world.sphere) {
    // Between so many places a path is as good as straight.
    const int parts = std::max(1, 64 / static_cast<int>(ends_.size()));
    constexpr double kNoLength = 1e-6;  // A itself may lie on the surface
    double q = 0.0, s = 0.0;
    const auto length_to = [&](double there) {
      return s + integral(q, there,
                          [&](double p) { return curve_->pace(p).speed; });
    };
    const auto height = [&](double there) {
      const CurvePlace place = curve_->at(there);
      return height_above_surface(
          scene_, mass_centre(scene_.body, point_of(*curve_, place),
                              theta_after(scene_.body, length_to(there))));
    };
    double before = height(0.0);
    std::vector<double> ends;
    for (const double end : ends_) {
      const double from = q;
      for (int i = 1; i <= parts; ++i) {
        check_stop();
        const double next =
            std::lerp(from, end, static_cast<double>(i) / parts);
        const double at = height(next);
        if ((at > 0.0) != (before > 0.0)) {
          const double root = math::find_root(height, q, next, before, at);
          if (root > kNoLength) ends.push_back(root);
        }
        s = length_to(next);
        q = next;
        before = at;
      }
      if (ends.empty() || ends.back() < end) ends.push_back(end);
    }
    ends_ = std::move(ends);
  }
  if (!scene_.world.brakes()) return;
  std::vector<double> divided;
  Sums from;
  from.energy = start_energy_;
  for (const double end : ends_) {
    if (!stall_) divide(from, end, divided);
  }
  ends_ = std::move(divided);
}

/// Adds ends on the way to a place, itself among them, between which a step and
/// its two halves agree; moves there.
void PrescribedMotion::divide(Sums& from, double to,
                              std::vector<double>& ends) {
  constexpr double kAgreement = 1e-7;  // the next halving leaves rounding
  constexpr double kRounding = 1e-15;
  constexpr double kShortest = 1e-12;
  check_stop();
  const double middle = 0.5 * (from.q + to);
  const std::variant<Sums, Stall> whole = advance(from, to);
  std::variant<Sums, Stall> halves = advance(from, middle);
  if (const Sums* half = std::get_if<Sums>(&halves))
    halves = advance(*half, to);
  const Sums* one = std::get_if<Sums>(&whole);
  const Sums* two = std::get_if<Sums>(&halves);
  if (one != nullptr && two != nullptr && two->energy > 0.0 &&
      std::abs(one->t - two->t) <= kAgreement * (two->t - from.t) &&
      std::abs(one->energy - two->energy) <=
          kAgreement * two->energy +
              kRounding * energy(curve_->at(to), two->s)) {
    from = *two;
    ends.push_back(to);
    return;
  }
  if (to - from.q <= kShortest) {
    const CurvePlace place = curve_->at(to);
    stall_ = Stall{Stall::Reason::Stops, to, point_of(*curve_, place)};
    if (const Stall* found = std::get_if<Stall>(&halves)) stall_ = *found;
    // What is drawn along moves on whatever brakes.
    if (stall_->reason == Stall::Reason::Stops &&
        gain_at_rest(place, from.s) > 0.0) {
      stall_->reason = Stall::Reason::NotFollowed;
    }
    return;
  }
  divide(from, middle, ends);
  if (!stall_) divide(from, to, ends);
}

void PrescribedMotion::integrate(int cells_per_piece) {
  cells_ = {Sums{}};
  cells_.front().energy = start_energy_;
  double from = 0.0;
  for (const double to : ends_) {
    for (int i = 1; i <= cells_per_piece; ++i) {
      check_stop();
      const double q =
          i == cells_per_piece ? to : from + (to - from) * i / cells_per_piece;
      const std::variant<Sums, Stall> next = advance(cells_.back(), q);
      if (const Stall* stall = std::get_if<Stall>(&next)) {
        stall_ = *stall;
        if (scene_.world.ordinary()) return;
        Sums last = cells_.back();
        for (double half = 0.5 * (q - last.q); half > 1e-12; half *= 0.5) {
          const std::variant<Sums, Stall> part = advance(last, last.q + half);
          if (std::holds_alternative<Stall>(part)) {
            stall_ = std::get<Stall>(part);
          } else {
            last = std::get<Sums>(part);
          }
        }
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
  const double E = scene_.world.brakes() ? sums.energy : energy(place, sums.s);
  if (sums.q > 0.0 && E > 0.0) {
    state.w = std::sqrt(2.0 * E);
    // dβ/du; at the start the limit of dq/du.
    state.beta_rate = place.turning * state.w / place.speed;
  } else {
    state.w = start_w();
    state.beta_rate = start_slope_rate();
  }
  out.motion = kinematics(scene_, state);
  return out;
}

StartLimits PrescribedMotion::at_start() const {
  const PathState start{curve_->start(), scene_.body.theta_m, start_.beta,
                        start_w(), start_slope_rate()};
  if (start_energy_ > 0.0 || start_.turning != 0.0) {
    return start_limits(scene_, start);
  }
  return start_limits_of_curvature(scene_, start, start_curvature());
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
