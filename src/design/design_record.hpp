// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What a search came to as JSON, for those who search elsewhere.

#pragma once

#include <nlohmann/json_fwd.hpp>

#include "design/design_search.hpp"

namespace brachisto {

/// Numbers by their names.
[[nodiscard]] nlohmann::ordered_json numbers_json(const NamedNumbers& numbers);

/// The search without the solution of its answer; doubles survive bit for bit.
[[nodiscard]] nlohmann::ordered_json to_json(const DesignSearch& search);
/// \throws std::exception  of nlohmann::json, if it is no search
[[nodiscard]] DesignSearch design_search_from_json(
    const nlohmann::ordered_json& json);

}  // namespace brachisto
