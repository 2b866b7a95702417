// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/report/sweep_page.hpp"

#include <fmt/format.h>

#include "brachisto/version.hpp"
#include "report/key_label.hpp"
#include "report/page_style.hpp"
#include "report/svg.hpp"
#include "report/sweep_csv.hpp"
#include "report/sweep_html.hpp"

namespace brachisto::report {

namespace {

constexpr const char* kAllScenes = "scenes.csv";
/// Bytes of drawings on a page: a map of some 20 000 scenes.
constexpr std::size_t kMostOfDrawings = 1'000'000;

std::string csv_name(const SweepFigure& figure) {
  return figure.name + ".csv";
}

/// A drawing as a part of the page while there is room, or from its file.
std::string shown(const OutputFile& drawing, std::size_t& room) {
  if (drawing.content.size() > room) {
    return fmt::format("<img src=\"{0}\" alt=\"{0}\"/>\n", drawing.name);
  }
  room -= drawing.content.size();
  return drawing.content;
}

/// That scenes are missing, if so.
std::string warning(const SweepTable& table) {
  const SweepDigest found = digest(table, all_scenes(table));
  if (found.missing == 0) return {};
  return fmt::format(
      "<p class=\"partial\"><strong>Partial.</strong> {} of {} scenes have not "
      "been run yet; extremes and maps may change.</p>\n",
      found.missing, table.outcomes.size());
}

std::string figure_html(const SweepTable& table, const SweepFigure& figure,
                        std::size_t& number, std::size_t& room) {
  std::string out = fmt::format(
      "<h2>{}</h2>\n<div class=\"part\">\n<div>\n",
      figure.fixed.empty()
          ? "Results"
          : place(table, figure.fixed, figure.scenes.front(), Markup::Html));
  for (const SweepDrawing& drawing : figure.drawings) {
    out += fmt::format(
        "<figure>\n<div class=\"drawing\">\n{}</div>\n<figcaption>Figure {}. "
        "{} <span class=\"files\"><a href=\"{}\">SVG</a>, "
        "<a href=\"{}\">CSV</a></span></figcaption>\n"
        "</figure>\n",
        shown(drawing.file, room), ++number, drawing.caption, drawing.file.name,
        csv_name(figure));
  }
  return out + "</div>\n" + digest_table(table, figure.scenes) + "</div>\n";
}

std::string page(const SweepTable& table, const SweepFigures& drawn) {
  const std::string title =
      table.title.empty() ? "Sweep" : xml_escaped(table.title);
  std::string out = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width, "
      "initial-scale=1\"/>\n<title>{0}</title>\n{1}</head>\n<body>\n"
      "<h1>{0}</h1>\n<p class=\"about\">The transit time <i>T</i> of each "
      "scene as <i>τ</i> = <i>T</i> / √(<i>H</i> / 2<i>g</i>), on its "
      "smooth-contact extremal (docs/theory.md, section 3) unless the scene "
      "says otherwise.</p>\n",
      title, page_style());
  out += warning(table);
  if (table.outcomes.empty()) out += "<p>The sweep has no scenes.</p>\n";
  if (!table.columns.empty()) {
    out += "<div class=\"wide\">" + axes_table(table) + "</div>\n";
  }
  for (const std::string& remark : drawn.remarks) {
    out += "<p>" + remark + "</p>\n";
  }
  std::size_t number = 0;
  std::size_t room = kMostOfDrawings;
  for (const SweepFigure& figure : drawn.figures) {
    out += figure_html(table, figure, number, room);
  }
  if (drawn.figures.empty() && !table.outcomes.empty()) {
    out += "<h2>Results</h2>\n" + digest_table(table, all_scenes(table));
  }
  out += failures_table(table) + scenes_table(table, kAllScenes);
  return out + fmt::format(
                   "<footer>Written by brachisto {}.</footer>\n</body>\n"
                   "</html>\n",
                   BRACHISTO_VERSION);
}

}  // namespace

std::vector<OutputFile> sweep_report(const SweepTable& table) {
  check(table);
  SweepFigures drawn = sweep_figures(table);
  std::string index = page(table, drawn);
  std::vector<OutputFile> files;
  for (SweepFigure& figure : drawn.figures) {
    files.push_back({csv_name(figure), sweep_csv(table, figure.scenes)});
    for (SweepDrawing& drawing : figure.drawings) {
      files.push_back(std::move(drawing.file));
    }
  }
  files.push_back({kAllScenes, sweep_csv(table, all_scenes(table))});
  // Last, so that whoever sees the page sees what it refers to.
  files.push_back({"index.html", std::move(index)});
  return files;
}

}  // namespace brachisto::report
