// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Recorded runs, read again.

#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace brachisto::benchmarks {

/// A field of a CSV file, in quotes where it has to be.
[[nodiscard]] std::string csv_field(std::string_view text);

/// One row by the names of its columns.
class CsvRow {
 public:
  explicit CsvRow(std::map<std::string, std::string> fields)
      : fields_(std::move(fields)) {}

  /// \throws std::runtime_error if there is no such column
  [[nodiscard]] const std::string& text(const std::string& column) const;
  /// 0 if the field is empty. \throws std::runtime_error if it is no number
  [[nodiscard]] double number(const std::string& column) const;
  [[nodiscard]] int integer(const std::string& column) const {
    return static_cast<int>(number(column));
  }

 private:
  std::map<std::string, std::string> fields_;
};

/// The rows of a file whose first one names the columns.
/// \throws std::runtime_error if it cannot be read or a row has more or fewer
/// fields than the first
[[nodiscard]] std::vector<CsvRow> read_csv(const std::string& path);

}  // namespace brachisto::benchmarks
