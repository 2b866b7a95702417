// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What must not be provable is not, and what holds in closed form lies inside.

#include <gtest/gtest.h>

#include <array>
#include <string>

#include "proof/certificate.hpp"
#include "proof/scenes.hpp"

namespace brachisto {
namespace {

using namespace proof;
using brachisto::testing::bead;
using brachisto::testing::cylinder;
using brachisto::testing::kBits;

/// η = 1/3, θ_m = −30°: its start angle is no number of 64 bits.
const Scene& tilted() {
  static const Scene scene = cylinder(1.0 / 3.0, -0.5);
  return scene;
}

const Root& root_of_tilted() {
  static const Root root = [] {
    const Bits bits(kBits);
    return find_root(PlainSystem(tilted()), approximation(tilted()),
                     accuracy_of(kBits));
  }();
  return root;
}

/// What an extremal misses at the end that leaves with another slope.
Vector missed(double shift) {
  const Bits bits(kBits);
  const PlainSystem ends(tilted());
  Flow flow(tilted(), 0, accuracy_of(kBits));
  State state = ends.start(root_of_tilted().found, 0);
  state[kBeta] += Real(shift);
  flow.go(state, root_of_tilted().found.back());
  return ends.missed(state);
}

// 𝓗 is not 0 then, and p_w misses its end.
TEST(MustFail, AShiftedStartAngle) {
  for (const Real& each : missed(0.0)) EXPECT_TRUE(each.has_zero());
  bool misses = false;
  for (const Real& each : missed(1e-11)) misses = misses || !each.has_zero();
  EXPECT_TRUE(misses);
}

// The centre's path from A to B is not that of the contact from A to B.
TEST(MustFail, AnotherEndCondition) {
  const Bits bits(kBits);
  Scene other = tilted();
  other.contact = Contact::Centre;
  EXPECT_NO_THROW((void)verify_root(
      PlainSystem(tilted()), root_of_tilted().searched, accuracy_of(kBits)));
  EXPECT_THROW((void)verify_root(PlainSystem(other), root_of_tilted().searched,
                                 accuracy_of(kBits)),
               NotProven);
}

// 96 bits are too few for a cylinder, and so they are where A comes near 0.
TEST(MustFail, TooFewBitsAndSaysHowManyToTry) {
  const auto complaint = [](const Scene& scene, int bits) -> std::string {
    try {
      (void)prove(scene, accuracy_of(bits));
    } catch (const NotProven& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(complaint(cylinder(2.0 / 3.0, 0.0), 96).find("--bits 160"),
            std::string::npos);
  Scene thin = cylinder(0.0, 0.0);
  thin.body = Body::cylinder(1.0 / 3.0, 0.99, 0.0, 0.01);
  EXPECT_NE(complaint(thin, 128).find("--bits 192"), std::string::npos);
}

// A at the edge of the bounds: k = 1 − η², to the last bit and beyond.
TEST(MustFail, ABodyBeyondItsBounds) {
  Scene scene = cylinder(0.5, 0.0);
  scene.body = Body::cylinder(1.0 / 3.0, 0.5, 0.0, 0.75);
  EXPECT_NO_THROW((void)prove(scene, accuracy_of(kBits)));
  Json made = prove(bead(), accuracy_of(kBits));
  made["scene"]["shape"] = "cylinder";
  made["scene"]["radius"] = "0x1p-2";
  made["scene"]["eta_m"] = "0x1p-1";
  made["scene"]["k"] = "0x1.8p+0";
  made["digest"] = digest(made);
  EXPECT_THROW((void)check(made), Refused);
}

/// Whether an extremal near these unknowns has no point conjugate to its end.
Theorem no_conjugate_point_near(const Scene& scene, const Vector& unknowns) {
  Accuracy accuracy = accuracy_of(160);
  const Bits bits(accuracy.bits);
  accuracy.near = true;
  Flow flow(scene, 0, accuracy);
  State end = PlainSystem(scene).start(unknowns, 0);
  flow.go(end, unknowns.back());
  accuracy.near = false;
  return no_conjugate_point(scene, end, unknowns.back(), accuracy);
}

// Two smooth contacts of r = 0.2, τ = 5.483744 and 5.424799, which the search
// over branches calls a saddle and a minimum.
TEST(MustFail, ASaddleAsAMinimum) {
  Scene scene = cylinder(0.0, 0.0);
  scene.body = Body::cylinder(0.2, 2.0 / 3.0, 0.0, 0.5);
  const Theorem saddle = no_conjugate_point_near(
      scene, {Real(-0.305555229700), Real(0.272520654240), Real(0.250279547845),
              Real(9.96677384675)});
  const Theorem minimum = no_conjugate_point_near(
      scene, {Real(-0.779616221785), Real(0.313300065996), Real(0.838052260953),
              Real(9.58875509214)});
  EXPECT_FALSE(saddle.holds);
  EXPECT_TRUE(saddle.refuted) << saddle.why_not;
  EXPECT_TRUE(minimum.holds) << minimum.why_not;
}

// problems/hard/B_below_A.yaml, of which `solve` says that the body lifts off
// and that the track folds: both are shown, and shown again.
TEST(MustFail, ForcesAndFoldsOfAnInfeasibleTrack) {
  Scene scene = cylinder(2.0 / 3.0, 0.0);
  scene.L = 0.01;
  const Json made = prove(scene, accuracy_of(kBits));
  for (const char* name : {"normal_force_positive", "no_fold"}) {
    EXPECT_FALSE(made["theorems"][name]["holds"].get<bool>()) << name;
    EXPECT_TRUE(made["theorems"][name].contains("refuted")) << name;
  }
  EXPECT_NO_THROW((void)check(made));
  Json forged = made;
  forged["theorems"]["no_fold"]["why_not"] = "that anybody cares is false";
  forged["digest"] = digest(forged);
  EXPECT_THROW((void)check(forged), Refused);
}

struct Cycloid {
  Real alpha, tau;
};

/// The cycloid of a uniform cylinder, α wide, from (r, 0): with φ = π/2 − α/2,
/// a (α − sin α) = L + r sin φ − r and a (1 − cos α) = H − r cos φ,
/// τ = α √(2 (1 + k) a/H).
Cycloid closed_form(const Scene& scene) {
  const Real r(scene.body.radius), L(scene.L), one(1.0), half(0.5);
  const auto down = [&](const Real& alpha) {
    return one - r * sin(alpha * half);
  };
  const auto off = [&](const Real& alpha) {
    return (alpha - sin(alpha)) * down(alpha) -
           (one - cos(alpha)) * (L - r + r * cos(alpha * half));
  };
  Real low(3.0), high(6.0);
  EXPECT_TRUE((-off(low)).positive());
  EXPECT_TRUE(off(high).positive());
  for (int i = 0; i < 90; ++i) {
    const Real middle = ((low + high) * half).middle();
    (off(middle).positive() ? high : low) = middle;
  }
  EXPECT_TRUE((-off(low)).positive());
  EXPECT_TRUE(off(high).positive());
  const Real alpha = hull(low, high);
  const Real a = down(alpha) / (one - cos(alpha));
  return {alpha, alpha * sqrt(Real(2.0) * (one + Real(scene.body.k)) * a)};
}

// α grows evenly in time, and with β = π/2 − α/2 Newton's law is
// R_n = cos β (2 + k)/(1 + k), R_t = sin β k/(1 + k): friction is needed most
// where it begins to be asked for, k cot(α/2)/(2 + k).
TEST(ClosedForm, OfAUniformCylinderLiesInside) {
  const Scene scene = cylinder(0.0, 0.0);
  const Json made = prove(scene, accuracy_of(kBits));
  const Bits bits(256);
  const auto ball = [](const Json& enclosure) {
    Real out;
    EXPECT_TRUE(Real::read(enclosure["ball"].get<std::string>(), out));
    return out;
  };
  const auto [alpha, tau] = closed_form(scene);
  const Real found = ball(made["enclosures"]["tau"]);
  EXPECT_TRUE(tau.within(found));
  EXPECT_LT(found.radius().upper(), 1e-18);
  EXPECT_EQ(made["least_friction"].size(), 2);
  for (const Json& said : made["least_friction"]) {
    const Real half =
        alpha * Real(said["share_of_time"].get<double>()) * Real(0.5);
    const Real k(scene.body.k);
    const Real mu = k * cos(half) / (sin(half) * (Real(2.0) + k));
    EXPECT_TRUE(mu.within(ball(said["mu"]))) << mu.near();
    EXPECT_LT(ball(said["mu"]).radius().upper(), 1e-10 * mu.near());
  }
  for (const auto& [name, said] : made["theorems"].items()) {
    EXPECT_TRUE(said["holds"].get<bool>()) << name;
  }
}

}  // namespace
}  // namespace brachisto
