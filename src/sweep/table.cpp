// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "sweep/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "brachisto/report/result.hpp"
#include "report/csv.hpp"
#include "report/text_table.hpp"
#include "sweep/lanes.hpp"
#include "sweep/outcome.hpp"

namespace brachisto::sweep {

namespace {

using Json = nlohmann::ordered_json;

/// Figures of a result document that stand in a flat table, as JSON pointers.
constexpr const char* kGripAfter1 = "/grip/least_after/1/mu";
constexpr const char* kGripAfter5 = "/grip/least_after/2/mu";
constexpr const char* kFigures[] = {
    "/status",
    "/verified",
    "/feasible",
    "/tau",
    "/transit_time",
    "/estimated_error",
    "/centre_path_length",
    "/rail_length",
    "/start_angle",
    "/end_angle",
    "/rotation",
    "/normal_force/min",
    "/normal_force/min_after_rise",
    "/normal_force/max",
    "/normal_force/x_at_max",
    "/friction/share_above_0.3",
    "/friction/share_above_0.5",
    "/friction/share_above_1",
    kGripAfter1,
    kGripAfter5,
    "/curvature/min",
    "/curvature/min_after_rise",
    "/curvature/max",
    "/fold_margin",
    "/nodes",
    "/iterations",
    "/newton_steps",
    "/seconds/total",
    "/message",
};

/// And of a sweep that asks for derivatives of the time.
constexpr const char* kSlopes[] = {
    "/sensitivities/eta_m/tau", "/sensitivities/theta_m/tau",
    "/sensitivities/k/tau",     "/sensitivities/radius/tau",
    "/sensitivities/L/tau",     "/sensitivities/H/tau",
};

std::vector<const char*> figures_of(const io::SweepFile& file) {
  std::vector<const char*> figures(std::begin(kFigures), std::end(kFigures));
  const bool swept =
      std::ranges::any_of(file.keys(), [](const io::SweepKey& key) {
        return key.path == "solver.sensitivities";
      });
  const bool asked =
      file.num_scenes() > 0 &&
      file.problem(0).options.or_default<Collocation>().sensitivities !=
          SensitivityOrder::None;
  if (swept || asked) {
    figures.insert(figures.end(), std::begin(kSlopes), std::end(kSlopes));
  }
  if (asks_for_lanes(file)) figures.push_back("/engine");
  return figures;
}

std::string column_name(const std::string& pointer) {
  // Of an item of a list the place tells nothing.
  if (pointer == kGripAfter1) return "grip.mu_after_1_percent";
  if (pointer == kGripAfter5) return "grip.mu_after_5_percent";
  std::string name = pointer.substr(1);
  std::replace(name.begin(), name.end(), '/', '.');
  return name;
}

Json to_json(const io::SweepValue& value) {
  return std::visit([](const auto& v) { return Json(v); }, value);
}

std::vector<std::string> column_names(const io::SweepFile& file) {
  std::vector<std::string> names{"scene"};
  for (const io::SweepKey& key : file.keys()) names.push_back(key.path);
  for (const char* figure : figures_of(file)) {
    names.push_back(column_name(figure));
  }
  return names;
}

using RowVisitor = std::function<void(const std::vector<Json>&)>;

std::size_t for_each_row(Store& store, const io::SweepFile& file,
                         const RowVisitor& visit) {
  const std::vector<const char*> figures = figures_of(file);
  return store.for_each_result(
      [&](std::size_t scene, const std::string& document) {
        const Json result = Json::parse(document);
        std::vector<Json> row{scene};
        for (const io::SweepValue& value : file.values(scene)) {
          row.push_back(to_json(value));
        }
        for (const char* figure : figures) {
          const Json::json_pointer pointer(figure);
          row.push_back(result.contains(pointer) ? result[pointer] : Json());
        }
        visit(row);
      });
}

std::string field(const Json& value) {
  if (value.is_null()) return "";
  if (value.is_number()) return value.dump();
  return report::csv_field(
      value.is_string() ? value.get_ref<const std::string&>() : value.dump());
}

/// What τ depends on besides the keys of the sweep. Outside of its section no
/// key follows another one, so that one scene tells for all.
std::vector<SweepConstant> constants(const io::SweepFile& file) {
  const Scene scene = file.problem(0).scene;
  std::vector<SweepConstant> out;
  if (scene.body.rolls()) {
    const Body body = as_stated(scene.body);
    out = {{"scene.body.radius", body.radius},
           {"scene.body.eta_m", body.eta_m},
           {"scene.body.theta_m", body.theta_m},
           {"scene.body.k", body.k}};
  }
  out.push_back({"scene.finish.L", scene.L});
  out.push_back({"scene.finish.H", scene.H});
  std::erase_if(out, [&](const SweepConstant& constant) {
    return std::ranges::any_of(file.keys(), [&](const io::SweepKey& key) {
      return key.path == constant.key;
    });
  });
  return out;
}

/// The columns and axes of a sweep, no scene run yet.
SweepTable empty_table(const Job& job) {
  const io::SweepFile& file = job.file;
  SweepTable table;
  table.title = job.name;
  table.outcomes.resize(file.num_scenes());
  for (const io::SweepKey& key : file.keys()) {
    table.columns.push_back({.key = key.path});
  }
  for (std::size_t scene = 0; scene < file.num_scenes(); ++scene) {
    const std::vector<io::SweepValue> values = file.values(scene);
    for (std::size_t c = 0; c < values.size(); ++c) {
      SweepColumn& column = table.columns[c];
      if (file.keys()[c].numeric) {
        column.numbers.push_back(std::get<double>(values[c]));
      } else {
        column.words.push_back(std::get<std::string>(values[c]));
      }
    }
  }
  for (const io::SweepFileAxis& axis : file.axes()) {
    table.axes.push_back(
        {.columns = axis.keys, .count = axis.count, .ordered = axis.ordered});
  }
  if (file.num_scenes() > 0) table.constants = constants(file);
  return table;
}

}  // namespace

SweepTable read_table(Store& store, const Job& job) {
  SweepTable table = empty_table(job);
  store.for_each_result([&](std::size_t scene, const std::string& document) {
    table.outcomes.at(scene) = read_outcome(document);
  });
  return table;
}

std::vector<plot::SweepTrack> read_tracks(Store& store, const Job& job) {
  std::vector<plot::SweepTrack> tracks;
  if (!job.file.keeps_tracks()) return tracks;
  store.for_each_result([&](std::size_t scene, const std::string& document) {
    Json result = Json::parse(document);
    if (!result.contains("track")) return;
    tracks.push_back(
        {scene, job.file.problem(scene).scene, std::move(result["track"])});
  });
  return tracks;
}

ExportedTable export_csv(Store& store, const Job& job) {
  std::string text = report::csv_row(column_names(job.file), report::csv_field);
  const std::size_t rows =
      for_each_row(store, job.file, [&](const std::vector<Json>& row) {
        text += report::csv_row(row, field);
      });
  return {std::move(text), rows};
}

ExportedTable export_markdown(Store& store, const Job& job) {
  const auto cell = [](const Json& value) {
    if (value.is_null()) return std::string("—");
    if (value.is_string()) return value.get<std::string>();
    return value.is_number_float() ? fmt::format("{:.10g}", value.get<double>())
                                   : value.dump();
  };
  report::Rows table{column_names(job.file)};
  const std::size_t rows =
      for_each_row(store, job.file, [&](const std::vector<Json>& row) {
        std::ranges::transform(row, std::back_inserter(table.emplace_back()),
                               cell);
      });
  return {report::markdown_table(table), rows};
}

ExportedTable export_json(Store& store, const Job& job) {
  const std::vector<std::string> names = column_names(job.file);
  Json rows = Json::array();
  const std::size_t count =
      for_each_row(store, job.file, [&](const std::vector<Json>& row) {
        Json object;
        for (std::size_t c = 0; c < row.size(); ++c) object[names[c]] = row[c];
        rows.push_back(std::move(object));
      });
  const Json document = {{"schema_version", report::kSchemaVersion},
                         {"scenes", job.file.num_scenes()},
                         {"finished", count},
                         {"damaged", store.damage().scenes},
                         {"rows", std::move(rows)}};
  return {document.dump(1, ' ', false, Json::error_handler_t::replace) + "\n",
          count};
}

}  // namespace brachisto::sweep
