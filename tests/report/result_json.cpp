// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/report/result.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "report/solutions.hpp"
#include "study/answer_kinds.hpp"

namespace brachisto {
namespace {

using nlohmann::json;
using report::result_json;
using testing::bead_solution;
using testing::differentiated_solution;
using testing::discrete_solution;
using testing::impossible_solution;
using testing::limited_solution;
using testing::off_centred_solution;
using testing::uniform_solution;
using testing::unverified_solution;

// Names that other programs rely on, spelt out once more on purpose.
const std::vector<std::string> kPathKeys{
    "tau",         "transit_time", "centre_path_length", "rail_length",
    "start_angle", "end_angle",    "rotation",           "normal_force",
    "friction",    "curvature",    "fold_margin",        "at_start"};
const std::vector<std::string> kOtherKeys{"schema_version",
                                          "status",
                                          "verified",
                                          "feasible",
                                          "infeasible_because",
                                          "not_verified_because",
                                          "estimated_error",
                                          "nodes",
                                          "variables",
                                          "constraints",
                                          "iterations",
                                          "closure_passes",
                                          "seconds",
                                          "certificate",
                                          "provenance",
                                          "scene",
                                          "message",
                                          "warnings",
                                          "mesh",
                                          "newton_steps",
                                          "continuation",
                                          "refinement",
                                          "folds",
                                          "continued_from_L",
                                          "cold_start",
                                          "branches",
                                          "search_remark",
                                          "extremal",
                                          "discrete_system"};

std::vector<const Solution*> all_kinds() {
  return {&off_centred_solution(), &uniform_solution(),
          &bead_solution(),        &unverified_solution(),
          &impossible_solution(),  &discrete_solution()};
}

TEST(ResultJson, HasEveryKeyWhateverTheOutcome) {
  for (const Solution* solution : all_kinds()) {
    const json document = json::parse(result_json(*solution));

    for (const std::string& key : kPathKeys) {
      EXPECT_TRUE(document.contains(key)) << key;
    }
    for (const std::string& key : kOtherKeys) {
      EXPECT_TRUE(document.contains(key)) << key;
    }
    for (const char* key : {"kkt_residual", "reintegration_error",
                            "energy_drift", "contact_error", "second_order"}) {
      EXPECT_TRUE(document["certificate"].contains(key)) << key;
    }
    for (const char* key : {"total", "solve", "certificate"}) {
      EXPECT_TRUE(document["seconds"][key].is_number()) << key;
    }
  }
}

TEST(ResultJson, NamesTheMembersOfItsObjects) {
  const json document = json::parse(result_json(off_centred_solution()));

  for (const char* key : {"min", "max", "x_at_max", "min_after_rise"}) {
    EXPECT_TRUE(document["normal_force"][key].is_number()) << key;
  }
  for (const char* key :
       {"share_above_0.3", "share_above_0.5", "share_above_1"}) {
    EXPECT_TRUE(document["friction"][key].is_number()) << key;
  }
  for (const char* key : {"min", "max", "min_after_rise"}) {
    EXPECT_TRUE(document["curvature"][key].is_number()) << key;
  }
  for (const char* object : {"normal_force", "curvature"}) {
    EXPECT_EQ(document[object]["min_at_start"], true) << object;
    EXPECT_EQ(document[object]["max_at_start"], false) << object;
  }
  const json& grip = document["grip"]["least_after"];
  ASSERT_EQ(grip.size(), 3U);
  EXPECT_TRUE(grip[0]["mu"].is_null()) << "at the start no friction would do";
  EXPECT_EQ(grip[1]["share_of_time"], 0.01);
  EXPECT_GT(grip[1]["mu"], grip[2]["mu"]);
  EXPECT_EQ(document["at_start"]["normal_force"], 0.0);
  EXPECT_EQ(document["at_start"]["curvature"],
            -1.0 / off_centred_solution().scene.body.radius);
  EXPECT_TRUE(document["fold_margin"].is_number());
  for (const char* key : {"brachisto", "ipopt", "mumps", "blas", "suitesparse",
                          "compiler", "options"}) {
    EXPECT_TRUE(document["provenance"].contains(key)) << key;
  }
}

TEST(ResultJson, NumbersComeBackBitForBit) {
  const Solution& solution = off_centred_solution();
  const Trajectory& path = *trajectory_of(solution);

  const json document = json::parse(result_json(solution));

  EXPECT_EQ(document["tau"].get<double>(), path.tau());
  EXPECT_EQ(document["transit_time"].get<double>(), path.transit_time());
  EXPECT_EQ(document["centre_path_length"].get<double>(),
            path.centre_path_length());
  EXPECT_EQ(document["rail_length"].get<double>(), path.rail_length());
  EXPECT_EQ(document["start_angle"].get<double>(), path.start_angle());
  EXPECT_EQ(document["end_angle"].get<double>(), path.end_angle());
  EXPECT_EQ(document["rotation"].get<double>(), *path.rotation());
  EXPECT_EQ(document["estimated_error"].get<double>(),
            *solution.estimated_error);
  EXPECT_EQ(document["scene"]["body"]["radius"].get<double>(), 1.0 / 3.0);
  EXPECT_EQ(document["scene"]["gravity"].get<double>(), 9.81);
}

TEST(ResultJson, OfAVerifiedSolutionSaysSo) {
  const json document = json::parse(result_json(off_centred_solution()));

  EXPECT_EQ(document["status"], "solved");
  EXPECT_EQ(document["verified"], true);
  EXPECT_EQ(document["feasible"], true);
  EXPECT_EQ(document["infeasible_because"], json::array());
  EXPECT_EQ(document["not_verified_because"], json::array());
  EXPECT_EQ(document["nodes"], off_centred_solution().program()->nodes);
}

TEST(ResultJson, OfAnUnverifiedSolutionHasNoNumbersOfThePath) {
  ASSERT_EQ(unverified_solution().status, Status::Solved);
  ASSERT_FALSE(unverified_solution().verified());

  const json document = json::parse(result_json(unverified_solution()));

  EXPECT_EQ(document["status"], "solved");
  EXPECT_EQ(document["verified"], false);
  EXPECT_TRUE(document["feasible"].is_null());
  EXPECT_TRUE(document["infeasible_because"].is_null());
  const json& reasons = document["not_verified_because"];
  ASSERT_EQ(reasons.size(), 1u);
  EXPECT_TRUE(reasons[0].get<std::string>().starts_with("agreement is "));
  EXPECT_NE(document["message"].get<std::string>().find("not verified"),
            std::string::npos);
  for (const std::string& key : kPathKeys) {
    EXPECT_TRUE(document[key].is_null()) << key;
  }
}

TEST(ResultJson, OfAnUnsolvedSceneHasTheReason) {
  const json document = json::parse(result_json(impossible_solution()));

  EXPECT_EQ(document["status"], "no_admissible_path");
  EXPECT_EQ(document["verified"], false);
  EXPECT_TRUE(document["not_verified_because"].is_null());
  EXPECT_NE(document["message"].get<std::string>().find("inside the"),
            std::string::npos);
  for (const std::string& key : kPathKeys) {
    EXPECT_TRUE(document[key].is_null()) << key;
  }
  for (const char* key :
       {"estimated_error", "nodes", "variables", "constraints"}) {
    EXPECT_TRUE(document[key].is_null()) << key;
  }
}

TEST(ResultJson, TellsHowTheSolutionWasFound) {
  Solution solution = off_centred_solution();
  solution.folds = {0.75, 0.25};
  solution.cold_start = ColdStart{Status::Solved, 5.25, true};
  Branch branch;
  branch.tau = 5.5;
  branch.remarks = {"failed check slope"};
  solution.branches = {branch};
  CrossCheck opinion;
  opinion.solved = true;
  opinion.tau = 5.125;
  opinion.difference = 0.5;
  solution.extremal = opinion;

  const json document = json::parse(result_json(solution));

  const json& meshes = document["refinement"];
  ASSERT_EQ(meshes.size(), solution.effort.meshes.size());
  EXPECT_EQ(meshes.back()["degree"], document["mesh"]["degree"]);
  EXPECT_EQ(meshes.back()["elements"], document["mesh"]["elements"]);
  EXPECT_EQ(meshes.back()["estimated_error"], document["estimated_error"]);
  EXPECT_EQ(document["continuation"].size(),
            solution.effort.continuation.size());
  EXPECT_EQ(document["newton_steps"], solution.effort.newton_steps);
  EXPECT_EQ(document["folds"], json::array({0.75, 0.25}));
  EXPECT_EQ(document["cold_start"]["status"], "solved");
  EXPECT_EQ(document["cold_start"]["tau_coarse"], 5.25);
  EXPECT_EQ(document["cold_start"]["principal"], true);
  // What is not verified has no τ.
  EXPECT_TRUE(document["branches"][0]["tau"].is_null());
  EXPECT_EQ(document["branches"][0]["verified"], false);
  EXPECT_EQ(document["branches"][0]["remarks"][0], "failed check slope");
  EXPECT_EQ(document["extremal"]["solved"], true);
  EXPECT_EQ(document["extremal"]["tau"], 5.125);
  EXPECT_EQ(document["certificate"]["extremal_tau"], 5.125);
  EXPECT_EQ(document["certificate"]["tau"], document["tau"]);
  EXPECT_EQ(document["certificate"]["extremal_difference"], 0.5);
}

TEST(ResultJson, TellsWhatLimitsMeanForThePath) {
  const Solution& solution = limited_solution();

  const json document = json::parse(result_json(solution));

  const json& limits = document["limits"];
  ASSERT_EQ(limits.size(), 3u);
  EXPECT_EQ(limits[0]["name"], "friction");
  EXPECT_EQ(limits[0]["bound"], 0.5);
  EXPECT_EQ(limits[0]["least_slack"], 0.0);
  EXPECT_EQ(limits[0]["share_of_time"], 0.375);
  EXPECT_EQ(limits[0]["price"], -0.0625);
  EXPECT_EQ(limits[0]["price_at_fixed_contacts"], -0.15625);
  ASSERT_EQ(limits[0]["active"].size(), 2u);
  const TrajectoryPoint begin = solution.motion()->at(0.5);
  const TrajectoryPoint end = solution.motion()->at(0.75);
  const json expected = {
      {"u", {{"from", begin.u}, {"to", end.u}}},
      {"t", {{"from", begin.t}, {"to", end.t}}},
      {"x", {{"from", begin.motion.contact.x}, {"to", end.motion.contact.x}}}};
  EXPECT_EQ(limits[0]["active"][1], expected);
  EXPECT_TRUE(limits[1]["price"].is_null());
  EXPECT_TRUE(limits[2]["bound"].is_null());
  EXPECT_EQ(limits[2]["active"], json::array());
  EXPECT_EQ(document["constraints"], solution.program()->constraints);
}

TEST(ResultJson, TellsTheArcsFromAToBInTheirOrder) {
  const Solution& solution = limited_solution();

  const json structure = json::parse(result_json(solution))["structure"];

  const std::vector<std::pair<double, json>> begins{
      {0.0, json::array()},
      {0.125, {"friction"}},
      {0.25, json::array()},
      {0.5, {"friction"}},
      {0.6875, {"friction", "normal_force.max"}},
      {0.75, {"normal_force.max"}},
      {0.8125, json::array()}};
  ASSERT_EQ(structure.size(), begins.size());
  for (std::size_t i = 0; i < begins.size(); ++i) {
    const auto& [sigma, holds] = begins[i];
    const TrajectoryPoint begin = solution.motion()->at(sigma);
    const TrajectoryPoint end = solution.motion()->at(
        i + 1 < begins.size() ? begins[i + 1].first : 1.0);
    EXPECT_EQ(structure[i]["holds"], holds) << i;
    EXPECT_EQ(structure[i]["t"]["from"], begin.t) << i;
    EXPECT_EQ(structure[i]["t"]["to"], end.t) << i;
  }
  EXPECT_EQ(structure.back()["x"]["to"], solution.scene.L);
  EXPECT_FALSE(
      json::parse(result_json(uniform_solution())).contains("structure"));
}

TEST(ResultJson, TellsHowTheTimeChangesIfItIsAsked) {
  Solution solution = differentiated_solution();
  const json first = json::parse(result_json(solution))["sensitivities"];
  solution.sensitivities->second.emplace();
  (*solution.sensitivities->second)[SceneParameter::EtaM][SceneParameter::H] =
      0.5;
  const json second = json::parse(result_json(solution))["sensitivities"];

  EXPECT_EQ(first["H"], (json{{"tau", 6.0},
                              {"transit_time", 1.5},
                              {"tau_at_fixed_contacts", 3.0},
                              {"transit_time_at_fixed_contacts", 0.75}}));
  EXPECT_TRUE(first["k"].is_null());
  EXPECT_EQ(first["eta_m_sin_theta_m"], first["theta_m"]);
  EXPECT_FALSE(first.contains("second"));
  EXPECT_EQ(second["second"][0][5], 0.5);
  solution.sensitivities.reset();
  EXPECT_EQ(json::parse(result_json(solution))["sensitivities"],
            json::object());
  EXPECT_FALSE(json::parse(result_json(off_centred_solution()))
                   .contains("sensitivities"));
}

TEST(ResultJson, TellsOfLimitsWhereThereAreAnyAndThePathIsVerified) {
  Solution unverified = limited_solution();
  unverified.certificate.add("broken", 1.0, 0.0);

  for (const Solution* solution : all_kinds()) {
    EXPECT_FALSE(json::parse(result_json(*solution)).contains("limits"));
  }
  EXPECT_EQ(json::parse(result_json(unverified))["limits"], json::array());
}

TEST(ResultJson, HasNothingOfWhatWasNotAskedFor) {
  const json document = json::parse(result_json(off_centred_solution()));

  EXPECT_EQ(document["folds"], json::array());
  EXPECT_EQ(document["branches"], json::array());
  EXPECT_TRUE(document["cold_start"].is_null());
  EXPECT_TRUE(document["extremal"].is_null());
  EXPECT_TRUE(document["discrete_system"].is_null());
}

TEST(ResultJson, KeepsTheDiscreteSystemApartFromTheAnswer) {
  const json document = json::parse(result_json(discrete_solution()));

  EXPECT_EQ(document["status"], "solved");
  EXPECT_EQ(document["verified"], false);
  for (const std::string& key : kPathKeys) {
    EXPECT_TRUE(document[key].is_null()) << key;
  }
  const json& reasons = document["not_verified_because"];
  ASSERT_EQ(reasons.size(), 1u);
  EXPECT_TRUE(reasons[0].get<std::string>().starts_with("discretisation is "));
  const json& system = document["discrete_system"];
  EXPECT_EQ(system["solved"], true);
  EXPECT_EQ(system["nodes"], 100);
  EXPECT_EQ(system["unknowns"], 399);
  const double exact = testing::reference("reference_case").tau;
  EXPECT_NEAR(system["tau"].get<double>(), 5.1274, 1e-4);  // computed elsewhere
  EXPECT_NEAR(system["error"].get<double>(),
              system["tau"].get<double>() / exact - 1.0, 1e-10);
  for (const char* key :
       {"residual", "iterations", "evaluations", "jacobians", "refused_points",
        "cpu_seconds", "memory_bytes", "transit_time", "centre_path_length",
        "start_angle", "end_angle"}) {
    EXPECT_TRUE(system[key].is_number()) << key;
  }
  const json& options = document["provenance"]["options"]["solver"];
  EXPECT_EQ(options["method"], "fsolve");
  EXPECT_EQ(options["fsolve"]["variant"], "lifted");
  EXPECT_EQ(options["fsolve"]["datum"], "rest");
}

TEST(ResultJson, SecondsAddUp) {
  const json seconds =
      json::parse(result_json(off_centred_solution()))["seconds"];

  EXPECT_NEAR(
      seconds["solve"].get<double>() + seconds["certificate"].get<double>(),
      seconds["total"].get<double>(), 1e-12);
  EXPECT_GE(seconds["solve"].get<double>(), 0.0);
}

TEST(ResultJson, OfABeadHasNothingThatOnlyARollingBodyHas) {
  const json document = json::parse(result_json(bead_solution()));

  EXPECT_EQ(document["verified"], true);
  for (const char* key : {"rotation", "friction", "grip", "fold_margin"}) {
    EXPECT_TRUE(document[key].is_null()) << key;
  }
  EXPECT_EQ(document["scene"]["body"]["shape"], "bead");
  EXPECT_TRUE(document["tau"].is_number());
}

TEST(ResultJson, WritesWhatIsNotANumberAsNull) {
  Solution solution = off_centred_solution();
  solution.certificate.add("broken", std::numeric_limits<double>::quiet_NaN(),
                           1.0);

  const json document = json::parse(result_json(solution));

  EXPECT_TRUE(document["certificate"]["broken"].is_null());
  EXPECT_EQ(document["verified"], false);
  EXPECT_TRUE(document["tau"].is_null());
}

TEST(InputJson, HoldsTheSceneAndEveryDefault) {
  const json document = json::parse(
      report::input_json(testing::reference("theta_-30").scene(), {}));

  EXPECT_EQ(document["scene"]["finish"]["L"], 3.0);
  EXPECT_EQ(document["scene"]["contact"], "smooth");
  EXPECT_EQ(document["solver"]["method"], "ipopt");
  EXPECT_EQ(document["solver"]["limits"]["iterations"], 3000);
  EXPECT_EQ(document["solver"]["limits"]["seconds"], 3600.0);
  EXPECT_EQ(document["solver"]["tolerance"], 1e-12);
  EXPECT_TRUE(document["solver"]["fsolve"].is_null());
}

TEST(InputJson, HoldsTheKeysOfItsMethodAlone) {
  SolveOptions options;
  options.method = DiscreteSystem{};

  const json document = json::parse(
      report::input_json(testing::reference("theta_-30").scene(), options));

  EXPECT_EQ(document["solver"]["method"], "fsolve");
  EXPECT_EQ(document["solver"]["fsolve"]["quadrature"], "vmean");
  EXPECT_EQ(document["solver"]["fsolve"]["epsilon"], 1e-3);
  EXPECT_EQ(document["discretisation"]["nodes"], 100);
  for (const char* of_another : {"search", "polish", "linear_solver"}) {
    EXPECT_TRUE(document["solver"][of_another].is_null()) << of_another;
  }
}

}  // namespace
}  // namespace brachisto
