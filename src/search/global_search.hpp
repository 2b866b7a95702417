// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// All smooth contacts of a scene that can be found.

#pragma once

#include <functional>
#include <string>
#include <vector>

#include "brachisto/math/clock.hpp"
#include "brachisto/run/solve_options.hpp"
#include "transcription/extremal_curve.hpp"

namespace brachisto {

/// A smooth contact on the mesh of the search.
struct ContactCandidate {
  ExtremalCurve curve;
  double phi = 0.0;
};

/// More are not solved for on a mesh.
inline constexpr int kMostContacts = 24;

/// Outcome of find_contacts().
struct ContactSearch {
  std::vector<ContactCandidate> contacts;
  int newton_steps = 0;
  /// What the search left undone because its work is bounded; empty if nothing.
  std::string remark;
};

/// Looks for roots of β_end(φ) − φ.
///
/// scan_contacts() finds them by shooting backwards from B; Newton's method
/// then solves for each on a mesh. A body that is not off-centred has but one
/// smooth contact, and nothing is searched. What is found is not guaranteed to
/// be all there is. There are about as many contacts as turns: beyond
/// kMostContacts the slower ones are left out.
///
/// \param scene     in natural units, with Contact::Smooth
/// \param longest   paths of the centre longer than this are left out
/// \param mesh_for  mesh that can represent a path of given length
/// \param known     contacts known already; they come first in the result, the
///                  others follow by T
[[nodiscard]] ContactSearch find_contacts(
    const Scene& scene, double longest,
    const std::function<Mesh(double length)>& mesh_for,
    std::vector<ContactCandidate> known, const StopCondition& stop,
    const ProgressHook& progress = {});

}  // namespace brachisto
