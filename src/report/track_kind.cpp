// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/track_kind.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace brachisto::report {

namespace {

double in_degrees(double radians) {
  return radians * 180.0 / std::numbers::pi;
}

}  // namespace

std::string_view track_kind(const Scene& scene) {
  if (scene.path) return "given path";
  const bool limited = scene.limits.any();
  if (scene.contact == Contact::EndSlope) {
    return "fastest track with the end slope given";
  }
  if (!scene.body.rolls()) {
    return limited ? "brachistochrone of a bead under limits"
                   : "brachistochrone of a bead";
  }
  switch (scene.contact) {
    case Contact::Optimal:
      return "fastest track under these limits";
    case Contact::Centre:
      return limited
                 ? "extremal between fixed ends of the centre's path, under "
                   "limits"
                 : "extremal between fixed ends of the centre's path";
    default:
      return limited ? "smooth-contact extremal under limits"
                     : "smooth-contact extremal";
  }
}

std::string in_words(const Scene& scene) {
  const Body& body = scene.body;
  std::string text =
      body.rolls()
          ? fmt::format(
                "cylinder r = {:.6g} m, η_m = {:.6g}, θ_m = {:.6g}°, "
                "k = {:.6g}",
                body.radius, body.eta_m, in_degrees(body.theta_m), body.k)
          : std::string("bead");
  text += fmt::format("; L = {:.6g} m, H = {:.6g} m, g = {:.6g} m/s²", scene.L,
                      scene.H, scene.gravity);
  if (scene.contact == Contact::Centre) {
    text += ", between points of the centre's path";
  }
  if (scene.contact == Contact::EndSlope && scene.end_slope) {
    text += fmt::format(", end slope {:.6g}°", in_degrees(*scene.end_slope));
  }
  return text;
}

namespace {

/// "R_n from 0.1 to 5 m g", "R_n ≥ 0.1 m g", "R_n ≤ 5 m g".
std::string range(std::string_view what, std::optional<double> least,
                  std::optional<double> greatest, std::string_view unit) {
  if (least && greatest) {
    return fmt::format("{} from {:.6g} to {:.6g} {}", what, *least, *greatest,
                       unit);
  }
  return fmt::format("{} {} {:.6g} {}", what, least ? "≥" : "≤",
                     least ? *least : *greatest, unit);
}

}  // namespace

std::string in_words(const PathLimits& limits) {
  std::vector<std::string> parts;
  if (limits.friction) {
    parts.push_back(fmt::format("|R_t| ≤ {:.6g} R_n", *limits.friction));
  }
  if (limits.normal_min || limits.normal_max) {
    parts.push_back(range("R_n", limits.normal_min, limits.normal_max, "m g"));
  }
  const CurvatureLimit& curvature = limits.curvature;
  if (curvature.hump || curvature.valley) {
    const bool track = curvature.of == CurvatureLimit::Of::Track;
    parts.push_back(range(
        track ? "κ_b" : "κ_c",
        curvature.valley ? std::optional(-*curvature.valley) : std::nullopt,
        curvature.hump, "1/m"));
  }
  if (limits.fold_margin) {
    parts.push_back(fmt::format("1 − r κ_c ≥ {:.6g}", *limits.fold_margin));
  }
  if (limits.floor) {
    parts.push_back(fmt::format("floor at z = {:.6g} m", *limits.floor));
  }
  for (const auto& [count, what] :
       {std::pair{limits.discs.size(), "disc"},
        std::pair{limits.half_planes.size(), "half-plane"}}) {
    if (count == 0) continue;
    parts.push_back(
        fmt::format("clear of {} {}{}", count, what, count == 1 ? "" : "s"));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace brachisto::report
