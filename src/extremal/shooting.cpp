// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "extremal/shooting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "extremal/arc_newton.hpp"
#include "extremal/continuation.hpp"
#include "math/enum_table.hpp"
#include "model/cycloid.hpp"
#include "model/inertia.hpp"
#include "model/world_part.hpp"

namespace brachisto {

std::string_view describe(ExtremalStatus status) {
  constexpr auto kSentences = table_by<ExtremalStatus>(
      "solved to the accuracy asked for",
      "an extremal was found, with fewer digits than asked for",
      "a centred body has no smooth contact from which to start",
      "the branch of extremals from the cycloid turns back before η_m",
      "the continuation from the cycloid got stuck before η_m",
      "Newton's method did not converge",
      "the equations cannot be integrated from the guess",
      "the extremal found has a loop, which is no track",
      "the body comes to rest on the extremal found",
      "the Hamiltonian is not minimal along the extremal found",
      "the time allowed ran out", "stopped from outside");
  return kSentences[status];
}

namespace {

using arcs::ArcSystem;
using arcs::BranchEnd;

/// Without limits, with the slopes of an extremal of its own at both ends: what
/// other contacts ask for there has a place only beside limits.
Scene as_free_scene(Scene scene) {
  if (scene.contact != Contact::Centre) scene.contact = Contact::Smooth;
  scene.end_slope.reset();
  scene.limits = {};
  return scene;
}

/// The guess as one free arc in natural units.
arcs::Guess as_arc(const ExtremalGuess& guess, const Units& units) {
  arcs::Guess out;
  out.arcs = {{.held = {}, .duration = guess.rolling_time / units.time}};
  out.state = [state = guess.state, units](std::size_t, double share) {
    const ExtremalState s = state(share);
    const double speed = units.speed();
    return arcs::State{s.x / units.length,
                       s.z / units.length,
                       s.theta,
                       s.w / speed,
                       s.beta,
                       s.p_x * speed,
                       s.p_z * speed,
                       s.p_theta / units.time,
                       s.p_w * speed / units.time,
                       0.0};
  };
  return out;
}

/// A solution in the making.
class Solve {
 public:
  /// \param scene, options  must outlive this
  Solve(const Scene& scene, const ExtremalOptions& options,
        const ExtremalGuess& guess)
      : scene_(scene),
        options_(options),
        units_(natural_units(scene)),
        natural_(as_free_scene(in_natural_units(scene))),
        system_(natural_, as_arc(guess, units_), options.arcs),
        point_(system_.start()) {
    solution_.arcs = system_.num_pieces();
  }

  /// Follows the branch from the cycloid, and into another world; false if it
  /// does not arrive.
  bool follow_from_cycloid() { return follow_offset() && follow_into_world(); }
  /// Newton's method to full accuracy, and the result.
  void finish();

  /// Runs `ways` of it within its own stop condition.
  template <class Ways>
  [[nodiscard]] ExtremalSolution within_its_stop(Ways&& ways) {
    const StopScope scope(options_.stop);
    try {
      ways();
    } catch (const Stopped&) {
      if (!options_.stop.met()) throw;
      fail(options_.stop.interrupted() ? ExtremalStatus::Interrupted
                                       : ExtremalStatus::TimeLimit,
           where_);
    }
    return std::move(solution_);
  }

 private:
  void fail(ExtremalStatus status, std::string_view details) {
    solution_.status = status;
    solution_.message = fmt::format("{}: {}", describe(status), details);
  }
  bool follow_offset();
  bool follow_into_world();
  /// To the last scene of a family; `where` is what a place of it is in words.
  [[nodiscard]] arcs::FollowedBranch follow(
      const arcs::Family& family,
      const std::function<std::string(double)>& where);
  /// What is known of ∂²𝓗/∂β² along a point of the branch, in words.
  [[nodiscard]] std::string legendre_at(const Scene& natural) const;
  void fill(const arcs::RefinedRoot& root, arcs::ArcPath path);
  /// What a path that meets the equations is worth.
  void judge();

  const Scene& scene_;
  const ExtremalOptions& options_;
  Units units_;
  Scene natural_;
  ArcSystem system_;
  ArcSystem::Point point_;  ///< to go on from
  std::string where_ = "at the start";
  ExtremalSolution solution_;
};

arcs::FollowedBranch Solve::follow(
    const arcs::Family& family,
    const std::function<std::string(double)>& where) {
  arcs::FollowedBranch branch =
      follow_branch(system_.in(family.scene(family.from)), point_, family,
                    [&](double parameter) { where_ = where(parameter); });
  solution_.newton_steps += branch.newton_steps;
  point_ = branch.point;
  return branch;
}

bool Solve::follow_offset() {
  const double target = natural_.body.eta_m;
  if (target == 0.0) return true;
  const auto with_offset = [scene = in_ordinary_world(natural_)](double eta) {
    Scene out = scene;
    out.body.eta_m = eta;
    return out;
  };
  const arcs::FollowedBranch branch =
      follow({.scene = with_offset,
              .from = 0.0,
              .to = target,
              .follow_folds = options_.follow_folds},
             [&](double eta) {
               return fmt::format("at η = {:.6g} of {:.6g}", eta, target);
             });
  ContinuationReport& report = solution_.continuation;
  report.folds = branch.folds;
  report.rejected_steps = branch.rejected_steps;
  for (const arcs::BranchPoint& at : branch.points) {
    report.points.push_back(
        {at.parameter, at.phi, at.transit_time * units_.time});
  }
  if (branch.end == BranchEnd::Reached) return true;
  if (branch.end == BranchEnd::NoStart) {
    fail(ExtremalStatus::NewtonFailed,
         "already at η = 0, where the cycloid should satisfy all conditions; "
         "try more arcs");
    return false;
  }
  const auto& [eta, phi, time] = branch.points.back();
  if (branch.end == BranchEnd::TurnsBack) {
    fail(ExtremalStatus::BranchTurnsBack,
         fmt::format("it turns at η = {:.6g} (φ = {:.4g}), below η_m = {:.6g};"
                     " beyond, the branch from the cycloid was not followed. "
                     "Try to follow the fold, a guess from a direct method, or "
                     "a smaller η_m",
                     report.folds.empty() ? eta : report.folds.front(), phi,
                     target));
  } else {
    fail(ExtremalStatus::StepTooSmall,
         fmt::format("at η = {:.6g} (φ = {:.4g}) of {:.6g} after {} points, "
                     "where {}; try more arcs than {}, or a guess from a "
                     "direct method",
                     eta, phi, target, report.points.size(),
                     legendre_at(with_offset(eta)), system_.num_pieces()));
  }
  return false;
}

bool Solve::follow_into_world() {
  if (natural_.world.ordinary()) return true;
  const auto where = [](double part) {
    return fmt::format(
        "{:.3g} of the way from the uniform field without air, from rest, into "
        "the world that is asked for",
        part);
  };
  const arcs::FollowedBranch branch = follow(
      {.scene = [this](double part) { return part_of_world(natural_, part); },
       .from = 0.0,
       .to = 1.0},
      where);
  if (branch.end == BranchEnd::Reached) return true;
  fail(ExtremalStatus::NewtonFailed,
       "beyond " +
           where(branch.points.empty() ? 0.0 : branch.points.back().parameter));
  return false;
}

// Where ∂²𝓗/∂β² reaches zero, extremals get corners and are not followed.
std::string Solve::legendre_at(const Scene& natural) const {
  const ExtremalPath path(natural, units_,
                          system_.in(natural).path(point_, {}));
  if (path.empty()) {
    return "the path cannot be integrated accurately, as happens when "
           "∂²𝓗/∂β² reaches zero along it";
  }
  return fmt::format("∂²𝓗/∂β² falls to {:.2g} along the path",
                     path.regularity().min_legendre);
}

void Solve::finish() {
  // The local error is well below the wanted accuracy of the whole.
  constexpr double kShare = 0.1, kTightest = 1e-15;
  const double wanted = std::max(options_.tolerance, 1e-14);
  const ocp::StepControl control{
      .tolerance = std::max(kShare * wanted, kTightest), .halve = false};
  where_ = "in Newton's method";
  const arcs::ArcRoot root =
      arcs::find_root(system_, point_, control, options_.max_newton_steps);
  solution_.newton_steps += root.steps;
  solution_.residual = root.residual;
  if (root.at.links.empty()) {
    return fail(
        ExtremalStatus::BadGuess,
        fmt::format("on arc {} of {} no slope makes 𝓗 minimal, or the step "
                    "became too small; try a guess nearer to an extremal, "
                    "or more arcs",
                    root.at.piece + 1, system_.num_pieces()));
  }
  if (!root.converged) {
    return fail(ExtremalStatus::NewtonFailed,
                fmt::format("after {} steps the residual is {:.1e}; try a "
                            "better guess, or more arcs",
                            root.steps, root.residual));
  }
  arcs::RefinedRoot refined;
  arcs::ArcPath path;
  if (arcs::refine_root(system_, root, control, refined)) {
    where_ = "on the way along the solution";
    path = system_.path(refined.point, {control.tolerance, true});
  }
  if (path.empty()) {
    return fail(ExtremalStatus::NewtonFailed,
                "the solution cannot be integrated again");
  }
  fill(refined, std::move(path));
  judge();
}

void Solve::fill(const arcs::RefinedRoot& root, arcs::ArcPath path) {
  solution_.transit_time = root.transit_time * units_.time;
  solution_.error_estimate = root.error_estimate;
  solution_.tau =
      solution_.transit_time * std::sqrt(2.0 * scene_.gravity / scene_.H);
  solution_.rolling_time = path.rolling_time() * units_.time;
  solution_.start_angle = path.arcs().front().knots.front().control;
  const arcs::Knot& last = path.arcs().back().knots.back();
  solution_.phi = last.control;
  // No-slip: S = r (θ_end − θ_m). For a bead θ counts arc length.
  const double turned = last.y(arcs::free_arc::kTheta) - natural_.body.theta_m;
  solution_.rotation = natural_.body.rolls() ? turned : 0.0;
  solution_.centre_path_length =
      turned / arcs::rotation_per_length(natural_) * units_.length;
  solution_.p_x = last.y(arcs::free_arc::kPX) / units_.speed();
  solution_.p_z = last.y(arcs::free_arc::kPZ) / units_.speed();
  solution_.integration_steps = root.at.steps;
  solution_.path = ExtremalPath(natural_, units_, std::move(path));
}

void Solve::judge() {
  Regularity& found = solution_.regularity;
  found = solution_.path.regularity();
  if (!found.keeps_moving()) {
    fail(ExtremalStatus::Stalls,
         fmt::format("its speed falls to {:.3g} of the largest; try another "
                     "guess",
                     found.min_w));
  } else if (!found.free_of_loops()) {
    fail(ExtremalStatus::Loop,
         fmt::format("its slope angle runs from {:.4g} to {:.4g}; try another "
                     "guess",
                     found.min_beta, found.max_beta));
  } else if (!found.legendre_holds()) {
    fail(ExtremalStatus::NotMinimal,
         fmt::format("∂²𝓗/∂β² falls to {:.3g}; try another guess",
                     found.min_legendre));
  } else if (!(solution_.error_estimate <=
               std::max(options_.tolerance, 1e-14))) {
    fail(ExtremalStatus::AccuracyNotReached,
         fmt::format("the relative error of T is about {:.1e} instead of "
                     "{:.1e}, because of rounding or a sharply bent path",
                     solution_.error_estimate, options_.tolerance));
  } else {
    solution_.status = ExtremalStatus::Solved;
    solution_.message = describe(ExtremalStatus::Solved);
  }
}

}  // namespace

bool ExtremalSolution::usable() const {
  constexpr double kWorthless = 1e-6;  // an error that settles nothing
  return solved() || (status == ExtremalStatus::AccuracyNotReached &&
                      error_estimate <= kWorthless);
}

ExtremalSolution solve_extremal(const Scene& scene, const ExtremalGuess& guess,
                                const ExtremalOptions& options) {
  Solve solve(scene, options, guess);
  return solve.within_its_stop([&] { solve.finish(); });
}

ExtremalSolution solve_extremal(const Scene& scene,
                                const ExtremalOptions& options) {
  const ExtremalGuess cycloid = cycloid_guess(in_ordinary_world(scene));
  if (!cycloid.state) {
    ExtremalSolution none;
    none.status = ExtremalStatus::NoCycloid;
    none.message = fmt::format(
        "{}: B lies inside it at its start, (L − r)² + H² ≤ r²; try a larger "
        "H or L, or a smaller radius",
        describe(none.status));
    return none;
  }
  Solve solve(scene, options, cycloid);
  return solve.within_its_stop([&] {
    if (solve.follow_from_cycloid()) solve.finish();
  });
}

// For constant A, ∂𝓗/∂β = 0 and 𝓗 = 0 say that the vector (w p_x, w p_z + g
// p_w) is −√A (cos β, sin β). With β = π/2 − ψ/2 and w = 2 √(g a) sin ψ/2 this
// gives p_x = −√A/(2 √(g a)); p_w(U) = 0 gives p_z = p_x cot(ψ_end/2).
ExtremalGuess cycloid_guess(const Scene& scene) {
  ExtremalGuess guess;
  const std::optional<CycloidArc> arc = axisymmetric_optimum(scene);
  if (!arc) return guess;
  const double g = scene.gravity;
  const double root = std::sqrt(axisymmetric_inertia_factor(scene.body));
  const double p_x = -root / (2.0 * std::sqrt(g * arc->a));
  const double p_z = p_x / std::tan(0.5 * arc->psi_end);
  const Body body = scene.body;

  guess.rolling_time = arc->rolling_time(g);
  guess.phi = arc->slope_angle(arc->psi_end);
  guess.state = [arc = *arc, body, g, root, p_x, p_z](double sigma) {
    const double psi = sigma * arc.psi_end;
    const Point centre = arc.at(psi);
    const double w = arc.fall_speed(g, psi);
    const double turned =
        body.rolls() ? arc.arc_length(psi) / body.radius : 0.0;
    return ExtremalState{.x = centre.x,
                         .z = centre.z,
                         .theta = body.theta_m + turned,
                         .w = w,
                         .p_theta = 0.0,
                         .p_w = -(root * std::cos(0.5 * psi) + w * p_z) / g,
                         .beta = arc.slope_angle(psi),
                         .t = root * sigma * arc.rolling_time(g),
                         .p_x = p_x,
                         .p_z = p_z};
  };
  return guess;
}

}  // namespace brachisto
