// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/study/extremal_bridge.hpp"

#include "brachisto/transcription/prolongation.hpp"

namespace brachisto {

ExtremalGuess as_guess(const ExtremalCurve& curve, const Units& units,
                       double phi) {
  // Costates are minus the gradient of the time: p_x in s/m, p_θ in s, p_w in
  // s per m/s.
  const double per_length = units.time / units.length;
  ExtremalGuess guess;
  guess.rolling_time = curve.rolling_time() * units.time;
  guess.phi = phi;
  guess.p_x = curve.p_x() * per_length;
  guess.p_z = curve.p_z() * per_length;
  guess.state = [&curve, units](double sigma) {
    const ExtremalPoint at = curve.at(sigma);
    return ExtremalState{.x = at.centre.x * units.length,
                         .z = at.centre.z * units.length,
                         .theta = at.theta,
                         .w = at.w * units.speed(),
                         .p_theta = at.p.p_theta * units.time,
                         .p_w = at.p.p_w * units.time / units.speed(),
                         .beta = at.beta,
                         .t = at.t * units.time};
  };
  return guess;
}

PrimalDual sample_extremal(const ExtremalSolution& extremal, const Units& units,
                           const RollingTime& problem) {
  const double per_length = units.time / units.length;
  return sample_at_mesh(
      problem, extremal.rolling_time / units.time, [&](double sigma) {
        const ExtremalState at = extremal.path.at(sigma);
        ExtremalPoint point;
        point.centre = {at.x / units.length, at.z / units.length};
        point.theta = at.theta;
        point.w = at.w / units.speed();
        point.beta = at.beta;
        point.p = {extremal.p_x / per_length, extremal.p_z / per_length,
                   at.p_theta / units.time,
                   at.p_w * units.speed() / units.time};
        return point;
      });
}

}  // namespace brachisto
