// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How the time of a free extremal changes with its scene.

#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "refinement/time_rates.hpp"
#include "solvers/bordered_chain.hpp"
#include "transcription/contact_equation.hpp"
#include "transcription/rolling_time.hpp"
#include "transcription/start_equation.hpp"

namespace brachisto {

/// With F(y, p) = 0 the optimality conditions and the tangency condition, y
/// being (x, λ, φ), 𝓛 the Lagrangian and v the values of fixed variables,
///
///     y_p = −F_y⁻¹ F_p,   dT/dp = 𝓛_p + (∂𝓛/∂x_fixed)·(v_p + v_φ φ_p).
///
/// Where slope_at_A_is_open() φ stands for the two slopes c = (φ, α), or for α
/// alone, and the equations of both are solved around the chain, C(y, c, p) = 0
/// with y the unknowns between given ends: either of them closed inside of the
/// other would meet folds that both together do not have,
///
///     (C_c − C_y F_y⁻¹ F_c) c_p = C_y F_y⁻¹ F_p − C_p.
///
/// F_p and 𝓛_p are differences of formulas at one and the same point, at which
/// θ alone turns with the centre of mass: as a function of offset and θ − θ_m
/// they are regular at η = 0.
class FreeRates final : public TimeRates {
 public:
  /// \param point  x and λ of a solution of the scene on the mesh
  FreeRates(const Scene& scene, const Mesh& mesh, const PrimalDual& point,
            double phi);
  FreeRates(const FreeRates&) = delete;
  FreeRates& operator=(const FreeRates&) = delete;

  [[nodiscard]] const Scene& scene() const override { return at_.scene(); }
  [[nodiscard]] double time() const override { return time_; }
  [[nodiscard]] bool regular() const override { return regular_; }
  [[nodiscard]] TimeRate by(SceneCoordinate coordinate) override;
  [[nodiscard]] double contact_response() override;
  [[nodiscard]] std::unique_ptr<TimeRates> next(SceneCoordinate coordinate,
                                                double by) override;

 private:
  /// The equations of a scene.
  struct Equations {
    RollingTime problem;
    std::optional<ContactEquation> contact;  ///< at B
    std::optional<StartEquation> start;      ///< at A, where it is open
    KktSystem system;  ///< with the contact at B, unless both stand around it

    Equations(const Scene& scene, const Mesh& mesh, double phi);
    [[nodiscard]] const Scene& scene() const { return problem.scene(); }
    [[nodiscard]] nlp::TangencyCondition* tangency() {
      return contact && !start ? &*contact : nullptr;
    }
    /// What closes at B, then at A.
    [[nodiscard]] std::vector<nlp::TangencyCondition*> closing();
  };
  /// Turns of the slopes that close, as all unknowns follow from them.
  struct AroundChain {
    std::vector<nlp::TangencyCondition::Linearisation> rows;  ///< C
    std::vector<std::vector<double>> turns;  ///< −F_y⁻¹ F_c, by column
    Eigen::MatrixXd jacobian;                ///< of C, y following c
  };
  [[nodiscard]] bool linearise_around_chain();
  /// c_p, from F_p and C_p; NaN where it is not found.
  [[nodiscard]] Eigen::VectorXd slope_rates(std::vector<double> residual,
                                            const Eigen::VectorXd& open);
  /// The point, with θ turned as in another scene.
  [[nodiscard]] PrimalDual turned_to(const Scene& scene) const;

  Equations at_;
  PrimalDual point_;
  double phi_;
  double time_ = 0.0;
  bool regular_ = false;
  std::vector<long double> pull_;  ///< ∂𝓛/∂x
  std::unique_ptr<BorderedChain> chain_;
  AroundChain around_;  ///< empty unless the slope at A is open
};

}  // namespace brachisto
