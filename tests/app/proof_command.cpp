// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// certify: proof, and what refuses it.

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "app/command.hpp"

namespace brachisto {
namespace {

using nlohmann::json;
using testing::Output;
using testing::run;
using testing::ScratchDirectory;

/// A bead that lands on a floor and rolls to B: τ = 3 + π/2.
constexpr const char* kOnFloor =
    "scene:\n  body: {shape: bead}\n  finish: {L: 3, H: 1}\n"
    "  limits: {floor: 1}\n";

#ifdef BRACHISTO_HAS_ARB

TEST(CertifyProof, TellsBoundsAndWritesTheCertificate) {
  const ScratchDirectory directory;
  const std::string file = directory.file(
      "case.yaml", std::string(kOnFloor) + "solver: {certify: proof}\n");
  const std::string out = (directory.path() / "out").string();
  const Output solved = run({"solve", file, "--out", out, "--json"});
  ASSERT_EQ(solved.code, 0) << solved.err;

  const json result = json::parse(solved.out);
  const json& proof = result["proof"];
  EXPECT_EQ(result["input"]["solver"]["certify"], "proof");
  EXPECT_EQ(proof["proven"], true);
  EXPECT_EQ(proof["within_estimate"], true);
  const double tau = 3.0 + 0.5 * std::numbers::pi;
  EXPECT_NEAR(std::stod(proof["tau_lower"].get<std::string>()), tau, 1e-15);
  EXPECT_NEAR(std::stod(proof["tau_upper"].get<std::string>()), tau, 1e-15);
  ASSERT_FALSE(proof["theorems"].empty());
  for (const json& theorem : proof["theorems"]) {
    EXPECT_EQ(theorem["holds"], true) << theorem;
  }
  const Output again =
      run({"check-proof", out + "/proof.json", "--problem", file});
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(run({"check-proof", out + "/nowhere.json"}).code, 6);
  // No certificate of an earlier answer stays.
  const Output anew = run(
      {"solve", file, "--certify", "none", "--out", out, "--force", "--json"});
  EXPECT_EQ(anew.code, 0);
  EXPECT_FALSE(json::parse(anew.out).contains("proof"));
  EXPECT_FALSE(std::filesystem::exists(out + "/proof.json"));
}

// Friction is reached at rest: that answer stays verified.
TEST(CertifyProof, LeavesAnAnswerThatItCannotProve) {
  const ScratchDirectory directory;
  const std::string file =
      directory.file("case.yaml",
                     "scene:\n  body: {shape: cylinder, radius: 1/3, k: 1/2}\n"
                     "  finish: {L: 3, H: 1}\n  limits: {friction: 0.3}\n"
                     "solver: {certify: proof}\n");
  const Output solved = run({"solve", file, "--json"});
  EXPECT_EQ(solved.code, 0) << solved.err;
  const json result = json::parse(solved.out);
  EXPECT_EQ(result["verified"], true);
  EXPECT_EQ(result["proof"]["proven"], false);
  EXPECT_NE(result["proof"]["message"].get<std::string>().find("rest"),
            std::string::npos);
}

#else

TEST(CertifyProof, IsRefusedWithoutArb) {
  const ScratchDirectory directory;
  const Output solved = run(
      {"solve", directory.file("case.yaml", kOnFloor), "--certify", "proof"});
  EXPECT_EQ(solved.code, 2);
  EXPECT_NE(solved.err.find("without Arb"), std::string::npos);
}

#endif

TEST(CertifyProof, IsRefusedOfASweep) {
  const ScratchDirectory directory;
  const std::string out = (directory.path() / "out").string();
  const std::string file =
      directory.file("sweep.yaml", std::string(kOnFloor) +
                                       "solver: {certify: proof}\n"
                                       "sweep: {scene.finish.L: [2, 3]}\n");
  const Output swept = run({"sweep", file, "--out", out});
  EXPECT_EQ(swept.code, 3);
  EXPECT_NE(swept.err.find("solver.certify: a sweep proves nothing"),
            std::string::npos)
      << swept.err;
}

}  // namespace
}  // namespace brachisto
