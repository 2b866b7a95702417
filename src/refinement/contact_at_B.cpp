// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The part of Tightening that holds the slope which C_B is built from at one
// value after the other.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "refinement/open_conditions.hpp"
#include "refinement/tightening.hpp"

namespace brachisto {

namespace {

/// Slopes at B that are held lie so far apart and are no steeper [rad].
constexpr double kEndStep = 0.1, kSteepest = 1.4;

}  // namespace

bool Tightening::end_is_open(double phi) const {
  const Point end = end_of_centre(scene_, phi);
  return std::ranges::all_of(limits_, [&](const PathInequality& limit) {
    return limit.bounds_control() ||
           value_of(limit, ContactForce<double>{},
                    TurningPoint<double>{end.x, end.z, 0.0, 0.0, phi, 0.0}) >=
               limit.lower;
  });
}

bool Tightening::keep_limits_elsewhere(const LimitedEnds& ends) {
  constexpr double kStep = 0.3;
  if (!end_is_sought(scene_) || end_is_open(ends.phi)) return false;
  if (!blocking_ && !tight_) blocking_ = tightest();
  last_.reset();
  for (double off = kStep; off < 2.0 * kSteepest; off += kStep) {
    for (const double phi : {ends.phi + off, ends.phi - off}) {
      if (std::abs(phi) > kSteepest || !end_is_open(phi)) continue;
      if (!has_more()) return false;
      LimitedEnds held = ends;
      held.phi = phi;
      if (keep_limits(held)) return true;
    }
  }
  return false;
}

bool Tightening::solve_held(double phi) {
  const Mesh mesh = last_->problem().mesh();
  auto ends = next_ends(limits_);
  if (!ends) return none_at_rest();
  ends->phi = phi;
  return solve_rigid(limits_, mesh, *ends);
}

Tightening::Held Tightening::held() {
  const double phi = last_->problem().ends().phi;
  return {phi, end_slope(*last_) - phi};
}

void Tightening::turn_end(
    double direction,
    const std::function<bool(const std::optional<Held>& before,
                             const Held& here)>& go_on) {
  end_held_ = true;
  std::optional<Held> before = held();
  for (double phi = before->phi + direction * kEndStep;
       std::abs(phi) < kSteepest; phi += direction * kEndStep) {
    if (!end_is_open(phi)) {
      before.reset();
      continue;
    }
    if (!solve_held(phi)) return;
    const Held here = held();
    if (!go_on(before, here)) return;
    before = here;
  }
}

bool Tightening::close_in(Held a, Held b) {
  constexpr double kClose = 1e-3, kJump = 1e-5;
  while (std::abs(a.phi - b.phi) > kJump) {
    const double phi = 0.5 * (a.phi + b.phi);
    if (!solve_held(phi)) return false;
    const Held here = held();
    if (std::abs(here.open) < kClose) return true;
    ((here.open < 0.0) == (a.open < 0.0) ? a : b) = here;
  }
  return protocol_.fail(
      Status::NoSmoothContact,
      fmt::format("no smooth contact was found under these limits: where the "
                  "slope at B passes {:.6g} rad, that of the path that keeps "
                  "the limits jumps from {:.2g} to {:.2g} rad off it",
                  a.phi, a.open, b.open));
}

bool Tightening::close_contact() {
  constexpr double kClosed = 1e-4, kLongest = 0.3;
  constexpr int kMostPasses = 8;
  if (!end_is_sought(scene_)) return true;
  end_held_ = true;
  double slope = -1.0;  // of what is open by φ
  Held before = held();
  for (int i = 0; i < kMostPasses; ++i) {
    if (std::abs(before.open) <= kClosed) return true;
    const double step = std::clamp(-before.open / slope, -kLongest, kLongest);
    if (!solve_held(before.phi + step)) return false;
    const Held here = held();
    slope = (here.open - before.open) / step;
    before = here;
  }
  return protocol_.fail(Status::NotConverged, "the contact at B stays open");
}

std::vector<LimitedCurve> Tightening::contacts_along() {
  std::vector<LimitedCurve> out;
  if (!end_is_sought(scene_)) return out;
  const LimitedCurve first = *last_;
  for (const double direction : {1.0, -1.0}) {
    last_ = first;
    turn_end(direction, [&](const auto& before, const Held& here) {
      if (before && here.beyond(*before)) {
        const LimitedCurve there = *last_;
        if (close_in(*before, here)) out.push_back(*last_);
        last_ = there;
      }
      return has_more();
    });
  }
  return out;
}

bool Tightening::bracket_contact() {
  end_held_ = true;
  last_ = tight_;
  const LimitedCurve first = *last_;
  const Held begin = held();
  double least = std::abs(begin.open);
  double lowest = begin.phi, highest = begin.phi;
  bool closed = false, gap = false, unknown = false;
  std::string jump;
  for (const double direction : {1.0, -1.0}) {
    last_ = first;
    turn_end(direction, [&](const auto& before, const Held& here) {
      least = std::min(least, std::abs(here.open));
      lowest = std::min(lowest, here.phi);
      highest = std::max(highest, here.phi);
      gap = gap || !before;
      if (before && here.beyond(*before)) {
        const LimitedCurve there = *last_;
        closed = close_in(*before, here);
        if (closed) return false;
        const bool jumps = protocol_.status == Status::NoSmoothContact;
        if (jumps) jump = protocol_.message;
        unknown = unknown || !jumps;
        last_ = there;
      }
      return has_more();
    });
    if (closed) return true;
    if (!has_more()) break;
  }
  if (unknown || !has_more()) {
    return protocol_.fail(Status::NotConverged,
                          "slopes at B were not looked at to the end");
  }
  if (!jump.empty()) return protocol_.fail(Status::NoSmoothContact, jump);
  if (highest - lowest < 2.0 * kEndStep) return false;
  return protocol_.fail(
      Status::NoSmoothContact,
      fmt::format(
          "no smooth contact was found under these limits: for slopes "
          "at B from {:.3g} to {:.3g} rad{} the path that keeps "
          "the limits ends {:.2g} rad or more off",
          lowest, highest,
          gap ? ", but those with which the body is in the way at B," : "",
          least));
}

}  // namespace brachisto
