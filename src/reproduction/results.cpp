// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "reproduction/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "brachisto/math/clock.hpp"
#include "design/best_track.hpp"
#include "reproduction/bent_track.hpp"
#include "sweep/scratch_directory.hpp"
#include "sweep/table.hpp"

namespace brachisto::reproduction {

namespace {

constexpr double kPi = std::numbers::pi;

double tau_on_mesh(const Scene& scene, int degree, int nodes,
                   const Interrupt& interrupt) {
  SolveOptions options;
  Discretisation& mesh = options.use<Collocation>().discretisation;
  mesh.degree = degree;
  mesh.nodes = nodes;
  return verified_solution(scene, interrupt, options).motion()->tau();
}

PaperEquations solve_paper_equations(const Scene& scene, int nodes) {
  using Datum = DiscreteReading::Datum;
  const auto tau = [&](Datum datum) -> std::optional<double> {
    DiscreteSystem system;
    system.nodes = nodes;
    system.solver = DiscreteSolver::Lifted;
    system.reading.datum = datum;
    const DiscreteAnswer answer = solve_discrete_system(scene, system);
    if (!answer.solved()) return std::nullopt;
    return answer.tau;
  };
  return {tau(Datum::Rest), tau(Datum::Release)};
}

std::vector<GridRow> grid_study(const Scene& scene,
                                const Interrupt& interrupt) {
  std::vector<GridRow> rows;
  for (const int n : {25, 50, 100, 200}) {
    rows.push_back({n, tau_on_mesh(scene, 1, n, interrupt),
                    tau_on_mesh(scene, 5, n + 1, interrupt),
                    solve_paper_equations(scene, n)});
  }
  return rows;
}

std::vector<OrientationRow> fastest_orientations(Scene scene,
                                                 const Interrupt& interrupt) {
  std::vector<OrientationRow> rows;
  double guess = -kPi / 6.0;
  const double largest = std::sqrt(1.0 - scene.body.k);
  constexpr int kSteps = 14;
  for (int i = 1; i <= kSteps; ++i) {
    scene.body.eta_m = largest * i / kSteps;
    rows.push_back(
        {scene.body.eta_m, fastest_orientation(scene, guess, interrupt)});
    guess = rows.back().fastest.theta_m.value;
  }
  return rows;
}

std::vector<RadiusRow> uniform_of_radius(Scene scene,
                                         const Interrupt& interrupt) {
  std::vector<RadiusRow> rows;
  for (const double radius : {0.5, 1.0 / 3.0, 0.2, 0.1, 0.01, 0.001}) {
    scene.body.radius = radius;
    rows.push_back({radius, verified_tau(scene, interrupt)});
  }
  return rows;
}

double bead_between_ends(const Motion& motion, const Interrupt& interrupt) {
  const Point start = motion.at(0.0).centre;
  const Point end = motion.at(1.0).centre;
  Scene scene;
  scene.body = Body::bead();
  scene.L = end.x - start.x;
  scene.H = end.z - start.z;
  scene.gravity = motion.scene().gravity;
  // τ refers to the H of the other scene.
  return verified_tau(scene, interrupt) * std::sqrt(scene.H / motion.scene().H);
}

double largest_distance(const Motion& a, const Motion& b) {
  constexpr int kPlaces = 400;
  double largest = 0.0;
  for (int i = 0; i <= kPlaces; ++i) {
    const double sigma = static_cast<double>(i) / kPlaces;
    const Point p = a.at(sigma).motion.contact;
    const Point q = b.at(sigma).motion.contact;
    largest = std::max(largest, distance(p, q));
  }
  return largest;
}

ShiftByInertia shift_by_inertia(const Cases& cases,
                                const Interrupt& interrupt) {
  const Case& light = cases["fig10_k_0.1"];
  const Case& heavy = cases["fig10_k_5_9"];
  const auto uniform = [&](const Case& one) {
    Scene scene = cases["fig06_uniform_cylinder"].scene();
    scene.body.k = one.scene().body.k;
    return verified_solution(scene, interrupt);
  };
  const Solution uniform_light = uniform(light);
  const Solution uniform_heavy = uniform(heavy);
  return {largest_distance(*uniform_light.motion(), *uniform_heavy.motion()),
          largest_distance(light.motion(), heavy.motion())};
}

double uniform_on_incline(const Cases& cases, const Interrupt& interrupt) {
  Scene scene = cases["fig04_straight"].scene();
  scene.body = cases["fig06_uniform_cylinder"].scene().body;
  return verified_tau(scene, interrupt);
}

std::vector<BackwardStart> backward_starts(Scene scene,
                                           const Interrupt& interrupt) {
  std::vector<BackwardStart> rows;
  for (const double degrees :
       {-175.0, -150.0, -120.0, -100.0, 100.0, 120.0, 150.0, 175.0}) {
    scene.body.theta_m = degrees * kPi / 180.0;
    rows.push_back(
        {scene.body.theta_m, verified_solution(scene, interrupt).feasible()});
  }
  return rows;
}

std::vector<BentTrack> kinked_reference(const Motion& reference,
                                        const Interrupt& interrupt) {
  constexpr double kFirst = 0.352;  // [rad], beyond the smooth contact
  constexpr double kLast = -2.048;  // beyond the least time, at −1.768
  constexpr int kSteps = 60;
  std::vector<BentTrack> tracks;
  for (int i = 0; i <= kSteps; ++i) {
    const double phi =
        std::lerp(kFirst, kLast, static_cast<double>(i) / kSteps);
    tracks.push_back(
        {.phi = phi,
         .tau = tau_of_kinked_track(reference.scene(), phi, interrupt)});
  }
  return tracks;
}

std::vector<BentTrack> arched_reference(const Scene& reference,
                                        const Interrupt& interrupt) {
  constexpr double kRadius = 0.1;
  // Of the time on a spline through points.
  constexpr double kTolerance = 1e-8;
  std::vector<BentTrack> tracks;
  for (const double phi : {-0.2, -0.3, -0.4, -0.5, -0.6, -0.7, -0.8, -0.9, -1.0,
                           -1.1, -1.2, -1.3, -1.4, -1.5}) {
    const Solution solution = verified_solution(
        bent_track(reference, phi, kRadius, interrupt), interrupt, kTolerance);
    tracks.push_back(
        {phi, kRadius, solution.motion()->tau(), solution.feasible()});
  }
  return tracks;
}

/// For L = 2, 3 and 4.
std::vector<QuickestBody> quickest_bodies(Scene reference,
                                          const Interrupt& interrupt) {
  std::vector<QuickestBody> rows;
  for (const double L : {2.0, 3.0, 4.0}) {
    reference.L = L * reference.H;
    for (const bool any_k : {true, false}) {
      DesignPlan plan;
      plan.free = {BodyKey::EtaM, BodyKey::ThetaM};
      if (any_k) plan.free.push_back(BodyKey::K);
      plan.starts = kDesignStarts;
      std::vector<DesignSearch> searches;
      for (int start = 1; start <= plan.starts; ++start) {
        try {
          searches.push_back(
              search_design(reference, {}, plan, start, &interrupt));
        } catch (const Stopped&) {
          check(interrupt);
          throw;
        }
        check(interrupt);
      }
      std::optional<DesignMinimum> best =
          gather_designs(plan, std::move(searches)).best;
      if (best && !(best->verified && best->feasible)) best.reset();
      rows.push_back({L, any_k, std::move(best)});
    }
  }
  return rows;
}

/// What comparison, statements and figures refer to by name.
std::vector<std::string> needed_cases() {
  std::vector<std::string> names{"check_uniform_half_arch",
                                 "fig03_incline",
                                 "fig04_circular_arc",
                                 "fig04_cycloid",
                                 "fig04_parabola",
                                 "fig04_straight",
                                 "fig06_bead",
                                 "fig06_uniform_cylinder",
                                 "fig13_faster_than_bead"};
  for (const Members family : std::initializer_list<Members>{
           kByOffset, kByOrientation, kByInertia, kByRadius, kByRadiusOfTheText,
           kByLength}) {
    for (const Member& member : family) names.emplace_back(member.file);
  }
  return names;
}

/// Solves a sweep with the program's own workers, by all cores and without
/// leaving files.
SweepTable solve_family(const sweep::Job& job, int jobs,
                        const Interrupt& interrupt,
                        const sweep::ProgressSink& progress) {
  constexpr double kSecondsPerScene = 120.0;
  const sweep::ScratchDirectory scratch;
  sweep::Store store =
      sweep::Store::create(scratch.path(), sweep::store_info(job, "1/1"));
  const sweep::ManagerOptions options{.program = "/proc/self/exe",
                                      .jobs = jobs,
                                      .seconds_per_scene = kSecondsPerScene,
                                      .interrupt = &interrupt};
  sweep::run_manager(job, store, options, progress);
  SweepTable table = sweep::read_table(store, job);
  check(interrupt);
  for (const SweepOutcome& outcome : table.outcomes) {
    if (outcome.state != SweepOutcome::State::Verified) {
      throw NotVerified(job.name +
                        ": a scene has no verified answer: " + outcome.message);
    }
  }
  return table;
}

}  // namespace

double largest_error(const std::vector<OrientationRow>& rows) {
  const auto error = [](const OrientationRow& row) {
    return row.fastest.theta_m.error;
  };
  return error(std::ranges::max(rows, {}, error));
}

std::size_t column_of(const SweepTable& table, const char* key) {
  const auto found = std::ranges::find(table.columns, key, &SweepColumn::key);
  if (found != table.columns.end()) {
    return static_cast<std::size_t>(found - table.columns.begin());
  }
  throw std::runtime_error(fmt::format("the map does not vary {}", key));
}

std::vector<MapRow> rows_of(const SweepTable& map) {
  const SweepColumn& eta_m = map.columns[column_of(map, kEtaKey)];
  const SweepColumn& theta_m = map.columns[column_of(map, kThetaKey)];
  const std::size_t count = map.axes.back().count;
  std::vector<MapRow> rows;
  for (std::size_t i = 0; i < map.outcomes.size(); ++i) {
    if (i % count == 0) rows.push_back({eta_m.numbers[i], {}});
    rows.back().points.push_back({theta_m.numbers[i], map.outcomes[i].tau});
  }
  return rows;
}

Results find_all(const std::filesystem::path& directory, const Hooks& hooks) {
  const Interrupt& interrupt = *hooks.interrupt;
  // What is wrong with it is told before the work begins.
  const sweep::Job map =
      sweep::read_job(directory / "sweeps" / "fig13_map.yaml", {});
  Results out{.cases =
                  Cases(directory, needed_cases(), interrupt, hooks.announce)};
  const Scene& reference = out.cases["fig04_reference_case"].scene();
  const Case& fast = out.cases["fig13_faster_than_bead"];
  hooks.announce("grid study");
  out.grid = grid_study(reference, interrupt);
  constexpr int kNodes = 100;
  for (const char* name :
       {"fig06_uniform_cylinder", "fig04_reference_case", "fig12_L_2",
        "fig12_L_4", "fig13_faster_than_bead"}) {
    out.equations[name] =
        solve_paper_equations(out.cases[name].scene(), kNodes);
  }
  hooks.announce("uniform cylinders");
  out.uniform =
      uniform_of_radius(out.cases["fig06_uniform_cylinder"].scene(), interrupt);
  out.bead_between_centres = bead_between_ends(fast.motion(), interrupt);
  hooks.announce("other bodies on the paper's tracks");
  out.shift_by_inertia = shift_by_inertia(out.cases, interrupt);
  out.uniform_on_incline = uniform_on_incline(out.cases, interrupt);
  out.backward_starts = backward_starts(reference, interrupt);
  hooks.announce("slopes at B");
  out.kinked =
      kinked_reference(out.cases["fig04_reference_case"].motion(), interrupt);
  out.arched = arched_reference(reference, interrupt);
  hooks.announce("best orientations");
  out.orientations = fastest_orientations(reference, interrupt);
  hooks.announce("bodies as fast as the bead");
  constexpr int kSteps = 20;
  std::vector<double> eta_m;
  for (int i = 0; i <= kSteps; ++i) {
    eta_m.push_back((1.0 - 1.0 / kSteps) * i / kSteps);
  }
  out.boundary = bead_boundary(fast.scene(), eta_m, false, interrupt);
  hooks.announce("the same, put down best");
  out.best_boundary = bead_boundary(fast.scene(), eta_m, true, interrupt);
  hooks.announce("the quickest bodies");
  out.quickest = quickest_bodies(reference, interrupt);
  hooks.announce("map of transit times");
  out.map = solve_family(map, hooks.jobs, interrupt, hooks.progress);
  hooks.announce("figures");
  return out;
}

}  // namespace brachisto::reproduction
