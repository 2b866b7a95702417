// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/limited_refinement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "brachisto/math/index.hpp"
#include "model/loosened_limits.hpp"
#include "model/scene_coordinate.hpp"
#include "refinement/arc_following.hpp"
#include "refinement/arc_search.hpp"
#include "refinement/arcs_from_mesh.hpp"
#include "refinement/open_conditions.hpp"
#include "refinement/surface_passages.hpp"
#include "refinement/tightening.hpp"
#include "refinement/without_arcs.hpp"

namespace brachisto {

namespace {

class LimitedSolve {
 public:
  LimitedSolve(const Scene& scene, const Discretisation& wanted,
               const ExtremalCurve& free, double phi,
               const MeshOptions& options)
      : LimitedSolve(scene, wanted, options) {
    free_ = &free;
    phi_ = phi;
    tightening_.emplace(scene, free, phi, options.ipopt, protocol_);
  }
  /// Beside a path of another scene.
  LimitedSolve(const Scene& scene, const Discretisation& wanted,
               const MeshOptions& options)
      : scene_(scene),
        wanted_(wanted),
        limits_(inequalities(scene.body, scene.limits)),
        options_(options),
        protocol_(options) {}

  LimitedRefinement run() {
    protocol_.most_work = kSearchAsAsked * kMostSearchWork;
    tries("from the free path");
    refine(find_arcs());
    if (!answer_ && !tried_mesh_ && !ended()) refine(from_mesh());
    const bool none = protocol_.status == Status::NoFastestTrack;
    if (answer_ || none || protocol_.stop.met()) return finished();
    if (mesh_) {
      take_mesh();
    } else {
      if (protocol_.worked_enough()) {
        tries("until its share of work was used up");
        // That of an empty set takes all of it; the proof takes none.
        if (protocol_.status != Status::NoAdmissiblePath) {
          tightening_->is_shut();
        }
      }
      protocol_.most_work = kSearchWaves * kMostSearchWork;
      come_from_waves();
      protocol_.most_work = kSearchLooser * kMostSearchWork;
      if (!answer_) come_from_looser();
    }
    return finished();
  }
  LimitedRefinement run_beside(const FittedPath& neighbour, double most_work) {
    protocol_.most_work = most_work;
    const Scene from = neighbour.curve.problem().scene();
    const LimitRelaxation way(neighbour.curve.problem().limits(), limits_);
    const auto stage_at = [&](double share) {
      return Stage{way.at(share), between(from, scene_, share)};
    };
    Followed way_here = followed_by(neighbour, stage_at, {.first = 1.0});
    if (way_here.arrived()) refine(std::move(way_here.path));
    return finished();
  }

 private:
  [[nodiscard]] LimitedRefinement finished() {
    std::optional<BlockingLimit> blocking;
    if (!answer_ && tightening_ &&
        protocol_.status != Status::NoSmoothContact) {
      blocking = tightening_->blocking();
    }
    if (protocol_.status != Status::Solved && passes_surface()) {
      protocol_.message += fmt::format(
          ". It passes {}, where the field has a kink, and under limits a path "
          "is followed on one side alone",
          field_kind(scene_.world)->surface);
    }
    const double work = protocol_.work;
    if (protocol_.worked_enough()) {
      tries("until all the work of a search was used up");
    }
    return {std::move(protocol_).finished(),
            std::move(answer_),
            std::move(blocking),
            std::move(loosened_),
            work,
            std::move(tried_)};
  }

  /// Whether the best path that was found does.
  [[nodiscard]] bool passes_surface() const {
    const LimitedCurve* curve = answer_       ? &answer_->path.curve
                                : tightening_ ? tightening_->any()
                                              : nullptr;
    return curve != nullptr && !surface_passages(*curve).empty();
  }

  [[nodiscard]] std::optional<FittedPath> find_arcs() {
    const PhaseTimer timer(Phase::Start);
    const bool tightened = tightening_->tighten();
    std::optional<FittedPath> path;
    if (tightened) path = with_share(0.5, [&] { return read_off(); });
    const auto settled = [&] { return path || mesh_ || ended(); };
    if (settled() || protocol_.status == Status::NoAdmissiblePath) return path;
    Status status = protocol_.status;
    std::string message = tightened ? only_on_coarse_mesh() : protocol_.message;
    // Each leaves some work to those that come after it.
    if (tightened) path = with_share(0.6, [&] { return from_mesh(); });
    if (!settled() && tightening_->is_shut()) return path;
    if (!settled() && (tightened || status != Status::Infeasible)) {
      path = with_share(0.4, [&] { return follow_from_loosest(); });
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
  [[nodiscard]] std::string only_on_coarse_mesh() const {
    return fmt::format(
        "a path on a coarse mesh keeps the limits, with τ about {:.4g}, but "
        "where they begin and cease to hold was not found: {}",
        tightening_->tight()->transit_time() / std::sqrt(scene_.H),
        protocol_.message);
  }

  /// Where the contact at B could not be followed.
  [[nodiscard]] std::optional<FittedPath> bracketed() {
    if (!end_is_sought(scene_)) return {};
    tries("with the slope at B held at one value after the other");
    if (!tightening_->bracket_contact()) return {};
    return read_off();
  }
  [[nodiscard]] bool goes_elsewhere() {
    tries("from paths that lead elsewhere");
    return tightening_->tighten_elsewhere();
  }

  /// What the program finds next to a path that keeps looser limits.
  [[nodiscard]] std::optional<FittedPath> from_nearby(const FittedPath& path) {
    if (stopped() || !tightening_->tighten_from(path.curve)) return {};
    return read_off();
  }

  /// Under the limits asked for, from paths that have little to do with the
  /// free one.
  void come_from_waves() {
    constexpr int kWaves = 4;  // with half of the work that is left, each
    if (protocol_.status == Status::NoAdmissiblePath) return;
    tries("from random paths");
    const Status status = protocol_.status;
    const std::string message = protocol_.message;
    for (const RoughPath& wavy : waves(scene_, *free_, kWaves)) {
      if (stopped()) break;
      const auto path = path_under(
          0.0,
          [&](Tightening& tightening) { return tightening.tighten_from(wavy); },
          0.5);
      if (path) take(*path);
      if (answer_) return;
    }
    protocol_.fail(status, message);
  }

  /// What is found is made exact, whatever the search took.
  void refine(std::optional<FittedPath> path) {
    if (!path) return;
    const double most_work = std::exchange(
        protocol_.most_work, std::numeric_limits<double>::infinity());
    auto found = refined(*std::move(path), wanted_, arcs_, protocol_);
    if (found) answer_ = std::move(found);
    protocol_.most_work = most_work;
  }
  void tries(const char* way) {
    if (std::ranges::find(tried_, way) == tried_.end()) {
      tried_.emplace_back(way);
    }
  }
  [[nodiscard]] bool stopped() const { return protocol_.stopped(); }
  /// What is found with no more than a share of the work that is left.
  [[nodiscard]] std::optional<FittedPath> with_share(
      double share, const std::function<std::optional<FittedPath>()>& find) {
    const double most_work = protocol_.most_work;
    if (std::isfinite(most_work)) {
      protocol_.most_work -= (1.0 - share) * (most_work - protocol_.work);
    }
    auto found = find();
    protocol_.most_work = most_work;
    return found;
  }
  /// Whether nothing else is to be tried.
  [[nodiscard]] bool ended() const {
    return stopped() || protocol_.status == Status::NoFastestTrack;
  }

  /// From what the interior-point method found.
  [[nodiscard]] std::optional<FittedPath> read_off() {
    auto path = arcs_from(tightening_->last());
    if (!path && !ended() && tightening_->solve_finer()) {
      path = arcs_from(tightening_->last());
    }
    return path;
  }
  [[nodiscard]] std::optional<FittedPath> arcs_from(const LimitedCurve& mesh) {
    return brachisto::arcs_from(mesh, kArcDegree, arcs_, protocol_);
  }

  /// Steps of Newton's method along one way: those that lead anywhere take a
  /// few hundred. Fewer where there is an answer already.
  static constexpr int kMostFollowingSteps = 800, kFewFollowingSteps = 100;
  [[nodiscard]] Followed followed_by(
      std::optional<FittedPath> path,
      const std::function<Stage(double share)>& stage_at, WaySteps steps) {
    return follow(std::move(path), stage_at, steps, kArcDegree,
                  mesh_ ? kFewFollowingSteps : kMostFollowingSteps, arcs_,
                  protocol_);
  }

  /// How far follow_from_loosest() came.
  [[nodiscard]] std::string followed() const {
    if (!(reached_ > 0.0)) return {};
    std::string where;
    for (const PathInequality& limit : tightening_->relaxation().at(reached_)) {
      if (limit.kind != PathInequality::Kind::FrictionForward) continue;
      where = fmt::format(", to friction {:.3g}", limit.number);
    }
    return fmt::format(
        ". From limits that the free path keeps it was followed {:.3g} of the "
        "way to these{}; not further",
        reached_, where);
  }

  /// From the loosest limits.
  [[nodiscard]] std::optional<FittedPath> follow_from_loosest() {
    const LimitRelaxation& relaxation = tightening_->relaxation();
    tries("from limits that the free path keeps");
    if (!tightening_->solve_loosest()) return std::nullopt;
    const LimitedCurve loosest = tightening_->last();
    Followed way = followed_by(
        arcs_.fit_corrected(
            loosest,
            {relaxation.at(0.0), arcs_of(loosest), loosest.problem().ends()},
            kArcDegree),
        [&](double share) { return Stage{relaxation.at(share)}; },
        {.first = 0.05});
    reached_ = way.share;
    if (!way.arrived()) {
      return way.path ? from_nearby(*way.path) : std::nullopt;
    }
    return std::move(way.path);
  }

  // ---- On a mesh that knows no arcs; arcs are read off where it is finest.

  [[nodiscard]] std::optional<FittedPath> from_mesh() {
    tried_mesh_ = true;
    if (!tightening_->tight() || wanted_.fixed()) return {};
    tries("on meshes that know no arcs");
    FromMesh found = without_its_arcs(
        *tightening_->tight(), wanted_, [&] { return left(); }, arcs_,
        protocol_);
    mesh_ = std::move(found.mesh);
    return std::move(found.path);
  }
  void take_mesh() {
    answer_.emplace(answer_without_arcs(*mesh_, protocol_));
    loosened_.clear();
  }

  // ---- From limits that ask for less, each step an answer to them.

  void come_from_looser() {
    tries("from looser limits");
    double share = 0.25;  // of the work, for each of them
    for (const double by : {0.05, 0.2, 0.6, 1.0}) {
      auto path = path_under(by, &Tightening::tighten, share);
      share /= 1.0 - share;
      if (path) return tighten(*std::move(path));
      if (stopped()) return;
    }
  }

  /// With the iterations that are left.
  [[nodiscard]] IpoptOptions left() const {
    IpoptOptions ipopt = options_.ipopt;
    for (const MeshRecord& mesh : protocol_.meshes) {
      ipopt.max_iterations -= mesh.iterations;
    }
    ipopt.max_iterations =
        std::max(0, ipopt.max_iterations - protocol_.record.iterations);
    return ipopt;
  }
  /// With those too.
  /// \param tighten  from some start
  [[nodiscard]] std::optional<LoosenedPath> path_under(
      double by, const std::function<bool(Tightening&)>& tighten,
      double share = 0.5) {
    const PhaseTimer timer(Phase::Start);
    MeshOptions options = options_;
    options.ipopt = left();
    if (options.ipopt.max_iterations <= 0) return std::nullopt;
    const Scene looser = loosened(scene_, by);
    LimitedSolve solve(looser, wanted_, *free_, phi_, options);
    solve.protocol_.most_work = share * (protocol_.most_work - protocol_.work);
    std::optional<FittedPath> path;
    if (by > 0.0 && solve.tightening_->is_shut()) return std::nullopt;
    if (tighten(*solve.tightening_)) path = solve.read_off();
    if (!path && !solve.ended()) path = solve.from_mesh();
    RefinementProtocol done = std::move(solve.protocol_).finished();
    std::ranges::move(done.meshes, std::back_inserter(protocol_.meshes));
    protocol_.log += done.log;
    protocol_.work += solve.protocol_.work;
    if (path) return LoosenedPath{{*std::move(path), {}}, by};
    if (!solve.mesh_) return std::nullopt;
    return LoosenedPath{{solve.mesh_->path, solve.mesh_->estimated_error}, by};
  }

  /// To the limits of the scene, or else the tightest are kept, with the reason
  /// of the first attempt. Where arcs cannot be followed further the program is
  /// solved from there, under those limits or others half-way to them, until
  /// what is left of the way is nothing that anyone would ask for.
  void tighten(LoosenedPath path) {
    constexpr double kShortest = 0.1, kNothing = 1e-3;
    const Status status = protocol_.status;
    const std::string message = protocol_.message;
    loosened_.push_back(std::move(path));
    follow_tighter();
    for (double leap = 1.0; leap > kShortest && !stopped();) {
      const LoosenedPath reached = loosened_.back();
      if (reached.by == 0.0) take(reached);
      if (reached.by < kNothing || status == Status::NoSmoothContact) break;
      const double next = reached.by * (1.0 - leap);
      auto there = path_under(next, [&](Tightening& tightening) {
        return tightening.tighten_from(reached.path.curve);
      });
      if (!there && next > 0.0) there = path_under(next, &Tightening::tighten);
      if (there) {
        loosened_.push_back(*std::move(there));
        follow_tighter();
      } else {
        leap *= 0.5;
      }
    }
    if (answer_) return loosened_.clear();
    protocol_.fail(status, message);
  }
  /// What was found under the limits asked for.
  void take(const LoosenedPath& asked) {
    if (asked.knows_arcs()) {
      refine(asked.path);
    } else {
      answer_ =
          answer_without_arcs({asked.path, *asked.estimated_error}, protocol_);
    }
  }
  void follow_tighter() {
    const LoosenedPath from = loosened_.back();
    if (!from.knows_arcs()) return;
    const auto left = [&](double share) { return from.by * (1.0 - share); };
    const auto stage_at = [&](double share) {
      const Scene scene = loosened(scene_, left(share));
      return Stage{inequalities(scene.body, scene.limits), scene};
    };
    Followed way = followed_by(
        from.path, stage_at, {.first = 0.5, .largest = 1.0, .smallest = 0.01});
    if (way.share > 0.0) {
      loosened_.push_back({{*std::move(way.path), {}}, left(way.share)});
    }
  }

  const Scene& scene_;
  Discretisation wanted_;
  std::vector<PathInequality> limits_;
  MeshOptions options_;
  PassProtocol protocol_;
  ArcSearch arcs_{protocol_, options_};
  const ExtremalCurve* free_ = nullptr;  ///< where it starts from
  double phi_ = 0.0;
  std::optional<Tightening> tightening_;
  std::optional<LimitedAnswer> answer_;
  std::vector<LoosenedPath> loosened_;
  bool tried_mesh_ = false;
  std::vector<std::string> tried_;  ///< in words, each once
  std::optional<PathWithoutArcs> mesh_;
  double reached_ = 0.0;  ///< share of the way from the loosest limits
};

}  // namespace

LimitedRefinement refine_limited(const Scene& scene,
                                 const Discretisation& wanted,
                                 const ExtremalCurve& free, double phi,
                                 MeshOptions options) {
  return LimitedSolve(scene, wanted, free, phi, options).run();
}

std::optional<LimitedRefinement> refine_limited_beside(
    const Scene& scene, const Discretisation& wanted,
    const FittedPath& neighbour, MeshOptions options, double most_work) {
  if (!bounds_differ_alone(neighbour.curve.problem().limits(),
                           inequalities(scene.body, scene.limits))) {
    return std::nullopt;
  }
  return LimitedSolve(scene, wanted, options).run_beside(neighbour, most_work);
}

}  // namespace brachisto
