// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "plot/answer_card.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "math/angle.hpp"
#include "plot/answer_tables.hpp"
#include "plot/motion_data.hpp"
#include "plot/result_values.hpp"
#include "report/path_frame.hpp"
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

/// Dashes of tracks that share a colour.
constexpr std::array kTrackDashes{"", "7 3", "2 3", "9 3 2 3"};

/// Between ticks: 1, 2 or 5 times a power of ten, at most so many steps on a
/// range.
double tick_step(double range, double most) {
  const double least = range / most;
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double part : {1.0, 2.0, 5.0}) {
    if (part * power >= least) return part * power;
  }
  return 10.0 * power;
}

/// How a track is drawn.
/// \param below  tracks that it covers, which show through its gaps
std::string stroke(std::size_t racer, std::size_t below = 0) {
  constexpr std::size_t kColours = std::size(kCardColours);
  std::string dash = kTrackDashes[racer / kColours % kTrackDashes.size()];
  if (below > 0) dash = fmt::format("6 {}", 6 * below);
  return fmt::format(
      "fill=\"none\" stroke=\"{}\" stroke-width=\"2\"{}",
      kCardColours[racer % kColours],
      dash.empty() ? "" : fmt::format(" stroke-dasharray=\"{}\"", dash));
}

/// From a place to the track, a chain of chords [m].
double distance_to(const TrajectoryTable& table, Point p) {
  const std::vector<double>&x = table["x_b"], &z = table["z_b"];
  double least = std::hypot(x[0] - p.x, z[0] - p.z);
  for (std::size_t i = 1; i < x.size(); ++i) {
    const double dx = x[i] - x[i - 1], dz = z[i] - z[i - 1];
    const double square = dx * dx + dz * dz;
    const double along = (p.x - x[i - 1]) * dx + (p.z - z[i - 1]) * dz;
    const double part = square > 0.0 ? std::clamp(along / square, 0.0, 1.0) : 0;
    least = std::min(least, std::hypot(x[i - 1] + part * dx - p.x,
                                       z[i - 1] + part * dz - p.z));
  }
  return least;
}

/// A part of the plane, z down, in equal scales.
class Drawing {
 public:
  explicit Drawing(const Box& box)
      : box_(box),
        scale_(std::min(kWidest / box.width(), kHighest / box.height())),
        width_(kLeft + scale_ * box.width() + kRight),
        height_(kTop + scale_ * box.height() + kBottom) {}

  void axes() {
    constexpr double kBetweenX = 60.0, kBetweenZ = 40.0;
    ticks(box_.low.x, box_.high.x, kBetweenX, [&](double x, const auto& label) {
      put("<path d=\"M{:.1f} {:.1f}v4\"/>", px(x), bottom());
      text(px(x), bottom() + 16.0, "text-anchor=\"middle\"", label);
    });
    ticks(box_.low.z, box_.high.z, kBetweenZ, [&](double z, const auto& label) {
      put("<path d=\"M{:.1f} {:.1f}h-4\"/>", kLeft, pz(z));
      text(kLeft - 7.0, pz(z) + 4.0, "text-anchor=\"end\"", label);
    });
    put("<path d=\"M{:.1f} {:.1f}V{:.1f}H{:.1f}\"/>", kLeft, kTop, bottom(),
        right());
    text(0.5 * (kLeft + right()), bottom() + 34.0, "text-anchor=\"middle\"",
         "x [m]");
    const double middle = 0.5 * (kTop + bottom());
    text(14.0, middle,
         fmt::format(
             "text-anchor=\"middle\" transform=\"rotate(-90 14 {:.1f})\"",
             middle),
         "z, down [m]");
  }

  /// What limits keep the body out of.
  void obstacles(const PathLimits& limits) {
    for (const report::Outline& area :
         report::obstacles(limits, box_.low, box_.high)) {
      std::string corners;
      for (const Point corner : area) corners += place(corner) + " ";
      put("<polygon points=\"{}\" fill=\"currentColor\" fill-opacity=\"0.15\" "
          "stroke=\"none\"/>",
          corners);
    }
  }

  /// Of points that nobody could tell apart, the first one.
  void track(const TrajectoryTable& table, const std::string& style) {
    constexpr double kTooNear = 0.3;  // [px]
    const std::vector<double>&x = table["x_b"], &z = table["z_b"];
    std::string line = place({x[0], z[0]});
    std::size_t last = 0;
    for (std::size_t i = 1; i < x.size(); ++i) {
      const double step = scale_ * std::hypot(x[i] - x[last], z[i] - z[last]);
      if (step < kTooNear && i + 1 < x.size()) continue;
      line += " " + place({x[i], z[i]});
      last = i;
    }
    put("<polyline points=\"{}\" {}/>", line, style);
  }

  /// Whether one track would hide the other.
  [[nodiscard]] bool cover(const TrajectoryTable& one,
                           const TrajectoryTable& other) const {
    constexpr double kNear = 1.5;  // [px]
    constexpr int kPlaces = 8;     // that are looked at, between A and B
    const std::vector<double>&x = one["x_b"], &z = one["z_b"];
    for (std::size_t i = 1; i < kPlaces; ++i) {
      const std::size_t at = i * (x.size() - 1) / kPlaces;
      if (scale_ * distance_to(other, {x[at], z[at]}) > kNear) return false;
    }
    return true;
  }

  void body(const Body& body, const Pose& pose) {
    const Point contact = pose.contact(body);
    if (!body.rolls()) {
      dot(contact, 4.0, kCardColours[0]);
      return;
    }
    put("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"none\" "
        "stroke-opacity=\"0.7\"/>",
        px(pose.centre.x), pz(pose.centre.z), scale_ * body.radius);
    if (body.off_centred()) {
      const Point mass = pose.mass_centre(body);
      put("<path d=\"M{} L{}\" stroke-opacity=\"0.7\"/>", place(pose.centre),
          place(mass));
      dot(mass, 2.5, kCardColours[1]);
    }
    dot(contact, 2.0, kCardColours[0]);
  }

  /// \param offset  of the letter [px]
  void end(const char* name, Point at, Point offset) {
    dot(at, 3.0, "currentColor");
    text(px(at.x) + offset.x, pz(at.z) + offset.z,
         "text-anchor=\"middle\" font-weight=\"bold\"", name);
  }

  /// \param title  what it shows, plain: for those who cannot see it
  [[nodiscard]] std::string svg(const std::string& title) const {
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} "
        "{1:.0f}\" width=\"{0:.0f}\" role=\"img\" aria-label=\"{2}\" "
        "style=\"max-width:100%;height:auto\"><title>{2}</title>"
        "<g fill=\"none\" stroke=\"currentColor\">{3}</g>"
        "<g fill=\"currentColor\" font-family=\"sans-serif\" "
        "font-size=\"12\">{4}</g></svg>\n",
        width_, height_, xml_escaped(title), shapes_, words_);
  }

 private:
  // Lengths [px].
  static constexpr double kLeft = 58.0, kTop = 10.0, kRight = 14.0,
                          kBottom = 40.0, kWidest = 420.0, kHighest = 300.0;

  [[nodiscard]] double px(double x) const {
    return kLeft + scale_ * (x - box_.low.x);
  }
  [[nodiscard]] double pz(double z) const {
    return kTop + scale_ * (z - box_.low.z);
  }
  [[nodiscard]] double right() const { return width_ - kRight; }
  [[nodiscard]] double bottom() const { return height_ - kBottom; }
  [[nodiscard]] std::string place(Point p) const {
    return fmt::format("{:.1f},{:.1f}", px(p.x), pz(p.z));
  }

  void dot(Point p, double radius, const char* colour) {
    put("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" fill=\"{}\" "
        "stroke=\"none\"/>",
        px(p.x), pz(p.z), radius, colour);
  }

  /// \param between  pixels that two of them need
  template <class Put>
  void ticks(double low, double high, double between, const Put& put_tick) {
    const double most = std::max(2.0, scale_ * (high - low) / between);
    const double step = tick_step(high - low, most);
    const auto first = std::ceil(low / step), last = std::floor(high / step);
    for (double i = first; i <= last; ++i) {
      // A zero has no sign.
      const double value = i == 0.0 ? 0.0 : i * step;
      put_tick(value, printed(value));
    }
  }

  template <class... Args>
  void put(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(shapes_), format,
                   std::forward<Args>(args)...);
  }

  void text(double x, double y, std::string_view style,
            std::string_view content) {
    words_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>", x, y,
                          style, xml_escaped(content));
  }

  Box box_;
  double scale_;  ///< [px/m]
  double width_, height_;
  std::string shapes_, words_;
};

/// From contact to contact.
void name_ends(Drawing& drawing, const TrajectoryTable& table) {
  const std::vector<double>&x = table["x_b"], &z = table["z_b"];
  // Where the track does not go.
  drawing.end("A", {x.front(), z.front()}, {-12.0, 4.0});
  drawing.end("B", {x.back(), z.back()}, {0.0, 16.0});
}

std::string card(const std::string& content) {
  return "<div class=\"brachisto-card\" style=\"display:flex;flex-wrap:wrap;"
         "gap:1em 2em;align-items:center\">\n" +
         content + "</div>\n";
}

/// A row of a list: its name and its value, both HTML.
std::string row(std::string_view name, const std::string& value) {
  return fmt::format(
      "<tr><th scope=\"row\" style=\"text-align:left\">{}</th>"
      "<td style=\"text-align:left\">{}</td></tr>\n",
      name, value);
}

std::string judged(const Json& result) {
  if (!is_true(result, "verified")) return "not verified";
  if (is_true(result, "feasible")) return "verified, feasible";
  return "verified, infeasible" + reasons_html(result, "infeasible_because");
}

std::string figure_rows(const Json& result, const Scene& scene) {
  std::string out =
      row("transit time T", time_text(result, "transit_time") + " s") +
      row("τ = T √(2g/H)", time_text(result, "tau")) +
      row("length of the track", printed(number(result, "rail_length")) + " m");
  const double turned = number(result, "rotation");
  if (scene.body.rolls() && std::isfinite(turned)) {
    out += row("the body turns", printed(math::in_degrees(turned)) + "°");
  }
  if (const std::string force = force_text(result); !force.empty()) {
    out += row(symbols_html("normal force R_n"), force);
  }
  return out + row("verdict", judged(result));
}

}  // namespace

std::string answer_card(const Json& result, const Scene& scene,
                        const TrajectoryTable& table) {
  Drawing drawing(motion_box(table, scene.body));
  drawing.obstacles(scene.limits);
  drawing.axes();
  drawing.track(table, stroke(0));
  constexpr int kSteps = 5;
  for (int i = 0; i <= kSteps; ++i) {
    drawing.body(scene.body, table.pose(i * table.time().back() / kSteps));
  }
  name_ends(drawing, table);
  const std::string kind(report::track_kind(scene));
  return card(
      drawing.svg(fmt::format("The {} from A to B, with the body at equal "
                              "times",
                              kind)) +
      fmt::format("<table>\n<caption style=\"text-align:left\">{}; {}"
                  "</caption>\n<tbody>\n{}</tbody>\n</table>\n",
                  xml_escaped(kind),
                  report::html_words(report::in_words(scene)),
                  figure_rows(result, scene)));
}

std::string failure_card(const Json& result) {
  return card(
      fmt::format("<table>\n<tbody>\n{}{}{}</tbody>\n</table>\n",
                  row("status", xml_escaped(text_of(result, "status"))),
                  row("why", symbols_html(text_of(result, "message"))),
                  row("verdict", "not verified: there is no motion to show")));
}

std::string race_card(const std::vector<Racer>& racers) {
  Drawing drawing(motion_box(racers));
  drawing.axes();
  std::string rows;
  for (std::size_t i = 0; i < racers.size(); ++i) {
    const Racer& racer = racers[i];
    const auto below = static_cast<std::size_t>(std::count_if(
        racers.begin(), racers.begin() + static_cast<std::ptrdiff_t>(i),
        [&](const Racer& earlier) {
          return drawing.cover(racer.table, earlier.table);
        }));
    const std::string style = stroke(i, below);
    drawing.track(racer.table, style);
    constexpr double kShownOfT = 5e-7;  // [s]
    const double T = number(racer.result, "transit_time");
    const double error = number(racer.result, "estimated_error") * T;
    rows += fmt::format(
        "<tr><td>{}</td><th scope=\"row\" style=\"text-align:left\">"
        "<svg viewBox=\"0 0 30 6\" width=\"30\" height=\"6\" "
        "aria-hidden=\"true\"><path d=\"M0 3H30\" {}/></svg> {}{}</th>"
        "<td>{}</td><td>{}</td></tr>\n",
        i + 1, style, xml_escaped(racer.name),
        is_true(racer.result, "feasible") ? "" : " (infeasible)",
        report::within_error(T, std::max(error, kShownOfT)),
        behind(racers.front(), racer));
  }
  name_ends(drawing, racers.front().table);
  return card(drawing.svg(fmt::format("The tracks of {} bodies from A to B",
                                      racers.size())) +
              "<table>\n<caption style=\"text-align:left\">The order of arrival"
              "</caption>\n<thead><tr><th>place</th><th>body</th><th>T [s]</th>"
              "<th>behind [ms]</th></tr></thead>\n<tbody>\n" +
              rows + "</tbody>\n</table>\n");
}

}  // namespace brachisto::plot
