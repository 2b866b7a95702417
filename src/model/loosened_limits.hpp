// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Limits that ask for less.

#pragma once

#include "brachisto/model/scene.hpp"

namespace brachisto {

/// The limits of a scene, each of them looser the greater `by` is, and of the
/// same kinds: at 0 as they are, at 1 with twenty times the friction, the
/// greatest R_n, in which a small body's mass turns, and the curvatures (a
/// valley of the track stays below 1/r), the least R_n two m g less (not below
/// 0 if it was not), no fold margin, discs shrunk to a tenth,
/// floor and half-planes moved off by H. With Contact::Optimal bounds of humps
/// and the fold margin have a meaning of their own and stay.
///
/// \param by  in [0, 1]
[[nodiscard]] PathLimits loosened_limits(const Scene& scene, double by);

/// The scene under these.
[[nodiscard]] inline Scene loosened(Scene scene, double by) {
  scene.limits = loosened_limits(scene, by);
  return scene;
}

}  // namespace brachisto
