// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "plot/racers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <utility>
#include <vector>

#include "brachisto/io/problem_file.hpp"
#include "brachisto/report/result.hpp"
#include "report/scale.hpp"
#include "trajectory/held_path.hpp"

namespace brachisto::plot {

namespace {

/// The ends of a track, from A to B.
std::array<Point, 2> ends(const Racer& racer) {
  const std::vector<double>&x = racer.table["x_b"], &z = racer.table["z_b"];
  return {{{x.front(), z.front()}, {x.back(), z.back()}}};
}

/// \param close  [m], what is as near to zero is shown as zero
std::string ends_in_words(const Racer& racer, double close) {
  const auto [a, b] = ends(racer);
  const auto shown = [close](double place) {
    return report::printed(std::abs(place) <= close ? 0.0 : place);
  };
  return fmt::format("from ({}, {}) to ({}, {})", shown(a.x), shown(a.z),
                     shown(b.x), shown(b.z));
}

/// That is where the one of `first` does not run.
[[noreturn]] void refuse_ends(const std::string& file, const std::string& here,
                              const std::string& first,
                              const std::string& there) {
  throw io::InputError(
      {{.file = file,
        .line = 0,
        .column = 0,
        .key = "scene.finish",
        .message = fmt::format("the track runs {}, that of \"{}\" {}: all have "
                               "to start and to finish together",
                               here, first, there)}});
}

}  // namespace

void check_track(const std::string& file, const Scene& scene) {
  if (scene.contact != Contact::Centre || !scene.body.rolls()) return;
  throw io::InputError(
      {{.file = file,
        .line = 0,
        .column = 0,
        .key = "scene.contact",
        .message = "centre was read, which leads the centre from A to B, but "
                   "others are to take the track; expected smooth, optimal or "
                   "{end_slope: …}"}});
}

void check_finish(const std::string& file, const Scene& scene,
                  const std::string& first, const Scene& its_scene) {
  if (std::hypot(scene.L - its_scene.L, scene.H - its_scene.H) <=
      kCloseToEnds * std::hypot(its_scene.L, its_scene.H)) {
    return;
  }
  const auto finish = [](const Scene& of) {
    return fmt::format("to ({}, {})", report::printed(of.L),
                       report::printed(of.H));
  };
  refuse_ends(file, finish(scene), first, finish(its_scene));
}

void check_ends(const std::string& file, const Racer& first,
                const Racer& racer) {
  const std::array<Point, 2> there = ends(first), here = ends(racer);
  // As much as the points of a given path may miss A and B.
  const double close = kCloseToEnds * std::hypot(there[1].x, there[1].z);
  for (std::size_t i = 0; i < there.size(); ++i) {
    if (distance(here[i], there[i]) <= close) {
      continue;
    }
    refuse_ends(file, ends_in_words(racer, close), first.name,
                ends_in_words(first, close));
  }
}

Racer racer_of(const std::string& name, const Solution& solution) {
  return {.name = name,
          .result = report::Json::parse(report::result_json(solution)),
          .scene = solution.scene,
          .table = TrajectoryTable::read(report::trajectory_csv(solution))};
}

std::shared_ptr<const GivenPath> track_of(const Solution& solution) {
  // For files, which show it: a turn makes the track go up and down once.
  constexpr double kFewest = 800.0, kPerTurn = 50.0, kMost = 8000.0;
  const Motion& motion = *solution.motion();
  const double turns =
      motion.rotation().value_or(0.0) / (2.0 * std::numbers::pi);
  const int pieces =
      static_cast<int>(std::clamp(kPerTurn * turns, kFewest, kMost));
  GivenPath path;
  path.curve = GivenPath::Curve::Track;
  path.shape = GivenPath::Shape::Points;
  for (int i = 0; i <= pieces; ++i) {
    path.points.push_back(motion.at(1.0 * i / pieces).motion.contact);
  }
  // What rounding leaves of the ends.
  path.points.front() = {0.0, 0.0};
  path.points.back() = {solution.scene.L, solution.scene.H};
  path.track_of = std::make_shared<const Scene>(on_its_path(motion));
  return std::make_shared<const GivenPath>(std::move(path));
}

Scene on_track(Scene scene, std::shared_ptr<const GivenPath> track) {
  scene.path = std::move(track);
  scene.contact = Contact::Smooth;
  scene.end_slope.reset();
  scene.limits = {};
  return scene;
}

}  // namespace brachisto::plot
