// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What joins a key to a problem: the part of the problem where it lives, and a
/// member of that part, which one lens reads and writes.

#pragma once

#include <initializer_list>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>

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
  static std::optional<double> number(const Value& value) {
    return static_cast<double>(value);
  }
};
template <class Value>
struct Bare<std::optional<Value>> {
  using type = Value;
  static std::optional<double> number(const std::optional<Value>& value) {
    return value ? Bare<Value>::number(*value) : std::nullopt;
  }
};

/// A member of a part, as a number.
template <const auto& place, auto member>
struct Member {
  using Bared =
      Bare<std::remove_cvref_t<decltype(place.make(std::declval<Draft&>()).*
                                        member)>>;
  using Value = typename Bared::type;

  static std::optional<double> number(const Draft& problem, Binding::Row) {
    const auto* part = place.find(problem);
    return part ? Bared::number(part->*member) : std::nullopt;
  }
  static void put(Draft& problem, double value, Binding::Row) {
    place.make(problem).*member = static_cast<Value>(value);
  }
};

/// A number, an integer if the member is one; the member may be optional.
template <const auto& place, auto member>
[[nodiscard]] Binding number() {
  using Of = Member<place, member>;
  return {.type = std::is_integral_v<typename Of::Value> ? KeyType::Integer
                                                         : KeyType::Number,
          .number = Of::number,
          .put = Of::put,
          .used = place.used};
}

/// One key for a member of parts of two methods, which is read into both.
template <const auto& place, auto member, const auto& other, auto other_member>
[[nodiscard]] Binding shared() {
  using One = Member<place, member>;
  using Other = Member<other, other_member>;
  Binding both = number<place, member>();
  both.number = [](const Draft& problem, Binding::Row row) {
    return (other.used(problem) ? Other::number : One::number)(problem, row);
  };
  both.put = [](Draft& problem, double value, Binding::Row row) {
    One::put(problem, value, row);
    Other::put(problem, value, row);
  };
  both.used = [](const Draft& problem) {
    return place.used(problem) || other.used(problem);
  };
  return both;
}

template <const auto& place, auto member>
[[nodiscard]] Binding angle() {
  Binding binding = number<place, member>();
  binding.type = KeyType::Angle;
  return binding;
}

/// One of some words, each of which stands for a value of the member; of
/// another value speaks a map of keys below.
template <const auto& place, auto member>
[[nodiscard]] Binding choice(
    std::initializer_list<
        std::pair<std::string_view, typename Member<place, member>::Value>>
        words) {
  Binding binding = number<place, member>();
  binding.type = KeyType::Choice;
  for (const auto& [word, value] : words) {
    binding.words.push_back(word);
    binding.values.push_back(static_cast<double>(value));
  }
  return binding;
}

template <const auto& place, auto member>
[[nodiscard]] Binding yes_or_no() {
  return choice<place, member>({{"true", true}, {"false", false}});
}

/// A map of further keys.
[[nodiscard]] inline Binding map() {
  return {.type = KeyType::Map};
}

/// The same where a problem need not have the part that they are about.
template <const auto& place>
[[nodiscard]] Binding map() {
  return {.type = KeyType::Map,
          .number =
              [](const Draft& problem, Binding::Row) {
                return place.find(problem) ? std::optional(0.0) : std::nullopt;
              },
          .used = place.used};
}

/// What the echo leaves out where there is nothing to say.
[[nodiscard]] inline Binding silent(Binding binding) {
  binding.silent = true;
  return binding;
}

}  // namespace brachisto::io
