// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto validate FILE: reads a problem file and says what it means.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/exit_code.hpp"
#include "app/solution_output.hpp"
#include "app/terminal.hpp"
#include "app/verbs.hpp"
#include "brachisto/io/problem_file.hpp"
#include "brachisto/report/result.hpp"
#include "io/effective_input.hpp"
#include "io/visible_text.hpp"
#include "report/text_table.hpp"
#include "study/size.hpp"

namespace brachisto::app {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kShownAtEachEnd = 3;

Json effective_input(const io::ProblemFile& problem) {
  Json json = Json::parse(report::input_json(problem.scene, problem.options));
  if (!problem.design.parts.empty()) {
    // In the place of what follows from them, or the file would be another.
    Json& body = json["scene"]["body"];
    for (const char* const key : {"eta_m", "theta_m", "k"}) body.erase(key);
    for (const MassPart& part : problem.design.parts) {
      body["parts"].push_back(part.name);
    }
  }
  for (const char* const section : {"work_precision", "design"}) {
    const Json plan = io::effective_section(problem, section);
    if (plan != io::effective_section({}, section)) json[section] = plan;
  }
  return json;
}

/// Paths of the keys that run along an axis.
std::vector<std::string> paths_of(const io::SweepFile& sweep,
                                  const io::SweepFileAxis& axis) {
  std::vector<std::string> paths;
  for (const std::size_t key : axis.keys) {
    paths.push_back(sweep.keys()[key].path);
  }
  return paths;
}

/// The first and the last scene along an axis that start at scene 0.
std::pair<std::size_t, std::size_t> ends_of(const io::SweepFile& sweep,
                                            std::size_t axis) {
  std::size_t stride = 1;
  for (std::size_t i = axis + 1; i < sweep.axes().size(); ++i) {
    stride *= sweep.axes()[i].count;
  }
  return {0, (sweep.axes()[axis].count - 1) * stride};
}

/// The values of some keys in a scene, by path.
Json values_json(const io::SweepFile& sweep, std::size_t scene,
                 const std::vector<std::string>& paths) {
  Json values = Json::object();
  const std::vector<io::SweepValue> all = sweep.values(scene);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string& path = sweep.keys()[i].path;
    if (std::ranges::count(paths, path) == 0) continue;
    std::visit([&](const auto& value) { values[path] = value; }, all[i]);
  }
  return values;
}

std::string sweep_json(const io::SweepFile& sweep) {
  std::vector<std::string> paths;
  for (const io::SweepKey& key : sweep.keys()) paths.push_back(key.path);
  Json axes = Json::array();
  for (std::size_t i = 0; i < sweep.axes().size(); ++i) {
    const io::SweepFileAxis& axis = sweep.axes()[i];
    const auto along = paths_of(sweep, axis);
    const auto [first, last] = ends_of(sweep, i);
    axes.push_back({{"keys", along},
                    {"count", axis.count},
                    {"ordered", axis.ordered},
                    {"first", values_json(sweep, first, along)},
                    {"last", values_json(sweep, last, along)}});
  }
  const std::size_t last = sweep.num_scenes() - 1;
  Json json = {{"schema_version", report::kSchemaVersion},
               {"valid", true},
               {"sweep",
                {{"scenes", sweep.num_scenes()},
                 {"warm_start", sweep.warm_start()},
                 {"keep", sweep.keeps_tracks() ? "tracks" : "nothing"},
                 {"keys", paths},
                 {"axes", axes},
                 {"first", values_json(sweep, 0, paths)},
                 {"last", values_json(sweep, last, paths)}}}};
  // The first scene follows with the keys that a single problem has.
  json.update(effective_input(sweep.problem(0)));
  json["input"] = Json::parse(sweep.stated());
  return json_text(json);
}

std::string text_of(const io::SweepValue& value) {
  const double* number = std::get_if<double>(&value);
  return number != nullptr ? fmt::format("{:.10g}", *number)
                           : io::visible(std::get<std::string>(value));
}

std::string axes_table(const io::SweepFile& sweep) {
  report::Rows rows{{"axis", "values", "first", "last"}};
  for (std::size_t i = 0; i < sweep.axes().size(); ++i) {
    const io::SweepFileAxis& axis = sweep.axes()[i];
    const auto [first, last] = ends_of(sweep, i);
    for (const std::size_t key : axis.keys) {
      rows.push_back(
          {sweep.keys()[key].path,
           fmt::format("{}{}", axis.count, axis.ordered ? "" : " (random)"),
           text_of(sweep.values(first)[key]),
           text_of(sweep.values(last)[key])});
    }
  }
  return report::text_table(rows);
}

std::string scenes_table(const io::SweepFile& sweep) {
  report::Rows rows{{"scene"}};
  for (const io::SweepKey& key : sweep.keys()) rows[0].push_back(key.path);
  const std::size_t scenes = sweep.num_scenes();
  for (std::size_t scene = 0; scene < scenes; ++scene) {
    if (scene == kShownAtEachEnd && scenes > 2 * kShownAtEachEnd) {
      rows.emplace_back(rows[0].size(), "...");
      scene = scenes - kShownAtEachEnd;
    }
    rows.push_back({fmt::format("{}", scene)});
    for (const io::SweepValue& value : sweep.values(scene)) {
      rows.back().push_back(text_of(value));
    }
  }
  return report::text_table(rows);
}

Json forecast_json(const Forecast& size) {
  return {{"nodes", size.nodes},
          {"memory_bytes", size.bytes},
          {"seconds", size.seconds}};
}

/// \return the exit code
int describe(const CommonFlags& flags, const io::ProblemFile& problem) {
  const std::optional<Forecast> size = forecast(problem.scene, problem.options);
  const std::optional<Outcome> refused =
      size ? too_large(*size, problem.options.limits.seconds) : std::nullopt;
  warn_of(problem);
  Json input = effective_input(problem);
  if (flags.json) {
    if (size) input["forecast"] = forecast_json(*size);
    print_json(input);
  } else if (!flags.quiet) {
    print(fmt::format("{}: valid. Effective input, defaults filled in:\n{}",
                      io::visible(flags.file), json_text(input)));
    if (size) print(fmt::format("To be solved: {}.\n", in_words(*size)));
  }
  if (!refused) return kSuccess;
  tell_error(fmt::format("brachisto: {}\n", refused->message));
  return kLimit;
}

int describe(const CommonFlags& flags, const io::SweepFile& sweep) {
  if (flags.json) {
    print_data(sweep_json(sweep));
  } else if (!flags.quiet) {
    print(fmt::format("{}: valid. A sweep of {} scene{}.\n\n{}\n{}",
                      io::visible(flags.file), sweep.num_scenes(),
                      sweep.num_scenes() == 1 ? "" : "s", axes_table(sweep),
                      scenes_table(sweep)));
  }
  return kSuccess;
}

}  // namespace

Verb validate_verb() {
  const auto flags = std::make_shared<CommonFlags>();
  return {
      .name = "validate",
      .text = "Check a problem file and print its effective input",
      .flags = flags->with({}),
      .footer =
          R"(Of a file with a section sweep, all scenes are checked and some listed.
Examples:
  brachisto validate case.yaml
  brachisto validate case.yaml --set scene.body.k=1/4 --json
Exit codes: 0 valid, 3 bad input file, 6 I/O, 7 valid, but solve would
not begin: there is not the memory, or by far not the time.)",
      .run = [flags] {
        const auto content =
            io::read_problem_or_sweep_file(flags->file, flags->overrides);
        return std::visit(
            [&](const auto& what) { return describe(*flags, what); }, content);
      }};
}

}  // namespace brachisto::app
