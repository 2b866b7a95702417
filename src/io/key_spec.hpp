// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The table that describes every key of a problem file. Reading, messages and
/// the reference in the documentation all come from it.

#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "brachisto/io/problem_file.hpp"
#include "io/expression.hpp"

namespace brachisto::io {

enum class KeyType {
  Map,       ///< of further keys of the table
  Number,    ///< literal or expression
  Angle,     ///< the same with a suffix
  Integer,   ///< number with an integral value
  Choice,    ///< one of some words
  Text,      ///< any text
  List,      ///< of what its reader accepts
  Sweep,     ///< map of swept keys
  Reserved,  ///< known, but of a later version of the program
};

/// Which problem files have a key.
enum class Presence {
  Optional,
  Required,
  RequiredOfCylinder,  ///< and refused for a bead
  OptionalOfCylinder,  ///< and refused for a bead
};

/// A word that a Choice may be.
struct Choice {
  std::string_view name;
  void (*set)(ProblemFile&);
};

/// Bounds that a number has for the sake of the program. Those that physics
/// gives are not here: validate(const Scene&) knows them.
struct Interval {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  bool lower_allowed = true;

  [[nodiscard]] bool contains(double value) const {
    return (lower_allowed ? value >= lower : value > lower) && value <= upper;
  }
};

struct KeySpec;
struct YamlValue;
class Findings;
/// Stores a list, or reports what is wrong with it.
using ListReading = void(ProblemFile&, const KeySpec&, const YamlValue&,
                         Findings&);

/// One key.
struct KeySpec {
  std::string_view path;  ///< dotted
  KeyType type = KeyType::Reserved;
  Presence presence = Presence::Optional;
  std::string_view unit = {};
  std::string_view fallback = {};  ///< what holds if the key is absent
  std::string_view bounds = {};    ///< in words or as a formula
  std::string_view description = {};
  Interval interval = {};
  void (*set)(ProblemFile&, double) = nullptr;  ///< stores a number
  void (*set_text)(ProblemFile&, const std::string&) = nullptr;
  std::vector<Choice> choices = {};
  ListReading* read_list = nullptr;

  [[nodiscard]] std::string_view name() const;    ///< last part of the path
  [[nodiscard]] std::string_view parent() const;  ///< the rest, may be ""
  [[nodiscard]] bool of_cylinder() const {
    return presence == Presence::RequiredOfCylinder ||
           presence == Presence::OptionalOfCylinder;
  }
};

/// All keys in the order of the documentation, each map before its keys.
[[nodiscard]] std::span<const KeySpec> key_table();

/// The key with this path, or nullptr.
[[nodiscard]] const KeySpec* find_key(std::string_view path);

/// True if a key of the problem has a number or a word as its value, so that a
/// sweep may vary it. Not so `version`, which is no part of the problem.
[[nodiscard]] bool is_value_key(std::string_view path);

/// Names of the keys that a map may contain, reserved ones left out.
[[nodiscard]] std::vector<std::string_view> keys_of(std::string_view map);

/// Names that a Choice may be.
[[nodiscard]] std::vector<std::string_view> choices_of(const KeySpec& spec);

/// Whether a number of this key may carry the suffix of an angle.
[[nodiscard]] Unit unit_of(const KeySpec& spec);

/// Why a word is not one of a Choice, with what is expected; "" if it is.
[[nodiscard]] std::string objection(const KeySpec& spec, std::string_view word);

/// What a value has to be: "a number in m, > 0".
[[nodiscard]] std::string expected(const KeySpec& spec);

}  // namespace brachisto::io
