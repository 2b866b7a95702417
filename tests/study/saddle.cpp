// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// A principal extremal that is a saddle between its fixed ends (scene 418 of
// docs/robustness.md) is refused, and whoever asked learns what to try.

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "brachisto/study/solve.hpp"

namespace brachisto {
namespace {

Scene scene_of_a_saddle() {
  Scene scene;
  scene.body = Body::cylinder(0.38522, 0.63445, -1.2318, 0.50532);
  scene.L = 2.9236;
  scene.H = 1.0;
  return scene;
}

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

struct AdvisedWay {
  const char* name;
  std::function<void(SolveOptions&)> choose;
  const char* advice;
};

const std::vector<AdvisedWay>& ways() {
  static const std::vector<AdvisedWay> all = {
      {"ipopt", [](SolveOptions&) {}, "search: global looks"},
      {"newton_kkt",
       [](SolveOptions& o) {
         o.use<Collocation>().solver = ProgramSolver::NewtonKkt;
       },
       "search: global looks"},
      {"extremal", [](SolveOptions& o) { o.method = Shooting{}; },
       "search: global with method: ipopt looks"},
      {"another start",
       [](SolveOptions& o) { o.use<Collocation>().guess = Guess::Straight; },
       "search: global looks"},
      {"straight pieces",
       [](SolveOptions& o) {
         o.use<Collocation>().discretisation.formulation =
             Formulation::ArcLength;
         o.use<Collocation>().discretisation.elements = 200;
       },
       "search: global with formulation: rolling_time looks"},
      {"another check fails too",
       [](SolveOptions& o) {
         o.use<Collocation>().discretisation.tolerance = 1e-12;
         o.use<Collocation>().discretisation.degree = 5;
         o.use<Collocation>().discretisation.elements = 12;
       },
       "search: global looks"}};
  return all;
}

TEST(Saddle, IsRefusedWithAdviceThatItsOptionsAllow) {
  for (const AdvisedWay& way : ways()) {
    SolveOptions options;
    way.choose(options);

    const Solution solution = solve(scene_of_a_saddle(), options);

    EXPECT_FALSE(solution.verified()) << way.name;
    ASSERT_NE(solution.certificate.find("second_order"), nullptr) << way.name;
    EXPECT_FALSE(solution.certificate.find("second_order")->passed) << way.name;
    EXPECT_TRUE(says(solution.advice(), way.advice))
        << way.name << ": " << solution.advice();
    EXPECT_TRUE(says(solution.message, solution.advice()))
        << way.name << ": " << solution.message;
  }
}

TEST(Saddle, TheAdviceIsGood) {
  SolveOptions options;
  options.use<Collocation>().search = Search::Global;

  const Solution solution = solve(scene_of_a_saddle(), options);

  ASSERT_TRUE(solution.verified()) << solution.message;
  EXPECT_EQ(solution.advice(), "");
  const double answer = solution.motion()->tau();
  int saddles = 0;
  for (const Branch& branch : solution.branches) {
    if (branch.minimum) continue;
    ++saddles;
    ASSERT_FALSE(branch.remarks.empty());
    EXPECT_TRUE(says(branch.remarks.back(), "no answer: it is stationary"))
        << branch.remarks.back();
  }
  EXPECT_GE(saddles, 1);
  EXPECT_GT(answer, 0.0);
}

TEST(Saddle, IsAReasonToSearchWhereThereAreOthers) {
  const auto advice = [](const Scene& scene) {
    Solution solution;
    solution.scene = scene;
    solution.certificate.add("second_order", 1.0, 0.0, "");
    return solution.advice();
  };
  Scene scene = scene_of_a_saddle();
  EXPECT_NE(advice(scene), "");
  scene.contact = Contact::Centre;
  EXPECT_NE(advice(scene), "");
  scene.world.start_speed = 1.0;
  EXPECT_EQ(advice(scene), "");
  scene.limits.floor = 5.0;
  EXPECT_NE(advice(scene), "");
  scene.limits = {};
  scene.world = {};
  scene.body.eta_m = 0.0;
  EXPECT_EQ(advice(scene), "");
}

TEST(Saddle, IsNotAssumedWhereAMinimumIsFound) {
  Scene scene = scene_of_a_saddle();
  scene.body = Body::cylinder(1.0 / 3.0, 2.0 / 3.0, 0.0, 0.5);
  SolveOptions options;
  Discretisation& mesh = options.use<Collocation>().discretisation;
  mesh.tolerance = 1e-12;
  mesh.degree = 2;
  mesh.elements = 8;

  const Solution solution = solve(scene, options);

  EXPECT_FALSE(solution.verified());
  EXPECT_EQ(solution.advice(), "");
}

}  // namespace
}  // namespace brachisto
