// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What the keys of a problem file demand of each other.

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "io/effective_input.hpp"
#include "io/reading.hpp"

namespace brachisto::io {
namespace {

std::string mesh_errors(const std::string& keys) {
  return errors(kBead + "discretisation: {" + keys + "}\n");
}

TEST(Consistency, StraightPiecesHaveNoDegreeAndNoOtherSearch) {
  const std::string leave = "; leave it out, or take formulation: rolling_time";
  EXPECT_EQ(mesh_errors("formulation: arc_length, nodes: 1000"), "");
  EXPECT_EQ(mesh_errors("formulation: arc_length, tolerance: 1e-9"), "");
  EXPECT_EQ(mesh_errors("formulation: arc_length, degree: 2"),
            "p.yaml:2:51: discretisation.degree: has no effect with "
            "formulation: arc_length" +
                leave);
  EXPECT_EQ(mesh_errors("formulation: arc_length, elements: 7"),
            "p.yaml:2:53: discretisation.elements: 7 is not allowed with "
            "formulation: arc_length, which needs 8 or more");
  EXPECT_EQ(mesh_errors("formulation: arc_length, nodes: 8"),
            "p.yaml:2:50: discretisation.nodes: 8 is not allowed with "
            "formulation: arc_length, which needs 9 or more");
  EXPECT_EQ(errors(kBead + "discretisation: {formulation: arc_length}\n"
                           "solver: {search: global}\n"),
            "p.yaml:3:18: solver.search: has no effect with formulation: "
            "arc_length" +
                leave);
}

TEST(Consistency, StraightPiecesSayHowManyATightToleranceWouldTake) {
  EXPECT_EQ(mesh_errors("formulation: arc_length, tolerance: 1e-12"),
            "p.yaml:2:54: discretisation.tolerance: 1e-12 is not allowed with "
            "formulation: arc_length, whose error falls as the square of the "
            "number of pieces: it would take some 6e+05 of them. Allowed is "
            "1e-09 or more; or take formulation: rolling_time");
}

TEST(Consistency, CylindersNeedRadiusAndInertia) {
  EXPECT_EQ(errors(cylinder("eta_m: 1/2")),
            "p.yaml:3:3: scene.body.radius: missing; expected a number in m, "
            "> 0 (r, radius of the cylinder; of a ball R)\n"
            "p.yaml:3:3: scene.body.k: missing; expected a number, "
            "0 ≤ k ≤ 1 − η_m² (k = I_cm/(m r²), moment of inertia about the "
            "centre of mass)");
}

TEST(Consistency, BeadsHaveNothingButMass) {
  EXPECT_EQ(errors("scene:\n"
                   "  body: {radius: 1/3, k: x, shape: bead, mass: 2}\n"
                   "  finish: {L: 3, H: 1}\n"),
            "p.yaml:2:10: scene.body.radius: a bead has no radius; allowed of "
            "a bead: shape, mass\n"
            "p.yaml:2:23: scene.body.k: a bead has no k; allowed of a bead: "
            "shape, mass\n"
            "p.yaml:2:26: scene.body.k: \"x\" is not a number: \"x\" has no "
            "meaning here; expected a number, 0 ≤ k ≤ 1 − η_m²");
}

TEST(Consistency, BeadsRefuseTheKeysOfCylindersEvenIfZero) {
  EXPECT_EQ(errors("scene: {body: {shape: bead, eta_m: 0}, "
                   "finish: {L: 3, H: 1}}\n"),
            "p.yaml:1:29: scene.body.eta_m: a bead has no eta_m; allowed of a "
            "bead: shape, mass");
}

TEST(Consistency, BoundsOfPhysicsGetAPosition) {
  EXPECT_EQ(errors(cylinder("radius: 0, k: 1/2")),
            "p.yaml:3:35: scene.body.radius: 0 m is not allowed: it must be "
            "> 0, for the radius of a cylinder is a length");
  EXPECT_NE(errors(cylinder("radius: 1, eta_m: 0.8, k: 0.5"))
                .find("p.yaml:3:53: scene.body.k: 0.5 is not allowed"),
            std::string::npos);
  EXPECT_NE(errors("scene:\n  gravity: -9.81\n  body: {shape: bead}\n"
                   "  finish: {L: 3, H: 0}\n")
                .find("p.yaml:2:12: scene.gravity: -9.81 m/s² is not allowed"),
            std::string::npos);
}

TEST(Consistency, BoundsOfPhysicsLeaveRoomForRounding) {
  EXPECT_EQ(errors(cylinder("radius: 1, eta_m: 1/sqrt(2), k: 1/2")), "");
}

TEST(Consistency, BoundsAreNotCheckedAgainstNumbersNobodyGave) {
  const std::string message =
      errors(cylinder("radius: x, eta_m: y, k: 0.9, mass: z"));

  EXPECT_EQ(std::ranges::count(message, '\n'), 2) << message;
  EXPECT_EQ(message.find("is not allowed:"), std::string::npos) << message;
}

TEST(Consistency, ElementsAndNodesExcludeEachOther) {
  EXPECT_EQ(mesh_errors("elements: 10, nodes: 51"),
            "p.yaml:2:32: discretisation.nodes: elements is given too; "
            "elements and nodes both fix the mesh, allowed is one of them");
  EXPECT_EQ(mesh_errors("nodes: 51, elements: 10"),
            "p.yaml:2:29: discretisation.elements: nodes is given too; "
            "elements and nodes both fix the mesh, allowed is one of them");
}

TEST(Consistency, NodesFitTheDegree) {
  EXPECT_EQ(mesh_errors("nodes: 201"), "");
  EXPECT_EQ(mesh_errors("nodes: 200, degree: 1"), "");
  EXPECT_EQ(mesh_errors("nodes: 1e6, degree: 3"), "");
  EXPECT_EQ(mesh_errors("nodes: 1e6, degree: 2"),
            "p.yaml:2:25: discretisation.nodes: 1000000 is not allowed; "
            "nodes − 1 is a multiple of the degree 2; nearest: 999999 or "
            "1000001");
  EXPECT_EQ(mesh_errors("nodes: 200"),
            "p.yaml:2:25: discretisation.nodes: 200 is not allowed; nodes − 1 "
            "is a multiple of the degree 5; nearest: 196 or 201");
  EXPECT_EQ(mesh_errors("nodes: 3"),
            "p.yaml:2:25: discretisation.nodes: 3 is not allowed; nodes − 1 is "
            "a multiple of the degree 5; nearest: 6");
}

TEST(Consistency, AllMistakesComeInFileOrder) {
  const std::string text =
      "solver: {guess: strait}\n"
      "scene:\n"
      "  gravity: 0\n"
      "  body: {shape: cylinder, k: 1/2, etam: 0}\n"
      "  finish: {L: -1, H: 1/0}\n"
      "version: 7\n";
  const auto line_starts = {
      "p.yaml:1:17: solver.guess: ",     "p.yaml:3:12: scene.gravity: ",
      "p.yaml:4:3: scene.body.radius: ", "p.yaml:4:35: scene.body.etam: ",
      "p.yaml:5:15: scene.finish.L: ",   "p.yaml:5:22: scene.finish.H: ",
      "p.yaml:6:10: version: "};

  const std::string message = errors(text);

  std::size_t at = 0;
  for (const std::string start : line_starts) {
    EXPECT_EQ(message.substr(at, start.size()), start);
    at = message.find('\n', at) + 1;
  }
  EXPECT_EQ(at, 0U) << "more lines than expected: " << message;
}

TEST(Consistency, ShootingRefusesKeysItHasNoUseFor) {
  const std::string has =
      "has no effect with method: extremal; leave it out, or take method: "
      "ipopt";
  for (const std::string keys :
       {"discretisation: {degree: 3}\n", "discretisation: {elements: 40}\n",
        "discretisation: {nodes: 41, tolerance: 1e-8}\n"}) {
    const std::string found =
        errors(kBead + keys + "solver: {method: extremal}\n");

    EXPECT_NE(found.find(has), std::string::npos) << keys << found;
  }
  for (const std::string key :
       {"search: global", "tolerance: 1e-9", "polish: false", "guess: random",
        "linear_solver: mumps", "certify: extremal", "sensitivities: true",
        "limits: {iterations: 7}"}) {
    const std::string found =
        errors(kBead + "solver: {method: extremal, " + key + "}\n");

    EXPECT_NE(found.find(has), std::string::npos) << key << ": " << found;
    EXPECT_EQ(errors(kBead + "solver: {method: ipopt, " + key + "}\n"), "");
  }
}

TEST(Consistency, AGivenPathHasNoSensitivities) {
  EXPECT_EQ(errors("scene: {body: {shape: bead}, finish: {L: 3, H: 1}, path: "
                   "{shape: straight}}\nsolver: {sensitivities: true}\n"),
            "p.yaml:2:25: solver.sensitivities: is not allowed with "
            "scene.path; what is evaluated and not optimised has no conditions "
            "to follow");
  EXPECT_EQ(errors(kBead + "solver: {sensitivities: first}\n"),
            "p.yaml:2:25: solver.sensitivities: \"first\" was read; expected "
            "false or true or second");
}

TEST(Consistency, AGivenPathMindsWhatFindsOrSearches) {
  const std::string scene =
      "scene: {body: {shape: bead}, finish: {L: 3, H: 1}, path: {shape: "
      "straight}}\n";
  for (const std::string stated :
       {"discretisation: {formulation: arc_length}",
        "solver: {method: extremal}", "solver: {method: newton_kkt}",
        "solver: {method: fsolve}", "solver: {search: global}",
        "solver: {certify: extremal}", "solver: {guess: random}"}) {
    EXPECT_NE(errors(scene + stated + "\n")
                  .find("is not allowed with scene.path: what is given is "
                        "evaluated, not found"),
              std::string::npos)
        << stated;
  }
  EXPECT_EQ(errors(scene + "solver: {limits: {seconds: 9}}\n"), "");
}

TEST(Consistency, ShootingMindsNoKeyThatSaysWhatHoldsAnyway) {
  EXPECT_EQ(errors(kBead +
                   "discretisation: {tolerance: 1e-8}\n"
                   "solver: {method: extremal, search: principal, polish: true,"
                   " certify: none, guess: cycloid, limits: {seconds: 5}}\n"),
            "");
}

TEST(Consistency, TheDiscreteSystemRefusesKeysItHasNoUseFor) {
  for (const std::string keys :
       {"discretisation: {degree: 3}\n", "discretisation: {elements: 40}\n",
        "discretisation: {tolerance: 1e-2}\n"}) {
    const std::string found =
        errors(kBead + keys + "solver: {method: fsolve}\n");

    EXPECT_NE(found.find("has no effect with method: fsolve; "),
              std::string::npos)
        << keys << found;
  }
  for (const std::string key :
       {"search: global", "tolerance: 1e-9", "polish: false", "guess: random",
        "linear_solver: mumps", "certify: extremal", "sensitivities: second"}) {
    const std::string found =
        errors(kBead + "solver: {method: fsolve, " + key + "}\n");

    EXPECT_NE(found.find("has no effect with method: fsolve; "),
              std::string::npos)
        << key << ": " << found;
  }
}

TEST(Consistency, TheDiscreteSystemHasAnyNumberOfNodes) {
  const auto with = [](const std::string& nodes) {
    return errors(kBead + "discretisation: {nodes: " + nodes +
                  "}\nsolver: {method: fsolve, limits: {iterations: 9}}\n");
  };

  EXPECT_EQ(with("100"), "");
  EXPECT_EQ(with("3"), "");
  EXPECT_EQ(with("2"),
            "p.yaml:2:25: discretisation.nodes: 2 is not allowed; method: "
            "fsolve needs 3 or more");
}

TEST(Consistency, KeysOfTheDiscreteSystemNeedItsMethod) {
  for (const std::string key :
       {"quadrature: midpoint", "datum: rest", "slopes: smooth",
        "epsilon: 1e-4", "variant: lifted"}) {
    const std::string fsolve = "fsolve: {" + key + "}";
    const std::string found = errors(kBead + "solver: {" + fsolve + "}\n");

    EXPECT_NE(found.find("has no effect with method: ipopt; leave it out, or "
                         "take method: fsolve"),
              std::string::npos)
        << key << ": " << found;
    EXPECT_EQ(errors(kBead + "solver: {method: fsolve, " + fsolve + "}\n"), "");
  }
  EXPECT_NE(
      errors(kBead + "solver: {method: fsolve, fsolve: {variant: newton, "
                     "epsilon: 1e-4}}\n")
          .find("has no effect with variant: newton; leave it out, or take "
                "variant: hybrid"),
      std::string::npos);
}

TEST(Consistency, KeysComeInAnyOrderAndWhatHoldsAnywayIsNoMistake) {
  const std::string keys = "fsolve: {epsilon: 1e-4, variant: hybrid}";

  EXPECT_EQ(errors(kBead + "solver: {" + keys + ", method: fsolve}\n"), "");
  EXPECT_EQ(errors(kBead + "solver: {fsolve: {epsilon: 1e-3}}\n"), "");
  EXPECT_EQ(errors(kBead + "discretisation: {degree: 3}\n"
                           "solver: {method: newton_kkt, guess: cycloid}\n"),
            "");
  // Of no use for two reasons at once.
  const std::string pieces = "discretisation: {formulation: arc_length}\n";
  EXPECT_EQ(
      errors(kBead + pieces + "solver: {method: newton_kkt, guess: cycloid}\n"),
      "");
  EXPECT_NE(
      errors(kBead + pieces + "solver: {method: newton_kkt, guess: random}\n")
          .find("solver.guess: has no effect here; leave it out"),
      std::string::npos);
  EXPECT_NE(
      errors(kBead + "discretisation: {formulation: arc_length, degree: 3}\n"
                     "solver: {method: extremal}\n")
          .find("discretisation.degree: has no effect"),
      std::string::npos);
  EXPECT_NE(errors(kBead + "solver: {method: newton_kkt, guess: random}\n")
                .find("has no effect with method: newton_kkt; leave it out, or "
                      "take method: ipopt"),
            std::string::npos);
}

TEST(OtherWorlds, HaveOneFieldAlone) {
  const std::string sphere =
      "sphere: {centre: {x: 0, z: 9}, radius: 3, surface_gravity: 2}";
  const std::string scene =
      "scene: {body: {shape: bead}, finish: {L: 3, H: 1}, ";
  const std::string again =
      "says again what pulls the body; allowed is one of scene.gravity, "
      "scene.field.uniform and scene.field.sphere";
  EXPECT_EQ(errors(scene + "field: {uniform: 2, " + sphere + "}}\n"),
            "p.yaml:1:60: scene.field.uniform: " + again);
  EXPECT_EQ(errors(scene + "gravity: 2, field: {" + sphere + "}}\n"),
            "p.yaml:1:72: scene.field.sphere: " + again);
  EXPECT_EQ(errors(scene + "field: {uniform: -2}}\n"),
            "p.yaml:1:69: scene.field.uniform: -2 m/s² is not allowed: it must "
            "be > 0, for it is what moves the body");
}

TEST(OtherWorlds, AreRefusedByWhatIsDerivedForTheOrdinaryOne) {
  const std::string scene =
      "scene: {body: {shape: bead}, finish: {L: 3, H: 1}, air: {linear: 1}}\n";
  for (const std::string stated :
       {"discretisation: {formulation: arc_length}", "solver: {method: fsolve}",
        "solver: {search: global}", "solver: {guess: straight}"}) {
    EXPECT_NE(
        errors(scene + stated + "\n")
            .find("is not allowed with a field that varies, a start speed, "
                  "air or losses: "),
        std::string::npos)
        << stated;
  }
}

TEST(OtherWorlds, AreSearchedUnderLimits) {
  const std::string scene =
      "scene: {body: {shape: bead}, finish: {L: 3, H: 1}, air: {linear: 1}";
  const std::string search = "}\nsolver: {search: global}\n";

  EXPECT_EQ(errors(scene + ", limits: {floor: 2}" + search), "");
  EXPECT_NE(errors(scene + search).find("without limits the search goes back"),
            std::string::npos);
  EXPECT_NE(errors(scene + ", limits: {}" + search), "");
  EXPECT_EQ(errors(scene + ", limits: {floor: abc}" + search)
                .find("without limits the search"),
            std::string::npos);
}

TEST(Consistency, FixedEndsAreSearchedToo) {
  EXPECT_EQ(errors("scene: {body: {shape: cylinder, radius: 0.1, eta_m: 0.5, "
                   "k: 0.2}, finish: {L: 3, H: 1}, contact: centre}\n"
                   "solver: {search: global}\n"),
            "");
}

TEST(OtherWorlds, SurviveTheWayThroughTheirEcho) {
  const ProblemFile problem = read(
      "scene: {body: {shape: bead}, finish: {L: 3, H: 1}, start: {speed: 2}, "
      "air: {quadratic: 0.1}, field: {sphere: {centre: {x: 1, z: 9}, radius: "
      "3, "
      "surface_gravity: 2}}}\n");
  const Json echo = effective_input(problem.scene, problem.options);

  const ProblemFile again = read(echo.dump());

  EXPECT_EQ(again.scene.world.start_speed, 2.0);
  EXPECT_EQ(again.scene.world.air.linear, 0.0);
  EXPECT_EQ(again.scene.world.air.quadratic, 0.1);
  ASSERT_TRUE(again.scene.world.sphere);
  EXPECT_EQ(again.scene.world.sphere->centre, (Point{1.0, 9.0}));
  EXPECT_EQ(again.scene.gravity,
            again.scene.world.sphere->strength_at({0.0, 0.0}));
}

}  // namespace
}  // namespace brachisto::io
