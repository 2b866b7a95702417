// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// scene_keys(): what is to roll where.

#include <memory>
#include <string>
#include <utility>

#include "io/key_sections.hpp"

namespace brachisto::io {

namespace {

/// Changes the given path; copies of the scene that share it keep theirs.
template <class Change>
void change_path(ProblemFile& problem, Change&& change) {
  const auto& old = problem.scene.path;
  auto path = std::make_shared<GivenPath>(old ? *old : GivenPath{});
  change(*path);
  problem.scene.path = std::move(path);
}

}  // namespace

std::vector<KeySpec> scene_keys() {
  return {
      {.path = "scene",
       .type = KeyType::Map,
       .presence = Presence::Required,
       .description = "what is to roll where"},
      {.path = "scene.body",
       .type = KeyType::Map,
       .presence = Presence::Required,
       .description = "the body"},
      {.path = "scene.body.shape",
       .type = KeyType::Choice,
       .presence = Presence::Required,
       .description = "a cylinder rolls without slip, a bead slides without "
                      "friction",
       .choices = {{"cylinder",
                    [](ProblemFile& p) {
                      p.scene.body.shape = Shape::Cylinder;
                    }},
                   {"bead",
                    [](ProblemFile& p) { p.scene.body.shape = Shape::Bead; }}}},
      {.path = "scene.body.radius",
       .type = KeyType::Number,
       .presence = Presence::RequiredOfCylinder,
       .unit = "m",
       .bounds = "> 0",
       .description = "r, radius of the cylinder",
       .set = [](ProblemFile& p, double v) { p.scene.body.radius = v; }},
      {.path = "scene.body.eta_m",
       .type = KeyType::Number,
       .presence = Presence::OptionalOfCylinder,
       .fallback = "0",
       .bounds = "0 ≤ η_m < 1",
       .description = "η_m, distance of the centre of mass from the axis, in "
                      "radii",
       .set = [](ProblemFile& p, double v) { p.scene.body.eta_m = v; }},
      {.path = "scene.body.theta_m",
       .type = KeyType::Angle,
       .presence = Presence::OptionalOfCylinder,
       .unit = "rad",
       .fallback = "0",
       .description = "θ_m, direction from the axis to the centre of mass at "
                      "the start, from +x towards +z (down)",
       .set = [](ProblemFile& p, double v) { p.scene.body.theta_m = v; }},
      {.path = "scene.body.k",
       .type = KeyType::Number,
       .presence = Presence::RequiredOfCylinder,
       .bounds = "0 ≤ k ≤ 1 − η_m²",
       .description = "k = I_cm/(m r²), moment of inertia about the centre of "
                      "mass",
       .set = [](ProblemFile& p, double v) { p.scene.body.k = v; }},
      {.path = "scene.body.mass",
       .type = KeyType::Number,
       .unit = "kg",
       .bounds = "> 0",
       .description = "m, only needed for forces in newtons",
       .set = [](ProblemFile& p, double v) { p.scene.body.mass = v; }},
      {.path = "scene.finish",
       .type = KeyType::Map,
       .presence = Presence::Required,
       .description = "the point B to be reached from A = (0, 0)"},
      {.path = "scene.finish.L",
       .type = KeyType::Number,
       .presence = Presence::Required,
       .unit = "m",
       .bounds = "> 0",
       .description = "L, horizontal distance from A to B",
       .set = [](ProblemFile& p, double v) { p.scene.L = v; }},
      {.path = "scene.finish.H",
       .type = KeyType::Number,
       .presence = Presence::Required,
       .unit = "m",
       .bounds = "> 0",
       .description = "H, drop from A to B",
       .set = [](ProblemFile& p, double v) { p.scene.H = v; }},
      {.path = "scene.gravity",
       .type = KeyType::Number,
       .unit = "m/s²",
       .fallback = "9.81",
       .bounds = "> 0",
       .description = "g, acceleration of gravity",
       .set = [](ProblemFile& p, double v) { p.scene.gravity = v; }},
      {.path = "scene.contact",
       .type = KeyType::Choice,
       .fallback = "smooth",
       .description = "whether A and B are points of the track (smooth) or of "
                      "the path of the centre",
       .choices = {{"smooth",
                    [](ProblemFile& p) { p.scene.contact = Contact::Smooth; }},
                   {"centre",
                    [](ProblemFile& p) {
                      p.scene.contact = Contact::Centre;
                    }}}},
      {.path = "scene.path",
       .type = KeyType::Map,
       .description = "a given path, which is evaluated; without it the "
                      "extremal is found"},
      {.path = "scene.path.curve",
       .type = KeyType::Choice,
       .fallback = "centre",
       .description = "whose curve it is: the path of the centre, or the track "
                      "from A to B",
       .choices = {{"centre",
                    [](ProblemFile& p) {
                      change_path(p, [](GivenPath& path) {
                        path.curve = GivenPath::Curve::Centre;
                      });
                    }},
                   {"track",
                    [](ProblemFile& p) {
                      change_path(p, [](GivenPath& path) {
                        path.curve = GivenPath::Curve::Track;
                      });
                    }}}},
      {.path = "scene.path.shape",
       .type = KeyType::Choice,
       .presence = Presence::Required,
       .description = "a parabola has a horizontal axis if it starts "
                      "vertically, a vertical one otherwise; a cycloid has its "
                      "cusp at the start; points: a cubic spline",
       .choices = {{"straight",
                    [](ProblemFile& p) {
                      change_path(p, [](GivenPath& path) {
                        path.shape = GivenPath::Shape::Straight;
                      });
                    }},
                   {"parabola",
                    [](ProblemFile& p) {
                      change_path(p, [](GivenPath& path) {
                        path.shape = GivenPath::Shape::Parabola;
                      });
                    }},
                   {"circular_arc",
                    [](ProblemFile& p) {
                      change_path(p, [](GivenPath& path) {
                        path.shape = GivenPath::Shape::CircularArc;
                      });
                    }},
                   {"cycloid",
                    [](ProblemFile& p) {
                      change_path(p, [](GivenPath& path) {
                        path.shape = GivenPath::Shape::Cycloid;
                      });
                    }},
                   {"points",
                    [](ProblemFile& p) {
                      change_path(p, [](GivenPath& path) {
                        path.shape = GivenPath::Shape::Points;
                      });
                    }}}},
      {.path = "scene.path.start_angle",
       .type = KeyType::Angle,
       .unit = "rad",
       .fallback = "90 deg",
       .description = "slope angle at the start of a parabola or a circular "
                      "arc, downwards positive",
       .set =
           [](ProblemFile& p, double v) {
             change_path(p, [=](GivenPath& path) { path.start_angle = v; });
           }},
      {.path = "scene.path.file",
       .type = KeyType::Text,
       .bounds = "a CSV file with the columns x,z",
       .description = "of points, in metres, from A to B; a relative name "
                      "starts from the problem file's directory",
       .set_text =
           [](ProblemFile& p, const std::string& text) {
             p.points_file = text;
             change_path(p, [](GivenPath&) {});
           }},
  };
}

}  // namespace brachisto::io
