// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Scenes in certificates: numbers without loss, and nothing that a proof does
/// not need.

#pragma once

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>

#include "brachisto/model/scene.hpp"
#include "proof/real.hpp"

namespace brachisto::proof {

using Json = nlohmann::ordered_json;

/// A file that is no certificate, or none that can be believed as it stands.
class Refused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// In hexadecimal digits, and back.
[[nodiscard]] std::string hex(double number);
/// \throws Refused
[[nodiscard]] double number(const Json& object, std::string_view key);
/// \throws Refused  if it is none that Real::exact() wrote, or not finite
[[nodiscard]] Real ball(const Json& text);

[[nodiscard]] Json scene_json(const Scene& scene);
/// \throws Refused  if it is not what scene_json() writes of a valid scene
[[nodiscard]] Scene scene_from(const Json& said);

}  // namespace brachisto::proof
