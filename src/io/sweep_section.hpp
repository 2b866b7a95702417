// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The section `sweep` as it was written: which keys vary, by which rule, and
/// which of them together.

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "brachisto/io/problem_file.hpp"
#include "io/expression.hpp"
#include "io/findings.hpp"
#include "io/key_spec.hpp"
#include "io/yaml_tree.hpp"
#include "math/portable_random.hpp"

namespace brachisto::io {

enum class Spacing {
  Linear,  ///< equal differences
  Log,     ///< equal ratios
};

/// Value at the fraction part/whole of the way between two ends:
///
///   linear  from (1 − f) + to f,  log  from^(1 − f) to^f,  f = part/whole.
///
/// The ends are exact, and swapping them while f becomes 1 − f gives the same
/// bits; a linear value is rounded three times, whatever its place, and does
/// not depend on the platform.
///
/// \param part, whole  0 ≤ part ≤ whole, whole − part exact
/// \throws ExpressionError  if the value is not finite or, for equal ratios,
///         if the ends are not of one sign, or zero
[[nodiscard]] double between(double from, double to, double part, double whole,
                             Spacing spacing);

inline constexpr std::string_view kExpectedRanges =
    "a map of the keys that are random, each with from and to";

/// A key of the problem whose numbers may name quantities.
[[nodiscard]] KeySpec as_swept(const KeySpec& spec);

/// A map of two ends, their spacing and, if it is counted, the number of values
/// from one to the other; the far end may then be left out.
[[nodiscard]] KeySpec range_of(const KeySpec& spec, bool counted);

/// What the section may have besides keys of the problem and `zip`: random,
/// whose ranges are such keys, warm_start, keep.
[[nodiscard]] const std::vector<KeySpec>& keys_beside_swept();

/// Whether the section may have such a key, and what is below one of its keys.
[[nodiscard]] bool is_key_of_sweep(std::string_view key);
[[nodiscard]] bool is_key_of_range(std::string_view key);

/// Numbers from one end to the other, both included, or random ones between.
struct NumberRange {
  Expression from, to;
  Spacing spacing = Spacing::Linear;
  std::optional<RandomStream> random = {};
};

/// Words or numbers, one after the other, or a range.
using SweepRule = std::variant<std::vector<std::string>,
                               std::vector<Expression>, NumberRange>;

/// A key of the section.
struct SweepEntry {
  const KeySpec* spec = nullptr;  ///< of the key of the problem
  std::string key;                ///< dotted, from the section on
  Position key_position;
  Position position;                ///< of the value
  std::vector<Position> positions;  ///< of each value of a list
  SweepRule rule;
  std::size_t count = 1;  ///< values
  bool runs = false;      ///< along an axis; else count = 1
  bool readable = false;  ///< false: a mistake was reported
};

/// The section.
struct SweepSection {
  std::vector<SweepEntry> entries;  ///< in file order
  std::vector<SweepFileAxis> axes;  ///< of indices of entries
  bool warm_start = false;
  bool keeps_tracks = false;

  /// The entry of a key of the problem, nullptr if it does not vary.
  [[nodiscard]] const SweepEntry* find(std::string_view path) const;
};

/// Reads one key of the section: a list, a range or a single value.
/// \param key  dotted, from the section on
[[nodiscard]] SweepEntry read_sweep_entry(const KeySpec& spec,
                                          const Entry& entry, std::string key,
                                          Findings& findings);

/// Reads one key of the random ranges.
[[nodiscard]] SweepEntry read_sample_entry(const KeySpec& spec,
                                           const Entry& entry, std::string key,
                                           std::uint64_t seed,
                                           Findings& findings);

/// Reads the section. All mistakes go to the findings; it is of use only if
/// there are none.
[[nodiscard]] SweepSection read_sweep_section(const Entry& sweep,
                                              Findings& findings);

/// The expressions of a rule.
[[nodiscard]] std::vector<const Expression*> expressions_of(
    const SweepRule& rule);

/// Value number `index` of an entry in a scene with the given quantities.
/// \throws ExpressionError  if it is not a finite number
[[nodiscard]] SweepValue value_of(const SweepEntry& entry, std::size_t index,
                                  const QuantityValues& quantities);

}  // namespace brachisto::io
