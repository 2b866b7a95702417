// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "proof/certificate.hpp"
#include "proof/scene_json.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "proof/scenes.hpp"

namespace brachisto {
namespace {

using namespace proof;
using brachisto::testing::bead;

const Json& certificate() {
  static const Json made = prove(bead(), accuracy_of(128));
  return made;
}

std::string refusal(const std::function<void(Json&)>& edit) {
  Json edited = certificate();
  edit(edited);
  try {
    (void)check(edited);
  } catch (const Refused& error) {
    return error.what();
  }
  return "";
}

/// τ = α √(2/(1 − cos α)) of the cycloid that is α wide,
/// (α − sin α)/(1 − cos α) = L/H: enclosed by signs beside a root.
Real closed_form() {
  const auto off = [](const Real& alpha) {
    return alpha - sin(alpha) - Real(3.0) * (Real(1.0) - cos(alpha));
  };
  Real alpha(4.0);
  for (int i = 0; i < 12; ++i) {
    const Real slope = Real(1.0) - cos(alpha) - Real(3.0) * sin(alpha);
    alpha = (alpha - off(alpha) / slope).middle();
  }
  const Real by(0x1p-90);
  EXPECT_TRUE((-off(alpha - by)).positive());
  EXPECT_TRUE(off(alpha + by).positive());
  alpha = alpha.widened(by);
  return alpha * sqrt(Real(2.0) / (Real(1.0) - cos(alpha)));
}

TEST(Certificate, OfABeadHoldsTheClosedForm) {
  const Bits bits(256);
  Real tau;
  ASSERT_TRUE(Real::read(
      certificate()["enclosures"]["tau"]["ball"].get<std::string>(), tau));
  EXPECT_TRUE(closed_form().within(tau));
  EXPECT_LT(tau.radius().upper(), 1e-17);
  for (const auto& [name, said] : certificate()["theorems"].items()) {
    EXPECT_TRUE(said["holds"].get<bool>()) << name;
  }
}

TEST(Certificate, IsAPageThatNamesEveryStatement) {
  const std::string text = page(certificate());
  for (const auto& [name, said] : certificate()["theorems"].items()) {
    EXPECT_NE(text.find("`" + name + "`: proven"), std::string::npos) << name;
  }
  for (const auto& [name, said] : certificate()["enclosures"].items()) {
    EXPECT_NE(text.find(said["lower"].get<std::string>()), std::string::npos);
  }
  EXPECT_NE(text.find("128 bits"), std::string::npos);
}

TEST(Certificate, IsShownAgain) {
  const Json again = check(certificate());
  EXPECT_EQ(again["theorems"], certificate()["theorems"]);
  EXPECT_NE(again["accuracy"], certificate()["accuracy"]);
}

TEST(Certificate, IsRefusedWhenEditedOrOfAnother) {
  EXPECT_NE(refusal([](Json& c) {
              c["enclosures"]["tau"]["upper"] = "4";
            }).find("edited"),
            std::string::npos);
  EXPECT_NE(refusal([](Json& c) { c["version"] = 99; }).find("version"),
            std::string::npos);
  EXPECT_NE(refusal([](Json& c) { c = Json::array(); }).find("no certificate"),
            std::string::npos);
  Scene other = bead();
  other.L = std::nextafter(other.L, 4.0);
  EXPECT_TRUE(is_of(certificate(), bead()));
  EXPECT_FALSE(is_of(certificate(), other));
}

/// What check() says of an edited file whose digest is its own again.
std::string refusal_of_forged(const std::function<void(Json&)>& edit) {
  return refusal([&](Json& c) {
    edit(c);
    c["digest"] = digest(c);
  });
}

// τ to more digits than can be shown, an end that is not that of the ball, and
// a theorem that nobody shows.
TEST(Certificate, IsRefusedWhenForgedThoughItsDigestFits) {
  const Bits bits(256);
  Real tau;
  ASSERT_TRUE(Real::read(
      certificate()["enclosures"]["tau"]["ball"].get<std::string>(), tau));
  EXPECT_NE(refusal_of_forged([&](Json& c) {
              c["enclosures"]["tau"]["ball"] = tau.middle().exact();
            }).find("its tau"),
            std::string::npos);
  EXPECT_NE(refusal_of_forged([](Json& c) {
              c["enclosures"]["tau"]["upper"] = "4.6";
            }).find("its tau"),
            std::string::npos);
  EXPECT_NE(refusal_of_forged([](Json& c) {
              c["theorems"]["global_minimum"] = {{"holds", true}};
            }).find("global_minimum"),
            std::string::npos);
  EXPECT_NE(refusal_of_forged([](Json& c) {
              c["theorems"]["no_fold"] = {{"holds", false}, {"refuted", true}};
            }).find("no_fold"),
            std::string::npos);
}

// Nothing stands in a file beside what is shown again, and nothing is missing.
TEST(Certificate, IsRefusedWhenItSaysMoreOrLess) {
  const auto refused = [](const auto& edit) {
    return !refusal_of_forged(edit).empty();
  };
  EXPECT_FALSE(refused([](Json&) {}));
  EXPECT_TRUE(refused([](Json& c) { c["arcs"] = Json::array(); }));
  EXPECT_TRUE(refused([](Json& c) { c["remark"] = "the best of all"; }));
  EXPECT_TRUE(refused([](Json& c) { c.erase("least_friction"); }));
  EXPECT_TRUE(refused(
      [](Json& c) { c["enclosures"]["energy"] = c["enclosures"]["tau"]; }));
  EXPECT_TRUE(refused([](Json& c) { c["enclosures"]["tau"]["about"] = "4"; }));
  EXPECT_TRUE(refused([](Json& c) { c["theorems"]["fastest"] = {}; }));
  EXPECT_TRUE(refused([](Json& c) {
    c["theorems"]["fastest"] = {{"why_not", "it is"}};
  }));
  EXPECT_TRUE(refused(
      [](Json& c) { c["theorems"]["no_fold"]["why_not"] = "it does"; }));
  EXPECT_TRUE(
      refused([](Json& c) { c["theorems"]["no_fold"]["always"] = true; }));
  EXPECT_TRUE(refused([](Json& c) { c["accuracy"]["steps"] = "few"; }));
  EXPECT_TRUE(refused([](Json& c) { c["accuracy"]["terms"] = 3; }));
  EXPECT_TRUE(refused([](Json& c) {
    Json renamed;
    for (const auto& [name, said] : c["unknowns"].items()) {
      renamed[name == "p_x" ? "p_y" : name] = said;
    }
    c["unknowns"] = renamed;
  }));
}

// The part of the box that is said to hold the root has to hold it.
TEST(Certificate, IsRefusedWhenItsRootIsAPointBesideIt) {
  EXPECT_NE(refusal_of_forged([](Json& c) {
              Json& said = c["unknowns"]["p_x"]["found"];
              said = ball(said).middle().exact();
            }).find("root"),
            std::string::npos);
}

Vector box_of(const Json& made) {
  Vector out;
  for (const auto& [name, said] : made["unknowns"].items()) {
    EXPECT_TRUE(
        Real::read(said["searched"].get<std::string>(), out.emplace_back()));
  }
  return out;
}

// A box beside the root, a scene whose end is an ulp away, and one that is too
// wide: Krawczyk's operator maps none of them into itself.
// As C's %a has them: fmt 10 writes 0 as 0x0p-1022, fmt 9 as here.
TEST(Certificate, WritesNumbersAlikeOnEverySystem) {
  EXPECT_EQ(hex(0.0), "0x0p+0");
  EXPECT_EQ(hex(1.5), "0x1.8p+0");
}

TEST(Krawczyk, RefusesABoxWithoutTheRoot) {
  const Accuracy accuracy = accuracy_of(128);
  const Vector box = box_of(certificate());
  EXPECT_NO_THROW((void)verify_root(PlainSystem(bead()), box, accuracy));
  Vector beside = box;
  beside[0] = beside[0] + beside[0].radius() * Real(3.0);
  EXPECT_THROW((void)verify_root(PlainSystem(bead()), beside, accuracy),
               NotProven);
  Scene farther = bead();
  farther.L = std::nextafter(3.0, 4.0);
  Vector narrow = box;
  for (Real& each : narrow) each = each.middle().widened(Real(0x1p-70));
  EXPECT_THROW((void)verify_root(PlainSystem(farther), narrow, accuracy),
               NotProven);
  Vector wide = box;
  for (Real& each : wide) each = each.widened(Real(0.25));
  EXPECT_THROW((void)verify_root(PlainSystem(bead()), wide, accuracy),
               NotProven);
}

}  // namespace
}  // namespace brachisto
