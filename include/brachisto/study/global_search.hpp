// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// All smooth contacts of a scene that can be found.

#pragma once

#include <vector>

#include "brachisto/model/cycloid.hpp"
#include "brachisto/solvers/stop_condition.hpp"
#include "brachisto/transcription/extremal_curve.hpp"

namespace brachisto {

/// A smooth contact on the mesh of the search.
struct ContactCandidate {
  ExtremalCurve curve;
  double phi = 0.0;
};

/// Looks for roots of β_end(φ) − φ.
///
/// Extremals between C_A and C_B(φ) come in families, each a smooth function of
/// φ. From `known` and from cold starts at evenly spaced φ each family is
/// followed over φ in both directions by Newton's method; where β_end(φ) − φ
/// changes sign, the contact is closed. What is found is not guaranteed to be
/// all there is.
///
/// \param scene  in natural units, with Contact::Smooth
/// \param known  contacts known already; they come first in the result
[[nodiscard]] std::vector<ContactCandidate> find_contacts(
    const Scene& scene, const CycloidArc& arc, const Mesh& mesh,
    std::vector<ContactCandidate> known, const StopCondition& stop);

}  // namespace brachisto
