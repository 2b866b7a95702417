// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "plot/answer_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "math/angle.hpp"
#include "plot/answer_tables.hpp"
#include "plot/motion_data.hpp"
#include "plot/result_values.hpp"
#include "plot/web_parts.hpp"
#include "report/page.hpp"
#include "report/rich_text.hpp"
#include "report/scale.hpp"
#include "report/text_table.hpp"
#include "report/track_kind.hpp"
#include "trajectory/grip.hpp"
#include "transcription/rolling_time.hpp"

namespace brachisto::plot {

namespace {

using report::Json;
using report::printed;
using report::xml_escaped;

std::string degrees(double radians) {
  return printed(math::in_degrees(radians), 6) + "°";
}
std::string slope(double radians) {
  return degrees(std::abs(radians)) + (radians < 0.0 ? " up" : " down");
}

/// Whether it is of a design none of whose bodies has grip enough; `feasible`
/// of a result does not ask for that, and that of a minimum does.
bool lacks_grip(const Json& result) {
  const Json& design = at(result, "design");
  const Json& minima = at(design, "minima");
  return at(design, "values").is_null() && !minima.empty() &&
         std::ranges::none_of(
             minima, [](const Json& one) { return is_true(one, "feasible"); });
}

/// How many of the checks there are passed.
struct Checks {
  std::size_t passed = 0, all = 0;
};
Checks checks_of(const Json& result) {
  Checks checks;
  for (const Json& check : result.at("certificate").at("checks")) {
    ++checks.all;
    if (is_true(check, "passed")) ++checks.passed;
  }
  return checks;
}

std::string verdict(const Json& result) {
  const auto list = [&](const std::string& first, std::string_view key) {
    return first + reasons_html(result, key) + ".";
  };
  const auto [passed, checks] = checks_of(result);
  const bool verified = is_true(result, "verified");
  const bool feasible = is_true(result, "feasible");
  const bool for_want_of_grip = verified && feasible && lacks_grip(result);
  const bool undecided =
      feasible && !for_want_of_grip && !at(result, "undecided_because").empty();
  std::string out = fmt::format(
      "<p class=\"verdict {}\">{} {}</p>\n",
      verified && feasible && !for_want_of_grip ? "good" : "bad",
      list(fmt::format("{}, {} of {} checks passed",
                       verified ? "Verified" : "Not verified", passed, checks),
           "not_verified_because"),
      list(!feasible ? "Infeasible"
           : for_want_of_grip
               ? "Infeasible for want of the grip that is asked for"
           : undecided ? "Feasible within the error of this mesh"
           : result.at("scene").at("body").at("shape") == "bead"
               ? "Feasible: a bead is held from both sides"
               : "Feasible: the body presses on the track all the way, and the "
                 "track does not fold",
           undecided ? "undecided_because" : "infeasible_because"));
  for (const std::string& warning : words(result, "warnings")) {
    out += fmt::format("<p>{}</p>\n", xml_escaped(warning));
  }
  return out;
}

/// The friction needed after shares of the time; empty for a bead.
std::vector<LeastGrip> grip_of(const Json& result) {
  std::vector<LeastGrip> out;
  for (const Json& one : at(at(result, "grip"), "least_after")) {
    const double mu = number(one, "mu");
    out.push_back(
        {number(one, "share_of_time"),
         std::isnan(mu) ? std::numeric_limits<double>::infinity() : mu});
  }
  return out;
}

/// The numbers that one looks for first.
std::string numbers(const Json& result, const TrajectoryTable& table) {
  std::string out = "<dl class=\"numbers\">\n";
  const auto add = [&](std::string_view name, const std::string& value) {
    out += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", name, value);
  };
  add("transit time T", time_text(result, "transit_time") + " s");
  if (const std::vector<LeastGrip> grip = grip_of(result); !grip.empty()) {
    add("grip, least μ", grip_in_words(grip));
  }
  add("τ = T √(2g/H)", time_text(result, "tau"));
  add("greatest speed of the centre",
      printed(std::ranges::max(table["v_c"]), 4) + " m/s");
  add("length of the track", printed(number(result, "rail_length"), 6) + " m");
  add("slopes at A and B", slope(number(result, "start_angle")) + ", " +
                               slope(number(result, "end_angle")));
  const double rotation = number(result, "rotation");
  if (std::isfinite(rotation)) add("the body turns", degrees(rotation));
  if (const std::string force = force_text(result); !force.empty()) {
    add(symbols_html("normal force R_n"), force);
  }
  return out + "</dl>\n";
}

/// What stands beside the drawing.
std::string key(const Scene& scene, const Json& result) {
  std::string out = "<p class=\"key\">";
  const auto add = [&](std::string_view swatch, const std::string& words,
                       std::string_view more = "") {
    out += fmt::format("<span{}><i class=\"swatch {}\"></i>{}</span>\n", more,
                       swatch, words);
  };
  add("normal", symbols_html("normal force R_n"));
  if (scene.body.rolls()) {
    add("tangential", symbols_html("friction force R_t"));
  }
  if (scene.body.off_centred()) {
    add("mass", scene.world.field_varies()
                    ? "centre of mass and its path"
                    : "centre of mass, its path, weight");
  } else if (!scene.world.field_varies()) {
    add("mass", "weight");
  }
  add("lift", symbols_html("R_n ≤ 0: here the body would lift off"),
      " id=\"lift-key\" hidden=\"hidden\"");
  std::size_t band = 0;
  for (const Json& limit : at(result, "limits")) {
    if (at(limit, "active").empty()) continue;
    constexpr std::size_t kBands = 6;
    add(fmt::format("arc-key band{}", band++ % kBands),
        fmt::format("<code>{}</code> holds",
                    xml_escaped(text_of(limit, "name"))));
  }
  return out + "</p>\n";
}

std::string controls(const Scene& scene) {
  const bool rolls = scene.body.rolls();
  const auto box = [](std::string_view id, std::string_view name, bool on,
                      bool there) {
    return fmt::format(
        "<label{}><input type=\"checkbox\" id=\"{}\"{}/> {}</label>\n",
        there ? "" : " hidden=\"hidden\"", id, on ? " checked=\"checked\"" : "",
        name);
  };
  return report::playback_html(
      box("use-forces", "forces", true, true) +
      box("use-ghosts", "every tenth of T", true, true) +
      box("use-lens", "lens", false, rolls));
}

std::string motion_section(const Scene& scene, const Json& result,
                           const ThinnedTable& rows) {
  const bool whole = rows.table.size() == rows.of_rows;
  std::string held = fmt::format(
      "This page holds {} rows of trajectory.csv to seven digits and draws "
      "cubics of time between them.",
      whole ? fmt::format("all {}", rows.of_rows)
            : fmt::format("{} of the {}", rows.table.size(), rows.of_rows));
  if (!whole) {
    held += fmt::format(
        " These miss none of the other rows by more than {} m along the "
        "path{}",
        printed(rows.path_error, 2),
        rows.curve_error > kCoarsest
            ? ". The body turns so often that they cannot follow its turns: "
              "curves and lens show only between which values they run."
            : fmt::format(", nor by more than {} % of the height of a curve.",
                          printed(100.0 * rows.curve_error, 2)));
  }
  std::string said =
      scene.body.rolls()
          ? "The thick sectors of the rim leave the thick pieces of "
            "the track: as long as each other, for the body does "
            "not slip. The ring marks where they touch. "
          : "";
  return "<section>\n<h2 id=\"motion-heading\">The motion</h2>\n"
         "<noscript><p>The motion and the curves are drawn by a script, which "
         "this browser does not run.</p></noscript>\n"
         "<div class=\"motion\"><div id=\"stage\"></div>"
         "<div id=\"lens\" hidden=\"hidden\"></div></div>\n" +
         controls(scene) + key(scene, result) +
         fmt::format(
             "<p class=\"about\" id=\"motion-words\">{}Arrows are forces on "
             "the body{}.</p>\n"
             "<p class=\"about keys\">Space plays and stops; ← and → move by a "
             "hundredth of the time, with Shift by a tenth. Dragging on a "
             "curve "
             "moves the body; dragging with Shift enlarges, a double click "
             "shows "
             "all again.</p>\n"
             "<p class=\"about\" id=\"beyond-words\" hidden=\"hidden\">A "
             "triangle marks where a curve leaves its picture, as some do "
             "without bound at the start.</p>\n"
             "<div id=\"curves\"></div>\n<p class=\"about\">{}</p>\n"
             "</section>\n",
             said,
             scene.world.field_varies() ? "" : ", of which the weight is 1 m g",
             held);
}

std::string section(std::string_view heading, const std::string& content) {
  if (content.empty()) return {};
  return fmt::format("<section>\n<h2>{}</h2>\n{}</section>\n", heading,
                     content);
}

std::string repeat_section(const Json& result) {
  return "<p>The result beside this page is a problem file too. This solves "
         "the scene again:</p>\n<pre>brachisto solve result.json --out "
         "again</pre>\n"
         "<details><summary>The problem file, defaults filled in</summary>\n"
         "<pre>" +
         xml_escaped(at(result, "input").dump(2)) + "</pre></details>\n" +
         provenance_tables(result);
}

/// Which entries of the KKT matrix of one element may be other than zero, of
/// the formulation rolling_time without limits in an ordinary world.
/// \param degree    p
/// \param elements  of the mesh, told in the words below it
std::string block_drawing(const Scene& scene, int degree, int elements) {
  // Its entries are where they are whatever the slope at B is.
  const RollingTime element(scene, uniform_mesh(degree, 1), 0.0);
  const int n = element.num_variables(), size = n + element.num_constraints();
  std::set<std::pair<int, int>> entries;  // row and column
  const auto put = [&](int row, int column) {
    entries.emplace(row, column);
    entries.emplace(column, row);
  };
  element.hess_lag_pattern().for_each(
      [&](std::size_t, int row, int column) { put(row, column); });
  element.jac_g_pattern().for_each(
      [&](std::size_t, int row, int column) { put(n + row, column); });
  // Entries side by side are one rectangle.
  std::string path;
  for (auto entry = entries.begin(); entry != entries.end();) {
    const auto [row, column] = *entry;
    int end = column;
    while (entry != entries.end() && *entry == std::pair{row, end}) {
      ++entry;
      ++end;
    }
    fmt::format_to(std::back_inserter(path), "M{} {}h{}v1h{}z", column, row,
                   end - column, column - end);
  }
  return fmt::format(
      "<figure class=\"small block\"><svg viewBox=\"-1 -1 {0} {0}\" "
      "role=\"img\" aria-label=\"Pattern of the KKT matrix of one element\">"
      "<path class=\"frame\" d=\"M0 0H{1}V{1}H0zM{2} 0V{1}M0 {2}H{1}\"/>"
      "<path class=\"entries\" d=\"{3}\"/></svg><figcaption>Where the KKT "
      "matrix of one element of degree {4} may have entries, {5} in all: the "
      "Hessian of its {2} variables to the upper left, the Jacobian of its {6} "
      "rows below. The mesh of this answer is a chain of {7}, neighbours "
      "sharing a node, bordered by one variable of all, "
      "U.</figcaption></figure>\n",
      size + 2, size, n, path, degree, entries.size(), size - n, elements);
}

/// The matrix, where the answer was found by collocation in the rolling time on
/// its own, as most are.
std::string matrix(const Json& result, const Scene& scene) {
  const bool plain =
      scene.world.ordinary() && !scene.limits.any() && !scene.path;
  const Json& options =
      at(at(at(result, "provenance"), "options"), "discretisation");
  const Json& mesh = at(result, "mesh");
  const double degree = number(mesh, "degree");
  const double elements = number(mesh, "elements");
  constexpr double kHighest = 8.0;  // of all meshes
  // Written so that what is no number is none.
  const bool known = degree >= 1.0 && degree <= kHighest && elements >= 1.0;
  if (!plain || !known || at(options, "formulation") != "rolling_time") {
    return {};
  }
  return block_drawing(scene, static_cast<int>(degree),
                       static_cast<int>(elements));
}

/// Tables as programs read them, folded; open where a check failed.
std::string all_that_is_known(const Json& result, const Scene& scene) {
  const auto folded = [](const std::string& summary, const std::string& content,
                         bool open = false) {
    return content.empty() ? "" : report::folded_html(summary, content, open);
  };
  const auto [passed, checks] = checks_of(result);
  return folded(fmt::format("The certificate: {} of {} checks passed", passed,
                            checks),
                certificate_table(result), passed < checks) +
         folded("What was asked, key by key", asked_table(result)) +
         folded("What was found, key by key", found_table(result)) +
         folded("How it was found: mesh, iterations and times",
                way_tables(result) + matrix(result, scene)) +
         folded("How to repeat it", repeat_section(result));
}

/// "A cylinder, 3 m across and 1 m down: 1.14671 s".
std::string headline(const Json& result, const Scene& scene) {
  return fmt::format("A {}, {} m across and {} m {}: {} s",
                     !scene.body.rolls() ? "bead"
                     : scene.body.ball   ? "ball"
                                         : "cylinder",
                     printed(scene.L), printed(std::abs(scene.H)),
                     scene.H < 0.0 ? "up" : "down",
                     printed(number(result, "transit_time")));
}

}  // namespace

std::string answer_page(const Json& result, const Scene& scene,
                        const TrajectoryTable& table) {
  const ThinnedTable rows = rows_for_page(table, scene);
  std::string kind(report::track_kind(scene));
  kind[0] = static_cast<char>(std::toupper(kind[0]));
  const std::string title = headline(result, scene);
  std::string out =
      report::document_head(xml_escaped(title), {kChartStyle, kAnswerStyle});
  out += fmt::format("<header>\n<h1>{}</h1>\n<p class=\"about\">{}: {}</p>\n",
                     xml_escaped(title), kind,
                     report::html_words(report::in_words(scene)));
  if (scene.limits.any()) {
    out += fmt::format("<p class=\"about\">Limits: {}</p>\n",
                       report::html_words(report::limits_in_words(scene)));
  }
  out += verdict(result) + numbers(result, table) + "</header>\n<main>\n" +
         motion_section(scene, result, rows) +
         section("What the limits cost", limits_table(result)) +
         section("How the time changes with the scene",
                 sensitivities_tables(result)) +
         section("All that is known", all_that_is_known(result, scene));
  out += fmt::format(
      "</main>\n<footer>Written from a result of brachisto {}. Curves by "
      "dygraphs, whose licence is in the source of this page.</footer>\n",
      xml_escaped(version_in(result)));
  out += report::data_html(motion_data(rows.table, scene, result,
                                       motion_box(rows.table, scene.body)));
  out += report::script_html(
      fmt::format("/*!\n{}*/\n{}", kChartLicence, kChartScript));
  out +=
      report::script_html(kMotionScript) + report::script_html(kAnswerScript);
  return out + "</body>\n</html>\n";
}

}  // namespace brachisto::plot
