// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How a track is to be built.

#pragma once

#include <optional>
#include <stdexcept>

namespace brachisto::report::cutting {

inline constexpr double kMillimetres = 1e3;  ///< in a metre
inline constexpr double kMargin = 10.0;      ///< at the edges of a sheet [mm]
inline constexpr double kApart = 5.0;        ///< between parts on a sheet [mm]

/// Sheets of material, and what is made of them [mm].
struct Build {
  double width = 600.0, height = 400.0;  ///< of a sheet
  double scale = 1.0;      ///< a length that is built over that of the scene
  double strip = 40.0;     ///< width of the strips, at most
  double thickness = 3.0;  ///< of the material
  double hole = 6.0;       ///< diameter
  /// Two strips with so much between them; nothing: one strip.
  std::optional<double> gauge = {};

  /// [mm/m]
  [[nodiscard]] double per_metre() const { return kMillimetres * scale; }
};

/// A strip is at least so many holes wide.
inline constexpr double kStripInHoles = 4.0;

/// A track that cannot be built so; what() says why.
class TemplateError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace brachisto::report::cutting
