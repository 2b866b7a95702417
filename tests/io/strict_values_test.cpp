// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What the values of a problem file may be.

#include <gtest/gtest.h>

#include <string>

#include "io/reading.hpp"

namespace brachisto::io {
namespace {

/// Messages of a bead with one more key in a section, from line 2 on.
std::string errors_with(const std::string& section, const std::string& key,
                        const std::string& value) {
  return errors(kBead + section + ":\n  " + key + ": " + value + "\n");
}

TEST(StrictValues, NumbersAreNeitherMapsNorListsNorNothing) {
  EXPECT_EQ(errors_with("solver", "tolerance", "{a: 1}"),
            "p.yaml:3:14: solver.tolerance: a map was read; expected a number, "
            "from 1e-14 to 1e-6");
  EXPECT_EQ(errors_with("solver", "tolerance", "[1e-9]"),
            "p.yaml:3:14: solver.tolerance: a list was read; expected a "
            "number, from 1e-14 to 1e-6");
  EXPECT_EQ(errors_with("solver", "tolerance", ""),
            "p.yaml:3:3: solver.tolerance: no value was read; expected a "
            "number, from 1e-14 to 1e-6");
  EXPECT_EQ(errors_with("solver", "tolerance", "\"\""),
            "p.yaml:3:14: solver.tolerance: \"\" is not a number: it is empty; "
            "expected a number, from 1e-14 to 1e-6");
}

TEST(StrictValues, MapsAreMaps) {
  EXPECT_EQ(errors("scene: 3\n"),
            "p.yaml:1:8: scene: a single value was read; expected a map with "
            "the keys body, finish, gravity, contact, path, field, start, air, "
            "losses, limits");
  EXPECT_EQ(
      errors("- scene\n"),
      "p.yaml:1:1: a list was read; expected a map with the keys "
      "version, scene, discretisation, solver, sweep, work_precision, design");
  EXPECT_EQ(
      errors("scene\n"),
      "p.yaml:1:1: a single value was read; expected a map with the keys "
      "version, scene, discretisation, solver, sweep, work_precision, design");
}

TEST(StrictValues, SectionsMayBeEmpty) {
  EXPECT_EQ(errors(kBead + "solver:\ndiscretisation: {}\n"), "");
}

TEST(StrictValues, NonFiniteNumbersAreRefused) {
  for (const std::string value :
       {".inf", "-.inf", ".nan", "inf", "nan", "1/0", "1e999", "log(0)"}) {
    EXPECT_NE(errors_with("solver", "tolerance", value)
                  .find("p.yaml:3:14: solver.tolerance: \"" + value +
                        "\" is not a number: "),
              std::string::npos)
        << value;
  }
}

TEST(StrictValues, WordsAreNotNumbers) {
  EXPECT_EQ(errors_with("solver", "tolerance", "tight"),
            "p.yaml:3:14: solver.tolerance: \"tight\" is not a number: "
            "\"tight\" has no meaning here; expected a number, from 1e-14 to "
            "1e-6");
}

TEST(StrictValues, ToleranceBoundsAreKept) {
  EXPECT_EQ(errors_with("solver", "tolerance", "1e-14"), "");
  EXPECT_EQ(errors_with("solver", "tolerance", "1e-6"), "");
  EXPECT_EQ(errors_with("solver", "tolerance", "1e-5"),
            "p.yaml:3:14: solver.tolerance: \"1e-5\" is not allowed; expected "
            "a number, from 1e-14 to 1e-6");
  EXPECT_EQ(errors_with("discretisation", "tolerance", "1e-13"), "");
  EXPECT_EQ(errors_with("discretisation", "tolerance", "0.1"), "");
  EXPECT_EQ(errors_with("discretisation", "tolerance", "0"),
            "p.yaml:3:14: discretisation.tolerance: \"0\" is not allowed; "
            "expected a number, from 1e-13 to 1e-1");
}

TEST(StrictValues, IntegersAreIntegral) {
  EXPECT_EQ(errors_with("discretisation", "degree", "5.0"), "");
  EXPECT_EQ(errors_with("discretisation", "degree", "2*3"), "");
  EXPECT_EQ(errors_with("discretisation", "degree", "2.5"),
            "p.yaml:3:11: discretisation.degree: \"2.5\" is not an integer; "
            "expected an integer, from 1 to 8");
}

TEST(StrictValues, IntegerBoundsAreKept) {
  const auto refused = [](const std::string& message) {
    return message.find("is not allowed; expected an integer") !=
           std::string::npos;
  };

  EXPECT_TRUE(refused(errors_with("discretisation", "degree", "0")));
  EXPECT_TRUE(refused(errors_with("discretisation", "degree", "9")));
  EXPECT_TRUE(refused(errors_with("discretisation", "elements", "0")));
  EXPECT_EQ(errors_with("discretisation", "elements", "1e7"), "");
  EXPECT_TRUE(refused(errors_with("discretisation", "elements", "10000001")));
  EXPECT_TRUE(refused(errors_with("discretisation", "nodes", "1")));
  EXPECT_TRUE(refused(errors_with("discretisation", "nodes", "1e300")));
  EXPECT_EQ(errors(kBead + "solver: {limits: {iterations: 0}}\n"),
            "p.yaml:2:31: solver.limits.iterations: \"0\" is not allowed; "
            "expected an integer, ≥ 1");
  EXPECT_EQ(errors(kBead + "solver: {limits: {iterations: 2147483647}}\n"), "");
  EXPECT_EQ(errors(kBead + "solver: {limits: {iterations: 2147483648}}\n"),
            "p.yaml:2:31: solver.limits.iterations: \"2147483648\" is not "
            "allowed; expected an integer, ≥ 1, at most 2147483647");
}

TEST(StrictValues, TimeLimitIsPositive) {
  EXPECT_EQ(errors(kBead + "solver: {limits: {seconds: 1e-3}}\n"), "");
  EXPECT_EQ(errors(kBead + "solver: {limits: {seconds: 0}}\n"),
            "p.yaml:2:28: solver.limits.seconds: \"0\" is not allowed; "
            "expected a number in s, > 0");
}

TEST(StrictValues, OtherVersionsAreRefused) {
  EXPECT_EQ(errors(kBead + "version: 1\n"), "");
  EXPECT_EQ(errors(kBead + "version: 2\n"),
            "p.yaml:2:10: version: \"2\" is not allowed; expected an integer, "
            "1 (this program reads version 1)");
}

TEST(StrictValues, WordsGetTheNearestKnown) {
  EXPECT_EQ(errors("scene: {body: {shape: baed}, finish: {L: 3, H: 1}}\n"),
            "p.yaml:1:23: scene.body.shape: \"baed\" was read; expected "
            "cylinder or ball or bead; did you mean bead?");
  EXPECT_EQ(errors_with("solver", "method", "IPOPT"),
            "p.yaml:3:11: solver.method: \"IPOPT\" was read; expected ipopt "
            "or newton_kkt or extremal or fsolve or auto; did you mean ipopt?");
  EXPECT_EQ(errors_with("solver", "guess", "{random: 3}"),
            "p.yaml:3:10: solver.guess: a map was read; expected cycloid or "
            "straight or random");
}

TEST(StrictValues, AnglesTakeASuffixAndOtherNumbersDoNot) {
  EXPECT_EQ(errors(cylinder("radius: 1/3, k: 1/2, theta_m: 30 deg")), "");
  EXPECT_EQ(errors(cylinder("radius: 1/3, k: 1/2 deg")),
            "p.yaml:3:43: scene.body.k: \"1/2 deg\" is not a number: deg is a "
            "unit of angles, and this is none; expected a number, "
            "0 ≤ k ≤ 1 − η_m²");
}

}  // namespace
}  // namespace brachisto::io
