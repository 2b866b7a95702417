// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Proofs under limits: closed forms lie inside, and what is wrong is not
// proven.

#include <gtest/gtest.h>

#include <string>

#include "proof/arc_theorems.hpp"
#include "proof/certificate.hpp"
#include "proof/enclosed.hpp"
#include "proof/scenes.hpp"

namespace brachisto {
namespace {

using namespace proof;
using brachisto::testing::ball_of;
using brachisto::testing::bead;
using brachisto::testing::cylinder;
using brachisto::testing::enclosed;
using brachisto::testing::kBits;

/// A bead to a point of the floor, 1 m below.
Scene on_floor() {
  Scene scene = bead();
  scene.limits.floor = 1.0;
  return scene;
}

// Half an arch of a cycloid as high as the floor is deep, π/2 m wide, takes
// τ = π; the rest is rolled at √(2 g H), which takes τ = L − π/2.
TEST(Limited, ABeadLandsOnAFloorAfterHalfAnArch) {
  const Json made = prove(on_floor(), accuracy_of(kBits));
  const Bits bits(256);
  const Real half_pi = Real::pi() * Real(0.5);
  EXPECT_TRUE((Real(3.0) + half_pi).within(enclosed(made, "tau")));
  EXPECT_LT(enclosed(made, "tau").radius().upper(), 1e-18);
  ASSERT_EQ(made["junctions"].size(), 1);
  const Json& landing = made["junctions"][0];
  EXPECT_TRUE(half_pi.within(ball_of(landing["x_per_H"])));
  EXPECT_TRUE(Real::pi().within(ball_of(landing["time"])));
  for (const auto& [name, said] : made["theorems"].items()) {
    EXPECT_TRUE(said["holds"].get<bool>()) << name;
  }
  const std::string text = page(made);
  EXPECT_NE(text.find("free, floor"), std::string::npos);
  EXPECT_NE(text.find("`keeps_limits`: proven"), std::string::npos);
  EXPECT_EQ(check(made)["theorems"], made["theorems"]);
}

// What a limit costs: it is slower than the free cycloid, and the less it
// binds the less. Loads are held on an arc in the valley.
TEST(Limited, ALoadIsHeldOnAnArc) {
  Scene scene = bead();
  scene.limits.normal_max = 1.75;
  const Json made = prove(scene, accuracy_of(kBits));
  scene.limits.normal_max = 1.625;
  const Json tighter = prove(scene, accuracy_of(kBits));
  scene.limits = {};
  const Json free = prove(scene, accuracy_of(kBits));
  const Bits bits(256);
  EXPECT_TRUE((enclosed(made, "tau") - enclosed(free, "tau")).positive());
  EXPECT_TRUE((enclosed(tighter, "tau") - enclosed(made, "tau")).positive());
  EXPECT_EQ(made["arcs"][1]["holds"], "normal_force");
  for (const char* name : {"keeps_limits", "multipliers", "legendre"}) {
    EXPECT_TRUE(made["theorems"][name]["holds"].get<bool>()) << name;
  }
}

/// The bead's scene with these arcs, found from those of the floor.
struct OnFloor {
  NearChain near = approximate_chain(on_floor());
  ArcRoot root =
      find_arc_root(ArcSystem(near.chain), near.unknowns, accuracy_of(kBits));
};
const OnFloor& found_on_floor() {
  static const OnFloor found;
  return found;
}

// A floor that is 1e-12 higher, B with it: the landing lies elsewhere.
TEST(MustFail, AnotherFloor) {
  const OnFloor& found = found_on_floor();
  ArcChain other = found.near.chain;
  other.scene.limits.floor = other.scene.H = 1.0 - 0x1p-40;
  other.arcs[1]->limit.number = *other.scene.limits.floor;
  EXPECT_THROW((void)verify_arc_root(ArcSystem(other), found.root.searched,
                                     accuracy_of(kBits)),
               NotProven);
  EXPECT_NO_THROW((void)verify_arc_root(
      ArcSystem(found.near.chain), found.root.searched, accuracy_of(kBits)));
}

// The free cycloid goes through the floor.
TEST(MustFail, AFreePathThroughAFloor) {
  NearChain near = approximate_chain([] {
    Scene scene = bead();
    scene.world.start_speed = 1e-3;  // for a chain
    return scene;
  }());
  near.chain.scene.limits.floor = 1.0;
  const ArcSystem system(near.chain);
  const ArcRoot root = find_arc_root(system, near.unknowns, accuracy_of(kBits));
  const ArcTheorems shown =
      prove_arc_theorems(system, root, accuracy_of(kBits));
  EXPECT_FALSE(shown.keeps.holds);
  EXPECT_TRUE(shown.keeps.refuted);
  EXPECT_NE(shown.keeps.why_not.find("floor"), std::string::npos);
}

// A path that keeps above a roof, as if that were a floor, has the multiplier
// of the wrong sign.
TEST(MustFail, ABoundFromTheWrongSide) {
  const OnFloor& found = found_on_floor();
  ArcChain roof = found.near.chain;
  PathInequality& limit = roof.arcs[1]->limit;
  limit.lower = -std::numeric_limits<double>::infinity();
  limit.upper = 0.0;
  const ArcTheorems shown =
      prove_arc_theorems(ArcSystem(roof), found.root, accuracy_of(kBits));
  EXPECT_FALSE(shown.multipliers.holds);
  EXPECT_TRUE(shown.multipliers.refuted);
}

TEST(MustFail, ForgedArcs) {
  const auto refusal = [](const auto& edit) -> std::string {
    static const Json made = prove(on_floor(), accuracy_of(kBits));
    Json forged = made;
    edit(forged);
    forged["digest"] = digest(forged);
    try {
      (void)check(forged);
    } catch (const Refused& error) {
      return error.what();
    } catch (const NotProven& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal([](Json&) {}), "");
  EXPECT_NE(refusal([](Json& c) { c["arcs"][1] = Json::object(); }), "");
  EXPECT_NE(refusal([](Json& c) { c["arcs"][1]["limit"] = 7; }), "");
  EXPECT_NE(refusal([](Json& c) { c["scene"]["limits"] = Json::object(); }),
            "");
  EXPECT_NE(refusal([](Json& c) { c["junctions"] = Json::array(); }), "");
  EXPECT_NE(refusal([](Json& c) {
              c["junctions"][0]["x_per_H"]["ball"] =
                  ball_of(c["junctions"][0]["x_per_H"]).middle().exact();
            }),
            "");
}

// From rest along a limit of forces the curvature is 0/0.
TEST(MustFail, FrictionFromRestAndSaysWhy) {
  Scene scene = cylinder(2.0 / 3.0, 0.0);
  scene.limits.friction = 1.0;
  try {
    (void)prove(scene, accuracy_of(kBits));
    ADD_FAILURE();
  } catch (const NotProven& error) {
    EXPECT_NE(std::string(error.what()).find("rest"), std::string::npos);
  }
}

}  // namespace
}  // namespace brachisto
