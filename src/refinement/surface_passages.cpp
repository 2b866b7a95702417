// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/surface_passages.hpp"

#include <algorithm>
#include <cmath>

#include "math/roots.hpp"
#include "model/field.hpp"

namespace brachisto {

std::vector<double> surface_passages(
    const Scene& scene, const Mesh& mesh,
    const std::function<Point(double)>& heavy_at) {
  std::vector<double> out;
  if (!has_surface(scene.world)) return out;
  const auto height = [&](double sigma) {
    return height_above_surface(scene, heavy_at(sigma));
  };
  // Between so many places of an element a path is as good as straight.
  const int parts = 2 * mesh.degree;
  double before = 0.0, at_before = height(0.0);
  for (int e = 0; e < mesh.num_elements(); ++e) {
    for (int i = 1; i <= parts; ++i) {
      const double sigma = mesh.sigma(e, static_cast<double>(i) / parts);
      const double at = height(sigma);
      if ((at > 0.0) != (at_before > 0.0)) {
        out.push_back(math::find_root(height, before, sigma, at_before, at));
      }
      before = sigma;
      at_before = at;
    }
  }
  return out;
}

std::vector<double> surface_passages(const Scene& scene,
                                     const ExtremalCurve& curve) {
  return surface_passages(scene, curve.mesh(), [&](double sigma) {
    const ExtremalPoint at = curve.without_slope(sigma);
    return mass_centre(scene.body, at.centre, at.theta);
  });
}

std::vector<double> surface_passages(const LimitedCurve& curve) {
  const Scene& scene = curve.problem().scene();
  return surface_passages(scene, curve.problem().mesh(), [&](double sigma) {
    const MovingState at = moving(curve.at(sigma).state);
    return mass_centre(scene.body, at.centre, at.theta);
  });
}

std::vector<FieldSide> sides_of_elements(const ExtremalCurve& curve,
                                         const Mesh& mesh) {
  std::vector<FieldSide> out;
  const Scene& scene = curve.scene();
  if (!has_surface(scene.world)) return out;
  for (int e = 0; e < mesh.num_elements(); ++e) {
    const ExtremalPoint at = curve.without_slope(mesh.sigma(e, 0.5));
    out.push_back(
        side_of_surface(scene, mass_centre(scene.body, at.centre, at.theta)));
  }
  return out;
}

std::vector<int> elements_beyond(const std::vector<FieldSide>& sides) {
  std::vector<int> out;
  for (std::size_t e = 1; e < sides.size(); ++e) {
    if (sides[e] != sides[e - 1]) out.push_back(static_cast<int>(e));
  }
  return out;
}

Mesh with_beginnings_at(const Mesh& mesh, const std::vector<int>& elements,
                        const std::vector<double>& places) {
  Mesh out = mesh;
  std::size_t first = 0;
  for (std::size_t i = 0; i <= elements.size(); ++i) {
    const bool rest = i == elements.size();
    const std::size_t last = rest ? mesh.boundaries.size() - 1
                                  : static_cast<std::size_t>(elements[i]);
    const double from = mesh.boundaries[first], to = mesh.boundaries[last];
    const double new_from = out.boundaries[first];
    const double new_to = rest ? to : places[i];
    for (std::size_t e = first + 1; e <= last; ++e) {
      const double share = (mesh.boundaries[e] - from) / (to - from);
      out.boundaries[e] = new_from + share * (new_to - new_from);
    }
    out.boundaries[last] = new_to;
    first = last;
  }
  return out;
}

Mesh with_ends_at(Mesh mesh, const std::vector<double>& places, bool as_many) {
  // Of the element that a place is in: 0.5 is near one of its ends.
  const double near = as_many ? 0.5 : 0.3;
  // A itself may lie on the surface; no element begins and ends there.
  constexpr double kNoLength = 1e-9;
  std::size_t placed = 0;  // the last end that stays, which is at A at first
  for (const double sigma : places) {
    if (std::min(sigma, 1.0 - sigma) < kNoLength) continue;
    const auto [e, t] = mesh.locate(sigma);
    const auto before = static_cast<std::size_t>(e), after = before + 1;
    std::vector<double>& ends = mesh.boundaries;
    const bool before_moves = before > placed;
    const bool after_moves = after + 1 < ends.size();
    if (before_moves && (t < near || (as_many && !after_moves))) {
      placed = before;
    } else if (after_moves && (t > 1.0 - near || as_many)) {
      placed = after;
    } else {
      ends.insert(ends.begin() + static_cast<std::ptrdiff_t>(after), sigma);
      placed = after;
    }
    ends[placed] = sigma;
  }
  return mesh;
}

void SurfaceEnds::learn(const ExtremalCurve& solution) {
  constexpr double kPlaced = 1e-13;
  // Where rounding keeps the two apart they come no closer.
  constexpr double kAlmost = 1e-9, kCloser = 0.5;
  const Mesh& mesh = solution.mesh();
  Solution now;
  now.passages = surface_passages(solution.scene(), solution);
  now.T = solution.transit_time();
  for (const double passage : now.passages) {
    const auto [e, t] = mesh.locate(passage);
    const auto nearest = static_cast<std::size_t>(t < 0.5 ? e : e + 1);
    now.ends.push_back(mesh.boundaries[nearest]);
    now.apart = std::max(now.apart, std::abs(passage - now.ends.back()));
  }
  next_ = now.passages;
  error_ = 0.0;
  const bool again = last_ && last_->ends.size() == now.ends.size();
  settled_ = now.apart <= kPlaced || (again && now.apart <= kAlmost &&
                                      now.apart > kCloser * last_->apart);
  // A secant for each: an end moved by 1 moves its passage by c.
  constexpr double kFitted = 1e-3, kSteepest = 0.8;
  if (again && last_->apart <= kFitted) {
    double moved = 0.0;
    for (std::size_t i = 0; i < next_.size(); ++i) {
      const double by = now.ends[i] - last_->ends[i];
      moved = std::max(moved, std::abs(by));
      const double c = (now.passages[i] - last_->passages[i]) / by;
      if (!(c < kSteepest)) continue;
      next_[i] = now.ends[i] + (now.passages[i] - now.ends[i]) / (1.0 - c);
    }
    if (moved > 0.0) {
      error_ = std::abs(now.T / last_->T - 1.0) / moved * now.apart;
    }
  }
  last_ = std::move(now);
}

}  // namespace brachisto
