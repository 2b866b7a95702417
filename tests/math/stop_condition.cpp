// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/math/clock.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

namespace brachisto::testing {
namespace {

const StopCondition kNever;
const StopCondition kAtOnce(0.0, nullptr);

TEST(CheckStop, DoesNothingWhereNoConditionIsInForce) {
  EXPECT_NO_THROW(check_stop());
}

TEST(CheckStop, ThrowsAsSoonAsTheFlagIsSet) {
  std::atomic<int> flag{0};
  const StopScope scope(StopCondition(3600.0, &flag));
  EXPECT_NO_THROW(check_stop());

  flag = 2;

  EXPECT_THROW(check_stop(), Stopped);
}

TEST(CheckStop, ThrowsOnceTheTimeIsOver) {
  const StopScope scope(kAtOnce);

  EXPECT_THROW(check_stop(), Stopped);
}

TEST(StopScope, LeavesOtherConditionsInForce) {
  const StopScope outer(kAtOnce);
  const StopScope inner(kNever);

  EXPECT_THROW(check_stop(), Stopped);
}

TEST(StopScope, EndsWithItsBlock) {
  {
    const StopScope scope(kAtOnce);
    EXPECT_THROW(check_stop(), Stopped);
  }

  EXPECT_NO_THROW(check_stop());
}

TEST(StopScope, IsOfOneThread) {
  const StopScope scope(kAtOnce);
  bool other_went_on = false;

  std::thread other([&] {
    check_stop();
    other_went_on = true;
  });
  other.join();

  EXPECT_TRUE(other_went_on);
}

TEST(CheckStop, OfALoopLooksInOneOf1024Turns) {
  const StopScope scope(kAtOnce);

  EXPECT_THROW(check_stop(0), Stopped);
  for (int turn = 1; turn < 1024; ++turn) EXPECT_NO_THROW(check_stop(turn));
  EXPECT_THROW(check_stop(1024), Stopped);
}

}  // namespace
}  // namespace brachisto::testing
