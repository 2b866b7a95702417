// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Keys of a document that is written: each is described once, with what writes
/// it.

#pragma once

#include <functional>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "brachisto/study/design.hpp"
#include "report/result_texts.hpp"

namespace brachisto::report {

/// A value, or null if there is none.
template <class Value>
[[nodiscard]] Json or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json();
}

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
  static Json json(const std::optional<Value>& value) { return or_null(value); }
};

/// A key of what is told of a `Source`; null is written for what it lacks.
template <class Source>
struct Field {
  FieldText text;
  std::function<Json(const Source&)> write;
  bool may_lack = false;  ///< left out in place of null

  Field(FieldText described, std::function<Json(const Source&)> writer,
        bool lacking = false)
      : text(std::move(described)),
        write(std::move(writer)),
        may_lack(lacking) {}

  /// A value: a member of the source or what a function makes of it. The type
  /// of the key is that of the value, which may be optional.
  template <class Read>
  Field(std::string_view name, std::string_view unit, std::string_view meaning,
        Read read, bool lacking = false)
      : may_lack(lacking) {
    using Value =
        Written<std::remove_cvref_t<std::invoke_result_t<Read, const Source&>>>;
    text = {name, Value::kType, unit, meaning};
    write = [=](const Source& source) {
      return Value::json(std::invoke(read, source));
    };
  }
};

template <class Source>
using Fields = std::vector<Field<Source>>;

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

/// A value that is told under a condition.
template <class Value>
[[nodiscard]] std::optional<Value> only_if(bool there, const Value& value) {
  return there ? std::optional(value) : std::nullopt;
}

/// Where a part of a source is: a member, perhaps optional, or what a function
/// points at; nullptr: there is none.
template <class Source, class Find>
[[nodiscard]] const auto* found(Find find, const Source& source) {
  decltype(auto) part = std::invoke(find, source);
  if constexpr (std::is_pointer_v<std::remove_cvref_t<decltype(part)>>) {
    return part;
  } else if constexpr (requires { part.has_value(); }) {
    return part ? &*part : nullptr;
  } else {
    return &part;
  }
}
template <class Source, class Find>
using PartOf = std::remove_const_t<std::remove_pointer_t<decltype(found(
    std::declval<Find>(), std::declval<const Source&>()))>>;

/// An object about a part of the source; nullptr: null.
template <class Source, class Find>
[[nodiscard]] Field<Source> object(std::string_view name, std::string_view unit,
                                   std::string_view meaning, Find find,
                                   Fields<PartOf<Source, Find>> fields) {
  return {{name, "object", unit, meaning, texts_of(fields)},
          [=](const Source& source) {
            const auto* part = found(find, source);
            return part != nullptr ? written(fields, *part) : Json();
          }};
}

/// A list with an object per item; `items` is a member of the source.
template <class Source, class Items>
[[nodiscard]] Field<Source> list(std::string_view name,
                                 std::string_view meaning, Items Source::*items,
                                 Fields<typename Items::value_type> fields) {
  return {{name, "array", "", meaning, texts_of(fields)},
          [=](const Source& source) {
            Json json = Json::array();
            for (const auto& item : source.*items) {
              json.push_back(written(fields, item));
            }
            return json;
          }};
}

/// A key about a part as one of the source; nullptr: null.
template <class Source, class Find>
[[nodiscard]] Field<Source> of_part(Find find,
                                    Field<PartOf<Source, Find>> field) {
  return {field.text,
          [=](const Source& source) {
            const auto* part = found(find, source);
            return part != nullptr ? field.write(*part) : Json();
          },
          field.may_lack};
}

/// The same of several keys.
template <class Source, class Find>
[[nodiscard]] Fields<Source> of_part(
    Find find, const Fields<PartOf<Source, Find>>& fields) {
  Fields<Source> out;
  for (const auto& field : fields) out.push_back(of_part<Source>(find, field));
  return out;
}

template <class Source>
[[nodiscard]] Fields<Source> joined(
    std::initializer_list<Fields<Source>> groups) {
  Fields<Source> all;
  for (const Fields<Source>& group : groups) {
    all.insert(all.end(), group.begin(), group.end());
  }
  return all;
}

/// The keys as rows of a table in Markdown.
[[nodiscard]] std::string markdown_rows(const std::vector<FieldText>& fields,
                                        const std::string& path = "");

/// What a JSON Schema tells of an object with these keys.
/// \param open  whether there may be more
[[nodiscard]] Json schema_of(const std::vector<FieldText>& fields, bool open);

/// Of the answer: its motion, forces, limits and derivatives, and its mesh.
[[nodiscard]] Fields<Solution> answer_fields();
/// The work that a solve took.
[[nodiscard]] Fields<Solution> effort_fields();
/// Where the solve came by, and answers beside the answer.
[[nodiscard]] Fields<Solution> search_fields();
/// What enclosures say, in one line.
[[nodiscard]] std::string in_words(const Proof& proof);
/// Of `brachisto design`; no key of another result.
[[nodiscard]] Field<DesignAnswer> design_field();
[[nodiscard]] Field<Solution> seconds_field();

}  // namespace brachisto::report
