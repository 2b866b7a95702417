// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "plot/race_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>

#include "plot/answer_tables.hpp"
#include "plot/motion_data.hpp"
#include "plot/result_values.hpp"
#include "plot/web_parts.hpp"
#include "report/page.hpp"
#include "report/rich_text.hpp"
#include "report/scale.hpp"
#include "report/text_table.hpp"
#include "report/track_kind.hpp"

namespace brachisto::plot {

namespace {

using report::Box;
using report::Json;
using report::printed;
using report::xml_escaped;

constexpr double kMilli = 1e3;     // ms in a second
constexpr int kClockDecimals = 4;  // of clocks, in seconds
constexpr std::size_t kColours = 6, kDashes = 4;

double transit_time(const Racer& racer) {
  return racer.result.at("transit_time").get<double>();
}

/// Of T [s]; 0 if the result tells none.
double time_error(const Racer& racer) {
  const double error = number(racer.result, "estimated_error");
  return std::isnan(error) ? 0.0 : error * transit_time(racer);
}

/// With so many decimals, or those that the error leaves.
std::string rounded(double value, double error, int decimals) {
  return error < 0.5 * std::pow(10.0, -decimals)
             ? fmt::format("{:.{}f}", value, decimals)
             : report::with_error(value, error);
}

bool feasible(const Racer& racer) {
  return is_true(racer.result, "feasible");
}

/// Classes of race.css: the colour of a racer and the dashes of its track, of
/// which no two of 24 have both.
std::string style(std::size_t i) {
  return fmt::format("racer{} dash{}", i % kColours + 1,
                     i / kColours % kDashes + 1);
}

/// Those that start, with a clock for each and how they come in, which the page
/// hides until they do.
std::string starting_list(const std::vector<Racer>& racers) {
  std::string out =
      "<table class=\"arrivals\">\n<caption>Who comes first? Guess, then press "
      "Play: a result is shown when its body arrives</caption>\n"
      "<thead><tr><th>guess</th><th>body</th><th>clock</th><th>place</th>"
      "<th class=\"exact\">T [s]</th><th>behind [ms]</th></tr></thead>\n"
      "<tbody>\n";
  const Racer& first = *std::ranges::min_element(racers, {}, transit_time);
  for (std::size_t i = 0; i < racers.size(); ++i) {
    const Racer& racer = racers[i];
    const double T = transit_time(racer);
    constexpr int kDecimals = 6;
    out += fmt::format(
        "<tr id=\"racer-{0}\" class=\"{1}\"><td><input type=\"radio\" "
        "name=\"guess\" value=\"{0}\" aria-label=\"{3} comes first\"/></td>"
        "<th scope=\"row\">{2} <svg class=\"swatch\" viewBox=\"0 0 40 6\" "
        "aria-hidden=\"true\"><path class=\"track {1}\" d=\"M0 3H40\"/></svg>"
        "{3}{4}</th>"
        "<td class=\"lap\" id=\"clock-{0}\">{5:.{6}f} s</td>"
        "<td class=\"result\">{7}</td><td class=\"result exact\">{8}</td>"
        "<td class=\"result\">{9}</td></tr>\n",
        i, style(i), i + 1, xml_escaped(racer.name),
        feasible(racer) ? "" : " <span class=\"bad\">(infeasible)</span>", T,
        kClockDecimals,
        1 + std::ranges::count_if(
                racers,
                [T](const Racer& other) { return transit_time(other) < T; }),
        rounded(T, time_error(racer), kDecimals), behind(first, racer));
  }
  return out + "</tbody>\n</table>\n<p id=\"guessed\" role=\"status\"></p>\n";
}

/// Questions with room for answers, to be printed before the race is run.
std::string worksheet(const std::vector<Racer>& racers, bool same_track) {
  constexpr std::string_view kLines =
      "<p class=\"line\"></p><p class=\"line\"></p>";
  std::string rows;
  for (const Racer& racer : racers) {
    rows += fmt::format(
        "<tr><th scope=\"row\">{}</th><td>&#160;</td><td>&#160;</td>"
        "<td>&#160;</td></tr>\n",
        xml_escaped(racer.name));
  }
  double last = 0.0;
  for (const Racer& racer : racers) {
    last = std::max(last, transit_time(racer));
  }
  return fmt::format(
      "<details id=\"worksheet\"><summary>A worksheet, to print before the "
      "race</summary>\n<ol>\n"
      "<li>Before you press Play: who comes first, who last, and why?{0}</li>\n"
      "<li>Play it in slow motion, and write down what you see."
      "<table><thead><tr><th>body</th><th>guessed place</th><th>place</th>"
      "<th>clock [s]</th></tr></thead><tbody>\n{1}</tbody></table></li>\n"
      "<li>{2}{0}</li>\n"
      "<li>In real time the last one needs {3} s. You stop a watch by hand to "
      "0.1 s: which places could you tell by it?{0}</li>\n</ol>\n</details>\n",
      kLines, rows,
      same_track
          ? "All fall by the same height. A body that turns more easily keeps "
            "more of that energy for its way: uniform bodies of one radius "
            "need "
            "times in proportion to √(1 + k). Compute the ratio of two of "
            "these "
            "times, and compare it with that of the clocks."
          : "The straight line is the shortest way. By which clocks do you see "
            "that the shortest way is not the quickest, and what does a track "
            "win that falls steeply at first?",
      printed(last, 3));
}

/// Who they are.
std::string starters(const std::vector<Racer>& racers) {
  std::string out = "<ol class=\"starters\">\n";
  for (const Racer& racer : racers) {
    out += fmt::format("<li>{}: {}; {}", xml_escaped(racer.name),
                       report::html_words(report::in_words(racer.scene)),
                       report::track_kind(racer.scene));
    if (racer.scene.limits.any()) {
      out += "; limits: " +
             report::html_words(report::limits_in_words(racer.scene));
    }
    if (!feasible(racer)) {
      out += fmt::format(". <span class=\"bad\">Infeasible{}</span>",
                         reasons_html(racer.result, "infeasible_because"));
    }
    out += ".</li>\n";
  }
  return out + "</ol>\n";
}

/// Rows of all racers, and what the picture shows of the plane.
struct Ground {
  std::vector<ThinnedTable> rows;
  Box box;
};

Ground ground_of(const std::vector<Racer>& racers) {
  Ground ground{{}, motion_box(racers)};
  for (const Racer& racer : racers) {
    ground.rows.push_back(
        rows_for_page(racer.table, racer.scene, kMostNumbers / racers.size()));
  }
  return ground;
}

/// How exact what is drawn is.
std::string held(const Ground& ground) {
  std::size_t rows = 0, of_rows = 0;
  double error = 0.0;
  for (const ThinnedTable& one : ground.rows) {
    rows += one.table.size();
    of_rows += one.of_rows;
    error = std::max(error, one.path_error);
  }
  if (rows == of_rows) {
    return fmt::format(
        "This page holds all {} nodes of the tracks to seven digits and draws "
        "cubics of time between them.",
        rows);
  }
  return fmt::format(
      "This page holds {} of the {} nodes of the tracks to seven digits and "
      "draws cubics of time between them, which miss none of the others by "
      "more than {} m along the path.",
      rows, of_rows, printed(error, 2));
}

std::string race_data(const std::vector<Racer>& racers, const Ground& ground) {
  std::string out = fmt::format(
      "{{\"decimals\":{},\"box\":[[{:.7g},{:.7g}],[{:.7g},{:.7g}]],"
      "\"racers\":[",
      kClockDecimals, ground.box.low.x, ground.box.low.z, ground.box.high.x,
      ground.box.high.z);
  for (std::size_t i = 0; i < racers.size(); ++i) {
    if (i > 0) out += ",\n";
    out += motion_data(ground.rows[i].table, racers[i].scene, racers[i].result,
                       ground.box);
  }
  return out + "]}";
}

}  // namespace

std::vector<Racer> in_order_of_arrival(std::vector<Racer> racers) {
  std::ranges::stable_sort(racers, {}, transit_time);
  return racers;
}

std::string behind(const Racer& first, const Racer& racer) {
  const double ms = kMilli * (transit_time(racer) - transit_time(first));
  if (ms == 0.0) return "0";
  constexpr int kDecimals = 3;
  const double error = kMilli * (time_error(first) + time_error(racer));
  return "+" + rounded(ms, error, kDecimals);
}

report::Box motion_box(const std::vector<Racer>& racers) {
  report::Box box = motion_box(racers.front().table, racers.front().scene.body);
  for (const Racer& racer : racers) {
    const report::Box its = motion_box(racer.table, racer.scene.body);
    box.include(its.low, 0.0);
    box.include(its.high, 0.0);
  }
  return box;
}

std::string race_page(const std::vector<Racer>& racers, bool same_track) {
  const Ground ground = ground_of(racers);
  const Racer& first = racers.front();
  // From contact to contact, whatever the scene gives the ends of.
  const std::vector<double>&x = first.table["x_b"], &z = first.table["z_b"];
  const double drop = z.back() - z.front();
  const std::string title =
      fmt::format("A race of {}, {}", racers.size(),
                  same_track ? "all on one track" : "each on its own track");
  std::string out = report::document_head(title, {kAnswerStyle, kRaceStyle});
  out += fmt::format(
      "<header>\n<h1>{}</h1>\n<p class=\"about\">All start together at A, {}, "
      "and arrive at B, {} m to the right and {} m {}."
      "</p>\n</header>\n<main>\n",
      title,
      same_track ? "on the track of " + xml_escaped(first.name)
                 : "each on its own track",
      printed(x.back() - x.front()), printed(std::abs(drop)),
      drop < 0.0 ? "above" : "below");
  out +=
      "<section>\n<h2 id=\"motion-heading\">The race</h2>\n"
      "<noscript><p>The race is drawn by a script, which this browser does not "
      "run.</p></noscript>\n<div id=\"stage\"></div>\n" +
      report::playback_html() +
      "<p class=\"key\"><span id=\"lift-key\" hidden=\"hidden\"><i "
      "class=\"swatch lift\"></i>" +
      symbols_html("R_n ≤ 0: here the body would lift off") + "</span></p>\n" +
      starting_list(racers) +
      "<p class=\"about\" id=\"motion-words\">Numbers, on the tracks and above "
      "the bodies, are those of the list. Tracks that run on each other are "
      "drawn as dashes by turns.</p>\n"
      "<p class=\"about keys\">Space plays and stops; ← and → move by a "
      "hundredth of the time, with Shift by a tenth.</p>\n" +
      worksheet(racers, same_track) +
      "</section>\n<section>\n<h2>Who starts</h2>\n" + starters(racers) +
      fmt::format("<p class=\"about\">{}</p>\n</section>\n</main>\n",
                  held(ground));
  out += fmt::format(
      "<footer>Written from results of brachisto {}, each of them "
      "verified.</footer>\n",
      xml_escaped(version_in(first.result)));
  return out + report::data_html(race_data(racers, ground)) +
         report::script_html(kMotionScript) + report::script_html(kRaceScript) +
         "</body>\n</html>\n";
}

namespace {

namespace fs = std::filesystem;

/// The path of a file without its ending, in parts, the last one first.
std::vector<std::string> parts_of(const std::string& file) {
  const fs::path path = fs::absolute(file).lexically_normal();
  std::vector<std::string> parts{path.stem().string()};
  for (fs::path folder = path.parent_path(); folder.has_relative_path();
       folder = folder.parent_path()) {
    parts.push_back(folder.filename().string());
  }
  return parts;
}

/// The last ones of these parts.
std::string joined(const std::vector<std::string>& parts, std::size_t count) {
  std::string name = parts[0];
  for (std::size_t i = 1; i < count; ++i) name = parts[i] + "/" + name;
  std::ranges::replace(name, '_', ' ');
  return name;
}

}  // namespace

std::vector<std::string> racer_names(const std::vector<std::string>& files) {
  std::vector<std::vector<std::string>> parts;
  std::vector<std::string> names;
  for (const std::string& file : files) {
    parts.push_back(parts_of(file));
    names.push_back(joined(parts.back(), 1));
  }
  std::vector<std::size_t> counts(files.size(), 1);
  for (bool longer = true; longer;) {
    longer = false;
    const std::vector<std::string> before = names;
    for (std::size_t i = 0; i < files.size(); ++i) {
      if (std::ranges::count(before, before[i]) == 1) continue;
      if (counts[i] < parts[i].size()) {
        names[i] = joined(parts[i], ++counts[i]);
        longer = true;
      } else {
        names[i] = files[i];
      }
    }
  }
  return names;
}

}  // namespace brachisto::plot
