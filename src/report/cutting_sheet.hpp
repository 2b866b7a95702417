// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Sheets of material: words above, a ruler below, and parts between.

#pragma once

#include <string>
#include <vector>

#include "report/cutting_build.hpp"
#include "report/cutting_drawing.hpp"
#include "report/cutting_parts.hpp"
#include "report/path_frame.hpp"

namespace brachisto::report::cutting {

/// What all sheets of a build have in common.
class SheetFrame {
 public:
  static constexpr double kLetter = 3.5, kLine = 5.25;  ///< of words [mm]

  /// \param facts  paragraphs, broken into lines as wide as the sheet
  SheetFrame(const Build& build, const std::vector<std::string>& facts);

  /// Where parts may be [mm].
  [[nodiscard]] const Box& room() const { return room_; }
  [[nodiscard]] bool fits(const Box& box) const;
  /// A sheet with its words and a ruler of 100 mm, else empty.
  [[nodiscard]] Drawing sheet(const std::string& name,
                              const std::string& title) const;

 private:
  double width_, height_;
  std::vector<std::string> lines_;
  Box room_;
};

/// Parts on sheets, the highest first, in rows; as they hang where they fit, or
/// all of them as low as they may lie if that takes fewer sheets.
struct Arrangement {
  std::vector<Drawing> sheets;  ///< "sheet-01" and so on
  std::vector<int> sheet_of;    ///< of each part, from 1 on
};

/// \throws TemplateError  if a part is larger than a sheet
[[nodiscard]] Arrangement arranged(const std::vector<Part>& parts,
                                   const SheetFrame& frame);

}  // namespace brachisto::report::cutting
