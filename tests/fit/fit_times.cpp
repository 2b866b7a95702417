// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "fit/fit_times.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "brachisto/study/solve.hpp"
#include "fit/synthetic.hpp"

namespace brachisto {
namespace {

using namespace testing;
using fit::CannotFit;
using fit::Fit;
using fit::TimedPlace;
using fit::Wanted;
using Shape = GivenPath::Shape;
using ::testing::HasSubstr;

constexpr double kSigma = 1e-3;  // [s]

Wanted wanted(std::initializer_list<const char*> keys, bool offset = false) {
  Wanted out{{}, offset, true};
  for (const char* key : keys) {
    out.parameters.push_back(fit::find_parameter(key));
  }
  return out;
}

Fit fit_on(const Scene& scene, const std::vector<TimedPlace>& times,
           const Wanted& asked) {
  return fit::fit_times(scene, centre_curve(scene), times, asked);
}

std::string refusal(const Scene& scene, const std::vector<TimedPlace>& times,
                    const Wanted& asked) {
  try {
    (void)fit_on(scene, times, asked);
  } catch (const CannotFit& error) {
    return error.what();
  }
  return "";
}

/// Times without noise give the numbers back, as far as χ² of rounding tells.
constexpr double kExact = 1e-9;

TEST(FitTimes, FindsTheFrictionOfABeadOnAnIncline) {
  Scene scene = led_along(bead_scene(), Shape::Straight);
  scene.world.losses.sliding = 0.1;
  const auto times = timed(scene, 10, kSigma, time_on_incline);
  scene.world.losses.sliding = 0.0;

  const Fit found = fit_on(scene, times, wanted({"scene.losses.sliding"}));

  EXPECT_NEAR(found.estimates[0].value, 0.1, kExact);
  EXPECT_EQ(found.estimates[0].start, 0.0);
  EXPECT_NEAR(found.chi_squared, 0.0, kExact);
  EXPECT_EQ(found.freedom, 9);
  EXPECT_NEAR(found.transit_time, times.back().t, kExact);
}

TEST(FitTimes, HasTheStandardErrorsOfTheClosedForm) {
  // t = t₀ + τ(c) √s: a line in √s, whose errors are those of regression.
  Scene scene = led_along(uniform_scene(), Shape::Straight);
  scene.world.losses.rolling = 0.02;
  const auto times = timed(scene, 12, kSigma, time_on_incline);
  const double slope = std::atan2(scene.H, scene.L);
  const double by_c =
      0.5 * std::cos(slope) / (std::sin(slope) - 0.02 * std::cos(slope));
  double one = 0.0, first = 0.0, second = 0.0;
  for (const TimedPlace& row : times) {
    const double gain = by_c * row.t;
    one += 1.0;
    first += gain;
    second += gain * gain;
  }
  const double determinant = one * second - first * first;

  const Fit found =
      fit_on(scene, times, wanted({"scene.losses.rolling"}, true));

  ASSERT_EQ(found.estimates.size(), 2U);
  EXPECT_EQ(found.estimates[1].key, "offset");
  const double error_c = kSigma * std::sqrt(one / determinant);
  EXPECT_NEAR(found.estimates[0].error / error_c, 1.0, 1e-6);
  EXPECT_NEAR(
      found.estimates[1].error / (kSigma * std::sqrt(second / determinant)),
      1.0, 1e-6);
  EXPECT_NEAR(found.correlation[0][1], -first / std::sqrt(one * second), 1e-6);
  EXPECT_NEAR(found.transit_time_error, by_c * times.back().t * error_c,
              1e-6 * found.transit_time_error);
}

TEST(FitTimes, TellsLossAndInertiaApartOnAnArc) {
  Scene scene = led_along(uniform_scene(), Shape::CircularArc);
  scene.world.losses.rolling = 0.03;
  scene.body.k = 0.4;
  const auto times = timed(scene, 20, kSigma, time_on_arc);
  scene.world.losses.rolling = 0.0;
  scene.body.k = 0.5;

  const Fit found = fit_on(
      scene, times, wanted({"scene.losses.rolling", "scene.body.k"}, true));

  EXPECT_NEAR(found.estimates[0].value, 0.03, kExact);
  EXPECT_NEAR(found.estimates[1].value, 0.4, kExact);
  EXPECT_NEAR(found.estimates[2].value, 0.0, kExact);
}

/// From far off, where a first step leads to losses that stop the body.
TEST(FitTimes, GoesBackFromLossesThatStopTheBody) {
  Scene scene = led_along(uniform_scene(), Shape::Straight);
  scene.world.losses.rolling = 0.32;  // of 1/3 that hold it
  const auto times = timed(scene, 10, kSigma, time_on_incline);
  scene.world.losses.rolling = 0.0;

  const Fit found = fit_on(scene, times, wanted({"scene.losses.rolling"}));

  EXPECT_NEAR(found.estimates[0].value, 0.32, kExact);
}

TEST(FitTimes, TakesTheErrorsFromTheResidualsWithoutSigma) {
  Scene scene = led_along(uniform_scene(), Shape::Straight);
  auto times = timed(scene, 10, 1.0, time_on_incline);
  Normal noise(7);
  for (TimedPlace& row : times) row.t += kSigma * noise();
  Wanted asked = wanted({"scene.losses.rolling"});
  asked.sigma_known = false;

  const Fit without = fit_on(scene, times, asked);
  const double scatter = *without.scatter();
  for (TimedPlace& row : times) row.sigma = scatter;
  asked.sigma_known = true;
  const Fit with = fit_on(scene, times, asked);

  EXPECT_FALSE(without.reduced_chi_squared());
  EXPECT_NEAR(*with.reduced_chi_squared(), 1.0, 1e-9);
  EXPECT_NEAR(without.estimates[0].error / with.estimates[0].error, 1.0, 1e-6);
}

TEST(FitTimes, RefusesWhatTheyCannotTellApart) {
  // On an incline from rest t ~ √s whatever c and k are.
  const Scene scene = led_along(uniform_scene(), Shape::Straight);
  const auto times = timed(scene, 10, kSigma, time_on_incline);

  EXPECT_THAT(
      refusal(scene, times, wanted({"scene.losses.rolling", "scene.body.k"})),
      HasSubstr("these times cannot tell scene.losses.rolling and "
                "scene.body.k apart"));
  EXPECT_EQ(refusal(scene, times, wanted({"scene.body.k"}, true)), "");
  // One place tells one number.
  std::vector<TimedPlace> gate(3, times.back());
  EXPECT_THAT(refusal(scene, gate, wanted({"scene.body.k"}, true)),
              HasSubstr("cannot tell scene.body.k and offset apart"));
  gate.assign(3, {0.0, 0.0, 0.0, kSigma});
  EXPECT_EQ(refusal(scene, gate, wanted({"scene.body.k"})),
            "the times do not depend on scene.body.k");
}

TEST(FitTimes, RefusesFewerRowsThanNumbers) {
  const Scene scene = led_along(uniform_scene(), Shape::CircularArc);
  const auto times = timed(scene, 2, kSigma, time_on_arc);
  Wanted asked = wanted({"scene.losses.rolling", "scene.body.k"}, true);

  EXPECT_EQ(refusal(scene, times, asked),
            "2 rows cannot tell 3 numbers; expected 3 or more");
  asked.offset = false;
  EXPECT_EQ(refusal(scene, times, asked), "");
  asked.sigma_known = false;
  EXPECT_EQ(refusal(scene, times, asked),
            "2 rows cannot tell 2 numbers and, without sigma, their errors; "
            "expected 3 or more");
}

TEST(FitTimes, RefusesAStartThatDoesNotArrive) {
  Scene scene = led_along(uniform_scene(), Shape::Straight);
  const auto times = timed(scene, 5, kSigma, time_on_incline);
  scene.world.losses.rolling = 0.5;

  EXPECT_THAT(refusal(scene, times, wanted({"scene.losses.rolling"})),
              HasSubstr("with the values of the file the body does not arrive: "
                        "released from rest"));
}

/// They ask for more losses than the body would arrive with.
TEST(FitTimes, RefusesAnEdgeThatIsNoMinimum) {
  const Scene scene = led_along(uniform_scene(), Shape::Cycloid);
  std::array late{1.0, 1.5, 3.0};
  const double* next = late.data();
  const auto times =
      timed(scene, 3, kSigma, [&](const Scene&, double) { return *next++; });

  EXPECT_THAT(refusal(scene, times, wanted({"scene.losses.rolling"})),
              HasSubstr("χ² falls all the way to scene.losses.rolling = "));
}

}  // namespace
}  // namespace brachisto
