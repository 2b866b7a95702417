// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "sweep/job.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "brachisto/report/result_json.hpp"
#include "io/input_tree.hpp"

namespace brachisto::sweep {

namespace {

using nlohmann::json;

std::string effective_input(const io::SweepFile& file, std::size_t scene) {
  const io::ProblemFile problem = file.problem(scene);
  return report::input_json(problem.scene, problem.options);
}

}  // namespace

Job read_job(const std::filesystem::path& path,
             const std::vector<std::string>& overrides) {
  std::string text = io::read_bytes(path);
  io::SweepFile file = io::read_sweep_text(text, path.string(), overrides);
  return {path.string(), std::move(text), overrides, std::move(file)};
}

std::string to_line(const Job& job) {
  return json{{"name", job.name},
              {"text", job.text},
              {"overrides", job.overrides}}
             .dump() +
         "\n";
}

Job job_from_line(const std::string& line) {
  const json document = json::parse(line);
  const std::string name = document.at("name");
  const std::string text = document.at("text");
  const std::vector<std::string> overrides = document.at("overrides");
  return {name, text, overrides, io::read_sweep_text(text, name, overrides)};
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
  for (std::size_t scene = 0; scene < file.num_scenes(); ++scene) {
    add(effective_input(file, scene));
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
  for (std::size_t scene = 0; scene < stored.num_scenes(); ++scene) {
    const json was = json::parse(effective_input(stored, scene)).flatten();
    const json is = json::parse(effective_input(wanted, scene)).flatten();
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
