// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "plot/answer_tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "io/key_spec.hpp"
#include "math/angle.hpp"
#include "plot/check_texts.hpp"
#include "plot/result_values.hpp"
#include "report/page.hpp"
#include "report/rich_text.hpp"
#include "report/scale.hpp"

namespace brachisto::plot {

namespace {

using report::FieldText;
using report::Json;
using report::printed;
using report::Rows;
using report::xml_escaped;

enum class Part {
  Head,
  Found,
  Limits,
  Sensitivities,
  Way,
  Certificate,
  Origin
};

/// Where a key at the top of a result is told.
Part part_of(std::string_view key) {
  // Between blanks, those at both ends too.
  constexpr std::pair<Part, std::string_view> kKeys[] = {
      {Part::Head,
       " schema_version status message warnings verified not_verified_because "
       "feasible infeasible_because undecided_because "},
      {Part::Found,
       " tau transit_time centre_path_length rail_length start_angle end_angle "
       "rotation normal_force friction grip curvature at_start fold_margin "
       "estimated_error "},
      {Part::Limits, " limits structure "},
      {Part::Sensitivities, " sensitivities "},
      {Part::Certificate, " certificate "},
      {Part::Origin, " provenance scene input "}};
  for (const auto& [part, keys] : kKeys) {
    if (keys.find(fmt::format(" {} ", key)) != keys.npos) return part;
  }
  return Part::Way;
}

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// Few digits for what is only to be small.
constexpr int kDigits = 10, kFewDigits = 3;

std::string number_text(double value) {
  constexpr double kSmall = 1e-5;
  return printed(value, std::abs(value) < kSmall ? kFewDigits : kDigits);
}

/// A value in one cell.
std::string cell_text(const Json& value) {
  if (value.is_null()) return "–";
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (value.is_number_integer()) return fmt::format("{}", value.get<long>());
  if (value.is_number()) return xml_escaped(number_text(value.get<double>()));
  if (value.is_string()) return xml_escaped(value.get<std::string>());
  std::vector<std::string> parts;
  for (const auto& [name, item] : value.items()) {
    if (item.is_null()) continue;
    parts.push_back(
        value.is_object()
            ? fmt::format("{} = {}", symbols_html(name), cell_text(item))
            : cell_text(item));
  }
  const bool of_objects =
      value.is_array() && !value.empty() && value.front().is_object();
  return parts.empty()
             ? "none"
             : fmt::format("{}", fmt::join(parts, of_objects ? "; " : ", "));
}

std::string with_unit(const Json& value, std::string_view unit) {
  std::string text = cell_text(value);
  if (unit.empty() || value.is_null()) return text;
  text += fmt::format(" {}", xml_escaped(unit));
  if (unit == "rad" && value.is_number()) {
    text += fmt::format(" <small>({}°)</small>",
                        printed(math::in_degrees(value.get<double>()), 7));
  }
  return text;
}

/// Of cells that are HTML, the first of a row being its name; nothing of no
/// rows.
std::string table(const std::vector<std::string>& heads, const Rows& rows,
                  std::string_view style = "") {
  report::HtmlRows cells;
  for (const std::vector<std::string>& row : rows) {
    auto& to = cells.emplace_back();
    for (const std::string& cell : row) to.push_back({cell});
  }
  return rows.empty() ? "" : report::html_table(heads, cells, style, true);
}

bool is_list_of_objects(const FieldText& text) {
  return text.type == "array" && !text.parts.empty();
}

/// What is told of keys, of those within them too, but for lists of objects.
void add_rows(Rows& rows, const FieldText& text, const Json& value,
              const std::string& path) {
  const bool nothing = value.is_null() || (value.is_array() && value.empty());
  if (nothing || is_list_of_objects(text)) return;
  const std::string key = path + std::string(text.name);
  const bool whole = text.parts.empty() || !value.is_object();
  rows.push_back({fmt::format("<code>{}</code>", xml_escaped(key)),
                  whole ? with_unit(value, text.unit) : "",
                  symbols_html(text.meaning)});
  if (whole) return;
  for (const FieldText& part : text.parts) {
    add_rows(rows, part, at(value, part.name), key + ".");
  }
}

/// A list of objects as a table, and those within objects.
std::string lists(const FieldText& text, const Json& value,
                  const std::string& path) {
  std::string out;
  const std::string key = path + std::string(text.name);
  if (value.is_object()) {
    for (const FieldText& part : text.parts) {
      out += lists(part, at(value, part.name), key + ".");
    }
    return out;
  }
  if (!is_list_of_objects(text) || !value.is_array() || value.empty()) {
    return out;
  }
  std::vector<std::string> heads{"#"};
  for (const FieldText& part : text.parts) {
    heads.push_back(symbols_html(part.name) +
                    (part.unit.empty()
                         ? ""
                         : fmt::format(" [{}]", xml_escaped(part.unit))));
  }
  Rows rows;
  for (const Json& item : value) {
    std::vector<std::string> cells{fmt::format("{}", rows.size() + 1)};
    for (const FieldText& part : text.parts) {
      cells.push_back(cell_text(at(item, part.name)));
    }
    rows.push_back(std::move(cells));
  }
  return fmt::format("<h3><code>{}</code> {}</h3>\n", xml_escaped(key),
                     symbols_html(text.meaning)) +
         table(heads, rows);
}

/// All keys of one part of the page: values first, then lists.
std::string part_tables(const Json& result, Part part) {
  Rows rows;
  std::string further;
  for (const FieldText& text : report::result_texts()) {
    if (part_of(text.name) != part) continue;
    add_rows(rows, text, at(result, text.name), "");
    further += lists(text, at(result, text.name), "");
  }
  return table({"key", "value", "meaning"}, rows, "values") + further;
}

const FieldText& field_of(std::string_view key) {
  static const std::vector<FieldText> kTexts = report::result_texts();
  return *std::ranges::find(kTexts, key, &FieldText::name);
}

/// Values of the input with what the reference of problem files tells of them.
void add_input(Rows& rows, const Json& json, const std::string& path) {
  for (const auto& [name, value] : json.items()) {
    const std::string key = path + (path.empty() ? "" : ".") + name;
    if (value.is_null()) continue;
    if (value.is_object()) {
      add_input(rows, value, key);
      continue;
    }
    const io::KeySpec* spec = io::find_key(key);
    rows.push_back({fmt::format("<code>{}</code>", xml_escaped(key)),
                    with_unit(value, spec == nullptr ? "" : spec->unit),
                    spec == nullptr ? "" : symbols_html(spec->description)});
  }
}

}  // namespace

std::string symbols_html(std::string_view text) {
  std::string rich;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool sign = text[i] == '-' && i > 0 && text[i - 1] == ' ' &&
                      i + 1 < text.size() && text[i + 1] >= '0' &&
                      text[i + 1] <= '9';
    if (sign) {
      rich += "−";
      continue;
    }
    rich += text[i];
    if (text[i] == '^') {
      rich.back() = '\\';
      rich += '^';
    }
    if (text[i] != '_') continue;
    // A symbol is one letter, or one of Greek, which has no byte of ASCII.
    const bool symbol =
        i > 0 &&
        (static_cast<unsigned char>(text[i - 1]) >= 0x80 ||
         (is_letter(text[i - 1]) &&
          (i == 1 || !(is_letter(text[i - 2]) || text[i - 2] == '_'))));
    std::size_t end = i + 1;
    while (end < text.size() && is_letter(text[end])) ++end;
    if (!symbol || end == i + 1) {
      rich.insert(rich.size() - 1, 1, '\\');
      continue;
    }
    rich += fmt::format("{{{}}}", text.substr(i + 1, end - i - 1));
    i = end - 1;
  }
  return report::html_words(rich);
}

std::string reasons_html(const Json& json, std::string_view key) {
  std::string out;
  for (const std::string& reason : words(json, key)) {
    out += (out.empty() ? ": " : "; ") + symbols_html(reason);
  }
  return out;
}

std::string asked_table(const Json& result) {
  Rows rows;
  add_input(rows, at(result, "scene"), "scene");
  return table({"key", "value", "meaning"}, rows, "values");
}

std::string found_table(const Json& result) {
  return part_tables(result, Part::Found);
}

std::string limits_table(const Json& result) {
  const Json& limits = at(result, "limits");
  Rows rows;
  for (const Json& limit : limits) {
    std::vector<std::string> arcs;
    for (const Json& arc : at(limit, "active")) {
      arcs.push_back(fmt::format("{} to {}",
                                 cell_text(at(at(arc, "t"), "from")),
                                 cell_text(at(at(arc, "t"), "to"))));
    }
    const Json& share = at(limit, "share_of_time");
    rows.push_back(
        {fmt::format("<code>{}</code>", cell_text(at(limit, "name"))),
         cell_text(at(limit, "bound")),
         arcs.empty() ? "nowhere"
                      : fmt::format("{}", fmt::join(arcs, ",<br/>")),
         share.is_number()
             ? fmt::format("{:.1f} %", 100.0 * share.get<double>())
             : "–",
         cell_text(at(limit, "least_slack")), cell_text(at(limit, "price")),
         cell_text(at(limit, "price_at_fixed_contacts"))});
  }
  return table(
      {"limit", "bound", "holds at t [s]", "of the time", "least slack",
       "price dτ/d(bound)", "the same, contacts held: its multiplier"},
      rows);
}

std::string sensitivities_tables(const Json& result) {
  const Json& all = at(result, "sensitivities");
  if (!all.is_object() || all.empty()) return {};
  Rows rows;
  std::vector<std::string> names;
  for (const FieldText& by : field_of("sensitivities").parts) {
    const Json& derivatives = at(all, by.name);
    if (by.parts.empty()) continue;
    names.emplace_back(by.name);
    if (!derivatives.is_object()) continue;
    std::vector<std::string> cells{fmt::format(
        "<code>{}</code> {}", xml_escaped(by.name), symbols_html(by.meaning))};
    for (const FieldText& one : by.parts) {
      cells.push_back(with_unit(at(derivatives, one.name), one.unit));
    }
    rows.push_back(std::move(cells));
  }
  std::string out =
      table({"by", "dτ", "dT", "dτ, contacts held", "dT, contacts held"}, rows);
  const Json& second = at(all, "second");
  if (!second.is_array() || second.empty()) return out;
  names.resize(second.size());
  std::vector<std::string> heads{"∂²τ"};
  Rows square;
  for (std::size_t i = 0; i < names.size(); ++i) {
    heads.push_back(symbols_html(names[i]));
    std::vector<std::string> cells{symbols_html(names[i])};
    for (const Json& value : second[i]) cells.push_back(cell_text(value));
    square.push_back(std::move(cells));
  }
  return out + table(heads, square);
}

std::string certificate_table(const Json& result) {
  Rows rows;
  for (const Json& check : at(at(result, "certificate"), "checks")) {
    const auto brief = [&](std::string_view key) {
      const Json& value = at(check, key);
      if (!value.is_number()) return std::string("not known");
      const double number = value.get<double>();
      // The largest number below zero: what is judged is to be negative.
      if (number == -std::numeric_limits<double>::min()) {
        return std::string("below 0");
      }
      return printed(number, kFewDigits);
    };
    const std::string name = cell_text(at(check, "name"));
    const Json& where = at(check, "where");
    rows.push_back(
        {fmt::format("<code>{}</code>", name),
         xml_escaped(check_meaning(name)) +
             (where.is_string()
                  ? fmt::format("<br/><small>{}</small>", cell_text(where))
                  : ""),
         brief("value"), brief("threshold"),
         is_true(check, "passed") ? "<span class=\"good\">passed</span>"
                                  : "<strong class=\"bad\">failed</strong>"});
  }
  return table({"check", "what it means", "value", "at most", "verdict"}, rows,
               "checks");
}

std::string way_tables(const Json& result) {
  return part_tables(result, Part::Way);
}

std::string provenance_tables(const Json& result) {
  Rows rows, options;
  for (const FieldText& part : field_of("provenance").parts) {
    if (part.name == "options") continue;
    add_rows(rows, part, at(at(result, "provenance"), part.name), "");
  }
  add_input(options, at(at(result, "provenance"), "options"), "");
  return table({"key", "value", "meaning"}, rows, "values") +
         report::folded_html(
             "Options, defaults filled in",
             table({"key", "value", "meaning"}, options, "values"));
}

}  // namespace brachisto::plot
