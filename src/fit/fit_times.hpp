// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Numbers of a scene from times on its track, by weighted least squares.

#pragma once

#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "brachisto/model/scene.hpp"
#include "brachisto/trajectory/motion.hpp"
#include "fit/measurements.hpp"
#include "model/plane_curve.hpp"
#include "trajectory/time_sensitivity.hpp"

namespace brachisto::fit {

/// A number that can be fitted.
struct Parameter {
  const char* key;      ///< of problem files
  MotionNumber number;  ///< by which times are derived
  bool of_bead;         ///< or of what rolls
  double& (*of)(Scene&);
};

inline constexpr std::array<Parameter, 3> kParameters{{
    {"scene.losses.rolling", MotionNumber::Loss, false,
     [](Scene& scene) -> double& { return scene.world.losses.rolling; }},
    {"scene.losses.sliding", MotionNumber::Loss, true,
     [](Scene& scene) -> double& { return scene.world.losses.sliding; }},
    {"scene.body.k", MotionNumber::Inertia, false,
     [](Scene& scene) -> double& { return scene.body.k; }},
}};

/// The one of that key, or null.
[[nodiscard]] const Parameter* find_parameter(std::string_view key);

/// Why a scene has no such number; "" if it has.
[[nodiscard]] std::string objection(const Parameter& parameter,
                                    const Scene& scene);

/// Times do not tell what is asked of them; what() says why.
class CannotFit : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What is to be found.
struct Wanted {
  std::vector<const Parameter*> parameters;  ///< one or more, each once
  /// Also t₀, at which the body leaves by the clock that measured.
  bool offset = false;
  /// Standard deviations are known; otherwise all times are as good as each
  /// other, and how good, their residuals tell.
  bool sigma_known = false;
};

/// A number that was found.
struct Estimate {
  std::string key;     ///< "scene.losses.rolling"; "offset"
  double start = 0.0;  ///< that of the scene
  double value = 0.0;
  double error = 0.0;  ///< standard error
};

/// A time beside the one that the fitted scene has.
struct Residual {
  TimedPlace measured;
  double predicted = 0.0;  ///< with the offset [s]

  [[nodiscard]] double value() const { return measured.t - predicted; }
};

/// What times tell.
struct Fit {
  Scene scene;                      ///< with the values that were found
  std::vector<Estimate> estimates;  ///< in the order of Wanted, the offset last
  /// Of the estimates, row by row; on the diagonal 1.
  std::vector<std::vector<double>> correlation;
  std::vector<Residual> residuals;
  double chi_squared = 0.0;  ///< Σ (residual/sigma)²
  int freedom = 0;           ///< rows − estimates
  bool sigma_known = false;
  double condition = 0.0;     ///< of the normal matrix, its columns scaled
  double transit_time = 0.0;  ///< T of the fitted scene [s]
  double transit_time_error = 0.0;  ///< standard error [s]
  int evaluations = 0;              ///< of the motion

  /// χ² per degree of freedom; nothing without sigma or without a row to spare.
  [[nodiscard]] std::optional<double> reduced_chi_squared() const;
  /// √(Σ residual²/freedom), weights left out [s]; nothing without a row to
  /// spare.
  [[nodiscard]] std::optional<double> scatter() const;
};

/// The p and t₀ of the smallest
///
///     χ² = Σ ((t_i − t₀ − t(q_i; p))/σ_i)²
///
/// by Levenberg's and Marquardt's method (Eigen's translation of MINPACK) with
/// the exact ∂t/∂p of TimeSensitivity, from the scene's own values. Values are
/// not held within the bounds of a scene, or their errors would mean nothing.
/// With J the matrix of (∂t_i/∂p)/σ_i their covariance is (JᵀJ)⁻¹, without
/// sigma times χ²/freedom; that of T follows by ∂T/∂p.
///
/// \param scene   a valid one
/// \param centre  the path of the centre, which is held
/// \throws CannotFit  if there are too few rows, the body does not arrive, or
///                    JᵀJ is singular: the sentence names what it cannot tell
/// \throws Stopped
[[nodiscard]] Fit fit_times(const Scene& scene, const PlaneCurvePtr& centre,
                            const std::vector<TimedPlace>& times,
                            const Wanted& wanted);

}  // namespace brachisto::fit
