// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Losses that grow with the load: against quadratures, closed forms and the
// laws of mechanics, and by two methods.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "brachisto/study/solve.hpp"
#include "support/limited_scenes.hpp"
#include "support/newton_euler.hpp"
#include "support/verified.hpp"
#include "support/world_scenes.hpp"

namespace brachisto {
namespace {

using namespace testing;
using ::testing::HasSubstr;

Scene with_sliding(Scene scene, double mu) {
  scene.world.losses.sliding = mu;
  return scene;
}
Scene with_rolling(Scene scene, double c) {
  scene.world.losses.rolling = c;
  return scene;
}

double tau_of(const Solution& solution) {
  return solution.verified() ? solution.motion()->tau() : std::nan("");
}

/// τ of a bead with Coulomb friction whose load never pulls, in units g = 1.
/// W = v e^{−μβ} makes β a control, and 𝓗 = 0 with p constant gives
///
///     v = (f − μ e)/D,  e = sin β − μ cos β,  f = cos β + μ sin β,
///     D = e (b + μ a) − a f,  a = p_x cos β + p_z sin β,
///     d = p_z cos β − p_x sin β,  b = μ a + d,
///
/// from β = π/2 to where b = 0. β̇ = e/(dv/dβ − μ v) is 0/0 where e = 0, but e
/// is a factor of dv/dβ − μ v:
///
///     dt/dβ = (μ D′ − (1 − μ²) D − 4 μ f b)/D²,  D′ = 2 μ (a f + e d).
///
/// p is found from x = L and z = H.
double tau_by_quadrature(double mu, double L, double H) {
  using Vector = Eigen::Vector2d;
  struct Sums {
    double t;
    Vector place;
  };
  const math::QuadratureRule rule = math::gauss_legendre(40);
  const auto along = [&](const Vector& p) {
    const double first = 0.5 * kPi;
    const double last = std::atan2(-(mu * p.x() + p.y()), mu * p.y() - p.x());
    Sums sum{0.0, {0.0, 0.0}};
    for (std::size_t i = 0; i < rule.points.size(); ++i) {
      const double beta = first + (last - first) * rule.points[i];
      const double s = std::sin(beta), c = std::cos(beta);
      const double a = p.x() * c + p.y() * s, d = p.y() * c - p.x() * s;
      const double e = s - mu * c, f = c + mu * s, b = mu * a + d;
      const double D = e * (b + mu * a) - a * f;
      const double D_beta = 2.0 * mu * (a * f + e * d);
      const double dt = (mu * D_beta - (1.0 - mu * mu) * D - 4.0 * mu * f * b) /
                        (D * D) * (last - first) * rule.weights[i];
      sum.t += dt;
      sum.place += dt * (f - mu * e) / D * Vector(c, s);
    }
    return sum;
  };
  // Of the cycloid nearly, and by Newton's method with differences from there.
  Vector p(-0.6, -0.1);
  for (int i = 0; i < 60; ++i) {
    const Vector miss = along(p).place - Vector(L, H);
    if (miss.norm() < 1e-15) break;
    constexpr double kStep = 1e-6;
    Eigen::Matrix2d by;
    for (int j = 0; j < 2; ++j) {
      const Vector step = kStep * Vector::Unit(j);
      by.col(j) = (along(p + step).place - along(p - step).place) / 2e-6;
    }
    Vector change = by.partialPivLu().solve(miss);
    p -= change * std::min(1.0, 0.1 / change.norm());
  }
  return along(p).t * std::sqrt(2.0 / H);
}

/// A part of 1e12 of τ, which is five.
constexpr double kTwelveDigits = 5e-12;

TEST(LossesOfABead, AreThoseOfTheQuadratureByBothMethods) {
  for (const double mu : {0.02, 0.1, 0.2}) {
    const double tau = tau_by_quadrature(mu, 3.0, 1.0);
    const Scene scene = with_sliding(bead_scene(), mu);

    EXPECT_NEAR(tau_of(verified(scene)), tau, kTwelveDigits);
    EXPECT_NEAR(tau_of(verified(scene, by_shooting())), tau, kTwelveDigits);
  }
}

TEST(LossesOfABead, AreThoseOfTheReference) {
  EXPECT_NEAR(tau_by_quadrature(0.1, 3.0, 1.0), 5.0341538427536, 1e-12);
  EXPECT_NEAR(tau_by_quadrature(0.0, 3.0, 1.0), 4.510563136747, 1e-12);
}

/// τ(μ) = τ(0) + τ′ μ + O(μ²): halves of μ leave halves of what they change,
/// and of what the halves do not agree in quarters.
TEST(LossesOfABead, VanishInTheFirstOrder) {
  const double none = tau_of(verified(bead_scene()));
  const auto slope = [&](double mu) {
    return (tau_of(verified(with_sliding(bead_scene(), mu))) - none) / mu;
  };

  const double one = slope(4e-3), half = slope(2e-3), quarter = slope(1e-3);

  EXPECT_GT(quarter, 1.0);
  EXPECT_NEAR((one - half) / (half - quarter), 2.0, 0.05);
}

TEST(LossesOfABead, KeepItsLoadAndItsSlope) {
  const Solution solution = verified(with_sliding(bead_scene(), 0.2));

  ASSERT_EQ(solution.limits.size(), 1u);
  EXPECT_EQ(solution.limits.front().name, "normal_force.min");
  EXPECT_TRUE(solution.limits.front().active.empty());
}

Scene between_centres(double c) {
  Scene scene = with_rolling(uniform_scene(), c);
  scene.contact = Contact::Centre;
  return scene;
}

/// From an indirect method of its own, not this one's.
TEST(LossesOfACylinder, AreThoseOfTheReferenceWhereTheLoadMustNotPull) {
  constexpr double kReference = 6.0544174361717;
  const Scene scene =
      under(between_centres(0.1), least_force(0.0), Contact::Centre);

  EXPECT_NEAR(tau_of(verified(scene)), kReference, kTwelveDigits);
  EXPECT_NEAR(tau_of(verified(scene, by_shooting())), kReference,
              kTwelveDigits);
}

/// The static cone of tan β₀ ≤ (μ (1 + k) − c)/k.
TEST(LossesOfACylinder, MakeTheStaticConeNarrower) {
  constexpr double c = 0.1, mu = 0.6, k = 0.5;
  const Scene scene = under(between_centres(c), friction(mu), Contact::Centre);

  const Solution solution = verified(scene);

  EXPECT_NEAR(solution.motion()->start_angle(),
              std::atan((mu * (1.0 + k) - c) / k), 1e-9);
}

struct LossyRow {
  std::string name;
  Scene scene;
};

std::ostream& operator<<(std::ostream& out, const LossyRow& row) {
  return out << row.name;
}

/// Pushed, in a sphere's field and in air, with every contact.
std::vector<LossyRow> lossy_rows() {
  const Scene bead = with_sliding(bead_scene(), 0.1);
  const Scene uniform = with_rolling(uniform_scene(), 0.05);
  const Scene base = with_rolling(off_centred_scene(), 0.03);
  PathLimits ride = bends(2.7, 4.0);
  ride.normal_min = 0.0;
  ride.normal_max = 5.0;
  Scene level = under(base, bends(2.5, 3.0), Contact::EndSlope);
  level.limits.normal_min = 0.0;
  level.end_slope = 0.0;
  return {
      {"bead_with_a_push", with_push(bead, 1.0)},
      {"bead_on_a_floor", under(bead, floor_at(1.1))},
      {"cylinder_with_a_push", under(with_push(uniform, 1.0), friction(0.6))},
      {"friction_on_a_planet",
       under(about_sphere(base, {{1.0, 10.0}, 8.0, 9.81}), friction(1.0))},
      {"ride", under(base, ride, Contact::Optimal)},
      {"friction_in_air", under(in_air(base, 0.1, 0.05), friction(1.0))},
      {"given_slope", level},
  };
}

class LossesInAWorld : public ::testing::TestWithParam<LossyRow> {};

TEST_P(LossesInAWorld, AreTheSameByBothMethodsAndByTheLaws) {
  const Scene& scene = GetParam().scene;

  const Solution program = verified(scene);
  const Solution shot = verified(scene, by_shooting());
  ASSERT_TRUE(program.verified() && shot.verified());

  EXPECT_NEAR(tau_of(program) / tau_of(shot), 1.0,
              *program.estimated_error + *shot.estimated_error);
  EXPECT_LE(*program.estimated_error, 1e-9);
  const LeftOver left = left_over(*program.motion(), rigid_body_of(scene));
  EXPECT_LE(left.largest(), allowed_along(program)) << left;
}

INSTANTIATE_TEST_SUITE_P(Scenes, LossesInAWorld,
                         ::testing::ValuesIn(lossy_rows()),
                         [](const auto& row) { return row.param.name; });

/// Loads bounded from both sides, little friction or a floor, whatever else.
Scene random_scene(std::mt19937& random) {
  const auto in = [&](double from, double to) {
    return std::uniform_real_distribution<>(from, to)(random);
  };
  const bool bead = in(0.0, 1.0) < 0.3;
  const double eta = in(0.0, 1.0) < 0.3 ? 0.0 : in(0.1, 0.6);
  const double L = in(1.5, 4.0);
  Scene scene;
  PathLimits limits;
  if (bead) {
    scene = with_sliding(bead_scene(), in(0.01, 0.5) / L);
    limits.normal_min = 0.0;
  } else {
    scene =
        with_rolling(scene_of(Body::cylinder(in(0.1, 0.4), eta, in(-0.6, 0.6),
                                             in(0.2, 0.9) * (1.0 - eta * eta))),
                     in(0.005, 0.1));
    if (in(0.0, 1.0) < 0.7) {
      limits.friction = in(0.6, 1.5);
    } else {
      limits.normal_min = 0.0;
    }
  }
  scene.L = L;
  if (in(0.0, 1.0) < 0.3) limits.normal_max = in(2.2, 3.0);
  if (in(0.0, 1.0) < 0.3) limits.floor = in(1.2, 1.5);
  if (in(0.0, 1.0) < 0.3) scene = in_air(scene, in(0.0, 0.2), in(0.0, 0.1));
  return under(scene, limits);
}

TEST(LossesOfRandomScenes, AreTheSameByBothMethodsAndByTheLaws) {
  constexpr int kScenes = 12;
  constexpr double kAllowed = 1e-10;
  std::mt19937 random(36);
  for (int i = 0; i < kScenes; ++i) {
    SCOPED_TRACE(i);
    const Scene scene = random_scene(random);

    const Solution program = verified(scene);
    const Solution shot = verified(scene, by_shooting());
    ASSERT_TRUE(program.verified() && shot.verified());

    EXPECT_NEAR(tau_of(program) / tau_of(shot), 1.0, kAllowed);
    const LeftOver left = left_over(*program.motion(), rigid_body_of(scene));
    EXPECT_LE(left.largest(), allowed_along(program)) << left;
  }
}

/// A loss that is left out of the laws, or counted twice.
TEST(LossesOfAnAnswer, AreMissedWhereTheyAreForgotten) {
  constexpr double kSeen = 1e-3;
  for (const Scene& scene :
       {with_sliding(bead_scene(), 0.1),
        under(with_rolling(off_centred_scene(), 0.05), friction(1.0))}) {
    const Solution solution = verified(scene);
    for (const double factor : {0.0, 2.0}) {
      RigidBody body = rigid_body_of(scene);
      body.loss *= factor;

      EXPECT_GE(left_over(*solution.motion(), body).energy, kSeen);
    }
  }
}

Scene on_path(Scene scene, GivenPath::Shape shape) {
  auto path = std::make_shared<GivenPath>();
  path->shape = shape;
  scene.path = std::move(path);
  scene.contact = Contact::Centre;
  return scene;
}

/// On an incline S = ½ v̇ T², v̇ = g (sin α − c cos α)/(1 + k).
TEST(LossesOnAGivenPath, AreThoseOfAnIncline) {
  const auto check = [](const Scene& scene) {
    const double S = std::hypot(scene.L, scene.H);
    const Losses& lost = scene.world.losses;
    const double v_dot = scene.gravity *
                         (scene.H - (lost.sliding + lost.rolling) * scene.L) /
                         S / (1.0 + scene.body.k);

    const Solution solution =
        verified(on_path(scene, GivenPath::Shape::Straight));

    EXPECT_NEAR(solution.motion()->transit_time() / std::sqrt(2.0 * S / v_dot),
                1.0, 1e-12);
    EXPECT_LE(
        left_over(*solution.motion(),
                  rigid_body_of(on_path(scene, GivenPath::Shape::Straight)))
            .largest(),
        1e-11);
  };
  check(with_sliding(bead_scene(), 0.2));
  check(with_rolling(uniform_scene(), 0.2));
}

/// On a quarter of a circle of radius R from a vertical start, where by the
/// slope d(v²)/dβ = −2 g R (sin β − μ cos β) + 2 μ v² is linear in v²:
///
///     v² = 2 g R [(1 − 2 μ²) cos β + 3 μ (sin β − e^{μ (2 β − π)})]/(1 + 4
///     μ²).
TEST(LossesOnAGivenPath, AreThoseOfACircleWithItsCentripetalPart) {
  constexpr double mu = 0.2;
  Scene scene = with_sliding(bead_scene(), mu);
  scene.L = scene.H = 1.0;

  const Solution solution =
      verified(on_path(scene, GivenPath::Shape::CircularArc));

  const auto squared = [&](double beta) {
    return 2.0 * scene.gravity / (1.0 + 4.0 * mu * mu) *
           ((1.0 - 2.0 * mu * mu) * std::cos(beta) +
            3.0 * mu * (std::sin(beta) - std::exp(mu * (2.0 * beta - kPi))));
  };
  for (const double q : {0.3, 0.6, 1.0}) {
    const TrajectoryPoint at = solution.motion()->at(q);
    EXPECT_NEAR(at.motion.v_c, std::sqrt(squared(at.beta)), 1e-11);
    EXPECT_NEAR(at.motion.R_t, -mu * at.motion.R_n, 1e-12);
  }
}

/// An off-centred body on a path with bends: the laws, and its state and the
/// integration in time have nothing in common but the scene.
TEST(LossesOnAGivenPath, KeepTheLawsOfAnOffCentredBody) {
  Scene scene = with_rolling(off_centred_scene(-0.4), 0.05);
  auto path = std::make_shared<GivenPath>();
  path->curve = GivenPath::Curve::Track;
  path->shape = GivenPath::Shape::Parabola;
  path->start_angle = kPi / 3.0;
  scene.path = std::move(path);

  const Solution solution = verified(scene);
  ASSERT_TRUE(solution.verified());

  const LeftOver left = left_over(*solution.motion(), rigid_body_of(scene));
  EXPECT_LE(left.largest(), 1e-9) << left;
}

/// Of whole solves, over steps of 1e-4.
TEST(LossesAndLimits, HavePricesAndSensitivitiesThatAreSlopesOfTheTime) {
  constexpr double kStep = 1e-4, kAllowed = 1e-6;
  PathLimits loads = friction(0.6);
  loads.normal_max = 2.2;
  const Scene scene = under(with_rolling(off_centred_scene(), 0.05), loads);
  const auto tau_with = [&](const std::function<void(Scene&)>& change) {
    Scene changed = scene;
    change(changed);
    return tau_of(verified(changed));
  };

  Collocation program;
  program.sensitivities = SensitivityOrder::First;
  SolveOptions options;
  options.method = program;
  const Solution solution = verified(scene, options);
  ASSERT_TRUE(solution.sensitivities);
  const auto with_eta = [&](double by) {
    return tau_with([&](Scene& s) { s.body.eta_m += by; });
  };
  EXPECT_NEAR(solution.sensitivities->by[SceneParameter::EtaM].tau,
              (with_eta(kStep) - with_eta(-kStep)) / (2.0 * kStep), kAllowed);

  int active = 0;
  for (const LimitOnPath& limit : solution.limits) {
    ASSERT_TRUE(limit.price);
    if (limit.active.empty()) continue;
    ++active;
    const auto at = [&](double by) {
      return tau_with([&](Scene& s) {
        (limit.name == "friction" ? *s.limits.friction
                                  : *s.limits.normal_max) += by;
      });
    };
    EXPECT_NEAR(*limit.price, (at(kStep) - at(-kStep)) / (2.0 * kStep),
                kAllowed)
        << limit.name;
  }
  EXPECT_GE(active, 1);
}

struct Refused {
  Scene scene;
  std::string key, reason;
};

TEST(LossesThatAreRefused, SayWhy) {
  const Scene rolls = with_rolling(uniform_scene(), 0.1);
  Scene brisk = with_rolling(off_centred_scene(), 3.0);
  brisk.path = std::make_shared<GivenPath>();
  Scene pulls = with_sliding(bead_scene(), 0.1);
  pulls.limits.normal_min = -0.5;
  const std::vector<Refused> scenes{
      {with_sliding(bead_scene(), -0.1), "scene.losses.sliding",
       "takes energy away"},
      {with_sliding(uniform_scene(), 0.1), "scene.losses.sliding",
       "of a body that rolls"},
      {with_rolling(bead_scene(), 0.1), "scene.losses.rolling", "of a bead"},
      {rolls, "scene.losses.rolling", "without scene.limits.friction"},
      {brisk, "scene.losses.rolling", "has no bound"},
      {pulls, "scene.limits.normal_force.min", "pulls at the body"},
      {under(rolls, friction(0.09)), "scene.limits.friction", "not start"},
  };
  for (const auto& [scene, key, reason] : scenes) {
    const std::vector<SceneError> errors = validate(scene);

    ASSERT_EQ(errors.size(), 1u) << reason;
    EXPECT_EQ(errors.front().key, key);
    EXPECT_THAT(errors.front().message, HasSubstr(reason));
  }
}

}  // namespace
}  // namespace brachisto
