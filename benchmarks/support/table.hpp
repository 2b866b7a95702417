// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Tables for people, in Markdown.

#pragma once

#include <string>
#include <vector>

namespace brachisto::benchmarks {

/// A table with aligned columns that is Markdown at the same time.
class Table {
 public:
  explicit Table(std::vector<std::string> head) : rows_{std::move(head)} {}
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  [[nodiscard]] bool empty() const { return rows_.size() == 1; }
  [[nodiscard]] std::string markdown() const;

 private:
  std::vector<std::vector<std::string>> rows_;  // the head first
};

/// The q-quantile, 0 ≤ q ≤ 1, nearest rank; NaN without values.
[[nodiscard]] double quantile(std::vector<double> values, double q);

/// Processor, compiler and versions in one line, for the foot of a table.
[[nodiscard]] std::string machine();

/// \throws std::runtime_error if the file cannot be written
void write_file(const std::string& path, const std::string& content);

}  // namespace brachisto::benchmarks
