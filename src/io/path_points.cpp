// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/path_points.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "io/expression.hpp"
#include "io/input_tree.hpp"
#include "io/item_reader.hpp"
#include "io/lists.hpp"
#include "io/text_lines.hpp"
#include "io/visible_text.hpp"

namespace brachisto::io {

namespace {

constexpr const char* kFileKey = "scene.path.file";
constexpr const char* kPointsKey = "scene.path.points";

constexpr std::string_view kPointOfLine = "two numbers x,z in m";

/// Two numbers with a comma between.
/// \param number  of the line
/// \throws PointsError
Point point_of_line(std::string_view line, std::size_t number) {
  const std::size_t comma = line.find(',');
  if (comma == std::string_view::npos) {
    throw PointsError(fmt::format("{}:1: {} was read; expected {}", number,
                                  in_quotes(line), kPointOfLine));
  }
  const auto value = [&](std::size_t from, std::size_t length) {
    const std::string_view text = line.substr(from, length);
    try {
      return evaluate(text);
    } catch (const ExpressionError& error) {
      throw PointsError(fmt::format("{}:{}: {}", number, from + 1,
                                    not_a_number(text, error, kPointOfLine)));
    }
  };
  const double x = value(0, comma);
  return {x, value(comma + 1, std::string_view::npos)};
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

Objection put_points(Draft& problem, const Json& list, Binding::Row) {
  auto path = std::make_shared<GivenPath>(
      problem.scene.path ? *problem.scene.path : GivenPath{});
  path->points.clear();
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Point point{list[i][0], list[i][1]};
    if (const std::string why = objection(path->points, point); !why.empty()) {
      problem.scene.path = std::move(path);  // as far as it is one
      return {fmt::format("[{}, {}] {}", point.x, point.z, why), i};
    }
    path->points.push_back(point);
  }
  problem.scene.path = std::move(path);
  return {};
}

Json points_json(const Draft& problem, Binding::Row) {
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
        fmt::format("1:1: longer than {} bytes, which no {} points "
                    "need",
                    kMaxPointsSize, kMostPoints));
  }
  text = without_byte_order_mark(text);
  if (const std::string_view head = take_line(text); head != "x,z") {
    throw PointsError(fmt::format("1:1: {} was read; expected the line x,z",
                                  in_quotes(head)));
  }
  std::vector<Point> points;
  for (std::size_t number = 2; !text.empty(); ++number) {
    const std::string_view line = take_line(text);
    if (line.empty()) continue;
    const Point point = point_of_line(line, number);
    if (const std::string why = objection(points, point); !why.empty()) {
      throw PointsError(
          fmt::format("{}:1: {} {}", number, in_quotes(line), why));
    }
    points.push_back(point);
  }
  return points;
}

Binding points_list() {
  KeySpec point = list_item("", number_item("", KeyType::Number),
                            {.bounds = "a point [x, z], two numbers in m"});
  point.value.count = 2;
  return {.type = KeyType::List,
          .echo = points_json,
          .silent = true,
          .put_list = put_points,
          .items = {std::move(point)}};
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
    const auto [source, line, column] = position_of(input.root, kFileKey);
    throw IoError(
        to_string({input.sources.at(static_cast<std::size_t>(source)),
                   source == 0 ? line : 0, source == 0 ? column : 0, kFileKey,
                   fmt::format("{}; the points may also stand in {}",
                               error.what(), kPointsKey)}));
  }
}

}  // namespace brachisto::io
