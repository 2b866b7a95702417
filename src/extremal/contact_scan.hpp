// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// All extremals of a scene, from every way to arrive at B.

#pragma once

#include <functional>
#include <vector>

#include "brachisto/model/scene.hpp"
#include "extremal/extremal_path.hpp"

namespace brachisto {

/// An extremal with smooth contact at both ends, or between the centre's fixed
/// ends, to some eight digits.
struct ScannedContact {
  double phi = 0.0;                 ///< slope angle at B [rad]
  double rolling_time = 0.0;        ///< U
  double transit_time = 0.0;        ///< T
  double centre_path_length = 0.0;  ///< S
  double p_x = 0.0, p_z = 0.0;
  ExtremalPath path;
};

/// What a scan found.
struct ContactScan {
  std::vector<ScannedContact> contacts;  ///< fastest first
  /// Starts of Newton's method that the grid gave, and how many were tried.
  long starts = 0, tried = 0;
  bool whole_grid = false;  ///< all of it was shot from

  /// False if the scan was stopped, or reached the bound of its work.
  [[nodiscard]] bool complete() const { return whole_grid && tried == starts; }
};

/// Looks for extremals by shooting backwards.
///
/// The orientation θ and the slope angle φ with which a body arrives at B
/// determine one extremal, which is followed back until the body rests (w = 0).
/// A contact is a pair (θ, φ) in [0, 2π) × [−π, π] for which that happens at
/// C_A with the orientation θ_m, up to whole turns: two equations, and the box
/// is bounded. It is covered by a grid; the two equations, interpolated in
/// triangles, tell where to start Newton's method. No contact is missed but
/// those that the grid is too coarse for: pairs next to a fold.
///
/// Cost: some ten thousand integrations, each linear in the turns of the body,
/// as is the number of starts. The work is bounded; starts inside of their
/// triangles come first, the others as they lie ever further outside.
///
/// \param natural  the scene, off-centred, with Contact::Smooth or
///                 Contact::Centre, in natural units; so is the result
/// \param longest  paths of the centre longer than this are left out
/// \param stop     asked now and then; true ends the search with what is found
/// \param most_steps  bound on the steps of all integrations
[[nodiscard]] ContactScan scan_contacts(const Scene& natural, double longest,
                                        const std::function<bool()>& stop,
                                        long most_steps = 10'000'000);

}  // namespace brachisto
