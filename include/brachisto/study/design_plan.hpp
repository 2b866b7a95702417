// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What a design may change of a body, and what was found: values alone.

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

/// A number of a design under the name that its file or its result has for it;
/// in SI units, angles in radians.
struct NamedNumber {
  std::string name;
  double value = 0.0;
};
using NamedNumbers = std::vector<NamedNumber>;

struct DesignBounds {
  double lower = 0.0, upper = 0.0;
};

/// Largest η_m of a design that states no bound: at η_m = 1, k = 0 the inertia
/// factor A vanishes whenever the mass touches the track.
inline constexpr double kLargestOffset = 0.99;

inline constexpr int kMostDesignStarts = 1000;

/// The section `design` of a problem file: which body is the quickest on its
/// track.
struct DesignPlan {
  enum class Minimised { Tau };

  Minimised minimised = Minimised::Tau;
  std::vector<BodyKey> free;  ///< each once; empty: there is nothing to design
  /// As stated; see bounds_of().
  std::array<std::optional<DesignBounds>, kNumBodyKeys> bounds;
  /// Whether the body has to be able to run on its track; see
  /// Solution::feasible().
  bool require_feasible = true;
  int starts = 5;  ///< the body of the scene, then random ones; ≥ 1
  std::uint64_t seed = 1;

  [[nodiscard]] bool is_free(BodyKey key) const;
  /// The bounds that hold: as stated, or of all bodies, ±∞ where there is none.
  [[nodiscard]] DesignBounds bounds_of(BodyKey key) const;
};

/// A bound that the best body leans on.
struct BoundOfDesign {
  std::string name;  ///< key of the bound, or what it is a bound of
  double bound = 0.0;
  double multiplier = 0.0;  ///< dτ/d(bound), the contacts moving along
};

/// A body that no other one near it is quicker than.
struct DesignMinimum {
  Body body;
  NamedNumbers values;  ///< of what is free
  double tau = 0.0;
  bool feasible = false;
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
  int found_from = 0;  ///< as many starts led here
};

/// A body on the way of a search.
struct DesignStep {
  NamedNumbers values;
  double tau = 0.0;
};

/// What a design came to. The best body is that of the Solution it belongs to.
struct DesignAnswer {
  DesignPlan plan;
  std::optional<DesignMinimum> best;           ///< one of the minima, or none
  std::vector<DesignMinimum> minima;           ///< quickest first
  std::vector<std::vector<DesignStep>> paths;  ///< of each start
  int solves = 0;            ///< closed solutions, of all starts together
  double cpu_seconds = 0.0;  ///< of them
};

}  // namespace brachisto
