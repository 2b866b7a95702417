// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Hamilton's equations in another world, where p_x and p_z need not be
/// constant, and their integration.

#pragma once

#include <Eigen/Core>
#include <functional>
#include <utility>

#include "extremal/adaptive_integration.hpp"
#include "model/world_hamiltonian.hpp"

namespace brachisto::worlds {

/// Order of the states and costates, that of PhasePoint.
enum Component : std::size_t {
  kX,
  kZ,
  kTheta,
  kW,
  kPX,
  kPZ,
  kPTheta,
  kPW,
  kSize
};
inline constexpr std::size_t kStates = 4;
using State = std::array<double, kSize>;

/// The right-hand side (∂𝓗/∂p, −∂𝓗/∂y) with β eliminated by ∂𝓗/∂β = 0, from
/// one jet of 𝓗, whose second derivatives are its linearisation.
class WorldFlow {
 public:
  /// \param natural  in natural units. A bead gets 1/r = 1, which turns its θ
  ///                 into the arc length
  explicit WorldFlow(Scene natural)
      : scene_(std::move(natural)),
        inverse_radius_(shooting::inverse_radius(scene_.body)) {}

  /// The same with the law of one side of the sphere's surface on both.
  [[nodiscard]] WorldFlow on_side(SphereSide side) const;
  [[nodiscard]] bool has_surface() const {
    return scene_.world.sphere.has_value();
  }
  /// How far the centre of mass is above that surface.
  [[nodiscard]] double height(const State& y) const;
  /// Its change with a change v of the state.
  [[nodiscard]] double height_variation(const State& y, const State& v) const;

  /// 𝓗 with its derivatives where its minimum nearest to the slope angle
  /// `beta` is, which becomes β; false if there is none.
  [[nodiscard]] bool find_slope(const State& y, double& beta,
                                PhaseJet& h) const;
  /// What h says of the rates.
  [[nodiscard]] static State rates(const PhaseJet& h);
  /// Change of the rates with a change v of the state.
  [[nodiscard]] static State variation(const PhaseJet& h, const State& v);
  /// Change of β with it.
  [[nodiscard]] static double slope_variation(const PhaseJet& h,
                                              const State& v);
  /// √A, and its change.
  [[nodiscard]] double time_rate(const State& y, double beta) const;
  [[nodiscard]] double time_variation(const State& y, double beta,
                                      const PhaseJet& h, const State& v) const;

  [[nodiscard]] double inverse_radius() const { return inverse_radius_; }

 private:
  Scene scene_;
  double inverse_radius_;
};

/// Where an arc ends.
struct ArcEnd {
  static constexpr int kWidth = static_cast<int>(kSize);

  State y;
  double t = 0.0;     ///< ∫√A du over the arc
  double beta = 0.0;  ///< continuous along the arc
  State rates;        ///< dy/du
  double time_rate = 0.0;
  int steps = 0;
  Eigen::Matrix<double, kWidth, kWidth> by_start;  ///< ∂y/∂(y at the start)
  Eigen::Matrix<double, 1, kWidth> time_by_start;
};

/// Integrates from u = 0 to `span` with the derivatives. Where the centre of
/// mass passes the surface of a sphere, on which the field has a kink, a step
/// ends: an error estimate from stages on both sides would see little of it.
/// \param near  slope angle near the start
/// \param step  [in,out] step to try first; the last one taken
[[nodiscard]] bool integrate_arc(const WorldFlow& flow, const State& start,
                                 double near, double span,
                                 const shooting::StepControl& control,
                                 double& step, ArcEnd& end);

/// A state on the way.
struct Passed {
  double u = 0.0;
  State y{};
  double t = 0.0, beta = 0.0;
};

/// The same without derivatives; tells of the start and of every step.
[[nodiscard]] bool follow_arc(const WorldFlow& flow, const State& start,
                              double near, double span,
                              const shooting::StepControl& control,
                              const std::function<void(const Passed&)>& tell);

/// One step of length `span`, unchecked: for interpolation.
[[nodiscard]] Passed step_from(const WorldFlow& flow, const Passed& from,
                               double span);

}  // namespace brachisto::worlds
