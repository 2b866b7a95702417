// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What a design may change of a body.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "brachisto/model/mass_distribution.hpp"

namespace brachisto {

/// A property of the body that a design may choose.
enum class BodyKey { EtaM, ThetaM, K, Radius };

inline constexpr std::size_t kNumBodyKeys = 4;
inline constexpr std::array<BodyKey, kNumBodyKeys> kBodyKeys{
    BodyKey::EtaM, BodyKey::ThetaM, BodyKey::K, BodyKey::Radius};

/// "eta_m", "theta_m", "k", "r": as a problem file calls it.
[[nodiscard]] std::string_view name(BodyKey key);

struct DesignBounds {
  double lower = 0.0, upper = 0.0;
};

/// A part of the body whose place or mass a design may choose.
struct FreePart {
  enum class Key { At, Mass };

  std::size_t part = 0;  ///< its index
  Key key = Key::At;
  DesignBounds bounds;  ///< of the mass; a place is bounded by the cylinder
};

/// Largest η_m of a design that states no bound: at η_m = 1, k = 0 the inertia
/// factor A vanishes whenever the mass touches the track.
inline constexpr double kLargestOffset = 0.99;

/// The friction coefficient that there is, asked for from a share of the
/// transit time on: at a start from rest no friction would do.
struct MaxGrip {
  double mu = 0.0;      ///< > 0
  double after = 0.01;  ///< share of the transit time, in [0, 1)
};

inline constexpr int kMostDesignStarts = 1000;

/// The section `design` of a problem file: which body is the quickest on its
/// track.
struct DesignPlan {
  enum class Minimised { Tau };

  Minimised minimised = Minimised::Tau;
  std::vector<BodyKey> free;  ///< each once
  /// As stated; see bounds_of().
  std::array<std::optional<DesignBounds>, kNumBodyKeys> bounds;
  /// Whether the body has to be able to run on its track; see
  /// Solution::feasible().
  bool require_feasible = true;
  /// What is asked of a feasible body besides; only if that is required.
  std::optional<MaxGrip> max_grip;
  int starts = 5;  ///< the body of the scene, then random ones; ≥ 1
  std::uint64_t seed = 1;
  std::optional<int> start;  ///< the one that is searched from, 1 to `starts`;
                             ///< nothing: all
  std::vector<MassPart> parts;  ///< of the body, if the file tells them
  std::vector<FreePart> free_parts;

  /// Whether there is nothing to design.
  [[nodiscard]] bool empty() const {
    return free.empty() && free_parts.empty();
  }
  [[nodiscard]] bool is_free(BodyKey key) const;
  /// The bounds that hold: as stated, or of all bodies, ±∞ where there is none.
  [[nodiscard]] DesignBounds bounds_of(BodyKey key) const;
};

}  // namespace brachisto
