// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Keys of the problem file as a reader of the paper knows them.

#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "report/scale.hpp"
#include "report/sweep_table.hpp"

namespace brachisto::report {

/// What a text becomes part of: rich text, or a page.
enum class Markup { Rich, Html };

/// How a quantity is named and in which unit it is shown.
struct KeyLabel {
  std::string words;  ///< "offset of the mass"; empty: not known
  std::string symbol;
  std::string subscript;
  std::string unit;
  bool letter = false;  ///< a symbol, set in italics, rather than a key
  bool degrees = false;
  /// Of two keys the one of the lower rank lies to the right in a map.
  std::size_t rank = 0;

  /// A number in SI units or radians, in the unit shown.
  [[nodiscard]] double shown(double value) const;
  /// The unit as it follows a number: "°", " m" or nothing.
  [[nodiscard]] std::string after_number() const;
  /// The same, or what is left of a key in so many letters.
  [[nodiscard]] KeyLabel within(std::size_t letters) const;
  /// "η_m", or "η_m [°]".
  [[nodiscard]] std::string text(Markup markup, bool with_unit) const;
  /// "angle of the mass θ_m [°]", as an axis has it.
  [[nodiscard]] std::string in_full(Markup markup, bool with_unit) const;
};

/// θ_m in degrees for "scene.body.theta_m" and so on; what has no symbol keeps
/// its key.
[[nodiscard]] KeyLabel key_label(std::string_view key);

/// The number of a numeric column as shown.
[[nodiscard]] double shown_number(const SweepColumn& column, std::size_t scene);
/// Degrees, or what suits the numbers of these scenes.
[[nodiscard]] Scale scale_of(const SweepColumn& column,
                             const std::vector<std::size_t>& scenes);
/// "η_m = 0.3, θ_m = −30°": what these columns say of a scene.
[[nodiscard]] std::string place(const SweepTable& table,
                                const std::vector<std::size_t>& columns,
                                std::size_t scene, Markup markup);
/// The same of all columns that these scenes have alike, and of what the whole
/// sweep has alike.
[[nodiscard]] std::string what_is_fixed(const SweepTable& table,
                                        const std::vector<std::size_t>& scenes);

}  // namespace brachisto::report
