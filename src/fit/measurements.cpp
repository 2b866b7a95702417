// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "fit/measurements.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "brachisto/io/problem_file.hpp"
#include "io/expression.hpp"
#include "io/input_tree.hpp"
#include "io/item_reader.hpp"
#include "io/text_lines.hpp"
#include "io/visible_text.hpp"
#include "math/roots.hpp"

namespace brachisto::fit {

namespace {

constexpr std::string_view kS = "s", kX = "x", kT = "t", kSigma = "sigma";
constexpr std::array kColumns{kS, kX, kT, kSigma};
constexpr std::string_view kBlanks = " \t";
constexpr std::string_view kHead =
    "a line with the columns s or x, t and, if "
    "known, sigma, as in s,t,sigma";

std::string_view unit_of(std::string_view column) {
  return column == kS || column == kX ? "m" : "s";
}

[[noreturn]] void refuse(const std::string& file, int line, int column,
                         std::string_view key, const std::string& message) {
  throw io::InputError({{file, line, column, std::string(key), message}});
}

/// A cell and where it begins.
struct Cell {
  std::string_view text;
  std::size_t column;  ///< from 1
};

std::vector<Cell> cells_of(std::string_view line) {
  std::vector<Cell> cells;
  for (std::size_t from = 0;;) {
    const std::size_t comma = line.find(',', from);
    cells.push_back({line.substr(from, comma - from), from + 1});
    if (comma == std::string_view::npos) return cells;
    from = comma + 1;
  }
}

/// The columns that a first line names.
std::vector<std::string_view> columns_of(std::string_view line,
                                         const std::string& file) {
  std::vector<std::string_view> columns;
  for (const Cell& cell : cells_of(line)) {
    const std::string_view name = io::trimmed(cell.text, kBlanks);
    const int column = static_cast<int>(cell.column);
    if (std::ranges::find(kColumns, name) == kColumns.end()) {
      refuse(file, 1, column, "", io::unknown_word(name, kHead, kColumns));
    }
    if (std::ranges::find(columns, name) != columns.end()) {
      refuse(file, 1, column, "",
             fmt::format("{} is named twice; expected {}", io::in_quotes(name),
                         kHead));
    }
    columns.push_back(name);
  }
  const auto has = [&](std::string_view name) {
    return std::ranges::find(columns, name) != columns.end();
  };
  if (!has(kT) || has(kS) == has(kX)) {
    refuse(file, 1, 1, "",
           fmt::format("{}; expected {}",
                       !has(kT)  ? "there is no column t"
                       : has(kS) ? "there are both columns s and x"
                                 : "there is no column s or x",
                       kHead));
  }
  return columns;
}

MeasuredRow row_of(std::string_view line, int number,
                   const std::vector<std::string_view>& columns,
                   const std::string& file) {
  const std::vector<Cell> cells = cells_of(line);
  if (cells.size() != columns.size()) {
    refuse(
        file, number, 1, "",
        fmt::format("{} was read; expected {} numbers {}", io::in_quotes(line),
                    columns.size(), fmt::join(columns, ",")));
  }
  MeasuredRow row;
  row.line = number;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::string_view name = columns[i];
    const int column = static_cast<int>(cells[i].column);
    double value = 0.0;
    try {
      value = io::evaluate(cells[i].text);
    } catch (const io::ExpressionError& error) {
      refuse(file, number, column, name,
             io::not_a_number(cells[i].text, error,
                              fmt::format("a number in {}", unit_of(name))));
    }
    if (name == kT) {
      row.t = value;
    } else if (name == kSigma) {
      // Times count by its inverse square.
      constexpr double kLeast = 1e-12, kMost = 1e12;
      if (!(value >= kLeast && value <= kMost)) {
        refuse(file, number, column, name,
               fmt::format("{:g} was read; expected a number in s from {:g} to "
                           "{:g}",
                           value, kLeast, kMost));
      }
      row.sigma = value;
    } else {
      row.place = value;
    }
  }
  return row;
}

/// The place q of an x, between the rows of a sample of the path.
class PlaceByX {
 public:
  explicit PlaceByX(const PrescribedMotion& motion)
      : motion_(motion), sample_(motion.fine_sample(1000)) {}

  /// All of them.
  [[nodiscard]] std::vector<double> places(double x) const {
    std::vector<double> found;
    for (std::size_t i = 1; i < sample_.size(); ++i) {
      const double before = sample_[i - 1].centre.x - x;
      const double after = sample_[i].centre.x - x;
      if (after == 0.0) {
        found.push_back(sample_[i].sigma);
      } else if (before * after < 0.0) {
        found.push_back(math::find_root(
            [&](double q) {
              return point_of(motion_.curve(), motion_.curve().at(q)).x - x;
            },
            sample_[i - 1].sigma, sample_[i].sigma, before, after));
      }
    }
    if (sample_.front().centre.x == x) found.push_back(0.0);
    return found;
  }
  /// x at both ends.
  [[nodiscard]] double first() const { return sample_.front().centre.x; }
  [[nodiscard]] double last() const { return sample_.back().centre.x; }

 private:
  const PrescribedMotion& motion_;
  std::vector<TrajectoryPoint> sample_;
};

}  // namespace

Measurements read_measurements_text(std::string_view text,
                                    const std::string& name) {
  Measurements out;
  out.file = name;
  text = io::without_byte_order_mark(text);
  const std::vector<std::string_view> columns =
      columns_of(io::take_line(text), name);
  out.by_x = std::ranges::find(columns, kX) != columns.end();
  for (int number = 2; !text.empty(); ++number) {
    const std::string_view line = io::take_line(text);
    if (io::trimmed(line, kBlanks).empty()) continue;
    if (out.rows.size() == kMostRows) {
      refuse(name, number, 1, "",
             fmt::format("one row too many; {} are allowed", kMostRows));
    }
    out.rows.push_back(row_of(line, number, columns, name));
  }
  return out;
}

Measurements read_measurements(const std::filesystem::path& path) {
  const std::string text = io::read_file_bytes(
      path, kMaxMeasurementsSize, "a CSV file with the columns s,t,sigma");
  if (text.size() > kMaxMeasurementsSize) {
    refuse(path.string(), 1, 1, "",
           fmt::format("longer than {} bytes, which no {} rows need",
                       kMaxMeasurementsSize, kMostRows));
  }
  return read_measurements_text(text, path.string());
}

std::vector<TimedPlace> places_of(const Measurements& measurements,
                                  const PrescribedMotion& motion) {
  const double S = motion.centre_path_length();
  const std::string_view column = measurements.by_x ? kX : kS;
  // As far as points of a path may miss A and B.
  const double slack = kCloseToEnds * S;
  std::optional<PlaceByX> by_x;
  if (measurements.by_x) by_x.emplace(motion);
  std::vector<TimedPlace> out;
  double least = -std::numeric_limits<double>::infinity();
  double least_here = least;  // of the times at the last place
  for (const MeasuredRow& row : measurements.rows) {
    const auto reject = [&](const std::string& message) {
      refuse(measurements.file, row.line, 1, "", message);
    };
    TimedPlace place{.t = row.t, .sigma = row.sigma.value_or(1.0)};
    if (by_x) {
      const auto [low, high] = std::minmax({by_x->first(), by_x->last()});
      const bool close = row.place >= low - slack && row.place <= high + slack;
      const double x = close ? std::clamp(row.place, low, high) : row.place;
      const std::vector<double> places = by_x->places(x);
      if (places.empty()) {
        reject(
            fmt::format("x = {:.9g} m lies beyond the path of the centre, "
                        "which leads from x = {:.9g} to {:.9g} m",
                        row.place, by_x->first(), by_x->last()));
      }
      if (places.size() > 1) {
        reject(
            fmt::format("the centre passes x = {:.9g} m {} times; give its "
                        "place by s",
                        row.place, places.size()));
      }
      place.q = places.front();
      place.s = motion.at(place.q).s;
    } else {
      if (!(row.place >= -slack && row.place <= S + slack)) {
        reject(
            fmt::format("s = {:.9g} m lies beyond the path of the centre, "
                        "which is {:.9g} m long",
                        row.place, S));
      }
      place.s = std::clamp(row.place, 0.0, S);
      place.q = motion.place_at_length(place.s);
    }
    if (!out.empty() && place.q < out.back().q) {
      reject(
          fmt::format("{} = {:.9g} m lies before that of the row above; "
                      "expected rows along the path",
                      column, row.place));
    }
    if (out.empty() || place.q > out.back().q) {
      least = std::exchange(least_here, row.t);
    } else {
      least_here = std::min(least_here, row.t);
    }
    if (!(row.t > least)) {
      reject(
          fmt::format("t = {:.9g} s is not after t = {:.9g} s of the place "
                      "before; expected times that ascend along the path",
                      row.t, least));
    }
    out.push_back(place);
  }
  return out;
}

}  // namespace brachisto::fit
