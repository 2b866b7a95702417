// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/track_kind.hpp"

#include <fmt/format.h>

#include <numbers>

namespace brachisto::report {

std::string_view track_kind(const Scene& scene) {
  if (scene.path) return "given path";
  if (!scene.body.rolls()) return "brachistochrone of a bead";
  return scene.contact == Contact::Centre
             ? "extremal between fixed ends of the centre's path"
             : "smooth-contact extremal";
}

std::string in_words(const Scene& scene) {
  const Body& body = scene.body;
  std::string text =
      body.rolls() ? fmt::format(
                         "cylinder r = {:.6g} m, η_m = {:.6g}, θ_m = {:.6g}°, "
                         "k = {:.6g}",
                         body.radius, body.eta_m,
                         body.theta_m * 180.0 / std::numbers::pi, body.k)
                   : std::string("bead");
  return text + fmt::format("; L = {:.6g} m, H = {:.6g} m, g = {:.6g} m/s²{}",
                            scene.L, scene.H, scene.gravity,
                            scene.contact == Contact::Centre
                                ? ", between points of the centre's path"
                                : "");
}

}  // namespace brachisto::report
