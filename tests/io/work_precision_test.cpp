// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What the section `work_precision` may contain.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/reading.hpp"
#include "io/sweep_reading.hpp"

namespace brachisto::io {
namespace {

/// A good problem whose second line is a section.
std::string with_work_precision(const std::string& section) {
  return kBead + "work_precision: " + section + "\n";
}

WorkPrecisionPlan work_precision_plan(const std::string& section) {
  return read(with_work_precision(section)).work_precision;
}

const std::string kExpectedMethods =
    "expected a list of rolling_time, adaptive, arc_length, extremal, fsolve, "
    "{rolling_time: [degrees]} and {fsolve: [arms]}";
const std::string kExpectedMeshes =
    "expected a list of integers from 2 to 1000000";
const std::string kExpectedDegrees =
    "expected a list of degrees, integers from 1 to 8";

TEST(WorkPrecisionSection, HasDefaults) {
  const WorkPrecisionPlan absent = read(kBead).work_precision;

  EXPECT_EQ(absent.meshes, (std::vector<int>{10, 20, 40, 80}));
  EXPECT_EQ(absent.repetitions, 5);
  EXPECT_EQ(absent.seconds_per_point, 60.0);
  EXPECT_EQ(absent.tolerances,
            (std::vector<double>{1e-4, 1e-6, 1e-8, 1e-10, 1e-12}));
  EXPECT_EQ(absent.methods.size(), 11U);
  EXPECT_EQ(work_precision_plan("").methods, absent.methods);
  EXPECT_EQ(work_precision_plan("{meshes: [7]}").methods, absent.methods);
}

TEST(WorkPrecisionSection, IsRead) {
  const WorkPrecisionPlan stated = work_precision_plan(
      "{methods: [extremal, {rolling_time: [2, 1+4]}, {fsolve: [lifted, "
      "rest]}], meshes: [40, 10], repetitions: 3, seconds_per_point: 1/2}");

  EXPECT_EQ(stated.methods, (std::vector<ComparedMethod>{
                                {.kind = ComparedMethod::Kind::Extremal},
                                rolling_time(2),
                                rolling_time(5),
                                discrete_system(DiscreteArm::Lifted),
                                discrete_system(DiscreteArm::Rest)}));
  EXPECT_EQ(stated.meshes, (std::vector<int>{10, 40})) << "ascending";
  EXPECT_EQ(stated.repetitions, 3);
  EXPECT_EQ(stated.seconds_per_point, 0.5);
}

TEST(WorkPrecisionSection, WordsAloneStandForTheirDefaults) {
  const WorkPrecisionPlan stated = work_precision_plan(
      "{methods: [rolling_time, adaptive, arc_length, extremal, fsolve]}");

  EXPECT_EQ(stated.methods, WorkPrecisionPlan{}.methods);
}

TEST(WorkPrecisionSection, CanBeOverridden) {
  const ProblemFile problem = read(kBead, {"work_precision.meshes=[5, 9]",
                                           "work_precision.methods=[extremal]",
                                           "work_precision.repetitions=1"});

  EXPECT_EQ(problem.work_precision.meshes, (std::vector<int>{5, 9}));
  EXPECT_EQ(problem.work_precision.methods.size(), 1U);
  EXPECT_EQ(problem.work_precision.repetitions, 1);
}

TEST(WorkPrecisionSection, UnknownKeysGetTheNearestKnown) {
  EXPECT_EQ(errors(with_work_precision("{method: [extremal]}")),
            "p.yaml:2:18: work_precision.method: misplaced key; it belongs in "
            "solver; allowed in work_precision: methods, meshes, tolerances, "
            "repetitions, seconds_per_point");
  EXPECT_EQ(errors(with_work_precision("{meshs: [10]}")),
            "p.yaml:2:18: work_precision.meshs: unknown key; allowed in "
            "work_precision: methods, meshes, tolerances, repetitions, "
            "seconds_per_point; did you mean meshes?");
  EXPECT_EQ(errors(with_work_precision("[extremal]")),
            "p.yaml:2:17: work_precision: a list was read; expected a map with "
            "the keys methods, meshes, tolerances, repetitions, "
            "seconds_per_point");
}

TEST(WorkPrecisionSection, MethodsAreWordsOrNamedLists) {
  EXPECT_EQ(errors(with_work_precision("{methods: extremal}")),
            "p.yaml:2:27: work_precision.methods: a single value was read; " +
                kExpectedMethods);
  EXPECT_EQ(errors(with_work_precision("{methods: []}")),
            "p.yaml:2:27: work_precision.methods: an empty list was read; " +
                kExpectedMethods);
  EXPECT_EQ(errors(with_work_precision("{methods: [extremal, arclength]}")),
            "p.yaml:2:38: work_precision.methods: \"arclength\" was read; " +
                kExpectedMethods + "; did you mean arc_length?");
  EXPECT_EQ(errors(with_work_precision("{methods: [[extremal]]}")),
            "p.yaml:2:28: work_precision.methods: a list was read; " +
                kExpectedMethods);
  EXPECT_EQ(errors(with_work_precision("{methods: [{extremal: [1]}]}")),
            "p.yaml:2:29: work_precision.methods: \"extremal\" was read; " +
                kExpectedMethods);
}

TEST(WorkPrecisionSection, DegreesAndArmsAreThoseThereAre) {
  EXPECT_EQ(errors(with_work_precision("{methods: [{rolling_time: [1, 9]}]}")),
            "p.yaml:2:47: work_precision.methods.rolling_time: \"9\" is not "
            "allowed; " +
                kExpectedDegrees);
  EXPECT_EQ(errors(with_work_precision("{methods: [{rolling_time: [1.5]}]}")),
            "p.yaml:2:44: work_precision.methods.rolling_time: \"1.5\" is not "
            "an integer; " +
                kExpectedDegrees);
  EXPECT_EQ(errors(with_work_precision("{methods: [{rolling_time: 5}]}")),
            "p.yaml:2:43: work_precision.methods.rolling_time: a single value "
            "was read; " +
                kExpectedDegrees);
  EXPECT_EQ(errors(with_work_precision("{methods: [{fsolve: [rest, newtn]}]}")),
            "p.yaml:2:44: work_precision.methods.fsolve: \"newtn\" was read; "
            "expected a list of rest, release, newton, lifted; did you mean "
            "newton?");
}

TEST(WorkPrecisionSection, NothingIsRunTwice) {
  EXPECT_EQ(errors(with_work_precision("{methods: [extremal, extremal]}")),
            "p.yaml:2:38: work_precision.methods: \"extremal\" is repeated; " +
                kExpectedMethods + ", each once");
  EXPECT_EQ(
      errors(with_work_precision("{methods: [rolling_time, rolling_time]}")),
      "p.yaml:2:42: work_precision.methods: \"rolling_time\" is repeated; " +
          kExpectedMethods + ", each once");
  EXPECT_EQ(
      errors(with_work_precision("{methods: [{rolling_time: [2, 3, 2]}]}")),
      "p.yaml:2:50: work_precision.methods.rolling_time: \"2\" is repeated; " +
          kExpectedDegrees + ", each once");
  EXPECT_EQ(errors(with_work_precision("{meshes: [10, 20, 10]}")),
            "p.yaml:2:35: work_precision.meshes: \"10\" is repeated; " +
                kExpectedMeshes + ", each once");
}

TEST(WorkPrecisionSection, MeshesAreIntegersWithinBounds) {
  EXPECT_EQ(errors(with_work_precision("{meshes: 10}")),
            "p.yaml:2:26: work_precision.meshes: a single value was read; " +
                kExpectedMeshes);
  EXPECT_EQ(errors(with_work_precision("{meshes: [10, 1]}")),
            "p.yaml:2:31: work_precision.meshes: \"1\" is not allowed; " +
                kExpectedMeshes);
  EXPECT_EQ(errors(with_work_precision("{meshes: [10.5]}")),
            "p.yaml:2:27: work_precision.meshes: \"10.5\" is not an integer; " +
                kExpectedMeshes);
  EXPECT_NE(
      errors(with_work_precision("{meshes: [ten]}")).find("is not a number"),
      std::string::npos);
}

TEST(WorkPrecisionSection, TolerancesAreNumbersWithinBoundsFromCoarseToFine) {
  EXPECT_EQ(work_precision_plan("{tolerances: [1e-9, 1e-3, 1e-5]}").tolerances,
            (std::vector<double>{1e-3, 1e-5, 1e-9}));
  const std::string expected = "expected a list of numbers from 1e-13 to 0.1";
  EXPECT_EQ(errors(with_work_precision("{tolerances: [1e-14]}")),
            "p.yaml:2:31: work_precision.tolerances: \"1e-14\" is not "
            "allowed; " +
                expected);
  EXPECT_EQ(errors(with_work_precision("{tolerances: [1e-4, 1e-4]}")),
            "p.yaml:2:37: work_precision.tolerances: \"1e-4\" is repeated; " +
                expected + ", each once");
}

TEST(WorkPrecisionSection, NumbersAreWithinBounds) {
  EXPECT_EQ(errors(with_work_precision("{repetitions: 0}")),
            "p.yaml:2:31: work_precision.repetitions: \"0\" is not allowed; "
            "expected an integer, from 1 to 1000");
  EXPECT_EQ(errors(with_work_precision("{seconds_per_point: 0}")),
            "p.yaml:2:37: work_precision.seconds_per_point: \"0\" is not "
            "allowed; expected a number in s, > 0");
}

TEST(WorkPrecisionSection, AllMistakesAreReportedAtOnce) {
  EXPECT_EQ(errors(with_work_precision("{meshes: [1, x], repetitions: many}"))
                .find("p.yaml:2:27"),
            0U);
  const std::string all =
      errors(with_work_precision("{meshes: [1, 0], repetitions: 0.5}"));
  EXPECT_NE(all.find("p.yaml:2:30"), std::string::npos) << all;
  EXPECT_NE(all.find("work_precision.repetitions"), std::string::npos) << all;
}

TEST(WorkPrecisionSection, IsNoPartOfTheProblemThatASweepMayVary) {
  EXPECT_NE(sweep_errors({"work_precision.repetitions: [1, 2]"}), "");
}

}  // namespace
}  // namespace brachisto::io
