// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "trajectory/feasibility.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "model/contact.hpp"
#include "model/path_inequality.hpp"
#include "trajectory/self_crossing.hpp"

namespace brachisto {

bool forbid_lift_off(const PathLimits& limits) {
  return limits.friction || limits.normal_min.value_or(-1.0) >= 0.0;
}

namespace {

/// Whether a number that must be above 0 is below by more than its error.
/// Written so that a NaN counts as below.
bool falls_short(double value, double error) {
  return error > 0.0 ? !(value >= -error) : !(value > 0.0);
}

std::string place_text(const Extreme& extreme) {
  return extreme.at_start ? "at the start"
                          : fmt::format("at x_b = {:.4g}", extreme.x);
}

}  // namespace

bool folds(const Scene& scene, const PathDiagnostics& path) {
  // Written so that a NaN folds.
  return falls_short(path.min_fold_margin.value, path.fold_margin_error) &&
         !(path.folds_back <= kShortestFold * std::hypot(scene.L, scene.H));
}

std::vector<std::string> infeasible_because(const Scene& scene,
                                            const PathDiagnostics& path) {
  std::vector<std::string> reasons;
  if (!scene.body.rolls()) return reasons;
  if (scene.contact == Contact::Smooth) {
    const Point start = start_of_centre(scene);
    if (std::hypot(scene.L - start.x, scene.H - start.z) < scene.body.radius) {
      reasons.emplace_back("B lies inside the body at its start");
    }
  }
  if (!forbid_lift_off(scene.limits)) {
    const Extreme& force = path.min_normal_force;
    // 0 is not taken where it is the limit at the start.
    const bool presses = (force.value == 0.0 && force.at_start) ||
                         !falls_short(force.value, path.normal_force_error);
    const bool at_once =
        path.at_start.lifts_off() && std::isfinite(path.normal_force_error);
    if (at_once || !presses) {
      reasons.push_back(fmt::format(
          "the body would lift off{} = {:.4g} m g {}{}",
          at_once ? " at the start, least R_n" : ": R_n", force.value,
          place_text(force),
          scene.limits.any()
              ? "; normal_force: {min: 0} under scene.limits would forbid it"
              : ""));
    }
  }
  const Extreme& margin = path.min_fold_margin;
  // Under a limit the certificate says that it is kept.
  if (!scene.limits.fold_margin && folds(scene, path)) {
    reasons.push_back(fmt::format(
        "the track folds{}, and runs back by {:.2g} m{}",
        margin.at_start ? " at the start: β′ > 0"
                        : fmt::format(": 1 − r κ_c = {:.4g} {}", margin.value,
                                      place_text(margin)),
        path.folds_back,
        scene.limits.any()
            ? "; fold_margin: 0 under scene.limits would forbid it"
            : ""));
  }
  if (path.self_crossing) {
    reasons.push_back(
        fmt::format("the track crosses itself at x_b = {:.4g}, z_b = {:.4g}",
                    path.self_crossing->x, path.self_crossing->z));
  }
  return reasons;
}

std::vector<std::string> undecided_because(const Scene& scene,
                                           const PathDiagnostics& path) {
  std::vector<std::string> reasons;
  const auto ask = [&](const char* what, const Extreme& least, double error,
                       const char* unit) {
    if (!(error > 0.0) || !(std::abs(least.value) <= error)) return;
    reasons.push_back(
        fmt::format("{} = {:.2g}{} {}, and the error of this mesh is {:.1g}{}",
                    what, least.value, unit, place_text(least), error, unit));
  };
  // Where arcs are known, and elements as short as they need be, limits are
  // kept between points as well as at them.
  const auto between = [&](const char* what, const Extreme& least, double bound,
                           const char* unit, double of = 1.0) {
    constexpr double kKept = 1e-6;  // a hundred times a certificate's threshold
    if (least.value >= bound - kKept * of) return;
    reasons.push_back(fmt::format(
        "{} is {:.2g}{} below its bound {:.6g} {}, between points of this mesh",
        what, bound - least.value, unit, bound, place_text(least)));
  };
  const PathLimits& limits = scene.limits;
  if (forbid_lift_off(limits)) {
    between("R_n", path.min_normal_force,
            std::max(0.0, limits.normal_min.value_or(0.0)), " m g");
  }
  if (!scene.body.rolls()) return reasons;
  if (forbid_lift_off(limits)) {
    // Nothing else is to be asked of R_n.
  } else if (std::isinf(path.normal_force_error)) {
    return {"this mesh does not tell whether R_n rises at the start"};
  } else {
    ask("least R_n after its first rise", path.normal_force_after_rise,
        path.normal_force_error, " m g");
  }
  for (const PathInequality& limit : inequalities(scene.body, limits)) {
    const double K = limit.number;
    if (limit.kind == PathInequality::Kind::Hump) {
      between("1 − r κ_c", path.min_fold_margin,
              1.0 - scene.body.folding_distance() * K, "");
    }
    // A track that folds is as sharp as one likes.
    if (limit.kind == PathInequality::Kind::Valley &&
        path.min_fold_margin.value > 0.0) {
      const double sharpest = K / (1.0 + scene.body.radius * K);
      between("κ_b", path.min_curvature, -sharpest, " 1/m", sharpest);
    }
  }
  if (!limits.fold_margin) {
    ask("least 1 − r κ_c", path.min_fold_margin, path.fold_margin_error, "");
  }
  return reasons;
}

}  // namespace brachisto
