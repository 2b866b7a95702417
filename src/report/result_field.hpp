// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Keys of a document that is written: each is described once, with what writes
/// it.

#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace brachisto::report {

using Json = nlohmann::ordered_json;

/// What documentation and schemas tell of a key.
struct FieldText {
  std::string_view name;
  std::string_view type;  ///< as JSON Schema calls it
  std::string_view unit;
  std::string_view meaning;
  /// Of an object; of each item of an array, which is of plain values if empty.
  std::vector<FieldText> parts = {};
  bool open = false;  ///< an object may have further keys
};

/// A key of what is told of a `Source`; null is written for what it lacks.
template <class Source>
struct Field {
  FieldText text;
  std::function<Json(const Source&)> write;
  bool may_lack = false;  ///< left out in place of null
};

template <class Source>
using Fields = std::vector<Field<Source>>;

template <class Value>
struct Written {
  static constexpr std::string_view kType =
      std::is_same_v<Value, bool>                      ? "boolean"
      : std::is_integral_v<Value>                      ? "integer"
      : std::is_floating_point_v<Value>                ? "number"
      : std::is_convertible_v<Value, std::string_view> ? "string"
                                                       : "array";
  static Json json(const Value& value) { return value; }
};
template <class Value>
struct Written<std::optional<Value>> {
  static constexpr std::string_view kType = Written<Value>::kType;
  static Json json(const std::optional<Value>& value) {
    return value ? Json(*value) : Json();
  }
};

/// A value: a member of the source or what a function makes of it. The type of
/// the key is that of the value, which may be optional.
template <class Source, class Read>
[[nodiscard]] Field<Source> value(std::string_view name, std::string_view unit,
                                  std::string_view meaning, Read read) {
  using Value =
      Written<std::remove_cvref_t<std::invoke_result_t<Read, const Source&>>>;
  return {{name, Value::kType, unit, meaning}, [=](const Source& source) {
            return Value::json(std::invoke(read, source));
          }};
}

/// The same, left out where there is none.
template <class Source, class Read>
[[nodiscard]] Field<Source> value_if(std::string_view name,
                                     std::string_view unit,
                                     std::string_view meaning, Read read) {
  Field<Source> field = value<Source>(name, unit, meaning, read);
  field.may_lack = true;
  return field;
}

template <class Source>
[[nodiscard]] Json written(const Fields<Source>& fields, const Source& source) {
  Json json = Json::object();
  for (const Field<Source>& field : fields) {
    Json value = field.write(source);
    if (field.may_lack && value.is_null()) continue;
    json[field.text.name] = std::move(value);
  }
  return json;
}

template <class Source>
[[nodiscard]] std::vector<FieldText> texts_of(const Fields<Source>& fields) {
  std::vector<FieldText> texts;
  for (const Field<Source>& field : fields) texts.push_back(field.text);
  return texts;
}

/// What a function that finds a part of a source points at.
template <class Source, class Find>
using PartOf = std::remove_const_t<
    std::remove_pointer_t<std::invoke_result_t<Find, const Source&>>>;

/// An object about a part of the source; nullptr: null.
template <class Source, class Find>
[[nodiscard]] Field<Source> object(std::string_view name, std::string_view unit,
                                   std::string_view meaning, Find find,
                                   Fields<PartOf<Source, Find>> fields) {
  return {{name, "object", unit, meaning, texts_of(fields)},
          [=](const Source& source) {
            const auto* part = find(source);
            return part != nullptr ? written(fields, *part) : Json();
          }};
}

/// A list with an object per item; `items` is a member of the source.
template <class Source, class Item>
[[nodiscard]] Field<Source> list(std::string_view name,
                                 std::string_view meaning,
                                 std::vector<Item> Source::*items,
                                 Fields<Item> fields) {
  return {{name, "array", "", meaning, texts_of(fields)},
          [=](const Source& source) {
            Json json = Json::array();
            for (const Item& item : source.*items) {
              json.push_back(written(fields, item));
            }
            return json;
          }};
}

/// Keys about a part among those of the source; nullptr: all of them are null.
template <class Source, class Find>
void splice(Fields<Source>& target, Find find,
            const Fields<PartOf<Source, Find>>& fields) {
  for (const auto& field : fields) {
    target.push_back({field.text,
                      [=](const Source& source) {
                        const auto* part = find(source);
                        return part != nullptr ? field.write(*part) : Json();
                      },
                      field.may_lack});
  }
}

}  // namespace brachisto::report
