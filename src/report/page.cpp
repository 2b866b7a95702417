// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "report/letters.hpp"
#include "report/rich_text.hpp"

namespace brachisto::report {

namespace {

/// A drawing of gnuplot within a page: without its prologue, and with
/// identifiers that no other one has.
std::string embedded(std::string svg, const std::string& name) {
  svg.erase(0, svg.find("<svg"));
  for (const auto& [before, after] :
       {std::pair{"id='gp", fmt::format("id='{}_gp", name)},
        {"id=\"gnuplot_", fmt::format("id=\"{}_", name)},
        {"#gnuplot_", fmt::format("#{}_", name)},
        {"#gp", fmt::format("#{}_gp", name)}}) {
    svg = replaced(svg, before, after);
  }
  return svg;
}

std::string without_tags(std::string_view html) {
  std::string out;
  bool tag = false;
  for (const char c : html) {
    if (c == '<') tag = true;
    if (!tag) out += c;
    if (c == '>') tag = false;
  }
  return out;
}

}  // namespace

std::string document_head(const std::string& title,
                          std::initializer_list<std::string_view> styles) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width, "
      "initial-scale=1\"/>\n<title>{}</title>\n<meta name=\"color-scheme\" "
      "content=\"light dark\"/>\n<style>{}</style>\n</head>\n<body>\n",
      title, fmt::join(styles, "\n"));
}

bool GrowingPage::add(const Figure& figure, const std::string& caption) {
  DrawnFiles drawn = draw(figure, Format::Svg, interrupt_);
  ++pictures_;
  std::string picture, link;
  if (!drawn.missing.empty()) {
    picture = fmt::format("<p>{}</p>\n", xml_escaped(drawn.missing));
    out_.missing = drawn.missing;
  } else {
    const std::string& svg = drawn.files.back().content;
    const std::string& file = drawn.files.back().name;
    link = fmt::format("<a href=\"{}\">SVG</a>, ", file);
    if (svg.size() > room_) {
      picture = fmt::format("<img src=\"{0}\" alt=\"{0}\"/>\n", file);
    } else {
      room_ -= svg.size();
      picture = embedded(svg, figure.name);
    }
  }
  html_ += fmt::format(
      "<figure>\n<div class=\"drawing\" "
      "id=\"drawing-{3}\">\n{0}</div>\n<figcaption>{1} "
      "<span class=\"files\">{2}<a href=\"{3}.csv\">CSV</a>, "
      "<a href=\"{3}.gp\">gnuplot</a></span></figcaption>\n</figure>\n",
      picture, caption, link, figure.name);
  std::ranges::move(drawn.files, std::back_inserter(out_.files));
  return drawn.missing.empty();
}

std::string GrowingPage::next_number() const {
  return fmt::format("Figure {}. ", pictures_ + 1);
}

std::string html_table(const std::vector<std::string>& heads,
                       const HtmlRows& rows, std::string_view style,
                       bool names) {
  std::string out =
      fmt::format("<div class=\"wide\"><table class=\"{}\"><thead><tr>",
                  style.empty() ? "stacked" : fmt::format("stacked {}", style));
  for (const std::string& head : heads) {
    out += fmt::format("<th scope=\"col\">{}</th>", head);
  }
  out += "</tr></thead><tbody>\n";
  for (const std::vector<HtmlCell>& row : rows) {
    out += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) {
      const auto& [html, of_cell] = row[i];
      out += i == 0 && names
                 ? fmt::format("<th scope=\"row\">{}</th>", html)
                 : fmt::format("<td{} data-label=\"{}\">{}</td>",
                               of_cell.empty()
                                   ? ""
                                   : fmt::format(" class=\"{}\"", of_cell),
                               without_tags(heads.at(i)), html);
    }
    out += "</tr>\n";
  }
  return out + "</tbody></table></div>\n";
}

std::string html_table(const Rows& rows) {
  std::vector<std::string> heads;
  for (const std::string& head : rows.at(0)) heads.push_back(xml_escaped(head));
  HtmlRows cells;
  for (std::size_t row = 1; row < rows.size(); ++row) {
    cells.emplace_back();
    for (const std::string& cell : rows[row]) {
      constexpr std::size_t kSentence = 32;  // letters that need no break
      cells.back().push_back(
          {xml_escaped(cell), letters(cell) > kSentence ? "words" : ""});
    }
  }
  return html_table(heads, cells);
}

std::string folded_html(std::string_view summary, const std::string& content,
                        bool open) {
  return fmt::format("<details{}><summary>{}</summary>\n{}</details>\n",
                     open ? " open=\"open\"" : "", xml_escaped(summary),
                     content);
}

std::string script_html(std::string_view content) {
  return fmt::format("<script>//<![CDATA[\n{}\n//]]></script>\n", content);
}

std::string page_json(const Json& json) {
  const std::string text =
      json.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  std::string out;
  // Outside of strings JSON has none of these.
  for (const char c : text) {
    if (std::string_view("<>&").find(c) == std::string_view::npos) {
      out += c;
    } else {
      out += fmt::format("\\u{:04x}", static_cast<int>(c));
    }
  }
  return out;
}

std::string data_html(std::string_view json) {
  return fmt::format(
      "<script type=\"application/json\" id=\"data\">{}</script>\n", json);
}

std::string playback_html(std::string_view more) {
  return fmt::format(
      "<div class=\"controls\" role=\"group\" aria-label=\"Playback\">\n"
      "<button id=\"play\" type=\"button\">Play</button>\n"
      "<input id=\"time\" type=\"range\" min=\"0\" max=\"1\" step=\"any\" "
      "aria-label=\"Time\"/>\n"
      "<output id=\"clock\" aria-live=\"off\"></output>\n"
      "<fieldset id=\"rates\" aria-label=\"Speed\"></fieldset>\n{}</div>\n",
      more);
}

}  // namespace brachisto::report
