// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Which arcs a solution asks for whose multipliers have the wrong sign here and
// there, for they are made so.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "brachisto/math/index.hpp"
#include "brachisto/study/solve.hpp"
#include "refinement/arcs.hpp"
#include "study/answer_kinds.hpp"
#include "support/limited_scenes.hpp"

namespace brachisto {
namespace {

using nlp::Held;
using ::testing::SizeIs;

/// Cycloid, straight line along the floor, cycloid.
class AlongAFloor : public ::testing::Test {
 protected:
  /// \param signs  of the multiplier on each element of the arc along the
  ///               floor; '+': the right one
  [[nodiscard]] ArcsFromA corrected_with(const std::string& signs) {
    const Solution solution =
        solve(testing::under(testing::uniform_scene(), testing::floor_at(1.1)));
    const auto* answer = answer_as<LimitedPathAnswer>(solution.answer);
    if (answer == nullptr || answer->arcs.size() != 3) {
      ADD_FAILURE() << solution.message;
      return {};
    }
    const LimitedCurve& path = answer->motion.curve();
    arcs = answer->arcs;
    arcs[1].cuts = equal_cuts(static_cast<int>(signs.size()));
    const LimitedTime& before = path.problem();
    LimitedTime problem(before.scene(), before.limits(),
                        mesh_of(arcs, before.mesh().degree), before.ends(),
                        held_limits(arcs, {}));
    PrimalDual point = prolong(path, problem);
    const int p = problem.mesh().degree, first = arcs[0].elements();
    for (int e = first; e < first + arcs[1].elements(); ++e) {
      const bool right = signs[at(e - first)] == '+';
      for (int c = e * p; c < (e + 1) * p; ++c) {
        const double weight = problem.scheme().rule.weights[at(c - e * p)];
        for (std::size_t i = 0; i < arcs[1].held.size(); ++i) {
          if (arcs[1].held[i] == Held::No) continue;
          const bool upper = arcs[1].held[i] == Held::AtUpper;
          point.lambda[at(problem.layout().limit(c, static_cast<int>(i)))] =
              (right == upper ? 1.0 : -1.0) * weight * problem.mesh().length(e);
        }
      }
    }
    const LimitedCurve curve(problem, std::move(point));
    const auto other = corrected(curve, arcs, Takeover::LedBack, kExceeded);
    EXPECT_TRUE(other.has_value());
    return other.value_or(ArcsFromA{});
  }
  /// Where an element of that arc begins.
  [[nodiscard]] double begin_of(int element) const {
    return arcs[0].end + (arcs[1].end - arcs[0].end) * element /
                             static_cast<double>(arcs[1].elements());
  }

  std::vector<Arc> arcs;  ///< that are corrected
};

TEST_F(AlongAFloor, WhatIsLeftBetweenReleasedStretchesIsReleasedWithThem) {
  const ArcsFromA found = corrected_with("+++++++-+-");

  ASSERT_THAT(found.arcs, SizeIs(3));
  EXPECT_NEAR(found.arcs[1].end, begin_of(7),
              0.1 * (begin_of(1) - begin_of(0)));
}

TEST_F(AlongAFloor, ALongStretchBetweenTwoStays) {
  // Four times as long as each of both.
  const ArcsFromA found = corrected_with("++++-++++-");

  ASSERT_THAT(found.arcs, SizeIs(5));
  EXPECT_NEAR(found.arcs[3].end, begin_of(9),
              0.1 * (begin_of(1) - begin_of(0)));
}

TEST_F(AlongAFloor, IsLeftOnceWhereOneStretchIsReleased) {
  const ArcsFromA found = corrected_with("+++++---++");

  ASSERT_THAT(found.arcs, SizeIs(5));
  EXPECT_NEAR(found.arcs[2].end, begin_of(8),
              0.1 * (begin_of(1) - begin_of(0)));
}

}  // namespace
}  // namespace brachisto
