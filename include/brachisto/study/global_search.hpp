// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// All smooth contacts of a scene that can be found.

#pragma once

#include <functional>
#include <vector>

#include "brachisto/math/stop_condition.hpp"
#include "brachisto/transcription/extremal_curve.hpp"

namespace brachisto {

/// A smooth contact on the mesh of the search.
struct ContactCandidate {
  ExtremalCurve curve;
  double phi = 0.0;
};

/// Outcome of find_contacts().
struct ContactSearch {
  std::vector<ContactCandidate> contacts;
  int newton_steps = 0;
};

/// Looks for roots of β_end(φ) − φ.
///
/// scan_contacts() finds them by shooting backwards from B; Newton's method
/// then solves for each on a mesh. A body that is not off-centred has but one
/// smooth contact, and nothing is searched. What is found is not guaranteed to
/// be all there is.
///
/// \param scene     in natural units, with Contact::Smooth
/// \param longest   paths of the centre longer than this are left out
/// \param mesh_for  mesh that can represent a path of given length
/// \param known     contacts known already; they come first in the result, the
///                  others follow by T
[[nodiscard]] ContactSearch find_contacts(
    const Scene& scene, double longest,
    const std::function<Mesh(double length)>& mesh_for,
    std::vector<ContactCandidate> known, const StopCondition& stop);

}  // namespace brachisto
