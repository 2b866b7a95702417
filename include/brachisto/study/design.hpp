// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What a design may change of a body, and which bodies it has found.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "brachisto/model/body.hpp"

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

/// A number of a design under the name that its file or its result has for it;
/// in SI units, angles in radians.
struct NamedNumber {
  std::string name;
  double value = 0.0;
};
using NamedNumbers = std::vector<NamedNumber>;

/// A bound that the best body leans on.
struct BoundOfDesign {
  std::string name;  ///< key of the bound, or what it is a bound of
  double bound = 0.0;
  double multiplier = 0.0;  ///< dτ/d(bound), the contacts moving along
};

/// A body that no other one near it is quicker than; or, where a search was
/// lost at the edge of a fold, the quickest one that it has passed.
struct DesignMinimum {
  bool stationary = false;  ///< the former: first-order conditions hold
  Body body;
  NamedNumbers values;  ///< of what is free
  double tau = 0.0;
  bool feasible = false;  ///< with DesignPlan::max_grip, if there is one
  /// Solved anew from the cycloid its track passed every check, and has this τ:
  /// it lies on the principal branch.
  bool verified = false;
  std::vector<std::string> remarks;  ///< why not feasible, why not verified
  NamedNumbers gradient;  ///< dτ/d(value), the contacts moving along
  std::vector<BoundOfDesign> bounds_active;
  /// Eigenvalues, ascending, of the second derivative of τ along the bounds
  /// that hold, by the design's own coordinates; empty if all are held, or if
  /// it could not be had.
  std::vector<double> curvatures;
  int found_from = 0;  ///< as many searches led here
};

/// A body on the way of a search.
struct DesignStep {
  NamedNumbers values;
  double tau = 0.0;
};

/// Bodies on the way of a search, in their order.
using DesignPath = std::vector<DesignStep>;

/// A way of a search that led to no body.
struct LostSearch {
  int search = 0;      ///< its number, from 1 on
  std::string reason;  ///< in words
};

/// What a design came to. The best body is that of the Solution it belongs to.
struct DesignAnswer {
  DesignPlan plan;                    ///< what was asked for
  std::optional<DesignMinimum> best;  ///< one of the minima, or none
  std::vector<DesignMinimum> minima;  ///< quickest first
  std::vector<LostSearch> lost;       ///< each was begun again elsewhere
  std::vector<DesignPath> paths;      ///< of all ways
  int searches = 0;                   ///< that ended
  int starts = 0;  ///< bodies that they began at, in place of lost
                   ///< ones too
  int solves = 0;  ///< closed solutions, of all searches together
  /// The limit of time came before all searches had ended: if none had, the
  /// best is the quickest body that one had reached.
  bool stopped = false;
  double cpu_seconds = 0.0;  ///< of them
};

}  // namespace brachisto
