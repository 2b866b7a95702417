// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "study/limited_branches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "refinement/arcs_from_mesh.hpp"
#include "study/answer_kinds.hpp"
#include "study/branches.hpp"
#include "study/conclude.hpp"
#include "study/record.hpp"

namespace brachisto {

namespace {

struct JudgedPath {
  Branch branch;
  Solution solution;
};

/// \pre a motion()
const LimitedCurve& curve_of(const Solution& limited) {
  return answer_as<LimitedPathAnswer>(limited.answer)->motion.curve();
}

/// Nothing if the path led nowhere, or to what is known.
void judge(Solution solution, bool principal, std::vector<JudgedPath>& judged) {
  const Motion* motion = solution.motion();
  if (motion == nullptr) return;
  Branch branch =
      branch_of(*motion, solution.estimated_error, solution.certificate,
                solution.infeasible_because());
  branch.principal = principal;
  // Two ways round a disc may take as long and end alike.
  if (std::ranges::any_of(judged, [&](const JudgedPath& other) {
        return same(other.branch, branch) &&
               alike(curve_of(other.solution), curve_of(solution));
      })) {
    return;
  }
  judged.push_back({std::move(branch), std::move(solution)});
}

void take_answer(const Solution& found, Solution& out) {
  record(Outcome{found.status, found.message}, out);
  out.answer = found.answer;
  out.estimated_error = found.estimated_error;
  out.diagnostics = found.diagnostics;
  out.limits = found.limits;
  out.certificate = found.certificate;
  out.extremal = found.extremal;
  out.relaxed.reset();
  out.effort.meshes = found.effort.meshes;
}

}  // namespace

void judge_limited_paths(const PosedProblem& posed,
                         const std::vector<LimitedCurve>& paths,
                         Solution& out) {
  std::vector<JudgedPath> judged;
  judge(out, true, judged);
  const LimitedCurve* own = out.verified() ? &curve_of(out) : nullptr;
  // Each may take what the limit allows; a line for each is enough.
  MeshOptions quietly = posed.mesh_options_after({});
  quietly.progress = {};
  const auto judge_all = [&] {
    for (std::size_t i = 0; i < paths.size() && !posed.stop().met(); ++i) {
      if (own != nullptr && alike(*own, paths[i])) continue;
      if (posed.progress()) {
        posed.progress()("branches",
                         fmt::format("{} of {}", i + 1, paths.size()));
      }
      Solution one;
      one.scene = posed.asked;
      one.options = posed.options;
      conclude_resolved(
          posed,
          refine_from_mesh(paths[i], posed.program.discretisation, quietly),
          one);
      out.effort += one.effort;
      judge(std::move(one), false, judged);
    }
  };
  try {
    judge_all();
  } catch (const Stopped&) {
    // What was judged before stays.
    if (!posed.stop().met()) throw;
  }
  std::ranges::stable_sort(
      judged, {}, [](const JudgedPath& path) { return path.branch.tau; });
  for (const JudgedPath& path : judged) out.branches.push_back(path.branch);
  const JudgedPath* best = best_branch(judged);
  if (best != nullptr && best->branch.verified && !best->branch.principal) {
    take_answer(best->solution, out);
  }
}

}  // namespace brachisto
