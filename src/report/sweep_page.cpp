// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/report/sweep_page.hpp"

#include <fmt/format.h>

#include <iterator>
#include <utility>

#include "brachisto/version.hpp"
#include "report/key_label.hpp"
#include "report/page.hpp"
#include "report/rich_text.hpp"
#include "report/sweep_csv.hpp"
#include "report/sweep_html.hpp"

namespace brachisto::report {

namespace {

constexpr const char* kAllScenes = "scenes.csv";

/// That scenes are missing, if so.
std::string warning(const SweepTable& table) {
  const SweepDigest found = digest(table, all_scenes(table));
  if (found.missing == 0) return {};
  return fmt::format(
      "<p class=\"partial\"><strong>Partial.</strong> {} of {} scenes have not "
      "been run yet; extremes and maps may change.</p>\n",
      found.missing, table.outcomes.size());
}

/// The drawings of a figure, drawn and put to the others.
std::string figure_part(const SweepTable& table, const SweepFigure& figure,
                        const std::atomic<int>* interrupt, SweepPage& out,
                        std::size_t& number, std::size_t& room) {
  std::string html = fmt::format(
      "<h2>{}</h2>\n<div class=\"part\">\n<div>\n",
      figure.fixed.empty()
          ? "Results"
          : place(table, figure.fixed, figure.scenes.front(), Markup::Html));
  for (const SweepDrawing& drawing : figure.drawings) {
    DrawnFigure drawn = draw(drawing.figure, Format::Svg, interrupt);
    html += figure_html(drawn, drawing.figure.name,
                        fmt::format("Figure {}. {}", ++number, drawing.caption),
                        room);
    if (!drawn.missing.empty()) out.missing = drawn.missing;
    std::move(drawn.files.begin(), drawn.files.end(),
              std::back_inserter(out.files));
  }
  return html + "</div>\n" + digest_table(table, figure.scenes) + "</div>\n";
}

/// \param figures  in HTML
std::string page(const SweepTable& table, const SweepFigures& planned,
                 const std::string& figures) {
  std::string out =
      page_head(table.title.empty() ? "Sweep" : xml_escaped(table.title)) +
      "<p class=\"about\">The transit time <i>T</i> of each "
      "scene as <i>τ</i> = <i>T</i> / √(<i>H</i> / 2<i>g</i>), on its "
      "smooth-contact extremal (docs/theory.md, section 3) unless the scene "
      "says otherwise.</p>\n";
  out += warning(table);
  if (table.outcomes.empty()) out += "<p>The sweep has no scenes.</p>\n";
  if (!table.columns.empty()) {
    out += "<div class=\"wide\">" + axes_table(table) + "</div>\n";
  }
  for (const std::string& remark : planned.remarks) {
    out += "<p>" + remark + "</p>\n";
  }
  out += figures;
  if (planned.figures.empty() && !table.outcomes.empty()) {
    out += "<h2>Results</h2>\n" + digest_table(table, all_scenes(table));
  }
  out += failures_table(table) + scenes_table(table, kAllScenes);
  return out + fmt::format(
                   "<footer>Written by brachisto {}.</footer>\n</body>\n"
                   "</html>\n",
                   BRACHISTO_VERSION);
}

}  // namespace

SweepPage sweep_report(const SweepTable& table,
                       const std::atomic<int>* interrupt) {
  check(table);
  const SweepFigures planned = sweep_figures(table);
  SweepPage out;
  std::string figures;
  std::size_t number = 0, room = kMostOfPictures;
  for (const SweepFigure& figure : planned.figures) {
    figures += figure_part(table, figure, interrupt, out, number, room);
  }
  out.files.push_back({kAllScenes, sweep_csv(table)});
  // Last, so that whoever sees the page sees what it refers to.
  out.files.push_back({"index.html", page(table, planned, figures)});
  return out;
}

}  // namespace brachisto::report
