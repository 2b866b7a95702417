// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto design, from the outside.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "app/command.hpp"

namespace brachisto {
namespace {

using nlohmann::json;
using testing::Output;
using testing::run;
using testing::ScratchDirectory;

std::string design_problem(const std::string& name) {
  return std::string(BRACHISTO_PROBLEMS_DIR) + "/design/" + name + ".yaml";
}

TEST(DesignCommand, GivesTheSolutionOfTheBestBodyAndItsChoice) {
  const Output output = run({"design", design_problem("half_inertia"), "--json",
                             "--set", "design.starts=2"});

  ASSERT_EQ(output.code, 0) << output.err;
  const json result = json::parse(output.out);
  const json& design = result["design"];
  // Known to ten and four digits.
  EXPECT_NEAR(result["tau"], 4.976102748, 1e-9);
  EXPECT_NEAR(design["values"]["eta_m"], 0.4007, 5e-5);
  EXPECT_NEAR(design["values"]["theta_m"], -0.4787, 5e-5);
  EXPECT_EQ(result["scene"]["body"]["eta_m"], design["values"]["eta_m"]);
  EXPECT_TRUE(design["bounds_active"].empty());
  EXPECT_EQ(design["minima"].size(), 1U);
  EXPECT_EQ(design["minima"][0]["found_from"], 2);
  EXPECT_GT(design["solves"], 2);
  // At a minimum the slopes are the errors of their solves.
  EXPECT_NEAR(design["gradient"]["eta_m"], 0.0, 1e-6);
}

TEST(DesignCommand, WritesAnInputThatIsADesignAgain) {
  const ScratchDirectory scratch;
  const std::string out = (scratch.path() / "out").string();
  const Output first = run({"design", design_problem("half_inertia"), "--out",
                            out, "--json", "--set", "design.starts=2", "--set",
                            "design.bounds.theta_m=[-60 deg, 0]"});
  ASSERT_EQ(first.code, 0) << first.err;
  const json result = json::parse(first.out);
  EXPECT_EQ(result["input"]["design"]["free"], json({"eta_m", "theta_m"}));

  const Output again = run({"design", out + "/result.json", "--json"});

  ASSERT_EQ(again.code, 0) << again.err;
  EXPECT_NEAR(json::parse(again.out)["tau"], result["tau"], 1e-9);
}

TEST(DesignCommand, ToldToTellsHowFarItIs) {
  // Lines come after two seconds: most designs have none.
  const Output quick = run({"design", design_problem("half_inertia"),
                            "--verbose", "--set", "design.starts=1"});
  EXPECT_EQ(quick.code, 0);
  EXPECT_EQ(quick.err, "");
  const Output silent = run({"design", design_problem("half_inertia"), "--set",
                             "design.starts=60", "--jobs", "1"});
  EXPECT_EQ(silent.err, "");

  const Output slow =
      run({"design", design_problem("half_inertia"), "--verbose", "--set",
           "design.starts=200", "--jobs", "1"});

  EXPECT_NE(slow.err.find("of 200 searches have ended, least τ so far 4.97610"),
            std::string::npos)
      << slow.err;
}

TEST(DesignCommand, ClaimsTheQuickestOfItsSearchesInDegrees) {
  const Output output = run({"design", design_problem("half_inertia"), "--set",
                             "design.free=[theta_m]", "--set",
                             "design.bounds.theta_m=[200 deg, 230 deg]",
                             "--set", "design.starts=2"});

  EXPECT_EQ(output.code, 0) << output.err;
  for (const char* words :
       {"quickest found", "of 2 searches", "at its bound θ_m = 230°", "per rad",
        "2 searches from 2 bodies, of which 0 led nowhere"}) {
    EXPECT_NE(output.out.find(words), std::string::npos) << words << '\n'
                                                         << output.out;
  }
}

TEST(DesignCommand, DoesNotDependOnTheNumberOfWorkers) {
  const auto minima = [](const char* jobs) {
    const Output output = run({"design", design_problem("quickest"), "--json",
                               "--jobs", jobs, "--set", "design.starts=3"});
    return json::parse(output.out)["design"]["minima"];
  };

  EXPECT_EQ(minima("1"), minima("3"));
}

TEST(DesignCommand, ItsLimitOfTimeIsThatOfAllSearches) {
  const ScratchDirectory scratch;
  const std::string out = (scratch.path() / "out").string();
  // Minutes of work.
  const Output output =
      run({"design", design_problem("quickest"), "--json", "--set",
           "design.starts=1000", "--set", "solver.limits.seconds=1", "--out",
           out, "--map", "50"});

  EXPECT_EQ(output.code, 7) << output.err;
  const json result = json::parse(output.out);
  const json& design = result["design"];
  EXPECT_TRUE(design["stopped"]);
  EXPECT_LT(design["searches"], 1000);
  EXPECT_FALSE(std::filesystem::exists(scratch.path() / "out/design_map.svg"));
  if (result["verified"] == true) {
    EXPECT_NE(output.err.find("the limit of 1 s was reached"),
              std::string::npos)
        << output.err;
    // None is quicker than the quickest, known to ten digits.
    EXPECT_GT(result["tau"], 3.977561557);
    EXPECT_EQ(result["scene"]["body"]["k"], design["values"]["k"]);
  } else {
    EXPECT_EQ(result["status"], "time_limit") << result["message"];
  }
}

TEST(DesignCommand, GoesOnWithTheSearchesThatAreThere) {
  const ScratchDirectory scratch;
  const std::string out = (scratch.path() / "out").string();
  const auto design = [&](const char* flag) {
    return run({"design", design_problem("half_inertia"), "--out", out, "--set",
                "design.starts=2", "--json", flag});
  };
  const json first = json::parse(design("--force").out);

  const Output again = design("--resume");

  ASSERT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(json::parse(again.out)["design"], first["design"]);
  for (const char* file : {"result.json", "path.svg", "sweep.sqlite"}) {
    EXPECT_TRUE(std::filesystem::exists(scratch.path() / "out" / file)) << file;
  }
  const Output other =
      run({"design", design_problem("half_inertia"), "--out", out, "--resume",
           "--set", "design.starts=2", "--set", "design.seed=2"});
  EXPECT_EQ(other.code, 6);
  EXPECT_NE(other.err.find("design differs"), std::string::npos) << other.err;
}

TEST(DesignCommand, Ends3ForAProblemWithoutAQuickestBody) {
  const Output output =
      run({"design", design_problem("quickest"), "--set", "design.free=[r]"});

  EXPECT_EQ(output.code, 3);
  EXPECT_NE(output.err.find("(L² + H²)/(2L)"), std::string::npos) << output.err;
}

TEST(DesignCommand, Ends3WithoutAnythingToDesign) {
  const Output output = run({"design", testing::paper_problem("fig06_bead")});

  EXPECT_EQ(output.code, 3);
  EXPECT_NE(output.err.find("design.free"), std::string::npos) << output.err;
}

TEST(DesignCommand, OtherVerbsLeaveTheSectionAlone) {
  const Output output = run({"solve", design_problem("quickest"), "--json"});

  ASSERT_EQ(output.code, 0) << output.err;
  const json result = json::parse(output.out);
  EXPECT_EQ(result["scene"]["body"]["k"], 0.5);
  EXPECT_FALSE(result.contains("design"));
}

TEST(DesignCommand, TellsWhereToGlueAWeight) {
  const Output output = run({"design", design_problem("ring_with_weight"),
                             "--set", "design.starts=2"});

  EXPECT_EQ(output.code, 0) << output.err;
  EXPECT_NE(output.out.find("part_2.x"), std::string::npos) << output.out;
}

}  // namespace
}  // namespace brachisto
