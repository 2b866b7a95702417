// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How the time of a free extremal changes with its scene.

#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "refinement/time_rates.hpp"
#include "solvers/bordered_chain.hpp"
#include "transcription/contact_equation.hpp"
#include "transcription/extremal_curve.hpp"
#include "transcription/rolling_time.hpp"
#include "transcription/start_equation.hpp"

namespace brachisto {

/// With F(y, p) = 0 the optimality conditions between given ends, y being
/// (x, λ), and 𝓛 the Lagrangian, whose fixed variables have values that move,
/// several numbers c = (φ, α, σ₁, σ₂, …) close the path: the slopes at B and A,
/// as far as they are open, and the element ends where it passes the surface of
/// a field. Their equations C(y, c, p) = 0, for σ_k that the centre of mass is
/// on the surface there, are solved around the chain, all together: one closed
/// inside of another would meet folds that all together do not have,
///
///     (C_c − C_y F_y⁻¹ F_c) c_p = C_y F_y⁻¹ F_p − C_p,
///     dT/dp = 𝓛_p + 𝓛_c c_p.
///
/// Every element keeps the field of its own side of the surface. F_p, C_p and
/// 𝓛_p are differences of formulas at one and the same point, at which θ alone
/// turns with the centre of mass: as a function of offset and θ − θ_m they are
/// regular at η = 0. By σ_k all of them are linear.
class FreeRates final : public TimeRates {
 public:
  /// Of a solution, x and λ, whose element ends first go to where the path
  /// passes the surface of a field, if they are not there. Null if no solution
  /// is found with them.
  [[nodiscard]] static std::unique_ptr<FreeRates> make(
      const ExtremalCurve& curve, const PrimalDual& point, double phi);
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
  /// A scene's elements, and of which side of a surface each has the field;
  /// nothing where there is no surface.
  struct Elements {
    Mesh mesh;
    std::vector<FieldSide> sides;
  };
  /// The equations of a scene.
  struct Equations {
    RollingTime problem;
    std::vector<int> passages;  ///< elements that begin on the surface
    std::optional<ContactEquation> contact;  ///< at B
    std::optional<StartEquation> start;      ///< at A, where it is open
    KktSystem system;

    Equations(const Scene& scene, const Elements& elements, double phi);
    [[nodiscard]] const Scene& scene() const { return problem.scene(); }
    /// The slopes that close, at B, then at A.
    [[nodiscard]] std::vector<nlp::TangencyCondition*> slopes();
    /// C: theirs, and the heights at the passages.
    [[nodiscard]] std::vector<nlp::TangencyCondition::Linearisation> rows(
        const PrimalDual& point);
  };
  /// Derivatives by one number at one and the same point.
  struct Partial {
    std::vector<double> residual;  ///< of F
    Eigen::VectorXd open;          ///< of C
    double lagrangian = 0.0;  ///< of 𝓛, the values of fixed variables moving
    double start_angle = 0.0;
  };
  /// Of 𝓛 and C by one number, y following.
  struct Rates {
    double time = 0.0;
    Eigen::VectorXd open;
  };

  FreeRates(const Scene& scene, Elements elements, const PrimalDual& point,
            double phi);
  /// Solves from nearby, the element ends following the passages.
  [[nodiscard]] static std::unique_ptr<FreeRates> closed(Scene scene,
                                                         Elements elements,
                                                         PrimalDual point,
                                                         double phi);
  [[nodiscard]] bool linearise_around_chain();
  [[nodiscard]] Partial nothing() const;
  /// \param moved_to  the scene and the elements for a value of the number, 0
  ///                  for those of the solution
  [[nodiscard]] Partial partial(
      double step,
      const std::function<std::pair<Scene, Elements>(double)>& moved_to);
  /// The elements with the one passage moved.
  [[nodiscard]] Elements moved_passage(std::size_t number, double by) const;
  /// By how much the element ends miss the passages, as Newton's method has it.
  [[nodiscard]] Eigen::VectorXd misses() const;
  /// With y following; NaN where it cannot.
  [[nodiscard]] Rates followed(Partial by);
  /// The point, with θ turned as in another scene.
  [[nodiscard]] PrimalDual turned_to(const Scene& scene) const;

  Elements elements_;
  Equations at_;
  PrimalDual point_;
  double phi_;
  double time_ = 0.0;
  bool regular_ = false;
  std::vector<long double> pull_;  ///< ∂𝓛/∂x
  std::unique_ptr<BorderedChain> chain_;
  std::vector<nlp::TangencyCondition::Linearisation> rows_;  ///< C
  std::vector<Rates> closing_;                               ///< by c
};

}  // namespace brachisto
