// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/refinement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "brachisto/ocp/mesh.hpp"
#include "model/contact.hpp"
#include "model/start_angle.hpp"
#include "refinement/mesh_choice.hpp"
#include "refinement/mesh_sequence.hpp"
#include "refinement/start_closure.hpp"
#include "refinement/surface_passages.hpp"
#include "solvers/newton_solver.hpp"
#include "transcription/contact_equation.hpp"
#include "transcription/extremal_curve.hpp"
#include "transcription/prolongation.hpp"

namespace brachisto {

namespace {

/// What rounding leaves of T, relative: a few ulps of the sum of the integral,
/// and half an ulp for each element, whose defect hands the state on with as
/// much, and on equal elements to the same side.
double rounding_error(const Mesh& mesh) {
  constexpr double kOfSum = 2e-15;
  constexpr double kHalfAnUlp = 0.5 * std::numeric_limits<double>::epsilon();
  return kOfSum + kHalfAnUlp * mesh.num_elements();
}

/// What a better or an independent solution says of the error of `answer`,
/// given a bound on that solution's own, relative.
double estimate(const MeshAnswer& answer, const ExtremalCurve& curve,
                const ExtremalCurve& other, double other_phi,
                double error_of_other, double weight) {
  const double T = curve.transit_time();
  const Tangency& tangency = answer.solution.tangency;
  const EndErrors ends = errors_of_end(
      curve.scene(), tangency, {.p_x = curve.p_x(), .p_z = curve.p_z()});
  // Two parts of the error, that of the ends and that between fixed ends, may
  // have opposite signs; the estimate must not profit from it. What is known of
  // the other's own error is between fixed ends.
  const double difference = other.transit_time() - T;
  const double of_ends = ends.per_radian * (other_phi - tangency.phi);
  const double of_start =
      slope_at_A_is_open(curve.scene())
          ? time_per_start_slope(curve) *
                (start_angle(other.scene()) - start_angle(curve.scene()))
          : 0.0;
  const double apart = weight * (std::abs(of_ends) + std::abs(of_start)) +
                       std::abs(difference - of_ends - of_start);
  return (std::max(weight * std::abs(difference), apart) + ends.open +
          ends.rounding) /
             T +
         error_of_other + rounding_error(curve.mesh());
}

/// By the same elements with degree p + 1.
void estimate_by_degree(MeshAnswer& answer, const MeshOptions& options) {
  const ExtremalCurve coarse = answer.curve();
  Mesh mesh = coarse.mesh();
  mesh.degree += 1;
  const double phi = answer.solution.tangency.phi;
  RollingTime finer(coarse.scene(), mesh, phi);
  const auto judge_by = [&](const PrimalDual& point, double finer_phi) {
    answer.finer.emplace(finer, point);
    answer.finer_phi = finer_phi;
    constexpr double kSameSide = 2.0;
    const double of_finer = sum_of_errors(element_errors(*answer.finer));
    answer.estimated_error =
        estimate(answer, coarse, *answer.finer, finer_phi,
                 of_finer / coarse.transit_time(), kSameSide);
  };
  if (slope_at_A_is_open(coarse.scene())) {
    const MeshSolution solution = close_start(
        finer, {prolong(coarse, finer), phi, -1.0}, options, stay_on_mesh);
    answer.solution.polish.newton_steps += solution.polish.newton_steps;
    if (solution.solved()) judge_by(solution.point, solution.tangency.phi);
    return;
  }
  const bool smooth = coarse.scene().contact == Contact::Smooth;
  std::optional<ContactEquation> contact;
  if (smooth) contact.emplace(finer);
  NewtonOptions newton;
  // A looser one may hold at the start already, and nothing would be learnt.
  newton.tolerance =
      reachable(std::min(options.ipopt.tolerance, kRoundingResidual),
                answer.problem, answer.solution.point.x);
  newton.max_iterations = 10;
  newton.linear_solver = options.ipopt.linear_solver;
  newton.stop = options.ipopt.stop;
  const NewtonResult result = NewtonSolver(finer, smooth ? &*contact : nullptr)
                                  .solve(prolong(coarse, finer), phi, newton);
  answer.solution.polish.newton_steps += result.iterations;
  if (result.residual > reachable(kRoundingResidual, finer, result.point.x))
    return;
  judge_by(result.point, result.phi);
}

/// How far a solution lies from the curve it started from: in T, relative, or
/// in φ, whichever is more.
double departure(RollingTime& problem, const MeshSolution& solution,
                 const ExtremalCurve& curve, double phi) {
  if (!problem.set_point(solution.point.x)) {
    return std::numeric_limits<double>::infinity();
  }
  const double T = problem.eval_f();
  return std::max(std::abs(T / curve.transit_time() - 1.0),
                  std::abs(solution.tangency.phi - phi));
}

/// Solves `scene` on `mesh`, starting from `curve`, and estimates the error.
///
/// Let ΔT and Δφ be the changes of T and φ when the scene is solved on the same
/// elements with degree p + 1. The estimate is
///
///     max(2 |ΔT|, 2 |T_φ Δφ| + |ΔT − T_φ Δφ|) + Σ_e |U ∫_e 𝓗 dσ|,
///
/// T_φ = −r (p_x cos φ + p_z sin φ) being dT/dφ, and the sum taken on the finer
/// solution: ΔT is the error but for that of the finer solution, which the sum
/// bounds from above between fixed ends. The factors 2 keep it honest where the
/// two degrees err to the same side, in φ too, the split where the errors of
/// the end point and between fixed ends cancel by accident. What an open
/// contact and rounding add comes on top.
///
/// If the answer of a coarser mesh is given, it takes the place of degree p +
/// 1, and its own estimate that of the sum: the triangle inequality, for the
/// price of the coarser mesh.
///
/// Where Ipopt leaves the extremal that `curve` shows, because between its ends
/// it is no minimum, Newton's method finds it alone.
MeshAnswer answer_on_mesh(const Scene& scene, const Mesh& mesh,
                          const ExtremalCurve& curve, double phi,
                          const MeshOptions& options,
                          const MeshAnswer* coarser) {
  // Far less than branches lie apart, far more than meshes differ that follow
  // a tolerance.
  constexpr double kLargestDeparture = 3e-3;
  MeshAnswer answer{RollingTime(scene, mesh, phi), {}, {}, {}, phi};
  RollingTime& problem = answer.problem;
  const bool open_start = slope_at_A_is_open(scene);
  if (open_start) problem.set_start_slope(start_angle(curve.scene()));
  MeshSolution& solution = answer.solution;
  const auto start = [&] {
    return MeshStart{prolong(curve, problem), phi, -1.0};
  };
  solution = close_start(problem, start(), options, solve_near);
  const bool out_of_budget =
      solution.status == Status::IterationLimit &&
      solution.iterations >= options.ipopt.max_iterations;
  if (out_of_budget || solution.status == Status::OutOfMemory ||
      options.ipopt.stop.met()) {
    return answer;
  }
  const double away = solution.solved()
                          ? departure(answer.problem, solution, curve, phi)
                          : std::numeric_limits<double>::infinity();
  if (away > kLargestDeparture && !options.newton_alone) {
    const std::optional<double> slope_found = problem.scene().world.start_slope;
    if (open_start) problem.set_start_slope(start_angle(curve.scene()));
    MeshSolution stayed = close_start(problem, start(), options, stay_on_mesh);
    if (stayed.solved() &&
        departure(answer.problem, stayed, curve, phi) < 0.5 * away) {
      take_instead(solution, std::move(stayed));
    } else {
      if (slope_found) problem.set_start_slope(*slope_found);
      answer.problem.set_end_angle(solution.tangency.phi);
      if (solution.status == Status::IterationLimit) {
        solution.status = Status::NotConverged;
        solution.message = fmt::format(
            "on degree {}, {} elements no solution near the coarser one: {}",
            mesh.degree, mesh.num_elements(), solution.message);
      }
    }
  }
  if (!solution.solved()) return answer;
  if (coarser == nullptr) {
    if (options.progress) {
      options.progress("check", fmt::format("degree {} on the same elements",
                                            mesh.degree + 1));
    }
    estimate_by_degree(answer, options);
  } else {
    answer.coarser_elements = coarser->problem.mesh().num_elements();
    answer.estimated_error = estimate(answer, answer.curve(), coarser->curve(),
                                      coarser->solution.tangency.phi,
                                      coarser->estimated_error.value(), 1.0);
  }
  return answer;
}

/// Meshes of elements, each from the solution of the one before.
class Elements {
 public:
  Elements(const Scene& scene, const Discretisation& wanted,
           const ExtremalCurve& curve, double phi)
      : scene_(scene),
        meets_surface_(has_surface(scene.world)),
        fixed_(wanted.fixed()),
        degree_is_fixed_(wanted.degree.has_value()),
        tolerance_(wanted.tolerance.value_or(kDefaultTolerance)),
        mesh_(wanted.fixed() ? fixed_mesh(wanted)
                             : first_mesh(wanted, tolerance_, curve)),
        from_(curve),
        phi_(phi) {
    if (meets_surface_) {
      surface_.learn(curve);
      mesh_ = surface_.fit(std::move(mesh_), fixed_);
    }
    constexpr int kManyElements = 4000;
    constexpr int kTimesCoarser = 8;
    constexpr int kEnoughElements = 5000;
    const int elements = mesh_.num_elements();
    if (!fixed_ || elements < kManyElements) return;
    large_ = std::exchange(
        mesh_, uniform_mesh(mesh_.degree, std::min(elements / kTimesCoarser,
                                                   kEnoughElements)));
  }

  [[nodiscard]] std::string name() const {
    return fmt::format("mesh {} × {}", mesh_.degree, mesh_.num_elements());
  }
  [[nodiscard]] MeshAnswer solve(const MeshOptions& options,
                                 const Refinement&) const {
    const bool judged =
        coarser_ && coarser_->estimated_error &&
        *coarser_->estimated_error <= largest_error_of_a_judge(tolerance_);
    return answer_on_mesh(scene_, mesh_, from_, phi_, options,
                          judged ? &*coarser_ : nullptr);
  }
  bool goes_on(MeshAnswer answer, const StopCondition& stop, Refinement& out) {
    const MeshSolution& solution = answer.solution;
    if (large_) {
      mesh_ = *std::exchange(large_, std::nullopt);
      if (!solution.solved()) return true;
      start_from(answer.curve(), solution.tangency.phi);
      if (meets_surface_) {
        // Its own ends were not there, and it judges no other mesh.
        surface_.learn(answer.curve());
        mesh_ = surface_.fit(std::move(mesh_), fixed_);
        return true;
      }
      coarser_.emplace(std::move(answer));
      return true;
    }
    --left_;
    if (stop.met()) return false;
    if (!solution.solved()) {
      if (fixed_ || !too_coarse(solution) ||
          mesh_.num_elements() > kLargestDoubled) {
        return false;
      }
      mesh_ = stretch(mesh_, 2 * mesh_.num_elements());
      return left_ > 0;
    }
    if (meets_surface_) {
      surface_.learn(answer.curve());
      if (!surface_.settled()) {
        // Degree p + 1 errs alike where ends are not on the surface.
        answer.estimated_error.reset();
        mesh_ = surface_.fit(answer.problem.mesh(), fixed_);
        start_from(answer.curve(), solution.tangency.phi);
        if (!out.answer) out.answer.emplace(std::move(answer));
        return left_ > 0;
      }
      if (answer.estimated_error) *answer.estimated_error += surface_.error();
    }
    const bool improved =
        !out.answer || !out.answer->estimated_error ||
        (answer.estimated_error &&
         *answer.estimated_error < *out.answer->estimated_error);
    if (improved) out.answer.emplace(std::move(answer));
    // The lower of two degrees may err less by accident; once more elements
    // only get worse as well, rounding has the last word.
    if (!improved && std::exchange(got_worse_, true)) return false;
    const MeshAnswer& best = *out.answer;
    if (best.estimated_error && *best.estimated_error <= tolerance_) {
      return false;
    }
    if (left_ == 0 || fixed_) return false;
    // What coarse meshes show is not yet the path.
    const bool known = kMaxMeshes - left_ >= kCoarseMeshes;
    if (known && another_slope_is_faster(best.curve())) return false;
    mesh_ =
        surface_.fit(improved ? next_mesh(best, tolerance_, degree_is_fixed_)
                              : stretch(mesh_, 2 * mesh_.num_elements()),
                     fixed_);
    if (best.finer) {
      start_from(*best.finer, best.finer_phi);
    } else {
      start_from(best.curve(), best.solution.tangency.phi);
    }
    return true;
  }

 private:
  static constexpr int kMaxMeshes = 12, kCoarseMeshes = 3;
  // A mesh of so many elements that cannot be solved on is not too coarse.
  static constexpr int kLargestDoubled = 2000;

  void start_from(const ExtremalCurve& curve, double phi) {
    from_ = curve;
    phi_ = phi;
  }

  const Scene& scene_;
  bool meets_surface_;  ///< ends of elements go where paths pass one
  bool fixed_;          ///< so many elements are asked for
  bool degree_is_fixed_;
  double tolerance_;
  int left_ = kMaxMeshes;   ///< so many meshes may be tried yet
  bool got_worse_ = false;  ///< some mesh than the one before it
  Mesh mesh_;
  std::optional<Mesh> large_;  ///< to come after mesh_
  ExtremalCurve from_;
  double phi_;
  std::optional<MeshAnswer> coarser_;
  SurfaceEnds surface_;
};

}  // namespace

EndErrors errors_of_end(const Scene& scene, const Tangency& tangency,
                        const Costates& p) {
  constexpr double kRoundings = 16.0;
  const bool smooth = scene.contact == Contact::Smooth;
  const double r = smooth ? scene.body.radius : 0.0;
  const double phi = tangency.phi;
  // C_B moves by r (cos φ, sin φ) per radian.
  const double per_radian =
      -r * (p.p_x * std::cos(phi) + p.p_z * std::sin(phi));
  const Point start = start_of_centre(scene);
  const Point end = end_of_centre(scene, phi);
  const double largest =
      std::max({std::abs(start.x), std::abs(start.z), std::abs(end.x),
                std::abs(end.z), scene.L, scene.H});
  return {per_radian, std::abs(tangency.mismatch / tangency.slope * per_radian),
          kRoundings * std::numeric_limits<double>::epsilon() * largest *
              (1.0 + r) * std::hypot(p.p_x, p.p_z)};
}

MeshRecord record_of(const Transcription& problem, const MeshSolution& solution,
                     const std::optional<double>& error) {
  return {problem.mesh().degree,
          problem.mesh().num_elements(),
          error,
          solution.tangency.passes,
          solution.first_iterations,
          solution.iterations,
          solution.polish.newton_steps,
          solution.linear_solver};
}

std::string text_of(const MeshRecord& mesh) {
  return fmt::format(
      "{} iterations in {} passes, {} Newton steps, error of T {}",
      mesh.iterations, mesh.passes, mesh.newton_steps,
      mesh.estimated_error ? fmt::format("{:.1e}", *mesh.estimated_error)
                           : "unknown");
}

Refinement refine(const Scene& scene, const Discretisation& wanted,
                  const ExtremalCurve& curve, double phi, MeshOptions options) {
  return run<Elements, Refinement>({scene, wanted, curve, phi},
                                   std::move(options));
}

}  // namespace brachisto
