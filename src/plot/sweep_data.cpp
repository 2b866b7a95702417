// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "plot/sweep_data.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <initializer_list>
#include <optional>
#include <utility>

#include "plot/motion_data.hpp"
#include "plot/thinning.hpp"
#include "report/path_frame.hpp"
#include "report/scale.hpp"

namespace brachisto::plot {

namespace {

using report::Json;
using State = SweepOutcome::State;

/// To so many units of one.
double rounded(double value, double units) {
  return std::round(value * units) / units;
}

Json cells_of(const report::Figure& figure) {
  Json scenes = Json::array(), x = Json::array(), y = Json::array();
  constexpr double kPerPixel = 10.0;
  for (const report::SceneCells::Cell& cell : figure.scenes.cells) {
    scenes.push_back(cell.scene);
    x.push_back(rounded(cell.x, kPerPixel));
    y.push_back(rounded(cell.y, kPerPixel));
  }
  return {{"name", figure.name},
          {"size", {figure.width, figure.height}},
          {"row", figure.scenes.per_row},
          {"meet", figure.scenes.meet},
          {"scenes", std::move(scenes)},
          {"x", std::move(x)},
          {"y", std::move(y)}};
}

/// Why it failed or cannot be run on, and what its branch went through.
std::string remark(const SweepOutcome& outcome) {
  std::string text;
  if (outcome.state == State::Failed) text = outcome.message;
  if (outcome.state == State::Verified && !outcome.feasible) {
    text = fmt::format("Infeasible: {}",
                       fmt::join(outcome.infeasible_because, "; "));
  }
  if (!outcome.folds.empty()) {
    std::vector<std::string> places;
    for (const double eta_m : outcome.folds) {
      places.push_back(report::printed(eta_m, 4));
    }
    text += fmt::format("{}Its branch from the cycloid turned at η_m = {}.",
                        text.empty() ? "" : " ", fmt::join(places, ", "));
  }
  return text;
}

Json place_of(Point p) {
  constexpr double kPerMetre = 1e4;
  return {rounded(p.x, kPerMetre), rounded(p.z, kPerMetre)};
}

/// Nothing of what is no track.
std::optional<Json> track_data(const SweepTrack& track) {
  const Body& body = track.scene.body;
  const auto rows = read_kept_track(track.kept, body);
  if (!rows) return std::nullopt;
  const report::Box box = motion_box(*rows, body);
  Json out = track.kept;
  out["body"] = {
      {"rolls", body.rolls()}, {"radius", body.radius}, {"eta", body.eta_m}};
  if (body.ball) out["body"]["walls"] = body.wall_ratio;
  out["box"] = {place_of(box.low), place_of(box.high)};
  out["obstacles"] = Json::array();
  for (const report::Outline& area :
       report::obstacles(track.scene.limits, box.low, box.high)) {
    Json outline = Json::array();
    for (const Point corner : area) outline.push_back(place_of(corner));
    out["obstacles"].push_back(std::move(outline));
  }
  return out;
}

}  // namespace

Json sweep_data(const SweepTable& table,
                const std::vector<report::Figure>& figures,
                const std::vector<SweepTrack>& tracks) {
  Json data;
  data["figures"] = Json::array();
  for (const report::Figure& figure : figures) {
    if (!figure.scenes.cells.empty())
      data["figures"].push_back(cells_of(figure));
  }
  using Test = bool (*)(const SweepOutcome&);
  for (const auto& [name, are] :
       std::initializer_list<std::pair<const char*, Test>>{
           {"infeasible",
            [](const SweepOutcome& one) {
              return one.state == State::Verified && !one.feasible;
            }},
           {"unsolved",
            [](const SweepOutcome& one) { return one.state == State::Failed; }},
           {"missing",
            [](const SweepOutcome& one) {
              return one.state == State::Missing;
            }},
           {"folded",
            [](const SweepOutcome& one) { return !one.folds.empty(); }}}) {
    Json& scenes = data[name] = Json::array();
    for (std::size_t scene = 0; scene < table.outcomes.size(); ++scene) {
      if (are(table.outcomes[scene])) scenes.push_back(scene);
    }
  }
  data["remarks"] = Json::object();
  for (std::size_t scene = 0; scene < table.outcomes.size(); ++scene) {
    const std::string text = remark(table.outcomes[scene]);
    if (!text.empty()) data["remarks"][std::to_string(scene)] = text;
  }
  data["tracks"] = Json::object();
  for (const SweepTrack& track : tracks) {
    if (auto one = track_data(track)) {
      data["tracks"][std::to_string(track.number)] = *std::move(one);
    }
  }
  return data;
}

}  // namespace brachisto::plot
