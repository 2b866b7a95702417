// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Measured times.

#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "trajectory/prescribed_motion.hpp"

namespace brachisto::fit {

/// Most rows that are read, and the longest file [bytes].
inline constexpr std::size_t kMostRows = 100'000;
inline constexpr std::size_t kMaxMeasurementsSize = std::size_t{1} << 24U;

/// A row of a file of times.
struct MeasuredRow {
  int line = 0;
  double place = 0.0;           ///< s or x [m]
  double t = 0.0;               ///< [s]
  std::optional<double> sigma;  ///< standard deviation of t [s]
};

/// A file of times.
struct Measurements {
  std::string file;
  bool by_x = false;  ///< places are those of the centre in x, not lengths s
  std::vector<MeasuredRow> rows;

  [[nodiscard]] bool has_sigma() const {
    return !rows.empty() && rows.front().sigma.has_value();
  }
};

/// Reads a CSV file whose first line names the columns `s` or `x`, `t` and, if
/// there is one, `sigma`, in any order.
/// \throws io::IoError     if it cannot be read
/// \throws io::InputError  with the first mistake
[[nodiscard]] Measurements read_measurements(const std::filesystem::path& path);
/// The same from memory; `name` stands for the file in messages.
[[nodiscard]] Measurements read_measurements_text(std::string_view text,
                                                  const std::string& name);

/// A time at a place of a path.
struct TimedPlace {
  double q = 0.0;
  double s = 0.0;      ///< [m]
  double t = 0.0;      ///< [s]
  double sigma = 1.0;  ///< [s]; 1 for all where none is known
};

/// Where the rows lie on the path of a motion, which they have to follow.
/// \throws io::InputError  with the first row that lies beyond the path, before
///                         the row above it, in place or in time, or, by x, at
///                         an x that the path passes more than once
[[nodiscard]] std::vector<TimedPlace> places_of(
    const Measurements& measurements, const PrescribedMotion& motion);

}  // namespace brachisto::fit
