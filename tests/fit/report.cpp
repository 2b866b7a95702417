// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "fit/fit_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "brachisto/io/problem_file.hpp"
#include "fit/synthetic.hpp"
#include "io/yaml_writer.hpp"

namespace brachisto {
namespace {

using namespace testing;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr const char* kProblem = R"(# An incline.
scene:
  body: {shape: cylinder, radius: 1/3, k: 1/2}
  finish: {L: 3, H: 1}
  contact: centre
  path: {curve: centre, shape: straight}
)";

TEST(FittedProblem, IsTheFileWithOtherValues) {
  const std::string text = io::problem_yaml(
      kProblem, "dir/p.yaml", {"scene.losses.rolling=0.0125"}, "out");
  const io::ProblemFile before = io::read_problem_text(kProblem, "p.yaml");
  const io::ProblemFile after = io::read_problem_text(text, "fit.yaml");

  EXPECT_EQ(after.scene.world.losses.rolling, 0.0125);
  EXPECT_EQ(after.scene.body.radius, before.scene.body.radius);
  EXPECT_EQ(after.scene.body.k, before.scene.body.k);
  EXPECT_EQ(after.scene.path->shape, before.scene.path->shape);
  EXPECT_THAT(text, HasSubstr("radius: 1/3"));
}

TEST(FittedProblem, FindsItsPointsFromWhereItStands) {
  const std::string text =
      io::problem_yaml("scene:\n  path: {shape: points, file: track.csv}\n",
                       "dir/p.yaml", {}, "out/of");

  EXPECT_THAT(text, HasSubstr("file: ../../dir/track.csv"));
}

fit::Fit fit_with(double c, double sigma) {
  Scene scene = led_along(uniform_scene(), GivenPath::Shape::Straight);
  scene.world.losses.rolling = c;
  auto times = timed(scene, 10, sigma, time_on_incline);
  times[4].t += 1e-3;
  scene.world.losses.rolling = 0.0;
  return fit::fit_times(
      scene, centre_curve(scene), times,
      {{fit::find_parameter("scene.losses.rolling")}, false, true});
}

TEST(FitReport, WritesValuesThatASceneMayHave) {
  EXPECT_THAT(fit::doubts(fit_with(0.01, 1e-3)), IsEmpty());

  const fit::Fit gains = fit_with(-0.01, 1e-3);

  EXPECT_LT(gains.estimates[0].value, -0.005);
  EXPECT_THAT(fit::overrides_of(gains), ElementsAre("scene.losses.rolling=0"));
  EXPECT_THAT(fit::doubts(gains), ElementsAre(HasSubstr("is beyond 0, by")));
}

TEST(FitReport, DoubtsErrorsThatAreTooSmall) {
  EXPECT_THAT(fit::doubts(fit_with(0.01, 1e-5)),
              ElementsAre(HasSubstr("further from the model than sigma")));
}

TEST(FitReport, TellsTheDigitsThatErrorsLeave) {
  const std::string text = fit::summary(fit_with(0.01, 1e-3));

  EXPECT_THAT(text, HasSubstr("scene.losses.rolling"));
  EXPECT_THAT(text, HasSubstr("10 rows, χ²/ν = "));
  EXPECT_THAT(text, HasSubstr(" ± "));
}

}  // namespace
}  // namespace brachisto
