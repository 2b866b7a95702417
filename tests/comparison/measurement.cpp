// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What a run says of itself, read from its line.

#include "comparison/measurement.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "comparison/comparison.hpp"

namespace brachisto::comparison {
namespace {

using Outcome = Measurement::Outcome;

/// A line of `measure` with the parts that differ between tests.
std::string line(const std::string& tau, const std::string& more,
                 const std::string& discrete = "null") {
  return R"({"cpu": [0.02, 0.01, 0.04], "tau": )" + tau +
         R"(, "unknowns": 127, "result": {"iterations": 17, "newton_steps": 9,
            "estimated_error": 1e-11, "discrete_system": )" +
         discrete + ", " + more + "}}";
}

const std::string kVerified =
    R"("status": "solved", "verified": true, "message": "")";

TEST(Measurement, OfASolution) {
  const Measurement run = parse_measurement(line("5.09", kVerified));

  EXPECT_EQ(run.outcome, Outcome::Solved);
  EXPECT_TRUE(run.verified);
  EXPECT_EQ(run.tau, 5.09);
  EXPECT_EQ(run.cpu, (std::vector<double>{0.02, 0.01, 0.04}));
  EXPECT_EQ(run.unknowns, 127);
  EXPECT_EQ(run.iterations, 17);
  EXPECT_EQ(run.newton_steps, 9);
  EXPECT_FALSE(run.evaluations);
  EXPECT_EQ(run.estimated_error, 1e-11);
  EXPECT_EQ(run.cause, "");
}

TEST(Measurement, HasTheTimeOnTheMeshWithoutTheStart) {
  Measurement run;
  run.cpu = {5.0, 3.0};
  EXPECT_TRUE(run.on_mesh().empty()) << "not known";

  run.start = {1.0, 0.5};

  EXPECT_EQ(run.on_mesh(), (std::vector<double>{4.0, 2.5}));
}

TEST(Measurement, RefusedHasTheReasonInWords) {
  EXPECT_EQ(refusal_in(R"({"status": "bad_input", "errors": [
                 {"file": "--set a=b", "line": 0, "key": "a",
                  "message": "b is not allowed in air"},
                 {"file": "x.yaml", "line": 3, "key": "c", "message": "nor c"}
                 ]})",
                       "--set a=b: a: b is not allowed in air\n"),
            "b is not allowed in air; nor c");
  EXPECT_EQ(refusal_in("", "out of order\nand more"), "out of order");
}

TEST(Measurement, OfTheDiscreteSystemCountsItsEvaluations) {
  const Measurement run = parse_measurement(
      line("5.2",
           R"("status": "solved", "verified": false, "message": "",
              "not_verified_because": ["one", "two"])",
           R"({"evaluations": 4321})"));

  EXPECT_EQ(run.outcome, Outcome::Solved);
  EXPECT_FALSE(run.verified);
  EXPECT_EQ(run.evaluations, 4321);
  EXPECT_FALSE(run.newton_steps) << "they are the extremal's beside it";
  EXPECT_EQ(run.cause, "one; two");
}

TEST(Measurement, KeepsTheReasonOfAFailure) {
  const Measurement failed =
      parse_measurement(line("null",
                             R"("status": "not_converged", "verified": false,
              "message": "lost its way")"));
  const Measurement late = parse_measurement(line(
      "null",
      R"("status": "time_limit", "verified": false, "message": "too long")"));

  EXPECT_EQ(failed.outcome, Outcome::Failed);
  EXPECT_EQ(failed.cause, "lost its way");
  EXPECT_EQ(late.outcome, Outcome::Limit);
}

TEST(Measurement, BelievesNothingButACompleteResult) {
  const std::string whole = line("5.09", kVerified);

  for (const std::string& text :
       {std::string(), std::string("{}"), whole.substr(0, whole.size() / 2)}) {
    EXPECT_EQ(parse_measurement(text).outcome, Outcome::Crashed) << text;
  }
}

const Referee kReferee{{.kind = ComparedMethod::Kind::Extremal}, {}, "it"};

TEST(Reference, IsAVerifiedAnswerWithAnErrorBar) {
  Measurement extremal = parse_measurement(line("5.0", kVerified));
  ASSERT_TRUE(kReferee.reference_in(extremal));
  EXPECT_EQ(kReferee.reference_in(extremal)->error, 1e-11);

  extremal.verified = false;
  EXPECT_FALSE(kReferee.reference_in(extremal));
  EXPECT_FALSE(kReferee.reference_in(Measurement{}));
}

TEST(Reference, ErrorsAreRelativeAndWithoutSign) {
  Measurement run;
  run.tau = 4.5;
  EXPECT_EQ(error_of(run, {4.0, 0.0}), 0.125);
  run.tau = 3.5;
  EXPECT_EQ(error_of(run, {4.0, 0.0}), 0.125);
}

TEST(Verdict, TellsFailuresWithTheirCause) {
  ComparisonRow row;
  row.run.outcome = Outcome::Limit;
  row.run.cause = "killed after 60 s";
  EXPECT_EQ(verdict(row), "limit: killed after 60 s");

  row.run.outcome = Outcome::Solved;
  row.run.cause = "agreement";
  EXPECT_EQ(verdict(row), "solved, not verified: agreement");
  row.method.kind = ComparedMethod::Kind::DiscreteSystem;
  EXPECT_EQ(verdict(row), "solved, first-order conditions");
  row.run.verified = true;
  EXPECT_EQ(verdict(row), "verified");
}

TEST(MethodComparison, HasNoDigitBeyondTheErrorOfTheReference) {
  MethodComparison found;
  found.reference = Reference{5.0370514729, 3.4e-10, {}};  // 2e-9 in τ
  Measurement run;
  run.outcome = Measurement::Outcome::Solved;
  run.tau = found.reference->tau;
  found.rows = {{"extremal", kReferee.method, run, 0.0}};

  const std::string text = summary(found);

  EXPECT_NE(text.find("  5.037051473  "), std::string::npos) << text;
}

}  // namespace
}  // namespace brachisto::comparison
