// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/path_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "io/expression.hpp"
#include "io/input_tree.hpp"

namespace brachisto::io {

namespace {

constexpr const char* kFileKey = "scene.path.file";
constexpr const char* kPointsKey = "scene.path.points";

/// Takes the first line off a text, its end included.
std::string_view take_line(std::string_view& text) {
  const std::size_t length = std::min(text.find('\n'), text.size());
  std::string_view line = text.substr(0, length);
  text.remove_prefix(std::min(length + 1, text.size()));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

/// Two numbers with a comma between; nothing if the line is anything else.
std::optional<Point> point_of_line(std::string_view line) {
  const std::size_t comma = line.find(',');
  if (comma == std::string_view::npos) return std::nullopt;
  try {
    return Point{evaluate(line.substr(0, comma)),
                 evaluate(line.substr(comma + 1))};
  } catch (const ExpressionError&) {
    return std::nullopt;
  }
}

/// Why a point cannot follow others; "" if it can.
std::string objection(const std::vector<Point>& points, const Point& point) {
  if (!points.empty() && point == points.back()) {
    return "repeats the point before it";
  }
  return points.size() < kMostPoints
             ? ""
             : fmt::format("is one point too many; {} are allowed",
                           kMostPoints);
}

/// A point [x, z] of a problem file.
std::optional<Point> point_of_item(const YamlValue& item) {
  const auto is_scalar = [](const YamlValue& value) {
    return value.kind == YamlValue::Kind::Scalar;
  };
  if (item.items.size() != 2 || !std::ranges::all_of(item.items, is_scalar)) {
    return std::nullopt;
  }
  try {
    return Point{evaluate(item.items[0].text), evaluate(item.items[1].text)};
  } catch (const ExpressionError&) {
    return std::nullopt;
  }
}

void read_points(Draft& problem, const KeySpec& spec, const YamlValue& list,
                 Findings& findings) {
  std::vector<Point> points;
  std::string mistake;
  Position where = list.position;
  if (list.items.empty()) {
    mistake = fmt::format("{} was read", list.kind == YamlValue::Kind::List
                                             ? "an empty list"
                                             : kind_name(list.kind));
  }
  for (const YamlValue& item : list.items) {
    where = item.position;
    const std::optional<Point> point = point_of_item(item);
    if (!point) {
      mistake = "a point is a list of two numbers";
      break;
    }
    mistake = objection(points, *point);
    if (!mistake.empty()) {
      mistake = fmt::format("[{}, {}] {}", point->x, point->z, mistake);
      break;
    }
    points.push_back(*point);
  }
  if (!mistake.empty()) {
    findings.add(where, std::string(spec.path),
                 fmt::format("{}; expected {} in m", mistake, expected(spec)));
  }
  auto path = std::make_shared<GivenPath>(
      problem.scene.path ? *problem.scene.path : GivenPath{});
  path->points = std::move(points);
  problem.scene.path = std::move(path);
}

Json points_json(const Draft& problem) {
  const auto& path = problem.scene.path;
  if (!path || path->shape != GivenPath::Shape::Points) return {};
  Json list = Json::array();
  for (const Point& point : path->points) list.push_back({point.x, point.z});
  return list;
}

std::vector<Point> points_of_file(const std::filesystem::path& path) {
  const std::string text =
      read_file_bytes(path, kMaxPointsSize, "a CSV file with the columns x,z");
  try {
    return parse_points(text);
  } catch (const PointsError& error) {
    throw PointsError(fmt::format("{}:{}", path.string(), error.what()));
  }
}

}  // namespace

std::vector<Point> parse_points(std::string_view text) {
  if (text.size() > kMaxPointsSize) {
    throw PointsError(
        fmt::format("1: longer than {} bytes, which no {} points "
                    "need",
                    kMaxPointsSize, kMostPoints));
  }
  if (const std::string_view head = take_line(text); head != "x,z") {
    throw PointsError(
        fmt::format("1: {} was read; expected the line x,z", in_quotes(head)));
  }
  std::vector<Point> points;
  for (std::size_t number = 2; !text.empty(); ++number) {
    const std::string_view line = take_line(text);
    if (line.empty()) continue;
    const auto refuse = [&](const std::string& why) {
      throw PointsError(fmt::format("{}: {} {}", number, in_quotes(line), why));
    };
    const std::optional<Point> point = point_of_line(line);
    if (!point) refuse("was read; expected two numbers x,z in m");
    if (const std::string why = objection(points, *point); !why.empty()) {
      refuse(why);
    }
    points.push_back(*point);
  }
  return points;
}

Binding points_list() {
  return {.type = KeyType::List,
          .get = points_json,
          .read_list = read_points,
          .items = [] {
            const Json number = {{"type", {"number", "string"}}};
            return Json{{"type", "array"},
                        {"items", number},
                        {"minItems", 2},
                        {"maxItems", 2}};
          }};
}

void read_path_points(const InputTree& input, const std::vector<Point>* known,
                      Draft& problem, Findings& findings) {
  const auto refuse = [&](const std::string& message) {
    findings.add(position_of(input.root, kFileKey), kFileKey, message);
  };
  if (!problem.scene.path) return;
  const bool listed = find_entry(input.root, kPointsKey) != nullptr;
  if (problem.scene.path->shape != GivenPath::Shape::Points) {
    if (!problem.points_file.empty()) refuse("only shape: points has a file");
    if (listed && !findings.concern("scene.path.shape")) {
      findings.add(position_of(input.root, kPointsKey), kPointsKey,
                   "only shape: points has points");
    }
    return;
  }
  if (listed) {
    if (!problem.points_file.empty()) {
      refuse("the points are given twice; leave out file or points");
    }
    return;
  }
  if (problem.points_file.empty()) {
    refuse("missing; shape: points needs a CSV file with the columns x,z");
    return;
  }
  const std::string& name = input.sources.front();
  try {
    auto given = std::make_shared<GivenPath>(*problem.scene.path);
    given->points =
        known != nullptr
            ? *known
            : points_of_file(std::filesystem::path(name).parent_path() /
                             problem.points_file);
    problem.scene.path = std::move(given);
  } catch (const PointsError& error) {
    refuse(error.what());
  } catch (const IoError& error) {
    throw IoError(fmt::format("{}: {}: {}", name, kFileKey, error.what()));
  }
}

}  // namespace brachisto::io
