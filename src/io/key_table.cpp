// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// key_table(): every key of a problem file, once.

#include <algorithm>
#include <iterator>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <utility>

#include "io/binding.hpp"
#include "io/lists.hpp"
#include "io/yaml_tree.hpp"
#include "model/limit_table.hpp"

namespace brachisto::io {

namespace {

using Keys = std::vector<KeySpec>;

constexpr double kMaxInt = std::numeric_limits<int>::max();

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
  return is_collocation(d) && d.uses_ipopt();
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
    // Under limits shooting has its arcs from a program.
    [](const Draft& d) {
      return !is_shooting(d) || d.scene.limits.any() ||
             d.scene.world.losses.any();
    });
constexpr auto kPlan = place([](auto& p) -> auto& { return p.work_precision; });
constexpr auto kDesign = place([](auto& p) -> auto& { return p.design; });

// Rules that several keys have.
KeyRules required() {
  return {.presence = Presence::Required};
}
KeyRules required_length() {
  return {.presence = Presence::Required, .unit = "m", .physical = kPositive};
}
KeyRules positive(std::string_view unit) {
  return {.unit = unit, .physical = kPositive};
}
KeyRules seconds() {
  return {.unit = "s", .interval = kPositive};
}
KeyRules within(double lower, double upper) {
  return {.interval = {lower, upper}};
}

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
  Binding binding = angle<kPath, &GivenPath::start_angle>();
  binding.number = [](const Draft& p, Binding::Row) {
    const auto& path = p.scene.path;
    return path && path->has_start_angle()
               ? std::optional(path->start_angle_or_vertical())
               : std::nullopt;
  };
  return binding;
}

/// The file of points, whose content is echoed in its place.
Binding points_file() {
  return {.type = KeyType::Text,
          .put_text = [](Draft& p, const std::string& name) {
            p.points_file = name;
            kPath.make(p);
          }};
}

/// A word, or in its place a map with the slope at B.
Binding contact() {
  Binding binding =
      choice<kScene, &Scene::contact>({{"smooth", Contact::Smooth},
                                       {"centre", Contact::Centre},
                                       {"optimal", Contact::Optimal}});
  binding.put = [](Draft& p, double word, Binding::Row) {
    p.scene.end_slope.reset();
    p.scene.contact = static_cast<Contact>(word);
  };
  return binding;
}

Binding end_slope() {
  Binding binding = angle<kScene, &Scene::end_slope>();
  binding.put = [](Draft& p, double slope, Binding::Row) {
    p.scene.contact = Contact::EndSlope;
    p.scene.end_slope = slope;
  };
  return binding;
}

constexpr bool has_force(const PathLimits& limits) {
  return limits.normal_min || limits.normal_max;
}
constexpr bool has_curvature(const PathLimits& limits) {
  const CurvatureLimit& curvature = limits.curvature;
  return curvature.hump || curvature.valley ||
         curvature.of != CurvatureLimit::Of::Track;
}
bool has_limits(const PathLimits& limits) {
  return limits.any() || has_curvature(limits);
}

constexpr auto limits = [](auto& p) -> auto& {
  return p.scene.limits;
};
constexpr auto kPathLimits = stated_place<has_limits>(limits);
constexpr auto kForce = stated_place<has_force>(limits);
constexpr auto kHasCurvature = stated_place<has_curvature>(limits);
constexpr auto kCurvature =
    place([](auto& p) -> auto& { return p.scene.limits.curvature; });

Interval interval_of(Allowed allowed) {
  switch (allowed) {
    case Allowed::Any:
      return {};
    case Allowed::Positive:
      return kPositive;
    case Allowed::NotNegative:
      return {.lower = 0.0};
    case Allowed::Fraction:
      return {.lower = 0.0, .upper = 1.0, .upper_allowed = false};
  }
  return {};
}

/// \param row  in limit_table()
Binding limit_number(std::size_t row) {
  return {.type = KeyType::Number,
          .number =
              [](const Draft& p, Binding::Row i) {
                return limit_table()[i].bound(p.scene.limits);
              },
          .put =
              [](Draft& p, double value, Binding::Row i) {
                limit_table()[i].bound_in(p.scene.limits) = value;
              },
          .row = row};
}

Keys limit_keys() {
  using Of = CurvatureLimit::Of;
  constexpr std::string_view kForces = "scene.limits.normal_force";
  constexpr std::string_view kCurvatures = "scene.limits.curvature";
  Keys keys{{"scene.limits", silent(map<kPathLimits>()),
             "what the motion has to keep to; see [Limits](#limits)"}};
  std::string_view group = keys.front().path;
  for (std::size_t row = 0; row < limit_table().size(); ++row) {
    const LimitEntry& limit = limit_table()[row];
    KeySpec key(limit.key, limit_number(row), limit.meaning,
                {.unit = limit.unit, .physical = interval_of(limit.allowed)});
    if (limit.allowed == Allowed::Fraction) key.bounds = "0 ≤ m < 1";
    if (key.parent() != group) {
      if (group == kCurvatures) {
        keys.emplace_back(
            "scene.limits.curvature.of",
            choice<kCurvature, &CurvatureLimit::of>(
                {{"track", Of::Track}, {"centre", Of::Centre}}),
            "whose curvature: of the track, or of the path of the centre");
      }
      group = key.parent();
      if (group == kForces) {
        keys.emplace_back(group, map<kForce>(),
                          "R_n, force of the track on the body across it");
      } else if (group == kCurvatures) {
        keys.emplace_back(
            group, map<kHasCurvature>(),
            "how sharply the track, or the path of the centre, may turn");
      }
    }
    keys.push_back(std::move(key));
  }
  keys.push_back(
      {"scene.limits.clear_of",
       clear_of_list(),
       "what the body must not touch: discs, and all that lies behind the line "
       "through a point, whose normal, from +x towards +z, points to where the "
       "body may be",
       {.bounds = "a list of {disc: {x, z, radius}} and {half_plane: {x, z, "
                  "normal}}"}});
  return keys;
}

bool has_field(const World& world) {
  return world.field_varies();
}
constexpr bool has_speed(const World& world) {
  return world.start_speed != 0.0;
}
bool has_air(const World& world) {
  return world.air.any();
}
bool has_losses(const World& world) {
  return world.losses.any();
}
constexpr auto world = [](auto& p) -> auto& {
  return p.scene.world;
};
constexpr auto kField = stated_place<has_field>(world);
constexpr auto kStart = stated_place<has_speed>(world);
constexpr auto kHasAir = stated_place<has_air>(world);
constexpr auto kHasLosses = stated_place<has_losses>(world);

/// \param row  in kWorldParameters
Binding world_number(std::size_t row) {
  return {.type = KeyType::Number,
          .number =
              [](const Draft& p, Binding::Row i) {
                const double* number = kWorldParameters[i].find(p.scene.world);
                return number ? std::optional(*number) : std::nullopt;
              },
          .put =
              [](Draft& p, double value, Binding::Row i) {
                const WorldParameter& parameter = kWorldParameters[i];
                World& into = p.scene.world;
                for (const FieldKind& kind : kFieldKinds) {
                  if (below(parameter.key, kind.key) && !kind.stands_in(into)) {
                    kind.put_into(into);
                  }
                }
                *parameter.find_in(into) = value;
              },
          .row = row};
}

/// A map of those numbers, where the world has its field.
/// \param row  in kFieldKinds
Binding field_map(std::size_t row) {
  return {.type = KeyType::Map,
          .number =
              [](const Draft& p, Binding::Row i) {
                return kFieldKinds[i].stands_in(p.scene.world)
                           ? std::optional(0.0)
                           : std::nullopt;
              },
          .row = row};
}

/// Gravity, which another field says in other words.
Binding gravity() {
  Binding binding = number<kScene, &Scene::gravity>();
  binding.number = [](const Draft& p, Binding::Row) {
    return has_field(p.scene.world) ? std::nullopt
                                    : std::optional(p.scene.gravity);
  };
  return binding;
}

/// The same by another name, under which it is not echoed.
Binding uniform_field() {
  Binding binding = number<kScene, &Scene::gravity>();
  binding.number = [](const Draft&, Binding::Row) {
    return std::optional<double>();
  };
  return silent(binding);
}

Keys world_keys() {
  Keys keys{
      {"scene.field", silent(map<kField>()),
       "what pulls the body; see [Other worlds](#other-worlds)"},
      {"scene.field.uniform", uniform_field(),
       "g, what `gravity` means: one of the two", positive("m/s²")},
      {"scene.start", silent(map<kStart>()), "how the motion begins"},
      {"scene.air", silent(map<kHasAir>()),
       "drag on the centre, against its motion: c_1 v + c_2 v² per mass"},
      {"scene.losses", silent(map<kHasLosses>()),
       "what the track takes in proportion to the load R_n; see "
       "[Losses](#losses)"},
  };
  auto at = keys.begin() + 2;
  for (std::size_t row = 0; row < std::size(kFieldKinds); ++row) {
    const FieldKind& kind = kFieldKinds[row];
    at = keys.insert(at, {kind.key, field_map(row), kind.meaning}) + 1;
    if (*kind.place == '\0') continue;
    at = keys.insert(
             at, {kind.place, field_map(row), kind.place_meaning, required()}) +
         1;
  }
  // Behind the last key of its map.
  for (std::size_t row = 0; row < std::size(kWorldParameters); ++row) {
    const WorldParameter& parameter = kWorldParameters[row];
    KeySpec key(parameter.key, world_number(row), parameter.meaning,
                {.presence = parameter.of_field ? Presence::Required
                                                : Presence::Optional,
                 .unit = parameter.unit,
                 .physical = interval_of(parameter.allowed)});
    const auto after =
        std::find_if(keys.rbegin(), keys.rend(), [&](const KeySpec& known) {
          return known.path == key.parent() || known.parent() == key.parent();
        });
    keys.insert(after.base(), std::move(key));
  }
  return keys;
}

/// What a ball runs in, which is made with the first of its keys.
constexpr auto kBall =
    optional_place([](auto& p) -> auto& { return p.scene.body.ball; });

template <std::optional<double> Ball::*number>
constexpr Place<Ball> ball_with() {
  Place<Ball> place = kBall;
  place.find = [](const Draft& p) -> const Ball* {
    const auto& ball = p.scene.body.ball;
    return ball && (*ball).*number ? &*ball : nullptr;
  };
  return place;
}
constexpr auto kRails = ball_with<&Ball::gauge>();
constexpr auto kRoundRails = ball_with<&Ball::rail_radius>();
constexpr auto kGroove = ball_with<&Ball::groove>();

/// Mass distributions that have names, in place of k, which is echoed.
Binding inertia() {
  Binding binding = choice<kBody, &Body::k>({{"disc", 1.0 / 2.0},
                                             {"ring", 1.0},
                                             {"ball", 2.0 / 5.0},
                                             {"hollow_ball", 2.0 / 3.0}});
  binding.number = nullptr;
  return binding;
}

Keys scene_keys() {
  using Curve = GivenPath::Curve;
  using Form = GivenPath::Shape;
  return {
      {"scene", map(), "what is to roll where", required()},
      {"scene.body", map(), "the body", required()},
      {"scene.body.shape",
       choice<kBody, &Body::shape>({{"cylinder", Shape::Cylinder},
                                    {"ball", Shape::Ball},
                                    {"bead", Shape::Bead}}),
       "a cylinder rolls without slip, a ball likewise, a bead slides",
       required()},
      {"scene.body.radius",
       number<kBody, &Body::radius>(),
       "r, radius of the cylinder; of a ball R",
       {.presence = Presence::RequiredOfCylinder,
        .unit = "m",
        .physical = kPositive}},
      {"scene.body.eta_m",
       number<kBody, &Body::eta_m>(),
       "η_m, distance of the centre of mass from the axis, in radii",
       {.presence = Presence::OptionalOfCylinder,
        .bounds = "0 ≤ η_m < 1",
        .physical = {.lower = 0.0, .upper = 1.0, .upper_allowed = false}}},
      {"scene.body.theta_m",
       angle<kBody, &Body::theta_m>(),
       "θ_m, direction from the axis to the centre of mass at the start, from "
       "+x towards +z (down)",
       {.presence = Presence::OptionalOfCylinder, .unit = "rad"}},
      {"scene.body.k",
       number<kBody, &Body::k>(),
       "k = I_cm/(m r²), moment of inertia about the centre of mass",
       {.presence = Presence::RequiredOfCylinder,
        .bounds = "0 ≤ k ≤ 1 − η_m²",
        .physical = {.lower = 0.0, .upper = 1.0}}},
      {"scene.body.inertia",
       inertia(),
       "in place of k: 1/2, 1, 2/5, 2/3",
       {.presence = Presence::OptionalOfCylinder}},
      {"scene.body.rails",
       silent(map<kRails>()),
       "the two rails a ball runs on; see [A ball on rails](#a-ball-on-rails)",
       {.presence = Presence::OptionalOfCylinder}},
      {"scene.body.rails.gauge", silent(number<kRails, &Ball::gauge>()),
       "b, between the edges of thin rails, or between the axes of round ones",
       required_length()},
      {"scene.body.rails.radius",
       silent(number<kRoundRails, &Ball::rail_radius>()),
       "ρ, of round rails; thin ones have none", positive("m")},
      {"scene.body.groove",
       silent(map<kGroove>()),
       "in place of rails: the groove a ball runs in",
       {.presence = Presence::OptionalOfCylinder}},
      {"scene.body.groove.angle",
       silent(angle<kGroove, &Ball::groove>()),
       "2γ, from wall to wall",
       {.presence = Presence::Required,
        .unit = "rad",
        .bounds = "between 0 and π",
        .physical = {.lower = 0.0,
                     .upper = std::numbers::pi,
                     .lower_allowed = false,
                     .upper_allowed = false}}},
      {"scene.body.parts",
       parts_list(),
       "what the body consists of, in place of eta_m, theta_m and k; see [A "
       "body from its parts](#a-body-from-its-parts)",
       {.presence = Presence::OptionalOfCylinder,
        .bounds = "a list of parts, as in [\"ring:m=2\", "
                  "\"point:m=1,at=0.3@-30deg\"]"}},
      {"scene.body.mass", number<kBody, &Body::mass>(),
       "m, only needed for forces in newtons", positive("kg")},
      {"scene.finish", map(), "the point B to be reached from A = (0, 0)",
       required()},
      {"scene.finish.L", number<kScene, &Scene::L>(),
       "L, horizontal distance from A to B", required_length()},
      {"scene.finish.H", number<kScene, &Scene::H>(), "H, drop from A to B",
       required_length()},
      {"scene.gravity", gravity(), "g, acceleration of gravity",
       positive("m/s²")},
      {"scene.contact", contact(),
       "whether A and B are points of the track, whose slopes there are the "
       "extremal's own (smooth), the best (optimal), or given at B (a map); or "
       "of the path of the centre"},
      {"scene.contact.end_slope",
       end_slope(),
       "slope angle of the track at B, downwards positive, in place of a word "
       "for contact",
       {.presence = Presence::Required,
        .unit = "rad",
        .bounds = "from −π to π",
        .physical = {-std::numbers::pi, std::numbers::pi}}},
      {"scene.path", map<kPath>(),
       "a given path, which is evaluated; without it the extremal is found"},
      {"scene.path.curve",
       choice<kPath, &GivenPath::curve>(
           {{"centre", Curve::Centre}, {"track", Curve::Track}}),
       "whose curve it is: the path of the centre, or the track from A to B"},
      {"scene.path.shape",
       choice<kPath, &GivenPath::shape>({{"straight", Form::Straight},
                                         {"parabola", Form::Parabola},
                                         {"circular_arc", Form::CircularArc},
                                         {"cycloid", Form::Cycloid},
                                         {"points", Form::Points}}),
       "a parabola has a horizontal axis if it starts vertically, a vertical "
       "one otherwise; a cycloid has its cusp at the start; points: a cubic "
       "spline",
       required()},
      {"scene.path.start_angle",
       start_angle(),
       "slope angle at the start of a parabola or a circular arc, downwards "
       "positive",
       {.unit = "rad", .fallback = "90 deg"}},
      {"scene.path.file",
       points_file(),
       "of points, in metres, from A to B; a relative name starts from the "
       "problem file's directory",
       {.bounds = "a CSV file with the columns x,z"}},
      {"scene.path.points",
       points_list(),
       "the points themselves, in place of a file",
       {.unit = "m", .bounds = "a list of points [x, z]"}},
  };
}

Keys discretisation_keys() {
  return {
      {"discretisation", map(), "wanted accuracy, or a fixed mesh"},
      {"discretisation.formulation",
       choice<kMesh, &Discretisation::formulation>(
           {{"rolling_time", Formulation::RollingTime},
            {"arc_length", Formulation::ArcLength}}),
       "how the problem is made finite. rolling_time: collocation; arc_length: "
       "the paper's variables, on straight pieces, of order 2"},
      {"discretisation.tolerance",
       shared<kMesh, &Discretisation::tolerance, kShooting,
              &Shooting::tolerance>(),
       "wanted relative error of the transit time; the mesh follows unless it "
       "is fixed. arc_length: 1e-9 or more, 1e-6 if absent. If absent, 1e-2 is "
       "enough on a fixed mesh, 1e-4 under limits where arcs are not found",
       {.fallback = "1e-10",
        .bounds = "from 1e-13 to 1e-1",
        .interval = {kSmallestTolerance, kLargestTolerance}}},
      {"discretisation.degree",
       number<kElements, &Discretisation::degree>(),
       "p, polynomial degree of an element; not for arc_length",
       {.fallback = "follows the tolerance, 5 on a fixed mesh",
        .interval = {kMinDegree, kMaxDegree}}},
      {"discretisation.elements",
       number<kMesh, &Discretisation::elements>(),
       "N, number of elements, of straight pieces for arc_length; fixes the "
       "mesh",
       {.bounds = "from 1 to 10 million", .interval = {1, kMaxElements}}},
      {"discretisation.nodes",
       shared<kMesh, &Discretisation::nodes, kSystem, &DiscreteSystem::nodes>(),
       "number of nodes, N p + 1, or N + 1 for arc_length; fixes the mesh in "
       "place of elements. With method: fsolve any n ≥ 3",
       {.fallback = "follows the tolerance, 100 with method: fsolve",
        .bounds = "from 2 to 80000001, and N p + 1",
        .interval = {2, kMaxNodes}}},
  };
}

Keys solver_keys() {
  const auto named = [](LinearSolver solver) {
    return std::pair{name(solver), solver};
  };
  return {
      {"solver", map(), "how the finite problem is solved"},
      {"solver.method",
       choice<kMethod, &Draft::method>({{"ipopt", MethodWord::Ipopt},
                                        {"newton_kkt", MethodWord::NewtonKkt},
                                        {"extremal", MethodWord::Extremal},
                                        {"fsolve", MethodWord::Fsolve},
                                        {"auto", MethodWord::Auto}}),
       "auto: scenes of a sweep whose free path keeps clear of all limits side "
       "by side by the indirect method, all others as ipopt; ipopt: "
       "collocation and a nonlinear program; newton_kkt: the same by "
       "Newton's method on its optimality conditions, from the continuation; "
       "extremal: Pontryagin's conditions by multiple shooting; fsolve: the "
       "paper's discrete system, for comparison, never verified"},
      {"solver.linear_solver",
       choice<kProgram, &Collocation::linear_solver>(
           {named(LinearSolver::Auto), named(LinearSolver::Mumps),
            named(LinearSolver::Chain)}),
       "what factorises the KKT matrix. chain: along the chain of elements; "
       "mumps: a general sparse solver; auto: chain where it is possible, "
       "mumps otherwise"},
      {"solver.threads", number<kProgram, &Collocation::threads>(),
       "that factorise a chain of thousands of elements; the digits are the "
       "same for any number",
       within(1, kMostThreads)},
      {"solver.tolerance", number<kProgram, &Collocation::tolerance>(),
       "largest scaled KKT residual of a solution",
       within(kSmallestResidual, kLargestResidual)},
      {"solver.search",
       choice<kCollocation, &Collocation::search>(
           {{"principal", Search::Principal}, {"global", Search::Global}}),
       "which extremal is the answer. principal: the one that continues from "
       "the cycloid as η_m grows from 0; global: of those that a search finds "
       "the fastest verified and feasible one"},
      {"solver.polish", yes_or_no<kProgram, &Collocation::polish>(),
       "last digits by Newton's method on the optimality conditions and the "
       "contact together"},
      {"solver.certify",
       choice<kProgram, &Collocation::certify>({{"none", Certify::None},
                                                {"extremal", Certify::Extremal},
                                                {"proof", Certify::Proof}}),
       "extremal: solve once more by multiple shooting and compare; proof: "
       "enclose the extremal, as `brachisto prove` does; of one scene"},
      {"solver.sensitivities",
       choice<kCollocation, &Collocation::sensitivities>(
           {{"false", SensitivityOrder::None},
            {"true", SensitivityOrder::First},
            {"second", SensitivityOrder::Second}}),
       "derivatives of the time by body and finish; second: those of second "
       "order too. Not for a given path"},
      {"solver.guess",
       choice<kColdStart, &Collocation::guess>({{"cycloid", Guess::Cycloid},
                                                {"straight", Guess::Straight},
                                                {"random", Guess::Random}}),
       "where a cold start begins; straight and random are tried in addition "
       "and reported, the answer does not depend on them"},
      {"solver.seed", number<kProgram, &Collocation::seed>(),
       "of the random guess", within(0, kMaxInt)},
      {"solver.limits", map(), "bounds on the work"},
      {"solver.limits.iterations", number<kIterations, &Limits::iterations>(),
       "of Ipopt, in all passes together; steps of Newton's method do not "
       "count",
       within(1, kMaxInt)},
      {"solver.limits.seconds", number<kLimits, &Limits::seconds>(),
       "wall-clock time", seconds()},
  };
}

/// What the paper leaves open of its discrete system.
Keys fsolve_keys() {
  using Quadrature = DiscreteReading::Quadrature;
  using Datum = DiscreteReading::Datum;
  using Slopes = DiscreteReading::Slopes;
  return {
      {"solver.fsolve", map<kSystem>(),
       "of method: fsolve, what the paper leaves open"},
      {"solver.fsolve.quadrature",
       choice<kReading, &DiscreteReading::quadrature>(
           {{"vmean", Quadrature::MeanSpeed},
            {"midpoint", Quadrature::Midpoint},
            {"trapezoid", Quadrature::Trapezoid}}),
       "time of a chord of length l: vmean, 2 l/(v + v') with the speeds at "
       "its ends; midpoint, l/v halfway; trapezoid, l (1/v + 1/v')/2"},
      {"solver.fsolve.datum",
       choice<kReading, &DiscreteReading::datum>({{"release", Datum::Release},
                                                  {"rest", Datum::Rest},
                                                  {"printed", Datum::Printed}}),
       "zero level of the energy: release, the first node; rest, A as printed "
       "but at rest in the first node; printed, A, which leaves no real speed "
       "there"},
      {"solver.fsolve.slopes",
       choice<kReading, &DiscreteReading::slopes>(
           {{"literal", Slopes::Literal}, {"smooth", Slopes::Smooth}}),
       "end slopes: literal, by Δz/Δx, which turns round with Δx; smooth, by "
       "Δx/l and Δz/l"},
      {"solver.fsolve.epsilon",
       number<kDifferences, &DiscreteReading::epsilon>(),
       "half width of the central differences in units of H, of variant "
       "hybrid; 0: exact derivatives",
       within(0.0, kLargestEpsilon)},
      {"solver.fsolve.variant",
       choice<kSystem, &DiscreteSystem::solver>(
           {{"hybrid", DiscreteSolver::Hybrid},
            {"newton", DiscreteSolver::Newton},
            {"lifted", DiscreteSolver::Lifted}}),
       "hybrid: Powell's method with a dense Jacobian by differences, as "
       "fsolve; newton: exact derivatives, dense; lifted: the same steps from "
       "a sparse system"},
  };
}

Keys work_precision_keys() {
  constexpr double kMostRepetitions = 1000;
  return {
      {"work_precision", map(),
       "what `brachisto work-precision` runs; other verbs read it and go their "
       "way"},
      {"work_precision.methods",
       methods_list(),
       "lines of the diagram; the arms of fsolve are rest, release (the hybrid "
       "method with either datum), newton and lifted, the first two if none is "
       "named",
       {.bounds = "a list of rolling_time, adaptive, arc_length, extremal, "
                  "fsolve, {rolling_time: [degrees]} and {fsolve: [arms]}"}},
      {"work_precision.meshes",
       meshes_list(),
       "points of each line: elements of rolling_time, pieces of arc_length, "
       "nodes of fsolve",
       {.bounds = "a list of integers from 2 to 1000000"}},
      {"work_precision.tolerances",
       tolerances_list(),
       "points of the line adaptive: wanted relative errors of T",
       {.bounds = "a list of numbers from 1e-13 to 0.1"}},
      {"work_precision.repetitions",
       number<kPlan, &WorkPrecisionPlan::repetitions>(),
       "timed runs of a point, of which the median counts; fewer where a run "
       "takes seconds",
       within(1, kMostRepetitions)},
      {"work_precision.seconds_per_point",
       number<kPlan, &WorkPrecisionPlan::seconds_per_point>(),
       "wall-clock time after which a point is given up", seconds()},
  };
}

constexpr auto kMaxGrip =
    optional_place([](auto& p) -> auto& { return p.design.max_grip; });

Keys design_keys() {
  using Minimised = DesignPlan::Minimised;
  return {
      {"design", map(),
       "which body `brachisto design` looks for; other verbs read it and go "
       "their way"},
      {"design.minimise",
       choice<kDesign, &DesignPlan::minimised>({{"tau", Minimised::Tau}}),
       "what the body is to make least: τ of its own extremal"},
      {"design.free",
       free_list(),
       "what the design chooses; what is not free stays as in scene.body",
       {.bounds = "a list of eta_m, theta_m, k and r, or of {part: 2, key: at} "
                  "and {part: 2, key: mass, bounds: [0.1, 2]}"}},
      {"design.bounds", map(),
       "least and greatest values of what is free; a body is within 0 ≤ k ≤ 1 "
       "− η_m² besides"},
      {"design.bounds.eta_m",
       bounds_list(BodyKey::EtaM),
       "of η_m; from 0 to 0.99 if absent",
       {.bounds = "two numbers from 0 to below 1"}},
      {"design.bounds.theta_m",
       bounds_list(BodyKey::ThetaM),
       "of θ_m; all directions if absent",
       {.unit = "rad", .bounds = "two angles from −2π to 2π"}},
      {"design.bounds.k",
       bounds_list(BodyKey::K),
       "of k; from 0 to 1 if absent",
       {.bounds = "two numbers from 0 to 1"}},
      {"design.bounds.r",
       bounds_list(BodyKey::Radius),
       "of the radius; required if it is free, the greatest below (L² + "
       "H²)/(2L)",
       {.unit = "m", .bounds = "two numbers > 0"}},
      {"design.require_feasible",
       yes_or_no<kDesign, &DesignPlan::require_feasible>(),
       "whether the body has to be able to run on its track, without lift-off "
       "and folds"},
      {"design.max_grip", silent(map<kMaxGrip>()),
       "friction that there is: a body that needs more counts as one that "
       "cannot run on its track"},
      {"design.max_grip.mu",
       number<kMaxGrip, &MaxGrip::mu>(),
       "μ: R_t from −μ R_n to μ R_n",
       {.presence = Presence::Required, .interval = kPositive}},
      {"design.max_grip.after",
       number<kMaxGrip, &MaxGrip::after>(),
       "share of the transit time from which on it is asked for; at a start "
       "from rest no friction would do",
       {.fallback = "0.01",
        .bounds = "0 ≤ share < 1",
        .interval = {.lower = 0.0, .upper = 1.0, .upper_allowed = false}}},
      {"design.starts", number<kDesign, &DesignPlan::starts>(),
       "searches: the first from scene.body, the others from random bodies",
       within(1, kMostDesignStarts)},
      {"design.seed", number<kDesign, &DesignPlan::seed>(),
       "of the random bodies", within(0, kMaxInt)},
      {"design.start",
       number<kDesign, &DesignPlan::start>(),
       "the one that is searched from, in place of all",
       {.bounds = "an integer from 1 to starts",
        .interval = {1, kMostDesignStarts}}},
  };
}

Keys all_keys() {
  Keys keys{
      {"version",
       {.type = KeyType::Integer, .put = [](Draft&, double, Binding::Row) {}},
       "of the file format",
       {.fallback = "1",
        .bounds = "1 (this program reads version 1)",
        .interval = {1, 1}}}};
  const auto add = [&](Keys part) {
    std::ranges::move(part, std::back_inserter(keys));
  };
  add(scene_keys());
  add(world_keys());
  add(limit_keys());
  add(discretisation_keys());
  add(solver_keys());
  add(fsolve_keys());
  keys.push_back({"sweep",
                  {.type = KeyType::Sweep},
                  "keys that vary, which makes one scene into many; see "
                  "[Sweeps](#sweeps)"});
  add(work_precision_keys());
  add(design_keys());
  keys.push_back({"constraints", {}, ""});

  // What is not said in words, the values say.
  Draft fresh;
  kPath.make(fresh);
  for (KeySpec& key : keys) key.complete(fresh);
  return keys;
}

}  // namespace

std::span<const KeySpec> key_table() {
  static const Keys table = all_keys();
  return table;
}

}  // namespace brachisto::io
