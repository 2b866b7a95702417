// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The outcome of a solve: one answer, what is known of it, and how it was
/// sought.

#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "brachisto/math/clock.hpp"
#include "brachisto/model/body.hpp"
#include "brachisto/model/scene.hpp"
#include "brachisto/run/solve_options.hpp"
#include "brachisto/solvers/status.hpp"
#include "brachisto/trajectory/motion.hpp"

namespace brachisto {

struct Interval {
  double from = 0.0, to = 0.0;
};

/// A stretch of the path along which a limit holds as an equation.
struct ActiveArc {
  Interval sigma;  ///< places, see Motion::at()
  Interval u, t;   ///< [s]
  Interval x;      ///< of the point of the track [m]
};

/// A bound of scene.limits, on the answer's path.
struct LimitOnPath {
  std::string name;  ///< its key below scene.limits, "normal_force.min"
  /// As the scene states it; nothing of a half-plane, which has none.
  std::optional<double> bound;
  std::vector<ActiveArc> active;  ///< in the order of the path
  double least_slack = 0.0;       ///< distance from the bound, 0 if active
  double share_of_time = 0.0;     ///< of T, on the active arcs
  /// dτ/d(bound), the contacts moving along: the slope of τ over the bound. Of
  /// a half-plane by metre along its normal.
  std::optional<double> price;
  /// What the multiplier says: dτ/d(bound) with A, B and both slopes that the
  /// places of the centre follow from held.
  std::optional<double> price_at_fixed_contacts;
};

/// What enclosures say of an answer; see docs/proofs.md.
struct Proof {
  struct Statement {
    std::string name;  ///< as in a certificate, "strict_minimum"
    bool holds = false;
    std::string why_not;  ///< empty if it holds, or follows from others
  };
  std::string not_proven_because;    ///< empty: the extremal exists
  std::string tau_lower, tau_upper;  ///< decimal, rounded outward
  double off_at_most = 0.0;  ///< how far the answer's τ is from the extremal's
  bool within_estimate = false;  ///< no more than its estimated error
  std::vector<Statement> statements;
  int bits = 0;
  double cpu_seconds = 0.0;
};

struct Solution;

/// The numbers of a scene that its time is differentiated by, as problem files
/// have them.
enum class SceneParameter { EtaM, ThetaM, K, Radius, L, H };

inline constexpr std::size_t kNumSceneParameters = 6;

/// Its key: "eta_m".
[[nodiscard]] const char* name(SceneParameter parameter);

/// One of each parameter.
template <class Value>
struct PerParameter : std::array<Value, kNumSceneParameters> {
  using Base = std::array<Value, kNumSceneParameters>;
  using Base::operator[];
  [[nodiscard]] Value& operator[](SceneParameter parameter) {
    return Base::operator[](static_cast<std::size_t>(parameter));
  }
  [[nodiscard]] const Value& operator[](SceneParameter parameter) const {
    return Base::operator[](static_cast<std::size_t>(parameter));
  }
};

/// Derivatives by one number, per unit of it: 1, rad or m.
struct TimeDerivatives {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  /// dτ and dT [s], the contacts moving along: slopes of τ and T over the
  /// number.
  double tau = kNone, transit_time = kNone;
  /// The same with the slopes at A and B held from which the places of the
  /// centre there follow.
  double tau_at_fixed_contacts = kNone, transit_time_at_fixed_contacts = kNone;
};

/// ∂²τ, symmetric.
using SecondDerivatives = PerParameter<PerParameter<double>>;

/// Derivatives of an answer. Those by what the body does not have, as a bead
/// has no radius, are NaN.
struct Sensitivities {
  /// At η_m = 0 those by η_m are of a step to the stated θ_m, and those by θ_m
  /// are 0.
  PerParameter<TimeDerivatives> by;
  /// By η_m cos θ_m and η_m sin θ_m, regular at η_m = 0 too.
  std::array<TimeDerivatives, 2> by_offset;
  std::optional<SecondDerivatives> second;  ///< of τ
  /// The same with η_m cos θ_m and η_m sin θ_m for the first two parameters.
  std::optional<SecondDerivatives> second_by_offset;
  /// How far the slope φ of the contact at B moves per kink κ = φ − β_end that
  /// is asked for there, dφ/dκ; NaN without a smooth contact, or under limits.
  /// It is positive and of order 1 on the whole, 0 where the path ceases to be
  /// a minimum between its fixed ends, and infinite where the branch turns.
  double contact_response = std::numeric_limits<double>::quiet_NaN();
};

/// From the optimality conditions of an answer, which is worth no more than the
/// solution is verified(). Costs a few Newton steps on its mesh; with second
/// derivatives some hundred.
///
/// \return nothing unless the answer was found by collocation in the rolling
///         time, and where its conditions are singular: a branch turns there;
///         without `second` where the neighbours for it are not found
[[nodiscard]] std::optional<Sensitivities> sensitivities(
    const Solution& solution, bool second = false);

/// What one run on the paper's discrete system came to. Its equations may hold
/// to rounding; how far their solution is from the extremal is another
/// matter, which nothing here knows.
struct DiscreteAnswer {
  Status status = Status::InternalError;
  std::string message;  ///< how it ended, and why it failed
  int nodes = 0;        ///< n
  int unknowns = 0;     ///< 2n + 1; 4n − 1 if lifted
  int iterations = 0;
  int evaluations = 0;  ///< of the residual, those for differences included
  int jacobians = 0;
  int refused_points = 0;  ///< at which the residual is no real number
  double residual = 0.0;   ///< Euclidean norm of the 2n + 1 equations, lengths
                           ///< in H; NaN if not even the start has one
  double cpu_seconds = 0.0;
  double memory_bytes = 0.0;  ///< of matrices and factors, by their sizes

  // Of the solution; zero and empty unless solved().
  double tau = 0.0;                 ///< by the reading's quadrature
  double transit_time = 0.0;        ///< [s]
  double centre_path_length = 0.0;  ///< S [m]
  double start_angle = 0.0;         ///< slope angle of the first chord [rad]
  double end_angle = 0.0;           ///< slope angle of the last chord [rad]
  std::vector<Point> centre;        ///< the n nodes [m]

  [[nodiscard]] bool solved() const { return status == Status::Solved; }
};

/// Solves the discrete system of a scene from the cycloid of the uniform
/// cylinder by one of the three ways. All end at the same residual.
///
/// Status::NoAdmissiblePath if there is no cycloid of a uniform cylinder,
/// Status::NotReached if of an off-centred one, Status::NotEvaluable if the
/// iteration was turned back by points without a real transit time,
/// Status::OutOfMemory if a dense matrix does not fit.
///
/// \throws std::invalid_argument if n < 3 or ε < 0
[[nodiscard]] DiscreteAnswer solve_discrete_system(
    const Scene& scene, const DiscreteSystem& options,
    int max_iterations = Limits{}.iterations, const StopCondition& stop = {});

/// How a solve or a stage of it ended.
struct Outcome {
  Status status = Status::InternalError;
  std::string message;  ///< what failed, where, and what to try
};

/// The finite problem that an answer solves.
struct ProgramSize {
  int nodes = 0, variables = 0, constraints = 0;
  std::optional<int> degree;  ///< p; nothing of straight pieces
  int elements = 0;           ///< N, or pieces
};

/// What a Solution keeps of the problem it solves; the library alone knows it.
struct Answer;

/// An extremal that was found, to start from in a scene not far away.
struct Neighbour;

/// Outcome of solve(). The numbers of motion() are worth something only if
/// verified() is true. A copy shares the answer, which neither can change.
struct Solution {
  Scene scene;
  SolveOptions options;
  Status status = Status::InternalError;
  std::string message;  ///< what failed, where, and what to try
  /// What the scene says but hardly means, such as θ_m of many turns.
  std::vector<std::string> warnings;

  std::shared_ptr<const Answer> answer;        ///< null: there is none
  std::optional<PathDiagnostics> diagnostics;  ///< of motion()
  std::optional<double> estimated_error;       ///< relative, of T
  Certificate certificate;
  std::optional<CrossCheck> extremal;
  std::optional<Proof> proof;       ///< of Certify::Proof, by the command
  std::vector<LimitOnPath> limits;  ///< one for each bound of the scene
  /// Where limits were not reached, verified: the answer under those that ask
  /// for less, tightened as far as a path was found. Null otherwise.
  std::shared_ptr<const Solution> relaxed;
  /// If they were asked for; see brachisto::sensitivities().
  std::optional<Sensitivities> sensitivities;

  Effort effort;
  /// η_m at which the branch from the cycloid turned on its way to the scene's
  /// η_m. Usually empty. Otherwise the solution lies beyond a fold: connected
  /// with the cycloid, but not what it turns into as η_m grows.
  std::vector<double> folds;
  /// L [m] of the scene whose branch from the cycloid was followed back in L
  /// to this one, where the uniform cylinder has no path to B: then no branch
  /// of this scene is principal. Usually nothing.
  std::optional<double> continued_from_L;
  std::optional<ColdStart> cold_start;
  std::vector<Branch> branches;  ///< of Search::Global, fastest first
  /// What Search::Global left undone, bounded or cut by time; empty if nothing.
  std::string search_remark;

  /// The motion, found or given; null if there is none.
  [[nodiscard]] const Motion* motion() const;
  /// The finite problem solved; null if there is none.
  [[nodiscard]] const ProgramSize* program() const;
  /// Of a DiscreteSystem; null otherwise.
  [[nodiscard]] const DiscreteAnswer* discrete() const;
  /// For scenes not far from this one; see SolveHooks. Null if the answer is
  /// not the end of the branch from the cycloid: what lies beyond a fold, or
  /// what a search chose, is not what neighbours continue.
  [[nodiscard]] std::shared_ptr<const Neighbour> as_neighbour() const;

  /// Solved, and every check of the certificate passed. Never for a solution
  /// of the paper's discrete system.
  [[nodiscard]] bool verified() const;
  /// See brachisto::not_verified_because(); empty if nothing is solved.
  [[nodiscard]] std::vector<std::string> not_verified_because() const;
  /// What to try where the extremal that was found is no minimum between its
  /// fixed ends; empty otherwise, and where there is nothing to try.
  [[nodiscard]] std::string advice() const;
  /// See brachisto::infeasible_because(); empty as long as nothing is solved.
  [[nodiscard]] std::vector<std::string> infeasible_because() const;
  [[nodiscard]] bool feasible() const { return infeasible_because().empty(); }
  /// See brachisto::undecided_because(); empty as long as nothing is solved.
  [[nodiscard]] std::vector<std::string> undecided_because() const;
  /// Forgets the answer with all that is known of it, not how it was sought.
  void discard_answer();
};

}  // namespace brachisto
