// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/math/clock.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <limits>
#include <numeric>

namespace brachisto {
namespace {

/// Processor time by another clock than the one under test, good to 1e-6 s.
double processor_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Computes until so much processor time has passed; tells how much it was.
double work(double seconds) {
  const double start = processor_seconds();
  double passed = 0.0;
  volatile double sink = 0.0;
  while (passed < seconds) {
    for (int i = 0; i < 1000; ++i) sink = sink + std::sqrt(i);
    passed = processor_seconds() - start;
  }
  return passed;
}

constexpr double kWork = 0.03;      // [s]
constexpr double kPart = 0.01;      // relative, of times that were booked
constexpr double kClock = 50.0e-6;  // [s] that reading clocks may take

double total(const PhaseSeconds& phases) {
  return std::accumulate(phases.seconds.begin(), phases.seconds.end(), 0.0);
}

/// What has been booked since the construction.
class Since {
 public:
  [[nodiscard]] PhaseSeconds booked() const {
    PhaseSeconds now = phase_seconds();
    now -= start_;
    return now;
  }

 private:
  PhaseSeconds start_ = phase_seconds();
};

void expect_seconds(double booked, double passed) {
  EXPECT_NEAR(booked, passed, kPart * passed + kClock);
}

TEST(PhaseTimer, BooksTheInnermost) {
  const Since since;
  double ipopt = 0.0, evaluation = 0.0, factorisation = 0.0;
  {
    const PhaseTimer outer(Phase::Ipopt);
    ipopt += work(kWork);
    {
      const PhaseTimer inner(Phase::Evaluation);
      evaluation += work(2.0 * kWork);
      const PhaseTimer innermost(Phase::Factorisation);
      factorisation += work(3.0 * kWork);
    }
    // What is outside goes on where it was left.
    ipopt += work(kWork);
  }
  const double other = work(kWork);

  const PhaseSeconds booked = since.booked();

  expect_seconds(booked.of(Phase::Ipopt), ipopt);
  expect_seconds(booked.of(Phase::Evaluation), evaluation);
  expect_seconds(booked.of(Phase::Factorisation), factorisation);
  expect_seconds(booked.of(Phase::Other), other);
  EXPECT_EQ(booked.of(Phase::Solution), 0.0);
}

TEST(PhaseTimer, OfThePhaseItIsInChangesNothing) {
  const Since since;
  double passed = 0.0;
  {
    const PhaseTimer outer(Phase::Solution);
    {
      const PhaseTimer same(Phase::Solution);
      passed += work(kWork);
    }
    passed += work(kWork);
  }

  expect_seconds(since.booked().of(Phase::Solution), passed);
}

TEST(PhaseTimer, OfSomePhasesTakesAllWithin) {
  for (const Phase phase :
       {Phase::Start, Phase::Certificate, Phase::Diagnosis}) {
    const Since since;
    double passed = 0.0;
    {
      const PhaseTimer outer(phase);
      passed += work(kWork);
      {
        const PhaseTimer inner(Phase::Evaluation);
        passed += work(kWork);
        const PhaseTimer another(Phase::Certificate);
        passed += work(kWork);
      }
      passed += work(kWork);
      // Work that others timed within is part of it too.
      move_phase_seconds(Phase::Ipopt, Phase::SetUp, 1.0);
    }

    const PhaseSeconds booked = since.booked();

    expect_seconds(booked.of(phase), passed);
    for (std::size_t i = 0; i < kNumPhases; ++i) {
      const auto other = static_cast<Phase>(i);
      if (other == phase || other == Phase::Other) continue;
      EXPECT_EQ(booked.of(other), 0.0) << name(phase) << ", " << name(other);
    }
    EXPECT_LT(booked.of(Phase::Other), kPart * passed + kClock);
  }
}

TEST(PhaseTimer, EndsWithAnException) {
  try {
    const PhaseTimer timer(Phase::Ipopt);
    throw 1;
  } catch (int) {
  }
  const Since since;
  work(kWork);

  EXPECT_EQ(since.booked().of(Phase::Ipopt), 0.0);
}

TEST(PhaseSeconds, IncludesWhatIsUnderWay) {
  const PhaseTimer timer(Phase::Factorisation);
  const Since since;
  const double passed = work(kWork);

  expect_seconds(since.booked().of(Phase::Factorisation), passed);
}

TEST(PhaseSeconds, AddUpToTheProcessorTime) {
  const double start = processor_seconds();
  const Since since;
  constexpr Phase kSome[] = {Phase::Evaluation, Phase::Ipopt,
                             Phase::Certificate, Phase::SetUp, Phase::Other};
  for (int round = 0; round < 20; ++round) {
    for (const Phase phase : kSome) {
      const PhaseTimer outer(phase);
      work(1e-3);
      const PhaseTimer inner(Phase::Solution);
      work(1e-3);
    }
  }

  const double booked = total(since.booked());
  const double passed = processor_seconds() - start;

  ASSERT_GE(passed, 0.2);
  EXPECT_NEAR(booked, passed, 0.01 * passed);
}

TEST(MovePhaseSeconds, KeepsTheSumAndTakesNoMoreThanThereIs) {
  constexpr double kMoved = 0.01;
  {
    const PhaseTimer timer(Phase::Ipopt);
    work(3.0 * kMoved);
  }
  const PhaseSeconds before = phase_seconds();
  const Since since;

  move_phase_seconds(Phase::Ipopt, Phase::Solution, kMoved);

  const PhaseSeconds booked = since.booked();
  const double rounding = 64.0 * std::numeric_limits<double>::epsilon() *
                          (1.0 + total(phase_seconds()));
  EXPECT_NEAR(booked.of(Phase::Ipopt), -kMoved, rounding);
  EXPECT_NEAR(booked.of(Phase::Solution), kMoved, rounding);
  // What passes meanwhile is that of no phase.
  EXPECT_NEAR(total(booked), booked.of(Phase::Other), rounding);

  move_phase_seconds(Phase::Ipopt, Phase::Solution, 1e6);

  EXPECT_NEAR(phase_seconds().of(Phase::Ipopt), 0.0, rounding);
  EXPECT_NEAR(phase_seconds().of(Phase::Solution),
              before.of(Phase::Solution) + before.of(Phase::Ipopt), rounding);
}

}  // namespace
}  // namespace brachisto
