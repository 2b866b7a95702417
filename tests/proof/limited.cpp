// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Proofs under limits: closed forms lie inside, and what is wrong is not
// proven.

#include <gtest/gtest.h>

#include <limits>
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

// A limit that does not hold anywhere changes nothing: R_n, which is 0 at rest,
// is positive behind it.
TEST(Limited, AFreePathKeepsALoadAboveNothing) {
  Scene scene = bead();
  const Json free = prove(scene, accuracy_of(kBits));
  scene.limits.normal_min = 0.0;
  const Json made = prove(scene, accuracy_of(kBits));
  const Bits bits(256);
  EXPECT_TRUE((enclosed(made, "tau") - enclosed(free, "tau")).has_zero());
  for (const char* name : {"keeps_limits", "strong_minimum"}) {
    EXPECT_TRUE(made["theorems"][name]["holds"].get<bool>()) << name;
  }
  EXPECT_EQ(check(made)["theorems"], made["theorems"]);
}

/// No valley is rounder than a circle of 2 m.
Scene on_a_circle_and_a_floor() {
  Scene scene = on_floor();
  scene.limits.curvature.valley = 0.5;
  return scene;
}

// The circle through A that touches the floor does so at x = √3 m; from there
// the bead goes at √(2 g H).
TEST(Limited, ABeadLandsOnAFloorAlongACircle) {
  const Json made = prove(on_a_circle_and_a_floor(), accuracy_of(kBits));
  const Bits bits(256);
  const Real place = sqrt(Real(3.0));
  ASSERT_EQ(made["junctions"].size(), 1);
  const Json& landing = made["junctions"][0];
  EXPECT_TRUE(place.within(ball_of(landing["x_per_H"])));
  EXPECT_TRUE(
      (ball_of(landing["time"]) + Real(3.0) - place - enclosed(made, "tau"))
          .has_zero());
  EXPECT_EQ(made["arcs"][0]["holds"], "valley");
  for (const auto& [name, said] : made["theorems"].items()) {
    EXPECT_TRUE(said["holds"].get<bool>()) << name;
  }
  EXPECT_EQ(check(made)["theorems"], made["theorems"]);
}

// Two limits on one side: on a circle of curvature κ from β₀, R_n = cos β + 2 κ
// z and κ z = cos β − cos β₀, so that the load N takes over at 3 cos β = N + 2
// cos β₀.
TEST(Limited, ALoadTakesOverFromACircle) {
  Scene scene = bead();
  scene.limits.curvature.valley = 0.75;
  scene.limits.normal_max = 1.6875;
  const Json made = prove(scene, accuracy_of(kBits));
  const Bits bits(256);
  ASSERT_EQ(made["arcs"].size(), 2);
  EXPECT_EQ(made["arcs"][0]["holds"], "valley");
  EXPECT_EQ(made["arcs"][1]["holds"], "normal_force");
  EXPECT_FALSE(made["arcs"][1].contains("from_the_other_side"));
  const Real start = enclosed(made, "start_angle");
  const Real cosine = (Real(1.6875) + Real(2.0) * cos(start)) / Real(3.0);
  const Real sine = sqrt(Real(1.0) - cosine * cosine);
  const Real place = (sin(start) - sine) / Real(0.75);
  const Real found = ball_of(made["junctions"][0]["x_per_H"]);
  EXPECT_TRUE((place - found).has_zero());
  EXPECT_LT(place.radius().upper() + found.radius().upper(), 1e-17);
  for (const char* name : {"keeps_limits", "multipliers"}) {
    EXPECT_TRUE(made["theorems"][name]["holds"].get<bool>()) << name;
  }
}

// From one bend to the other at once; the less a hump may bend the slower.
TEST(Limited, AHumpGoesOverIntoAValley) {
  const auto prove_with = [](double bend) {
    Scene scene = bead();
    scene.body = Body::cylinder(1.0 / 3.0, 0.0, 0.0, 0.5);
    scene.contact = Contact::Optimal;
    scene.limits.curvature.hump = bend;
    scene.limits.curvature.valley = 1.5;
    return prove(scene, accuracy_of(160));
  };
  const Json made = prove_with(3.0);
  const Json tighter = prove_with(2.5);
  const Bits bits(256);
  EXPECT_TRUE((enclosed(tighter, "tau") - enclosed(made, "tau")).positive());
  EXPECT_EQ(made["arcs"][0]["holds"], "hump");
  EXPECT_EQ(made["arcs"][1]["holds"], "valley");
  EXPECT_TRUE(made["arcs"][1].value("from_the_other_side", false));
  for (const auto& [name, said] : made["theorems"].items()) {
    EXPECT_TRUE(said["holds"].get<bool>()) << name;
  }
  EXPECT_EQ(check(made)["theorems"], made["theorems"]);
}

/// The bead's scene with these arcs, found from those of the floor.
struct OnFloor {
  NearChain near = approximate_chain(on_floor());
  Root root =
      find_root(ArcSystem(near.chain), near.unknowns, accuracy_of(kBits));
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
  EXPECT_THROW((void)verify_root(ArcSystem(other), found.root.searched,
                                 accuracy_of(kBits)),
               NotProven);
  EXPECT_NO_THROW((void)verify_root(ArcSystem(found.near.chain),
                                    found.root.searched, accuracy_of(kBits)));
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
  const Root root = find_root(system, near.unknowns, accuracy_of(kBits));
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

// Costates jump into the allowed side: of another jump, and of the same one at
// a roof, it is shown that the sign is wrong.
TEST(MustFail, AJumpToTheWrongSide) {
  const NearChain near = approximate_chain(on_a_circle_and_a_floor());
  const ArcSystem system(near.chain);
  const Root root = find_root(system, near.unknowns, accuracy_of(kBits));
  const auto why_not = [](const ArcSystem& of, const Root& at) {
    const Theorem shown =
        prove_arc_theorems(of, at, accuracy_of(kBits)).multipliers;
    EXPECT_EQ(shown.holds, !shown.refuted);
    return shown.why_not;
  };
  EXPECT_EQ(why_not(system, root), "");
  Root other = root;
  Real& jump = other.found[near.chain.jump(1)];
  EXPECT_TRUE(jump.positive());
  jump = -jump;
  EXPECT_NE(why_not(system, other).find("jump"), std::string::npos);
  ArcChain roof = near.chain;
  PathInequality& limit = roof.arcs[1]->limit;
  limit.lower = -std::numeric_limits<double>::infinity();
  limit.upper = 0.0;
  EXPECT_NE(why_not(ArcSystem(roof), root).find("jump"), std::string::npos);
}

/// A certificate of a free path to which a floor is added that it breaks.
Json with_a_floor_in_its_way() {
  Scene scene = bead();
  scene.world.start_speed = 1e-3;
  Json made = prove(scene, accuracy_of(kBits));
  made["scene"]["limits"]["floor"] = hex(1.0625);
  return made;
}

// That it exists is shown; that it keeps the floor, or is a minimum, is not.
TEST(MustFail, AFreeMinimumUnderAFloorThatIsForged) {
  static const Json free = with_a_floor_in_its_way();
  const auto refusal = [](const auto& edit) -> std::string {
    Json forged = free;
    edit(forged["theorems"]);
    forged["digest"] = digest(forged);
    try {
      const Json again = check(forged)["theorems"];
      EXPECT_FALSE(again["keeps_limits"]["holds"].get<bool>());
      EXPECT_TRUE(again["keeps_limits"].contains("refuted"));
    } catch (const Refused& error) {
      return error.what();
    }
    return "";
  };
  const auto without_minimum = [](Json& theorems) {
    for (const char* name : {"strict_minimum", "strong_minimum"}) {
      theorems[name]["holds"] = false;
    }
  };
  EXPECT_NE(refusal([](Json&) {}), "");
  EXPECT_NE(refusal(without_minimum), "");
  EXPECT_NE(refusal([](Json& t) {
              t["keeps_limits"] = {{"holds", true}};
            }),
            "");
  const Json open = {{"holds", false}, {"why_not", "it is left open"}};
  EXPECT_NE(refusal([&](Json& t) {
              t["keeps_limits"] = open;
            }).find("strict_minimum"),
            std::string::npos);
  EXPECT_EQ(refusal([&](Json& t) {
              without_minimum(t);
              t["keeps_limits"] = open;
            }),
            "");
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
