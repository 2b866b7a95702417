// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "peers/program.hpp"

#include <fmt/format.h>

#include <fstream>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "brachisto/math/index.hpp"
#include "brachisto/study/solve.hpp"
#include "program_files/nl_file.hpp"
#include "program_files/program_in_formulas.hpp"
#include "study/pose.hpp"
#include "study/start.hpp"
#include "transcription/arc_length.hpp"
#include "transcription/prolongation.hpp"
#include "transcription/rolling_time.hpp"

namespace brachisto::benchmarks {

namespace {

Scene reference_scene(double eta_m) {
  Scene scene;
  scene.body = Body::cylinder(1.0 / 3.0, eta_m, 0.0, 0.5);
  scene.L = 3.0;
  scene.H = 1.0;
  return scene;
}

constexpr double kEtaM = 2.0 / 3.0;

/// With what is fixed where it is fixed.
PrimalDual within_fixed(const Transcription& problem, PrimalDual start) {
  for (int i = 0; i < problem.num_variables(); ++i) {
    const nlp::Range range = problem.variable_range(i);
    if (range.single()) start.x[at(i)] = range.lower;
  }
  return start;
}

PrimalDual begun_nearby(const ReferenceCase& reference,
                        const RollingTime& problem) {
  return within_fixed(problem, prolong(reference.nearby, problem));
}

/// The whole path leans towards its other end: a single short piece cannot.
PrimalDual begun_nearby(const ReferenceCase& reference, ArcLength& problem) {
  problem.set_end_angle(reference.nearby_phi);
  PrimalDual start = prolong(reference.nearby, problem);
  problem.set_end_angle(reference.phi);
  const VariableLayout& layout = problem.layout();
  const int last = problem.num_intervals();
  for (const StateComponent component :
       {StateComponent::X, StateComponent::Z}) {
    const int end = layout.state(last, component);
    const double gap = problem.variable_range(end).lower - start.x[at(end)];
    for (int node = 1; node <= last; ++node) {
      const double sigma = problem.sigma(node);
      start.x[at(layout.state(node, component))] += sigma * sigma * gap;
    }
  }
  return within_fixed(problem, std::move(start));
}

}  // namespace

ReferenceCase ReferenceCase::make() {
  SolveOptions options;
  options.method = Shooting{.tolerance = kSmallestTolerance};
  const Solution solution = solve(reference_scene(kEtaM), options);
  if (!solution.verified()) {
    throw std::runtime_error("no verified reference: " + solution.message);
  }
  // So far that the start is none of those that solves end with.
  constexpr double kNearby = 0.9;
  const PosedProblem posed = pose(reference_scene(kEtaM), {}, {});
  const PosedProblem other = pose(reference_scene(kNearby * kEtaM), {}, {});
  const Start start = start_from_cycloid(other);
  if (!start.curve) throw std::runtime_error("no start: " + start.message);
  const Motion& motion = *solution.motion();
  return {posed.natural,
          motion.tau(),
          motion.end_angle(),
          motion.tau() / motion.transit_time() * posed.units.time,
          *start.curve,
          start.phi};
}

PeerProgram::PeerProgram(const ReferenceCase& reference,
                         Formulation formulation, int nodes) {
  if (formulation == Formulation::ArcLength) {
    auto pieces =
        std::make_unique<ArcLength>(reference.natural, nodes, reference.phi);
    start = begun_nearby(reference, *pieces);
    problem = std::move(pieces);
  } else {
    const Mesh mesh = uniform_mesh(kDefaultDegree, nodes / kDefaultDegree);
    auto elements =
        std::make_unique<RollingTime>(reference.natural, mesh, reference.phi);
    start = begun_nearby(reference, *elements);
    problem = std::move(elements);
  }
}

void PeerProgram::write(const std::filesystem::path& nl_file) const {
  const auto formulas = program_files::in_formulas(*problem);
  const program_files::NlNumbering order(*problem, *formulas);
  std::ofstream file(nl_file, std::ios::binary);
  program_files::TextStream out(
      [&file](std::string_view piece) { file << piece; });
  program_files::put_nl(*problem, *formulas, order, start, out);
  out.flush();
  if (!file.flush()) {
    throw std::runtime_error("cannot write " + nl_file.string());
  }
}

}  // namespace brachisto::benchmarks
