// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// key_table(): every key of a problem file, once.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include "io/binding.hpp"
#include "io/path_points.hpp"
#include "io/work_precision_lists.hpp"

namespace brachisto::io {

namespace {

using Keys = std::vector<KeySpec>;

constexpr double kMaxInt = std::numeric_limits<int>::max();
constexpr Interval kPositive{.lower = 0.0, .lower_allowed = false};

constexpr auto kScene = place([](auto& p) -> auto& { return p.scene; });
constexpr auto kBody = place([](auto& p) -> auto& { return p.scene.body; });
constexpr auto kLimits =
    place([](auto& p) -> auto& { return p.options.limits; });
constexpr auto kMethod = place([](auto& p) -> auto& { return p; });

constexpr bool is_program(const Draft& d) {
  return d.poses_the_program();
}
/// Elements with a degree, one branch among others to be sought.
constexpr bool is_collocation(const Draft& d) {
  return d.poses_the_program() && !d.of_pieces();
}
constexpr bool is_shooting(const Draft& d) {
  return d.method == MethodWord::Extremal;
}
constexpr bool is_system(const Draft& d) {
  return d.method == MethodWord::Fsolve;
}

constexpr auto program = [](auto& p) -> auto& {
  return p.program;
};
constexpr auto mesh = [](auto& p) -> auto& {
  return p.program.discretisation;
};
constexpr auto reading = [](auto& p) -> auto& {
  return p.system.reading;
};

constexpr auto kProgram = place(program, is_program);
constexpr auto kCollocation = place(program, is_collocation);
constexpr auto kColdStart = place(program, [](const Draft& d) {
  return is_collocation(d) && d.method == MethodWord::Ipopt;
});
constexpr auto kMesh = place(mesh, is_program);
constexpr auto kElements = place(mesh, is_collocation);
constexpr auto kShooting = place(
    [](auto& p) -> auto& { return p.shooting; }, is_shooting);
constexpr auto kSystem = place(
    [](auto& p) -> auto& { return p.system; }, is_system);
constexpr auto kReading = place(reading, is_system);
constexpr auto kDifferences = place(reading, [](const Draft& d) {
  return is_system(d) && d.system.solver == DiscreteSolver::Hybrid;
});
constexpr auto kIterations = place(
    [](auto& p) -> auto& { return p.options.limits; },
    [](const Draft& d) { return !is_shooting(d); });
constexpr auto kPlan = place([](auto& p) -> auto& { return p.work_precision; });

/// The given path. Copies of the scene share it, so that a change makes it
/// anew.
constexpr Place<GivenPath> kPath{
    [](const Draft& p) { return p.scene.path.get(); },
    [](Draft& p) -> GivenPath& {
      const auto& old = p.scene.path;
      auto path = std::make_shared<GivenPath>(old ? *old : GivenPath{});
      GivenPath& made = *path;
      p.scene.path = std::move(path);
      return made;
    }};

/// The start angle is echoed as it is in force.
Binding start_angle() {
  Binding binding = angle(kPath, &GivenPath::start_angle);
  binding.get = [](const Draft& p) {
    const auto& path = p.scene.path;
    return path && path->has_start_angle()
               ? Json(path->start_angle_or_vertical())
               : Json();
  };
  return binding;
}

/// The file of points, whose content is echoed in its place.
Binding points_file() {
  return {.type = KeyType::Text, .set = [](Draft& p, const Json& text) {
            p.points_file = text.get<std::string>();
            kPath.make(p);
          }};
}

Keys scene_keys() {
  using Curve = GivenPath::Curve;
  using Form = GivenPath::Shape;
  return {
      {.path = "scene",
       .value = map(),
       .presence = Presence::Required,
       .description = "what is to roll where"},
      {.path = "scene.body",
       .value = map(),
       .presence = Presence::Required,
       .description = "the body"},
      {.path = "scene.body.shape",
       .value = choice(kBody, &Body::shape,
                       {{"cylinder", Shape::Cylinder}, {"bead", Shape::Bead}}),
       .presence = Presence::Required,
       .description = "a cylinder rolls without slip, a bead slides without "
                      "friction"},
      {.path = "scene.body.radius",
       .value = number(kBody, &Body::radius),
       .presence = Presence::RequiredOfCylinder,
       .unit = "m",
       .description = "r, radius of the cylinder",
       .physical = kPositive},
      {.path = "scene.body.eta_m",
       .value = number(kBody, &Body::eta_m),
       .presence = Presence::OptionalOfCylinder,
       .bounds = "0 ≤ η_m < 1",
       .description = "η_m, distance of the centre of mass from the axis, in "
                      "radii",
       .physical = {.lower = 0.0, .upper = 1.0, .upper_allowed = false}},
      {.path = "scene.body.theta_m",
       .value = angle(kBody, &Body::theta_m),
       .presence = Presence::OptionalOfCylinder,
       .unit = "rad",
       .description = "θ_m, direction from the axis to the centre of mass at "
                      "the start, from +x towards +z (down)"},
      {.path = "scene.body.k",
       .value = number(kBody, &Body::k),
       .presence = Presence::RequiredOfCylinder,
       .bounds = "0 ≤ k ≤ 1 − η_m²",
       .description = "k = I_cm/(m r²), moment of inertia about the centre of "
                      "mass",
       .physical = {.lower = 0.0, .upper = 1.0}},
      {.path = "scene.body.mass",
       .value = number(kBody, &Body::mass),
       .unit = "kg",
       .description = "m, only needed for forces in newtons",
       .physical = kPositive},
      {.path = "scene.finish",
       .value = map(),
       .presence = Presence::Required,
       .description = "the point B to be reached from A = (0, 0)"},
      {.path = "scene.finish.L",
       .value = number(kScene, &Scene::L),
       .presence = Presence::Required,
       .unit = "m",
       .description = "L, horizontal distance from A to B",
       .physical = kPositive},
      {.path = "scene.finish.H",
       .value = number(kScene, &Scene::H),
       .presence = Presence::Required,
       .unit = "m",
       .description = "H, drop from A to B",
       .physical = kPositive},
      {.path = "scene.gravity",
       .value = number(kScene, &Scene::gravity),
       .unit = "m/s²",
       .description = "g, acceleration of gravity",
       .physical = kPositive},
      {.path = "scene.contact",
       .value =
           choice(kScene, &Scene::contact,
                  {{"smooth", Contact::Smooth}, {"centre", Contact::Centre}}),
       .description = "whether A and B are points of the track (smooth) or of "
                      "the path of the centre"},
      {.path = "scene.path",
       .value = map(kPath),
       .description = "a given path, which is evaluated; without it the "
                      "extremal is found"},
      {.path = "scene.path.curve",
       .value = choice(kPath, &GivenPath::curve,
                       {{"centre", Curve::Centre}, {"track", Curve::Track}}),
       .description = "whose curve it is: the path of the centre, or the track "
                      "from A to B"},
      {.path = "scene.path.shape",
       .value = choice(kPath, &GivenPath::shape,
                       {{"straight", Form::Straight},
                        {"parabola", Form::Parabola},
                        {"circular_arc", Form::CircularArc},
                        {"cycloid", Form::Cycloid},
                        {"points", Form::Points}}),
       .presence = Presence::Required,
       .description = "a parabola has a horizontal axis if it starts "
                      "vertically, a vertical one otherwise; a cycloid has its "
                      "cusp at the start; points: a cubic spline"},
      {.path = "scene.path.start_angle",
       .value = start_angle(),
       .unit = "rad",
       .fallback = "90 deg",
       .description = "slope angle at the start of a parabola or a circular "
                      "arc, downwards positive"},
      {.path = "scene.path.file",
       .value = points_file(),
       .bounds = "a CSV file with the columns x,z",
       .description = "of points, in metres, from A to B; a relative name "
                      "starts from the problem file's directory"},
      {.path = "scene.path.points",
       .value = points_list(),
       .unit = "m",
       .bounds = "a list of points [x, z]",
       .description = "the points themselves, in place of a file"},
  };
}

Keys discretisation_keys() {
  return {
      {.path = "discretisation",
       .value = map(),
       .description = "wanted accuracy, or a fixed mesh"},
      {.path = "discretisation.formulation",
       .value = choice(kMesh, &Discretisation::formulation,
                       {{"rolling_time", Formulation::RollingTime},
                        {"arc_length", Formulation::ArcLength}}),
       .description = "how the problem is made finite. rolling_time: "
                      "collocation; arc_length: the paper's variables, on "
                      "straight pieces, of order 2"},
      {.path = "discretisation.tolerance",
       .value = shared(number(kMesh, &Discretisation::tolerance),
                       number(kShooting, &Shooting::tolerance)),
       .fallback = "1e-10",
       .bounds = "from 1e-13 to 1e-1",
       .description = "wanted relative error of the transit time; the mesh "
                      "follows unless it is fixed. arc_length: 1e-9 or more, "
                      "1e-6 if absent",
       .interval = {kSmallestTolerance, kLargestTolerance}},
      {.path = "discretisation.degree",
       .value = number(kElements, &Discretisation::degree),
       .fallback = "follows the tolerance, 5 on a fixed mesh",
       .description = "p, polynomial degree of an element; not for arc_length",
       .interval = {kMinDegree, kMaxDegree}},
      {.path = "discretisation.elements",
       .value = number(kMesh, &Discretisation::elements),
       .bounds = "from 1 to 10 million",
       .description = "N, number of elements, of straight pieces for "
                      "arc_length; fixes the mesh",
       .interval = {1, kMaxElements}},
      {.path = "discretisation.nodes",
       .value = shared(number(kMesh, &Discretisation::nodes),
                       number(kSystem, &DiscreteSystem::nodes)),
       .fallback = "follows the tolerance, 100 with method: fsolve",
       .bounds = "from 2 to 80000001, and N p + 1",
       .description = "number of nodes, N p + 1, or N + 1 for arc_length; "
                      "fixes the mesh in place of elements. With method: "
                      "fsolve any n ≥ 3",
       .interval = {2, kMaxNodes}},
  };
}

Keys solver_keys() {
  const auto named = [](LinearSolver solver) {
    return std::pair{name(solver), solver};
  };
  return {
      {.path = "solver",
       .value = map(),
       .description = "how the finite problem is solved"},
      {.path = "solver.method",
       .value = choice(kMethod, &Draft::method,
                       {{"ipopt", MethodWord::Ipopt},
                        {"newton_kkt", MethodWord::NewtonKkt},
                        {"extremal", MethodWord::Extremal},
                        {"fsolve", MethodWord::Fsolve}}),
       .description =
           "ipopt: collocation and a nonlinear program; newton_kkt: "
           "the same by Newton's method on its optimality conditions, "
           "from the continuation; extremal: "
           "Pontryagin's conditions by multiple shooting; fsolve: "
           "the paper's discrete system, for comparison, never "
           "verified"},
      {.path = "solver.linear_solver",
       .value = choice(kProgram, &Collocation::linear_solver,
                       {named(LinearSolver::Auto), named(LinearSolver::Mumps),
                        named(LinearSolver::Chain)}),
       .description =
           "what factorises the KKT matrix. chain: along the chain "
           "of elements; mumps: a general sparse solver; auto: chain "
           "where it is possible, mumps otherwise"},
      {.path = "solver.tolerance",
       .value = number(kProgram, &Collocation::tolerance),
       .description = "largest scaled KKT residual of a solution",
       .interval = {kSmallestResidual, kLargestResidual}},
      {.path = "solver.search",
       .value = choice(
           kCollocation, &Collocation::search,
           {{"principal", Search::Principal}, {"global", Search::Global}}),
       .description = "which extremal is the answer. principal: the one that "
                      "continues from the cycloid as η_m grows from 0; "
                      "global: of the smooth contacts that a search finds the "
                      "fastest verified and feasible one"},
      {.path = "solver.polish",
       .value = yes_or_no(kProgram, &Collocation::polish),
       .description = "last digits by Newton's method on the optimality "
                      "conditions and the contact together"},
      {.path = "solver.certify",
       .value =
           choice(kProgram, &Collocation::certify,
                  {{"none", Certify::None}, {"extremal", Certify::Extremal}}),
       .description = "extremal: solve once more by multiple shooting and "
                      "compare"},
      {.path = "solver.guess",
       .value = choice(kColdStart, &Collocation::guess,
                       {{"cycloid", Guess::Cycloid},
                        {"straight", Guess::Straight},
                        {"random", Guess::Random}}),
       .description = "where a cold start begins; straight and random are "
                      "tried in addition and reported, the answer does not "
                      "depend on them"},
      {.path = "solver.seed",
       .value = number(kProgram, &Collocation::seed),
       .description = "of the random guess",
       .interval = {0, kMaxInt}},
      {.path = "solver.limits",
       .value = map(),
       .description = "bounds on the work"},
      {.path = "solver.limits.iterations",
       .value = number(kIterations, &Limits::iterations),
       .description = "of the solver, in all passes together",
       .interval = {1, kMaxInt}},
      {.path = "solver.limits.seconds",
       .value = number(kLimits, &Limits::seconds),
       .unit = "s",
       .description = "wall-clock time",
       .interval = kPositive},
  };
}

/// What the paper leaves open of its discrete system.
Keys fsolve_keys() {
  using Quadrature = DiscreteReading::Quadrature;
  using Datum = DiscreteReading::Datum;
  using Slopes = DiscreteReading::Slopes;
  return {
      {.path = "solver.fsolve",
       .value = map(kSystem),
       .description = "of method: fsolve, what the paper leaves open"},
      {.path = "solver.fsolve.quadrature",
       .value = choice(kReading, &DiscreteReading::quadrature,
                       {{"vmean", Quadrature::MeanSpeed},
                        {"midpoint", Quadrature::Midpoint},
                        {"trapezoid", Quadrature::Trapezoid}}),
       .description = "time of a chord of length l: vmean, 2 l/(v + v') with "
                      "the speeds at its ends; midpoint, l/v halfway; "
                      "trapezoid, l (1/v + 1/v')/2"},
      {.path = "solver.fsolve.datum",
       .value = choice(kReading, &DiscreteReading::datum,
                       {{"release", Datum::Release},
                        {"rest", Datum::Rest},
                        {"printed", Datum::Printed}}),
       .description = "zero level of the energy: release, the first node; "
                      "rest, A as printed but at rest in the first node; "
                      "printed, A, which leaves no real speed there"},
      {.path = "solver.fsolve.slopes",
       .value =
           choice(kReading, &DiscreteReading::slopes,
                  {{"literal", Slopes::Literal}, {"smooth", Slopes::Smooth}}),
       .description = "end slopes: literal, by Δz/Δx, which turns round with "
                      "Δx; smooth, by Δx/l and Δz/l"},
      {.path = "solver.fsolve.epsilon",
       .value = number(kDifferences, &DiscreteReading::epsilon),
       .description = "half width of the central differences in units of H, "
                      "of variant hybrid; 0: exact derivatives",
       .interval = {0.0, kLargestEpsilon}},
      {.path = "solver.fsolve.variant",
       .value = choice(kSystem, &DiscreteSystem::solver,
                       {{"hybrid", DiscreteSolver::Hybrid},
                        {"newton", DiscreteSolver::Newton},
                        {"lifted", DiscreteSolver::Lifted}}),
       .description = "hybrid: Powell's method with a dense Jacobian by "
                      "differences, as fsolve; newton: exact derivatives, "
                      "dense; lifted: the same steps from a sparse system"},
  };
}

Keys work_precision_keys() {
  constexpr double kMostRepetitions = 1000;
  return {
      {.path = "work_precision",
       .value = map(),
       .description = "what `brachisto work-precision` runs; other verbs read "
                      "it and go their way"},
      {.path = "work_precision.methods",
       .value = methods_list(),
       .bounds = "a list of rolling_time, arc_length, extremal, fsolve, "
                 "{rolling_time: [degrees]} and {fsolve: [arms]}",
       .description = "lines of the diagram; the arms of fsolve are rest, "
                      "release (the hybrid method with either datum), newton "
                      "and lifted, the first two if none is named"},
      {.path = "work_precision.meshes",
       .value = meshes_list(),
       .bounds = "a list of integers from 2 to 1000000",
       .description = "points of each line: elements of rolling_time, pieces "
                      "of arc_length, nodes of fsolve"},
      {.path = "work_precision.repetitions",
       .value = number(kPlan, &WorkPrecisionPlan::repetitions),
       .description = "timed runs of a point, of which the median counts; "
                      "fewer where a run takes seconds",
       .interval = {1, kMostRepetitions}},
      {.path = "work_precision.seconds_per_point",
       .value = number(kPlan, &WorkPrecisionPlan::seconds_per_point),
       .unit = "s",
       .description = "wall-clock time after which a point is given up",
       .interval = kPositive},
  };
}

/// A number as one would write it: 1e-6, not 1e-06.
std::string short_number(double value) {
  std::string text = fmt::format("{}", value);
  if (const std::size_t at = text.find("e-0"); at != std::string::npos) {
    text.erase(at + 2, 1);
  }
  return text;
}

std::string words_of(const Interval& interval) {
  if (std::isinf(interval.lower)) return "";
  if (interval.upper >= kMaxInt) {
    return fmt::format("{} {}", interval.lower_allowed ? "≥" : ">",
                       short_number(interval.lower));
  }
  return fmt::format("from {} to {}", short_number(interval.lower),
                     short_number(interval.upper));
}

/// A value as it stands in a file.
std::string written(const Json& value) {
  if (value.is_null()) return "";
  if (value.is_number()) return short_number(value.get<double>());
  std::string text;
  for (const char c : value.dump()) {
    if (c == '"') continue;
    text += c;
    if (c == ',' || c == ':') text += ' ';
  }
  return text;
}

Keys all_keys() {
  Keys keys{
      {.path = "version",
       .value = {.type = KeyType::Integer, .set = [](Draft&, const Json&) {}},
       .fallback = "1",
       .bounds = "1 (this program reads version 1)",
       .description = "of the file format",
       .interval = {1, 1}}};
  const auto add = [&](Keys part) {
    std::ranges::move(part, std::back_inserter(keys));
  };
  add(scene_keys());
  add(discretisation_keys());
  add(solver_keys());
  add(fsolve_keys());
  keys.push_back({.path = "sweep",
                  .value = {.type = KeyType::Sweep},
                  .description = "keys that vary, which makes one scene into "
                                 "many; see [Sweeps](#sweeps)"});
  add(work_precision_keys());
  keys.push_back({.path = "constraints"});

  // What is not said in words, the values say.
  Draft fresh;
  kPath.make(fresh);
  for (KeySpec& key : keys) {
    if (key.bounds.empty()) key.bounds = words_of(key.interval);
    if (key.bounds.empty()) key.bounds = words_of(key.physical);
    const bool has_default =
        key.type() != KeyType::Map && key.value.get && !key.is_required();
    if (key.fallback.empty() && has_default) {
      key.fallback = written(key.value.get(fresh));
    }
  }
  return keys;
}

}  // namespace

std::span<const KeySpec> key_table() {
  static const Keys table = all_keys();
  return table;
}

}  // namespace brachisto::io
