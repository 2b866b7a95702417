// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/figure.hpp"

#include <fmt/format.h>

#include <cmath>

#include "brachisto/math/clock.hpp"
#include "process/child_process.hpp"
#include "report/rich_text.hpp"
#include "report/svg_theme.hpp"

namespace brachisto::report {

namespace {

constexpr double kFontSize = 13.0;  // [px]
constexpr double kDrawingSeconds = 60.0;

/// With letters of equal size in both formats, and dashes in units of the width
/// of a line: a dash of length 1 is half of that in SVG (measured with gnuplot
/// 5.4).
std::string terminal(const Figure& figure, Format format) {
  constexpr double kDashInSvg = 1.0 / 0.5, kPointsPerPixel = 0.75;
  if (format == Format::Gif) {
    return fmt::format(
        "gif animate delay {} loop 0 enhanced size {:.0f},{:.0f} "
        "font 'DejaVu Sans,{:.4g}'",
        figure.frame_delay, figure.width, figure.height,
        kFontSize * kPointsPerPixel);
  }
  return fmt::format(
      "svg enhanced size {:.0f},{:.0f} font 'DejaVu Sans,{:.4g}' "
      "dashlength {:.4g} background '#ffffff'",
      figure.width, figure.height, kFontSize, kDashInSvg);
}

std::string script(const Figure& figure, Format format, std::string_view data) {
  return fmt::format(
      "set encoding utf8\n"
      "set minussign\n"
      "set terminal {}\n"
      "data = '{}'\n"
      "set datafile separator comma\n"
      "part(p, c) = strcol('part') eq p ? column(c) : NaN\n"
      "{}",
      terminal(figure, format), data, figure.commands);
}

/// gnuplot calls every SVG document by its own name.
std::string with_title(std::string svg, const std::string& title) {
  constexpr std::string_view kIts = "<title>Gnuplot</title>";
  const std::size_t at = svg.find(kIts);
  if (at == std::string::npos || title.empty()) return svg;
  return svg.replace(at, kIts.size(),
                     "<title>" + xml_escaped(title) + "</title>");
}

}  // namespace

double PixelScale::operator()(double value) const {
  const double share = logarithmic
                           ? std::log(value / low) / std::log(high / low)
                           : (value - low) / (high - low);
  return std::lerp(from, to, share);
}

DrawnFiles draw(const Figure& figure, Format format,
                const std::atomic<int>* interrupt) {
  const std::string picture =
      figure.name + (format == Format::Svg ? ".svg" : ".gif");
  DrawnFiles drawn;
  drawn.files = {{figure.name + ".csv", figure.table},
                 {figure.name + ".gp",
                  fmt::format("# gnuplot {0}.gp draws {0}.csv as {1}\n"
                              "set output '{1}'\n",
                              figure.name, picture) +
                      script(figure, format, figure.name + ".csv")}};
  const auto without = [&](std::string_view why) {
    drawn.missing = fmt::format("{} is not drawn: {}; gnuplot {}.gp draws it",
                                picture, why, figure.name);
    return drawn;
  };
  const auto programs = programs_on_path("gnuplot");
  if (programs.empty()) {
    return without("gnuplot is not installed (Debian: gnuplot-nox)");
  }
  // The table goes along as a block of data, so that no file has to exist yet.
  const ChildRun run = run_child(
      programs.front(), {"--default-settings"}, kDrawingSeconds, interrupt,
      "$table << END_OF_TABLE\n" + figure.table + "END_OF_TABLE\n" +
          script(figure, format, "$table"));
  switch (run.end) {
    case ChildRun::End::Interrupted:
      throw Stopped();
    case ChildRun::End::OutOfTime:
      return without(
          fmt::format("gnuplot took more than {:g} s", kDrawingSeconds));
    case ChildRun::End::Signalled:
      return without(fmt::format("gnuplot was ended by signal {}", run.code));
    case ChildRun::End::Exited:
      break;
  }
  if (run.code != 0 || run.out.empty()) {
    return without(fmt::format("gnuplot ended with exit code {}", run.code));
  }
  if (format != Format::Svg) {
    drawn.files.push_back({picture, run.out});
    return drawn;
  }
  drawn.files.push_back(
      {picture, with_theme(with_title(run.out, figure.title))});
  return drawn;
}

std::string gnuplot_escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '\'') {
      out += "''";
    } else if (static_cast<unsigned char>(c) < ' ') {
      out += ' ';
    } else {
      if (std::string_view("\\_^{}@&~").find(c) != std::string_view::npos) {
        out += '\\';
      }
      out += c;
    }
  }
  return out;
}

}  // namespace brachisto::report
