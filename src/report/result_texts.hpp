// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What is told of the keys of a result document, for those who read it.

#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>
#include <vector>

#include "brachisto/study/solution.hpp"

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

/// The keys of a result document.
[[nodiscard]] std::vector<FieldText> result_texts();

/// What result_json() writes, without the keys that tell where the result comes
/// from: provenance, scene and input.
[[nodiscard]] Json outcome_document(const Solution& solution);

}  // namespace brachisto::report
