// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/result_field.hpp"

#include <fmt/format.h>

namespace brachisto::report {

std::string markdown_rows(const std::vector<FieldText>& fields,
                          const std::string& path) {
  std::string text;
  for (const FieldText& field : fields) {
    const bool items = field.type == "array" && !field.parts.empty();
    const std::string name =
        fmt::format("{}{}{}", path, field.name, items ? "[]" : "");
    text += fmt::format("| `{}` | {} | {} | {} |\n", name, field.type,
                        field.unit, field.meaning) +
            markdown_rows(field.parts, name + ".");
  }
  return text;
}

Json schema_of(const std::vector<FieldText>& fields, bool open) {
  Json properties = Json::object();
  for (const FieldText& field : fields) {
    Json schema = {{"type", {field.type, "null"}}};
    if (field.type == "object" && !field.parts.empty()) {
      schema.update(schema_of(field.parts, field.open));
      schema["type"] = {"object", "null"};
    } else if (!field.parts.empty()) {
      schema["items"] = schema_of(field.parts, field.open);
    }
    schema["description"] =
        field.unit.empty() ? std::string(field.meaning)
                           : fmt::format("{} [{}]", field.meaning, field.unit);
    properties[field.name] = std::move(schema);
  }
  return {{"type", "object"},
          {"properties", std::move(properties)},
          {"additionalProperties", open}};
}

}  // namespace brachisto::report
