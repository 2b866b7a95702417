// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/path_points.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/expression.hpp"

namespace brachisto::io {

namespace {

constexpr const char* kFileKey = "scene.path.file";
constexpr std::size_t kMostPoints = 100'000;

std::string without_end(std::string line) {
  if (!line.empty() && line.back() == '\r') line.pop_back();
  return line;
}

/// Two numbers with a comma between; nothing if the line is anything else.
std::optional<Point> point_of_line(const std::string& line) {
  const std::size_t comma = line.find(',');
  if (comma == std::string::npos) return std::nullopt;
  try {
    return Point{evaluate(line.substr(0, comma)),
                 evaluate(line.substr(comma + 1))};
  } catch (const ExpressionError&) {
    return std::nullopt;
  }
}

}  // namespace

void read_path_points(const InputTree& input, ProblemFile& problem,
                      Findings& findings) {
  if (!problem.scene.path ||
      problem.scene.path->shape != GivenPath::Shape::Points) {
    return;
  }
  const auto refuse = [&](const std::string& message) {
    findings.add(position_of(input.root, kFileKey), kFileKey, message);
  };
  if (problem.points_file.empty()) {
    refuse("missing; shape: points needs a CSV file with the columns x,z");
    return;
  }
  namespace fs = std::filesystem;
  const fs::path path =
      fs::path(input.sources.front()).parent_path() / problem.points_file;
  std::ifstream file(path);
  std::error_code ignored;
  if (!file || fs::is_directory(path, ignored)) {
    refuse(fmt::format("{} cannot be read", in_quotes(path.string())));
    return;
  }
  std::string line;
  std::size_t number = 1;
  std::getline(file, line);
  if (without_end(line) != "x,z") {
    refuse(fmt::format("{}:1: {} was read; expected the line x,z",
                       path.string(), in_quotes(without_end(line))));
    return;
  }
  auto given = std::make_shared<GivenPath>(*problem.scene.path);
  std::vector<Point>& points = given->points;
  while (std::getline(file, line)) {
    ++number;
    line = without_end(line);
    if (line.empty()) continue;
    const std::optional<Point> point = point_of_line(line);
    const bool repeated = point && !points.empty() &&
                          point->x == points.back().x &&
                          point->z == points.back().z;
    if (!point || repeated || points.size() == kMostPoints) {
      refuse(fmt::format("{}:{}: {} {}", path.string(), number, in_quotes(line),
                         !point     ? "was read; expected two numbers x,z in m"
                         : repeated ? "repeats the point before it"
                                    : "is one point too many; 100000 are "
                                      "allowed"));
      return;
    }
    points.push_back(*point);
  }
  problem.scene.path = std::move(given);
}

}  // namespace brachisto::io
