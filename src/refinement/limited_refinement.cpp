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
#include "refinement/cold_paths.hpp"
#include "refinement/limited_ways.hpp"
#include "refinement/surface_passages.hpp"
#include "refinement/tightening.hpp"

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
    ways_.emplace(scene_, wanted_, free, phi, options_, protocol_);
  }
  /// Beside a path of another scene.
  LimitedSolve(const Scene& scene, const Discretisation& wanted,
               const MeshOptions& options)
      : scene_(scene),
        wanted_(wanted),
        limits_(inequalities(scene.body, scene.limits)),
        options_(options),
        most_work_(most_search_work(options)),
        protocol_(options) {}

  LimitedRefinement run(Tightening::Care care) {
    protocol_.most_work = kSearchAsAsked * most_work_;
    if (care == Tightening::Care::Rough) refine(ways_->find_at_once());
    rough_ = answer_.has_value();
    if (!rough_ && !protocol_.stop.met()) {
      protocol_.message.clear();
      protocol_.most_work = protocol_.work + kSearchAsAsked * most_work_;
      refine(ways_->find_with_care());
    }
    if (!answer_ && !ways_->ended()) refine(ways_->from_mesh());
    if (answer_ || protocol_.status == Status::NoFastestTrack ||
        protocol_.stop.met()) {
      return finished();
    }
    if (!ways_->mesh()) {
      if (protocol_.worked_enough()) {
        protocol_.tries("until its share of work was used up");
        // That of an empty set takes all of it; the proof takes none.
        if (protocol_.status != Status::NoAdmissiblePath) {
          ways_->tightening().is_shut();
        }
      }
      if (protocol_.status != Status::NoAdmissiblePath) come_from_random();
      if (!answer_ && ways_->mesh_wants_work()) go_on_without_arcs();
    }
    if (protocol_.status == Status::NoFastestTrack) return finished();
    if (!answer_ && ways_->mesh()) {
      answer_ = answer_without_arcs(*ways_->mesh(), protocol_);
    }
    if (!answer_) {
      protocol_.most_work = protocol_.work + kSearchLooser * most_work_;
      come_from_looser();
    }
    return finished();
  }
  LimitedRefinement run_cold() {
    come_from_random();
    return finished();
  }
  LimitedRefinement run_beside(const FittedPath& neighbour,
                               std::optional<double> most_work) {
    protocol_.most_work = most_work.value_or(most_work_);
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
    if (!answer_ && ways_ && protocol_.status != Status::NoSmoothContact) {
      blocking = ways_->tightening().blocking();
    }
    if (protocol_.status != Status::Solved && passes_surface()) {
      protocol_.message += fmt::format(
          ". It passes {}, where the field has a kink, and under limits a path "
          "is followed on one side alone",
          field_kind(scene_.world)->surface);
    }
    const double work = protocol_.work;
    if (cut_short_ || protocol_.worked_enough()) {
      protocol_.tries(fmt::format(
          "until all the work of a search was used up (more is allowed by "
          "solver.limits.iterations above {})",
          Limits{}.iterations));
    }
    std::vector<std::string> tried = std::move(protocol_.tried);
    return {std::move(protocol_).finished(),
            std::move(answer_),
            std::move(blocking),
            std::move(loosened_),
            work,
            std::move(tried),
            from_random_,
            rough_};
  }

  /// Whether the best path that was found does.
  [[nodiscard]] bool passes_surface() const {
    const LimitedCurve* curve = answer_ ? &answer_->path.curve
                                : ways_ ? ways_->tightening().any()
                                        : nullptr;
    return curve != nullptr && !surface_passages(*curve).empty();
  }

  /// On finer meshes, with work of its own: a path keeps the limits on the
  /// coarse one.
  void go_on_without_arcs() {
    const Status status = protocol_.status;
    const std::string message = protocol_.message;
    // Looser limits need iterations too.
    const PassProtocol::Share part(protocol_, 0.5);
    protocol_.most_work = protocol_.work + kSearchOnMesh * most_work_;
    refine(ways_->from_mesh_again());
    if (answer_ || protocol_.status == Status::NoFastestTrack) return;
    protocol_.fail(status, message);
  }
  /// Under the limits asked for, from paths that owe nothing to the free one.
  void come_from_random() {
    constexpr int kStarts = 6;
    if (protocol_.left(options_.ipopt).max_iterations == 0) return;
    protocol_.tries("from random paths");
    const Status status = protocol_.status;
    const std::string message = protocol_.message;
    // Looser limits need iterations too.
    const PassProtocol::Share part(protocol_, 1.0 / 3.0);
    // An empty set takes no more than the starts.
    protocol_.most_work = protocol_.work + kSearchCold * most_work_;
    const std::vector<LimitedCurve> found =
        cold_paths(scene_, *free_, phi_, options_.ipopt, kStarts,
                   kSearchCold / kStarts * most_work_, protocol_);
    protocol_.most_work = protocol_.work + kSearchFromCold * most_work_;
    for (const LimitedCurve& curve : found) {
      if (stopped()) break;
      const auto path = path_under(
          0.0, [&](LimitedWays& ways) { return ways.from_tight(curve); });
      if (path) take(*path);
      if (!answer_) continue;
      from_random_ = true;
      return;
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
  [[nodiscard]] bool stopped() const { return protocol_.stopped(); }
  [[nodiscard]] Followed followed_by(
      std::optional<FittedPath> path,
      const std::function<Stage(double share)>& stage_at, WaySteps steps) {
    return follow(std::move(path), stage_at, steps, kArcDegree,
                  kMostFollowingSteps, arcs_, protocol_);
  }

  // ---- From limits that ask for less, each step an answer to them.

  /// Share of the work left that one attempt may take, to find a path under
  /// some of them or to follow one.
  static constexpr double kOfALeap = 0.15;

  void come_from_looser() {
    protocol_.tries("from looser limits");
    const Status status = protocol_.status;
    const std::string message = protocol_.message;
    (ways_->tightening().is_shut() ? shut_to_ : open_from_) = 0.0;
    // That there is no direction at rest says more.
    if (status == Status::NoAdmissiblePath) protocol_.fail(status, message);
    // The loosest first: where there is a path it is mostly found soon; limits
    // under which there is none use up all they are given.
    for (const double by : {1.0, 0.6, 0.2, 0.05}) {
      auto path = path_under(by, &LimitedWays::find, kOfALeap);
      if (path) return tighten(*std::move(path));
      if (by <= shut_to_ || stopped()) return;
    }
  }

  /// Whether the way is known to be shut under limits that are looser by so
  /// much: under tighter ones it is then too. Where the proof says nothing it
  /// is not asked again for looser ones, of which it would mostly say nothing
  /// too.
  [[nodiscard]] bool known_to_be_shut(double by, Tightening& under_them) {
    if (by >= open_from_ || by <= shut_to_) return by <= shut_to_;
    const bool shut = under_them.is_shut();
    (shut ? shut_to_ : open_from_) = by;
    return shut;
  }

  /// With a share of the work that is left, and all iterations.
  /// \param find  by some of the ways
  [[nodiscard]] std::optional<LoosenedPath> path_under(
      double by,
      const std::function<std::optional<FittedPath>(LimitedWays&)>& find,
      double share = 0.5) {
    const PhaseTimer timer(Phase::Start);
    MeshOptions options = options_;
    options.ipopt = protocol_.left(options.ipopt);
    if (options.ipopt.max_iterations <= 0) return std::nullopt;
    const Scene looser = loosened(scene_, by);
    PassProtocol protocol(options);
    protocol.most_work = share * (protocol_.most_work - protocol_.work);
    LimitedWays ways(looser, wanted_, *free_, phi_, options, protocol);
    // Limits as they are asked for are looked at where looser ones come next.
    if ((by > 0.0 || shut_to_ >= 0.0) &&
        known_to_be_shut(by, ways.tightening())) {
      return std::nullopt;
    }
    std::optional<FittedPath> path = find(ways);
    protocol_.work += protocol.work;
    cut_short_ = cut_short_ || protocol.worked_enough();
    RefinementProtocol done = std::move(protocol).finished();
    std::ranges::move(done.meshes, std::back_inserter(protocol_.meshes));
    protocol_.log += done.log;
    if (path) return LoosenedPath{{*std::move(path), {}}, by};
    if (!ways.mesh()) return std::nullopt;
    return LoosenedPath{{ways.mesh()->path, ways.mesh()->estimated_error}, by};
  }

  /// To the limits of the scene, or else the tightest are kept, with the reason
  /// of the first attempt. Where arcs cannot be followed further the program is
  /// solved from there, under limits half of the way to those, or less where
  /// that fails, until what is left of it is nothing that anyone would ask for.
  void tighten(LoosenedPath path) {
    constexpr double kLongest = 0.5, kShortest = 0.05;
    constexpr double kNear = 0.02, kNothing = 1e-3;
    const Status status = protocol_.status;
    const std::string message = protocol_.message;
    loosened_.push_back(std::move(path));
    follow_tighter();
    double asked_below = kNear;  // the limits asked for are tried, twice
    for (double leap = kLongest; leap > kShortest;) {
      const LoosenedPath reached = loosened_.back();
      const bool there =
          reached.by == 0.0 || (reached.by < kNothing && asked_below == 0.0);
      if (there || stopped() || status == Status::NoSmoothContact) break;
      double next = reached.by * (1.0 - leap);
      if (next < asked_below) {
        next = 0.0;
        asked_below = asked_below > kNothing ? kNothing : 0.0;
      }
      auto found = path_under(
          next,
          [&](LimitedWays& ways) {
            return ways.from_beside(reached.path.curve);
          },
          kOfALeap);
      if (!found && next > std::max(0.0, shut_to_) && !stopped()) {
        found = path_under(next, &LimitedWays::find, kOfALeap);
      }
      if (found) {
        loosened_.push_back(*std::move(found));
        follow_tighter();
      } else {
        leap *= 0.5;
      }
    }
    if (status != Status::NoSmoothContact &&
        status != Status::NoAdmissiblePath) {
      come_nearer();
    }
    if (loosened_.back().by == 0.0) take(loosened_.back());
    if (answer_) return loosened_.clear();
    protocol_.fail(status, message);
  }
  /// Where nothing that begins with the free path leads on, a path that owes it
  /// nothing may: with work of its own.
  void come_nearer() {
    constexpr double kLeaps[] = {0.3, 0.1};
    constexpr double kNothing = 1e-3, kOfEach = 0.2;
    if (loosened_.back().by < kNothing) return;
    protocol_.tries("from random paths under looser limits");
    protocol_.most_work = protocol_.work + kSearchNearer * most_work_;
    for (const double leap : kLeaps) {
      while (!stopped() && loosened_.back().by >= kNothing) {
        const double next = loosened_.back().by * (1.0 - leap);
        if (next <= shut_to_) break;
        auto found = path_under(next, &LimitedWays::from_random, kOfEach);
        if (!found) break;
        loosened_.push_back(*std::move(found));
        follow_tighter();
      }
    }
  }
  /// What was found under the limits asked for.
  void take(const LoosenedPath& asked) {
    if (asked.knows_arcs()) return refine(asked.path);
    answer_ =
        answer_without_arcs({asked.path, *asked.estimated_error}, protocol_);
  }
  void follow_tighter() {
    const LoosenedPath from = loosened_.back();
    if (from.by == 0.0 || !from.knows_arcs()) return;
    const PassProtocol::Share part(protocol_, kOfALeap);
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
  double most_work_;  ///< most_search_work()
  PassProtocol protocol_;
  ArcSearch arcs_{protocol_, options_};
  const ExtremalCurve* free_ = nullptr;  ///< where it starts from
  double phi_ = 0.0;
  std::optional<LimitedWays> ways_;
  std::optional<LimitedAnswer> answer_;
  std::vector<LoosenedPath> loosened_;
  bool from_random_ = false, rough_ = false;
  /// By how much looser limits are under which the way is known to be shut, and
  /// from where on it is not.
  double shut_to_ = -std::numeric_limits<double>::infinity();
  double open_from_ = std::numeric_limits<double>::infinity();
  bool cut_short_ = false;  ///< some attempt, for want of work
};

}  // namespace

LimitedRefinement refine_limited(const Scene& scene,
                                 const Discretisation& wanted,
                                 const ExtremalCurve& free, double phi,
                                 MeshOptions options, Tightening::Care care) {
  return LimitedSolve(scene, wanted, free, phi, options).run(care);
}

LimitedRefinement refine_limited_cold(const Scene& scene,
                                      const Discretisation& wanted,
                                      const ExtremalCurve& elsewhere,
                                      double phi, MeshOptions options) {
  return LimitedSolve(scene, wanted, elsewhere, phi, options).run_cold();
}

std::optional<LimitedRefinement> refine_limited_beside(
    const Scene& scene, const Discretisation& wanted,
    const FittedPath& neighbour, MeshOptions options,
    std::optional<double> most_work) {
  if (!bounds_differ_alone(neighbour.curve.problem().limits(),
                           inequalities(scene.body, scene.limits))) {
    return std::nullopt;
  }
  return LimitedSolve(scene, wanted, options).run_beside(neighbour, most_work);
}

}  // namespace brachisto
