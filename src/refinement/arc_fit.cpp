// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/arc_fit.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "brachisto/solvers/newton_kkt.hpp"
#include "math/index.hpp"

namespace brachisto {

namespace {

/// An arc's share of σ.
double length_of(const std::vector<Arc>& arcs, std::size_t i) {
  return arcs[i].end - (i == 0 ? 0.0 : arcs[i - 1].end);
}

class Fit {
 public:
  Fit(const LimitedCurve& nearby, PathSetting setting, int degree,
      const MeshOptions& options, Eigen::MatrixXd inverse)
      : scene_(nearby.problem().scene()),
        limits_(std::move(setting.limits)),
        degree_(degree),
        options_(options),
        seeks_end_(end_is_sought(scene_)),
        seeks_start_(start_is_sought(scene_, limits_)),
        arcs_(std::move(setting.arcs)),
        ends_(setting.ends),
        nearby_(&nearby),
        inverse_(std::move(inverse)) {}

  ArcFit run() {
    while (true) {
      const Outcome outcome = iterate();
      if (outcome == Outcome::Vanished) continue;
      if (outcome == Outcome::Found) {
        out_.path.emplace(FittedPath{arcs_, ends_, *curve_,
                                     mismatch_of(*curve_, ends_), inverse_});
      }
      return std::move(out_);
    }
  }

 private:
  enum class Outcome { Found, Failed, Vanished };
  using Vector = Eigen::VectorXd;

  [[nodiscard]] Eigen::Index num_junctions() const {
    return static_cast<Eigen::Index>(arcs_.size()) - 1;
  }

  Outcome fail(std::string message) {
    out_.message = std::move(message);
    return Outcome::Failed;
  }

  /// The optimality conditions of arcs and ends as they are.
  bool solve(const std::vector<Arc>& arcs, const LimitedEnds& ends) {
    LimitedTime problem(scene_, limits_, mesh_of(arcs, degree_), ends,
                        held_limits(arcs));
    const bool same =
        curve_ && curve_->problem().num_variables() == problem.num_variables();
    NewtonOptions newton;
    newton.tolerance = kResidual;
    newton.max_iterations = 25;
    newton.max_halvings = 6;
    // Short elements weigh a residual little, and certificates go by weights.
    newton.to_rounding = true;
    newton.chain_alone = true;
    newton.stop = options_.ipopt.stop;
    PrimalDual start = same ? curve_->point() : prolong(*nearby_, problem);
    NewtonResult result =
        solve_with_newton(problem, nullptr, start, 0.0, newton);
    ++out_.passes;
    out_.newton_steps += result.iterations;
    if (result.status != Status::Solved) return false;
    if (!problem.set_point(result.point.x)) return false;
    curve_.emplace(problem, std::move(result.point));
    return true;
  }

  /// Moves junctions and ends; by less where an arc would shrink too fast.
  double move(const Vector& step, std::vector<Arc>& arcs,
              LimitedEnds& ends) const {
    constexpr double kShare = 0.6, kLongest = 0.1;
    double by = 1.0;
    const Eigen::Index m = num_junctions();
    for (Eigen::Index i = 0; i < m; ++i) {
      const auto a = static_cast<std::size_t>(i);
      const double room =
          step[i] > 0.0 ? length_of(arcs_, a + 1) : length_of(arcs_, a);
      by = std::min(by, kShare * room / (std::abs(step[i]) + 1e-300));
    }
    for (Eigen::Index i = m; i < step.size(); ++i) {
      by = std::min(by, kLongest / (std::abs(step[i]) + 1e-300));
    }
    for (Eigen::Index i = 0; i < m; ++i) {
      arcs[static_cast<std::size_t>(i)].end += by * step[i];
    }
    if (seeks_end_) ends.phi += by * step[m];
    if (seeks_start_) *ends.start += by * step[step.size() - 1];
    return by;
  }

  Outcome iterate() {
    constexpr int kMostSteps = 40, kFreshFor = 8;
    constexpr double kShortest = 1e-3;
    constexpr double kClosed = 1e-10, kRounding = 1e-13;
    if (!solve(arcs_, ends_)) {
      return fail("the optimality conditions of the arcs have no solution");
    }
    Vector now = open_conditions(*curve_, arcs_, ends_);
    int broyden = 0;  // steps since the Jacobian was computed
    double shorten = 1.0;
    double before = std::numeric_limits<double>::infinity();
    for (int i = 0; i < kMostSteps && now.size() > 0; ++i) {
      // The norm below would pass over what is not a number.
      if (!now.allFinite()) return fail("a junction has no slope");
      const double norm = now.lpNorm<Eigen::Infinity>();
      if (norm <= kRounding || (norm <= kClosed && norm > 0.5 * before)) {
        return Outcome::Found;
      }
      before = norm;
      if (drop_vanishing()) return Outcome::Vanished;
      if (inverse_.size() == 0 || broyden > kFreshFor) {
        const PathResponse response(*curve_, {limits_, arcs_, ends_});
        if (!response.regular()) return fail("the arcs are not determined");
        inverse_ = jacobian_of(response.to_unknowns()).inverse();
        if (!inverse_.allFinite())
          return fail("the junctions are not determined");
        broyden = 0;
      }
      std::vector<Arc> arcs = arcs_;
      LimitedEnds ends = ends_;
      const Vector wanted = -shorten * (inverse_ * now);
      const double by = move(wanted, arcs, ends);
      if (!solve(arcs, ends)) {
        shorten *= 0.3;
        if (shorten < kShortest) return fail("junctions cannot be moved");
        continue;
      }
      shorten = std::min(1.0, 3.0 * shorten);
      arcs_ = std::move(arcs);
      ends_ = ends;
      const Vector next = open_conditions(*curve_, arcs_, ends_);
      ++broyden;
      if (next.norm() > 0.3 * now.norm()) broyden = kFreshFor + 1;
      const Vector s = by * wanted;
      const Vector y = next - now;
      const Vector By = inverse_ * y;
      const double scale = s.dot(By);
      if (std::abs(scale) > 1e-3 * s.squaredNorm()) {
        inverse_ += (s - By) * (s.transpose() * inverse_) / scale;
      }
      now = next;
    }
    if (now.size() == 0) return Outcome::Found;
    return fail(
        fmt::format("junctions and contacts were not found: {:.1e} "
                    "is left",
                    now.lpNorm<Eigen::Infinity>()));
  }

  /// Leaves out an arc of no length.
  bool drop_vanishing() {
    constexpr double kNone = 1e-6;
    for (std::size_t i = 0; i < arcs_.size(); ++i) {
      if (arcs_.size() == 1 || length_of(arcs_, i) > kNone) continue;
      if (i > 0) arcs_[i - 1].end = arcs_[i].end;
      arcs_.erase(arcs_.begin() + static_cast<std::ptrdiff_t>(i));
      for (std::size_t k = 1; k < arcs_.size();) {
        if (arcs_[k - 1].held == arcs_[k].held) {
          arcs_[k - 1].end = arcs_[k].end;
          arcs_[k - 1].cuts =
              equal_cuts(arcs_[k - 1].elements() + arcs_[k].elements());
          arcs_.erase(arcs_.begin() + static_cast<std::ptrdiff_t>(k));
        } else {
          ++k;
        }
      }
      kept_.emplace(*curve_);
      nearby_ = &*kept_;
      curve_.reset();
      inverse_.resize(0, 0);
      return true;
    }
    return false;
  }

  const Scene& scene_;
  std::vector<PathInequality> limits_;
  int degree_;
  const MeshOptions& options_;
  bool seeks_end_, seeks_start_;
  std::vector<Arc> arcs_;
  LimitedEnds ends_;
  const LimitedCurve* nearby_;
  Eigen::MatrixXd inverse_;  ///< of the open conditions' Jacobian
  std::optional<LimitedCurve> kept_, curve_;
  ArcFit out_;

  static constexpr double kResidual = 1e-11;
};

}  // namespace

ArcFit fit_arcs(const LimitedCurve& nearby, PathSetting setting, int degree,
                const MeshOptions& options, const FittedPath* before) {
  const auto same = [](const Arc& a, const Arc& b) { return a.held == b.held; };
  Eigen::MatrixXd inverse;
  if (before != nullptr &&
      std::ranges::equal(before->arcs, setting.arcs, same)) {
    inverse = before->inverse;
  }
  return Fit(nearby, std::move(setting), degree, options, std::move(inverse))
      .run();
}

}  // namespace brachisto
