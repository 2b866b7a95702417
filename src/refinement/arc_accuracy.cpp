// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/arc_accuracy.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "brachisto/math/index.hpp"
#include "refinement/arc_elements.hpp"
#include "refinement/mesh_choice.hpp"

namespace brachisto {

namespace {

constexpr double kRounding = 1e-13;
constexpr const char* kSolvedOverArcs = "solved under limits";
constexpr int kManyElements = 2000;

LimitedAnswer told(FittedPath path, double error, PassProtocol& protocol) {
  error += path.curve.misled_from_rest().cost;
  protocol.record.estimated_error = error;
  protocol.keep_record("arcs", path.curve.transit_time());
  protocol.status = Status::Solved;
  protocol.message = kSolvedOverArcs;
  return {std::move(path), error};
}

/// By how much the time along one path is off that along another, relative.
double change(const FittedPath& path, const FittedPath& other) {
  return std::abs(other.curve.transit_time() / path.curve.transit_time() - 1.0);
}

/// Whether a limit is held along an element that exceeds it.
bool holds(const LimitedCurve& curve, const ExcessAt& excess) {
  const auto& held = curve.problem().held();
  return held && held->in_element[at(excess.element)][at(excess.limit)] !=
                     nlp::Held::No;
}

/// Leads paths back within limits that they exceed between points.
class WithinLimits {
 public:
  explicit WithinLimits(ArcSearch& search) : search_(search) {}

  /// On shorter elements, if polynomials exceed limits, or with more arcs, if
  /// the path does. Nothing if it was not found on shorter ones and exceeds
  /// limits by more than is allowed of a path.
  [[nodiscard]] std::optional<FittedPath> lead(FittedPath path, int degree) {
    constexpr int kMostMeshes = 7;
    constexpr double kFallsAtAll = 0.7;
    std::optional<double> before;  // exceeded on longer elements
    for (int i = 0; i < kMostMeshes && !as_close_as_found_; ++i) {
      const ExcessAt worst = path.curve.largest_excess();
      const double now = worst.value;
      if (now <= allowed_ || !std::isfinite(now) ||
          path.curve.problem().mesh().num_elements() > kManyElements) {
        break;
      }
      if (before && is_of_path(path.curve, worst, *before)) {
        allowed_ = exceeded_ = kAllowedOfPath;
        if (now <= allowed_) break;
        auto held = fitted(path, path.arcs, degree);
        corrections_ = held ? corrections_ - 1 : 0;
        // Elements are as long as before where no arc was found.
        before = held ? std::optional(now) : std::nullopt;
        if (held) path = *std::move(held);
        continue;
      }
      as_close_as_found_ =
          corrections_ == 0 && before && now > kFallsAtAll * *before;
      std::vector<Arc> arcs = path.arcs;
      if (as_close_as_found_ ||
          !divide_for_limits(path.curve, allowed_, arcs)) {
        break;
      }
      auto shorter = fitted(path, std::move(arcs), degree);
      if (!shorter) {
        if (now > kAllowedOfPath) return std::nullopt;
        as_close_as_found_ = true;
        break;
      }
      before = now;
      path = *std::move(shorter);
    }
    return path;
  }
  /// Or nothing closer is to be found: then the certificate judges.
  [[nodiscard]] bool keeps(const FittedPath& path) const {
    return as_close_as_found_ || path.curve.largest_excess().value <= allowed_;
  }
  /// What divisions may leave.
  [[nodiscard]] double allowed() const {
    return as_close_as_found_ ? std::numeric_limits<double>::infinity()
                              : allowed_;
  }
  /// From where on a limit is held by another arc.
  [[nodiscard]] double exceeded() const { return exceeded_; }

 private:
  /// Whether an excess is the path's own, to be held by an arc. That of
  /// polynomials falls by far more, except next to rest; of a limit that holds
  /// already all is theirs. Corrections see what is larger.
  ///
  /// \param before  on longer elements
  [[nodiscard]] bool is_of_path(const LimitedCurve& curve,
                                const ExcessAt& worst, double before) const {
    constexpr double kFalls = 0.25, kLargest = 10.0 * kExceeded;
    return worst.value > kFalls * before && worst.value <= kLargest &&
           corrections_ > 0 && !holds(curve, worst);
  }
  [[nodiscard]] std::optional<FittedPath> fitted(const FittedPath& from,
                                                 std::vector<Arc> arcs,
                                                 int degree) {
    return search_.fit_corrected(
        from.curve, {from.curve.problem().limits(), std::move(arcs), from.ends},
        degree, exceeded_);
  }

  ArcSearch& search_;
  double allowed_ = kAllowedExcess, exceeded_ = kExceeded;
  int corrections_ = 2;  ///< left to hold what the path exceeds
  bool as_close_as_found_ = false;
};

}  // namespace

std::optional<LimitedAnswer> on_fixed_mesh(const FittedPath& path, int p,
                                           const Discretisation& wanted,
                                           ArcSearch& search,
                                           PassProtocol& protocol) {
  const int elements =
      wanted.elements ? *wanted.elements : (*wanted.nodes - 1) / p;
  const std::vector<PathInequality>& limits = path.curve.problem().limits();
  constexpr int kTimesCoarser = 16;
  const Mesh& coarse = path.curve.problem().mesh();
  std::optional<LimitedAnswer> judge;
  if (elements >= kTimesCoarser * coarse.num_elements()) {
    Discretisation accurate;
    accurate.tolerance = largest_error_of_a_judge(wanted.wanted_tolerance());
    judge = refine_arcs(path, coarse.degree, accurate, search, protocol);
    if (judge &&
        (*judge->estimated_error > *accurate.tolerance ||
         !(judge->path.curve.largest_excess().value <= kAllowedOfPath) ||
         judge->path.curve.problem().mesh().num_elements() >= elements)) {
      judge.reset();
    }
  }
  const FittedPath& from = judge ? judge->path : path;
  std::optional<FittedPath> found =
      search
          .fit(from.curve,
               {limits, with_elements(from.arcs, elements), from.ends}, p)
          .path;
  if (!found || !judge) {
    return refine_arcs(std::move(found), p, wanted, search, protocol);
  }
  const double error = *judge->estimated_error + change(*found, judge->path) +
                       found->error_of_conditions() + kRounding;
  LimitedAnswer answer = told(*std::move(found), error, protocol);
  answer.judged_by = judge->path.curve.problem().mesh().num_elements();
  return answer;
}

std::optional<LimitedAnswer> refine_arcs(std::optional<FittedPath> path, int p,
                                         const Discretisation& wanted,
                                         ArcSearch& search,
                                         PassProtocol& protocol) {
  constexpr int kMostMeshes = 8;
  if (!path) return std::nullopt;
  const std::vector<PathInequality> limits = path->curve.problem().limits();
  const double tolerance = wanted.wanted_tolerance();
  std::optional<LimitedAnswer> answer;
  bool accurate = false;  // in time
  WithinLimits within(search);
  for (int i = 0; path && i < kMostMeshes; ++i) {
    if (!wanted.fixed() && i + 1 < kMostMeshes) {
      path = within.lead(*std::move(path), p);
      if (!path) break;
    }
    const ArcFit finer =
        search.fit(path->curve, {limits, path->arcs, path->ends}, p + 1);
    if (!finer.path) break;
    // The difference is T's error less that of the finer one, of either sign.
    const double error = 2.0 * change(*path, *finer.path) +
                         path->error_of_conditions() + kRounding;
    const bool good = error <= tolerance && within.keeps(*path);
    if (accurate && !good) break;
    accurate = good;
    answer.emplace(told(*path, error, protocol));
    if (wanted.fixed() ||
        (good && slopes_agree(path->curve, finer.path->curve, tolerance)) ||
        path->curve.problem().mesh().num_elements() > kManyElements) {
      return answer;
    }
    std::vector<Arc> arcs = finer.path->arcs;
    if (!divide(path->curve, finer.path->curve, 0.3 * tolerance,
                within.allowed(), arcs)) {
      break;
    }
    path = search.fit_corrected(finer.path->curve,
                                {limits, std::move(arcs), finer.path->ends}, p,
                                within.exceeded());
  }
  if (accurate) {  // only its slopes could be better
    protocol.status = Status::Solved;
    protocol.message = kSolvedOverArcs;
  }
  return answer;
}

}  // namespace brachisto
