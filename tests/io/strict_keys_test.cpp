// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Which keys a problem file may have, and where.

#include <gtest/gtest.h>

#include <string>

#include "io/reading.hpp"

namespace brachisto::io {
namespace {

TEST(StrictKeys, UnknownOnesAreRefusedWithTheNearestKnown) {
  EXPECT_EQ(
      errors(cylinder("raduis: 1/3, radius: 1/3, k: 1/2")),
      "p.yaml:3:27: scene.body.raduis: unknown key; allowed in "
      "scene.body: shape, radius, eta_m, theta_m, k, inertia, rails, groove, "
      "parts, mass; did you mean radius?");
  EXPECT_EQ(
      errors(kBead + "viscosity: 0.3\n"),
      "p.yaml:2:1: viscosity: unknown key; allowed at the top level: "
      "version, scene, discretisation, solver, sweep, work_precision, design");
}

TEST(StrictKeys, MisplacedOnesAreSentHome) {
  EXPECT_EQ(errors(kBead + "k: 1/2\n"),
            "p.yaml:2:1: k: misplaced key; it belongs in scene.body or "
            "design.bounds; allowed "
            "at the top level: version, scene, discretisation, solver, sweep, "
            "work_precision, design");
  EXPECT_EQ(
      errors("scene: {eta_m: 0, body: {shape: bead}, "
             "finish: {L: 3, H: 1}}\n"),
      "p.yaml:1:9: scene.eta_m: misplaced key; it belongs in scene.body or "
      "design.bounds; "
      "allowed in scene: body, finish, gravity, contact, path, field, start, "
      "air, losses, limits");
  EXPECT_EQ(errors(kBead + "tolerance: 1e-8\n"),
            "p.yaml:2:1: tolerance: misplaced key; it belongs in "
            "discretisation or solver; allowed at the top level: version, "
            "scene, discretisation, solver, sweep, work_precision, design");
}

TEST(StrictKeys, DottedOnesAreForOverridesOnly) {
  EXPECT_EQ(errors(kBead + "solver.guess: straight\n"),
            "p.yaml:2:1: solver.guess: a key with dots; in a file it is "
            "written as nested maps; allowed at the top level: version, "
            "scene, discretisation, solver, sweep, work_precision, design");
}

TEST(StrictKeys, RequiredOnesAreMissed) {
  EXPECT_EQ(errors("version: 1\n"),
            "p.yaml:1:1: scene: missing; expected a map with the keys body, "
            "finish, gravity, contact, path, field, start, air, losses, limits "
            "(what is to roll where)");
  EXPECT_EQ(errors("scene:\n  finish:\n    L: 3\n  body: {}\n"),
            "p.yaml:2:3: scene.finish.H: missing; expected a number in m, > 0 "
            "(H, drop from A to B)\n"
            "p.yaml:4:3: scene.body.shape: missing; expected cylinder or ball "
            "or bead (a cylinder rolls without slip, a ball likewise, a bead "
            "slides)");
}

TEST(StrictKeys, ReservedOnesAreNotCalledUnknown) {
  for (const std::string key : {"constraints"}) {
    EXPECT_EQ(errors(kBead + key + ": {}\n"),
              "p.yaml:2:1: " + key +
                  ": reserved for a later version of brachisto; allowed at the "
                  "top level: version, scene, discretisation, solver, sweep, "
                  "work_precision, design");
  }
}

}  // namespace
}  // namespace brachisto::io
