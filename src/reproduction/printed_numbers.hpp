// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What the paper prints, beside what is found.

#pragma once

#include <string>
#include <vector>

#include "report/scale.hpp"
#include "reproduction/results.hpp"

namespace brachisto::reproduction {

using report::with_minus_signs;

/// Transit times as the paper prints them.
namespace printed {
inline constexpr const char* kBead = "4.52";
inline constexpr const char* kUniform = "5.12";
inline constexpr const char* kOffCentred = "4.99";  // also for n = 50, 100, 200
inline constexpr const char* kOffCentredCoarse = "4.97";  // n = 25
inline constexpr const char* kShort = "3.96";             // L = 2
inline constexpr const char* kLong = "6.26";              // L = 4
inline constexpr const char* kFast = "4.06";
}  // namespace printed

/// A number as the paper prints it, "4.99", and ours. Words are rich text.
struct PrintedNumber {
  std::string place;  ///< in the paper
  std::string quantity;
  std::string paper;  ///< its digits as printed
  Measured ours;
  std::string unit = {};
  std::string remark = {};

  /// Ours − paper.
  [[nodiscard]] double difference() const;
  /// Half a unit of the paper's last digit, and our own error.
  [[nodiscard]] double slack() const;
  [[nodiscard]] bool agrees() const;
};

[[nodiscard]] std::vector<PrintedNumber> printed_numbers(const Results& found);

/// As many digits as are known, and the error: "5.0934444666180(2)".
[[nodiscard]] std::string with_error(const Measured& number);

/// Whether the track bends less than the body everywhere, κ_b < 1/r: the
/// paper's own condition. Sufficient for the track not to fold, not necessary.
[[nodiscard]] bool bends_less_than_body(const Case& one);

/// The number at the beginning of a text, whose minus may be a real one.
[[nodiscard]] double number_in(const std::string& printed);

}  // namespace brachisto::reproduction
