// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "plot/sweep_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "brachisto/version.hpp"
#include "plot/web_parts.hpp"
#include "report/csv.hpp"
#include "report/key_label.hpp"
#include "report/page.hpp"
#include "report/rich_text.hpp"
#include "report/sweep_plots.hpp"
#include "report/text_table.hpp"

namespace brachisto::plot {

namespace {

using report::all_scenes;
using report::columns_that_vary;
using report::digest;
using report::key_label;
using report::KeyLabel;
using report::Markup;
using report::place;
using report::printed;
using report::Scenes;
using report::shown_number;
using report::SweepDigest;
using report::SweepDrawing;
using report::SweepFigure;
using report::SweepFigures;
using report::xml_escaped;

constexpr std::size_t kMostFailures = 200;

using State = SweepOutcome::State;

/// With the digits that a relative error leaves; a dash if there is no number.
std::string known(double value, double error) {
  return std::isfinite(value) ? report::within_error(value, error * value)
                              : "–";
}

std::string column_heads(const SweepTable& table) {
  std::string out;
  for (const SweepColumn& column : table.columns) {
    out += fmt::format("<th scope=\"col\">{}</th>",
                       key_label(column.key).text(Markup::Html, true));
  }
  return out;
}

std::string column_cells(const SweepTable& table, std::size_t scene) {
  std::string out;
  for (const SweepColumn& column : table.columns) {
    out +=
        column.numeric()
            ? fmt::format("<td>{}</td>", printed(shown_number(column, scene)))
            : fmt::format("<td>{}</td>", xml_escaped(column.words[scene]));
  }
  return out;
}

/// Least and greatest number, or the words, of a column.
std::string values_of(const SweepTable& table, const SweepColumn& column) {
  if (!column.numeric()) {
    const std::vector<std::string> words =
        report::distinct_words(column, all_scenes(table));
    std::string out;
    constexpr std::size_t kMostWords = 12;
    for (std::size_t i = 0; i < std::min(words.size(), kMostWords); ++i) {
      out += (i == 0 ? "" : ", ") + xml_escaped(words[i]);
    }
    return out + (words.size() > kMostWords ? ", …" : "");
  }
  if (column.numbers.empty()) return "–";
  const KeyLabel label = key_label(column.key);
  const auto [low, high] = std::ranges::minmax_element(column.numbers);
  const std::string unit = label.after_number();
  if (*low == *high) return printed(label.shown(*low)) + unit;
  return fmt::format("{}{} to {}{}", printed(label.shown(*low)), unit,
                     printed(label.shown(*high)), unit);
}

/// The axes with their columns and the values they run over.
std::string axes_table(const SweepTable& table) {
  std::string out =
      "<table class=\"axes\"><thead><tr><th scope=\"col\">axis</th>"
      "<th scope=\"col\">values</th><th scope=\"col\">quantity</th>"
      "<th scope=\"col\">range</th><th scope=\"col\">key</th></tr></thead>"
      "<tbody>\n";
  const auto row = [&](const std::string& axis, const std::string& count,
                       const SweepColumn& column) {
    out += fmt::format(
        "<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td>"
        "<td><code>{}</code></td></tr>\n",
        axis, count, key_label(column.key).in_full(Markup::Html, false),
        values_of(table, column), xml_escaped(column.key));
  };
  const std::vector<std::size_t> varying =
      columns_that_vary(table, all_scenes(table));
  const auto varies = [&](std::size_t c) {
    return std::ranges::binary_search(varying, c);
  };
  std::vector<bool> on_axis(table.columns.size(), false);
  for (std::size_t a = 0; a < table.axes.size(); ++a) {
    const SweepAxis& axis = table.axes[a];
    for (const std::size_t column : axis.columns) {
      const bool first = column == axis.columns.front();
      row(first ? fmt::format("{}", a + 1) : "",
          first ? fmt::format("{}{}", axis.count,
                              axis.ordered ? "" : ", at random")
                : "",
          table.columns[column]);
      on_axis[column] = true;
    }
  }
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    if (!on_axis[c])
      row("–", varies(c) ? "follows" : "fixed", table.columns[c]);
  }
  for (const SweepConstant& constant : table.constants) {
    row("–", "fixed", {.key = constant.key, .numbers = {constant.value}});
  }
  return out + "</tbody></table>\n";
}

/// Counts and extreme values of these scenes.
std::string digest_table(const SweepTable& table, const Scenes& scenes) {
  const SweepDigest found = digest(table, scenes);
  const std::vector<std::size_t> varying = columns_that_vary(table, scenes);
  std::string out = "<table class=\"digest\"><tbody>\n";
  const auto row = [&](std::string_view what, const std::string& value) {
    out += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td></tr>\n", what,
                       value);
  };
  const auto at = [&](std::optional<std::size_t> scene,
                      const std::string& value) {
    const std::string where = place(table, varying, *scene, Markup::Html);
    return value + (where.empty() ? "" : "<br/><small>" + where + "</small>");
  };
  const auto tau = [&](std::optional<std::size_t> scene) {
    const SweepOutcome& outcome = table.outcomes[*scene];
    return at(scene, known(outcome.tau, outcome.estimated_error));
  };
  row("scenes", fmt::format("{}", scenes.size()));
  row("verified", fmt::format("{}", found.verified));
  row("of them feasible", fmt::format("{}", found.verified - found.infeasible));
  row("failed", fmt::format("{}", found.failed));
  row("not run yet", fmt::format("{}", found.missing));
  if (found.fastest) row("minimum of <i>τ</i>", tau(found.fastest));
  if (found.fastest_feasible && found.infeasible > 0) {
    row("minimum, feasible", tau(found.fastest_feasible));
  }
  if (found.slowest) row("maximum of <i>τ</i>", tau(found.slowest));
  if (found.least_accurate) {
    const double error = table.outcomes[*found.least_accurate].estimated_error;
    row("largest estimated error", at(found.least_accurate, printed(error, 2)));
  }
  return out + "</tbody></table>\n";
}

/// The scenes that failed, with their cause, up to a number that can be read;
/// empty if none did.
std::string failures_table(const SweepTable& table) {
  std::string rows;
  std::size_t count = 0;
  for (std::size_t scene = 0; scene < table.outcomes.size(); ++scene) {
    const SweepOutcome& outcome = table.outcomes[scene];
    if (outcome.state != State::Failed || ++count > kMostFailures) continue;
    rows += fmt::format(
        "<tr><td>{}</td>{}<td>{}</td><td class=\"words\">{}</td></tr>\n", scene,
        column_cells(table, scene), xml_escaped(outcome.status),
        xml_escaped(outcome.message));
  }
  if (count == 0) return {};
  std::string out = fmt::format(
      "<h2>Failed scenes</h2>\n<details><summary>{} of {} scenes have no "
      "verified result: their causes</summary>\n"
      "<div class=\"wide\"><table><thead><tr><th scope=\"col\">scene</th>{}"
      "<th scope=\"col\">status</th><th scope=\"col\">cause</th></tr></thead>"
      "<tbody>\n{}</tbody></table></div>\n",
      count, table.outcomes.size(), column_heads(table), rows);
  if (count > kMostFailures) {
    out += fmt::format("<p>{} more are not listed here.</p>\n",
                       count - kMostFailures);
  }
  return out + "</details>\n";
}

bool is_listed(const SweepTable& table) {
  return !table.outcomes.empty() && table.outcomes.size() <= kMostRows;
}

/// All scenes, folded; of a sweep too large for a page, where to find them.
std::string scenes_table(const SweepTable& table, const std::string& csv_name) {
  const std::string link = fmt::format("<a href=\"{0}\">{0}</a>", csv_name);
  std::string out = fmt::format(
      "<h2>All scenes</h2>\n<p>With 17 digits, in SI units and radians: "
      "{}.</p>\n",
      link);
  if (!is_listed(table)) return out;
  out += fmt::format(
      "<details><summary>Table of {} scenes</summary>\n<div class=\"wide\">"
      "<table id=\"scenes\"><thead><tr><th scope=\"col\">scene</th>{}"
      "<th scope=\"col\"><i>τ</i></th><th scope=\"col\"><i>T</i> [s]</th>"
      "<th scope=\"col\">error</th><th scope=\"col\">feasible</th>"
      "<th scope=\"col\">status</th></tr></thead><tbody>\n",
      table.outcomes.size(), column_heads(table));
  for (std::size_t scene = 0; scene < table.outcomes.size(); ++scene) {
    const SweepOutcome& outcome = table.outcomes[scene];
    const bool verified = outcome.state == State::Verified;
    out += fmt::format(
        "<tr><td>{}</td>{}<td>{}</td><td>{}</td><td>{}</td><td>{}</td>"
        "<td>{}</td></tr>\n",
        scene, column_cells(table, scene),
        known(outcome.tau, outcome.estimated_error),
        known(outcome.transit_time, outcome.estimated_error),
        std::isfinite(outcome.estimated_error)
            ? printed(outcome.estimated_error, 2)
            : "–",
        !verified          ? "–"
        : outcome.feasible ? "yes"
                           : "no",
        outcome.status.empty() ? report::name(outcome.state)
                               : xml_escaped(outcome.status));
  }
  return out + "</tbody></table></div></details>\n";
}

/// "sharper valleys" of problems/sweeps/sharper_valleys.yaml.
std::string name_of(const std::string& title) {
  const std::filesystem::path file(title);
  if (file.extension() != ".yaml" && file.extension() != ".yml") return title;
  std::string name = file.stem().string();
  std::ranges::replace(name, '_', ' ');
  return name;
}

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

/// The pictures, one beneath the other, and which of them there are.
struct Drawn {
  report::GrowingPage page;
  std::vector<report::Figure> figures = {};
};

void add_figure(const SweepTable& table, const SweepFigure& figure,
                Drawn& drawn) {
  report::GrowingPage& page = drawn.page;
  page += fmt::format(
      "<h2>{}</h2>\n<div class=\"part\">\n<div>\n",
      figure.fixed.empty()
          ? "Results"
          : place(table, figure.fixed, figure.scenes.front(), Markup::Html));
  for (const SweepDrawing& drawing : figure.drawings) {
    if (page.add(drawing.figure, page.next_number() + drawing.caption)) {
      drawn.figures.push_back(drawing.figure);
    }
  }
  page += "</div>\n" + digest_table(table, figure.scenes) + "</div>\n";
}

/// Where the script shows the track of a scene.
constexpr const char* kTrackSection =
    "<section id=\"track-section\" hidden=\"hidden\">\n"
    "<h3 id=\"motion-heading\">The track of scene <b id=\"track-scene\"></b>"
    "</h3>\n<div id=\"stage\"></div>\n";
constexpr const char* kTrackWords =
    "<p class=\"key\"><span id=\"lift-key\" hidden=\"hidden\"><i "
    "class=\"swatch lift\"></i>here the body would lift off</span></p>\n"
    "<p class=\"about\" id=\"motion-words\">The solid line is the track; the "
    "dashed one is the path of the centre and the dotted one that of the "
    "centre of mass, where they differ. The sweep kept <span "
    "id=\"track-rows\"></span> rows of its table; "
    "cubics of time between them miss none of the others by more than "
    "<span id=\"track-error\"></span> m.</p>\n"
    "<p class=\"about keys\">Space plays and stops.</p>\n</section>\n";

/// How to point at scenes; what is not there is not spoken of.
std::string directions(const std::vector<SweepTrack>& tracks) {
  return fmt::format(
      "<noscript><p>The values of single scenes are shown by a script, which "
      "this browser does not run; the table below has them.</p></noscript>\n"
      "<p class=\"about keys\">Each scene is a cell of the pictures: pointing "
      "at it, or the arrow keys once a picture has the focus, tell its "
      "values{}.</p>\n",
      tracks.empty() ? "; a sweep with <code>keep: tracks</code> shows its "
                       "track too"
                     : ", a click or the Enter key shows its track");
}

std::string page(const SweepTable& table, const SweepFigures& planned,
                 const Drawn& drawn, const std::vector<SweepTrack>& tracks) {
  const std::string title =
      table.title.empty() ? "Sweep" : xml_escaped(name_of(table.title));
  const bool pointed = is_listed(table) && !drawn.figures.empty();
  std::string out =
      report::document_head(title, {kAnswerStyle, kSweepStyle}) +
      "<header>\n<h1>" + title + "</h1>\n" +
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
  out += "</header>\n<main>\n";
  if (pointed) out += directions(tracks);
  out += drawn.page.html();
  if (!tracks.empty())
    out += kTrackSection + report::playback_html() + kTrackWords;
  if (planned.figures.empty() && !table.outcomes.empty()) {
    out += "<h2>Results</h2>\n" + digest_table(table, all_scenes(table));
  }
  out += failures_table(table) + scenes_table(table, kAllScenes);
  out += fmt::format("</main>\n<footer>Written by brachisto {}.</footer>\n",
                     BRACHISTO_VERSION);
  if (pointed) {
    out += report::data_html(
               report::page_json(sweep_data(table, drawn.figures, tracks))) +
           report::script_html(kMotionScript) +
           report::script_html(kSweepScript);
  }
  return out + "</body>\n</html>\n";
}

}  // namespace

report::DrawnFiles sweep_report(const SweepTable& table,
                                const std::vector<SweepTrack>& tracks,
                                const std::atomic<int>* interrupt) {
  report::check(table);
  const SweepFigures planned = report::sweep_figures(table);
  Drawn drawn{report::GrowingPage(interrupt)};
  for (const SweepFigure& figure : planned.figures) {
    add_figure(table, figure, drawn);
  }
  drawn.page.add_file(kAllScenes, report::sweep_csv(table));
  // Last, so that whoever sees the page sees what it refers to.
  drawn.page.add_file(
      "index.html",
      page(table, planned, drawn,
           is_listed(table) ? tracks : std::vector<SweepTrack>()));
  return drawn.page.files();
}

}  // namespace brachisto::plot
