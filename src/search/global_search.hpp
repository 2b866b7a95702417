// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// All extremals of a scene that can be found.

#pragma once

#include <functional>
#include <string>
#include <vector>

#include "brachisto/math/clock.hpp"
#include "brachisto/run/solve_options.hpp"
#include "transcription/extremal_curve.hpp"

namespace brachisto {

/// An extremal on the mesh of the search, with smooth contact or between the
/// centre's fixed ends.
struct ContactCandidate {
  ExtremalCurve curve;
  double phi = 0.0;  ///< of the smooth contact
};

/// By what those that take as long are told apart: φ of smooth contacts [rad],
/// the length of the centre's path between its fixed ends, whose slope there
/// errs by far more on coarse meshes.
[[nodiscard]] double mark_of(const ContactCandidate& extremal);

/// More are not solved for on a mesh.
inline constexpr int kMostContacts = 24;

/// Outcome of find_contacts().
struct ContactSearch {
  std::vector<ContactCandidate> contacts;
  int newton_steps = 0;
  /// What the search left undone because its work is bounded, and how many
  /// extremals were lost on a mesh; empty if nothing.
  std::string remark;
};

/// Looks for other extremals: roots of β_end(φ) − φ, or between fixed ends.
///
/// scan_contacts() finds them by shooting backwards from B; Newton's method
/// then solves for each on a mesh. A body that is not off-centred has but one,
/// and nothing is searched. What is found is not guaranteed to be all there is.
/// There are about as many as turns: beyond kMostContacts the slower ones are
/// left out.
///
/// \param scene     in natural units, with Contact::Smooth or Contact::Centre
/// \param longest   paths of the centre longer than this are left out
/// \param mesh_for  mesh that can represent a path of given length
/// \param known     those known already; they come first in the result, the
///                  others follow by T
[[nodiscard]] ContactSearch find_contacts(
    const Scene& scene, double longest,
    const std::function<Mesh(double length)>& mesh_for,
    std::vector<ContactCandidate> known, const StopCondition& stop,
    const ProgressHook& progress = {});

}  // namespace brachisto
