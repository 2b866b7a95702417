// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The ways to a path under the limits of one scene.

#pragma once

#include <optional>
#include <string>

#include "refinement/arc_search.hpp"
#include "refinement/arcs_from_mesh.hpp"
#include "refinement/tightening.hpp"

namespace brachisto {

/// Ways that begin with the free path, one after the other, until one leads to
/// a path with arcs or, on meshes that know none, to an answer(). The protocol
/// then tells what the first of them that took care ended with.
class LimitedWays {
 public:
  /// The share of the work and the iterations that find_at_once() may take.
  static constexpr double kSearchRough = 0.1;

  /// All but phi must outlive this.
  ///
  /// \param scene  in natural units, with limits
  /// \param free   the extremal without them, with the end angle φ
  LimitedWays(const Scene& scene, const Discretisation& wanted,
              const ExtremalCurve& free, double phi, const MeshOptions& options,
              PassProtocol& protocol);

  /// All of them: at once, or else with care, which then may take as much work
  /// as without that.
  [[nodiscard]] std::optional<FittedPath> find();
  /// The arcs that a rough path tells, if they fit: with a tenth of the work
  /// and of the iterations that are left. If they do not, it gives no reason.
  [[nodiscard]] std::optional<FittedPath> find_at_once();
  [[nodiscard]] std::optional<FittedPath> find_with_care();
  /// What a coarse path that keeps the limits leads to.
  [[nodiscard]] std::optional<FittedPath> from_tight(const LimitedCurve& found);
  /// What a path under other limits leads to.
  [[nodiscard]] std::optional<FittedPath> from_beside(const LimitedCurve& path);
  /// What the best of a few random paths leads to, each found with a share of
  /// the work that is left.
  [[nodiscard]] std::optional<FittedPath> from_random();

  /// On meshes that know no arcs; arcs are read off where one is finest. Once.
  [[nodiscard]] std::optional<FittedPath> from_mesh();
  /// The same with other work.
  [[nodiscard]] std::optional<FittedPath> from_mesh_again();
  /// Whether there is a path for it, and too little work was left.
  [[nodiscard]] bool mesh_wants_work() const {
    return tightening_.tight() && !wanted_.fixed() &&
           (!tried_mesh_ || mesh_wants_work_);
  }

  [[nodiscard]] Tightening& tightening() { return tightening_; }
  [[nodiscard]] const Tightening& tightening() const { return tightening_; }
  /// On a mesh that knows no arcs, where none were found.
  [[nodiscard]] const std::optional<PathWithoutArcs>& mesh() const {
    return mesh_;
  }
  /// Whether nothing else is to be tried.
  [[nodiscard]] bool ended() const {
    return protocol_.stopped() || protocol_.status == Status::NoFastestTrack;
  }

 private:
  [[nodiscard]] std::string only_on_coarse_mesh() const;

  [[nodiscard]] std::optional<FittedPath> read_off_rough();
  /// What the coarse path that tightening() ended with leads to.
  [[nodiscard]] std::optional<FittedPath> from_tight();

  /// From what the interior-point method found.
  [[nodiscard]] std::optional<FittedPath> read_off();
  [[nodiscard]] std::optional<FittedPath> arcs_from(const LimitedCurve& mesh);
  /// From the loosest limits.
  [[nodiscard]] std::optional<FittedPath> follow_from_loosest();
  /// How far that came.
  [[nodiscard]] std::string followed() const;
  /// What the program finds next to a path that keeps looser limits.
  [[nodiscard]] std::optional<FittedPath> from_nearby(const FittedPath& path);
  /// Where the contact at B could not be followed.
  [[nodiscard]] std::optional<FittedPath> bracketed();
  [[nodiscard]] bool goes_elsewhere();

  /// See PassProtocol::Share.
  [[nodiscard]] std::optional<FittedPath> with_share(
      double share, std::optional<FittedPath> (LimitedWays::*way)()) {
    const PassProtocol::Share part(protocol_, share);
    return (this->*way)();
  }

  const Scene& scene_;
  const Discretisation& wanted_;
  const ExtremalCurve& free_;
  double phi_;
  const MeshOptions& options_;
  PassProtocol& protocol_;
  ArcSearch arcs_{protocol_, options_};
  Tightening tightening_;
  std::optional<PathWithoutArcs> mesh_;
  bool tried_mesh_ = false, mesh_wants_work_ = false;
  double reached_ = 0.0;  ///< share of the way from the loosest limits
};

}  // namespace brachisto
