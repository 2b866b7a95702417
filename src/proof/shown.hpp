// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What was shown of a scene, and how a certificate writes it.

#pragma once

#include <string>
#include <vector>

#include "proof/arc_theorems.hpp"
#include "proof/scene_json.hpp"

namespace brachisto::proof {

/// What was shown, of one free arc or of a chain.
struct Shown {
  std::vector<std::string> names;  ///< of the unknowns
  Vector searched, found;
  int steps = 0;
  Enclosures enclosed;
  Json theorems;
  std::vector<Friction> friction;
  std::vector<Junction> junctions;
  Json arcs;  ///< null of one free arc of a plain scene
};

[[nodiscard]] Shown shown_of(const PlainSystem& system, const Root& root,
                             const Accuracy& accuracy);
[[nodiscard]] Shown shown_of(const ArcSystem& system, const Root& root,
                             const Accuracy& accuracy);

/// The certificate.
[[nodiscard]] Json document(const Scene& scene, const Accuracy& accuracy,
                            const Shown& shown);

/// Where a ball ends, rounded outward to so many digits as ends are printed
/// with.
[[nodiscard]] std::string decimal_end(const Real& ball, bool upper);

}  // namespace brachisto::proof
