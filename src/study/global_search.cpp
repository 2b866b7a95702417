// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/study/global_search.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "brachisto/solvers/ipopt.hpp"
#include "brachisto/solvers/newton_kkt.hpp"
#include "brachisto/transcription/contact_equation.hpp"
#include "brachisto/transcription/initial_guess.hpp"
#include "brachisto/transcription/prolongation.hpp"

namespace brachisto {

namespace {

constexpr double kLargestPhi = 1.5;  // [rad]; steeper ends are left out
constexpr double kStep = 0.05;       // of a family over φ [rad]
constexpr int kColdStarts = 13;
constexpr int kColdIterations = 150;
// Two extremals are the same if φ and T agree to this.
constexpr double kSame = 1e-5;

/// An extremal between fixed end points.
struct Member {
  double phi;
  double mismatch;  // β_end − φ
  PrimalDual point;
  double T;
};

class Search {
 public:
  Search(const Scene& scene, const Mesh& mesh,
         std::vector<ContactCandidate> known, const StopCondition& stop)
      : problem_(scene, mesh, 0.0), found_(std::move(known)), stop_(stop) {}

  /// Follows the family of `start` in both directions.
  void follow(const Member& start) {
    if (seen(start)) return;
    for (const double direction : {1.0, -1.0}) walk(start, direction);
  }

  [[nodiscard]] std::optional<Member> member(const PrimalDual& start,
                                             double phi) {
    problem_.set_end_angle(phi);
    NewtonOptions options;
    options.tolerance = 1e-9;
    options.max_iterations = 8;
    options.max_halvings = 1;
    options.stop = stop_;
    const NewtonResult result =
        solve_with_newton(problem_, nullptr, start, phi, options);
    if (result.status != Status::Solved) return std::nullopt;
    return describe(result.point, phi);
  }

  [[nodiscard]] std::optional<Member> cold(const PrimalDual& guess,
                                           double phi) {
    problem_.set_end_angle(phi);
    IpoptOptions options;
    options.tolerance = 1e-9;
    options.max_iterations = kColdIterations;
    options.stop = stop_;
    const SolverResult result = solve_with_ipopt(problem_, guess, options);
    if (result.status != Status::Solved) return std::nullopt;
    return describe(result.point, phi);
  }

  [[nodiscard]] RollingTime& problem() { return problem_; }
  [[nodiscard]] std::vector<ContactCandidate> take() {
    return std::move(found_);
  }

 private:
  [[nodiscard]] std::optional<Member> describe(const PrimalDual& point,
                                               double phi) const {
    const ExtremalCurve curve(problem_, point);
    const auto& w = curve.w_at_points();
    if (!std::all_of(w.begin(), w.end(), [](double v) { return v > 0.0; })) {
      return std::nullopt;
    }
    for (const double beta : curve.continuous_slope()) {
      if (!(std::abs(beta) <= std::numbers::pi)) return std::nullopt;
    }
    const double slope = curve.at(1.0).beta;
    if (!std::isfinite(slope)) return std::nullopt;
    return Member{phi, slope - phi, point, curve.transit_time()};
  }

  /// True if a family that was followed already passes through `member`.
  [[nodiscard]] bool seen(const Member& member) const {
    for (const std::vector<Member>& family : families_) {
      for (std::size_t i = 0; i + 1 < family.size(); ++i) {
        const Member& a = family[i];
        const Member& b = family[i + 1];
        const auto [low, high] = std::minmax(a.phi, b.phi);
        if (member.phi < low || member.phi > high || low == high) continue;
        const double t = (member.phi - a.phi) / (b.phi - a.phi);
        // T is smooth along a family: linear interpolation over a step errs by
        // its square.
        const double T = a.T + t * (b.T - a.T);
        const double slope = a.mismatch + t * (b.mismatch - a.mismatch);
        if (std::abs(member.T - T) <= 0.01 * T * kStep &&
            std::abs(member.mismatch - slope) <= kStep) {
          return true;
        }
      }
    }
    return false;
  }

  void walk(const Member& start, double direction) {
    families_.push_back({start});
    Member now = start;
    std::optional<Member> before;
    double step = kStep;
    while (std::abs(now.phi) <= kLargestPhi && !stop_.met()) {
      const double phi = now.phi + direction * step;
      PrimalDual predicted = now.point;
      if (before) {
        const double ratio = (phi - now.phi) / (now.phi - before->phi);
        for (std::size_t i = 0; i < predicted.x.size(); ++i) {
          predicted.x[i] += ratio * (now.point.x[i] - before->point.x[i]);
        }
        for (std::size_t i = 0; i < predicted.lambda.size(); ++i) {
          predicted.lambda[i] +=
              ratio * (now.point.lambda[i] - before->point.lambda[i]);
        }
      }
      std::optional<Member> next = member(predicted, phi);
      // A jump of the end slope means another family.
      if (!next || std::abs(next->mismatch - now.mismatch) > 8.0 * step) {
        step *= 0.5;
        if (step < kStep / 64.0) return;
        continue;
      }
      if ((next->mismatch > 0.0) != (now.mismatch > 0.0)) close(now, *next);
      families_.back().push_back(*next);
      before = std::move(now);
      now = std::move(*next);
      step = std::min(kStep, 2.0 * step);
    }
  }

  /// Closes the contact between two neighbours.
  void close(const Member& a, const Member& b) {
    const Member& start = std::abs(a.mismatch) < std::abs(b.mismatch) ? a : b;
    ContactEquation contact(problem_);
    NewtonOptions options;
    options.tolerance = 1e-10;
    options.max_iterations = 12;
    const NewtonResult result =
        solve_with_newton(problem_, &contact, start.point, start.phi, options);
    if (result.status != Status::Solved) return;
    if (std::abs(result.phi - start.phi) > 2.0 * kStep) return;
    ExtremalCurve curve(problem_, result.point);
    for (const ContactCandidate& other : found_) {
      if (std::abs(other.phi - result.phi) <= kSame &&
          std::abs(other.curve.transit_time() - curve.transit_time()) <=
              kSame * curve.transit_time()) {
        return;
      }
    }
    // The stationarity in β has a second kind of root, a maximum of 𝓗.
    if (std::abs(curve.at(1.0).beta - result.phi) > 1e-6) return;
    found_.push_back({std::move(curve), result.phi});
  }

  RollingTime problem_;
  std::vector<ContactCandidate> found_;
  std::vector<std::vector<Member>> families_;
  const StopCondition& stop_;
};

}  // namespace

std::vector<ContactCandidate> find_contacts(const Scene& scene,
                                            const CycloidArc& arc,
                                            const Mesh& mesh,
                                            std::vector<ContactCandidate> known,
                                            const StopCondition& stop) {
  const std::vector<ContactCandidate> starts = known;
  Search search(scene, mesh, std::move(known), stop);
  for (const ContactCandidate& start : starts) {
    const PrimalDual point = prolong(start.curve, search.problem());
    if (const auto member = search.member(point, start.phi)) {
      search.follow(*member);
    }
  }
  for (int i = 0; i < kColdStarts && !stop.met(); ++i) {
    const double phi = kLargestPhi * (2.0 * i / (kColdStarts - 1) - 1.0) * 0.95;
    search.problem().set_end_angle(phi);
    for (const PrimalDual& guess : {cycloid_guess(search.problem(), arc),
                                    straight_guess(search.problem())}) {
      if (const auto member = search.cold(guess, phi)) search.follow(*member);
    }
  }
  return search.take();
}

}  // namespace brachisto
