// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What joins a key to a problem: the part of the problem where it lives, and a
/// member of that part. One such lens reads and writes.

#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "io/key_spec.hpp"

namespace brachisto::io {

/// A part of a problem, which it need not have, or not have a use for.
template <class Part>
struct Place {
  const Part* (*find)(const Draft&);  ///< nullptr: there is none
  Part& (*make)(Draft&);              ///< the part, made if need be
  bool (*used)(const Draft&) = [](const Draft&) { return true; };
};

/// A part that every draft has, as a function without captures names it, and
/// which problems have a use for it:
/// place([](auto& problem) -> auto& { return problem.scene; }).
template <class Lens>
[[nodiscard]] constexpr auto place(Lens, bool (*used)(const Draft&) = nullptr) {
  using Part = std::remove_reference_t<std::invoke_result_t<Lens, Draft&>>;
  Place<Part> place{
      [](const Draft& problem) -> const Part* { return &Lens{}(problem); },
      [](Draft& problem) -> Part& { return Lens{}(problem); }};
  if (used != nullptr) place.used = used;
  return place;
}

/// A part that is made where one of its keys is; the lens names the optional.
template <class Lens>
[[nodiscard]] constexpr auto optional_place(Lens) {
  using Part = typename std::remove_reference_t<
      std::invoke_result_t<Lens, Draft&>>::value_type;
  return Place<Part>{[](const Draft& problem) {
                       const auto& part = Lens{}(problem);
                       return part ? &*part : nullptr;
                     },
                     [](Draft& problem) -> Part& {
                       auto& part = Lens{}(problem);
                       return part ? *part : part.emplace();
                     }};
}

/// A part of every draft that counts as there if something of it is stated.
template <auto stated, class Lens>
[[nodiscard]] constexpr auto stated_place(Lens lens) {
  auto stated_one = place(lens);
  using Part = std::remove_reference_t<std::invoke_result_t<Lens, Draft&>>;
  stated_one.find = [](const Draft& problem) -> const Part* {
    const Part& part = Lens{}(problem);
    return stated(part) ? &part : nullptr;
  };
  return stated_one;
}

template <class Value>
struct Bare {
  using type = Value;
  static Json json(const Value& value) { return value; }
};
template <class Value>
struct Bare<std::optional<Value>> {
  using type = Value;
  static Json json(const std::optional<Value>& value) {
    return value ? Json(*value) : Json();
  }
};

/// A number, an integer if the member is one; the member may be optional.
template <class Part, class Value>
[[nodiscard]] Binding number(Place<Part> place, Value Part::*member) {
  using Stored = typename Bare<Value>::type;
  return {
      .type = std::is_integral_v<Stored> ? KeyType::Integer : KeyType::Number,
      .get =
          [=](const Draft& problem) {
            const Part* part = place.find(problem);
            return part ? Bare<Value>::json(part->*member) : Json();
          },
      .set =
          [=](Draft& problem, const Json& value) {
            place.make(problem).*member =
                static_cast<Stored>(value.get<double>());
          },
      .used = place.used};
}

/// One key for parts of two methods, which is read into both.
[[nodiscard]] inline Binding shared(const Binding& one, const Binding& other) {
  Binding both = one;
  both.get = [=](const Draft& problem) {
    return (other.used(problem) ? other : one).get(problem);
  };
  both.set = [=](Draft& problem, const Json& value) {
    one.set(problem, value);
    other.set(problem, value);
  };
  both.used = [=](const Draft& problem) {
    return one.used(problem) || other.used(problem);
  };
  return both;
}

template <class Part, class Value>
[[nodiscard]] Binding angle(Place<Part> place, Value Part::*member) {
  Binding binding = number(place, member);
  binding.type = KeyType::Angle;
  return binding;
}

/// A word as JSON has it: those of truth are no texts.
[[nodiscard]] inline Json as_json(std::string_view word) {
  if (word == "true" || word == "false") return word == "true";
  return word;
}

/// One of some words, each of which stands for a value.
template <class Part, class Value>
[[nodiscard]] Binding choice(
    Place<Part> place, Value Part::*member,
    std::vector<std::pair<std::string_view, std::type_identity_t<Value>>>
        words) {
  Binding binding{.type = KeyType::Choice, .used = place.used};
  for (const auto& [word, value] : words) binding.words.push_back(word);
  binding.get = [=](const Draft& problem) -> Json {
    const Part* part = place.find(problem);
    if (part == nullptr) return {};
    for (const auto& [word, value] : words) {
      if (part->*member == value) return as_json(word);
    }
    return {};
  };
  binding.set = [=](Draft& problem, const Json& chosen) {
    for (const auto& [word, value] : words) {
      if (word == chosen.get_ref<const std::string&>()) {
        place.make(problem).*member = value;
      }
    }
  };
  return binding;
}

template <class Part>
[[nodiscard]] Binding yes_or_no(Place<Part> place, bool Part::*member) {
  return choice(place, member, {{"true", true}, {"false", false}});
}

/// A map of further keys.
[[nodiscard]] inline Binding map() {
  return {.type = KeyType::Map};
}

/// The same where a problem need not have the part that they are about.
template <class Part>
[[nodiscard]] Binding map(Place<Part> place) {
  return {.type = KeyType::Map,
          .get =
              [=](const Draft& problem) {
                return place.find(problem) ? Json::object() : Json();
              },
          .used = place.used};
}

/// A map that the echo leaves out where there is nothing to say.
template <class Part>
[[nodiscard]] Binding silent_map(Place<Part> place) {
  Binding binding = map(place);
  binding.silent = true;
  return binding;
}

}  // namespace brachisto::io
