// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Options of a solve, as a problem file or a caller states them, and what is
/// told of it: its progress, the work it took, what was met on the way.

#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "brachisto/math/clock.hpp"
#include "brachisto/solvers/status.hpp"

namespace brachisto {

/// Both ends and a node to move.
inline constexpr int kFewestDiscreteNodes = 3;
/// Of DiscreteReading::epsilon.
inline constexpr double kLargestEpsilon = 0.1;

/// A reading of section "Solution Methodology": the choices that eqs. (13)–(19)
/// need and the paper does not state, and its ε.
struct DiscreteReading {
  /// Transit time of a chord of length l with speeds v at its ends.
  enum class Quadrature {
    MeanSpeed,  ///< 2 l / (v_left + v_right); the only one regular at a start
                ///< from rest, of first order there
    Midpoint,   ///< l / v with E and θ halfway; error n^(−1/2) at the start
    Trapezoid,  ///< l (1/v_left + 1/v_right) / 2; MeanSpeed where v_left = 0
  };
  /// What the energy height E of eq. (1) is measured from.
  enum class Datum {
    Release,  ///< z − z_1: at rest at node 1, whatever the slope there
    Rest,     ///< z as printed, but v = 0 at node 1
    Printed,  ///< z as printed: E_1 = −r cos β_1, negative unless the first
              ///< chord is vertical, and then v_1 is no real number
  };
  /// sin and cos of the end slopes.
  enum class Slopes {
    Literal,  ///< z'/√(1 + z'²) and 1/√(1 + z'²) with z' = Δz/Δx, as printed:
              ///< they jump where Δx changes its sign
    Smooth,  ///< Δz/l and Δx/l, the same where Δx > 0
  };

  Quadrature quadrature = Quadrature::MeanSpeed;
  Datum datum = Datum::Release;
  Slopes slopes = Slopes::Literal;
  /// Half width of the central differences of eq. (18), in units of H, at
  /// most kLargestEpsilon; 0 takes their limit, the exact derivatives.
  double epsilon = 1e-3;
};

/// Which discretisation of the optimal-control problem to solve.
enum class Formulation {
  RollingTime,  ///< collocation of degree p in the rolling time; order 2p
  ArcLength,    ///< the paper's variables, on straight pieces; order 2
};

inline constexpr int kMinDegree = 1;
inline constexpr int kMaxDegree = 8;
/// Of a fixed mesh.
inline constexpr int kDefaultDegree = 5;
/// More elements are no mesh that any machine has the memory for.
inline constexpr int kMaxElements = 10'000'000;
inline constexpr int kMaxNodes = kMaxElements * kMaxDegree + 1;
inline constexpr double kSmallestTolerance = 1e-13;
inline constexpr double kLargestTolerance = 1e-1;
inline constexpr double kDefaultTolerance = 1e-10;
/// An arc_length mesh for a smaller relative error needs some 10⁵ pieces, which
/// collocation replaces by a hundred nodes.
inline constexpr double kSmallestArcLengthTolerance = 1e-9;
inline constexpr double kDefaultArcLengthTolerance = 1e-6;
/// So few that half as many still show an error.
inline constexpr int kFewestPieces = 8;

/// The wanted accuracy or a fixed mesh.
///
/// With neither `elements` nor `nodes` the mesh follows from `tolerance`.
/// `nodes` means N p + 1 for degree p and N elements and excludes `elements`.
/// An arc_length mesh has no degree; its N pieces have N + 1 nodes.
struct Discretisation {
  Formulation formulation = Formulation::RollingTime;
  /// Wanted relative error of T, in [kSmallestTolerance, kLargestTolerance],
  /// for arc_length from kSmallestArcLengthTolerance on; see
  /// wanted_tolerance().
  std::optional<double> tolerance;
  std::optional<int> degree;    ///< p, in [kMinDegree, kMaxDegree]; default 5
  std::optional<int> elements;  ///< N, in [1, kMaxElements]
  std::optional<int> nodes;     ///< N p + 1, at most kMaxNodes

  [[nodiscard]] bool fixed() const { return elements || nodes; }
  /// p of a mesh that is fixed; pieces are straight.
  [[nodiscard]] int degree_of_fixed() const {
    return formulation == Formulation::ArcLength
               ? 1
               : degree.value_or(kDefaultDegree);
  }
  /// The wanted relative error of T, where the mesh follows from it.
  [[nodiscard]] double wanted_tolerance() const {
    return tolerance.value_or(formulation == Formulation::ArcLength
                                  ? kDefaultArcLengthTolerance
                                  : kDefaultTolerance);
  }
};

/// Which of several extremals is the answer.
enum class Search {
  Principal,  ///< the one that continues from the cycloid as η_m grows from 0
  Global,     ///< the fastest verified and feasible one found
};

/// Where the first iteration starts.
enum class Guess {
  Cycloid,   ///< the centre on the cycloid of the uniform cylinder
  Straight,  ///< the centre on the straight line between its end points
  Random,    ///< the cycloid with random slopes and speeds
};

/// What an answer is cross-checked by.
enum class Certify {
  None,
  Extremal,  ///< Pontryagin's conditions solved by multiple shooting
  /// Enclosures of the extremal, which the command adds to a verified answer;
  /// solve() itself proves nothing.
  Proof,
};

/// Which derivatives of the time by the scene are wanted.
enum class SensitivityOrder { None, First, Second };

/// Bounds on the work; reaching one ends the solve with Status::IterationLimit
/// or Status::TimeLimit. A solve that cannot be done in this time, or in the
/// memory that there is, is not begun.
struct Limits {
  int iterations = 3000;    ///< of the solver, in all passes together; ≥ 1
  double seconds = 3600.0;  ///< wall clock, > 0
};

inline constexpr double kSmallestResidual = 1e-14;
inline constexpr double kLargestResidual = 1e-6;
inline constexpr int kMostThreads = 64;

/// Who solves the nonlinear program.
enum class ProgramSolver {
  Ipopt,
  NewtonKkt,  ///< Newton's method on the optimality conditions
};

/// The optimal-control problem made finite: a nonlinear program.
struct Collocation {
  Discretisation discretisation = {};
  ProgramSolver solver = ProgramSolver::Ipopt;
  /// Rolling bodies in the uniform field, in air or not, may be solved by lanes
  /// where those are as accurate as wanted (docs/sweeps.md, "Side by side").
  bool in_lanes = false;
  LinearSolver linear_solver = LinearSolver::Auto;
  int threads = 1;  ///< of the chain's factorisations, to kMostThreads
  /// Scaled KKT residual, in [kSmallestResidual, kLargestResidual].
  double tolerance = 1e-12;
  Search search = Search::Principal;
  bool polish = true;  ///< last digits by Newton's method on the whole system
  Certify certify = Certify::None;
  /// Of a verified answer in the rolling time.
  SensitivityOrder sensitivities = SensitivityOrder::None;
  Guess guess = Guess::Cycloid;
  std::uint64_t seed = 1;  ///< of Guess::Random
};

/// The indirect method: multiple shooting, under limits over a program's arcs.
struct Shooting {
  double tolerance = kDefaultTolerance;  ///< wanted relative error of T
};

/// Who solves the paper's discrete system.
enum class DiscreteSolver {
  Hybrid,  ///< Powell's hybrid method, dense differences: what fsolve does
  Newton,  ///< ε → 0, exact derivatives, dense Newton
  Lifted,  ///< the same steps from a sparse system with θ_j as unknowns
};

/// The paper's discrete system, for comparison; its answer is never verified.
struct DiscreteSystem {
  int nodes = 100;  ///< n ≥ kFewestDiscreteNodes; 100 in the paper
  DiscreteReading reading = {};  ///< its ε is for DiscreteSolver::Hybrid only
  DiscreteSolver solver = DiscreteSolver::Hybrid;
  /// On the Euclidean norm of the residual: the paper's.
  double tolerance = 1e-6;
};

/// All options of solve(). The defaults are right for almost every scene.
struct SolveOptions {
  /// How the extremal is found, each method with what it can be told.
  std::variant<Collocation, Shooting, DiscreteSystem> method = {};
  Limits limits = {};

  /// The options of a method, nullptr if it is another one.
  template <class Method>
  [[nodiscard]] const Method* of() const {
    return std::get_if<Method>(&method);
  }
  /// The same, or the method's defaults.
  template <class Method>
  [[nodiscard]] Method or_default() const {
    return of<Method>() != nullptr ? *of<Method>() : Method{};
  }
  /// The options of a method, which becomes the one that is used.
  template <class Method>
  [[nodiscard]] Method& use() {
    if (of<Method>() == nullptr) method = Method{};
    return std::get<Method>(method);
  }
  /// Whether all extremals are wanted that can be found.
  [[nodiscard]] bool searches() const {
    const auto* program = of<Collocation>();
    return program != nullptr && program->search == Search::Global;
  }
  /// True if the answer is the end of one branch that is followed.
  [[nodiscard]] bool follows_the_branch() const {
    const auto* program = of<Collocation>();
    return program != nullptr && program->search == Search::Principal &&
           program->guess == Guess::Cycloid;
  }
};

/// Called now and then from within a solve: which phase it is in, in a word or
/// two, and what is known so far.
using ProgressHook =
    std::function<void(std::string_view phase, const std::string& text)>;

/// One accepted step of a continuation.
struct ContinuationStep {
  double eta_m = 0.0;
  double phi = 0.0;      ///< [rad]
  int newton_steps = 0;  ///< to get there from the prediction
};

/// One mesh that was solved on.
struct MeshRecord {
  int degree = 0;
  int elements = 0;
  /// Relative, of T; nothing if the check could not be done.
  std::optional<double> estimated_error;
  int passes = 0;            ///< solves between fixed end points
  int first_iterations = 0;  ///< of Ipopt, in the first pass
  int iterations = 0;        ///< of Ipopt, in all passes
  int newton_steps = 0;      ///< of polishing and of the check
  /// Of Ipopt, if it ran: Chain or Mumps.
  std::optional<LinearSolver> linear_solver;
};

/// Work that a stage of a solve took.
struct Work {
  int iterations = 0;    ///< of Ipopt, in all passes on all meshes
  int passes = 0;        ///< solves between fixed end points
  int newton_steps = 0;  ///< of continuation, polishing and checks
  std::string log;       ///< of Ipopt, if asked for

  Work& operator+=(const Work& other);
};

/// What was done to find a solution.
struct Effort : Work {
  double seconds = 0.0;              ///< wall clock, all of solve()
  double certificate_seconds = 0.0;  ///< of these for the certificate
  /// Processor time of solve() without the certificate and cross-checks.
  double cpu_seconds = 0.0;
  double certificate_cpu_seconds = 0.0;  ///< processor time of these two
  PhaseSeconds phases;                   ///< processor time of solve()
  std::vector<ContinuationStep> continuation;
  /// On the way to the answer, in the order in which they were tried.
  std::vector<MeshRecord> meshes;

  /// The mesh that was tried last; all zero if there was none.
  [[nodiscard]] MeshRecord final_mesh() const {
    return meshes.empty() ? MeshRecord{} : meshes.back();
  }
};

/// A start other than the cycloid, and where it led on a coarse mesh.
struct ColdStart {
  Status status = Status::NotConverged;
  std::optional<double> tau;  ///< on the coarse mesh, if it converged
  bool principal = false;     ///< it led to the principal branch
};

/// One extremal, or path under limits, that Search::Global found.
struct Branch {
  double tau = 0.0;
  double estimated_error = 0.0;     ///< relative
  double end_angle = 0.0;           ///< [rad]
  double centre_path_length = 0.0;  ///< [m]
  bool principal = false;           ///< what Search::Principal leads to
  bool verified = false;
  bool minimum = false;  ///< second-order sufficiency at fixed φ
  bool feasible = false;
  std::vector<std::string> remarks;  ///< failed checks, why infeasible
};

}  // namespace brachisto
