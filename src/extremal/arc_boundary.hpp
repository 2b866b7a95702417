// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Conditions at the two ends of an extremal.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "extremal/arc_flow.hpp"

namespace brachisto::arcs {

/// How a path leaves A.
class Departure {
 public:
  enum class Kind {
    Free,     ///< with the slope that makes 𝓗 minimal
    Forced,   ///< along a limit on forces, from the border of the static cone
    Turning,  ///< along a limit of the curvature
  };

  /// \param natural  the scene, in natural units
  /// \param held     the limit that holds from A on
  /// \param near     a slope near the one at A [rad]
  Departure(const Scene& natural, const std::optional<HeldLimit>& held,
            double near);

  [[nodiscard]] Kind kind() const { return kind_; }
  /// Why this method does not know starts of the kind; empty if it does.
  [[nodiscard]] const std::string& refusal() const { return refusal_; }

  /// The rest is left after so much u by its series where the start is Forced:
  /// there the control is 0/0. With β right to the second order and w − g a u
  /// of the third the states err by 1e-15.
  static constexpr double kLeftRest = 1e-5;
  /// States after that much or less, and no costates.
  [[nodiscard]] State left_rest(double u = kLeftRest) const;

  /// What vanishes at the first node: states that are known, and p_β where β is
  /// a state that is not.
  [[nodiscard]] std::vector<Jet> conditions(const LinearPoint& first) const;

 private:
  Scene scene_;
  Kind kind_ = Kind::Free;
  /// β₀, where the contact does not leave it to the path.
  std::optional<double> slope_;
  double rise_ = 0.0;  ///< of β over u², where it is Forced
  std::string refusal_;
};

/// What vanishes at B.
/// \param turns  whether β is a state there
[[nodiscard]] std::vector<Jet> end_conditions(const Scene& natural,
                                              const LinearPoint& last,
                                              bool turns);

}  // namespace brachisto::arcs
