// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Proofs in other worlds: closed forms and laws of similarity lie inside.

#include <gtest/gtest.h>

#include <string>

#include "proof/arc_theorems.hpp"
#include "proof/certificate.hpp"
#include "proof/enclosed.hpp"
#include "proof/scenes.hpp"

namespace brachisto {
namespace {

using namespace proof;
using brachisto::testing::bead;
using brachisto::testing::cylinder;
using brachisto::testing::enclosed;
using brachisto::testing::kBits;

Real arc_cosine(const Real& of) {
  Real out;
  arb_acos(out.get(), of.get(), working_bits);
  return out;
}

/// A cycloid whose cusp is h₀ = v₀²/2g above A, of circles of radius R: from
/// 1 − cos φ₀ = h₀/R to 1 − cos φ₁ = (h₀ + H)/R, φ₁ > π, with
/// R (φ₁ − sin φ₁ − φ₀ + sin φ₀) = L, τ = (φ₁ − φ₀) √(2 R/H).
Real tau_of_pushed_cycloid(const Scene& scene) {
  const Real g(scene.gravity), v(scene.world.start_speed), one(1.0), two(2.0);
  const Real above = v * v / (two * g);
  const auto angles = [&](const Real& R) {
    return std::array{
        arc_cosine(one - above / R),
        two * Real::pi() - arc_cosine(one - (above + Real(scene.H)) / R)};
  };
  const auto off = [&](const Real& R) {
    const auto [from, to] = angles(R);
    return R * (to - sin(to) - from + sin(from)) - Real(scene.L);
  };
  Real low(0.62), high(3.0);
  for (int i = 0; i < 100; ++i) {
    const Real middle = ((low + high) * Real(0.5)).middle();
    (off(middle).positive() ? high : low) = middle;
  }
  EXPECT_TRUE((-off(low)).positive());
  EXPECT_TRUE(off(high).positive());
  const Real R = hull(low, high);
  const auto [from, to] = angles(R);
  return (to - from) * sqrt(two * R / Real(scene.H));
}

TEST(Worlds, APushedBeadFollowsARaisedCycloid) {
  Scene scene = bead();
  scene.world.start_speed = 2.0;
  const Json made = prove(scene, accuracy_of(kBits));
  const Bits bits(256);
  const Real tau = enclosed(made, "tau");
  EXPECT_TRUE(tau_of_pushed_cycloid(scene).within(tau));
  EXPECT_LT(tau.radius().upper(), 1e-18);
  for (const auto& [name, said] : made["theorems"].items()) {
    EXPECT_TRUE(said["holds"].get<bool>()) << name;
  }
  EXPECT_EQ(check(made)["theorems"], made["theorems"]);
}

Scene on_a_planet(Scene scene) {
  scene.world.sphere = Sphere{{1.0, 10.0}, 8.0, 9.81};
  scene.gravity = scene.world.sphere->strength_at({0.0, 0.0});
  scene.contact = Contact::Centre;
  return scene;
}

// Of a cylinder whose centre of mass is on its axis all times are √(1 + k)
// those of a bead, in any field.
TEST(Worlds, InTheFieldOfAPlanetAUniformCylinderIsASlowerBead) {
  const Json of_bead = prove(on_a_planet(bead()), accuracy_of(kBits));
  const Json of_cylinder =
      prove(on_a_planet(cylinder(0.0, 0.0)), accuracy_of(kBits));
  const Bits bits(256);
  const Real slower = enclosed(of_bead, "tau") * sqrt(Real(1.5));
  EXPECT_TRUE((slower - enclosed(of_cylinder, "tau")).has_zero());
  EXPECT_LT(slower.radius().upper(), 1e-17);
  for (const char* name : {"start_angle", "end_angle", "length_per_H"}) {
    EXPECT_TRUE(
        (enclosed(of_bead, name) - enclosed(of_cylinder, name)).has_zero())
        << name;
  }
  EXPECT_TRUE(of_bead["theorems"]["strong_minimum"]["holds"].get<bool>());
}

// Four times as large, everything takes twice as long: a drag of half as much
// per second and of a quarter per metre brakes as much.
TEST(Worlds, DragIsSimilarInSimilarScenes) {
  Scene scene = bead();
  scene.world.air = {.linear = 0.5, .quadratic = 0.25};
  Scene larger = scene;
  larger.L *= 4.0;
  larger.H *= 4.0;
  larger.world.air = {.linear = 0.25, .quadratic = 0.0625};
  const Json small = prove(scene, accuracy_of(160));
  const Json large = prove(larger, accuracy_of(160));
  const Bits bits(256);
  for (const char* name : {"tau", "end_angle", "length_per_H"}) {
    EXPECT_TRUE((enclosed(small, name) - enclosed(large, name)).has_zero())
        << name;
  }
  EXPECT_LT(enclosed(small, "tau").radius().upper(), 1e-17);
  EXPECT_TRUE(small["theorems"]["strict_minimum"]["holds"].get<bool>());
}

std::string complaint(const Scene& scene) {
  try {
    (void)prove(scene, accuracy_of(kBits));
  } catch (const NotProven& error) {
    return error.what();
  }
  return "";
}

// The field has another law beyond the surface; exponentials have no series
// here.
TEST(MustFail, APathThroughASurfaceOrWithLosses) {
  Scene scene = on_a_planet(bead());
  scene.world.sphere->radius = 9.3;
  EXPECT_NE(complaint(scene).find("surface"), std::string::npos);
  Scene lossy = cylinder(0.0, 0.0);
  lossy.world.losses.rolling = 0.1;
  lossy.limits.normal_min = 0.0;
  EXPECT_NE(complaint(lossy).find("losses"), std::string::npos);
}

// Faster by 1e-9 m/s it leaves the box, which is 1e-15 wide.
TEST(MustFail, AnotherPush) {
  Scene scene = bead();
  scene.world.start_speed = 2.0;
  const NearChain near = approximate_chain(scene);
  const Root root =
      find_root(ArcSystem(near.chain), near.unknowns, accuracy_of(kBits));
  EXPECT_NO_THROW((void)verify_root(ArcSystem(near.chain), root.searched,
                                    accuracy_of(kBits)));
  ArcChain faster = near.chain;
  faster.scene.world.start_speed += 1e-9;
  EXPECT_THROW(
      (void)verify_root(ArcSystem(faster), root.searched, accuracy_of(kBits)),
      NotProven);
}

}  // namespace
}  // namespace brachisto
