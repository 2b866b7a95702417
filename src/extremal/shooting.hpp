// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The indirect method: Pontryagin's conditions by multiple shooting.
///
/// Minimise T = ∫√A du subject to, with ' = d/du, in a uniform field without
/// air and from rest
///
///     x' = w cos β,  z' = w sin β,  r θ' = w,  w' = g (sin β + η cos θ),
///
/// from (C_A, θ_m, w = 0) to the centre C_B(φ), with θ, w and U free at the
/// end. With 𝓗 = √A + p·f the conditions are
///
///     ∂𝓗/∂β = 0, ∂²𝓗/∂β² > 0,  p_x, p_z constant,  p_θ' = −∂𝓗/∂θ,
///     p_w' = −∂𝓗/∂w,  p_θ(U) = p_w(U) = 0,  𝓗 = 0,  β(U) = φ.
///
/// All is regular at the start, where w = 0, β = β₀ and p_w = −√A/(g a). It is
/// one free arc of arcs::ArcSystem, in any world; what is new here is the way
/// to it, from the cycloid along a branch.

#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "brachisto/math/clock.hpp"
#include "brachisto/model/scene.hpp"
#include "extremal/extremal_path.hpp"

namespace brachisto {

enum class ExtremalStatus {
  Solved,              ///< A regular extremal, as accurate as asked for.
  AccuracyNotReached,  ///< An extremal with fewer digits than asked for.
  NoCycloid,           ///< η = 0 has no answer from which to continue.
  BranchTurnsBack,     ///< The branch from the cycloid has a fold below η_m.
  StepTooSmall,        ///< The continuation got stuck between 0 and η_m.
  NewtonFailed,        ///< Newton's method did not converge from the guess.
  BadGuess,            ///< The guess cannot be integrated at all.
  Loop,                ///< The extremal found leaves slopes of [−π, π].
  Stalls,              ///< The extremal found comes to rest on its way.
  NotMinimal,          ///< ∂²𝓗/∂β² > 0 fails on the extremal found.
  TimeLimit,           ///< The seconds allowed ran out.
  Interrupted,         ///< Told to stop from outside.
};

/// One sentence for people.
[[nodiscard]] std::string_view describe(ExtremalStatus status);

/// Where Newton's method starts.
struct ExtremalGuess {
  double rolling_time = 0.0;  ///< U [s]
  double phi = 0.0;           ///< slope angle at the end [rad]
  /// The extremal at σ = u/U in [0, 1]; t is not used.
  std::function<ExtremalState(double sigma)> state;
};

struct ExtremalOptions {
  /// Wanted relative error of T, at least 1e-14.
  double tolerance = 1e-13;
  /// Newton steps for one solution, at least 1.
  int max_newton_steps = 50;
  /// Pieces of the multiple shooting, called arcs in messages; 0: from the
  /// number of turns of the body.
  int arcs = 0;

  /// Goes on through folds of the branch instead of stopping at the first; an
  /// answer beyond a fold is connected with the cycloid, but is not what the
  /// cycloid turns into as η grows.
  bool follow_folds = false;
  StopCondition stop = StopCondition();  ///< looked at in every step
};

/// One solution on the branch, for a body with offset η.
struct ContinuationPoint {
  double eta = 0.0;
  double phi = 0.0;           ///< [rad]
  double transit_time = 0.0;  ///< [s], to some 8 digits
};

struct ContinuationReport {
  std::vector<ContinuationPoint> points;  ///< from η = 0 on
  std::vector<double> folds;              ///< η where the branch turned
  int rejected_steps = 0;
};

struct ExtremalSolution {
  ExtremalStatus status = ExtremalStatus::NewtonFailed;
  /// What failed, where, and what to try; one sentence if solved.
  std::string message;

  double transit_time = 0.0;        ///< T [s]
  double tau = 0.0;                 ///< T √(2 g/H) [-]
  double rolling_time = 0.0;        ///< U [s]
  double phi = 0.0;                 ///< slope angle at the end [rad]
  double start_angle = 0.0;         ///< β₀ [rad]
  double centre_path_length = 0.0;  ///< S [m]
  double rotation = 0.0;            ///< θ_end − θ_m [rad]; 0 for a bead
  double p_x = 0.0;                 ///< −∂T/∂x_end [s/m]
  double p_z = 0.0;                 ///< −∂T/∂z_end [s/m]

  int arcs = 0;                 ///< pieces of the one arc
  int newton_steps = 0;         ///< in all
  int integration_steps = 0;    ///< along the final path
  double residual = 0.0;        ///< largest of all equations, in natural units
  double error_estimate = 0.0;  ///< relative, of T: see solve_extremal()

  Regularity regularity;
  ContinuationReport continuation;  ///< empty if a guess was given
  ExtremalPath path;

  [[nodiscard]] bool solved() const { return status == ExtremalStatus::Solved; }
  /// True if the numbers may be used: an extremal whose own error is known,
  /// though it may have fewer digits than were asked for.
  [[nodiscard]] bool usable() const;
};

/// The extremal that Newton's method finds from a guess, which need not lie on
/// the principal branch.
///
/// T is corrected for the matching errors left, to the first order. Its
/// `error_estimate` is that of arcs::refine_root().
///
/// Cost: linear in the number of turns of the body.
/// \pre validate(scene) is empty; guess.state is set
[[nodiscard]] ExtremalSolution solve_extremal(
    const Scene& scene, const ExtremalGuess& guess,
    const ExtremalOptions& options = {});

/// The extremal of the principal branch: the one into which the cycloid of
/// η = 0 turns as η grows to η_m, followed by pseudo-arclength continuation.
/// \pre validate(scene) is empty
[[nodiscard]] ExtremalSolution solve_extremal(
    const Scene& scene, const ExtremalOptions& options = {});

/// The closed form for the scene with η = 0, with Pontryagin's costates:
/// (w p_x, w p_z + g p_w) = −√(1 + k) (cos β, sin β) and p_θ = 0. Its `state`
/// is empty if there is no cycloid.
[[nodiscard]] ExtremalGuess cycloid_guess(const Scene& scene);

}  // namespace brachisto
