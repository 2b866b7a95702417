// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/cutting_template.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "report/letters.hpp"
#include "report/solutions.hpp"
#include "report/xml.hpp"

namespace brachisto {
namespace {

using report::cutting::cutting_template;
using report::cutting::Drawing;
using report::cutting::Line;
using report::cutting::Polyline;
using testing::bead_solution;
using testing::off_centred_solution;
using testing::xml_flaw;

constexpr double kChord = 0.01;  // [mm], as promised

std::vector<Drawing> drawings_of(const Solution& solution,
                                 const report::cutting::Sheet& sheet = {}) {
  return cutting_template(solution, {}, sheet);
}

bool is_track(const Drawing& drawing) {
  return drawing.name.starts_with("track-");
}

/// Of a strip: the first half of its outline is the track.
std::vector<Point> track_of(const Drawing& piece) {
  const std::vector<Point>& outline = piece.polylines.front().points;
  return {outline.begin(),
          outline.begin() + static_cast<std::ptrdiff_t>(outline.size() / 2)};
}

double length_of(const std::vector<Point>& points) {
  double sum = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    sum += std::hypot(points[i].x - points[i - 1].x,
                      points[i].z - points[i - 1].z);
  }
  return sum;
}

TEST(CuttingTemplate, PiecesAreTogetherAsLongAsTheTrack) {
  for (const Solution& solution : {bead_solution(), off_centred_solution()}) {
    double length = 0.0;
    for (const Drawing& drawing : drawings_of(solution)) {
      if (is_track(drawing)) length += length_of(track_of(drawing));
    }
    // A chord of height h over an arc of length c is shorter by 8 h²/(3 c),
    // h = 0.01 mm, and there are not a hundred chords in 100 mm.
    EXPECT_NEAR(length / (1e3 * solution.motion()->rail_length()), 1.0, 1e-5);
  }
}

TEST(CuttingTemplate, TheEdgeOfABeadIsACycloid) {
  // x = a (ψ − sin ψ), z = a (1 − cos ψ), with a and the end of ψ by B.
  const Solution solution = bead_solution();
  const double L = 1e3 * solution.scene.L, H = 1e3 * solution.scene.H;
  double low = 1e-3, high = 2.0 * std::acos(-1.0) - 1e-3;
  for (int i = 0; i < 200; ++i) {
    const double psi = 0.5 * (low + high);
    const double ratio = (psi - std::sin(psi)) / (1.0 - std::cos(psi));
    (ratio < L / H ? low : high) = psi;
  }
  const double a = H / (1.0 - std::cos(low));
  // z at x, by Newton's method on ψ.
  const auto depth_at = [&](double x) {
    double psi = std::cbrt(6.0 * x / a);
    for (int i = 0; i < 100; ++i) {
      const double slope = 1.0 - std::cos(psi);
      if (slope < 1e-12) break;
      psi -= (psi - std::sin(psi) - x / a) / slope;
    }
    return a * (1.0 - std::cos(psi));
  };

  Point end{0.0, 0.0};  // of the piece before, on the track
  for (const Drawing& drawing : drawings_of(solution)) {
    const std::vector<Point> track = track_of(drawing);
    const Point shift{end.x - track.front().x, end.z - track.front().z};
    for (const Point p : track) {
      const double x = p.x + shift.x, z = p.z + shift.z;
      // Below the cusp the cycloid is steep: a bound of the distance is the
      // difference of depths over the slope's secant.
      if (x <= 1.0) continue;
      EXPECT_NEAR(z, depth_at(x), 1e-6 * H) << x;
    }
    end = {track.back().x + shift.x, track.back().z + shift.z};
  }
  EXPECT_NEAR(end.x, L, 1e-6 * L);
  EXPECT_NEAR(end.z, H, 1e-6 * H);
}

TEST(CuttingTemplate, ChordsAreAsNearAsTheySay) {
  // The middle of a chord is farthest from an arc, and the distance of a place
  // of the track between its ends tells it.
  const Solution solution = off_centred_solution();
  std::vector<Point> track;
  for (const Drawing& drawing : drawings_of(solution, {1e5, 1e5})) {
    if (is_track(drawing)) track = track_of(drawing);
  }
  const Point shift = track.front();
  for (int i = 1; i < 1000; ++i) {
    const Point on = solution.motion()->at(i / 1000.0).motion.contact;
    const double x = 1e3 * on.x + shift.x, z = 1e3 * on.z + shift.z;
    double nearest = 1e9;
    for (std::size_t j = 1; j < track.size(); ++j) {
      const Point a = track[j - 1], b = track[j];
      const double l2 = std::pow(b.x - a.x, 2) + std::pow(b.z - a.z, 2);
      const double t = std::clamp(
          ((x - a.x) * (b.x - a.x) + (z - a.z) * (b.z - a.z)) / l2, 0.0, 1.0);
      nearest = std::min(nearest, std::hypot(a.x + t * (b.x - a.x) - x,
                                             a.z + t * (b.z - a.z) - z));
    }
    EXPECT_LE(nearest, 1.1 * kChord);
  }
}

TEST(CuttingTemplate, EverythingIsOnItsSheet) {
  const report::cutting::Sheet sheet{300.0, 200.0};
  const std::vector<Drawing> drawings =
      drawings_of(off_centred_solution(), sheet);
  EXPECT_GT(drawings.size(), 10U);
  for (const Drawing& drawing : drawings) {
    for (const Polyline& polyline : drawing.polylines) {
      for (const Point p : polyline.points) {
        EXPECT_GE(std::min(p.x, p.z), 0.0);
        EXPECT_LE(p.x, drawing.width);
        EXPECT_LE(p.z, drawing.height);
      }
    }
    if (!is_track(drawing)) continue;
    EXPECT_EQ(drawing.width, sheet.width);
  }
}

TEST(CuttingTemplate, EverySheetTellsTheGripThatTheBodyNeeds) {
  for (const double width : {300.0, 600.0}) {
    for (const Drawing& drawing :
         drawings_of(off_centred_solution(), {width, 400.0})) {
      ASSERT_FALSE(drawing.labels.empty()) << drawing.name;
      const report::cutting::Label& grip = drawing.labels.back();
      EXPECT_TRUE(grip.text.starts_with("Grip: least friction coefficient "))
          << grip.text;
      EXPECT_TRUE(std::ranges::all_of(grip.text, [](char c) {
        return c >= ' ' && c <= '~';
      })) << "DXF has no others";
      // In wide letters, above what is cut.
      EXPECT_LE(
          grip.at.x + report::width_of(report::letters(grip.text), grip.size),
          drawing.width);
      EXPECT_GE(grip.size, is_track(drawing) ? 1.0 : 2.0) << "to be read";
      if (!is_track(drawing)) continue;
      for (const Point p : drawing.polylines.front().points) {
        EXPECT_GE(p.z, grip.at.z);
      }
    }
  }
  for (const Drawing& drawing : drawings_of(bead_solution())) {
    EXPECT_EQ(drawing.labels.size(), 1U) << "a bead rubs nowhere";
  }
}

TEST(CuttingTemplate, ABodyShowsItsCentreOfMassAndItsParts) {
  const Solution solution = off_centred_solution();
  const Body& body = solution.scene.body;
  const std::vector<MassPart> parts{MassPart::point(1.0, {0.1, 0.2})};

  const Drawing drawing = cutting_template(solution, parts, {}).back();

  EXPECT_EQ(drawing.name, "body");
  const double r = 1e3 * body.radius;
  EXPECT_NEAR(drawing.circles.front().radius, r, 1e-9 * r);
  const Point axis = drawing.circles.front().centre;
  // The second polyline is the level arm of the cross at the centre of mass.
  const std::vector<Point>& cross = drawing.polylines.at(1).points;
  EXPECT_NEAR(0.5 * (cross[0].x + cross[1].x) - axis.x,
              r * body.eta_m * std::cos(body.theta_m), 1e-9 * r);
  EXPECT_NEAR(cross[0].z - axis.z, r * body.eta_m * std::sin(body.theta_m),
              1e-9 * r);
  EXPECT_NEAR(drawing.circles.back().centre.x - axis.x, 100.0, 1e-9);
  EXPECT_NEAR(drawing.circles.back().centre.z - axis.z, 200.0, 1e-9);
}

TEST(CuttingTemplate, IsRefusedWhereNoPieceFits) {
  EXPECT_THROW(drawings_of(bead_solution(), {55.0, 55.0}),
               report::cutting::TemplateError);
}

TEST(Drawing, IsAnSvgOfItsSizeInMillimetres) {
  for (const Drawing& drawing : drawings_of(off_centred_solution())) {
    const std::string svg = report::cutting::as_svg(drawing);
    EXPECT_EQ(xml_flaw(svg), "");
    if (!is_track(drawing)) continue;
    EXPECT_NE(svg.find("width=\"600mm\" height=\"400mm\" "
                       "viewBox=\"0 0 600 400\""),
              std::string::npos);
  }
}

TEST(Drawing, IsADxfOfPairsThatEndsItsSections) {
  for (const Drawing& drawing : drawings_of(off_centred_solution())) {
    std::istringstream lines(report::cutting::as_dxf(drawing));
    std::vector<std::pair<int, std::string>> groups;
    for (std::string code, value;
         std::getline(lines, code) && std::getline(lines, value);) {
      groups.emplace_back(std::stoi(code), value);
    }
    ASSERT_EQ(groups.back(), (std::pair<int, std::string>{0, "EOF"}));
    int open = 0;
    std::size_t vertices = 0;
    for (const auto& [code, value] : groups) {
      if (code != 0) continue;
      if (value == "SECTION") ++open;
      if (value == "ENDSEC") --open;
      if (value == "VERTEX") ++vertices;
      EXPECT_TRUE(open == 0 || open == 1);
    }
    EXPECT_EQ(open, 0);
    std::size_t points = 0;
    for (const Polyline& polyline : drawing.polylines) {
      points += polyline.points.size();
    }
    EXPECT_EQ(vertices, points);
  }
}

}  // namespace
}  // namespace brachisto
