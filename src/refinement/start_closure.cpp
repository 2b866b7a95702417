// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/start_closure.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "model/contact.hpp"
#include "model/start_angle.hpp"

namespace brachisto {

namespace {

using Slopes = Eigen::Vector2d;  // at A and B

/// Solutions between ends that slopes at A and B say.
class BetweenSlopes {
 public:
  BetweenSlopes(RollingTime& problem, MeshStart start,
                const MeshOptions& options, const SolveOnMesh& solve)
      : problem_(problem),
        from_(std::move(start)),
        options_(options),
        solve_(solve) {
    options_.fixed_ends = true;
  }

  [[nodiscard]] Slopes start() const {
    return {start_angle(problem_.scene()), from_.phi};
  }
  /// By how much the extremal's own slopes differ from those that its ends are
  /// built from; nothing if there is none. Without a contact at B that slope is
  /// of no matter and kept.
  [[nodiscard]] std::optional<Slopes> mismatch(const Slopes& slopes) {
    problem_.set_start_slope(slopes(0));
    from_.phi = slopes(1);
    const bool first = solution_.tangency.passes == 0;
    MeshSolution pass =
        (first ? solve_ : SolveOnMesh(stay_on_mesh))(problem_, from_, options_);
    if (!first) {
      pass.polish.newton_steps += solution_.polish.newton_steps;
      pass.first_iterations = solution_.first_iterations;
      pass.iterations = solution_.iterations;
      pass.linear_solver = solution_.linear_solver;
      pass.log = std::move(solution_.log);
      if (pass.solved()) pass.message = std::move(solution_.message);
    }
    pass.tangency.passes = solution_.tangency.passes + 1;
    solution_ = std::move(pass);
    if (!solution_.solved()) return std::nullopt;
    from_.point = solution_.point;
    const bool smooth = problem_.scene().contact == Contact::Smooth;
    return Slopes(
        ExtremalCurve(problem_, from_.point).at(0.0).beta - slopes(0),
        smooth
            ? problem_.end_slope(from_.point.x, from_.point.lambda) - slopes(1)
            : 0.0);
  }
  [[nodiscard]] MeshSolution& solution() { return solution_; }

 private:
  RollingTime& problem_;
  MeshStart from_;
  MeshOptions options_;
  const SolveOnMesh& solve_;
  MeshSolution solution_;
};

}  // namespace

MeshSolution close_start(RollingTime& problem, MeshStart start,
                         const MeshOptions& options, const SolveOnMesh& solve,
                         double tolerance) {
  if (!slope_at_A_is_open(problem.scene())) {
    return solve(problem, std::move(start), options);
  }
  constexpr int kMostSteps = 20;
  constexpr double kLongestStep = 0.25;
  // Solutions are exact to rounding, so that differences over this have nine
  // digits or so, which is plenty for a first Jacobian.
  constexpr double kDifference = 1e-6;
  const double loose = std::max(tolerance, TangencyOptions{}.loose_tolerance);
  BetweenSlopes ends(problem, std::move(start), options, solve);
  Slopes slopes = ends.start();
  std::optional<Slopes> off = ends.mismatch(slopes);
  Eigen::Matrix2d jacobian = -Eigen::Matrix2d::Identity();
  const bool smooth = problem.scene().contact == Contact::Smooth;
  for (int i = 0; off && i < (smooth ? 2 : 1); ++i) {
    Slopes moved = slopes;
    moved(i) += kDifference;
    const std::optional<Slopes> there = ends.mismatch(moved);
    if (!there) return std::move(ends.solution());
    jacobian.col(i) = (*there - *off) / kDifference;
  }
  double size = std::numeric_limits<double>::infinity();
  bool closed = false;
  for (int i = 0; off && !closed && i < kMostSteps; ++i) {
    Slopes step = -jacobian.partialPivLu().solve(*off);
    const double longest = step.lpNorm<Eigen::Infinity>();
    if (!std::isfinite(longest)) break;
    if (longest > kLongestStep) step *= kLongestStep / longest;
    slopes += step;
    const std::optional<Slopes> next = ends.mismatch(slopes);
    if (!next) break;
    jacobian += (*next - *off - jacobian * step) * step.transpose() /
                std::max(step.squaredNorm(), 1e-30);
    off = next;
    const double now = off->lpNorm<Eigen::Infinity>();
    closed = now <= tolerance || (now <= loose && 2.0 * now >= size);
    size = now;
  }
  MeshSolution solution = std::move(ends.solution());
  if (!solution.solved()) return solution;
  Tangency& at_B = solution.tangency;
  at_B.phi = slopes(1);
  at_B.mismatch = (*off)(1);
  // With α such that the contact at A stays closed.
  if (smooth) at_B.slope = jacobian.determinant() / jacobian(0, 0);
  at_B.closed = closed;
  if (!closed) {
    solution.status = Status::NotConverged;
    solution.message = fmt::format(
        "no slopes at A and B reproduce themselves: they are off by {:.2e} and "
        "{:.2e} rad after {} passes",
        (*off)(0), (*off)(1), at_B.passes);
  }
  return solution;
}

double time_per_start_slope(const ExtremalCurve& curve) {
  const Scene& scene = curve.scene();
  if (!slope_at_A_is_open(scene)) return 0.0;
  const Costates p = curve.at(0.0).p;
  const StartRates turn = start_rates(scene);
  return p.p_x * turn.x + p.p_z * turn.z + p.p_w * turn.w;
}

}  // namespace brachisto
