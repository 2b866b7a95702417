// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A value for each enumerator of an enum. As with a switch, an enumerator that
/// has none does not compile.

#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <type_traits>

namespace brachisto {

/// Whether a value of an enum has a name, by how compilers spell template
/// arguments: "Mark::Disc", but "(Mark)7".
template <auto kValue>
consteval bool is_enumerator() {
  std::string_view spelt = __PRETTY_FUNCTION__;
  spelt.remove_prefix(spelt.find("kValue = "));
  spelt = spelt.substr(0, spelt.find_first_of(";]"));
  return spelt[spelt.find_last_not_of("0123456789")] != ')';
}

/// Made by table_by(). The enumerators are numbered from zero on.
template <class Enum, class Value, std::size_t count>
struct EnumTable {
  static_assert(is_enumerator<static_cast<Enum>(count - 1)>() &&
                    !is_enumerator<static_cast<Enum>(count)>(),
                "as many values as enumerators");

  std::array<Value, count> values;

  constexpr const Value& operator[](Enum at) const {
    return values[static_cast<std::size_t>(at)];
  }
};

/// A table of values in the order of the enumerators, of their common type.
template <class Enum, class... Values>
[[nodiscard]] constexpr auto table_by(Values... values) {
  using Value = std::common_type_t<Values...>;
  return EnumTable<Enum, Value, sizeof...(Values)>{{values...}};
}

}  // namespace brachisto
