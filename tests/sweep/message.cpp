// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "sweep/message.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "brachisto/report/result.hpp"
#include "brachisto/study/solve.hpp"
#include "sweep/outcome.hpp"

namespace brachisto::sweep {
namespace {

Scene off_centred(double theta_m) {
  Scene scene;
  scene.body.shape = Shape::Cylinder;
  scene.body.radius = 1.0 / 3.0;
  scene.body.eta_m = 2.0 / 3.0;
  scene.body.theta_m = theta_m;
  scene.body.k = 0.5;
  scene.L = 3.0;
  scene.H = 1.0;
  return scene;
}

const Solution& solved() {
  static const Solution solution = solve(off_centred(0.0));
  return solution;
}

TEST(State, SurvivesBitForBit) {
  ASSERT_TRUE(solved().as_neighbour());
  const Neighbour before = *solved().as_neighbour();

  const Neighbour after = neighbour_from_state(to_state(before), before.scene);

  EXPECT_EQ(after.mesh.degree, before.mesh.degree);
  EXPECT_EQ(after.mesh.boundaries, before.mesh.boundaries);
  EXPECT_EQ(after.point.x, before.point.x);
  EXPECT_EQ(after.point.lambda, before.point.lambda);
  EXPECT_EQ(after.phi, before.phi);
}

TEST(State, LeadsToTheSameResultAsTheSolutionItself) {
  const Scene next = off_centred(0.05);
  const Neighbour before = *solved().as_neighbour();
  const Neighbour after = neighbour_from_state(to_state(before), before.scene);

  const Solution direct = solve(next, {}, {.neighbour = &before});
  const Solution resumed = solve(next, {}, {.neighbour = &after});

  ASSERT_TRUE(direct.verified());
  EXPECT_EQ(direct.motion()->transit_time(), resumed.motion()->transit_time());
  EXPECT_EQ(direct.as_neighbour()->point.x, resumed.as_neighbour()->point.x);
}

TEST(State, UnderLimitsLeadsToTheSameResultAsTheSolutionItself) {
  Scene scene = off_centred(0.0);
  scene.limits.friction = 0.5;
  const Neighbour before = *solve(scene).as_neighbour();
  ASSERT_FALSE(before.arcs.empty());
  const Neighbour after = neighbour_from_state(to_state(before), before.scene);
  scene.limits.friction = 0.51;

  const Solution direct = solve(scene, {}, {.neighbour = &before});
  const Solution resumed = solve(scene, {}, {.neighbour = &after});

  ASSERT_TRUE(direct.verified());
  EXPECT_EQ(direct.effort.iterations, 0);
  EXPECT_EQ(direct.motion()->transit_time(), resumed.motion()->transit_time());
  EXPECT_EQ(direct.as_neighbour()->point.x, resumed.as_neighbour()->point.x);
}

TEST(State, OfAnotherSceneIsRefused) {
  Scene uniform = off_centred(0.0);
  uniform.body.eta_m = 0.0;
  EXPECT_ANY_THROW(
      (void)neighbour_from_state(to_state(*solved().as_neighbour()), uniform));
  EXPECT_ANY_THROW((void)neighbour_from_state("{}", uniform));
  EXPECT_ANY_THROW((void)neighbour_from_state("", uniform));
}

TEST(State, OfNoMeshIsRefused) {
  const Neighbour sound = *solved().as_neighbour();
  const auto refused = [&](auto change) {
    Neighbour neighbour = sound;
    change(neighbour);
    EXPECT_THROW((void)neighbour_from_state(to_state(neighbour), sound.scene),
                 std::invalid_argument);
  };
  refused([](Neighbour& n) { n.mesh.degree = 0; });
  refused([](Neighbour& n) { n.mesh.degree = -3; });
  refused([](Neighbour& n) { n.mesh.degree = 1'000'000'000; });
  refused([](Neighbour& n) { n.mesh.boundaries.clear(); });
  refused([](Neighbour& n) { n.mesh.boundaries = {0.0}; });
  refused([](Neighbour& n) { n.mesh.boundaries.back() = 2.0; });
  refused([](Neighbour& n) { n.mesh.boundaries[1] = 0.0; });
  refused([](Neighbour& n) { n.point.x.pop_back(); });
  refused([](Neighbour& n) { n.point.lambda.clear(); });
}

TEST(Request, SurvivesALine) {
  const Request request{3, 16, "{\"phi\": 1}\n\"quoted\""};
  const std::string line = to_line(request);
  EXPECT_EQ(line.find('\n'), line.size() - 1);

  const Request read = request_from_line(line);

  EXPECT_EQ(read.first, 3U);
  EXPECT_EQ(read.last, 16U);
  EXPECT_EQ(read.state, request.state);
}

TEST(Answer, SurvivesALine) {
  const Answer answer{7, outcome_json(solved()), R"({"phi":1})"};
  const std::string line = to_line(answer);
  EXPECT_EQ(line.find('\n'), line.size() - 1);

  const auto read = answer_from_line(line.substr(0, line.size() - 1));

  ASSERT_TRUE(read);
  EXPECT_EQ(read->scene, 7U);
  EXPECT_EQ(read->result, answer.result);
  EXPECT_EQ(read->state, answer.state);
  EXPECT_EQ(read->outcome.status, "solved");
  EXPECT_EQ(read->outcome.tau, solved().motion()->tau());
}

/// Laid out like those of to_line().
std::string answer_line(std::string_view scene, std::string_view result,
                        std::string_view state) {
  return fmt::format(R"({{"scene":{},"result":{},"state":{}}})", scene, result,
                     state);
}

constexpr std::string_view kResult =
    R"({"status":"x","message":"","verified":false})";

TEST(Answer, IsReadFromTheLeastOne) {
  EXPECT_TRUE(answer_from_line(answer_line("1", kResult, R"("")")));
  const auto nested = answer_from_line(answer_line(
      "1",
      R"({"status":"x","message":",\"state\":","verified":false,"state":[0]})",
      R"("{\"a\":0,\"state\":\"\"}")"));
  ASSERT_TRUE(nested);
  EXPECT_EQ(nested->outcome.message, ",\"state\":");
  EXPECT_EQ(nested->state, R"({"a":0,"state":""})");
}

TEST(Answer, IsNotReadFromAnythingElse) {
  const std::string whole = to_line(Answer{7, outcome_json(solved()), ""});
  const std::string least = answer_line("1", kResult, R"("")");
  for (const std::string& line :
       {std::string(""),
        std::string("rubbish"),
        std::string("{}"),
        std::string("[1, 2]"),
        std::string("7"),
        std::string("\xff\xfe"),
        answer_line("-1", kResult, R"("")"),
        answer_line("", kResult, R"("")"),
        answer_line("1", "3", R"("")"),
        answer_line("1", "", R"("")"),
        answer_line("1", kResult, "0"),
        answer_line("1", kResult, ""),
        answer_line("1", R"({"status":"x","message":"","verified":true})",
                    R"("")"),
        answer_line("1", R"({"status":1,"message":"","verified":"yes"})",
                    R"("")"),
        answer_line("1", kResult, R"("rubbish")"),
        answer_line("1", std::string(kResult) + " ", R"("")"),
        answer_line("1", std::string("\xef\xbb\xbf") + std::string(kResult),
                    R"("")"),
        answer_line("1", std::string(kResult) + R"(,"more":0)", R"("")"),
        answer_line("1", std::string(kResult) + "}", R"("")"),
        std::string(R"({"scene":1,"result":{"status":"solved"}})"),
        std::string(R"({"scene":1,"state":"","result":{}})"),
        least + "}",
        least.substr(0, least.size() - 1),
        whole.substr(0, whole.size() / 2)}) {
    EXPECT_FALSE(answer_from_line(line)) << line;
  }
}

TEST(Answer, IsNotReadFromWhatNestsWithoutEnd) {
  for (const auto& [open, close] : {std::pair{"[", "]"}, {"{\"a\":", "}"}}) {
    std::string deep;
    for (int i = 0; i < 300'000; ++i) deep += open;
    deep += "0";
    const std::string half = deep;
    for (int i = 0; i < 300'000; ++i) deep += close;
    EXPECT_FALSE(answer_from_line(deep));
    EXPECT_FALSE(answer_from_line(half));
    EXPECT_FALSE(answer_from_line(answer_line(
        "1", R"({"status":"","message":"","verified":false,"a":)" + deep + "}",
        R"("")")));
    EXPECT_FALSE(answer_from_line(answer_line("1", kResult, deep)));
    EXPECT_FALSE(answer_from_line(answer_line(deep, kResult, R"("")")));
  }
}

TEST(Answer, IsNotReadFromMoreThanAnyResultHas) {
  std::string wide = R"({"status":"","message":"","verified":false)";
  for (int i = 0; i < 300'000; ++i) wide += ",\"" + std::to_string(i) + "\":0";
  EXPECT_FALSE(answer_from_line(answer_line("1", wide + "}", R"("")")));
  EXPECT_FALSE(answer_from_line(
      answer_line("1",
                  R"({"status":"","verified":false,"message":")" +
                      std::string(2'000'000, 'm') + "\"}",
                  R"("")")));
}

TEST(Outcome, TellsWhatTheSolutionTold) {
  const SweepOutcome outcome = read_outcome(outcome_json(solved()));

  EXPECT_EQ(outcome.state, SweepOutcome::State::Verified);
  EXPECT_EQ(outcome.status, "solved");
  EXPECT_EQ(outcome.tau, solved().motion()->tau());
  EXPECT_EQ(outcome.transit_time, solved().motion()->transit_time());
  EXPECT_EQ(outcome.estimated_error, solved().estimated_error);
  EXPECT_EQ(outcome.feasible, solved().feasible());
}

TEST(Outcome, IsTheResultButForItsOrigin) {
  using Json = nlohmann::ordered_json;
  Json result = Json::parse(report::result_json(solved()));
  for (const char* key : {"forecast", "provenance", "scene", "input"}) {
    EXPECT_EQ(result.erase(key), 1U) << key;
  }

  EXPECT_EQ(outcome_json(solved()), result.dump());
}

TEST(Outcome, HasTheArcsOfItsLimitsInTheOrderOfThePath) {
  Solution solution = solved();
  const double T = solution.motion()->transit_time();
  LimitOnPath friction, floor;
  friction.name = "friction";
  const auto arc = [&](double from, double to) {
    ActiveArc active{};
    active.t = {from * T, to * T};
    return active;
  };
  friction.active = {arc(0.0, 0.1), arc(0.5, 1.0)};
  floor.name = "floor";
  floor.active = {arc(0.2, 0.3)};
  solution.limits = {friction, floor};
  solution.scene.limits.friction = 0.5;

  const SweepOutcome outcome = read_outcome(outcome_json(solution));

  ASSERT_EQ(outcome.arcs.size(), 3U);
  EXPECT_EQ(outcome.arcs[0].limit, "friction");
  EXPECT_EQ(outcome.arcs[1].limit, "floor");
  EXPECT_DOUBLE_EQ(outcome.arcs[1].from, 0.2);
  EXPECT_DOUBLE_EQ(outcome.arcs[1].to, 0.3);
  EXPECT_DOUBLE_EQ(outcome.arcs[2].to, 1.0);
}

TEST(Outcome, OfASaddleSaysWhatToTry) {
  Solution solution = solve(off_centred(0.0));
  ASSERT_TRUE(solution.verified());
  solution.certificate.checks.clear();
  solution.certificate.add("second_order", 1.0, 0.0, "");

  const SweepOutcome outcome = read_outcome(outcome_json(solution));

  EXPECT_EQ(outcome.status, "not_verified");
  EXPECT_NE(outcome.message.find("search: global"), std::string::npos)
      << outcome.message;
}

TEST(Outcome, OfAFailureHasNoNumbers) {
  const SweepOutcome outcome =
      read_outcome(failure_json("worker_lost", "the \"worker\" \xff crashed"));

  EXPECT_EQ(outcome.state, SweepOutcome::State::Failed);
  EXPECT_EQ(outcome.status, "worker_lost");
  EXPECT_TRUE(std::isnan(outcome.tau));
}

}  // namespace
}  // namespace brachisto::sweep
