// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// All that is computed for the paper.

#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "brachisto/study/design.hpp"
#include "report/sweep_table.hpp"
#include "reproduction/cases.hpp"
#include "reproduction/faster_bodies.hpp"
#include "sweep/manager.hpp"

namespace brachisto::reproduction {

/// τ that the paper's own equations have with n nodes, ε → 0, under two
/// readings of their energy; nothing where the iteration from the cycloid
/// fails.
struct PaperEquations {
  std::optional<double> rest;     ///< as printed, but v = 0 at node 1
  std::optional<double> release;  ///< relative to node 1
};

/// The reference case on a mesh of so many nodes as the paper's.
struct GridRow {
  int nodes = 0;         ///< n of the paper
  double linear = 0.0;   ///< τ by n nodes and degree 1
  double quintic = 0.0;  ///< τ by n + 1 nodes and degree 5
  PaperEquations equations;
};

/// The orientation of a body with the smallest τ.
struct OrientationRow {
  double eta_m = 0.0;
  Orientation fastest;
};

/// τ of the uniform cylinder of some radius.
struct RadiusRow {
  double radius = 0.0;
  double tau = 0.0;
};

/// The largest error of an orientation [rad].
[[nodiscard]] double largest_error(const std::vector<OrientationRow>& rows);

/// A row of the map: one η_m.
struct MapPoint {
  double theta_m = 0.0;  ///< [rad]
  double tau = 0.0;
};
struct MapRow {
  double eta_m = 0.0;
  std::vector<MapPoint> points;
};
[[nodiscard]] std::vector<MapRow> rows_of(const SweepTable& map);

/// Keys that the map varies, and the column of one of them.
inline constexpr const char* kEtaKey = "scene.body.eta_m";
inline constexpr const char* kThetaKey = "scene.body.theta_m";
[[nodiscard]] std::size_t column_of(const SweepTable& map, const char* key);

/// How far a point of the track moves, at the same share of the rolling time,
/// between k = 0.1 and k = 5/9: the farthest of all [H].
struct ShiftByInertia {
  double axisymmetric = 0.0;  ///< η_m = 0
  double off_centred = 0.0;   ///< η_m = 2/3
};

/// The reference case put down with its centre of mass on the other side.
struct BackwardStart {
  double theta_m = 0.0;  ///< |θ_m| > π/2 [rad]
  bool feasible = false;
};

/// A bent_track() for the body of the reference case.
struct BentTrack {
  double phi = 0.0;     ///< [rad]
  double radius = 0.0;  ///< of its arc [H]; 0: a kink, which is never feasible
  double tau = 0.0;
  bool feasible = false;
};

/// Starts of each search for the quickest body: the reference body and random
/// ones.
inline constexpr int kDesignStarts = 5;

/// Over all places of the centre of mass, the radius being given.
struct QuickestBody {
  double L = 0.0;      ///< [H]
  bool any_k = false;  ///< else that of the reference case
  /// The fastest that was found and that can run on its track, on the principal
  /// branch; nothing if the searches ended otherwise.
  std::optional<DesignMinimum> found;
};

struct Results {
  Cases cases;
  SweepTable map = {};  ///< τ over η_m and θ_m
  std::vector<GridRow> grid = {};
  /// By problem file, with the paper's n = 100.
  std::map<std::string, PaperEquations> equations = {};
  std::vector<OrientationRow> orientations = {};
  std::vector<BoundaryBody> boundary = {};       ///< with θ_m = −π/6
  std::vector<BoundaryBody> best_boundary = {};  ///< with the best θ_m
  std::vector<RadiusRow> uniform = {};
  /// τ of a bead between the ends of the *centre's* path of the body that the
  /// paper found to be faster than the bead.
  double bead_between_centres = 0.0;
  ShiftByInertia shift_by_inertia = {};
  double uniform_on_incline = 0.0;  ///< τ on the straight line of Fig. 4
  std::vector<BackwardStart> backward_starts = {};
  /// With a kink, φ from above the smooth contact down to the least time and a
  /// little farther; and with an arc, all of one radius, the least bend first.
  std::vector<BentTrack> kinked = {}, arched = {};
  std::vector<QuickestBody> quickest = {};

  /// τ of a case.
  [[nodiscard]] double tau(const std::string& name) const {
    return cases[name].tau().value;
  }
};

/// Who asks and who listens.
struct Hooks {
  int jobs = 1;  ///< worker processes
  const Interrupt* interrupt = nullptr;
  Announce announce;
  sweep::ProgressSink progress;
};

/// Solves everything.
///
/// \param directory  of the problem files of the paper
/// \throws io::IoError, io::InputError  if a file is missing or wrong
/// \throws NotVerified  if something has no verified answer
/// \throws sweep::StoreError, sweep::WorkersFail  of the map
/// \throws Interrupted
[[nodiscard]] Results find_all(const std::filesystem::path& directory,
                               const Hooks& hooks);

}  // namespace brachisto::reproduction
