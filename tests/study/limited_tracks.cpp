// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Tracks under limits through solve(), against other methods, closed forms and
// laws.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "brachisto/io/problem_file.hpp"
#include "brachisto/study/solve.hpp"
#include "search/continuation.hpp"
#include "study/answer_kinds.hpp"
#include "support/limited_scenes.hpp"
#include "support/reference_values.hpp"

namespace brachisto {
namespace {

using namespace testing;

/// What the references and the solver's residuals may differ by besides the
/// estimated error of the mesh: conditions are solved to 1e-10 rad, the contact
/// moves τ by r √A/w < 1 per radian.
constexpr double kConditions = 1e-10;

double allowed(const Solution& solution) {
  return kConditions + *solution.estimated_error * solution.motion()->tau();
}

/// Each row is solved once for all its tests.
class LimitedTrack : public ::testing::TestWithParam<LimitedReference> {
 protected:
  static const Solution& solution() {
    static std::map<std::string, Solution> solved;
    const auto place = solved.find(GetParam().name);
    if (place != solved.end()) return place->second;
    return solved.emplace(GetParam().name, solve(GetParam().scene))
        .first->second;
  }
};

/// Also of the two rows whose own confirmation is coarse, floor_0.8 (6e-6) and
/// valley_2 (2e-7): the digits come from arcs closed to 2e-13 as in the others.
TEST_P(LimitedTrack, IsThatOfTheReference) {
  const LimitedReference& row = GetParam();
  const Solution& solution = this->solution();

  ASSERT_TRUE(solution.verified())
      << solution.message
      << ::testing::PrintToString(solution.not_verified_because());
  EXPECT_TRUE(solution.feasible());
  EXPECT_NEAR(solution.motion()->tau(), row.tau, allowed(solution));
  // The slope moves with the square root of what τ is known to where contacts
  // are optimal; there nine decimals are given.
  if (row.end_angle) {
    EXPECT_NEAR(solution.motion()->end_angle(), *row.end_angle, 1e-8);
  }
  if (row.start_angle) {
    EXPECT_NEAR(solution.motion()->start_angle(), *row.start_angle, 1e-8);
  }
  ASSERT_FALSE(solution.limits.empty());
  EXPECT_TRUE(std::any_of(
      solution.limits.begin(), solution.limits.end(),
      [](const LimitOnPath& limit) { return !limit.active.empty(); }));
}

/// Central second differences in time of the centre of mass: the force of the
/// track, from places and times alone. Rounding leaves ε/h², the next term h².
struct Force {
  double normal, tangential;
};
Force force_by_differences(const Motion& motion, double sigma, double h) {
  const TrajectoryPoint a = motion.at(sigma - h);
  const TrajectoryPoint b = motion.at(sigma);
  const TrajectoryPoint c = motion.at(sigma + h);
  const double before = b.t - a.t, after = c.t - b.t;
  const auto second = [&](double p, double q, double s) {
    return 2.0 * ((s - q) / after - (q - p) / before) / (before + after);
  };
  const double g = motion.scene().gravity;
  const double x = second(a.motion.mass_centre.x, b.motion.mass_centre.x,
                          c.motion.mass_centre.x) /
                   g;
  const double z = second(a.motion.mass_centre.z, b.motion.mass_centre.z,
                          c.motion.mass_centre.z) /
                       g -
                   1.0;
  return {x * std::sin(b.beta) - z * std::cos(b.beta),
          x * std::cos(b.beta) + z * std::sin(b.beta)};
}

/// The motion's places are on one element, so that nothing jumps between them.
TEST_P(LimitedTrack, IsPressedAndFollowsNewtonsLaw) {
  const LimitedReference& row = GetParam();
  const Solution& solution = this->solution();
  ASSERT_TRUE(solution.verified());
  const auto* answer = answer_as<LimitedPathAnswer>(solution.answer);
  ASSERT_NE(answer, nullptr);
  const LimitedMotion& motion = answer->motion;
  const Mesh& mesh = motion.curve().problem().mesh();
  // ε T²/h² and h² of a path that varies on a tenth of T.
  constexpr double kStep = 1e-3, kForce = 2e-3;

  for (int e = 1; e < mesh.num_elements(); ++e) {
    if (mesh.length(e) < 4.0 * kStep) continue;
    const double sigma =
        mesh.boundaries[static_cast<std::size_t>(e)] + 0.5 * mesh.length(e);
    const Kinematics said = motion.at(sigma).motion;
    const Force found = force_by_differences(motion, sigma, kStep);

    EXPECT_NEAR(said.R_n, found.normal, kForce * (1.0 + said.R_n)) << sigma;
    EXPECT_NEAR(said.R_t, found.tangential, kForce * (1.0 + said.R_n)) << sigma;
    EXPECT_GT(found.normal, 0.0) << sigma;
    if (const auto mu = row.scene.limits.friction) {
      EXPECT_LE(std::abs(found.tangential), *mu * found.normal + kForce)
          << sigma;
    }
  }
}

/// On both sides of junctions, where forces jump, and at the start. Next to the
/// place of the least one R_n changes by no more than 20 per unit of σ.
TEST(LeastSlacks, AreThoseOfAFineGrid) {
  constexpr int kPlaces = 20000;
  constexpr double kBetween = 20.0 / kPlaces, kRounding = 1e-9;
  for (const char* file :
       {"/limits/coaster_with_a_push.yaml", "/losses/bead_sliding.yaml"}) {
    const io::ProblemFile problem =
        io::read_problem_file(std::string(BRACHISTO_PROBLEMS_DIR) + file);
    const Solution solution = solve(problem.scene, problem.options);
    ASSERT_TRUE(solution.verified()) << file;
    const auto limit = std::ranges::find(solution.limits, "normal_force.min",
                                         &LimitOnPath::name);
    ASSERT_NE(limit, solution.limits.end()) << file;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= kPlaces; ++i) {
      const double sigma = static_cast<double>(i) / kPlaces;
      least = std::min(least, solution.motion()->at(sigma).motion.R_n);
    }

    EXPECT_LE(limit->least_slack, least - *limit->bound + kRounding) << file;
    EXPECT_GE(limit->least_slack, least - *limit->bound - kBetween) << file;
  }
}

/// Friction asks for pressure, so that a body under it never lifts off.
TEST_P(LimitedTrack, KeepsItsForcesOnAFineGrid) {
  const PathLimits& limits = GetParam().scene.limits;
  const Solution& solution = this->solution();
  ASSERT_TRUE(solution.verified());
  // What limits may be exceeded by between the points of an element.
  constexpr double kBetween = 1e-8;
  const auto rows = solution.motion()->fine_sample(4000);

  for (std::size_t i = 1; i < rows.size(); ++i) {
    const Kinematics& here = rows[i].motion;
    EXPECT_GE(here.R_n, limits.normal_min.value_or(0.0) - kBetween)
        << rows[i].sigma;
    if (!limits.friction) continue;
    EXPECT_LE(std::abs(here.R_t), *limits.friction * here.R_n + kBetween)
        << rows[i].sigma;
  }
}

TEST_P(LimitedTrack, ConservesEnergyFromContactToContact) {
  const LimitedReference& row = GetParam();
  const Body& body = row.scene.body;
  const Solution& solution = this->solution();
  ASSERT_TRUE(solution.verified());
  const Motion& motion = *solution.motion();
  const auto rows = motion.fine_sample(500);
  constexpr double kDrift = 1e-9;

  for (const TrajectoryPoint& p : rows) {
    const double factor = 1.0 + body.eta_m * body.eta_m + body.k -
                          2.0 * body.eta_m * std::sin(p.theta - p.beta);
    const double fallen =
        p.motion.mass_centre.z - rows.front().motion.mass_centre.z;
    EXPECT_NEAR(0.5 * factor * p.motion.v_c * p.motion.v_c,
                row.scene.gravity * fallen, kDrift * row.scene.gravity)
        << p.sigma;
  }
  // Slopes are found to 1e-3 of the square root of the tolerance of T, 1e-10:
  // the centre is where φ has it, and the contact is off by r times what the
  // slope at the end is.
  const double place = 1e-10 + 1e-8 * body.radius;
  EXPECT_NEAR(rows.front().motion.contact.x, 0.0, place);
  EXPECT_NEAR(rows.front().motion.contact.z, 0.0, place);
  EXPECT_NEAR(rows.back().motion.contact.x, row.scene.L, place);
  EXPECT_NEAR(rows.back().motion.contact.z, row.scene.H, place);
  for (const LimitOnPath& limit : solution.limits) {
    EXPECT_GE(limit.least_slack, 0.0) << limit.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Rows, LimitedTrack,
                         ::testing::ValuesIn(limited_references()),
                         [](const auto& row) {
                           std::string name = row.param.name;
                           std::replace(name.begin(), name.end(), '.', '_');
                           return name;
                         });

/// The estimate is of the mesh alone, the closed forms have no error.
void expect_track(const Scene& scene, const ClosedTrack& closed,
                  const std::string& what) {
  const Solution solution = solve(scene);

  ASSERT_TRUE(solution.verified()) << what << ": " << solution.message;
  EXPECT_NEAR(solution.motion()->tau(), closed.tau, allowed(solution)) << what;
  EXPECT_NEAR(solution.motion()->end_angle(), closed.end_angle, 1e-8) << what;
}

TEST(ClosedForms, OfAFloorAreACycloidALineAndTheSameCycloid) {
  EXPECT_NEAR(closed_on_floor(bead_scene(), 1.0).tau, 3.0 + 0.5 * kPi, 1e-15);
  for (const double D : {1.0, 1.05, 1.2}) {
    expect_track(under(bead_scene(), floor_at(D)),
                 closed_on_floor(bead_scene(), D),
                 "bead above " + std::to_string(D));
  }
  for (const double D : {1.1, 1.25}) {
    const Scene scene = uniform_scene();
    expect_track(under(scene, floor_at(D)),
                 closed_on_floor(scene, D - scene.body.radius),
                 "cylinder above " + std::to_string(D));
  }
}

/// A floor that the free path enters by 1e-6 to 2e-5 m, next to an end of an
/// element, between the last places that are looked at. The arcs are 6e-7 to
/// 1e-5 of the track.
TEST(ClosedForms, OfAFloorThatIsBarelyEnteredAreMet) {
  Scene scene = uniform_scene();
  scene.body = Body::cylinder(0.2, 0.0, 0.0, 0.5);
  scene.L = 4.0;
  scene.H = 0.3;
  for (const double D :
       {1.3726798919435175, 1.3726708919435173, 1.3726620949669883}) {
    const Solution solution = solve(under(scene, floor_at(D)));

    ASSERT_TRUE(solution.verified()) << D;
    EXPECT_NEAR(solution.motion()->tau(),
                closed_on_floor(scene, D - scene.body.radius).tau,
                allowed(solution))
        << D;
    EXPECT_LT(*solution.estimated_error, 1e-12) << D;
    ASSERT_EQ(solution.limits.at(0).active.size(), 1u) << D;
    // Where the floor is a little higher, by differences of the closed form.
    const double step = 1e-6;
    const double slope =
        (closed_on_floor(scene, D - step - scene.body.radius).tau -
         closed_on_floor(scene, D - 2.0 * step - scene.body.radius).tau) /
        step;
    EXPECT_NEAR(*solution.limits.at(0).price, slope, 1e-3 * std::abs(slope));
  }
}

/// Its slopes at A and B cost it nothing.
TEST(LimitedTracks, OfABeadWithOptimalContactsIsThatWithSmoothOnes) {
  for (const double D : {1.0, 5.0}) {
    Scene scene = under(bead_scene(), floor_at(D));
    const Solution smooth = solve(scene);
    scene.contact = Contact::Optimal;
    const Solution optimal = solve(scene);
    ASSERT_TRUE(smooth.verified() && optimal.verified()) << optimal.message;
    EXPECT_EQ(smooth.motion()->tau(), optimal.motion()->tau());
  }
}

/// From what an incline to B needs, 1/9, on.
TEST(ClosedForms, OfFrictionAreTheSteepestInclineThatGripsAndACycloid) {
  for (const double mu : {0.1115, 0.112, 0.2, 0.3, 0.5, 1.0, 2.0}) {
    const Scene scene = uniform_scene();
    expect_track(under(scene, friction(mu)),
                 closed_incline(scene, static_slope(scene.body, mu)),
                 "friction " + std::to_string(mu));
  }
}

TEST(ClosedForms, OfALeastForceAreTheInclineThatPressesSoMuchAndACycloid) {
  for (const Scene& scene : {bead_scene(), uniform_scene()}) {
    for (const double R_n : {0.05, 0.1, 0.5}) {
      expect_track(under(scene, least_force(R_n)),
                   closed_incline(scene, std::acos(R_n)),
                   "force " + std::to_string(R_n));
    }
  }
}

/// Whether the coarsest of these pass for a picture of the path is another
/// question: between the points of an element they exceed limits by 1e-6.
TEST(LimitedMeshes, DoNotChangeTheAnswer) {
  for (const char* name : {"friction_0.6", "floor_0.9", "optimal_K2"}) {
    const LimitedReference row = limited_reference(name);
    for (const int elements : {40, 80}) {
      SolveOptions options;
      auto& mesh = options.use<Collocation>().discretisation;
      mesh.degree = 5;
      mesh.elements = elements;

      const Solution solution = solve(row.scene, options);

      ASSERT_EQ(solution.status, Status::Solved)
          << row.name << ": " << solution.message;
      ASSERT_NE(solution.motion(), nullptr);
      EXPECT_NEAR(solution.motion()->tau(), row.tau, allowed(solution))
          << row.name << ", " << elements;
      EXPECT_EQ(solution.program()->nodes, 5 * elements + 1);
    }
  }
}

/// So the estimate is the error, but for that of the few, 1e-11 at most.
TEST(LimitedMeshes, OfManyElementsAreJudgedByFew) {
  constexpr double kOfFew = 1e-11;
  const LimitedReference row = limited_reference("uniform_friction_0.5");
  for (const int degree : {1, 2, 5}) {
    SolveOptions options;
    auto& mesh = options.use<Collocation>().discretisation;
    mesh.degree = degree;
    mesh.elements = 1000;

    const Solution solution = solve(row.scene, options);

    ASSERT_EQ(solution.status, Status::Solved) << solution.message;
    const Check* agreement = solution.certificate.find("agreement");
    ASSERT_NE(agreement, nullptr);
    EXPECT_NE(agreement->where.find("1000 elements of degree " +
                                    std::to_string(degree) + " against"),
              std::string::npos)
        << agreement->where;
    const double error = std::abs(solution.motion()->tau() / row.tau - 1.0);
    EXPECT_LE(error, *solution.estimated_error + kConditions / row.tau);
    // Relative to the time found, not to the true one.
    EXPECT_NEAR(*solution.estimated_error, error,
                2.0 * kOfFew + 2.0 * error * error)
        << degree;
  }
}

/// A steep start is what friction forbids however great it is, since the force
/// vanishes there: τ(μ) = τ − 0.032/μ to first order.
TEST(LimitedLaws, FrictionWithoutBoundLeavesTheFreeTrack) {
  const double free = reference("reference_case").tau;
  double before = 0.0;
  for (const double mu : {3.0, 30.0, 1000.0}) {
    const Solution solution = solve(under(off_centred_scene(), friction(mu)));

    ASSERT_TRUE(solution.verified()) << mu << ": " << solution.message;
    const double scaled = mu * (free - solution.motion()->tau());
    EXPECT_GT(scaled, before) << mu;
    before = scaled;
  }
  // Half a unit of the last digit that is known of the constant.
  EXPECT_NEAR(before, 0.032, 0.0005);
}

/// Where slopes at the contacts are optimal the valley's bound is what keeps
/// the end from bending into a point: τ → inf V = 4.55233 like 1/K, from an
/// exponent below 1 because the start's arc adds a higher power.
TEST(LimitedLaws, SharperValleysApproachTheInfimumLikeOneOverTheirCurvature) {
  constexpr double kInfimum = 4.55233;
  std::vector<double> above;
  for (const double K : {20.0, 40.0, 80.0}) {
    const Solution solution =
        solve(under(off_centred_scene(), bends(2.9, K), Contact::Optimal));
    ASSERT_TRUE(solution.verified()) << K << ": " << solution.message;
    above.push_back(solution.motion()->tau() - kInfimum);
  }

  double before = 0.0;
  for (std::size_t i = 1; i < above.size(); ++i) {
    const double order = std::log2(above[i - 1] / above[i]);
    EXPECT_GT(order, before);
    before = order;
  }
  EXPECT_NEAR(before, 1.0, 0.1);
}

/// A stone under the free track lifts the body, which then falls faster than a
/// track could take it: an optimum that no track presses.
TEST(LimitedTracks, ThatLiftTheBodyOffAreVerifiedAndNotFeasible) {
  PathLimits stone;
  stone.discs = {{{1.5, 1.4}, 0.1}};

  const Solution solution = solve(under(off_centred_scene(), stone));

  ASSERT_TRUE(solution.verified()) << solution.message;
  ASSERT_EQ(solution.infeasible_because().size(), 1u);
  const std::string reason = solution.infeasible_because().front();
  EXPECT_NE(reason.find("would lift off"), std::string::npos) << reason;
  EXPECT_NE(reason.find("normal_force: {min: 0}"), std::string::npos) << reason;
}

/// The larger a bound, the nearer the track is to the free one. At A friction
/// holds however large μ is, and takes some 0.04/μ of τ.
TEST(LimitedTracks, ThatNumbersHardlyBoundAreTheFreeOnes) {
  Scene bead = off_centred_scene();
  bead.body = Body::bead();
  const Solution free_bead = solve(bead), free = solve(off_centred_scene());
  for (const double bound : {1e4, 1e9, 1e15}) {
    const Solution solution = solve(under(bead, bends(bound, bound)));
    ASSERT_TRUE(solution.verified()) << bound << ": " << solution.message;
    EXPECT_NEAR(solution.motion()->tau(), free_bead.motion()->tau(), 1e-12);
  }
  for (const double mu : {1e5, 1e7, 1e9, 1e12}) {
    const Solution solution = solve(under(off_centred_scene(), friction(mu)));
    ASSERT_TRUE(solution.verified()) << mu << ": " << solution.message;
    EXPECT_TRUE(solution.feasible()) << mu;
    EXPECT_NEAR(solution.motion()->tau(), free.motion()->tau(),
                0.1 / mu + allowed(solution));
  }
}

/// Friction and linear drag c from rest let the slope rise like the speed, by
/// b c v: the track folds for every c, for the more of its way back, b² c², the
/// greater c is, and its curvature at A is −1/r.
TEST(LimitedTracks, FoldByAsMuchAsDragBendsThem) {
  Scene scene = off_centred_scene();
  scene.body.eta_m = 0.0;
  scene.limits.friction = 0.4;
  const auto in_air = [&](double c) {
    scene.world.air.linear = c;
    return solve(scene);
  };

  std::vector<double> back;
  for (const double c : {0.5, 1.0, 1e-6}) {
    const Solution solution = in_air(c);
    ASSERT_TRUE(solution.verified()) << c << ": " << solution.message;
    const PathDiagnostics& path = *solution.diagnostics;
    EXPECT_NEAR(path.at_start.curvature, -1.0 / scene.body.radius, 1e-12);
    EXPECT_EQ(solution.feasible(), c < 1e-3);
    back.push_back(path.folds_back);
  }

  EXPECT_NEAR(std::log2(back[1] / back[0]), 2.0, 0.05);
  EXPECT_LT(back[2], 1e-12);
}

/// Drag on the axis has no share in what presses a uniform body: where a least
/// load holds from rest the track begins straight.
TEST(LimitedTracks, BeginStraightWhereDragHasNoShareInALoad) {
  Scene scene = off_centred_scene();
  scene.body.eta_m = 0.0;
  scene.limits.normal_min = 0.5;
  scene.world.air.linear = 1.0;

  const Solution solution = solve(scene);

  ASSERT_TRUE(solution.verified()) << solution.message;
  EXPECT_NEAR(solution.diagnostics->at_start.curvature, 0.0, 1e-9);
  EXPECT_NEAR(solution.diagnostics->at_start.fold_margin, 1.0, 1e-9);
}

/// While friction holds the control no arc can stay on the floor: the body
/// reaches it at one point, where its centre moves along it.
TEST(LimitedTracks, TouchAFloorThatFrictionKeepsThemFromFollowing) {
  constexpr double kFloor = 1.59;
  Scene scene = off_centred_scene();
  scene.body = Body::cylinder(1.0 / 3.0, 0.8, -0.5, 0.3);
  scene.L = 5.0;
  scene.limits.friction = 0.9;
  scene.limits.floor = kFloor;

  const Solution solution = solve(scene);

  ASSERT_TRUE(solution.verified()) << solution.message;
  const LimitOnPath& floor = solution.limits.at(1);
  ASSERT_EQ(floor.active.size(), 1u);
  EXPECT_EQ(floor.active[0].sigma.from, floor.active[0].sigma.to);
  const Motion& motion = *solution.motion();
  const double touched = floor.active[0].sigma.from;
  const double r = scene.body.radius;
  EXPECT_NEAR(motion.at(touched).centre.z + r, kFloor, 1e-10);
  // The place is found by differences of order four over 1e-2 of an element,
  // which leave 1e-9 of the turn on it.
  EXPECT_NEAR(motion.at(touched).beta, 0.0, 1e-9);
  constexpr int kPlaces = 4000;
  for (int i = 0; i <= kPlaces; ++i) {
    const double sigma = static_cast<double>(i) / kPlaces;
    EXPECT_LE(motion.at(sigma).centre.z + r, kFloor + 1e-8) << sigma;
  }
}

/// Friction that the floor asks for too much of at the end of its arc: the body
/// leaves it in good time and touches it once more.
TEST(LimitedTracks, LeaveAFloorBeforeFrictionDoesNotFollowIt) {
  Scene scene = under(off_centred_scene(), friction(0.4));
  scene.limits.floor = 1.0 + 0.7 / 3.0;

  const Solution solution = solve(scene);

  ASSERT_TRUE(solution.verified()) << solution.message;
  const Motion& motion = *solution.motion();
  constexpr int kPlaces = 4000;
  for (int i = 1; i <= kPlaces; ++i) {
    const TrajectoryPoint at = motion.at(static_cast<double>(i) / kPlaces);
    EXPECT_LE(at.centre.z + scene.body.radius, *scene.limits.floor + 1e-8);
    EXPECT_LE(std::abs(at.motion.R_t),
              *scene.limits.friction * at.motion.R_n + 1e-8);
  }
}

/// So early on the way the body has fallen through a millionth of the height
/// that the error of its place is told in: the motion integrated again from
/// there was off by more than the solution.
/// Next to where friction ceases to bound the turn a fit's steps lead to where
/// the body does not move on: it gives up, in words.
TEST(LimitedTracks, AreGivenUpInWordsWhereStepsLeadToRest) {
  PathLimits limits = friction(0.16);
  limits.curvature = {
      .hump = 20.0, .valley = 20.0, .of = CurvatureLimit::Of::Centre};
  SolveOptions options;
  options.limits.iterations = 200;

  const Solution solution = solve(under(off_centred_scene(), limits), options);

  EXPECT_NE(solution.status, Status::Solved);
  EXPECT_FALSE(solution.message.empty());
}
/// No bound of valleys lets the path set out like the free one, whose curvature
/// is infinite at rest: the arc there, of a length like 1/K², costs a time like
/// 1/K, with a next term that is smaller by that factor again.
TEST(LimitedTracks, KeepBoundsOfValleysFromRestOnHoweverSharpTheseAre) {
  const Scene base = off_centred_scene();
  const double free = solve(base).motion()->tau();
  const auto cost = [&](double K) {
    const Solution solution = solve(under(base, bends({}, K)));
    EXPECT_TRUE(solution.verified()) << K << ": " << solution.message;
    EXPECT_FALSE(solution.limits.front().active.empty()) << K;
    return K * (free - solution.motion()->tau());
  };
  const double sharp = cost(1e3), sharper = cost(1e4);
  EXPECT_NEAR(sharp, sharper, 1e-2 * sharper);
  EXPECT_NEAR(cost(700.0), sharper, 2e-2 * sharper);
}

/// A free path leaves rest where the normal force vanishes, outside every cone.
/// An arc along which even this friction is too little would have 1e-6 of it,
/// and is left out.
TEST(LimitedTracks, AreNotAnsweredByAnExtremalThatSlipsAtRest) {
  const SolveOptions shooting{.method = Shooting{}};
  const Solution solution =
      solve(under(uniform_scene(), friction(1e5)), shooting);
  EXPECT_FALSE(solution.verified());
  EXPECT_NE(solution.message.find("holds at A alone"), std::string::npos)
      << solution.message;
}

/// What holds at A alone turns the contact there, and T with it: shooting knows
/// so much of it that it may confirm the program.
TEST(LimitedTracks, WithALimitAtAAloneAreConfirmedByShooting) {
  SolveOptions options;
  options.use<Collocation>().certify = Certify::Extremal;
  for (const double least : {1e-8, 1e-7, 1e-6}) {
    Scene scene = uniform_scene();
    scene.limits.normal_min = least;

    const Solution solution = solve(scene, options);

    ASSERT_TRUE(solution.verified()) << least;
    ASSERT_TRUE(solution.extremal);
    EXPECT_LT(solution.extremal->difference, 1e-13) << least;
    // It has a price, and so a place.
    const LimitOnPath& limit = solution.limits.at(0);
    EXPECT_LT(*limit.price, -1e-3);
    ASSERT_EQ(limit.active.size(), 1u);
    EXPECT_EQ(limit.active[0].sigma.to, 0.0);
    // At rest R_n = cos β of the contact's slope.
    EXPECT_NEAR(std::cos(solution.motion()->start_angle()), least, 1e-12);
  }
}

/// From one scene to the next an arc is born (at μ = 0.26154), two become one
/// (at 0.2803) and one reaches B (at 0.5102).
TEST(LimitedTracks, AreFollowedFromANeighbourThroughBirthsOfArcs) {
  for (const auto& [from, to] :
       {std::pair{0.27, 0.255}, std::pair{0.285, 0.275},
        std::pair{0.49, 0.55}}) {
    const Solution near = solve(under(off_centred_scene(), friction(from)));
    ASSERT_TRUE(near.verified()) << near.message;
    const auto neighbour = near.as_neighbour();
    ASSERT_TRUE(neighbour);
    const Scene scene = under(off_centred_scene(), friction(to));

    const Solution beside = solve(scene, {}, {.neighbour = neighbour.get()});
    const Solution alone = solve(scene);

    ASSERT_TRUE(beside.verified()) << from << " to " << to;
    EXPECT_EQ(beside.effort.iterations, 0) << "of Ipopt";
    EXPECT_NEAR(beside.motion()->tau(), alone.motion()->tau(),
                allowed(beside) + allowed(alone));
  }
}

TEST(LimitedTracks, AreFollowedFromAnotherBodyAndFinish) {
  const Scene scene = under(off_centred_scene(), friction(0.5));
  Scene other = scene;
  other.body.eta_m = 0.64;
  other.L = 3.1;
  const auto neighbour = solve(other).as_neighbour();
  ASSERT_TRUE(neighbour);

  const Solution beside = solve(scene, {}, {.neighbour = neighbour.get()});

  ASSERT_TRUE(beside.verified()) << beside.message;
  EXPECT_EQ(beside.effort.iterations, 0) << "of Ipopt";
  EXPECT_NEAR(beside.motion()->tau(), 5.083389161786, allowed(beside));
}

TEST(LimitedTracks, AreNotFollowedFromWhatIsNoNeighbour) {
  const Scene scene = under(off_centred_scene(), friction(1.0));
  Scene near = scene;
  near.limits.friction = 1.05;
  const Neighbour sound = *solve(near).as_neighbour();
  const auto unused = [&](auto spoil) {
    Neighbour neighbour = sound;
    spoil(neighbour);
    const Solution solution = solve(scene, {}, {.neighbour = &neighbour});
    ASSERT_TRUE(solution.verified()) << solution.message;
    EXPECT_GT(solution.effort.iterations, 0) << "of Ipopt, from the cycloid";
  };
  unused([](Neighbour& n) { n.arcs.clear(); });
  unused([](Neighbour& n) { n.arcs.pop_back(); });
  unused([](Neighbour& n) { n.arcs[0].held.pop_back(); });
  unused([](Neighbour& n) { n.arcs[0].end = 2.0; });
  unused([](Neighbour& n) { std::ranges::reverse(n.arcs[0].cuts); });
  unused([](Neighbour& n) { n.arcs[0].touch = Touch{7, nlp::Held::AtUpper}; });
  unused([](Neighbour& n) { n.mesh.degree = -2; });
  unused([](Neighbour& n) { n.point.x.pop_back(); });
  unused([](Neighbour& n) { n.point.x[5] = std::nan(""); });
  unused([](Neighbour& n) { n.point.lambda.push_back(0.0); });
  unused([](Neighbour& n) { n.scene.H = -1.0; });
  unused([](Neighbour& n) { n.scene.limits.floor = 5.0; });
}

TEST(LimitedTracks, AreFollowedFromRestAsExactlyAsTheyAreSolved) {
  Scene scene = off_centred_scene();
  scene.body = Body::cylinder(0.574078, 0.591831, 0.247771, 0.620089);
  scene.L = 2.347915;
  scene.limits.normal_max = 2.332785;

  const Solution solution = solve(scene);

  EXPECT_TRUE(solution.verified())
      << ::testing::PrintToString(solution.not_verified_because());
}

}  // namespace
}  // namespace brachisto
