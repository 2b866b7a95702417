// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The numbers of a scene that its time is differentiated by.

#pragma once

#include <array>

#include "brachisto/model/scene.hpp"

namespace brachisto {

/// Of the offset the Cartesian components: by η and θ_m nothing is regular at
/// η = 0.
enum class SceneCoordinate {
  OffsetX,  ///< η cos θ_m
  OffsetZ,  ///< η sin θ_m
  K,
  Radius,
  L,
  H
};

inline constexpr std::array kSceneCoordinates{
    SceneCoordinate::OffsetX, SceneCoordinate::OffsetZ, SceneCoordinate::K,
    SceneCoordinate::Radius,  SceneCoordinate::L,       SceneCoordinate::H};

/// Whether the scene's body has it: a bead has L and H alone.
[[nodiscard]] bool has_coordinate(const Scene& scene,
                                  SceneCoordinate coordinate);

/// The scene with one of them greater by so much. η stays ≥ 0; beyond η = 0 the
/// centre of mass lies on the other side. k may become negative.
[[nodiscard]] Scene moved(const Scene& scene, SceneCoordinate coordinate,
                          double by);

/// A step of central differences of order six in formulas of the scene.
///
/// Lengths enter at worst as 1/r: a step of 2e-3 of it is in error by 36 ·
/// 2e-3⁶ = 2e-15. Of offset and k at worst √A is taken, A ≥ A₀ = (1 − η)² + k
/// and |∂A| ≤ 4: with 2e-3 A₀ that errs by (8e-3)⁶ = 3e-13. Both are relative
/// to the derivative next to the singularity, far from it they are less;
/// rounding adds ε/2e-3 = 1e-13 of the value, over A₀.
[[nodiscard]] double difference_step(const Scene& scene,
                                     SceneCoordinate coordinate);

/// The scene with θ as one of its unknowns, and the same answer: of a body
/// whose centre of mass lies on its axis with the smallest offset there is.
[[nodiscard]] Scene with_rotation(Scene scene);

}  // namespace brachisto
