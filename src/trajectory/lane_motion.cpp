// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "trajectory/lane_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "brachisto/math/polynomial_basis.hpp"
#include "extremal/arc_flow.hpp"
#include "model/contact.hpp"
#include "model/energy.hpp"
#include "model/field.hpp"
#include "model/start_angle.hpp"
#include "model/world_hamiltonian.hpp"
#include "trajectory/checks.hpp"

namespace brachisto {

namespace {

/// One element to a step; two places of each let no extreme hide.
Mesh steps_as_mesh(int steps) {
  Mesh mesh;
  for (int i = 0; i <= steps; ++i) {
    mesh.boundaries.push_back(static_cast<double>(i) / steps);
  }
  return mesh;
}

Scene with_law_of(std::optional<FieldSide> side, Scene scene) {
  scene.world.side = side;
  return scene;
}

/// Hermite's polynomials of degree 7 on the places 0, 1, 2, 3: what values and
/// rates count at a place between, and what they count in the rate there.
struct Weights {
  static constexpr int kPlaces = 4;
  std::array<double, kPlaces> value, rate;   ///< in the value
  std::array<double, kPlaces> slope, twist;  ///< in the rate

  explicit Weights(double at) {
    for (int i = 0; i < kPlaces; ++i) {
      // ℓ_i and its derivatives at the place, and ℓ_i' at its own.
      double l = 1.0, own = 0.0, first = 0.0;
      for (int j = 0; j < kPlaces; ++j) {
        if (j == i) continue;
        const double span = i - j;
        first = first * (at - j) / span + l / span;
        l *= (at - j) / span;
        own += 1.0 / span;
      }
      const double off = at - i;
      const auto k = static_cast<std::size_t>(i);
      value[k] = (1.0 - 2.0 * off * own) * l * l;
      rate[k] = off * l * l;
      slope[k] = -2.0 * own * l * l + (1.0 - 2.0 * off * own) * 2.0 * l * first;
      twist[k] = l * l + off * 2.0 * l * first;
    }
  }
};

}  // namespace

LaneMotion::LaneMotion(const Scene& natural, const lanes::Extremal& extremal,
                       const Scene& scene, const Units& units)
    : MeshMotion(with_law_of(extremal.side, natural),
                 steps_as_mesh(extremal.places), std::array{1.0},
                 extremal.rolling_time(), scene, units,
                 extremal.transit_time * units.time),
      extremal_(std::make_shared<const lanes::Extremal>(extremal)),
      turn_(arcs::rotation_per_length(natural)),
      step_(extremal.rolling_time() / extremal.places),
      changes_(static_cast<std::size_t>(extremal.places) + 1) {
  for (std::size_t i = 0; i < changes_.size(); ++i) {
    const lanes::Place& at = extremal.path[i];
    changes_[i] = {
        at.w * std::cos(at.beta) * step_, at.w * std::sin(at.beta) * step_,
        at.w * turn_ * step_,
        speed_gain(natural, at.x, at.z, at.theta, at.w, at.beta, at.root) *
            step_};
  }
}

double LaneMotion::start_angle() const {
  return extremal_->start().beta;
}

MeshMotion::Place LaneMotion::place(int element, double t) const {
  const int first = std::clamp(element - 1, 0, extremal_->places - 3);
  const Weights weights(element - first + t);
  Place out;
  PathState& state = out.state;
  for (std::size_t k = 0; k < Weights::kPlaces; ++k) {
    const std::size_t i = static_cast<std::size_t>(first) + k;
    const lanes::Place& at = extremal_->path[i];
    const Change& change = changes_[i];
    const double value = weights.value[k], rate = weights.rate[k];
    state.centre.x += value * at.x + rate * change.x;
    state.centre.z += value * at.z + rate * change.z;
    state.theta += value * at.theta + rate * change.theta;
    state.w += value * at.w + rate * change.w;
    state.beta += value * at.beta + rate * step_ * at.beta_rate;
    state.beta_rate +=
        weights.slope[k] * at.beta / step_ + weights.twist[k] * at.beta_rate;
    out.t += value * at.t + rate * step_ * at.root;
  }
  out.s = (state.theta - natural().body.theta_m) / turn_;
  return out;
}

namespace {

/// Where the slope at the start puts the centre: pushed, it is the path's own.
double slope_at_start(const Scene& scene, const lanes::Extremal& extremal) {
  return scene.world.start_speed > 0.0 ? extremal.start().beta
                                       : brachisto::start_angle(scene);
}
Point start_of(const Scene& scene, const lanes::Extremal& extremal) {
  return centre_above({0.0, 0.0}, contact_radius(scene),
                      slope_at_start(scene, extremal));
}
/// Energies ½ w², per mass, of the place of the centre and what is lost until
/// there.
class Energies {
 public:
  Energies(const Scene& scene, const lanes::Extremal& extremal)
      : scene_(scene), start_(start_of(scene, extremal)) {
    const double w = pushed_w(scene, slope_at_start(scene, extremal));
    pushed_ = 0.5 * w * w;
  }
  [[nodiscard]] double at(Point centre, double theta, double lost) const {
    const Point offset{centre.x - start_.x, centre.z - start_.z};
    return work_of_field(scene_, start_, offset, theta - scene_.body.theta_m) +
           pushed_ - lost;
  }
  [[nodiscard]] const Point& start() const { return start_; }

 private:
  const Scene& scene_;
  Point start_;
  double pushed_;
};

/// What is seen at the places of an extremal.
///
/// \param lost  energy until there, per mass
void look_along(const Scene& scene, const lanes::Extremal& extremal,
                const Energies& energies, const std::vector<double>& lost,
                Certificate& certificate) {
  Largest hamiltonian, drift, turning, slope, gain = kBelowAll;
  const std::optional<Point> O = turning_centre(scene.world);
  const auto kept = [&](const lanes::Place& at) {
    return turning_costate(*O, {at.x, at.z},
                           {at.p_x, at.p_z, at.p_theta, at.p_w});
  };
  int at_rest = 0;
  for (int i = 0; i <= extremal.places; ++i) {
    const lanes::Place& at = extremal.path[static_cast<std::size_t>(i)];
    const double sigma = static_cast<double>(i) / extremal.places;
    const Costates p{at.p_x, at.p_z, at.p_theta, at.p_w};
    const MovingState state{{at.x, at.z}, at.theta, at.w};
    hamiltonian.see(
        std::abs(brachisto::hamiltonian(scene, state, p, at.beta)) / at.root,
        sigma);
    gain.see(gain_of_other_directions(scene, state, p, at.beta), sigma);
    const double energy =
        energies.at({at.x, at.z}, at.theta, lost[static_cast<std::size_t>(i)]);
    if (O) {
      turning.see(std::abs(kept(at) - kept(extremal.end())) /
                      turning_scale(*O, extremal.transit_time),
                  sigma);
    }
    drift.see(std::abs(0.5 * at.w * at.w - energy) / scene.gravity, sigma);
    slope.see(std::abs(at.beta), sigma);
    if (i > 0 && !(at.w > 0.0)) ++at_rest;
  }
  certificate.add("hamiltonian", hamiltonian.value, kThresholds.kkt_residual,
                  hamiltonian.where());
  certificate.add("weierstrass", gain.value, kThresholds.weierstrass,
                  gain.where());
  certificate.add("energy_drift", drift.value, kThresholds.defects,
                  drift.where());
  if (O) {
    certificate.add("turning_costate", turning.value, kThresholds.defects,
                    turning.where());
  }
  certificate.add("slope_angle", slope.value, std::numbers::pi, slope.where());
  certificate.add("speed", static_cast<double>(at_rest) / extremal.places, 0.0);
}

}  // namespace

double LaneMotion::lost_within(int step, double t) const {
  if (!natural().world.air.any()) return 0.0;
  static const math::QuadratureRule rule = math::gauss_legendre(4);
  double lost = 0.0;
  for (std::size_t i = 0; i < rule.points.size(); ++i) {
    const PathState at = place(step, t * rule.points[i]).state;
    const double v = at.w / root_of_inertia(natural().body, at.theta, at.beta);
    lost += rule.weights[i] * t * step_ * at.w * drag(natural().world.air, v);
  }
  return lost;
}

Certificate certify(const LaneMotion& motion) {
  const lanes::Extremal& extremal = *motion.extremal_;
  const Scene& scene = motion.natural();
  const Body& body = scene.body;
  Certificate certificate;
  certificate.add("shooting", extremal.mismatch, kThresholds.kkt_residual);
  certificate.add("legendre", -extremal.min_legendre, 0.0);
  const bool minimum =
      extremal.least_jacobian > 0.0 && extremal.by_length > 0.0;
  certificate.add("second_order", minimum ? 0.0 : 1.0, 0.0);
  std::vector<double> lost{0.0};
  for (int e = 0; e < extremal.places; ++e) {
    lost.push_back(lost.back() + motion.lost_within(e, 1.0));
  }
  const Energies energies(scene, extremal);
  look_along(scene, extremal, energies, lost, certificate);

  const Point start = energies.start();
  const lanes::Place& last = extremal.end();
  check_contact(scene, start, slope_at_start(scene, extremal), {last.x, last.z},
                extremal.phi, 0.0, certificate);

  // Of the path nothing is taken but its slopes, and what it loses: θ is as far
  // as it came.
  static const math::QuadratureRule rule = math::gauss_legendre(4);
  double x = start.x, z = start.z, turned = 0.0, t = 0.0;
  Largest beyond = kBelowAll;
  for (int e = 0; e < extremal.places; ++e) {
    for (std::size_t i = 0; i < rule.points.size(); ++i) {
      const PathState at = motion.place(e, rule.points[i]).state;
      const double energy =
          energies.at(at.centre, at.theta,
                      lost[static_cast<std::size_t>(e)] +
                          motion.lost_within(e, rule.points[i]));
      const double w = std::sqrt(2.0 * energy);
      beyond.see(
          lanes::beyond_surface(scene, at.centre.x, at.centre.z, at.theta),
          (e + rule.points[i]) / extremal.places);
      const double du = rule.weights[i] * motion.step_;
      x += du * w * std::cos(at.beta);
      z += du * w * std::sin(at.beta);
      turned += du * w * motion.turn_;
      t += du * root_of_inertia(body, at.theta, at.beta);
    }
  }
  if (scene.world.side) {
    certificate.add("surface", beyond.value, lanes::kBeyondSurface,
                    beyond.where());
  }
  const double worst = std::max({std::abs(t / extremal.transit_time - 1.0),
                                 std::hypot(x - last.x, z - last.z),
                                 std::abs(body.theta_m + turned - last.theta)});
  // Between its places the path is interpolated; by what it is off there T is
  // not, which the places alone know.
  certificate.add("reintegration_error",
                  std::isnan(t + x + z + turned) ? kUnmeasured : worst,
                  std::max(kThresholds.tangency,
                           kThresholds.time_factor * extremal.error_estimate));
  return certificate;
}

}  // namespace brachisto
