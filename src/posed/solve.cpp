// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// From a statement to a checked answer: mesh from mesh, each solved twice, as
// it is and with its elements cut in two.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>

#include "brachisto/math/index.hpp"
#include "brachisto/posed/problem.hpp"
#include "math/cpu_clock.hpp"
#include "posed/bounds.hpp"
#include "posed/certificate.hpp"
#include "posed/free_junctions.hpp"
#include "posed/guess.hpp"
#include "posed/mesh_path.hpp"
#include "posed/mistakes.hpp"
#include "posed/on_mesh.hpp"
#include "posed/refine.hpp"
#include "posed/settle.hpp"

namespace brachisto::ocp {

namespace {

class Solve {
 public:
  Solve(const Posed& problem, const SolveBy& by)
      : problem_(problem),
        by_(by),
        said_(problem.statement()),
        states_(said_.states.size() + said_.parameters.size()),
        solver_(problem, by) {}

  [[nodiscard]] Answer run();

 private:
  /// Moves both paths' kinks to where they belong; false if it cannot.
  [[nodiscard]] bool settle(OnMesh& coarse, OnMesh& fine,
                            std::vector<RefinedMesh::Junction>& junctions);
  /// What a pass came to, with all that its estimate consists of but places.
  struct Judged {
    HeldAlong held;
    std::vector<double> errors;  ///< of elements
    double size, error;
  };
  [[nodiscard]] Judged judged(OnMesh& coarse, OnMesh& fine);
  /// Keeps it if it is the best one. True if its error is small enough.
  bool keep(OnMesh& fine, const Judged& pass,
            const std::vector<RefinedMesh::Junction>& junctions,
            const std::vector<double>& not_settled);
  /// Solves with the places of jumps as unknowns, on finer meshes if need be;
  /// true once the error is small enough.
  bool free_junctions(const RefinedMesh& next, const MeshPath& nearby);
  void put_down(OnMesh& fine, const HeldAlong& held,
                const std::vector<RefinedMesh::Junction>& junctions);
  [[nodiscard]] std::string why_not_nearer(const MeshPath& path) const;
  const Posed& problem_;
  const SolveBy& by_;
  const Statement& said_;
  std::size_t states_;
  MeshSolver solver_;
  Answer answer_;
  std::optional<OnMesh> best_;
  double relative_ = kNoBound;       // error of the best one
  std::vector<double> not_settled_;  // times
  double worst_ = 0.0;               // the time where it errs most
};

bool Solve::settle(OnMesh& coarse, OnMesh& fine,
                   std::vector<RefinedMesh::Junction>& junctions) {
  std::array<std::optional<Settled>, 2> found;
  const std::array both{&coarse, &fine};
  for (std::size_t i = 0; i < both.size(); ++i) {
    OnMesh& here = *both[i];
    found[i] = settled(problem_, *here.program, here.path(), here.result.point,
                       junctions);
    if (!found[i]) return false;
  }
  for (RefinedMesh::Junction& junction : junctions) {
    if (junction.half_width > 0.0) continue;
    const int behind = fine.mesh.locate(junction.sigma).element;
    junction = {found[1]->mesh.boundaries[at(behind)], 0.0, 0.0};
  }
  for (std::size_t i = 0; i < both.size(); ++i) {
    OnMesh& here = *both[i];
    here.mesh = std::move(found[i]->mesh);
    here.program = std::move(found[i]->program);
    here.result.point = std::move(found[i]->point);
    here.cost = found[i]->cost;
    here.gap = 0.0;
    here.exact = true;
  }
  return true;
}

void Solve::put_down(OnMesh& fine, const HeldAlong& held,
                     const std::vector<RefinedMesh::Junction>& junctions) {
  answer_.cost = fine.cost;
  answer_.duration = fine.path().duration();
  answer_.parameters.clear();
  for (std::size_t s = said_.states.size(); s < states_; ++s) {
    answer_.parameters.push_back(
        fine.result.point.x[at(fine.layout.state(0, static_cast<int>(s)))] *
        problem_.scales()[s]);
  }
  answer_.junctions.clear();
  for (int c = 0; c + 1 < fine.layout.num_points(); ++c) {
    if (held[at(c)] == held[at(c + 1)]) continue;
    double place = 0.5 * (sigma(fine.mesh, c) + sigma(fine.mesh, c + 1));
    for (const RefinedMesh::Junction& kink : junctions) {
      const int p = fine.mesh.degree;
      const bool beside =
          kink.sigma >= fine.mesh.boundaries[at(c / p)] &&
          kink.sigma <= fine.mesh.boundaries[at((c + 1) / p + 1)];
      if (kink.half_width == 0.0 && beside) place = kink.sigma;
    }
    if (!answer_.junctions.empty() &&
        answer_.junctions.back() == place * answer_.duration) {
      continue;
    }
    answer_.junctions.push_back(place * answer_.duration);
  }
  answer_.made_of.mesh = fine.mesh;
  answer_.made_of.point = fine.result.point;
  // Without the places of free junctions.
  for (std::vector<double>* values :
       {&answer_.made_of.point.x, &answer_.made_of.point.z_lower,
        &answer_.made_of.point.z_upper}) {
    if (!values->empty()) values->resize(at(fine.layout.num_variables()));
  }
  put_prices(problem_, *fine.program, fine.path(), fine.result.point, answer_);
}

Solve::Judged Solve::judged(OnMesh& coarse, OnMesh& fine) {
  const double size = solver_.size_of_cost(fine);
  const double change = std::abs(coarse.cost - fine.cost);
  const int iterations = solver_.take_iterations();
  answer_.passes.push_back(
      {fine.mesh.num_elements(), iterations, fine.cost, change});
  if (by_.verbose) {
    std::fprintf(stderr, "%s: %d elements, %d iterations, %.14g, change %.1e\n",
                 said_.name.c_str(), fine.mesh.num_elements(), iterations,
                 fine.cost, change);
  }
  const MeshPath coarse_path = coarse.path(), fine_path = fine.path();
  HeldAlong held =
      held_along(*fine.program, fine.result.point, fine.mesh, fine.layout);
  std::vector<double> errors =
      element_errors(problem_, {coarse_path, fine_path, held});
  Answer priced;
  put_prices(problem_, *fine.program, fine_path, fine.result.point, priced);
  // Next to junctions the finer path need not be the better one.
  constexpr double kRounding = 1e-14;
  const double error = 2.0 * change + fine.gap + kRounding * size +
                       cost_between_points(problem_, fine_path, priced.prices);
  return {std::move(held), std::move(errors), size, error};
}

bool Solve::keep(OnMesh& fine, const Judged& pass,
                 const std::vector<RefinedMesh::Junction>& junctions,
                 const std::vector<double>& not_settled) {
  // An error that is no number is no bound: any other is better.
  const double error = std::isnan(pass.error) ? kNoBound : pass.error;
  if (!best_ || error / pass.size < relative_) {
    relative_ = error / pass.size;
    answer_.estimated_error = error;
    put_down(fine, pass.held, junctions);
    not_settled_.clear();
    for (const double place : not_settled) {
      not_settled_.push_back(place * answer_.duration);
    }
    const auto worst = std::ranges::max_element(pass.errors);
    // Of the mesh that was cut in two.
    const auto element = 2 * (worst - pass.errors.begin()) + 1;
    worst_ =
        fine.mesh.boundaries[at(static_cast<int>(element))] * answer_.duration;
    best_.emplace(std::move(fine));
  }
  return relative_ <= by_.tolerance;
}

bool Solve::free_junctions(const RefinedMesh& next, const MeshPath& nearby) {
  constexpr int kMeshes = 6, kIterations = 100;
  const int most = std::min(kIterations, by_.most_iterations);
  RefinedMesh first{next.boundaries, {}};
  for (const RefinedMesh::Junction& junction : next.junctions) {
    first.junctions.push_back({junction.sigma});
  }
  Mesh mesh = first.mesh(by_.degree);
  std::vector<double> places;
  for (const RefinedMesh::Junction& one : first.junctions) {
    if (std::ranges::count(mesh.boundaries, one.sigma) == 0) return false;
    places.push_back(one.sigma);
  }
  MeshPath from = nearby;
  for (int i = 0; i < kMeshes; ++i) {
    const auto solved_on = [&](const Mesh& on) -> std::optional<OnMesh> {
      std::vector<int> free;
      for (const double place : places) {
        const auto here = std::ranges::find(on.boundaries, place);
        if (here == on.boundaries.end()) return std::nullopt;
        free.push_back(static_cast<int>(here - on.boundaries.begin()));
      }
      auto found = with_free_junctions(problem_, solver_, on, free, from, most);
      if (!found) return std::nullopt;
      from = found->path();
      for (std::size_t k = 0; k < free.size(); ++k) {
        places[k] = found->mesh.boundaries[at(free[k])];
      }
      return found;
    };
    auto coarse = solved_on(mesh);
    if (!coarse) return false;
    mesh = coarse->mesh;
    auto fine = solved_on(halved(mesh));
    if (!fine) return false;
    const Judged pass = judged(*coarse, *fine);
    std::vector<RefinedMesh::Junction> junctions;
    for (const double place : places) junctions.push_back({place});
    const bool holds =
        first_order(*fine->program, fine->result.point).max() < kAsCertified;
    if (holds && keep(*fine, pass, junctions, {})) return true;
    const double share = 0.3 * by_.tolerance * pass.size / mesh.num_elements();
    // With the places of the finer path.
    for (std::size_t b = 0; b < mesh.boundaries.size(); ++b) {
      mesh.boundaries[b] = from.mesh().boundaries[2 * b];
    }
    RefinedMesh finer{mesh.boundaries, {}};
    for (int e = 0; e < mesh.num_elements(); ++e) {
      cut(mesh, e, holds ? pass.errors[at(e)] / share : 2.0, finer.boundaries);
    }
    if (finer.boundaries.size() == mesh.boundaries.size()) return false;
    mesh = finer.mesh(by_.degree);
    if (mesh.num_elements() > by_.most_elements) return false;
  }
  return false;
}

std::string Solve::why_not_nearer(const MeshPath& path) const {
  if (std::string turn = turned(problem_, path); !turn.empty()) return turn;
  if (std::string jump = jump_along(problem_, path); !jump.empty()) return jump;
  return fmt::format(
      "the estimated error stays at {:.1e}, {:.1e} is wanted; {}", relative_,
      by_.tolerance,
      not_settled_.empty()
          ? fmt::format("it is largest near t = {:.4g}, where a control may "
                        "jump or be singular",
                        worst_)
          : fmt::format("not settled is where bounds begin or cease to hold "
                        "at t = {:.5g}; try another degree or number of "
                        "elements",
                        fmt::join(not_settled_, ", ")));
}

Answer Solve::run() {
  const double began = thread_cpu_seconds();
  answer_.made_of.statement = said_;
  answer_.made_of.scales = problem_.scales();
  RefinedMesh next{uniform_mesh(by_.degree, by_.elements).boundaries, {}};
  std::optional<MeshPath> nearby;
  constexpr int kTries = 10;
  int tries = 0;                // with free junctions
  double last_cost = kNoBound;  // of the mesh before
  // What the cost errs by as junctions are not quite where they are taken to
  // be, which both meshes of a pass have in common: it falls with the square of
  // how far they move. Nothing once they are settled, kinks all of them.
  const auto by_places = [&](const RefinedMesh& now, const RefinedMesh& after,
                             double cost, bool settled) {
    if (after.has_new()) return kNoBound;
    if (settled && !now.has_width() && !after.has_width()) return 0.0;
    if (after.junctions.empty()) return 0.0;
    constexpr double kOfJumps = 2.0, kAsKnown = 1e-5;
    const double change = std::abs(cost - last_cost);
    if (after.has_width()) return kOfJumps * change;
    return change *
           std::min(1.0, std::max(kAsKnown, after.moved()) / now.moved());
  };
  const auto ended = [&](Status status, std::string message) {
    answer_.status = status;
    answer_.message = said_.name + ": " + std::move(message);
  };
  ended(Status::NotConverged, "");
  for (int pass = 0; pass < by_.most_passes; ++pass) {
    const Mesh mesh = next.mesh(by_.degree);
    OnMesh coarse = nearby ? solver_.solved_near(*nearby, mesh)
                           : solver_.solved_from_guess(mesh);
    OnMesh* failed = coarse.solved() ? nullptr : &coarse;
    std::optional<OnMesh> halves;
    if (failed == nullptr) {
      halves.emplace(solver_.solved_near(coarse.path(), halved(mesh)));
      if (!halves->solved()) failed = &*halves;
    }
    if (failed != nullptr) {
      if (by_.verbose) {
        std::fprintf(stderr, "%s: %d elements: %s\n", said_.name.c_str(),
                     failed->mesh.num_elements(),
                     failed->result.message.c_str());
      }
      if (!best_ || was_stopped(failed->result.status)) {
        ended(failed->result.status, failed->result.message);
      }
      break;
    }
    OnMesh& fine = *halves;
    const bool settled =
        next.has_kinks() && settle(coarse, fine, next.junctions);
    Judged found = judged(coarse, fine);
    const MeshPath coarse_path = coarse.path(), fine_path = fine.path();
    const double share = 0.3 * by_.tolerance * found.size / mesh.num_elements();
    RefinedMesh after = refined(next, {coarse_path, fine_path, found.held},
                                found.errors, share);
    std::vector<double> not_settled;
    found.error += by_places(next, after, fine.cost, settled);
    last_cost = fine.cost;
    if (!settled) {
      for (const RefinedMesh::Junction& junction : next.junctions) {
        if (junction.half_width == 0.0) not_settled.push_back(junction.sigma);
      }
    }
    nearby.emplace(fine_path);
    if (keep(fine, found, next.junctions, not_settled) ||
        (after.all_jump() && tries++ < kTries &&
         free_junctions(after, fine_path))) {
      ended(Status::Solved, "solved");
      break;
    }
    if (after.mesh(by_.degree).boundaries == mesh.boundaries) {
      for (int e = 0; e < mesh.num_elements(); ++e) {
        after.boundaries.push_back(mesh.sigma(e, 0.5));
      }
      std::ranges::sort(after.boundaries);
    }
    if (after.mesh(by_.degree).num_elements() > by_.most_elements) break;
    next = std::move(after);
  }
  if (best_) {
    const MeshPath path = best_->path();
    if (answer_.status == Status::NotConverged) {
      ended(Status::NotConverged, why_not_nearer(path));
    }
    answer_.certificate =
        certify(problem_, *best_->program, best_->result.point, path, relative_,
                by_.tolerance, best_->exact);
  }
  answer_.seconds = thread_cpu_seconds() - began;
  return answer_;
}

}  // namespace

Answer solve(const Posed& problem, const SolveBy& by) {
  check(problem, by);
  return Solve(problem, by).run();
}

}  // namespace brachisto::ocp
