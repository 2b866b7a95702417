// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/limited_ways.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "refinement/arc_following.hpp"
#include "refinement/cold_paths.hpp"
#include "refinement/open_conditions.hpp"
#include "solvers/pivot_store.hpp"

namespace brachisto {

LimitedWays::LimitedWays(const Scene& scene, const Discretisation& wanted,
                         const ExtremalCurve& free, double phi,
                         const MeshOptions& options, PassProtocol& protocol)
    : scene_(scene),
      wanted_(wanted),
      free_(free),
      phi_(phi),
      options_(options),
      protocol_(protocol),
      tightening_(scene, free, phi, options.ipopt, protocol) {}

std::optional<FittedPath> LimitedWays::from_beside(const LimitedCurve& path) {
  if (!tightening_.tighten_from(path)) return std::nullopt;
  return from_tight();
}

std::optional<FittedPath> LimitedWays::from_tight(const LimitedCurve& found) {
  tightening_.take_tight(found);
  return from_tight();
}

std::optional<FittedPath> LimitedWays::from_tight() {
  auto path = read_off();
  if (!path && !ended()) path = from_mesh();
  return path;
}

std::optional<FittedPath> LimitedWays::find_at_once() {
  const PhaseTimer timer(Phase::Start);
  protocol_.tries("from the free path");
  const Status status = protocol_.status;
  const std::string message = protocol_.message;
  // What comes after a failure is not to depend on its pivots either.
  const ChainScope apart(ChainScope::threads());
  std::optional<FittedPath> path =
      with_share(kSearchRough, &LimitedWays::read_off_rough);
  // No verdict, nor any reason: both are given with care.
  if (!path && !protocol_.stop.met()) protocol_.fail(status, message);
  return path;
}

std::optional<FittedPath> LimitedWays::find() {
  const double work = protocol_.work;
  auto path = find_at_once();
  if (path || protocol_.stop.met()) return path;
  protocol_.most_work += protocol_.work - work;
  return find_with_care();
}

std::optional<FittedPath> LimitedWays::find_with_care() {
  const PhaseTimer timer(Phase::Start);
  protocol_.tries("from the free path");
  tightening_.leave(protocol_.left(options_.ipopt).max_iterations);
  const bool tightened = tightening_.tighten();
  std::optional<FittedPath> path;
  if (tightened) path = with_share(0.5, &LimitedWays::read_off);
  const auto settled = [&] { return path || mesh_ || ended(); };
  if (settled() || protocol_.status == Status::NoAdmissiblePath) return path;
  Status status = protocol_.status;
  std::string message = tightened ? only_on_coarse_mesh() : protocol_.message;
  // Each leaves some work to those that come after it.
  if (tightened) path = with_share(0.6, &LimitedWays::from_mesh);
  if (!settled() && tightening_.is_shut()) return path;
  if (!settled() && (tightened || status != Status::Infeasible)) {
    path = with_share(0.4, &LimitedWays::follow_from_loosest);
    message += followed();
  }
  if (!settled() && tightened) path = bracketed();
  if (protocol_.status == Status::NoSmoothContact) {
    status = protocol_.status;
    message = protocol_.message;
  }
  while (!settled() && goes_elsewhere()) {
    path = read_off();
    if (!settled()) path = bracketed();
    // That one way is shut is no verdict where another one is open.
    const bool shut = !tightened || status == Status::NoSmoothContact;
    if (!path && shut && protocol_.status != status) {
      status = Status::NotConverged;
      message = only_on_coarse_mesh();
    }
  }
  const bool said = path || protocol_.status == Status::NoFastestTrack;
  if (!said && !protocol_.stop.met()) {
    protocol_.fail(status, message);  // of the first attempt that has one
  }
  return path;
}
std::optional<FittedPath> LimitedWays::read_off_rough() {
  Tightening rough(scene_, free_, phi_, protocol_.left(options_.ipopt),
                   protocol_, Tightening::Care::Rough);
  return rough.tighten() ? arcs_from(rough.last()) : std::nullopt;
}
std::string LimitedWays::only_on_coarse_mesh() const {
  return fmt::format(
      "a path on a coarse mesh keeps the limits, with τ about {:.4g}, but "
      "where they begin and cease to hold was not found: {}",
      tightening_.tight()->transit_time() / std::sqrt(scene_.H),
      protocol_.message);
}

/// Where the contact at B could not be followed.
std::optional<FittedPath> LimitedWays::bracketed() {
  if (!end_is_sought(scene_)) return {};
  protocol_.tries("with the slope at B held at one value after the other");
  if (!tightening_.bracket_contact()) return {};
  return read_off();
}
bool LimitedWays::goes_elsewhere() {
  protocol_.tries("from paths that lead elsewhere");
  return tightening_.tighten_elsewhere();
}

/// What the program finds next to a path that keeps looser limits.
std::optional<FittedPath> LimitedWays::from_nearby(const FittedPath& path) {
  if (protocol_.stopped() || !tightening_.tighten_from(path.curve)) return {};
  return read_off();
}

/// From what the interior-point method found.
std::optional<FittedPath> LimitedWays::read_off() {
  auto path = arcs_from(tightening_.last());
  if (!path && !ended() && tightening_.solve_finer()) {
    path = arcs_from(tightening_.last());
  }
  return path;
}
std::optional<FittedPath> LimitedWays::arcs_from(const LimitedCurve& mesh) {
  return brachisto::arcs_from(mesh, kArcDegree, arcs_, protocol_);
}

/// How far follow_from_loosest() came.
std::string LimitedWays::followed() const {
  if (!(reached_ > 0.0)) return {};
  return fmt::format(
      ". From limits that the free path keeps it was followed {:.3g} of the "
      "way to these; not further",
      reached_);
}

/// From the loosest limits.
std::optional<FittedPath> LimitedWays::follow_from_loosest() {
  constexpr int kFewFollowingSteps = 100;  // where there is an answer already
  const LimitRelaxation& relaxation = tightening_.relaxation();
  protocol_.tries("from limits that the free path keeps");
  if (!tightening_.solve_loosest()) return std::nullopt;
  const LimitedCurve loosest = tightening_.last();
  Followed way = follow(
      arcs_.fit_corrected(
          loosest,
          {relaxation.at(0.0), arcs_of(loosest), loosest.problem().ends()},
          kArcDegree, kExceeded),
      [&](double share) { return Stage{relaxation.at(share)}; },
      {.first = 0.05}, kArcDegree,
      mesh_ ? kFewFollowingSteps : kMostFollowingSteps, arcs_, protocol_);
  reached_ = way.share;
  if (!way.arrived()) {
    return way.path ? from_nearby(*way.path) : std::nullopt;
  }
  return std::move(way.path);
}

std::optional<FittedPath> LimitedWays::from_random() {
  constexpr int kStarts = 3;
  const double each = (protocol_.most_work - protocol_.work) / (kStarts + 1);
  const std::vector<LimitedCurve> found =
      cold_paths(scene_, free_, phi_, protocol_.left(options_.ipopt), kStarts,
                 each, protocol_);
  std::optional<FittedPath> path;
  for (std::size_t i = 0; i < found.size() && !path && !mesh_ && !ended();
       ++i) {
    path = from_tight(found[i]);
  }
  return path;
}

std::optional<FittedPath> LimitedWays::from_mesh() {
  if (std::exchange(tried_mesh_, true)) return {};
  return from_mesh_again();
}
std::optional<FittedPath> LimitedWays::from_mesh_again() {
  if (!tightening_.tight() || wanted_.fixed()) return {};
  protocol_.tries("on meshes that know no arcs");
  FromMesh found = without_its_arcs(*tightening_.tight(), wanted_,
                                    options_.ipopt, arcs_, protocol_);
  mesh_ = std::move(found.mesh);
  mesh_wants_work_ = !found.path && !mesh_ && protocol_.worked_enough();
  return std::move(found.path);
}

}  // namespace brachisto
