// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The table that describes every key of a problem file. Reading, the echo of
/// the effective input, messages, the reference in the documentation, the
/// completions, new files and the schema for editors all come from it, and the
/// manual from that reference.

#pragma once

#include <cstddef>
#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/draft.hpp"
#include "io/expression.hpp"

namespace brachisto::io {

using Json = nlohmann::ordered_json;

enum class KeyType {
  Map,       ///< of further keys of the table
  Number,    ///< literal or expression
  Angle,     ///< the same with a suffix
  Integer,   ///< number with an integral value
  Choice,    ///< one of some words, or a map if there are keys below it
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

/// Bounds of a number.
struct Interval {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  bool lower_allowed = true;
  bool upper_allowed = true;

  [[nodiscard]] bool contains(double value) const {
    return (lower_allowed ? value >= lower : value > lower) &&
           (upper_allowed ? value <= upper : value < upper);
  }
  /// Whether the upper end is told. That of the integers of a program is where
  /// one exceeds it.
  [[nodiscard]] bool tells_upper() const {
    return upper < std::numeric_limits<int>::max();
  }
};

inline constexpr Interval kPositive{.lower = 0.0, .lower_allowed = false};

struct KeySpec;

/// What is wrong with a list that was read; no text: nothing.
struct Objection {
  std::string text = {};
  std::size_t item = std::numeric_limits<std::size_t>::max();  ///< else all
};

/// Where the value of a key lives, in both directions: functions without
/// captures, made by those of io/binding.hpp. `row` is that of the binding.
struct Binding {
  using Row = std::size_t;

  KeyType type = KeyType::Reserved;
  /// The number, or that of the word; of a map any. Nothing: there is none.
  std::optional<double> (*number)(const Draft&, Row) = nullptr;
  void (*put)(Draft&, double, Row) = nullptr;
  std::vector<std::string_view> words = {};  ///< of a Choice
  std::vector<double> values = {};           ///< that they stand for
  /// Of what has no number: in place of both.
  Json (*echo)(const Draft&, Row) = nullptr;
  void (*put_text)(Draft&, const std::string&) = nullptr;
  /// Whether the value means something to the problem. Null: always.
  bool (*used)(const Draft&) = nullptr;
  /// If there is none, the echo leaves the key out instead of saying null.
  bool silent = false;
  /// Of a list: stores what was read of it by `items`, see ItemReader.
  Objection (*put_list)(Draft&, const Json&, Row) = nullptr;
  /// What an item of a list may be, one word or number, list or map each. Of a
  /// map that is no key of a problem: its keys.
  std::vector<KeySpec> items = {};
  bool one_of = false;        ///< such a map has one of its keys
  bool once = false;          ///< no item of a list is repeated
  std::size_t count = 0;      ///< of items of a list; 0: one or more
  Names names = Names::None;  ///< what a number may name; if any, it is a text
  Row row = 0;                ///< of a table that has an entry for each key

  /// Whether the effective input has the key.
  [[nodiscard]] bool is_echoed() const {
    return number != nullptr || echo != nullptr;
  }
  /// The value, of use or not; null if there is none; an empty map if keys
  /// below say it. \pre is_echoed()
  [[nodiscard]] Json get(const Draft& problem) const;
  /// Stores a number; a text or a word.
  void set(Draft& problem, double value) const { put(problem, value, row); }
  void set(Draft& problem, const std::string& text) const;
};

/// What holds of a key, where there is anything to say.
struct KeyRules {
  Presence presence = Presence::Optional;
  std::string_view unit = {};
  /// What holds if the key is absent; left out: as a new problem has it.
  std::string fallback = {};
  std::string bounds = {};  ///< in words; left out: as the intervals say
  Interval interval = {};   ///< for the sake of the program, checked in reading
  Interval physical = {};   ///< what validate(const Scene&) checks at the least
};

/// One key.
struct KeySpec : KeyRules {
  std::string_view path;  ///< dotted
  Binding value;
  std::string_view description;

  KeySpec(std::string_view key, Binding binding, std::string_view meaning,
          KeyRules rules = {})
      : KeyRules(std::move(rules)),
        path(key),
        value(std::move(binding)),
        description(meaning) {}

  /// Bounds and fallback in words, where they are left out.
  /// \param fresh  a new problem
  void complete(const Draft& fresh);

  [[nodiscard]] std::string_view name() const;    ///< last part of the path
  [[nodiscard]] std::string_view parent() const;  ///< the rest, may be ""
  [[nodiscard]] KeyType type() const { return value.type; }
  [[nodiscard]] bool used(const Draft& draft) const {
    return value.used == nullptr || value.used(draft);
  }
  [[nodiscard]] bool of_cylinder() const {
    return presence == Presence::RequiredOfCylinder ||
           presence == Presence::OptionalOfCylinder;
  }
  [[nodiscard]] bool is_required() const {
    return presence == Presence::Required ||
           presence == Presence::RequiredOfCylinder;
  }
};

/// All keys in the order of the documentation, each map before its keys.
[[nodiscard]] std::span<const KeySpec> key_table();

/// The key with this path, or nullptr.
[[nodiscard]] const KeySpec* find_key(std::string_view path);

/// Whether scene.body.parts says what this key would.
[[nodiscard]] bool follows_from_parts(const KeySpec& spec);

inline constexpr const char* kInertiaKey = "scene.body.inertia";

/// Whether scene.body.inertia does.
[[nodiscard]] bool follows_from_inertia(const KeySpec& spec);

/// True if a key of the problem has a number or a word as its value, so that a
/// sweep may vary it. Not so `version`, which is no part of the problem.
[[nodiscard]] bool is_value_key(std::string_view path);

/// Names of the keys that a map may contain, reserved ones left out.
[[nodiscard]] std::vector<std::string_view> keys_of(std::string_view map);
[[nodiscard]] std::vector<std::string_view> keys_of(const KeySpec& map);

/// Whether a key may have, in place of a word, a map of keys below it.
[[nodiscard]] bool is_choice_or_map(const KeySpec& spec);

/// Whether a key has real numbers.
[[nodiscard]] inline bool is_real(const KeySpec& spec) {
  return spec.type() == KeyType::Number || spec.type() == KeyType::Angle;
}

/// Whether a number of this key may carry the suffix of an angle.
[[nodiscard]] Unit unit_of(const KeySpec& spec);

/// A key, and a word of it.
struct KeyWord {
  const KeySpec* key = nullptr;
  std::string_view word;
};

/// The word that a problem would have to have elsewhere for one of its keys to
/// mean something; nothing if no single one would do.
[[nodiscard]] std::optional<KeyWord> word_that_uses(const KeySpec& spec,
                                                    const Draft& draft);

/// A word as JSON has it: those of truth are no texts.
[[nodiscard]] Json as_json(std::string_view word);

/// What a value has to be: "a number in m, > 0".
[[nodiscard]] std::string expected(const KeySpec& spec);

/// "number", "word", "list", …
[[nodiscard]] std::string_view type_name(KeyType type);

/// Meaning, unit, what is allowed and the default in one paragraph, without
/// Markdown.
[[nodiscard]] std::string described(const KeySpec& spec);

/// The reference of all keys as a Markdown table, made from the very table
/// that the reader of problem files works with. docs/problem-files.md quotes
/// it.
[[nodiscard]] std::string key_reference_markdown();

/// A JSON Schema of problem files, made from the same table. It knows keys,
/// types, words and the bounds of single values; what keys demand of each other
/// the reader alone knows.
[[nodiscard]] std::string problem_schema();

}  // namespace brachisto::io
