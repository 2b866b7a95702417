// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// An extremal of any world and under limits as a chain of arcs: what they are,
/// and where one is, nearly.

#pragma once

#include <array>
#include <string>
#include <vector>

#include "brachisto/model/scene.hpp"
#include "proof/hamilton.hpp"
#include "proof/real.hpp"
#include "proof/scene_json.hpp"

namespace brachisto::proof {

/// The arcs of an extremal, along each of which one limit holds or none.
struct ArcChain {
  Scene scene;
  std::vector<Held> arcs;
  /// In front of an arc: limits of the control hold on both sides, and bound it
  /// from opposite ones.
  std::vector<bool> opposite;

  /// Whether the costates jump along the normal of the boundary in front of an
  /// arc: behind a limit of the control alone.
  [[nodiscard]] bool jumps(std::size_t arc) const {
    return arc > 0 && along_boundary(arcs[arc]) && along_bound(arcs[arc - 1]);
  }
  /// Numbers of a node and a length of each arc, then the jumps.
  static constexpr std::size_t kPerArc = kNode + 1;
  [[nodiscard]] std::size_t num_unknowns() const;
  [[nodiscard]] static std::size_t node(std::size_t arc) {
    return arc * kPerArc;
  }
  [[nodiscard]] static std::size_t length(std::size_t arc) {
    return arc * kPerArc + kNode;
  }
  /// The jump in front of an arc. \pre jumps(arc)
  [[nodiscard]] std::size_t jump(std::size_t arc) const;
  /// Powers of two near their natural units, in which boxes are about as wide
  /// in all directions.
  [[nodiscard]] std::vector<double> units() const;
  /// "2.p_x".
  [[nodiscard]] std::vector<std::string> names() const;
  [[nodiscard]] bool one_free_arc() const {
    return arcs.size() == 1 && !arcs.front();
  }
  /// "free, floor, free".
  [[nodiscard]] std::string in_words() const;
};

/// Why nothing is proven of such a chain, in one sentence; empty if it may be
/// tried.
[[nodiscard]] std::string not_of_this_kind(const ArcChain& chain);

/// Near an extremal of numbers of 64 bits, in the units of in_own_units().
struct NearChain {
  ArcChain chain;
  std::vector<Real> unknowns;
};

/// Solves the scene for its arcs.
/// \throws NotProven  if there is no answer, or none of arcs that are known
[[nodiscard]] NearChain approximate_chain(const Scene& scene);

/// Whether two limits of a scene are the same.
[[nodiscard]] bool same_limit(const PathInequality& a, const PathInequality& b);

/// The arcs in a certificate, and back.
[[nodiscard]] Json arcs_json(const ArcChain& chain);
/// \throws Refused  if they are none of the scene's
[[nodiscard]] ArcChain chain_from(const Scene& scene, const Json& said);

}  // namespace brachisto::proof
