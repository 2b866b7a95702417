// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The paper's own method, for comparison.

#pragma once

#include <string>
#include <vector>

#include "brachisto/math/stop_condition.hpp"
#include "brachisto/model/point.hpp"
#include "brachisto/model/scene.hpp"
#include "brachisto/run/solve_options.hpp"
#include "brachisto/solvers/status.hpp"

namespace brachisto {

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

}  // namespace brachisto
