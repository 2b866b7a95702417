// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The course of one solve.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "brachisto/extremal/shooting.hpp"
#include "brachisto/math/phase_clock.hpp"
#include "brachisto/model/cycloid.hpp"
#include "brachisto/study/arc_length_refinement.hpp"
#include "brachisto/study/global_search.hpp"
#include "brachisto/study/refinement.hpp"
#include "brachisto/study/solve.hpp"

namespace brachisto {

/// Whether the method poses the nonlinear program.
[[nodiscard]] bool solves_the_program(Method method);

/// True if the answer is the end of one branch that is followed.
[[nodiscard]] bool follows_the_branch(const SolveOptions& options);

/// One solve: its parts share the scene, the budget and the protocol.
class SolveRun {
 public:
  SolveRun(const Scene& scene, const SolveOptions& options,
           const SolveHooks& hooks);

  /// \param neighbour  where to begin; nullptr: with the cycloid
  Solution execute(const Neighbour* neighbour);

 private:
  void find();
  bool fits(const CycloidArc& arc);
  void find_beside(const Neighbour& neighbour);
  void find_by_search(const CycloidArc& arc, const Continuation& principal);
  void add_minima_below(std::vector<ContactCandidate>& known);
  void find_by_shooting();
  void find_by_fsolve();
  void follow_folds(Continuation& principal);
  void try_other_start(const CycloidArc& arc, const Continuation& principal);
  void answer_from(const Continuation& start);
  void report(MeshAnswer& answer,
              std::optional<double> transit_time = std::nullopt);
  void answer_on_pieces(const Continuation& start);
  void report(ArcLengthAnswer& answer, const Continuation& start);
  void tell_of_certificate(int nodes) const;
  void set_verdict(const std::string& message);
  /// Adds up the work on meshes, whether or not the answer comes from there.
  void count(const std::vector<MeshRecord>& meshes);
  /// Keeps how the answer was refined.
  void describe_way(const RefinementProtocol& refinement);
  void book(const RefinementProtocol& refinement);
  [[nodiscard]] ExtremalSolution shoot(double tolerance);

  [[nodiscard]] const StopCondition& stop() const {
    return mesh_options_.ipopt.stop;
  }
  [[nodiscard]] MeshOptions budget() const;

  Scene scene_, natural_;
  Units units_;
  SolveOptions options_;
  StopCondition::Clock::time_point start_time_;
  double start_cpu_;
  PhaseSeconds start_phases_;
  MeshOptions mesh_options_;
  Solution out_;
};

}  // namespace brachisto
