// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/cutting_template.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <string>

#include "report/cutting_assembly.hpp"
#include "report/cutting_parts.hpp"
#include "report/cutting_pieces.hpp"
#include "report/cutting_sheet.hpp"
#include "trajectory/displacement.hpp"
#include "trajectory/grip.hpp"

namespace brachisto::report::cutting {

namespace {

constexpr double kError = 1e-3;  ///< of a builder [m]
constexpr int kStretches = 10;

/// Of times: v ~ √length in a uniform field.
double time_scale(const Build& build) {
  return std::sqrt(build.scale);
}

std::string scale_in_words(double scale) {
  return scale <= 1.0 ? fmt::format("1:{:.6g}", 1.0 / scale)
                      : fmt::format("{:.6g}:1", scale);
}

std::string body_in_words(const Body& body, const Build& build) {
  if (!body.rolls()) return "a bead";
  const Body stated = as_stated(body);
  std::string out = fmt::format("a {} of radius {:.5g} mm, k = {:.4g}",
                                body.ball ? "ball" : "cylinder",
                                build.per_metre() * stated.radius, stated.k);
  if (body.off_centred()) {
    fmt::format_to(std::back_inserter(out),
                   ", its centre of mass {:.4g} mm from the axis, {:.4g} "
                   "degrees below level at A",
                   build.per_metre() * body.radius * body.eta_m,
                   body.theta_m * 180.0 / std::numbers::pi);
  }
  return out;
}

std::string built_in_words(const Build& build) {
  std::string out = fmt::format(
      "Strips {:.4g} mm wide of material {:.4g} mm thick, holes of {:.4g} mm",
      build.strip, build.thickness, build.hole);
  if (build.gauge) {
    fmt::format_to(std::back_inserter(out),
                   "; two strips, L and R, with {:.4g} mm between them",
                   *build.gauge);
  }
  return out +
         ". The cross on each piece is level and plumb once it hangs, the line "
         "below its rolling edge as deep as a flange. Plate 1-2 laps pieces 1 "
         "and 2 "
         "from behind.";
}

/// Discs with another k than the body of the track are another body.
std::string discs_in_words(const Body& body, const Build& build) {
  const auto told = [](double k) { return fmt::format("{:.3g}", k); };
  const std::string as_cut = told(k_of_discs(body, build));
  std::string out = fmt::format(
      "The two discs and two flanges have k = {} as they are cut", as_cut);
  if (as_cut != told(body.k)) {
    fmt::format_to(std::back_inserter(out),
                   ", and the track is for k = {}: weights on them, or another "
                   "body, have to make up for it",
                   told(body.k));
  }
  out += ". A of a disc touches A of the track at the start";
  if (body.off_centred()) out += ", G is the centre of mass";
  return out + '.';
}

std::string load_in_words(const PathDiagnostics& known, const Build& build) {
  const auto at = [&](const Extreme& extreme) {
    return fmt::format("{:.3g} m g at x = {:.4g} mm", told_force(extreme.value),
                       build.per_metre() * extreme.x);
  };
  return fmt::format(
      "Load: least {}{}, greatest {}.", at(known.normal_force_after_rise),
      known.min_normal_force.at_start ? " after it has risen from 0 at A" : "",
      at(known.max_normal_force));
}

std::string care_in_words(const std::vector<DisplacedStretch>& stretches,
                          const Build& build) {
  const auto amount = [](const DisplacedStretch& stretch) {
    return std::abs(stretch.dearer());
  };
  const auto [least, most] = std::ranges::minmax_element(stretches, {}, amount);
  const auto told = [&](const DisplacedStretch& stretch) {
    const auto x = [&](const TrajectoryPoint& at) {
      return build.per_metre() * at.motion.contact.x;
    };
    return fmt::format("from x = {:.4g} to {:.4g} mm, {}", x(stretch.from),
                       x(stretch.to), change_in_words(stretch.dearer()));
  };
  return fmt::format("Care: 1 mm of error matters most {}; least {}.",
                     told(*most), told(*least));
}

/// What every sheet tells, in letters that DXF has.
std::vector<std::string> facts(const Solution& solution, const Build& build,
                               const std::vector<DisplacedStretch>& stretches) {
  const Scene& scene = solution.scene;
  const double mm = build.per_metre();
  std::vector<std::string> out{fmt::format(
      "Track for {}; scale {}; B is {:.5g} mm to the right of A and {:.5g} mm "
      "below; T = {:.4g} s",
      body_in_words(scene.body, build), scale_in_words(build.scale),
      mm * scene.L, mm * scene.H,
      time_scale(build) * solution.motion()->transit_time())};
  if (scene.world.start_speed != 0.0) {
    fmt::format_to(std::back_inserter(out.back()),
                   " from a start with {:.4g} m/s",
                   time_scale(build) * scene.world.start_speed);
  }
  out.back() += '.';
  out.push_back(built_in_words(build));
  if (scene.body.rolls()) {
    out.push_back(fmt::format("Grip: least friction coefficient {}.",
                              grip_in_words(solution.diagnostics->least_grip)));
  }
  out.push_back(load_in_words(*solution.diagnostics, build));
  if (!stretches.empty()) out.push_back(care_in_words(stretches, build));
  if (scene.body.rolls() && !scene.body.ball) {
    out.push_back(discs_in_words(scene.body, build));
  }
  return out;
}

std::vector<DisplacedStretch> stretches_of(const Motion& motion,
                                           const Build& build) {
  std::vector<DisplacedStretch> out =
      displaced_stretches(motion, kStretches, kError / build.scale);
  for (DisplacedStretch& stretch : out) {
    stretch.raised *= time_scale(build);
    stretch.lowered *= time_scale(build);
  }
  return out;
}

/// The edges of two strips are thin rails.
void check_rails(const Build& build, const Ball& ball) {
  if (!ball.gauge || ball.rail_radius) {
    throw TemplateError(
        "sheets give a ball the edges of two strips to run on, and that of the "
        "scene runs on something else; they are for thin rails");
  }
  const double gauge = build.per_metre() * *ball.gauge;
  constexpr double kAsStated = 1e-6;
  if (!build.gauge || std::abs(*build.gauge - gauge) > kAsStated * gauge) {
    throw TemplateError(fmt::format(
        "the rails of the ball are {0:.6g} mm apart; --rails {0:.6g} has the "
        "strips so",
        gauge));
  }
}

}  // namespace

void check_build(const Build& build, const Scene& scene) {
  if (build.strip < kStripInHoles * build.hole) {
    throw TemplateError(fmt::format(
        "a strip of {:.4g} mm has no room for holes of {:.4g} mm; a --strip is "
        "{:g} times as wide as a --hole or wider",
        build.strip, build.hole, kStripInHoles));
  }
  if (build.scale != 1.0 &&
      (scene.world.field_varies() || scene.world.air.any())) {
    throw TemplateError(
        "in air, or in a field that varies, a model rolls otherwise than its "
        "scene; --scale is 1:1 there");
  }
  if (scene.body.ball) return check_rails(build, *scene.body.ball);
  const double across = 2.0 * build.per_metre() * scene.body.radius;
  const double most = std::min(build.width, build.height) - 2.0 * kMargin;
  if (across > most) {
    throw TemplateError(fmt::format(
        "a body of {:.4g} mm does not fit on a sheet of {:.6g} x {:.6g} mm, "
        "less {:g} mm at each edge; a larger --sheet or a smaller --scale "
        "makes room",
        across, build.width, build.height, kMargin));
  }
}

std::vector<Drawing> cutting_template(const Solution& solution,
                                      std::span<const MassPart> made_of,
                                      const Build& build) {
  check_build(build, solution.scene);
  if (!solution.verified()) {
    throw TemplateError("there is no verified track to be cut");
  }
  for (const std::string& reason : solution.infeasible_because()) {
    throw TemplateError("the track cannot be rolled on: " + reason);
  }
  const Motion& motion = *solution.motion();
  Build built = build;
  built.strip = strip_width(build, solution.diagnostics->max_curvature.value);
  const std::vector<DisplacedStretch> stretches = stretches_of(motion, built);
  const SheetFrame frame(built, facts(solution, built, stretches));
  const Edge edge(motion, built);
  const std::vector<Piece> pieces =
      pieces_of(edge, built, [&](const Box& box) { return frame.fits(box); });
  std::vector<Part> parts = track_parts(edge, pieces, built);
  std::ranges::move(
      body_parts(solution.scene.body, motion.start_angle(), made_of, built),
      std::back_inserter(parts));
  Arrangement sheets = arranged(parts, frame);
  // Pieces come first.
  sheets.sheet_of.resize(pieces.size() * (built.gauge ? 2 : 1));
  std::vector<Drawing> out = std::move(sheets.sheets);
  std::ranges::move(
      assembly(edge, pieces, sheets.sheet_of, stretches, built, frame),
      std::back_inserter(out));
  return out;
}

}  // namespace brachisto::report::cutting
