// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "support/csv.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace brachisto::benchmarks {

namespace {

/// A field in quotes has its quotes doubled, and no line ends within one.
std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (quoted && line.compare(i, 2, "\"\"") == 0) {
      fields.back() += line[i++];
    } else if (line[i] == '"') {
      quoted = !quoted;
    } else if (line[i] == ',' && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += line[i];
    }
  }
  return fields;
}

}  // namespace

std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\n") == std::string_view::npos) {
    return std::string(text);
  }
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c == '\n' ? ' ' : c;
  }
  return quoted + '"';
}

const std::string& CsvRow::text(const std::string& column) const {
  const auto found = fields_.find(column);
  if (found == fields_.end()) {
    throw std::runtime_error("there is no column " + column);
  }
  return found->second;
}

double CsvRow::number(const std::string& column) const {
  const std::string& field = text(column);
  char* end = nullptr;
  const double value = std::strtod(field.c_str(), &end);
  if (*end != '\0') {
    throw std::runtime_error(
        fmt::format("{} is no number: \"{}\"", column, field));
  }
  return value;
}

std::vector<CsvRow> read_csv(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line))
    throw std::runtime_error("cannot read " + path);
  const std::vector<std::string> columns = fields_of(line);
  std::vector<CsvRow> rows;
  while (std::getline(file, line)) {
    const std::vector<std::string> fields = fields_of(line);
    if (fields.size() != columns.size()) {
      throw std::runtime_error(fmt::format("{}:{}: {} fields, but {} columns",
                                           path, rows.size() + 2, fields.size(),
                                           columns.size()));
    }
    std::map<std::string, std::string> row;
    for (std::size_t i = 0; i < fields.size(); ++i) row[columns[i]] = fields[i];
    rows.emplace_back(std::move(row));
  }
  return rows;
}

}  // namespace brachisto::benchmarks
