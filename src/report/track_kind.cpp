// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/track_kind.hpp"

namespace brachisto::report {

std::string_view track_kind(const Scene& scene) {
  if (scene.path) return "given path";
  if (!scene.body.rolls()) return "brachistochrone of a bead";
  return scene.contact == Contact::Centre
             ? "extremal between fixed ends of the centre's path"
             : "smooth-contact extremal";
}

}  // namespace brachisto::report
