// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The paper's own discrete system, for comparison: discrete calculus of
/// variations on n points at equal distances along the path of the centre.

#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "brachisto/model/scene.hpp"
#include "brachisto/run/solve_options.hpp"

namespace brachisto {

/// The 2n + 1 equations (13)–(19) for the unknowns (x_1 … x_n, z_1 … z_n, S):
///
///     x_1 − r s_A = 0                                     (13)
///     l_j − S/(n − 1) = 0               j = 2 … n         (14)
///     z_1 + r c_A = 0                                     (17)
///     (T(z_j + ε) − T(z_j − ε))/(2 ε) = 0,  j = 2 … n − 1 (18)
///     z_n + r c_B = H                                     (19)
///     x_n − r s_B = L                                     (15)
///
/// in this order. l_j is the length of the chord that ends at node j; s and c
/// are sine and cosine of the slopes of the first and last chord. T is the sum
/// of the chords' times with θ_j = θ_m + (l_2 + … + l_j)/r, formed anew for
/// each perturbed path. With Contact::Centre the ends of the centre's path are
/// given, which is r = 0 in (13), (15), (17) and (19).
///
/// Lengths are in units of H, times in √(H/2g), so that T is τ and ε means what
/// it does in the paper, which has H = 1.
class DiscreteVariations {
 public:
  /// \param scene      a valid one; a path that it states is not looked at
  /// \param num_nodes  n ≥ 3
  /// \throws std::invalid_argument if n < 3 or ε < 0
  DiscreteVariations(const Scene& scene, int num_nodes,
                     const DiscreteReading& reading);

  [[nodiscard]] int num_nodes() const { return num_nodes_; }
  [[nodiscard]] int num_unknowns() const { return 2 * num_nodes_ + 1; }
  [[nodiscard]] const DiscreteReading& reading() const { return reading_; }
  /// The scene in units of H.
  [[nodiscard]] const Scene& scene() const { return scene_; }

  /// The uniform cylinder's cycloid at equal arc lengths, and its length;
  /// nothing if there is none.
  [[nodiscard]] std::optional<std::vector<double>> cycloid_guess() const;

  /// The 2n + 1 left-hand sides less right-hand sides. False if one of them is
  /// not a finite number; refusal() says why.
  ///
  /// Cost O(n²): each of the 2 (n − 2) perturbed times sums the chords from the
  /// moved node on, those before it being the same in both; O(n) with ε = 0.
  [[nodiscard]] bool residual(std::span<const double> unknowns,
                              std::span<double> residual) const;

  /// Why the residual is not finite there.
  [[nodiscard]] std::string refusal(std::span<const double> unknowns) const;

  /// T in the units above, which is τ; NaN where E < 0.
  [[nodiscard]] double tau(std::span<const double> unknowns) const;

 private:
  Scene scene_;
  int num_nodes_;
  DiscreteReading reading_;
};

}  // namespace brachisto
