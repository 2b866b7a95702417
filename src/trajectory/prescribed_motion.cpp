// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "trajectory/prescribed_motion.hpp"

#include <fmt/format.h>

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
#include "trajectory/braking.hpp"

namespace brachisto {

namespace {

constexpr int kFewestCells = 16;
constexpr double kTolerance = 1e-13;   // of T, relative
constexpr double kNextToStart = 1e-8;  // q there has the limits of the start
// Closer to it the height, like q², is rounding.
constexpr double kForgottenAtOnce = 1e-8;

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

double PrescribedMotion::turned_after(double s) const {
  return scene_.body.rolls() ? s / scene_.body.radius : 0.0;
}

double PrescribedMotion::length_between(double from, double to) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < gauss_step::rule().points.size(); ++i) {
    sum +=
        gauss_step::rule().weights[i] *
        curve_->pace(from + (to - from) * gauss_step::rule().points[i]).speed;
  }
  return (to - from) * sum;
}

PrescribedMotion::PrescribedMotion(const Scene& scene, PlaneCurvePtr centre)
    : scene_(scene), curve_(std::move(centre)), start_(curve_->at(0.0)) {
  const double w = pushed_w(scene_, start_.beta);
  start_energy_ = 0.5 * w * w;
  const double pushed =
      root_of_inertia(scene_.body, scene_.body.theta_m, start_.beta) *
      scene_.world.start_speed;
  start_kinetic_ = 0.5 * pushed * pushed;
  // s = ½ s'' q² and ½ w² = w' s at the start: from rest w = q √(w' s'').
  // Of forces that balance rounding leaves something.
  constexpr double kBalance = 1e-13;
  const double gain = gain_at_rest(start_, 0.0);
  const double s_bend = curve_->pace(kNextToStart).speed / kNextToStart;
  if (!(s_bend > 0.0)) {
    stall_ = Stall{Stall::Reason::DoesNotFit, 0.0, curve_->start()};
  } else if (!(gain > kBalance * scene_.gravity || w > 0.0)) {
    stall_ = Stall{Stall::Reason::DoesNotStart, 0.0, curve_->start()};
  }
  if (stall_) return;
  start_rate_ = std::sqrt(s_bend / gain);
  memory_ = w / std::sqrt(s_bend * gain);
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
  // No halving sees what T lacks by a push that no cell resolves.
  if (memory_ > 0.0 && memory_ <= kForgottenAtOnce) error_ += memory_;
}

double PrescribedMotion::energy(const CurvePlace& place, double s) const {
  return start_kinetic_ +
         work_of_field(scene_, curve_->start(), place.offset, turned_after(s));
}

double PrescribedMotion::gain_at_rest(const CurvePlace& place, double s) const {
  const Point centre = point_of(*curve_, place);
  const double theta = theta_after(s);
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
  constexpr double kConverged = 1e-10;
  using Jet = math::Jet1<double, 1>;
  using Vector = Eigen::Vector<double, gauss_step::kPoints>;
  const Vector weights =
      Eigen::Map<const Vector>(gauss_step::rule().weights.data());
  Eigen::Map<Vector> energies(points.energy.data());
  const auto found = braked_speeds(
      Vector((2.0 * energies).cwiseSqrt()),
      Vector(Vector::Constant(from.energy)),
      gauss_step::integration_to_points(),
      [&](int i, double w) {
        const CurvePlace& place = points.places[brachisto::at(i)];
        const double theta = theta_after(points.s[brachisto::at(i)]);
        const Point centre = point_of(*curve_, place);
        const Jet gain =
            speed_gain(scene_, Jet(centre.x), Jet(centre.z), Jet(theta),
                       Jet::variable(w, 0), Jet(place.beta),
                       Jet(root_of_inertia(scene_, theta, place.beta)));
        const double length = width * place.speed;
        return std::pair(length * gain.value, length * gain.gradient[0]);
      },
      kConverged);
  if (!found) {
    points.energy.fill(std::numeric_limits<double>::quiet_NaN());
    return points.energy.back();
  }
  energies = 0.5 * found->w.cwiseAbs2();
  return from.energy + weights.dot(found->rate);
}

std::variant<PrescribedMotion::Sums, Stall> PrescribedMotion::advance(
    const Sums& from, double q, Points& points) const {
  const math::SmallMatrix& to_point = gauss_step::integration_to_points();
  const double width = q - from.q;
  auto& [places, s, energies] = points;
  bool fits = true;
  for (std::size_t i = 0; i < places.size(); ++i) {
    places[i] = curve_->at(from.q + width * gauss_step::rule().points[i]);
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
                   from.q + width * gauss_step::rule().points[i],
                   point_of(*curve_, place)};
    }
    const double du = gauss_step::rule().weights[i] * width * place.speed /
                      std::sqrt(2.0 * energies[i]);
    to.u += du;
    const double theta = theta_after(s[i]);
    to.t += root_of_inertia(scene_, theta, place.beta) * du;
    to.s += gauss_step::rule().weights[i] * width * place.speed;
  }
  return to;
}

std::variant<PrescribedMotion::Sums, Stall> PrescribedMotion::advance(
    const Sums& from, double q) const {
  Points points;
  return advance(from, q, points);
}

/// Joints of the curve, passages of a surface, and what divide() adds.
void PrescribedMotion::end_pieces() {
  ends_ = curve_->joints();
  ends_.push_back(1.0);
  if (has_surface(scene_.world)) {
    // Between so many places a path is as good as straight.
    const int parts = std::max(1, 64 / static_cast<int>(ends_.size()));
    constexpr double kNoLength = 1e-6;  // A itself may lie on the surface
    double q = 0.0, s = 0.0;
    const auto length_to = [&](double there) {
      return s + length_between(q, there);
    };
    const auto height = [&](double there) {
      const CurvePlace place = curve_->at(there);
      return height_above_surface(
          scene_, mass_centre(scene_.body, point_of(*curve_, place),
                              theta_after(length_to(there))));
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
  // A push is forgotten where the fall has made as much of w² = w₀² + (w_q q)²:
  // a place that may be far too close to the start for any step to notice.
  if (memory_ > kForgottenAtOnce) {
    const double most = 0.25 * ends_.front();
    for (double q = memory_; q < most; q *= 2.0) ends_.push_back(q);
    std::ranges::sort(ends_);
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

}  // namespace brachisto
