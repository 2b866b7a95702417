// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "sweep/job.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <utility>

#include "io/consistency.hpp"
#include "io/effective_input.hpp"
#include "io/input_tree.hpp"

namespace brachisto::sweep {

namespace {

using nlohmann::json;

/// The section `design`, which all scenes share.
std::string design_of(const io::SweepFile& file) {
  return io::effective_section(file.problem(0), "design").dump();
}

/// The given path if it has points, which all scenes share; nullptr if not.
std::shared_ptr<const GivenPath> path_of_points(const io::SweepFile& file) {
  std::shared_ptr<const GivenPath> path = file.problem(0).scene.path;
  const bool of_points = path && path->shape == GivenPath::Shape::Points;
  return of_points ? path : nullptr;
}

/// How the points of two files differ, in one sentence; empty if they do not.
std::string difference_of_points(const io::SweepFile& stored,
                                 const io::SweepFile& wanted) {
  const auto stored_path = path_of_points(stored);
  const auto wanted_path = path_of_points(wanted);
  if (!stored_path || !wanted_path) return "";
  const std::vector<Point>& was = stored_path->points;
  const std::vector<Point>& is = wanted_path->points;
  const std::string file = wanted.problem(0).points_file;
  if (was.size() != is.size()) {
    return fmt::format("it has {} points from {}, which has {} now", was.size(),
                       file, is.size());
  }
  const auto [before, now] = std::mismatch(was.begin(), was.end(), is.begin());
  if (before == was.end()) return "";
  return fmt::format("it has {},{} as point {} from {}, which has {},{} now",
                     before->x, before->z, before - was.begin() + 1, file,
                     now->x, now->z);
}

/// \param points  of its path, if they are known already
Job job_of(const std::string& name, std::string text,
           std::vector<std::string> overrides, bool of_design,
           const std::vector<Point>* points = nullptr) {
  io::SweepFile file = io::read_sweep_text(text, name, overrides, points);
  return {name, std::move(text), std::move(overrides), std::move(file),
          of_design};
}

}  // namespace

Job read_job(const std::filesystem::path& path,
             const std::vector<std::string>& overrides) {
  std::string text = io::read_problem_bytes(path);
  return job_of(path.string(), std::move(text), overrides, false);
}

Job design_job(const std::string& text, const std::string& name,
               const std::vector<std::string>& overrides) {
  const io::ProblemFile problem = io::read_problem_text(text, name, overrides);
  io::require_design(problem, name);
  std::vector<int> starts(static_cast<std::size_t>(problem.design.starts));
  std::iota(starts.begin(), starts.end(), 1);
  if (problem.design.start) starts = {*problem.design.start};
  // An override of a key that varies would be idle; it has had its effect.
  std::vector<std::string> all = overrides;
  std::erase_if(all, [](const std::string& one) {
    return one.starts_with("design.start=");
  });
  all.push_back("sweep=" + json{{"design.start", starts}}.dump());
  return job_of(name, text, std::move(all), true);
}

Job design_map_job(const std::string& text, const std::string& name,
                   const std::vector<std::string>& overrides, const Body& best,
                   int count) {
  const DesignPlan plan = io::read_problem_text(text, name, overrides).design;
  std::vector<BodyKey> axes = plan.free;
  std::ranges::sort(axes);
  if (axes.size() < 2) {
    throw io::InputError({{.file = name,
                           .key = "design.free",
                           .message = "a map is over two of eta_m, theta_m, k "
                                      "and r; less are free"}});
  }
  axes.resize(2);
  std::vector<std::string> all = overrides;
  json section;
  const auto add = [&](BodyKey key, const char* path_of_key, double value) {
    if (std::ranges::count(axes, key) == 0) {
      all.push_back(fmt::format("{}={}", path_of_key, value));
      return;
    }
    std::erase_if(all, [&](const std::string& one) {
      return one.starts_with(std::string(path_of_key) + "=");
    });
    json range = {{"count", count}};
    const DesignBounds bounds = plan.bounds_of(key);
    range["from"] =
        std::isfinite(bounds.lower) ? json(bounds.lower) : json("-180 deg");
    range["to"] =
        std::isfinite(bounds.upper) ? json(bounds.upper) : json("180 deg");
    if (key == BodyKey::EtaM) {
      // The smaller one of the bound and the room below the rim.
      range["to"] =
          fmt::format("({0} + 0.999*sqrt(1-k) - abs({0} - 0.999*sqrt(1-k)))/2",
                      bounds.upper);
    }
    section[path_of_key] = std::move(range);
  };
  add(BodyKey::EtaM, "scene.body.eta_m", best.eta_m);
  add(BodyKey::ThetaM, "scene.body.theta_m", best.theta_m);
  add(BodyKey::K, "scene.body.k", best.k);
  add(BodyKey::Radius, "scene.body.radius", best.radius);
  all.push_back("sweep=" + section.dump());
  return job_of(name, text, std::move(all), false);
}

std::string to_line(const Job& job) {
  json document = {
      {"name", job.name}, {"text", job.text}, {"overrides", job.overrides}};
  if (job.of_design) document["design"] = true;
  if (const auto path = path_of_points(job.file)) {
    json& list = document["points"] = json::array();
    for (const Point& point : path->points) {
      list.push_back({point.x, point.z});
    }
  }
  // A name may have any bytes.
  return document.dump(-1, ' ', false, json::error_handler_t::replace) + "\n";
}

Job job_from_line(const std::string& line) {
  std::string name, text;
  std::vector<std::string> overrides;
  std::optional<std::vector<Point>> points;
  bool of_design = false;
  try {
    const json document = json::parse(line);
    of_design = document.value("design", false);
    document.at("name").get_to(name);
    document.at("text").get_to(text);
    document.at("overrides").get_to(overrides);
    if (document.contains("points")) {
      points.emplace();
      for (const auto& [x, z] :
           document["points"].get<std::vector<std::array<double, 2>>>()) {
        points->push_back({x, z});
      }
    }
  } catch (const json::exception& error) {
    throw JobError(error.what());
  }
  return job_of(name, std::move(text), std::move(overrides), of_design,
                points ? &*points : nullptr);
}

std::string input_hash(const io::SweepFile& file) {
  const std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state(
      XXH3_createState(), &XXH3_freeState);
  XXH3_128bits_reset(state.get());
  const auto add = [&](const std::string& text) {
    XXH3_128bits_update(state.get(), text.data(), text.size());
  };
  // The chains belong to the input: they decide where a scene starts from.
  add(fmt::format("{} {} {}\n", file.num_scenes(),
                  file.axes().empty() ? 1 : file.axes().back().count,
                  file.warm_start()));
  if (file.keeps_tracks()) add("tracks\n");
  if (!file.problem(0).design.empty()) add(design_of(file));
  for (std::size_t scene = 0; scene < file.num_scenes(); ++scene) {
    const io::ProblemFile problem = file.problem(scene);
    add(io::effective_lines(problem.scene, problem.options) + "\n");
  }
  const XXH128_hash_t hash = XXH3_128bits_digest(state.get());
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

std::string difference(const io::SweepFile& stored,
                       const io::SweepFile& wanted) {
  if (stored.num_scenes() != wanted.num_scenes()) {
    return fmt::format("it has {} scenes, the problem file means {}",
                       stored.num_scenes(), wanted.num_scenes());
  }
  if (stored.warm_start() != wanted.warm_start()) {
    return "sweep.warm_start differs";
  }
  if (stored.keeps_tracks() != wanted.keeps_tracks()) {
    return "sweep.keep differs";
  }
  if (design_of(stored) != design_of(wanted)) return "the design differs";
  if (std::string points = difference_of_points(stored, wanted);
      !points.empty()) {
    return points;
  }
  for (std::size_t scene = 0; scene < stored.num_scenes(); ++scene) {
    const auto input = [&](const io::SweepFile& file) {
      const io::ProblemFile problem = file.problem(scene);
      return io::effective_input(problem.scene, problem.options).flatten();
    };
    const auto was = input(stored), is = input(wanted);
    if (was == is) continue;
    for (const auto& [pointer, value] : is.items()) {
      if (was.contains(pointer) && was[pointer] == value) continue;
      std::string key = pointer.substr(1);
      std::replace(key.begin(), key.end(), '/', '.');
      return fmt::format(
          "in scene {} it has {} = {}, the problem file {}", scene, key,
          was.contains(pointer) ? was[pointer].dump() : "nothing",
          value.dump());
    }
  }
  return "the scenes are cut into other rows";
}

}  // namespace brachisto::sweep
