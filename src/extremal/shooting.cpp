// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "extremal/shooting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "extremal/boundary.hpp"
#include "extremal/continuation.hpp"
#include "extremal/extremal_attempt.hpp"
#include "extremal/world_shooting.hpp"
#include "model/cycloid.hpp"
#include "model/inertia.hpp"
#include "model/start_angle.hpp"
#include "model/world_part.hpp"

namespace brachisto {

std::string_view describe(ExtremalStatus status) {
  constexpr std::array<std::string_view, 12> kSentences{
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
      "the time allowed ran out",
      "stopped from outside"};
  static_assert(kSentences.size() ==
                static_cast<std::size_t>(ExtremalStatus::Interrupted) + 1);
  return kSentences.at(static_cast<std::size_t>(status));
}

namespace {

using namespace shooting;

/// What the two ways to a solution share.
class Solve : public ExtremalAttempt {
 public:
  Solve(const Scene& scene, const ExtremalOptions& options,
        const ExtremalGuess& guess)
      : ExtremalAttempt(options),
        scene_(scene),
        units_(natural_units(scene)),
        natural_(in_natural_units(scene)),
        system_(natural_, choose_arcs(natural_, guess, options.arcs),
                options.stop),
        start_(to_chain(natural_, units_, guess, system_.num_arcs())),
        scale_(scale_of(natural_, start_)) {
    solution_.arcs = system_.num_arcs();
    solution_.start_angle = brachisto::start_angle(scene.body);
  }

  /// Follows the branch from the cycloid; false if it does not arrive.
  bool continue_in_offset();
  /// Newton's method to full accuracy, and the result.
  void finish();

 private:
  void fill(const ShootingResult& result);
  /// T, corrected for the matching errors left [natural units].
  [[nodiscard]] double time_of(const ShootingResult& result) const {
    return result.at.transit_time +
           system_.time_missing(result.point, result.at.residual);
  }
  /// What is known of ∂²𝓗/∂β² along a point of the branch, in words.
  [[nodiscard]] std::string legendre_at(const ChainVector& point) const;
  [[nodiscard]] double rounding_error(const ShootingResult& result) const;

  const Scene& scene_;
  Units units_;
  Scene natural_;
  ShootingSystem system_;
  ChainVector start_;
  ChainScale scale_;
};

bool Solve::continue_in_offset() {
  const double target = natural_.body.eta_m;
  start_.globals(kEta) = 0.0;
  if (target == 0.0) return true;
  FollowedBranch branch =
      follow_branch(system_, start_, scale_, target, options_);
  solution_.newton_steps += branch.newton_steps;
  solution_.continuation = std::move(branch.report);
  ContinuationReport& report = solution_.continuation;
  for (ContinuationPoint& point : report.points) {
    point.transit_time *= units_.time;
  }
  start_ = std::move(branch.point);
  const double eta = start_.globals(kEta);
  const double phi = start_.globals(kPhi);
  switch (branch.end) {
    case BranchEnd::Reached:
      return true;
    case BranchEnd::TurnsBack:
      fail(ExtremalStatus::BranchTurnsBack,
           fmt::format(
               "it turns at η = {:.6g} (φ = {:.4g}), below η_m = {:.6g};"
               " beyond, the branch from the cycloid was not followed. Try to "
               "follow "
               "the fold, a guess from a direct method, or a smaller "
               "η_m",
               report.folds.empty() ? eta : report.folds.front(), phi, target));
      break;
    case BranchEnd::StepTooSmall:
    case BranchEnd::MaxSteps:
      fail(ExtremalStatus::StepTooSmall,
           fmt::format("at η = {:.6g} (φ = {:.4g}) of {:.6g} after {} points, "
                       "where {}; try more arcs than {}, or a guess from a "
                       "direct method",
                       eta, phi, target, report.points.size(),
                       legendre_at(start_), system_.num_arcs()));
      break;
    case BranchEnd::NoStart:
      fail(ExtremalStatus::NewtonFailed,
           "already at η = 0, where the cycloid should satisfy all conditions; "
           "try more arcs");
      break;
    case BranchEnd::Stopped:
      stop(fmt::format("at η = {:.6g} of {:.6g}", eta, target));
      break;
  }
  return false;
}

// Where ∂²𝓗/∂β² reaches zero, extremals get corners and are not followed.
std::string Solve::legendre_at(const ChainVector& point) const {
  const Globals& q = point.globals;
  Scene scene = natural_;
  scene.body.eta_m = q(kEta);
  const ExtremalPath path(scene, units_, q(kPX), q(kPZ),
                          system_.path(point, {}));
  if (path.empty()) {
    return "the path cannot be integrated accurately, as happens when "
           "∂²𝓗/∂β² reaches zero along it";
  }
  return fmt::format("∂²𝓗/∂β² falls to {:.2g} along the path",
                     path.regularity().min_legendre);
}

void Solve::finish() {
  // The local error is well below the wanted accuracy of the whole.
  constexpr double kShare = 0.1;
  constexpr double kTightest = 1e-15;
  const double wanted = std::max(options_.tolerance, 1e-14);
  ShootingOptions newton{
      .integration = {.tolerance = std::max(kShare * wanted, kTightest),
                      .halve = false},
      .tolerance = wanted,
      .max_steps = options_.max_newton_steps};
  const TangencyRow tangency = TangencyRow::offset(natural_.body.eta_m);

  const ShootingResult coarse =
      solve_newton(system_, start_, scale_, tangency, newton);
  solution_.newton_steps += coarse.steps;
  const auto describe_stop = [&](const ShootingResult& result) {
    return fmt::format(
        "after {} steps the correction is {:.1e}, the residual "
        "{:.1e}",
        result.steps, result.last_correction, scale_.norm(result.at.residual));
  };
  switch (coarse.end) {
    case NewtonEnd::Converged:
      break;
    case NewtonEnd::NotEvaluable:
      fail(ExtremalStatus::BadGuess,
           fmt::format("on arc {} of {} no slope makes 𝓗 minimal, or the step "
                       "became too small; try a guess nearer to an extremal, "
                       "or more arcs",
                       coarse.at.arc + 1, system_.num_arcs()));
      return;
    case NewtonEnd::Stopped:
      stop(describe_stop(coarse));
      return;
    case NewtonEnd::Diverged:
    case NewtonEnd::MaxSteps:
      fail(ExtremalStatus::NewtonFailed,
           describe_stop(coarse) + "; try a better guess, or more arcs");
      return;
  }
  newton.integration.halve = true;
  const ShootingResult fine =
      solve_newton(system_, coarse.point, scale_, tangency, newton);
  solution_.newton_steps += fine.steps;
  if (fine.end == NewtonEnd::Stopped) {
    stop(describe_stop(fine));
    return;
  }
  fill(fine.end == NewtonEnd::Converged ? fine : coarse);

  solution_.error_estimate =
      std::abs(time_of(fine) - time_of(coarse)) / time_of(fine) +
      rounding_error(fine);
  if (fine.end != NewtonEnd::Converged) {
    fail(ExtremalStatus::NewtonFailed,
         "with every step halved " + describe_stop(fine));
    return;
  }
  solution_.path = ExtremalPath(natural_, units_, fine.point.globals(kPX),
                                fine.point.globals(kPZ),
                                system_.path(fine.point, newton.integration));
  if (solution_.path.empty() && system_.stopped()) {
    stop("on the way along the solution");
    return;
  }
  if (solution_.path.empty()) {
    fail(ExtremalStatus::NewtonFailed,
         "the solution cannot be integrated again");
    return;
  }
  judge();
}

void Solve::fill(const ShootingResult& result) {
  const Globals& q = result.point.globals;
  solution_.transit_time = time_of(result) * units_.time;
  solution_.tau =
      solution_.transit_time * std::sqrt(2.0 * scene_.gravity / scene_.H);
  solution_.rolling_time = q(kU) * units_.time;
  solution_.phi = q(kPhi);
  // No-slip: S = r (θ_end − θ_m). For a bead θ counts arc length.
  const double turned =
      result.point.nodes.back()(kTheta) - natural_.body.theta_m;
  solution_.rotation = natural_.body.rolls() ? turned : 0.0;
  solution_.centre_path_length =
      turned / inverse_radius(natural_.body) * units_.length;
  solution_.p_x = q(kPX) / units_.speed();
  solution_.p_z = q(kPZ) / units_.speed();
  solution_.integration_steps = result.at.steps;
  solution_.residual = scale_.norm(result.at.residual);
}

// Every step rounds the states, which T feels through the costates; the errors
// are independent. The slope at the end, which determines φ and so the end
// point, is as wrong as the last correction that could not be told from zero.
double Solve::rounding_error(const ShootingResult& result) const {
  const double T = result.at.transit_time;
  const Globals& q = result.point.globals;
  double largest = T;
  for (const Vector6& node : result.point.nodes) {
    largest = std::max(largest, std::abs(q(kPX) * node(kX)) +
                                    std::abs(q(kPZ) * node(kZ)) +
                                    std::abs(node(kPTheta) * node(kTheta)) +
                                    std::abs(node(kPW) * node(kW)));
  }
  const EndSlide slide = end_slide(natural_, q(kPhi));
  const double per_phi = q(kPX) * slide.dx_dphi + q(kPZ) * slide.dz_dphi;
  return (std::numeric_limits<double>::epsilon() *
              std::sqrt(1.0 + result.at.steps) * largest +
          std::abs(per_phi * result.last_change_of_phi)) /
         T;
}

}  // namespace

bool ExtremalSolution::usable() const {
  constexpr double kWorthless = 1e-6;  // an error that settles nothing
  return solved() || (status == ExtremalStatus::AccuracyNotReached &&
                      error_estimate <= kWorthless);
}

ExtremalSolution solve_extremal(const Scene& scene, const ExtremalGuess& guess,
                                const ExtremalOptions& options) {
  if (!scene.world.ordinary()) {
    return solve_extremal_in_world(scene, guess, options);
  }
  Solve solve(scene, options, guess);
  return solve.within_its_stop([&] { solve.finish(); });
}

ExtremalSolution solve_extremal(const Scene& scene,
                                const ExtremalOptions& options) {
  if (!scene.world.ordinary()) {
    ExtremalSolution ordinary =
        solve_extremal(in_ordinary_world(scene), options);
    return ordinary.usable() ? solve_extremal_in_world(scene, ordinary, options)
                             : ordinary;
  }
  const ExtremalGuess cycloid = cycloid_guess(scene);
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
    if (solve.continue_in_offset()) solve.finish();
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
  guess.p_x = p_x;
  guess.p_z = p_z;
  guess.state = [arc = *arc, body, g, root, p_z](double sigma) {
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
                         .t = root * sigma * arc.rolling_time(g)};
  };
  return guess;
}

}  // namespace brachisto
