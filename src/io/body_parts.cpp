// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/body_parts.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "brachisto/model/body.hpp"
#include "io/lists.hpp"
#include "io/mass_part_text.hpp"

namespace brachisto::io {

namespace {

/// Texts, which stand for parts until the radius is known.
Objection put_parts(Draft& problem, const Json& list, Binding::Row) {
  problem.design.parts.clear();
  for (const Json& text : list) {
    problem.design.parts.emplace_back().name = text.get<std::string>();
  }
  return {};
}

}  // namespace

Binding parts_list() {
  // Not echoed: eta_m, theta_m and k say what matters of them.
  return {.type = KeyType::List,
          .put_list = put_parts,
          .items = {{"", {.type = KeyType::Text}, ""}}};
}

void read_body_parts(const YamlValue& root, Draft& problem,
                     Findings& findings) {
  const Entry* entry = find_entry(root, kPartsKey);
  if (entry == nullptr || findings.concern(kPartsKey)) return;
  const auto refuse = [&](std::string_view key, const std::string& message) {
    findings.add(position_of(root, key), std::string(key), message);
  };
  for (const KeySpec& spec : key_table()) {
    if (!follows_from_parts(spec) || find_entry(root, spec.path) == nullptr) {
      continue;
    }
    refuse(spec.path, "not allowed beside parts, from which it follows");
  }
  constexpr const char* kMassKey = "scene.body.mass";
  if (find_entry(root, kMassKey) != nullptr) {
    refuse(kMassKey,
           "not allowed beside parts, which have masses of their own");
  }
  constexpr const char* kRadiusKey = "scene.body.radius";
  const Entry* radius = find_entry(root, kRadiusKey);
  if (radius == nullptr || findings.concern(kRadiusKey)) return;
  if (radius->value.kind == YamlValue::Kind::Refused) {
    return refuse(kPartsKey,
                  "a body of parts has one radius, which cannot "
                  "vary");
  }
  Body& body = problem.scene.body;
  std::vector<MassPart>& parts = problem.design.parts;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::string text = parts[i].name;
    try {
      parts[i] = read_mass_part(text, body.radius);
    } catch (const std::invalid_argument& error) {
      findings.add(entry->value.items[i].position, kPartsKey,
                   fmt::format("{}: {}", text, error.what()));
    }
  }
  if (findings.concern(kPartsKey)) return;
  try {
    const MassProperties found = mass_properties(parts, body.radius);
    body.eta_m = found.eta_m;
    body.theta_m = found.theta_m;
    body.k = found.k;
  } catch (const std::invalid_argument& error) {
    refuse(kPartsKey, error.what());
  }
}

}  // namespace brachisto::io
