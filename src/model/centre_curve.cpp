// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "model/centre_curve.hpp"

#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "brachisto/math/clock.hpp"
#include "math/roots.hpp"
#include "model/contact.hpp"
#include "model/cycloid.hpp"

namespace brachisto {

namespace {

constexpr double kQuarterTurn = 0.5 * std::numbers::pi;

PlaneCurvePtr curve_between(const GivenPath& path, Point start, Point end) {
  switch (path.shape) {
    case GivenPath::Shape::Straight:
      return straight_line(start, end);
    case GivenPath::Shape::Parabola:
      return parabola(start, end, path.start_angle_or_vertical());
    case GivenPath::Shape::CircularArc:
      return circular_arc(start, end, path.start_angle_or_vertical());
    case GivenPath::Shape::Cycloid:
      return cycloid_curve(start, end);
    case GivenPath::Shape::Points:
      return spline_through(path.points);
    case GivenPath::Shape::Slopes:
      return curve_of_slopes(start, path.slopes);
  }
  throw std::invalid_argument("unknown shape");
}

/// The curve of the centre that ends at C_B of its own end slope.
PlaneCurvePtr curve_with_contacts(const Scene& scene, Point start) {
  const auto curve_to = [&](double phi) {
    return curve_between(*scene.path, start, end_of_centre(scene, phi));
  };
  const auto mismatch = [&](double phi) {
    return curve_to(phi)->at(1.0).beta - phi;
  };
  const auto if_there_is = [](auto&& find) -> std::optional<double> {
    try {
      return find();
    } catch (const std::invalid_argument&) {
      return std::nullopt;  // no such curve to that point
    }
  };
  // Signs on a grid tell roots from jumps, where the curve turns over.
  constexpr int kSteps = 400;
  constexpr double kJump = 0.5;
  std::optional<double> best;
  std::optional<double> before;
  double phi_before = 0.0;
  for (int i = 0; i <= kSteps; ++i) {
    check_stop();
    const double phi = kQuarterTurn * (2.0 * i / kSteps - 1.0);
    const std::optional<double> now =
        if_there_is([&] { return mismatch(phi); });
    if (before && now && *before * *now <= 0.0 &&
        std::abs(*before - *now) < kJump) {
      const std::optional<double> root = if_there_is([&] {
        return math::find_root(mismatch, phi_before, phi, *before, *now);
      });
      if (root && (!best || std::abs(*root) < std::abs(*best))) best = root;
    }
    before = now;
    phi_before = phi;
  }
  if (!best) {
    throw std::invalid_argument(
        "no curve of this shape brings the centre to where the body touches B "
        "with the curve's own slope");
  }
  return curve_to(*best);
}

}  // namespace

PlaneCurvePtr centre_curve(const Scene& scene) {
  const GivenPath& path = *scene.path;
  const Point a{0.0, 0.0}, b{scene.L, scene.H};
  const double r = scene.body.radius;
  if (path.track_of) {
    constexpr double kSame = 1e-11;  // of the radius: rounding at A
    const double more = r - path.track_of->body.radius;
    const PlaneCurvePtr other = centre_curve(*path.track_of);
    return std::abs(more) <= kSame * r ? other : centre_path_over(other, more);
  }
  if (scene.contact == Contact::Centre) return curve_between(path, a, b);
  if (path.curve == GivenPath::Curve::Track) {
    return centre_path_over(curve_between(path, a, b), r);
  }
  switch (path.shape) {
    case GivenPath::Shape::Slopes:
      return curve_between(path, centre_above(a, r, path.slopes.beta.front()),
                           b);
    case GivenPath::Shape::Straight:
      // Parallel to the line from A to B.
      return centre_path_over(straight_line(a, b), r);
    case GivenPath::Shape::Cycloid: {
      const std::optional<CycloidArc> arc = axisymmetric_optimum(scene);
      if (!arc) {
        throw std::invalid_argument(
            "B lies inside the uniform cylinder at its start, whose cycloid is "
            "asked for; none leads there");
      }
      return cycloid_curve(arc->start, arc->at(arc->psi_end));
    }
    default:
      // Slopes do not move the contacts of a bead.
      if (!scene.body.rolls()) return curve_between(path, a, b);
      return curve_with_contacts(
          scene, centre_above(a, r, path.start_angle_or_vertical()));
  }
}

}  // namespace brachisto
