// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// key_table(): every key of a problem file.

#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include "io/key_spec.hpp"

namespace brachisto::io {

namespace {

constexpr double kMaxInt = std::numeric_limits<int>::max();
constexpr int kMaxElements = 10'000'000;
constexpr int kMaxNodes = kMaxElements * kMaxDegree + 1;

/// Changes the given path; copies of the scene that share it keep theirs.
template <class Change>
void change_path(ProblemFile& problem, Change&& change) {
  const auto& old = problem.scene.path;
  auto path = std::make_shared<GivenPath>(old ? *old : GivenPath{});
  change(*path);
  problem.scene.path = std::move(path);
}

std::vector<KeySpec> scene_keys() {
  return {
      {.path = "scene",
       .type = KeyType::Map,
       .presence = Presence::Required,
       .description = "what is to roll where"},
      {.path = "scene.body",
       .type = KeyType::Map,
       .presence = Presence::Required,
       .description = "the body"},
      {.path = "scene.body.shape",
       .type = KeyType::Choice,
       .presence = Presence::Required,
       .description = "a cylinder rolls without slip, a bead slides without "
                      "friction",
       .choices = {{"cylinder",
                    [](ProblemFile& p) {
                      p.scene.body.shape = Shape::Cylinder;
                    }},
                   {"bead",
                    [](ProblemFile& p) { p.scene.body.shape = Shape::Bead; }}}},
      {.path = "scene.body.radius",
       .type = KeyType::Number,
       .presence = Presence::RequiredOfCylinder,
       .unit = "m",
       .bounds = "> 0",
       .description = "r, radius of the cylinder",
       .set = [](ProblemFile& p, double v) { p.scene.body.radius = v; }},
      {.path = "scene.body.eta_m",
       .type = KeyType::Number,
       .presence = Presence::OptionalOfCylinder,
       .fallback = "0",
       .bounds = "0 ≤ η_m < 1",
       .description = "η_m, distance of the centre of mass from the axis, in "
                      "radii",
       .set = [](ProblemFile& p, double v) { p.scene.body.eta_m = v; }},
      {.path = "scene.body.theta_m",
       .type = KeyType::Angle,
       .presence = Presence::OptionalOfCylinder,
       .unit = "rad",
       .fallback = "0",
       .description = "θ_m, direction from the axis to the centre of mass at "
                      "the start, from +x towards +z (down)",
       .set = [](ProblemFile& p, double v) { p.scene.body.theta_m = v; }},
      {.path = "scene.body.k",
       .type = KeyType::Number,
       .presence = Presence::RequiredOfCylinder,
       .bounds = "0 ≤ k ≤ 1 − η_m²",
       .description = "k = I_cm/(m r²), moment of inertia about the centre of "
                      "mass",
       .set = [](ProblemFile& p, double v) { p.scene.body.k = v; }},
      {.path = "scene.body.mass",
       .type = KeyType::Number,
       .unit = "kg",
       .bounds = "> 0",
       .description = "m, only needed for forces in newtons",
       .set = [](ProblemFile& p, double v) { p.scene.body.mass = v; }},
      {.path = "scene.finish",
       .type = KeyType::Map,
       .presence = Presence::Required,
       .description = "the point B to be reached from A = (0, 0)"},
      {.path = "scene.finish.L",
       .type = KeyType::Number,
       .presence = Presence::Required,
       .unit = "m",
       .bounds = "> 0",
       .description = "L, horizontal distance from A to B",
       .set = [](ProblemFile& p, double v) { p.scene.L = v; }},
      {.path = "scene.finish.H",
       .type = KeyType::Number,
       .presence = Presence::Required,
       .unit = "m",
       .bounds = "> 0",
       .description = "H, drop from A to B",
       .set = [](ProblemFile& p, double v) { p.scene.H = v; }},
      {.path = "scene.gravity",
       .type = KeyType::Number,
       .unit = "m/s²",
       .fallback = "9.81",
       .bounds = "> 0",
       .description = "g, acceleration of gravity",
       .set = [](ProblemFile& p, double v) { p.scene.gravity = v; }},
      {.path = "scene.contact",
       .type = KeyType::Choice,
       .fallback = "smooth",
       .description = "whether A and B are points of the track (smooth) or of "
                      "the path of the centre",
       .choices = {{"smooth",
                    [](ProblemFile& p) { p.scene.contact = Contact::Smooth; }},
                   {"centre",
                    [](ProblemFile& p) {
                      p.scene.contact = Contact::Centre;
                    }}}},
      {.path = "scene.path",
       .type = KeyType::Map,
       .description = "a given path, which is evaluated; without it the "
                      "fastest one is found"},
      {.path = "scene.path.curve",
       .type = KeyType::Choice,
       .fallback = "centre",
       .description = "whose curve it is: the path of the centre, or the track "
                      "from A to B",
       .choices = {{"centre",
                    [](ProblemFile& p) {
                      change_path(p, [](GivenPath& path) {
                        path.curve = GivenPath::Curve::Centre;
                      });
                    }},
                   {"track",
                    [](ProblemFile& p) {
                      change_path(p, [](GivenPath& path) {
                        path.curve = GivenPath::Curve::Track;
                      });
                    }}}},
      {.path = "scene.path.shape",
       .type = KeyType::Choice,
       .presence = Presence::Required,
       .description = "a parabola has a horizontal axis if it starts "
                      "vertically, a vertical one otherwise; a cycloid has its "
                      "cusp at the start; points: a cubic spline",
       .choices = {{"straight",
                    [](ProblemFile& p) {
                      change_path(p, [](GivenPath& path) {
                        path.shape = GivenPath::Shape::Straight;
                      });
                    }},
                   {"parabola",
                    [](ProblemFile& p) {
                      change_path(p, [](GivenPath& path) {
                        path.shape = GivenPath::Shape::Parabola;
                      });
                    }},
                   {"circular_arc",
                    [](ProblemFile& p) {
                      change_path(p, [](GivenPath& path) {
                        path.shape = GivenPath::Shape::CircularArc;
                      });
                    }},
                   {"cycloid",
                    [](ProblemFile& p) {
                      change_path(p, [](GivenPath& path) {
                        path.shape = GivenPath::Shape::Cycloid;
                      });
                    }},
                   {"points",
                    [](ProblemFile& p) {
                      change_path(p, [](GivenPath& path) {
                        path.shape = GivenPath::Shape::Points;
                      });
                    }}}},
      {.path = "scene.path.start_angle",
       .type = KeyType::Angle,
       .unit = "rad",
       .fallback = "90 deg",
       .description = "slope angle at the start of a parabola or a circular "
                      "arc, downwards positive",
       .set =
           [](ProblemFile& p, double v) {
             change_path(p, [=](GivenPath& path) { path.start_angle = v; });
           }},
      {.path = "scene.path.file",
       .type = KeyType::Text,
       .bounds = "a CSV file with the columns x,z",
       .description = "of points, in metres, from A to B; a relative name "
                      "starts from the problem file's directory",
       .set_text =
           [](ProblemFile& p, const std::string& text) {
             p.points_file = text;
             change_path(p, [](GivenPath&) {});
           }},
  };
}

std::vector<KeySpec> discretisation_keys() {
  return {
      {.path = "discretisation",
       .type = KeyType::Map,
       .description = "wanted accuracy, or a fixed mesh"},
      {.path = "discretisation.formulation",
       .type = KeyType::Choice,
       .fallback = "rolling_time",
       .description = "how the problem is made finite",
       .choices = {{"rolling_time",
                    [](ProblemFile& p) {
                      p.options.discretisation.formulation =
                          Formulation::RollingTime;
                    }},
                   {"arc_length"}}},
      {.path = "discretisation.tolerance",
       .type = KeyType::Number,
       .fallback = "1e-10",
       .bounds = "from 1e-13 to 1e-1",
       .description = "wanted relative error of the transit time; the mesh "
                      "follows unless it is fixed",
       .interval = {1e-13, 1e-1},
       .set = [](ProblemFile& p,
                 double v) { p.options.discretisation.tolerance = v; }},
      {.path = "discretisation.degree",
       .type = KeyType::Integer,
       .fallback = "follows the tolerance, 5 on a fixed mesh",
       .bounds = "from 1 to 8",
       .description = "p, polynomial degree of an element",
       .interval = {kMinDegree, kMaxDegree},
       .set =
           [](ProblemFile& p, double v) {
             p.options.discretisation.degree = static_cast<int>(v);
           }},
      {.path = "discretisation.elements",
       .type = KeyType::Integer,
       .bounds = "from 1 to 10 million",
       .description = "N, number of elements; fixes the mesh",
       .interval = {1, kMaxElements},
       .set =
           [](ProblemFile& p, double v) {
             p.options.discretisation.elements = static_cast<int>(v);
           }},
      {.path = "discretisation.nodes",
       .type = KeyType::Integer,
       .bounds = "from 2 to 80000001, and N p + 1",
       .description = "number of nodes, N p + 1; fixes the mesh in place of "
                      "elements",
       .interval = {2, kMaxNodes},
       .set =
           [](ProblemFile& p, double v) {
             p.options.discretisation.nodes = static_cast<int>(v);
           }},
  };
}

std::vector<KeySpec> solver_keys() {
  return {
      {.path = "solver",
       .type = KeyType::Map,
       .description = "how the finite problem is solved"},
      {.path = "solver.method",
       .type = KeyType::Choice,
       .fallback = "ipopt",
       .description = "ipopt: collocation and a nonlinear program; extremal: "
                      "Pontryagin's conditions by multiple shooting",
       .choices =
           {{"ipopt", [](ProblemFile& p) { p.options.method = Method::Ipopt; }},
            {"extremal",
             [](ProblemFile& p) { p.options.method = Method::Extremal; }},
            {"newton_kkt"},
            {"fsolve"}}},
      {.path = "solver.linear_solver",
       .type = KeyType::Choice,
       .fallback = "auto",
       .description = "what factorises the KKT matrix; auto takes the fastest "
                      "there is",
       .choices = {{"auto",
                    [](ProblemFile& p) {
                      p.options.linear_solver = LinearSolver::Auto;
                    }},
                   {"mumps",
                    [](ProblemFile& p) {
                      p.options.linear_solver = LinearSolver::Mumps;
                    }},
                   {"chain"}}},
      {.path = "solver.tolerance",
       .type = KeyType::Number,
       .fallback = "1e-12",
       .bounds = "from 1e-14 to 1e-6",
       .description = "largest scaled KKT residual of a solution",
       .interval = {1e-14, 1e-6},
       .set = [](ProblemFile& p, double v) { p.options.tolerance = v; }},
      {.path = "solver.search",
       .type = KeyType::Choice,
       .fallback = "principal",
       .description = "which extremal is the answer. principal: the one that "
                      "continues from the cycloid as η_m grows from 0; "
                      "global: the fastest feasible one of all that a search "
                      "finds",
       .choices =
           {{"principal",
             [](ProblemFile& p) { p.options.search = Search::Principal; }},
            {"global",
             [](ProblemFile& p) { p.options.search = Search::Global; }}}},
      {.path = "solver.polish",
       .type = KeyType::Choice,
       .fallback = "true",
       .description = "last digits by Newton's method on the optimality "
                      "conditions and the contact together",
       .choices = {{"true", [](ProblemFile& p) { p.options.polish = true; }},
                   {"false",
                    [](ProblemFile& p) { p.options.polish = false; }}}},
      {.path = "solver.certify",
       .type = KeyType::Choice,
       .fallback = "none",
       .description = "extremal: solve once more by multiple shooting and "
                      "compare",
       .choices =
           {{"none", [](ProblemFile& p) { p.options.certify = Certify::None; }},
            {"extremal",
             [](ProblemFile& p) { p.options.certify = Certify::Extremal; }}}},
      {.path = "solver.guess",
       .type = KeyType::Choice,
       .fallback = "cycloid",
       .description = "where a cold start begins; straight and random are "
                      "tried in addition and reported, the answer does not "
                      "depend on them",
       .choices = {{"cycloid",
                    [](ProblemFile& p) { p.options.guess = Guess::Cycloid; }},
                   {"straight",
                    [](ProblemFile& p) { p.options.guess = Guess::Straight; }},
                   {"random",
                    [](ProblemFile& p) { p.options.guess = Guess::Random; }}}},
      {.path = "solver.seed",
       .type = KeyType::Integer,
       .fallback = "1",
       .bounds = "≥ 0",
       .description = "of the random guess",
       .interval = {0, kMaxInt},
       .set = [](ProblemFile& p,
                 double v) { p.options.seed = static_cast<std::uint64_t>(v); }},
      {.path = "solver.limits",
       .type = KeyType::Map,
       .description = "bounds on the work"},
      {.path = "solver.limits.iterations",
       .type = KeyType::Integer,
       .fallback = "500",
       .bounds = "≥ 1",
       .description = "of the solver, in all passes together",
       .interval = {1, kMaxInt},
       .set =
           [](ProblemFile& p, double v) {
             p.options.limits.iterations = static_cast<int>(v);
           }},
      {.path = "solver.limits.seconds",
       .type = KeyType::Number,
       .unit = "s",
       .fallback = "3600",
       .bounds = "> 0",
       .description = "wall-clock time",
       .interval = {.lower = 0.0, .lower_allowed = false},
       .set = [](ProblemFile& p, double v) { p.options.limits.seconds = v; }},
      {.path = "solver.fsolve"},
  };
}

std::vector<KeySpec> all_keys() {
  std::vector<KeySpec> keys{{.path = "version",
                             .type = KeyType::Integer,
                             .fallback = "1",
                             .bounds = "1 (this program reads version 1)",
                             .description = "of the file format",
                             .interval = {1, 1},
                             .set = [](ProblemFile&, double) {}}};
  for (auto part : {scene_keys(), discretisation_keys(), solver_keys()}) {
    keys.insert(keys.end(), part.begin(), part.end());
  }
  keys.push_back({.path = "sweep",
                  .type = KeyType::Sweep,
                  .description = "keys that vary, which makes one scene into "
                                 "many; see [Sweeps](#sweeps)"});
  for (const std::string_view path : {"work_precision", "constraints"}) {
    keys.push_back({.path = path});
  }
  return keys;
}

}  // namespace

std::span<const KeySpec> key_table() {
  static const std::vector<KeySpec> table = all_keys();
  return table;
}

}  // namespace brachisto::io
