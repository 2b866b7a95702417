// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "transcription/smooth_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/rounding.hpp"

namespace brachisto::testing {
namespace {

using EndSlope = std::function<std::optional<double>(double)>;

/// Calls a made-up β_end and remembers where.
struct Recorder {
  EndSlope end_slope;
  std::vector<double> visited;

  std::optional<double> operator()(double phi) {
    visited.push_back(phi);
    return end_slope(phi);
  }
};

Tangency close(Recorder& recorder, double start,
               const TangencyOptions& options = {}) {
  return close_contact(std::ref(recorder), start, options);
}

TEST(CloseContact, NeedsThreePassesForALinearFunction) {
  // Plain substitution, one secant through two points of a line, confirmation.
  for (const double slope : {-2.0, -0.5, 0.0, 0.5, 0.9}) {
    const double root = 0.1;
    Recorder recorder{[&](double phi) { return root + slope * (phi - root); },
                      {}};

    const Tangency tangency = close(recorder, 0.15);

    EXPECT_TRUE(tangency.closed) << "slope " << slope;
    // The mismatch is below the tolerance, and it is slope − 1 per radian.
    EXPECT_NEAR(tangency.phi, root, 1e-12 / (1.0 - slope)) << "slope " << slope;
    EXPECT_LE(tangency.passes, 3) << "slope " << slope;
    EXPECT_EQ(tangency.passes, static_cast<int>(recorder.visited.size()));
    // As the secant sees it, from values off by ε over steps above 5 %.
    if (tangency.passes == 3) {
      EXPECT_NEAR(tangency.slope, slope - 1.0, 1e-3) << "slope " << slope;
    }
  }
}

TEST(CloseContact, NeedsOnePassWhereItStarts) {
  Recorder recorder{[](double) { return 0.3; }, {}};

  const Tangency tangency = close(recorder, 0.3);

  EXPECT_TRUE(tangency.closed);
  EXPECT_EQ(tangency.passes, 1);
  EXPECT_EQ(tangency.phi, 0.3);
  EXPECT_EQ(tangency.mismatch, 0.0);
}

TEST(CloseContact, NeedsTwoPassesIfItKnowsTheSlope) {
  Recorder recorder{[](double phi) { return 0.1 + 0.5 * (phi - 0.1); }, {}};
  TangencyOptions options;
  options.initial_slope = -0.5;

  const Tangency tangency = close(recorder, 0.2, options);

  EXPECT_TRUE(tangency.closed);
  EXPECT_EQ(tangency.passes, 2);
}

TEST(CloseContact, ClosesStronglyCurvedFunctions) {
  const std::vector<EndSlope> functions{
      [](double phi) { return std::cos(phi); },
      [](double phi) { return 0.8 - 2.0 * std::tanh(8.0 * phi); },
      [](double phi) { return std::exp(-3.0 * phi) - 1.0; },
      [](double phi) { return phi - std::atan(30.0 * (phi - 0.2)); },
      [](double phi) {
        const double d = phi - 0.2;
        return phi - 0.3 * d - 5.0 * d * d * d;
      },
  };
  for (std::size_t i = 0; i < functions.size(); ++i) {
    for (const double start : {-0.8, 0.0, 0.9}) {
      Recorder recorder{functions[i], {}};

      const Tangency tangency = close(recorder, start);

      EXPECT_TRUE(tangency.closed) << "function " << i << " from " << start;
      const double mismatch = *functions[i](tangency.phi) - tangency.phi;
      EXPECT_EQ(tangency.mismatch, mismatch);
      EXPECT_LE(std::abs(mismatch), TangencyOptions{}.loose_tolerance);
    }
  }
}

TEST(CloseContact, ClosesWhereSubstitutionWouldRunAway) {
  // β_end' = 1.5 and 4: each substitution leads farther from the root.
  for (const double slope : {1.5, 4.0}) {
    Recorder recorder{[&](double phi) { return slope * (phi - 0.2) + 0.2; },
                      {}};

    const Tangency tangency = close(recorder, 0.25);

    EXPECT_TRUE(tangency.closed) << "slope " << slope;
    EXPECT_NEAR(tangency.phi, 0.2, 1e-12 / (slope - 1.0)) << "slope " << slope;
  }
}

TEST(CloseContact, TakesNoLongStepsBeforeItHasABracket) {
  Recorder recorder{[](double phi) { return -3.0 + 0.2 * phi; }, {}};
  const double first_step = TangencyOptions{}.first_step;

  const Tangency tangency = close(recorder, 0.0);

  EXPECT_TRUE(tangency.closed);
  bool positive = false, negative = false;
  for (std::size_t i = 1; i < recorder.visited.size(); ++i) {
    const double before = recorder.visited[i - 1];
    (*recorder.end_slope(before) > before ? positive : negative) = true;
    if (positive && negative) break;
    EXPECT_LE(std::abs(recorder.visited[i] - before),
              first_step + ulps(1.0, 4.0))
        << "pass " << i;
  }
}

/// Noise of the given level that is a function of φ, as that of a solver is.
double noise(double phi, double level) {
  const double phase = std::fmod(std::abs(phi) * 1e15, 7.0);
  return level * std::sin(10.0 * phase);
}

TEST(CloseContact, StopsAtTheLevelOfNoise) {
  for (const double level : {1e-13, 1e-12, 1e-11}) {
    for (const double slope : {-0.7, 0.3, 1.5}) {
      Recorder recorder{[&](double phi) {
                          return 0.1 + slope * (phi - 0.1) + noise(phi, level);
                        },
                        {}};

      const Tangency tangency = close(recorder, 0.3);

      EXPECT_TRUE(tangency.closed) << "noise " << level << " slope " << slope;
      EXPECT_LE(std::abs(tangency.mismatch), TangencyOptions{}.loose_tolerance);
      EXPECT_LE(tangency.passes, 12) << "noise " << level << " slope " << slope;
    }
  }
}

TEST(CloseContact, GivesUpWithoutARoot) {
  const std::vector<EndSlope> functions{
      [](double phi) { return phi + 1.0; },
      [](double phi) { return phi + 0.5 + phi * phi; },
      [](double phi) { return phi - 0.01 - std::exp(phi); },
  };
  for (std::size_t i = 0; i < functions.size(); ++i) {
    Recorder recorder{functions[i], {}};

    const Tangency tangency = close(recorder, 0.1);

    EXPECT_FALSE(tangency.closed) << "function " << i;
    EXPECT_LE(tangency.passes, TangencyOptions{}.max_passes);
    EXPECT_TRUE(std::isfinite(tangency.phi)) << "function " << i;
    EXPECT_EQ(tangency.passes, static_cast<int>(recorder.visited.size()));
  }
}

TEST(CloseContact, DoesNotTakeAJumpForARoot) {
  Recorder recorder{[](double phi) { return phi < 0.2 ? 1.0 : -1.0; }, {}};

  const Tangency tangency = close(recorder, 0.0);

  EXPECT_FALSE(tangency.closed);
  EXPECT_GT(std::abs(tangency.mismatch), 0.5);
}

TEST(CloseContact, EndsWhereTheProblemCannotBeSolved) {
  int calls = 0;
  const auto fails_later = [&](double phi) -> std::optional<double> {
    if (++calls == 2) return std::nullopt;
    return 0.5 * phi;
  };
  const auto not_a_number = [](double) { return std::nan(""); };

  const Tangency failed = close_contact(fails_later, 1.0);
  const Tangency nan = close_contact(not_a_number, 1.0);

  EXPECT_FALSE(failed.closed);
  EXPECT_EQ(failed.passes, 2);
  EXPECT_EQ(calls, 2);
  EXPECT_FALSE(nan.closed);
  EXPECT_EQ(nan.passes, 1);
}

TEST(CloseContact, FindsTheNearerOfTwoRoots) {
  // Mismatch −(φ − 0.1)(φ + 0.9): roots 0.1, where substitution contracts, and
  // −0.9.
  const auto two_roots = [](double phi) {
    return phi - (phi - 0.1) * (phi + 0.9);
  };
  Recorder near_upper{two_roots, {}}, near_lower{two_roots, {}};
  TangencyOptions options;

  const Tangency upper = close(near_upper, 0.2, options);
  options.initial_slope = 1.0;  // what the mismatch has at −0.9
  const Tangency lower = close(near_lower, -0.8, options);

  EXPECT_TRUE(upper.closed);
  EXPECT_TRUE(lower.closed);
  // The mismatch has slope ∓1 there.
  EXPECT_NEAR(upper.phi, 0.1, 2e-12);
  EXPECT_NEAR(lower.phi, -0.9, 2e-12);
}

TEST(CloseContact, RespectsItsBudget) {
  Recorder recorder{[](double phi) { return std::cos(phi); }, {}};
  TangencyOptions options;
  options.max_passes = 3;

  const Tangency tangency = close(recorder, -1.0, options);

  EXPECT_FALSE(tangency.closed);
  EXPECT_EQ(tangency.passes, 3);
  ASSERT_EQ(recorder.visited.size(), 3U);
}

TEST(CloseContact, ReportsTheLastPassWhenItsBudgetIsSpent) {
  Recorder recorder{[](double phi) { return std::cos(phi); }, {}};
  TangencyOptions options;
  options.max_passes = 3;

  const Tangency tangency = close(recorder, -1.0, options);

  EXPECT_EQ(tangency.phi, recorder.visited.back());
  EXPECT_EQ(tangency.mismatch, std::cos(tangency.phi) - tangency.phi);
}

}  // namespace
}  // namespace brachisto::testing
