// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/report/result.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "report/solutions.hpp"

namespace brachisto {
namespace {

using report::summary;

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Summary, OfAVerifiedSolutionHasTheAnswer) {
  const std::string text = summary(testing::uniform_solution());

  EXPECT_TRUE(says(text, "5.11510065")) << text;
  EXPECT_TRUE(says(text, "; feasible")) << text;
}

TEST(Summary, HasNoDigitBeyondTheError) {
  Solution solution = testing::off_centred_solution();
  solution.estimated_error = 1e-6;

  const std::string text = summary(solution);

  // The reference value is 5.0894, known to more digits than these.
  const double tau = testing::reference("theta_-30").tau;
  EXPECT_TRUE(says(text, fmt::format("= {:.6f}(6)\n", tau))) << text;
}

TEST(Summary, CountsTheChecksAndSaysHowFarTheyAgree) {
  const Solution& solution = testing::off_centred_solution();
  const std::size_t checks = solution.certificate.checks.size();

  const std::string text = summary(solution);

  EXPECT_TRUE(says(text, fmt::format("verified: {0} of {0} checks", checks)))
      << text;
  EXPECT_TRUE(says(text, " agree to ")) << text;
  EXPECT_TRUE(says(text, "from the cycloid in ")) << text;
}

TEST(Summary, SaysWhatTheTrackIs) {
  Solution solution = testing::off_centred_solution();
  EXPECT_TRUE(says(summary(solution),
                   "smooth-contact extremal (docs/theory.md, section 3)"))
      << summary(solution);

  solution.options.use<Collocation>().search = Search::Global;
  solution.branches.resize(3);

  // Those that are no minimum are in the list, feasible or not.
  EXPECT_TRUE(
      says(summary(solution),
           "fastest verified and feasible of the 3 smooth contacts found"))
      << summary(solution);
}

TEST(Summary, SaysWhatTheTrackIsUnderLimits) {
  Solution solution = testing::limited_solution();
  const auto asked = [&](Contact contact, const std::string& words) {
    solution.scene.contact = contact;
    EXPECT_TRUE(says(summary(solution), words)) << summary(solution);
  };

  asked(Contact::Smooth,
        "the smooth-contact extremal under limits, a root and no minimum over "
        "the slopes there (docs/theory.md, section 11)");
  asked(Contact::Centre,
        "the extremal between fixed ends of the centre's path, under limits");
  asked(Contact::Optimal,
        "the fastest track under these limits, its slopes at A and B free");
  solution.scene.end_slope = -0.5;  // 28.6479 degrees
  asked(Contact::EndSlope,
        "the fastest track with the end slope given, 28.6479° up at B");
  asked(Contact::EndSlope, "g = 9.81 m/s², end slope −28.6479°");
  solution.scene.body = Body::bead();
  asked(Contact::Smooth, "the fastest wire from A to B under limits");
}

TEST(Summary, SaysWhoFoundTheArcsThatWereShotOver) {
  Solution solution = testing::limited_solution();
  const std::string words = "of Ipopt to find which arcs there are";
  EXPECT_FALSE(says(summary(solution), words)) << summary(solution);

  solution.options.method = Shooting{};

  EXPECT_TRUE(says(summary(solution), words)) << summary(solution);
}

TEST(Summary, HasATableOfLimits) {
  const Solution& solution = testing::limited_solution();
  const auto place = [&](double sigma) {
    return fmt::format("{:.4g}", solution.motion()->at(sigma).motion.contact.x);
  };

  const std::string text = summary(solution);

  EXPECT_THAT(text, ::testing::ContainsRegex(
                        "limits +limit +bound +of the time +least slack "
                        "+dτ/d\\(bound\\) +contacts held +active at x_b"));
  EXPECT_THAT(text, ::testing::ContainsRegex(fmt::format(
                        "friction +0.5 +38 % +0 +-0.0625 +-0.1562 +{} to {}, "
                        "{} to {}\n",
                        place(0.125), place(0.25), place(0.5), place(0.75))));
  EXPECT_THAT(text, ::testing::ContainsRegex("normal_force.max +5 +6 % +0 +— +"
                                             "-0.03125 +"));
  EXPECT_THAT(text, ::testing::ContainsRegex("clear_of.half_plane +— +0 % "
                                             "+0.7188 +0 +0 +nowhere\n"));
  EXPECT_FALSE(says(summary(testing::off_centred_solution()), "limits"));
}

TEST(Summary, TellsWhatSmallChangesDo) {
  const std::string text = summary(testing::differentiated_solution());

  // dT/dη_m = 1/4 s over r = 1/3 m; dT/dθ_m = 1/2 s over 57.3°; L, H in metres.
  for (const char* row :
       {"sensitivities +change +T \\[ms\\] +contacts held +dτ/d\\(number\\) "
        "+contacts held\n",
        "1 mm more offset \\(η_m\\) +\\+0.75 +\\+0.375 +1 +0.5\n",
        "1° more θ_m +\\+8.73 +\\+4.36 +2 +1\n",
        "1 mm more radius \\(r\\) +\\+1 +\\+0.5 +4 +2\n",
        "1 mm more H +\\+1.5 +\\+0.75 +6 +3\n"}) {
    EXPECT_THAT(text, ::testing::ContainsRegex(row));
  }
  EXPECT_FALSE(says(text, "more k")) << text;
  EXPECT_FALSE(says(summary(testing::off_centred_solution()), "sensitivities"));
}

// A cross-check and other contacts are refused with limits.
TEST(Summary, AdvisesASearchUnderLimitsAndNothingThatIsRefused) {
  Solution solution = testing::limited_solution();
  EXPECT_FALSE(says(summary(solution), "--certify")) << summary(solution);
  solution.diagnostics->min_fold_margin = {-0.5, 1.25};
  solution.diagnostics->folds_back = 0.01;

  const std::string text = summary(solution);

  EXPECT_TRUE(says(text, "INFEASIBLE")) << text;
  EXPECT_TRUE(says(text, "search: global")) << text;
  EXPECT_FALSE(says(text, "guess:")) << text;
  EXPECT_FALSE(says(text, "arc_length")) << text;
}

TEST(Summary, OfAnUnverifiedSolutionHasTheFailedCheckAndNoAnswer) {
  const std::string text = summary(testing::unverified_solution());

  EXPECT_TRUE(says(text, "NOT VERIFIED")) << text;
  EXPECT_TRUE(says(text, "agreement")) << text;
  EXPECT_FALSE(says(text, "5.09")) << text;
}

TEST(Summary, OfAnUnsolvedSceneHasTheReason) {
  const std::string text = summary(testing::impossible_solution());

  EXPECT_TRUE(says(text, "NOT SOLVED")) << text;
  EXPECT_TRUE(says(text, "inside the")) << text;
}

TEST(Summary, OfTheDiscreteSystemHasItsErrorAndNoAnswer) {
  const std::string text = summary(testing::discrete_solution());

  EXPECT_TRUE(says(text, "NOT VERIFIED")) << text;
  EXPECT_TRUE(says(text, "discrete system")) << text;
  EXPECT_TRUE(says(text, "discretisation is 0.0066")) << text;
  EXPECT_FALSE(says(text, "τ = T √(2g/H)")) << text;
}

TEST(Summary, OfTheDiscreteSystemHasNoDigitBeyondItsError) {
  Solution solution = testing::discrete_solution();
  ASSERT_TRUE(solution.extremal && solution.extremal->solved);
  // An error of 0.0066 leaves two places behind the point, and of an angle of
  // as many radians, 0.4°, one.
  const std::string text = summary(solution);

  EXPECT_THAT(text, ::testing::ContainsRegex("its τ = [0-9]\\.[0-9]{2}, "
                                             "S = [0-9]\\.[0-9]{2} m, "
                                             "[0-9]+\\.[0-9]° down at the "))
      << text;
}

TEST(Summary, TellsOfFolds) {
  Solution solution = testing::off_centred_solution();
  EXPECT_FALSE(says(summary(solution), "fold of"));
  EXPECT_FALSE(says(summary(solution), "folds of"));

  solution.folds = {0.75, 0.4};

  EXPECT_TRUE(says(summary(solution), "beyond 2 folds of that branch"))
      << summary(solution);
  EXPECT_TRUE(says(summary(solution), "0.750000")) << summary(solution);
}

TEST(Summary, ListsTheBranchesOfASearch) {
  Solution solution = testing::off_centred_solution();
  Branch principal;
  principal.tau = 5.25;
  principal.estimated_error = 1e-10;
  principal.principal = principal.verified = principal.feasible = true;
  principal.minimum = true;
  Branch other;
  other.tau = 5.5;
  solution.branches = {principal, other};

  const std::string text = summary(solution);

  EXPECT_TRUE(says(text, "τ = 5.2500000000,")) << text;
  EXPECT_TRUE(says(text, "principal, feasible")) << text;
  EXPECT_TRUE(says(text, "NOT VERIFIED, not a minimum, INFEASIBLE")) << text;
}

TEST(Summary, SaysWhyAFasterBranchIsNotTheAnswer) {
  Solution solution = testing::off_centred_solution();
  const double answer = solution.motion()->tau();
  Branch saddle, slower;
  saddle.tau = answer - 0.125;
  saddle.remarks = {"no answer: it is stationary, but no minimum"};
  slower.tau = answer + 0.125;
  slower.remarks = {"the body would lift off"};
  solution.branches = {saddle, slower};

  const std::string text = summary(solution);

  EXPECT_TRUE(says(text, "no answer: it is stationary")) << text;
  EXPECT_FALSE(says(text, "lift off")) << text;
}

TEST(Summary, SaysWhatToTryWhereTheExtremalIsASaddle) {
  Solution solution = testing::off_centred_solution();
  EXPECT_FALSE(says(summary(solution), "search: global")) << summary(solution);
  solution.certificate.checks.clear();
  solution.certificate.add("second_order", 1.0, 0.0, "");

  const std::string text = summary(solution);

  EXPECT_TRUE(says(text, "NOT VERIFIED")) << text;
  EXPECT_TRUE(says(text, "search: global")) << text;
}

TEST(Summary, HasTheSecondOpinion) {
  Solution solution = testing::off_centred_solution();
  CrossCheck opinion;
  opinion.solved = true;
  opinion.tau = 5.125;
  solution.extremal = opinion;
  EXPECT_TRUE(says(summary(solution), "5.125 by multiple shooting"));

  solution.extremal->solved = false;
  solution.extremal->message = "it did not converge";

  EXPECT_TRUE(says(summary(solution), "none: it did not converge"));
}

TEST(Summary, SaysThatTheLeastForceIsALimit) {
  EXPECT_TRUE(says(summary(testing::off_centred_solution()),
                   "from 0, its limit at the start, to "));
}

TEST(Summary, TellsWhyABodyCouldNotRun) {
  Solution solution = testing::uniform_solution();
  solution.diagnostics->min_normal_force = {-0.5, 1.25};

  const std::string text = summary(solution);

  EXPECT_TRUE(says(text, "INFEASIBLE")) << text;
  EXPECT_TRUE(says(text, "lift off")) << text;
}

TEST(Summary, SaysWhatTheMeshLeavesOpen) {
  Solution solution = testing::uniform_solution();
  solution.diagnostics->min_normal_force = {-0.5, 1.25};
  solution.diagnostics->normal_force_after_rise = {-0.5, 1.25};
  solution.diagnostics->normal_force_error = 0.75;

  const std::string text = summary(solution);

  EXPECT_TRUE(solution.feasible());
  EXPECT_TRUE(says(text, "feasible within the error of this mesh")) << text;
  EXPECT_TRUE(says(text, "the error of this mesh is 0.8 m g")) << text;
  EXPECT_TRUE(says(text, "a finer mesh")) << text;

  // The same from above, where there would be no reason for either.
  solution.diagnostics->min_normal_force = {0.0, 0.0, true};
  solution.diagnostics->normal_force_after_rise = {0.5, 1.25};
  EXPECT_TRUE(says(summary(solution), "within the error of this mesh"));

  solution.diagnostics->normal_force_error = 0.25;
  EXPECT_TRUE(solution.undecided_because().empty());
  solution.diagnostics->min_normal_force = {-0.5, 1.25};
  EXPECT_FALSE(solution.feasible()) << "by more than the error";
}

TEST(Summary, AdvisesNoSmallerOffsetOfABodyThatHasNone) {
  Solution solution = testing::uniform_solution();
  solution.diagnostics->min_normal_force = {-0.5, 1.25};
  EXPECT_FALSE(says(summary(solution), "eta_m"));

  solution.scene.body.eta_m = 0.5;
  EXPECT_TRUE(says(summary(solution), "a smaller eta_m"));
}

TEST(Summary, TellsNoForceThatIsRoundingAlone) {
  Solution solution = testing::uniform_solution();
  solution.diagnostics->min_normal_force = {-3.812e-12, 1.25};

  EXPECT_TRUE(says(summary(solution), "contact force    from 0 to "));
}

TEST(Summary, OfADesignWithoutGripSaysOnlyThatItIsInfeasible) {
  const Solution solution = testing::uniform_solution();
  DesignAnswer design;
  design.plan.max_grip = MaxGrip{0.3, 0.05};
  DesignMinimum& minimum = design.minima.emplace_back();
  minimum.stationary = minimum.verified = true;

  const std::string text = summary(solution, &design);

  EXPECT_TRUE(says(text, "; INFEASIBLE for want of the grip")) << text;
  EXPECT_FALSE(says(text, " feasible")) << text;

  minimum.feasible = true;
  design.best = minimum;
  EXPECT_TRUE(says(summary(solution, &design), "; feasible\n"));
}

TEST(Summary, TellsTheLeastGrip) {
  Solution solution = testing::uniform_solution();
  auto& grip = solution.diagnostics->least_grip;
  grip[1].mu = 0.62001;
  grip[2].mu = 0.45;

  EXPECT_TRUE(says(summary(solution),
                   "least μ 0.621 from 1 % of the time on, 0.45 from 5 % on; "
                   "more than any at the start itself"));

  for (LeastGrip& one : grip) one.mu = 0.3;
  EXPECT_TRUE(says(summary(solution), "least μ 0.3 from the start on\n"));
  // Friction of 0.25, 0.4 and 0.025 that is kept to 1e-8 is not more than that.
  for (const auto& [mu, words] :
       {std::pair{0.25000000118, "0.25"}, std::pair{0.4 + 9e-9, "0.4"},
        std::pair{0.025 + 9e-9, "0.025"}, std::pair{0.25 + 1e-7, "0.251"},
        std::pair{2.5, "2.5"}, std::pair{5e-9, "0"}}) {
    for (LeastGrip& one : grip) one.mu = mu;
    EXPECT_TRUE(says(summary(solution), fmt::format("least μ {} from the start "
                                                    "on\n",
                                                    words)))
        << mu;
  }
  for (LeastGrip& one : grip) one.mu = INFINITY;
  EXPECT_TRUE(says(summary(solution),
                   "least μ more than any from 1 % of the time on\n"));
}

}  // namespace
}  // namespace brachisto
