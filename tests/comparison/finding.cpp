// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The result in one sentence, from measurements that were made up.

#include "comparison/finding.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "comparison/work_precision.hpp"

namespace brachisto::comparison {
namespace {

using Kind = ComparedMethod::Kind;
using Outcome = Measurement::Outcome;

Measurement solved(double seconds) {
  Measurement run;
  run.outcome = Outcome::Solved;
  run.cpu = {seconds, 0.5 * seconds, 2.0 * seconds};
  return run;
}

const Party kProgram{
    "the program",
    {{"coarse", 0.001, 1e-4}, {"good", 0.0041, 7e-7}, {"fine", 0.012, 1e-9}}};
const Party kFsolve{"fsolve", {{"8", 0.1, 1e-3}, {"400", 2.0, 8.8e-5}}};
const Party kRefused{"arc_length", {}, true};

TEST(Finding, IsTheQuickestTrialToTheError) {
  EXPECT_EQ(in_a_sentence({kProgram}),
            "To an error of 1e−6 the program needs 4.1 ms.");
}

TEST(Finding, NamesWhoDoesNotReachTheError) {
  EXPECT_EQ(in_a_sentence({kProgram, kFsolve}),
            "To an error of 1e−6 the program needs 4.1 ms; fsolve does not "
            "reach it (at best 8.8e−5).");
}

TEST(Finding, NamesWhoRefusesTheScene) {
  EXPECT_EQ(in_a_sentence({kProgram, kRefused}),
            "To an error of 1e−6 the program needs 4.1 ms; arc_length does not "
            "take such a scene.");
}

TEST(Finding, NamesWhoFindsNoAnswer) {
  EXPECT_EQ(in_a_sentence({kProgram, {"arc_length", {}}, {"fsolve", {}}}),
            "To an error of 1e−6 the program needs 4.1 ms; arc_length and "
            "fsolve find no answer.");
}

TEST(Finding, ListsAllWhoReachTheError) {
  const Party extremal{"the extremal method", {{"", 0.0085, 1e-13}}};
  const Party pieces{"arc_length", {{"400", 1.25, 9e-7}}};

  EXPECT_EQ(in_a_sentence({kProgram, extremal, pieces}),
            "To an error of 1e−6 the program needs 4.1 ms, the extremal method "
            "8.5 ms and arc_length 1.2 s.");
}

TEST(Finding, OfNobodyWhoReachesTheErrorIsWhoComesNearest) {
  EXPECT_EQ(
      in_a_sentence({kProgram, kFsolve}, 1e-12),
      "No method reaches an error of 1e−12: the program comes nearest, to "
      "1e−9 in 12 ms.");
  EXPECT_EQ(in_a_sentence({{"the program", {}}}),
            "The program finds no answer.");
  EXPECT_EQ(in_a_sentence({}), "Nothing was measured.");
}

WorkPrecision measured() {
  WorkPrecision found{{}, {}, {.tau = 5.0, .error = 1e-13}};
  const ComparedMethod rest = discrete_system(DiscreteArm::Rest);
  Measurement failed;
  failed.outcome = Outcome::Failed;
  found.lines.push_back({rest, {{{.mesh = 8}, failed, {}, {}}}});
  found.lines.push_back({rolling_time(2),
                         {{{.mesh = 8}, solved(0.002), 1e-5, {}},
                          {{.mesh = 16}, solved(0.004), 6e-7, {}}}});
  found.lines.push_back(
      {rolling_time(5), {{{.mesh = 4}, solved(0.003), 0.0, {}}}});
  found.left_out.push_back({{.kind = Kind::ArcLength}, "it takes no limits"});
  return found;
}

TEST(Finding, TakesAllDegreesForTheProgramAndMediansForTimes) {
  const std::vector<Party> parties = parties_of(measured());

  ASSERT_EQ(parties.size(), 3U);
  EXPECT_EQ(parties[0].name, "the program") << "the program is the first";
  ASSERT_EQ(parties[0].trials.size(), 3U);
  EXPECT_EQ(parties[0].trials[2].error, 1e-13) << "that of the reference";
  EXPECT_EQ(in_a_sentence(parties),
            "To an error of 1e−6 the program needs 3 ms; fsolve finds no "
            "answer; arc_length does not take such a scene.");
}

TEST(Finding, HasTimesInMillisecondsBelowASecond) {
  EXPECT_EQ(duration(0.00414), "4.1 ms");
  EXPECT_EQ(duration(0.125), "125 ms");
  EXPECT_EQ(duration(12.4), "12 s");
}

}  // namespace
}  // namespace brachisto::comparison
