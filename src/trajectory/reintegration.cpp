// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "trajectory/reintegration.hpp"

#include <algorithm>
#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <limits>

#include "brachisto/math/stop_condition.hpp"
#include "math/index.hpp"
#include "model/energy.hpp"
#include "model/field.hpp"
#include "model/inertia.hpp"

namespace brachisto {

namespace {

/// Slope angle and curvature of the centre's path as functions of its arc
/// length s, element by element: slopes have kinks where elements meet.
///
/// In an element s is the integral of U w, of degree p + 1, and κ_c is the
/// exact derivative of β along it, so that both belong to one and the same path
/// on coarse meshes too.
class PathByLength {
 public:
  struct Place {
    double beta = 0.0;   ///< NaN where the curve has none
    double kappa = 0.0;  ///< κ_c
  };

  /// \param curve  must outlive this
  explicit PathByLength(const ExtremalCurve& curve);

  [[nodiscard]] int num_elements() const {
    return static_cast<int>(ends_.size()) - 1;
  }
  /// s where element e begins, or where element e − 1 ends.
  [[nodiscard]] double end(int e) const {
    return ends_[static_cast<std::size_t>(e)];
  }
  /// The scene as element e sees it.
  [[nodiscard]] const Scene& scene_in(int e) const {
    return curve_.scene_in(e);
  }
  /// In element e; beyond its ends the path goes on with its polynomials.
  /// \pre s > 0
  [[nodiscard]] Place at(int e, double s) const;

 private:
  [[nodiscard]] double combine(int e, const std::vector<double>& values,
                               const std::vector<double>& nodal) const;
  /// w at t and ∫₀ᵗ w, of element e.
  struct Speed {
    double w, integral;
  };
  [[nodiscard]] Speed speed(int e, double t) const;
  /// dβ/dt, of the place t in element e, along the polynomials.
  [[nodiscard]] double rate_in_world(int e, double t,
                                     const ExtremalPoint& point) const;

  const ExtremalCurve& curve_;
  const bool in_world_;
  const CollocationScheme& scheme_;
  math::QuadratureRule rule_;  ///< exact for w
  std::vector<double> ends_;
  std::vector<double> theta_, w_, p_w_;  ///< at nodes
  /// In other worlds, all states and costates at nodes.
  std::array<std::vector<double>, 8> all_;
};

PathByLength::PathByLength(const ExtremalCurve& curve)
    : curve_(curve),
      in_world_(curve.scene().world.changes_rates()),
      scheme_(collocation_scheme(curve.mesh().degree)),
      rule_(math::gauss_legendre((curve.mesh().degree + 2) / 2)) {
  const Mesh& mesh = curve.mesh();
  for (int node = 0; node < mesh.num_nodes(); ++node) {
    const ExtremalPoint at = curve.at_node(node);
    theta_.push_back(at.theta);
    w_.push_back(at.w);
    p_w_.push_back(at.p.p_w);
    if (!in_world_) continue;
    const std::array values{at.centre.x, at.centre.z, at.theta,     at.w,
                            at.p.p_x,    at.p.p_z,    at.p.p_theta, at.p.p_w};
    for (std::size_t i = 0; i < values.size(); ++i) {
      all_[i].push_back(values[i]);
    }
  }
  ends_.push_back(0.0);
  for (int e = 0; e < mesh.num_elements(); ++e) {
    check_stop(e);
    ends_.push_back(ends_.back() + curve.rolling_time() * mesh.length(e) *
                                       speed(e, 1.0).integral);
  }
}

double PathByLength::combine(int e, const std::vector<double>& values,
                             const std::vector<double>& nodal) const {
  const auto first = static_cast<std::size_t>(e * scheme_.degree);
  double sum = 0.0;
  for (std::size_t n = 0; n < values.size(); ++n) {
    sum += values[n] * nodal[first + n];
  }
  return sum;
}

PathByLength::Speed PathByLength::speed(int e, double t) const {
  std::vector<double> basis(static_cast<std::size_t>(scheme_.nodes.size()));
  const auto w = [&](double place) {
    scheme_.nodes.evaluate(place, basis);
    return combine(e, basis, w_);
  };
  double integral = 0.0;
  for (std::size_t i = 0; i < rule_.points.size(); ++i) {
    integral += t * rule_.weights[i] * w(t * rule_.points[i]);
  }
  return {w(t), integral};
}

PathByLength::Place PathByLength::at(int e, double s) const {
  const double hU = curve_.rolling_time() * curve_.mesh().length(e);
  // Solve hU ∫₀ᵗ w = s − s_e. At the start s ~ t², hence the root.
  double t = (s - end(e)) / (end(e + 1) - end(e));
  if (e == 0) t = std::sqrt(std::max(t, 0.0));
  Speed now = speed(e, t);
  constexpr int kMostSteps = 20;
  for (int i = 0; i < kMostSteps && now.w > 0.0; ++i) {
    const double step = (s - end(e) - hU * now.integral) / (hU * now.w);
    t += step;
    now = speed(e, t);
    if (std::abs(step) < 1e-15) break;
  }

  // ∂𝓗/∂β = 0 differentiated along the polynomials.
  const ExtremalPoint point = curve_.at(e, t);
  const Scene& scene = curve_.scene();
  if (in_world_) {
    return {point.beta, rate_in_world(e, t, point) / (hU * point.w)};
  }
  const SlopeHamiltonian h = slope_hamiltonian(
      scene.body, scene.gravity, {point.theta, point.w}, point.p, point.beta);
  const double sine = std::sin(point.beta);
  const double cosine = std::cos(point.beta);
  const double pull_z = point.w * point.p.p_z + point.p.p_w * scene.gravity;
  const double d2_root =
      h.d2_beta + point.w * point.p.p_x * cosine + pull_z * sine;
  std::vector<double> slopes(static_cast<std::size_t>(scheme_.nodes.size()));
  scheme_.nodes.differentiate(t, slopes);
  const double rate =
      (d2_root * combine(e, slopes, theta_) -
       (point.p.p_z * cosine - point.p.p_x * sine) * combine(e, slopes, w_) -
       scene.gravity * cosine * combine(e, slopes, p_w_)) /
      h.d2_beta;
  return {point.beta, rate / (hU * point.w)};
}

double PathByLength::rate_in_world(int e, double t,
                                   const ExtremalPoint& point) const {
  std::vector<double> slopes(static_cast<std::size_t>(scheme_.nodes.size()));
  scheme_.nodes.differentiate(t, slopes);
  std::array<double, 8> rates{};
  for (std::size_t i = 0; i < rates.size(); ++i) {
    rates[i] = combine(e, slopes, all_[i]);
  }
  return in_world::slope_rate_along(curve_.scene_in(e), point.state(), point.p,
                                    point.beta, rates);
}

namespace odeint = boost::numeric::odeint;

// Of the integrator, absolute and relative; ten times rounding.
constexpr double kTolerance = 1e-14;

/// dθ/ds.
double turning(const Body& body) {
  return body.rolls() ? 1.0 / body.radius : 0.0;
}

/// s̈ at the arc length s, by A s̈ = g (sin β + η cos θ) − ½ A_s ṡ².
/// \param v_kappa  ṡ κ_c
double acceleration(const Scene& scene, double s, double v, double beta,
                    double v_kappa) {
  const Body& body = scene.body;
  const double theta = body.theta_m + s * turning(body);
  const double A = inertia_factor(body, theta, beta);
  const double A_s_v2 = -2.0 * body.eta_m * std::cos(theta - beta) * v *
                        (v * turning(body) - v_kappa);
  return (scene.gravity * energy_slope(body, theta, beta) - 0.5 * A_s_v2) / A;
}

/// The same in any world, at a place of the centre: the force along the path of
/// field and drag, per mass, in place of g (sin β + η cos θ).
double acceleration_in_world(const Scene& scene, double s, double v, Point at,
                             double beta, double v_kappa) {
  const Body& body = scene.body;
  const double theta = body.theta_m + s * turning(body);
  const double A = inertia_factor(body, theta, beta);
  const double A_s_v2 = -2.0 * body.eta_m * std::cos(theta - beta) * v *
                        (v * turning(body) - v_kappa);
  const Point heavy = mass_centre(body, at, theta);
  const Pull<double> G = field_at(scene, heavy.x, heavy.z);
  const double force = G.x * (std::cos(beta) - body.eta_m * std::sin(theta)) +
                       G.z * (std::sin(beta) + body.eta_m * std::cos(theta)) -
                       drag(scene.world.air, v);
  return (force - 0.5 * A_s_v2) / A;
}

// s, ṡ, x, z
using State = std::array<double, 4>;

/// The equation of motion on a found path, in time.
struct EquationOfMotion {
  const Scene& scene;
  const PathByLength& path;
  double start_angle;
  bool in_world = scene.world.changes_rates();
  bool pushed = scene.world.start_speed > 0.0;

  /// Rates while the body is in element e.
  void rates(int e, const State& y, State& dy) const {
    const double s = y[0];
    const double v = y[1];
    double beta = start_angle;
    // A_s ṡ² tends to 0 at the start although κ_c grows without bound there,
    // for κ_c ~ 1/ṡ.
    double v_kappa = v * turning(scene.body);
    if (s > 0.0 || pushed) {
      const PathByLength::Place place = path.at(e, s);
      beta = place.beta;
      v_kappa = v * place.kappa;
    }
    const double s_ddot =
        in_world ? acceleration_in_world(path.scene_in(e), s, v, {y[2], y[3]},
                                         beta, v_kappa)
                 : acceleration(scene, s, v, beta, v_kappa);
    dy = {v, s_ddot, v * std::cos(beta), v * std::sin(beta)};
  }
};

using Stepper = odeint::runge_kutta_fehlberg78<State>;
// Copied before it has computed anything; being static it holds zeros then.
const Stepper kFreshStepper;

bool finite(const State& y) {
  return std::all_of(y.begin(), y.end(),
                     [](double value) { return std::isfinite(value); });
}

/// One motion from the start, at rest or with its speed.
class Journey {
 public:
  Journey(const EquationOfMotion& motion, const PathByLength& path, Point start,
          double duration)
      : motion_(motion),
        path_(path),
        duration_(duration),
        q_{0.0, motion.scene.world.start_speed, start.x, start.z} {}

  MotionEnd run() {
    MotionEnd end = leave();
    for (int e = 0; e < path_.num_elements() && end == MotionEnd::Arrived;
         ++e) {
      end = cross(e);
    }
    return end;
  }
  [[nodiscard]] double length() const { return s_; }
  [[nodiscard]] int steps() const { return steps_; }
  /// t, ṡ, x, z where the motion ended.
  [[nodiscard]] const State& state() const { return q_; }

 private:
  static constexpr int kMaxSteps = 1000000;
  static constexpr double kShortest = 1e-15;  // of T or S

  /// In time, for at rest nothing is a function of s, through a part of the
  /// first element.
  MotionEnd leave();
  /// In s, from where the body is to the end of element e.
  MotionEnd cross(int e);
  /// Where ṡ² falls to zero, steps in s shrink towards that place for ever.
  [[nodiscard]] bool about_to_rest(int e) const {
    constexpr double kAlmostThere = 1e-9;  // of S
    State rate{};
    motion_.rates(e, {s_, q_[1], q_[2], q_[3]}, rate);
    return rate[1] < 0.0 && q_[1] * q_[1] / (-2.0 * rate[1]) <
                                kAlmostThere * path_.end(path_.num_elements());
  }

  const EquationOfMotion& motion_;
  const PathByLength& path_;
  double duration_;
  State q_;
  double s_ = 0.0;
  double ds_ = 0.0;
  int steps_ = 0;
};

MotionEnd Journey::leave() {
  constexpr double kPart = 0.1;
  constexpr double kFirstStep = 1e-3;
  const double goal = kPart * path_.end(1);
  auto stepper = odeint::make_controlled(kTolerance, kTolerance, kFreshStepper);
  const auto in_time = [&](const State& y, State& dy, double) {
    motion_.rates(0, y, dy);
  };
  double t = 0.0;
  double dt = kFirstStep * duration_;
  State y{0.0, q_[1], q_[2], q_[3]};
  while (y[0] < goal) {
    check_stop();
    if (++steps_ > kMaxSteps) return MotionEnd::TooManySteps;
    const State before = y;
    const double t_before = t;
    const double tried = dt;
    const bool failed = stepper.try_step(in_time, y, t, dt) == odeint::fail;
    if (!finite(y)) return MotionEnd::PathUndefined;
    if (failed && dt < kShortest * duration_) return MotionEnd::StepTooSmall;
    if (!failed && y[0] > path_.end(1)) {
      // Right over the kink at the element's end: once more, shorter.
      y = before;
      t = t_before;
      dt = 0.25 * tried;
      continue;
    }
    // Where it does not roll forward now it never will.
    if (!failed && !(y[1] > 0.0)) return MotionEnd::ComesToRest;
  }
  q_ = {t, y[1], y[2], y[3]};
  s_ = y[0];
  ds_ = s_;
  return MotionEnd::Arrived;
}

MotionEnd Journey::cross(int e) {
  const double end = path_.end(e + 1);
  auto stepper = odeint::make_controlled(kTolerance, kTolerance, kFreshStepper);
  const auto by_length = [&](const State& q, State& dq, double s) {
    State rate{};
    motion_.rates(e, {s, q[1], q[2], q[3]}, rate);
    dq = {1.0 / q[1], rate[1] / q[1], rate[2] / q[1], rate[3] / q[1]};
  };
  while (s_ < end) {
    check_stop();
    if (++steps_ > kMaxSteps) return MotionEnd::TooManySteps;
    const bool last = ds_ >= end - s_;
    double ds = last ? end - s_ : ds_;
    const bool failed = stepper.try_step(by_length, q_, s_, ds) == odeint::fail;
    if (!finite(q_)) return MotionEnd::PathUndefined;
    if (!(q_[1] > 0.0)) return MotionEnd::ComesToRest;
    if (failed && ds < kShortest * path_.end(path_.num_elements())) {
      return about_to_rest(e) ? MotionEnd::ComesToRest
                              : MotionEnd::StepTooSmall;
    }
    if (failed || !last) {
      ds_ = ds;
    } else {
      s_ = end;  // but for rounding it is
      ds_ = std::max(ds_, ds);
    }
  }
  return MotionEnd::Arrived;
}

}  // namespace

std::string_view describe(MotionEnd end) {
  constexpr std::array<std::string_view, 5> kSentences{
      "the body reaches the end of the path",
      "the body comes to rest on its way",
      "between the nodes no slope makes 𝓗 minimal, so that there is no path",
      "the path bends too sharply to be integrated along",
      "the motion takes more steps of integration than allowed"};
  static_assert(kSentences.size() ==
                static_cast<std::size_t>(MotionEnd::TooManySteps) + 1);
  return kSentences.at(static_cast<std::size_t>(end));
}

Reintegration reintegrate(const ExtremalCurve& curve) {
  const Scene& scene = curve.scene();
  const PathByLength path(curve);
  const EquationOfMotion motion{scene, path, curve.at(0.0).beta};
  const ExtremalPoint end = curve.at(1.0);
  const double T = curve.transit_time();
  const double S = curve.arc_length();

  Journey journey(motion, path, curve.at(0.0).centre, T);
  Reintegration out;
  out.end = journey.run();
  out.steps = journey.steps();
  out.integration_error = kTolerance * out.steps;
  out.share = journey.length() / S;
  if (!out.arrived()) return out;
  const auto [time, speed, x, z] = journey.state();
  const double v =
      end.w / std::sqrt(inertia_factor(scene.body, end.theta, end.beta));
  const Point beyond{x - end.centre.x, z - end.centre.z};
  out.time_error = std::abs(time - T) / T;
  // p = −∂T/∂(x, z): what arriving elsewhere costs or saves.
  out.corrected_time_error =
      std::abs(time + curve.p_x() * beyond.x + curve.p_z() * beyond.z - T) / T;
  out.speed_error = std::abs(speed - v) / v;
  out.position_error = std::hypot(beyond.x, beyond.z);
  if (scene.body.rolls()) {
    out.rotation_error =
        std::abs(scene.body.theta_m + S / scene.body.radius - end.theta);
  }
  return out;
}

double reintegration_error(const PrescribedMotion& motion, double from) {
  using Pair = std::array<double, 2>;  // s, ṡ
  // As kFreshStepper.
  static const odeint::runge_kutta_fehlberg78<Pair> kFreshPairStepper;
  constexpr double kLoose = 1e-13;
  constexpr double kFirstStep = 1e-3;
  constexpr double kShortest = 1e-15;
  constexpr double kFailed = std::numeric_limits<double>::quiet_NaN();
  const double T = motion.transit_time();
  const auto body = [&](const Pair& y, Pair& dy, double) {
    const double s = std::clamp(y[0], 0.0, motion.centre_path_length());
    const CurvePlace place = motion.curve().at(motion.place_at_length(s));
    // At the start v κ_c stays bounded, and so A_s v² vanishes with v.
    const double v_kappa =
        place.speed > 0.0 ? y[1] * place.turning / place.speed : 0.0;
    dy = {y[1], acceleration(motion.scene(), s, y[1], place.beta, v_kappa)};
  };
  auto stepper = odeint::make_controlled(kLoose, kLoose, kFreshPairStepper);
  Pair y{0.0, 0.0};
  double t = 0.0;
  if (from > 0.0) {
    const TrajectoryPoint start = motion.at(from);
    y = {start.s, start.motion.v_c};
    t = start.t;
  }
  double dt = kFirstStep * T;
  // Cell by cell: where the curvature has kinks the steps end, for the error
  // estimate of this method does not see them.
  for (const TrajectoryPoint& cell : motion.at_nodes()) {
    while (t < cell.t) {
      check_stop();
      dt = std::min(dt, cell.t - t);
      if (stepper.try_step(body, y, t, dt) == odeint::fail &&
          dt < kShortest * T) {
        return kFailed;
      }
    }
  }
  const double v = motion.at(1.0).motion.v_c;
  const double late = std::abs(y[0] - motion.centre_path_length()) / (v * T);
  return std::max(late, std::abs(y[1] - v) / v);
}

LimitedReintegration reintegrate(const LimitedCurve& curve) {
  // t, ṡ, s, x, z along the place in an element.
  using Along = std::array<double, 5>;
  const LimitedTime& problem = curve.problem();
  const Scene& scene = problem.scene();
  const RadauScheme& scheme = problem.scheme();
  const double begin = scheme.rule.points.front();
  const TurningPoint<double> rest = curve.at(0, 0.0).state;
  // Up to there along the same slopes as behind, for so little has been fallen
  // that a place's own error would be a great part of it.
  const math::QuadratureRule rule = math::gauss_legendre(scheme.degree + 1);
  double h = problem.mesh().length(0) * curve.rolling_time();
  double fallen = 0.0;
  Along y{0.0, 0.0, 0.0, rest.x, rest.z};
  for (std::size_t i = 0; i < rule.points.size(); ++i) {
    const auto at = curve.at(0, begin * rule.points[i]).state;
    const double du = h * begin * rule.weights[i];
    y[0] += du * std::sqrt(inertia_factor(scene.body, at.theta, at.beta));
    y[2] += du * at.w;
    y[3] += du * at.w * std::cos(at.beta);
    fallen += du * at.w * std::sin(at.beta);
  }
  y[4] += fallen;
  const TurningPoint<double> first = curve.at(0, begin).state;
  y[1] = fall_speed(scene.gravity,
                    energy_height(scene.body, fallen, first.theta)) /
         std::sqrt(inertia_factor(scene.body, first.theta, first.beta));
  LimitedReintegration out;
  for (int e = 0; e < problem.mesh().num_elements(); ++e) {
    check_stop(e);
    h = problem.mesh().length(e) * curve.rolling_time();
    const auto look_at_limits = [&](double t) {
      TurningPoint<double> place = curve.at(e, t).state;
      place.w =
          y[1] * std::sqrt(inertia_factor(scene.body, place.theta, place.beta));
      place.x = y[3];
      place.z = y[4];
      const Excess excess =
          worst_excess(problem.limits(), scene.body, scene.gravity, place);
      if (std::isnan(out.excess) || excess.value <= out.excess) return;
      out.excess = excess.value;
      out.excess_at = problem.mesh().sigma(e, t);
    };
    const auto rates = [&](const Along& at, Along& rate, double t) {
      const TurningPoint<double> path = curve.at(e, t).state;
      const double v = at[1];
      const double ds = h * path.w;
      const double s_ddot =
          acceleration(scene, at[2], v, path.beta, v * path.q / path.w);
      rate = {ds / v, s_ddot * ds / v, ds, ds * std::cos(path.beta),
              ds * std::sin(path.beta)};
    };
    double t = e == 0 ? begin : 0.0;
    double dt = 0.25;
    auto stepper = odeint::make_controlled(
        kTolerance, kTolerance, odeint::runge_kutta_fehlberg78<Along>());
    constexpr int kMostSteps = 10000;
    for (int step = 0; t < 1.0; ++step) {
      dt = std::min(dt, 1.0 - t);
      const bool last = dt >= 1.0 - t;
      const bool failed = stepper.try_step(rates, y, t, dt) == odeint::fail;
      if (!(y[1] > 0.0) || step > kMostSteps) {
        out.error = std::numeric_limits<double>::quiet_NaN();
        return out;
      }
      if (!failed) look_at_limits(std::min(t, 1.0));
      if (!failed && last) break;
    }
  }
  const TurningPoint<double> last = curve.at(1.0).state;
  const double speed =
      last.w / std::sqrt(inertia_factor(scene.body, last.theta, last.beta));
  const double late = std::abs(y[0] / curve.transit_time() - 1.0);
  const double faster = std::abs(y[1] / speed - 1.0);
  const double off = std::hypot(y[3] - last.x, y[4] - last.z);
  const double sum = late + faster + off;
  out.error = std::isnan(sum) ? sum : std::max({late, faster, off});
  return out;
}

}  // namespace brachisto
