// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The protocol of a refinement while it is written, and how long a pass is.

#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "brachisto/run/solve_options.hpp"
#include "refinement/refinement.hpp"

namespace brachisto {

/// How far a pass of Ipopt may go: not far next to a solution, or where it is
/// one of many tries.
enum class Pass { Short, Long };

/// So many steps, and what they factorise if they go well, of variables and
/// constraints: slacks count too, and some steps factorise twice. Beyond that
/// it goes in circles, with several factorisations a step and many dense
/// fronts; small programs may do so for a while in a long one. Of a thousand
/// makers' scenes none is lost by it.
[[nodiscard]] inline IpoptOptions of_pass(Pass pass, IpoptOptions ipopt,
                                          const nlp::Problem& problem) {
  struct Bounds {
    int iterations;
    double factorised, least_effort;
  };
  const Bounds most =
      pass == Pass::Short ? Bounds{100, 3.0, 0.0} : Bounds{400, 2.0, 1.2e7};
  ipopt.max_iterations = std::min(ipopt.max_iterations, most.iterations);
  ipopt.most_effort = std::min(
      ipopt.most_effort,
      std::max(most.least_effort,
               most.factorised * most.iterations *
                   (problem.num_variables() + problem.num_constraints())));
  return ipopt;
}

/// What passes report to. They add to one record until it is kept, those that
/// failed on the way included.
struct PassProtocol : RefinementProtocol {
  MeshRecord record;      ///< of the passes since the last one was kept
  ProgressHook progress;  ///< may be empty
  /// Steps of solvers, each times the equations that it solves, and how much of
  /// that a search may take: unlike a limit of time, the same on all machines.
  double work = 0.0, most_work = std::numeric_limits<double>::infinity();

  int most_iterations;             ///< of Ipopt, in all passes
  std::vector<std::string> tried;  ///< ways, in words, each once
  StopCondition stop;

  explicit PassProtocol(const MeshOptions& options)
      : progress(options.progress),
        most_iterations(options.ipopt.max_iterations),
        stop(options.ipopt.stop) {}

  void tries(std::string way) {
    if (std::ranges::find(tried, way) != tried.end()) return;
    tried.push_back(std::move(way));
  }

  /// \return false, for callers that tell so whether they found anything
  bool fail(Status why, std::string text) {
    status = why;
    message = std::move(text);
    return false;
  }
  /// Whether a search has to end with what it has.
  [[nodiscard]] bool stopped() const { return stop.met() || worked_enough(); }
  [[nodiscard]] bool worked_enough() const { return work >= most_work; }
  void book(int steps, const nlp::Problem& problem) {
    work += static_cast<double>(steps) *
            (problem.num_variables() + problem.num_constraints());
  }
  /// With the iterations that are left.
  [[nodiscard]] IpoptOptions left(IpoptOptions ipopt) const {
    int iterations = most_iterations - record.iterations;
    for (const MeshRecord& mesh : meshes) iterations -= mesh.iterations;
    ipopt.max_iterations = std::max(0, iterations);
    return ipopt;
  }
  /// While it lives there is no more than a share of the work and of what
  /// left() tells.
  class Share {
   public:
    Share(PassProtocol& protocol, double share)
        : protocol_(protocol),
          work_(protocol.most_work),
          iterations_(protocol.most_iterations) {
      if (std::isfinite(work_)) {
        protocol.most_work -= (1.0 - share) * (work_ - protocol.work);
      }
      protocol.most_iterations -=
          static_cast<int>((1.0 - share) * protocol.left({}).max_iterations);
    }
    Share(const Share&) = delete;
    Share& operator=(const Share&) = delete;
    ~Share() {
      protocol_.most_work = work_;
      protocol_.most_iterations = iterations_;
    }

   private:
    PassProtocol& protocol_;
    double work_;
    int iterations_;
  };
  /// Of Newton's method, in all passes.
  [[nodiscard]] int newton_steps() const {
    int steps = record.newton_steps;
    for (const MeshRecord& mesh : meshes) steps += mesh.newton_steps;
    return steps;
  }
  /// Adds a pass of Ipopt.
  void add(const SolverResult& result, const nlp::Problem& problem) {
    book(result.iterations, problem);
    record.iterations += result.iterations;
    ++record.passes;
    record.linear_solver = result.linear_solver;
    log += result.log;
  }
  /// Ends the record of a mesh on which the transit time is T.
  void keep_record(const char* phase, double T) {
    meshes.push_back(std::exchange(record, {}));
    if (progress) {
      progress(phase, fmt::format("{} elements, T = {:.10g}",
                                  meshes.back().elements, T));
    }
  }
  /// With the record of passes that led nowhere, if there are such.
  [[nodiscard]] RefinementProtocol finished() && {
    if (record.passes > 0) meshes.push_back(record);
    return std::move(*this);
  }
};

}  // namespace brachisto
