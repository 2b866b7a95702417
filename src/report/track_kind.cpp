// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/track_kind.hpp"

#include <fmt/args.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "math/angle.hpp"
#include "report/scale.hpp"
#include "report/text_table.hpp"
#include "trajectory/stated_limits.hpp"

namespace brachisto::report {

namespace {

/// "0.5/s", "2 m".
std::string with_unit(double number, std::string_view unit) {
  if (unit.empty()) return fmt::format("{:.6g}", number);
  return unit.starts_with("1/")
             ? fmt::format("{:.6g}{}", number, unit.substr(1))
             : fmt::format("{:.6g} {}", number, unit);
}

/// "ball R = 0.008 m on rails 0.01 m apart, r = …, η_m = …, …".
std::string body_in_words(const Body& body) {
  if (!body.rolls()) return "bead";
  std::string text = "cylinder ";
  if (body.ball) {
    const Ball& ball = *body.ball;
    text = fmt::format("ball R = {:.6g} m", ball.radius);
    if (ball.gauge) {
      text += ball.rail_radius ? fmt::format(" on round rails of {:.6g} m",
                                             *ball.rail_radius)
                               : " on rails";
      text += fmt::format(", {:.6g} m apart", *ball.gauge);
    } else if (ball.groove) {
      text += fmt::format(" in a groove of {:.6g}°",
                          math::in_degrees(*ball.groove));
    }
    text += ", which rolls with ";
  }
  return text +
         fmt::format("r = {:.6g} m, η_m = {:.6g}, θ_m = {:.6g}°, k = {:.6g}",
                     body.radius, body.eta_m, math::in_degrees(body.theta_m),
                     body.k);
}

/// " at A of a sphere of 8 m about (1, 10), v_0 = 1 m/s"; "" if ordinary.
std::string world_in_words(const World& world) {
  std::string text;
  fmt::dynamic_format_arg_store<fmt::format_context> of_field;
  std::vector<std::string> drags;
  for (const WorldParameter& parameter : kWorldParameters) {
    const double* number = parameter.find(world);
    if (number == nullptr) continue;
    const std::string told = with_unit(*number, parameter.unit);
    if (parameter.of_field) {
      of_field.push_back(*number);
    } else if (*parameter.times != '\0') {
      drags.push_back(fmt::format("{} {}", told, parameter.times));
    } else if (*number != 0.0) {
      text += ", " + fmt::format(fmt::runtime(parameter.words), told);
    }
  }
  if (const FieldKind* kind = field_kind(world)) {
    text = " at A " + fmt::vformat(kind->words, of_field) + text;
  }
  if (!world.air.any()) return text;
  return fmt::format("{}, drag {}", text, fmt::join(drags, " + "));
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
  std::string text = body_in_words(scene.body);
  text += fmt::format("; L = {:.6g} m, H = {:.6g} m, g = {:.6g} m/s²", scene.L,
                      scene.H, scene.gravity);
  text += world_in_words(scene.world);
  if (scene.contact == Contact::Centre) {
    text += ", between points of the centre's path";
  }
  if (scene.contact == Contact::EndSlope && scene.end_slope) {
    text +=
        fmt::format(", end slope {:.6g}°", math::in_degrees(*scene.end_slope));
  }
  return with_minus_signs(text);
}

std::string limits_in_words(const Scene& scene) {
  std::vector<BoundInWords> bounds;
  for (const StatedLimit& limit : stated_limits(scene)) {
    if (limit.words) bounds.push_back(*limit.words);
  }
  std::vector<std::string> parts;
  for (auto bound = bounds.begin(); bound != bounds.end(); ++bound) {
    const auto next = bound + 1;
    const bool range =
        next != bounds.end() && next->quantity == bound->quantity;
    parts.push_back(range ? fmt::format("{} from {:.6g} to {:.6g}",
                                        bound->quantity,
                                        std::min(bound->number, next->number),
                                        std::max(bound->number, next->number))
                          : fmt::format("{} {} {:.6g}", bound->quantity,
                                        bound->relation, bound->number));
    if (!bound->unit.empty()) parts.back() += fmt::format(" {}", bound->unit);
    if (range) bound = next;
  }
  for (const auto& [count, what] :
       {std::pair{scene.limits.discs.size(), "disc"},
        std::pair{scene.limits.half_planes.size(), "half-plane"}}) {
    if (count == 0) continue;
    parts.push_back("clear of " + counted(count, what));
  }
  return with_minus_signs(fmt::format("{}", fmt::join(parts, ", ")));
}

}  // namespace brachisto::report
