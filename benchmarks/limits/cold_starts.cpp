// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Do limits that were given up as too tight keep a path after all? The program
// on one mesh, or some twice as fine each, its limits giving way at a price,
// from random paths that owe nothing to the search, with the contact closed:
// under the limits of a problem file, or under those of its `relaxed` answer,
// brought nearer to what is asked for.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include "brachisto/io/problem_file.hpp"
#include "brachisto/solvers/program_solvers.hpp"
#include "model/loosened_limits.hpp"
#include "nlp/elastic.hpp"
#include "refinement/open_conditions.hpp"
#include "refinement/random_path.hpp"
#include "study/pose.hpp"
#include "support/processes.hpp"
#include "support/text.hpp"

using namespace brachisto;
using namespace brachisto::benchmarks;

namespace {

struct Study {
  Scene asked;
  double by = 0.0;  ///< of loosened_limits()
  bool free_slopes = false;
  int elements = 30, degree = 3, halvings = 0, iterations = 300;
  double waviness = 0.5;  ///< of the starts, in L or H
};

/// What a start led to.
struct Record {
  enum class Fate { Unsolved, Winds, GivesWay, Open, Keeps };
  Fate fate = Fate::Unsolved;
  double give = 0.0;  ///< by which limits give way, in natural units
  double open = 0.0;  ///< what the slope at B is off [rad]
  double tau = 0.0, start = 0.0, phi = 0.0;
  int iterations = 0, attempts = 0;
  FixedText<120> reason;
};
constexpr std::array kFates{"unsolved", "winds", "gives way", "open", "keeps"};

class Attempt {
 public:
  Attempt(const Study& study, std::uint64_t seed)
      : study_(study),
        posed_(pose(loosened(study.asked, study.by), {}, {})),
        limits_(inequalities(posed_.limited->body, posed_.limited->limits)),
        random_(SplitMix64::scrambled(seed)) {}

  /// On meshes twice as fine each, for as long as limits are kept.
  Record run() {
    const RandomPath path =
        some_random_path(scene(), study_.waviness, random_, record_.attempts);
    ends_.free_contacts =
        study_.free_slopes || scene().contact == Contact::Optimal;
    ends_.phi = scene().end_slope.value_or(path.at.back().beta);
    ends_.start = path.at.front().beta;
    for (int halvings = 0; halvings <= study_.halvings; ++halvings) {
      const Mesh mesh =
          uniform_mesh(study_.degree, study_.elements << halvings);
      if (close(mesh, path).fate != Record::Fate::Keeps) break;
    }
    return record_;
  }

 private:
  [[nodiscard]] const Scene& scene() const { return *posed_.limited; }
  Record end(Record::Fate fate, std::string_view reason = {}) {
    record_.fate = fate;
    record_.reason = FixedText<120>(reason);
    return record_;
  }

  /// The contact.
  Record close(const Mesh& mesh, const RandomPath& path) {
    constexpr double kNone = 1e-6, kClosed = 1e-5;
    constexpr int kMostPasses = 30;
    for (int pass = 0; pass < kMostPasses; ++pass) {
      if (!ends_.free_contacts) {
        const auto there = with_start(ends_, scene(), limits_,
                                      curve_ && curve_->holds_control(0));
        if (!there) return end(Record::Fate::Unsolved, "no start at rest");
        ends_ = *there;
      }
      if (!solve(mesh, path)) return record_;
      const bool sought = !ends_.free_contacts && end_is_sought(scene());
      const double slope = sought ? end_slope(*curve_) : ends_.phi;
      record_.open = slope - ends_.phi;
      record_.phi = curve_->at(1.0).state.beta;
      record_.start = curve_->at(0.0).state.beta;
      record_.tau = curve_->transit_time() / std::sqrt(scene().H);
      if (std::abs(record_.open) <= kClosed) {
        return end(record_.give <= kNone ? Record::Fate::Keeps
                                         : Record::Fate::GivesWay);
      }
      ends_.phi += std::clamp(record_.open, -0.3, 0.3);
      ends_.start = curve_->start_slope();
    }
    return end(record_.give <= kNone ? Record::Fate::Open
                                     : Record::Fate::GivesWay);
  }

  /// From the path before, else the random one.
  bool solve(const Mesh& mesh, const RandomPath& path) {
    constexpr double kGive = 1.0, kPrice = 1e3;
    LimitedTime problem(scene(), limits_, mesh, ends_);
    problem.bound_slopes(std::numbers::pi);
    const VariableLayout& layout = problem.layout();
    std::vector<double> give(at(problem.num_constraints()), 0.0);
    const auto gives = [&](int row) {
      if (problem.constraint_range(row).bounded()) give[at(row)] = kGive;
    };
    for (int i = 0; i < layout.num_limits(); ++i) {
      const bool meaning = scene().contact == Contact::Optimal &&
                           limits_[at(i)].kind == PathInequality::Kind::Hump;
      if (meaning) continue;  // without it free slopes have none
      for (int c = 0; c < layout.num_points(); ++c) gives(layout.limit(c, i));
      if (i < layout.num_start_rows()) gives(layout.start_row(i));
    }
    nlp::Elastic elastic(problem, std::move(give), kPrice);
    PrimalDual start = curve_ ? elastic.with_elasticity(
                                    prolong(*curve_, problem), record_.give)
                              : start_on(problem, path);
    if (!curve_) start.x.push_back(1.0);
    IpoptOptions ipopt;
    ipopt.tolerance = 1e-8;
    ipopt.complementarity = 1e-9;
    ipopt.max_iterations = study_.iterations;
    SolverResult found = solve_with_ipopt(elastic, start, ipopt);
    record_.iterations += found.iterations;
    if (found.status != Status::Solved) {
      end(Record::Fate::Unsolved, found.message);
      return false;
    }
    record_.give = found.point.x.back();
    curve_.emplace(problem, elastic.without_elasticity(std::move(found.point)));
    for (int node = 0; node < layout.num_nodes(); ++node) {
      const double beta =
          curve_->point().x[at(layout.state(node, StateComponent::Beta))];
      if (std::abs(beta) > 0.999 * std::numbers::pi) {
        end(Record::Fate::Winds);
        return false;
      }
    }
    return true;
  }

  const Study& study_;
  PosedProblem posed_;
  std::vector<PathInequality> limits_;
  SplitMix64 random_;
  LimitedEnds ends_;
  std::optional<LimitedCurve> curve_;
  Record record_;
};

/// By how much the limits of an answer are loosened.
double loosened_by(const Scene& asked, const PathLimits& relaxed) {
  const auto size = [](const PathLimits& limits) {
    double sum =
        limits.friction.value_or(0.0) - limits.normal_min.value_or(0.0) +
        limits.normal_max.value_or(0.0) + limits.curvature.hump.value_or(0.0) +
        limits.curvature.valley.value_or(0.0) -
        limits.fold_margin.value_or(0.0) + limits.floor.value_or(0.0);
    for (const Disc& disc : limits.discs) sum -= disc.radius;
    for (const HalfPlane& plane : limits.half_planes) {
      sum -= plane.point.x * std::cos(plane.normal) +
             plane.point.z * std::sin(plane.normal);
    }
    return sum;
  };
  double less = 0.0, more = 1.0;
  for (int i = 0; i < 60; ++i) {
    const double by = 0.5 * (less + more);
    (size(loosened_limits(asked, by)) < size(relaxed) ? less : more) = by;
  }
  return 0.5 * (less + more);
}

}  // namespace

int main(int argc, char** argv) {
  Study study;
  std::string file;
  int starts = 20;
  std::uint64_t seed = 1;
  double nearer = 0.1;
  bool as_asked = false;
  ProcessLimits limits{.jobs = 1, .cpu_seconds = 20};
  CLI::App app{"Whether cold starts keep limits that a search gave up"};
  app.add_option("file", file, "Problem with limits")->required();
  app.add_flag("--as-asked", as_asked,
               "Under the limits of the file, which is not solved");
  app.add_option("--by", study.by, "Under its limits loosened by so much");
  app.add_option("--nearer", nearer,
                 "Else nearer than its relaxed answer by such a share")
      ->capture_default_str();
  app.add_flag("--free-slopes", study.free_slopes,
               "Of paths with any slopes at A and B");
  app.add_option("--starts", starts, "Random paths")->capture_default_str();
  app.add_option("--seed", seed, "Of the starts")->capture_default_str();
  app.add_option("--waviness", study.waviness,
                 "Of the starts, in L or H, the larger one")
      ->capture_default_str();
  app.add_option("--elements", study.elements, "Of the mesh")
      ->capture_default_str();
  app.add_option("--halvings", study.halvings,
                 "Of its elements, limits being kept on each mesh")
      ->check(CLI::Range(0, 10))
      ->capture_default_str();
  app.add_option("--degree", study.degree, "Of its elements")
      ->capture_default_str();
  app.add_option("--seconds", limits.cpu_seconds,
                 "Of processor time for a start")
      ->capture_default_str();
  app.add_option("--jobs", limits.jobs, "Processes at a time")
      ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  limits.seconds = 6 * limits.cpu_seconds;

  const io::ProblemFile problem = io::read_problem_file(file);
  study.asked = problem.scene;
  if (!as_asked && study.by == 0.0) {
    const Solution found = solve(problem.scene, problem.options);
    if (found.verified() || !found.relaxed) {
      fmt::print("{}: {}\n", file,
                 found.verified() ? "verified as asked" : "no relaxed answer");
      return found.verified() ? 0 : 1;
    }
    const double by = loosened_by(study.asked, found.relaxed->scene.limits);
    study.by = by * (1.0 - nearer);
    fmt::print("{}: answered under limits loosened by {:.4g}\n", file, by);
  }
  std::array<int, kFates.size()> ended{};
  double least = std::numeric_limits<double>::infinity();
  run_isolated<Record>(
      starts, limits,
      [&](int i) {
        return Attempt(study, seed + static_cast<std::uint64_t>(i)).run();
      },
      [&](int i, const std::optional<Record>& record, const std::string& fate) {
        Record one = record.value_or(Record{});
        if (!record) one.reason = FixedText<120>(fate);
        ++ended.at(static_cast<std::size_t>(one.fate));
        if (one.fate == Record::Fate::GivesWay) {
          least = std::min(least, one.give);
        }
        fmt::print(
            "start {:<3} {:<10} τ {:<9.6g} gives way {:<8.2g} off {:<8.1g} "
            "β₀ {:<8.4f} φ {:<8.4f} {:>5} iterations  {}\n",
            i, kFates.at(static_cast<std::size_t>(one.fate)), one.tau, one.give,
            one.open, one.start, one.phi, one.iterations, one.reason.str());
        std::fflush(stdout);  // a run that is stopped has told what it knew
      });
  const int keep = ended.at(static_cast<std::size_t>(Record::Fate::Keeps));
  fmt::print("{}: {} of {} cold starts keep its limits loosened by {:.4g}",
             file, keep, starts, study.by);
  for (std::size_t i = 0; i < kFates.size(); ++i) {
    fmt::print("{} {} {}", i == 0 ? ";" : ",", ended.at(i), kFates.at(i));
  }
  fmt::print("; least give {:.2g}\n", least);
  return keep == 0 ? 0 : 1;
}
