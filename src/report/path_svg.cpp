// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/report/path_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "report/axis.hpp"
#include "report/svg.hpp"
#include "report/track_kind.hpp"

namespace brachisto::report {

namespace {

constexpr double kPlotWidth = 860.0;  // of the coordinate box [px]
constexpr double kLargestHeight = 1200.0;
constexpr double kMarginLeft = 70.0;
constexpr double kMarginRight = 30.0;
constexpr double kMarginTop = 54.0;
constexpr double kMarginBottom = 96.0;

/// Axis-aligned box in metres.
struct Box {
  double left, right, top, bottom;  // top < bottom, for z points down

  void include(Point p, double radius) {
    left = std::min(left, p.x - radius);
    right = std::max(right, p.x + radius);
    top = std::min(top, p.z - radius);
    bottom = std::max(bottom, p.z + radius);
  }
};

/// The drawing: maps metres to pixels and collects elements.
class Canvas {
 public:
  explicit Canvas(const Box& box)
      : box_(box),
        scale_(std::min(kPlotWidth / (box.right - box.left),
                        kLargestHeight / (box.bottom - box.top))) {}

  [[nodiscard]] double width() const {
    return (box_.right - box_.left) * scale_;
  }
  [[nodiscard]] double height() const {
    return (box_.bottom - box_.top) * scale_;
  }
  [[nodiscard]] double x(double metres) const {
    return kMarginLeft + (metres - box_.left) * scale_;
  }
  [[nodiscard]] double z(double metres) const {
    return kMarginTop + (metres - box_.top) * scale_;
  }

  [[nodiscard]] Pixel pixel(Point p) const { return {x(p.x), z(p.z)}; }
  [[nodiscard]] double pixels(double metres) const { return metres * scale_; }

  void curve(const std::vector<Point>& points, std::string_view style) {
    // Where points crowd, those that nobody could tell apart are left out.
    constexpr double kTooNear = 0.2;  // [px]
    std::vector<Pixel> drawn{pixel(points.front())};
    for (const Point& p : points) {
      const Pixel next = pixel(p);
      const Pixel& last = drawn.back();
      const bool too_near =
          std::hypot(next.x - last.x, next.y - last.y) < kTooNear;
      if (!too_near) drawn.push_back(next);
    }
    drawn.push_back(pixel(points.back()));
    svg_.polyline(drawn, style);
  }
  void circle(Point centre, double radius, std::string_view style) {
    svg_.circle(pixel(centre), radius, style);
  }
  void text(double px, double py, std::string_view attributes,
            std::string_view content) {
    svg_.text({px, py}, attributes, content);
  }
  void line(double x1, double y1, double x2, double y2,
            std::string_view style) {
    svg_.line({x1, y1}, {x2, y2}, style);
  }
  void axes();

  [[nodiscard]] std::string document() const {
    return svg_.document(width() + kMarginLeft + kMarginRight,
                         height() + kMarginTop + kMarginBottom);
  }

 private:
  Box box_;
  double scale_;
  Svg svg_;
};

void Canvas::axes() {
  const double bottom = z(box_.bottom);
  const double step =
      tick_step(std::max(box_.right - box_.left, box_.bottom - box_.top), 8);
  constexpr std::string_view kGrid = "stroke=\"#dddddd\" stroke-width=\"1\"";
  // Adding zero turns −0 into 0.
  const auto first = [&](double low) { return std::ceil(low / step) + 0.0; };
  for (double i = first(box_.left); i * step <= box_.right; ++i) {
    line(x(i * step), z(box_.top), x(i * step), bottom, kGrid);
    text(x(i * step), bottom + 18.0, "text-anchor=\"middle\" fill=\"#333\"",
         fmt::format("{:.6g}", i * step));
  }
  for (double i = first(box_.top); i * step <= box_.bottom; ++i) {
    line(x(box_.left), z(i * step), x(box_.right), z(i * step), kGrid);
    text(x(box_.left) - 8.0, z(i * step) + 5.0,
         "text-anchor=\"end\" fill=\"#333\"", fmt::format("{:.6g}", i * step));
  }
  text(kMarginLeft + 0.5 * width(), bottom + 40.0, "text-anchor=\"middle\"",
       "x [m]");
  const double middle = kMarginTop + 0.5 * height();
  text(18.0, middle,
       fmt::format("text-anchor=\"middle\" transform=\"rotate(-90 18 {:.1f})\"",
                   middle),
       "z [m], down");
}

constexpr std::string_view kTrack =
    "fill=\"none\" stroke=\"black\" stroke-width=\"2.6\"";
constexpr std::string_view kCentre =
    "fill=\"none\" stroke=\"#666666\" stroke-width=\"1.4\" "
    "stroke-dasharray=\"7 4\"";
constexpr std::string_view kMassCentre =
    "fill=\"none\" stroke=\"#1f5fa8\" stroke-width=\"1.6\" "
    "stroke-dasharray=\"2 3\"";

void draw_body(Canvas& canvas, const Body& body, const TrajectoryPoint& at) {
  if (!body.rolls()) {
    canvas.circle(at.centre, 5.0, "fill=\"#444444\"");
    return;
  }
  canvas.circle(at.centre, canvas.pixels(body.radius),
                "fill=\"#cccccc\" fill-opacity=\"0.35\" stroke=\"#444444\"");
  canvas.circle(at.centre, 2.0, "fill=\"#444444\"");
  if (body.off_centred()) {
    canvas.circle(at.motion.mass_centre, 5.0, "fill=\"#1f5fa8\"");
  }
}

void draw_legend(Canvas& canvas, const Body& body) {
  const double y = kMarginTop + canvas.height() + 72.0;
  double x = kMarginLeft;
  const auto entry = [&](std::string_view style, std::string_view label,
                         double width) {
    canvas.line(x, y, x + 40.0, y, style);
    canvas.text(x + 48.0, y + 5.0, "", label);
    x += width;
  };
  entry(kTrack, "track", 120.0);
  if (!body.rolls()) return;
  entry(kCentre, "centre", 130.0);
  if (body.off_centred()) entry(kMassCentre, "centre of mass", 180.0);
}

}  // namespace

std::string path_svg(const Motion& motion) {
  const Body& body = motion.scene().body;
  const std::vector<TrajectoryPoint> rows = motion.fine_sample(600);
  std::vector<Point> track, centre, mass_centre;
  Box box{0.0, 0.0, 0.0, 0.0};
  for (const TrajectoryPoint& row : rows) {
    track.push_back(row.motion.contact);
    centre.push_back(row.centre);
    mass_centre.push_back(row.motion.mass_centre);
    box.include(row.motion.contact, 0.0);
    box.include(row.motion.mass_centre, 0.0);
    box.include(row.centre, 0.0);
  }
  box.include(rows.front().centre, body.radius);
  box.include(rows.back().centre, body.radius);
  const double margin =
      0.03 * std::max(box.right - box.left, box.bottom - box.top);
  box = {box.left - margin, box.right + margin, box.top - margin,
         box.bottom + margin};

  Canvas canvas(box);
  canvas.axes();
  draw_body(canvas, body, rows.front());
  draw_body(canvas, body, rows.back());
  if (body.rolls()) canvas.curve(centre, kCentre);
  if (body.off_centred()) canvas.curve(mass_centre, kMassCentre);
  canvas.curve(track, kTrack);
  const auto label = [&](Point at, std::string_view letter) {
    canvas.circle(at, 3.5, "fill=\"white\" stroke=\"black\"");
    canvas.text(canvas.x(at.x) - 14.0, canvas.z(at.z) + 16.0,
                "font-style=\"italic\"", letter);
  };
  label(rows.front().motion.contact, "A");
  label(rows.back().motion.contact, "B");
  std::string title(track_kind(motion.scene()));
  title[0] = static_cast<char>(std::toupper(title[0]));
  canvas.text(kMarginLeft, 30.0, "font-size=\"17\"",
              fmt::format("{}: τ = {:.8f}, T = {:.6g} s", xml_escaped(title),
                          motion.tau(), motion.transit_time()));
  draw_legend(canvas, body);
  return canvas.document();
}

}  // namespace brachisto::report
