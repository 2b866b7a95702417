// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Many free scenes at once: indirect shooting with as many scenes side by side
/// as a vector register holds numbers.
///
/// Each scene is continued from its own cycloid, η = 0, to its η_m and then
/// into its world, as one alone is, and looks at no other: its digits do not
/// depend on which scenes stand beside it, nor on the processor.

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "brachisto/model/scene.hpp"

namespace brachisto::lanes {

/// A place of an extremal, in natural units.
struct Place {
  double x = 0.0, z = 0.0, theta = 0.0, w = 0.0;
  double p_x = 0.0, p_z = 0.0, p_theta = 0.0, p_w = 0.0;
  double beta = 0.0;       ///< slope angle [rad]
  double beta_rate = 0.0;  ///< dβ/du
  double t = 0.0;          ///< time
  double root = 0.0;       ///< √A
};

/// The most steps of the path that is kept.
inline constexpr int kMostPlaces = 128;

/// Where a field has a kink on a surface, so far beyond it a path may be that
/// has the law of one side, in natural units: what that is off by in energy is
/// the square of it.
inline constexpr double kBeyondSurface = 1e-9;
/// How far a place is on the side whose law a scene does not have; nothing in
/// a field without a kink.
[[nodiscard]] double beyond_surface(const Scene& natural, double x, double z,
                                    double theta);

/// An extremal with smooth contacts, in natural units.
struct Extremal {
  static constexpr std::size_t kUnknowns = 4;

  /// All that is asked of it holds; without it nothing else has a meaning.
  bool found = false;
  double transit_time = 0.0;  ///< T
  /// Relative, of T: what doubling the steps changed, and rounding.
  double error_estimate = 0.0;
  double phi = 0.0;           ///< slope angle at B [rad]
  double mismatch = 0.0;      ///< largest residual of the shooting
  double min_legendre = 0.0;  ///< of ∂²𝓗/∂β²
  /// ∂²T/∂S² of the least time to B by paths of given length, and the least
  /// Jacobi determinant as a share of its size: a minimum has both positive.
  double by_length = 0.0, least_jacobian = 0.0;
  /// Whose law of a field with a kink it has, and is on.
  std::optional<FieldSide> side;
  int places = 0;                           ///< steps of the path
  std::array<Place, kMostPlaces + 1> path;  ///< at u = i U/places
  /// p_x, p_z, p_θ at the start, and U.
  std::array<double, kUnknowns> unknowns{};
  /// Of the determinant of ∂(residual)/∂(unknowns), the same all along a
  /// branch.
  double sign = 0.0;

  [[nodiscard]] const Place& start() const { return path.front(); }
  [[nodiscard]] const Place& end() const {
    return path[static_cast<std::size_t>(places)];
  }
  [[nodiscard]] double rolling_time() const { return unknowns[3]; }
};

/// Where a shot of some unknowns has led.
struct Landing {
  /// The centre off its place above B by x and z, p_θ r, and p_w.
  std::array<double, Extremal::kUnknowns> residual{};
  double transit_time = 0.0;
  double beta = 0.0, start_beta = 0.0;  ///< slope angles at B and at A [rad]
};
/// How that changes with each of the unknowns.
using Response = std::array<Landing, Extremal::kUnknowns>;

/// Whether such a scene is one of those that are solved side by side: an
/// off-centred cylinder or ball in the uniform field or that of a sphere, in
/// air or not, from rest or pushed, without losses, limits and a path of its
/// own.
[[nodiscard]] bool fits(const Scene& scene);

/// Sets of instructions that there is code for.
enum class Instructions { Baseline, Avx2, Avx512 };
/// The best one that this processor has.
[[nodiscard]] Instructions best_instructions();

/// How finely scenes are followed.
struct Fineness {
  int offsets;         ///< from the cycloid to η_m in so many equal steps
  int on_the_way;      ///< steps of the integration there
  int places;          ///< steps of the path that is kept, at the end
  int within;          ///< and of the integration for each of them
  int into_world = 0;  ///< and then into its world, unless it is ordinary
};
/// Enough for three scenes of four, and for most of the others.
inline constexpr Fineness kPlain{8, 10, kMostPlaces / 2, 1, 4},
    kFine{16, 20, kMostPlaces, 1, 16};

/// The principal extremal of each scene.
/// \pre fits() and validate() is empty of all
[[nodiscard]] std::vector<Extremal> shoot(
    std::span<const Scene> scenes, const Fineness& fineness = kPlain,
    Instructions instructions = best_instructions());

/// The extremal of each scene that continues a known one.
/// \param from   its scene
/// \pre besides, both have the same kind of contacts
[[nodiscard]] std::vector<Extremal> shoot_beside(
    std::span<const Scene> scenes, const Scene& from, const Extremal& known,
    const Fineness& fineness, Instructions instructions = best_instructions());

/// Shots with the unknowns of an extremal, one step between two of its places,
/// for scenes of its own natural units.
[[nodiscard]] std::vector<Landing> land(
    std::span<const Scene> natural, const Extremal& extremal,
    Instructions instructions = best_instructions());
/// How the shot of the scene itself responds to them, to the first order.
[[nodiscard]] Response respond(const Scene& natural, const Extremal& extremal);

}  // namespace brachisto::lanes
