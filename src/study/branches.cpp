// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "study/branches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "brachisto/math/clock.hpp"
#include "study/certification.hpp"
#include "study/resolve.hpp"
#include "trajectory/feasibility.hpp"
#include "trajectory/trajectory.hpp"

namespace brachisto {

namespace {

/// \pre an answer was found
JudgedBranch judge(const PosedScene& scene, const Discretisation& wanted,
                   Refinement found) {
  MeshAnswer& answer = *found.answer;
  const Trajectory trajectory(answer.curve(), scene.scene, scene.units);
  Certificate checks = certify_answer(answer, trajectory.curve(), wanted);
  Branch branch =
      branch_of(trajectory, answer.estimated_error, checks,
                infeasible_because(scene.scene, trajectory.diagnose()));
  return {std::move(branch), std::move(found), std::move(checks)};
}

}  // namespace

Branch branch_of(const Motion& motion, std::optional<double> estimated_error,
                 const Certificate& checks,
                 std::vector<std::string> infeasible) {
  Branch branch;
  branch.tau = motion.tau();
  branch.estimated_error =
      estimated_error.value_or(std::numeric_limits<double>::quiet_NaN());
  branch.end_angle = motion.end_angle();
  branch.centre_path_length = motion.centre_path_length();
  branch.verified = checks.verified();
  const Check* second_order = checks.find("second_order");
  branch.minimum = second_order != nullptr && second_order->passed;
  branch.feasible = infeasible.empty();
  branch.remarks = std::move(infeasible);
  for (const Check& check : checks.checks) {
    if (check.passed) continue;
    branch.remarks.push_back(
        &check == second_order
            ? "no answer: it is stationary, but no minimum between its fixed "
              "ends (failed check second_order)"
            : "failed check " + check.name);
  }
  return branch;
}

bool same(const Branch& a, const Branch& b) {
  constexpr double kSameTau = 1e-7, kSameAngle = 1e-6;
  // Next to a minimum a slope errs like the square root of the time.
  const double err = a.estimated_error + b.estimated_error;
  const double more = std::isfinite(err) ? err : 0.0;
  return std::abs(a.tau / b.tau - 1.0) < std::max(kSameTau, more) &&
         std::abs(a.end_angle - b.end_angle) <
             std::max(kSameAngle, std::sqrt(more));
}

JudgedBranches judge_branches(const PosedScene& scene,
                              const Discretisation& wanted,
                              const std::vector<ContactCandidate>& candidates,
                              bool first_is_principal,
                              const MeshOptions& options) {
  JudgedBranches out;
  MeshOptions quietly = options;  // a line for each branch is enough
  quietly.progress = {};
  std::optional<JudgedBranch> judged;  // of the candidate that is looked at
  const auto take_judged = [&] {
    if (judged &&
        std::ranges::none_of(out.branches, [&](const JudgedBranch& other) {
          return same(other.branch, judged->branch);
        })) {
      out.branches.push_back(*std::move(judged));
    }
    judged.reset();
  };
  const auto judge_all = [&] {
    for (std::size_t i = 0; i < candidates.size() && !options.ipopt.stop.met();
         ++i) {
      if (options.progress) {
        options.progress("branches",
                         fmt::format("{} of {}", i + 1, candidates.size()));
      }
      MeshOptions left = quietly;
      refine_until_resolved(
          scene.natural, wanted, candidates[i], [&] { return left; },
          [&](Refinement found) -> const Certificate* {
            for (const MeshRecord& mesh : found.meshes) {
              left.ipopt.max_iterations =
                  std::max(0, left.ipopt.max_iterations - mesh.iterations);
              out.meshes.push_back(mesh);
            }
            if (!found.answer) {
              out.failure = found.status;
              return nullptr;
            }
            judged = judge(scene, wanted, std::move(found));
            judged->branch.principal = i == 0 && first_is_principal;
            const bool ended =
                judged->refinement.status == Status::IterationLimit ||
                options.ipopt.stop.met();
            return ended ? nullptr : &judged->checks;
          });
      take_judged();
    }
  };
  try {
    judge_all();
  } catch (const Stopped&) {
    // What was judged before stays.
    if (!options.ipopt.stop.met()) throw;
    take_judged();
  }
  std::stable_sort(out.branches.begin(), out.branches.end(),
                   [](const JudgedBranch& a, const JudgedBranch& b) {
                     return a.branch.tau < b.branch.tau;
                   });
  return out;
}

int rank(const Branch& branch) {
  return branch.verified ? (branch.feasible ? 2 : 1) : 0;
}

}  // namespace brachisto
