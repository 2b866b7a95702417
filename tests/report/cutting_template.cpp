// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/cutting_template.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "brachisto/study/solve.hpp"
#include "report/cutting_parts.hpp"
#include "report/cutting_reading.hpp"
#include "report/letters.hpp"
#include "report/solutions.hpp"
#include "report/xml.hpp"
#include "support/world_scenes.hpp"

namespace brachisto {
namespace {

using report::cutting::Build;
using report::cutting::check_build;
using report::cutting::cutting_template;
using report::cutting::Drawing;
using report::cutting::Label;
using report::cutting::Part;
using report::cutting::TemplateError;
using testing::bead_solution;
using testing::corners;
using testing::CutPiece;
using testing::Dxf;
using testing::DxfEntity;
using ::testing::HasSubstr;
using testing::joined;
using testing::length_of;
using testing::off_centred_solution;
using testing::pieces_in;
using testing::read_dxf;
using testing::uniform_solution;
using testing::xml_flaw;

constexpr double kChord = 0.005;  // [mm], as promised

/// A fifth of the reference scene, which its sheets have room for.
Build fifth() {
  Build build;
  build.scale = 0.2;
  return build;
}
Build small_rails() {
  Build build = fifth();
  build.width = 420.0;
  build.height = 297.0;
  build.strip = 30.0;
  build.hole = 4.0;
  build.thickness = 5.0;
  build.gauge = 25.0;
  return build;
}

std::vector<Drawing> drawings_of(const Solution& solution, const Build& build) {
  return cutting_template(solution, {}, build);
}

bool is_cut(const Drawing& drawing) {
  return drawing.name.starts_with("sheet-");
}

std::string words_on(const Drawing& drawing) {
  std::string out;
  for (const Label& label : drawing.shapes.labels) out += label.text + " ";
  return out;
}

std::string why_refused(const auto& action) {
  try {
    action();
  } catch (const TemplateError& error) {
    return error.what();
  }
  return "";
}

TEST(CuttingTemplate, JoinedPiecesAreTheTrack) {
  for (const Build& build : {fifth(), small_rails()}) {
    for (const Solution* solution :
         {&bead_solution(), &uniform_solution(), &off_centred_solution()}) {
      const auto pieces =
          pieces_in(drawings_of(*solution, build), build.gauge ? "R" : "");
      ASSERT_FALSE(pieces.empty());
      EXPECT_EQ(static_cast<int>(pieces.size()), pieces.front().of);

      const std::vector<Point> track = joined(pieces);

      const double mm = build.per_metre();
      EXPECT_NEAR(length_of(track), mm * solution->motion()->rail_length(),
                  0.05);
      EXPECT_NEAR(track.back().x, mm * solution->scene.L, 0.05);
      EXPECT_NEAR(track.back().z, mm * solution->scene.H, 0.05);
    }
  }
}

TEST(CuttingTemplate, PiecesAreOfEqualLength) {
  for (const Build& build : {fifth(), small_rails()}) {
    const auto pieces = pieces_in(drawings_of(off_centred_solution(), build),
                                  build.gauge ? "L" : "");
    const auto [shortest, longest] = std::ranges::minmax_element(
        pieces, {},
        [](const CutPiece& piece) { return length_of(piece.edge); });
    // Coordinates are rounded to 1e-4 mm.
    EXPECT_NEAR(length_of(shortest->edge), length_of(longest->edge), 1e-2);
  }
}

TEST(CuttingTemplate, PiecesLieTurnedWhereThatSavesSome) {
  // From A to B it is farther than a sheet is wide: two are the fewest. As they
  // hang each is deeper than the room below the words.
  Build build = fifth();
  build.height = 212.0;
  build.strip = 20.0;
  build.hole = 4.0;

  const std::vector<Drawing> drawings = drawings_of(uniform_solution(), build);

  const auto pieces = pieces_in(drawings);
  ASSERT_EQ(pieces.size(), 2U);
  for (const CutPiece& piece : pieces) EXPECT_NE(piece.turned, 0.0);
  const Point end = joined(pieces).back();
  EXPECT_NEAR(end.x, build.per_metre() * uniform_solution().scene.L, 0.05);
  EXPECT_NEAR(end.z, build.per_metre() * uniform_solution().scene.H, 0.05);
}

TEST(CuttingTemplate, PiecesLieAsTheyHangWhereTurningSavesNothing) {
  Build build = fifth();
  build.width = build.height = 2000.0;
  for (const CutPiece& piece :
       pieces_in(drawings_of(uniform_solution(), build))) {
    EXPECT_EQ(piece.turned, 0.0);
  }
}

TEST(CuttingTemplate, TellsDiscsThatAreAnotherBody) {
  // k of two discs is 1/2, and flanges add to it.
  const std::string words =
      words_on(drawings_of(uniform_solution(), fifth()).front());
  EXPECT_THAT(words, HasSubstr("and the track is for k = 0.5: weights"));
}

TEST(CuttingTemplate, TellsWhereToBeCarefulInAir) {
  const Solution solution =
      solve(testing::in_air(testing::uniform_scene(), 0.1, 0.05));
  Build build;
  build.width = build.height = 1500.0;
  EXPECT_THAT(words_on(drawings_of(solution, build).front()),
              HasSubstr("Care: 1 mm of error matters most from x ="));
}

TEST(CuttingTemplate, TheEdgeOfABeadIsACycloid) {
  // x = a (ψ − sin ψ), z = a (1 − cos ψ), with a and the end of ψ by B.
  const Solution& solution = bead_solution();
  const Build build = fifth();
  const double L = build.per_metre() * solution.scene.L;
  const double H = build.per_metre() * solution.scene.H;
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
  for (const Point p : joined(pieces_in(drawings_of(solution, build)))) {
    // Below the cusp the cycloid is steep, up to 3 from x = 20 on, and pieces
    // are cut at chords.
    if (p.x <= 20.0) continue;
    EXPECT_NEAR(p.z, depth_at(p.x), 4.0 * kChord) << p.x;
  }
}

TEST(CuttingTemplate, ChordsAreAsNearAsTheySay) {
  // The middle of a chord is farthest from an arc, and the distance of a place
  // of the track between its ends tells it.
  const Solution& solution = off_centred_solution();
  Build build;
  build.width = build.height = 1e5;
  const auto pieces = pieces_in(drawings_of(solution, build));
  ASSERT_EQ(pieces.size(), 1U);
  const std::vector<Point> track = joined(pieces);
  for (int i = 1; i < 1000; ++i) {
    const Point on = solution.motion()->at(i / 1000.0).motion.contact;
    const double x = 1e3 * on.x, z = 1e3 * on.z;
    double nearest = 1e9;
    for (std::size_t j = 1; j < track.size(); ++j) {
      const Point p = track[j - 1], q = track[j];
      const double l2 = std::pow(q.x - p.x, 2) + std::pow(q.z - p.z, 2);
      const double t = std::clamp(
          ((x - p.x) * (q.x - p.x) + (z - p.z) * (q.z - p.z)) / l2, 0.0, 1.0);
      nearest = std::min(nearest, std::hypot(p.x + t * (q.x - p.x) - x,
                                             p.z + t * (q.z - p.z) - z));
    }
    // And coordinates are rounded to 1e-4 mm.
    EXPECT_LE(nearest, 1.1 * kChord);
  }
}

TEST(CuttingTemplate, EverythingIsOnItsSheet) {
  for (const Build& build : {fifth(), small_rails()}) {
    for (const Drawing& drawing : drawings_of(off_centred_solution(), build)) {
      EXPECT_EQ(drawing.width, build.width);
      EXPECT_EQ(drawing.height, build.height);
      const auto expect_on = [&](Point p) {
        EXPECT_GE(std::min(p.x, p.z), 0.0) << drawing.name;
        EXPECT_LE(p.x, drawing.width) << drawing.name;
        EXPECT_LE(p.z, drawing.height) << drawing.name;
      };
      for (const auto& polyline : drawing.shapes.polylines) {
        for (const Point p : polyline.points) expect_on(p);
      }
      for (const auto& circle : drawing.shapes.circles) {
        const Point at = circle.centre;
        expect_on({at.x - circle.radius, at.z - circle.radius});
        expect_on({at.x + circle.radius, at.z + circle.radius});
      }
      for (const Label& label : drawing.shapes.labels) {
        const double width =
            report::width_of(report::letters(label.text), label.size);
        const double from = label.centred ? -0.5 * width : 0.0;
        for (const double along : {from, from + width}) {
          expect_on({label.at.x + along * std::cos(label.angle),
                     label.at.z + along * std::sin(label.angle)});
        }
      }
    }
  }
}

TEST(CuttingTemplate, PartsDoNotOverlap) {
  // No corner of one outline lies in another, but slots.
  for (const Build& build : {fifth(), small_rails()}) {
    for (const Drawing& drawing : drawings_of(off_centred_solution(), build)) {
      std::vector<std::vector<Point>> areas;
      for (const auto& polyline : drawing.shapes.polylines) {
        constexpr std::size_t kSlot = 4;
        if (polyline.line == report::cutting::Line::Cut &&
            polyline.points.size() > kSlot) {
          areas.push_back(polyline.points);
        }
      }
      for (const auto& one : areas) {
        for (const auto& other : areas) {
          if (&one == &other) continue;
          for (const Point p : one) EXPECT_FALSE(testing::is_within(p, other));
        }
      }
    }
  }
}

TEST(CuttingTemplate, EverySheetTellsWhatABuilderHasToKnow) {
  for (const Drawing& drawing :
       drawings_of(off_centred_solution(), small_rails())) {
    const std::string words = words_on(drawing);
    EXPECT_THAT(words, HasSubstr("cylinder of radius 66.667 mm, k = 0.5"));
    EXPECT_THAT(words, HasSubstr("scale 1:5"));
    EXPECT_THAT(words, HasSubstr("Grip: least friction coefficient"));
    EXPECT_THAT(words, HasSubstr("Load: least"));
    EXPECT_THAT(words, HasSubstr("Care: 1 mm of error matters most from x ="));
    EXPECT_THAT(words, HasSubstr("100 mm"));
    for (const Label& label : drawing.shapes.labels) {
      EXPECT_TRUE(std::ranges::all_of(
          label.text, [](char c) { return c >= ' ' && c <= '~'; }))
          << "DXF has no others: " << label.text;
    }
  }
  // A bead rubs nowhere.
  for (const Drawing& drawing : drawings_of(bead_solution(), fifth())) {
    EXPECT_EQ(words_on(drawing).find("Grip"), std::string::npos);
  }
}

TEST(CuttingTemplate, TimesOfAModelAreThoseOfItsScale) {
  // A quarter of all lengths, half of all times.
  Build build = fifth();
  build.scale = 0.25;
  const double T = off_centred_solution().motion()->transit_time();
  char expected[32];
  std::snprintf(expected, sizeof expected, "T = %.4g s", 0.5 * T);
  EXPECT_THAT(words_on(drawings_of(off_centred_solution(), build).front()),
              HasSubstr(expected));
}

TEST(CuttingTemplate, TheRulerIsAHundredMillimetres) {
  for (const Drawing& drawing : drawings_of(bead_solution(), fifth())) {
    const auto& lines = drawing.shapes.polylines;
    EXPECT_TRUE(std::ranges::any_of(lines, [](const auto& line) {
      return line.line == report::cutting::Line::Engrave &&
             line.points.size() == 2 && line.points[0].z == line.points[1].z &&
             std::abs(line.points[1].x - line.points[0].x - 100.0) < 1e-9;
    })) << drawing.name;
  }
}

TEST(CuttingTemplate, PlatesFitTheHolesBesideTheirJoints) {
  const std::vector<Drawing> drawings =
      drawings_of(off_centred_solution(), fifth());
  const auto pieces = pieces_in(drawings);
  ASSERT_GT(pieces.size(), 1U);
  // Where holes are once pieces are joined, as seen from the joint.
  std::vector<std::vector<Point>> beside(pieces.size() - 1);
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
    const auto from = [](Point p, Point origin) {
      return Point{p.x - origin.x, p.z - origin.z};
    };
    for (const Point hole : pieces[i].holes) {
      beside[i].push_back(from(hole, pieces[i].edge.back()));
    }
    for (const Point hole : pieces[i + 1].holes) {
      beside[i].push_back(from(hole, pieces[i + 1].edge.front()));
    }
  }
  std::size_t plates = 0;
  for (const Drawing& drawing : drawings) {
    const Dxf dxf = read_dxf(as_dxf(drawing));
    for (const DxfEntity& words : dxf.entities) {
      const std::string text = words.text(1);
      if (words.kind != "TEXT" || text.size() != 3 || text[1] != '-') continue;
      ++plates;
      const auto joint = static_cast<std::size_t>(text[0] - '1');
      std::vector<Point> holes;
      for (const DxfEntity& entity : dxf.entities) {
        if (entity.kind != "POLYLINE" || entity.layer() != "CUT") continue;
        const std::vector<Point> area = corners(entity);
        if (!testing::is_within({words.number(10), words.number(20)}, area)) {
          continue;
        }
        for (const DxfEntity& hole : dxf.entities) {
          if (hole.kind != "CIRCLE") continue;
          const Point middle{hole.number(10), hole.number(20)};
          if (testing::is_within(middle, area)) holes.push_back(middle);
        }
      }
      ASSERT_EQ(holes.size(), 4U);
      // One shift and turn lays all four over holes of the pieces.
      const auto fits = [&](Point first, Point second) {
        const double turn =
            std::atan2(second.z - first.z, second.x - first.x) -
            std::atan2(holes[1].z - holes[0].z, holes[1].x - holes[0].x);
        return std::ranges::all_of(holes, [&](Point hole) {
          const double x = hole.x - holes[0].x, z = hole.z - holes[0].z;
          const Point at{first.x + x * std::cos(turn) - z * std::sin(turn),
                         first.z + x * std::sin(turn) + z * std::cos(turn)};
          return std::ranges::any_of(beside[joint], [&](Point p) {
            return std::hypot(p.x - at.x, p.z - at.z) < 1e-3;
          });
        });
      };
      const bool fitting = std::ranges::any_of(beside[joint], [&](Point p) {
        return std::ranges::any_of(beside[joint],
                                   [&](Point q) { return fits(p, q); });
      });
      EXPECT_TRUE(fitting) << text;
    }
  }
  EXPECT_EQ(plates, pieces.size() - 1);
}

TEST(CuttingTemplate, RailsAreTwoStripsAndASpacerForEachPairOfSlots) {
  const Build build = small_rails();
  const std::vector<Drawing> drawings =
      drawings_of(off_centred_solution(), build);
  const auto left = pieces_in(drawings, "L"), right = pieces_in(drawings, "R");
  ASSERT_EQ(left.size(), right.size());
  int slots = 0, spacers = 0;
  for (std::size_t i = 0; i < left.size(); ++i) {
    EXPECT_EQ(left[i].slots, right[i].slots);
    EXPECT_GE(left[i].slots, 1);
    slots += left[i].slots;
  }
  for (const Drawing& drawing : drawings) {
    for (const Label& label : drawing.shapes.labels) {
      if (label.text == "spacer") ++spacers;
    }
    for (const auto& polyline : drawing.shapes.polylines) {
      if (polyline.line != report::cutting::Line::Cut) continue;
      constexpr std::size_t kSlot = 4, kSpacer = 12;
      const auto& p = polyline.points;
      if (p.size() == kSlot) {
        EXPECT_NEAR(std::hypot(p[1].x - p[0].x, p[1].z - p[0].z),
                    build.thickness, 1e-9);
      } else if (p.size() == kSpacer) {
        // Between its shoulders, and over its tabs.
        EXPECT_NEAR(p[1].x - p[0].x, *build.gauge, 1e-9);
        EXPECT_NEAR(p[3].x - p[9].x, *build.gauge + 2.0 * build.thickness,
                    1e-9);
        // A tab is as high as a slot.
        EXPECT_NEAR(p[4].z - p[3].z, build.strip / 3.0, 1e-9);
      }
    }
  }
  EXPECT_EQ(slots, spacers);
}

TEST(CuttingTemplate, TheAssemblyTellsTheSheetsOfBothRails) {
  const std::vector<Drawing> drawings =
      drawings_of(off_centred_solution(), small_rails());
  std::map<std::string, int> sheets;  // of each piece, as engraved
  for (const Drawing& drawing : drawings) {
    if (!is_cut(drawing)) continue;
    for (const CutPiece& piece : pieces_in(read_dxf(as_dxf(drawing)))) {
      sheets[std::to_string(piece.number) + piece.side] =
          std::stoi(drawing.name.substr(drawing.name.find('-') + 1));
    }
  }
  const std::string words = words_on(drawings.back());
  for (int i = 1; sheets.contains(std::to_string(i) + "L"); ++i) {
    const std::string number = std::to_string(i);
    EXPECT_THAT(words, HasSubstr(" " + number + " " +
                                 std::to_string(sheets[number + "L"]) + " L, " +
                                 std::to_string(sheets[number + "R"]) + " R "));
  }
}

TEST(CuttingTemplate, WordsOfAnAssemblyDoNotOverlap) {
  // Level ones, as wide as width_of() says, between base line and height.
  for (const Build& build : {fifth(), small_rails()}) {
    for (const Solution* solution :
         {&bead_solution(), &uniform_solution(), &off_centred_solution()}) {
      for (const Drawing& drawing : drawings_of(*solution, build)) {
        if (drawing.name != "assembly-01") continue;
        const auto& labels = drawing.shapes.labels;
        const auto box = [](const Label& label) {
          const double width =
              report::width_of(report::letters(label.text), label.size);
          const double left = label.at.x - (label.centred ? 0.5 * width : 0.0);
          return report::Box{{left, label.at.z - label.size},
                             {left + width, label.at.z}};
        };
        for (std::size_t i = 0; i < labels.size(); ++i) {
          for (std::size_t j = 0; j < i; ++j) {
            const report::Box a = box(labels[i]), b = box(labels[j]);
            EXPECT_TRUE(a.high.x <= b.low.x || b.high.x <= a.low.x ||
                        a.high.z <= b.low.z || b.high.z <= a.low.z)
                << labels[i].text << " and " << labels[j].text;
          }
        }
      }
    }
  }
}

TEST(CuttingTemplate, TheBodyIsTwoDiscsAndTwoFlanges) {
  const Build build = fifth();
  const double r = build.per_metre() * off_centred_solution().scene.body.radius;
  int discs = 0, flanges = 0;
  for (const Drawing& drawing : drawings_of(off_centred_solution(), build)) {
    for (const auto& circle : drawing.shapes.circles) {
      if (circle.radius == r) ++discs;
      if (circle.radius > r) ++flanges;
    }
  }
  EXPECT_EQ(discs, 2);
  EXPECT_EQ(flanges, 2);
  // Of two discs alone k is ½; of flanges of the radius r + f it is
  // ½ (2 r⁴ + 2 (r + f)⁴)/((2 r² + 2 (r + f)²) r²).
  const double f = report::cutting::flange_of(build), R = r + f;
  EXPECT_NEAR(
      report::cutting::k_of_discs(off_centred_solution().scene.body, build),
      0.5 * (std::pow(r, 4) + std::pow(R, 4)) / ((r * r + R * R) * r * r),
      1e-12);
}

TEST(CuttingTemplate, ABodyShowsItsCentreOfMassAndItsParts) {
  const Solution& solution = off_centred_solution();
  const Body& body = solution.scene.body;
  std::vector<MassPart> made_of{MassPart::point(1.0, {0.1, 0.2})};
  made_of.front().name = "lead";
  const Build build = fifth();

  const auto parts = report::cutting::body_parts(
      body, solution.motion()->start_angle(), made_of, build);

  ASSERT_EQ(parts.size(), 4U);
  // The axis is the origin, and the second line is the level arm of the cross.
  const double r = build.per_metre() * body.radius;
  const auto& cross = parts.front().shapes.polylines.at(1).points;
  EXPECT_NEAR(0.5 * (cross[0].x + cross[1].x),
              r * body.eta_m * std::cos(body.theta_m), 1e-9);
  EXPECT_NEAR(cross[0].z, r * body.eta_m * std::sin(body.theta_m), 1e-9);
  EXPECT_NEAR(parts.front().shapes.circles.back().centre.x, 20.0, 1e-9);
  EXPECT_NEAR(parts.front().shapes.circles.back().centre.z, 40.0, 1e-9);
  EXPECT_TRUE(std::ranges::any_of(
      parts.front().shapes.labels,
      [](const Label& label) { return label.text == "1 lead"; }));
}

TEST(CuttingTemplate, SignsOfADiscDoNotCoverEachOther) {
  // The centre of mass and three parts at one place, and one where the name of
  // the disc would stand.
  const Build build = fifth();
  const double r = 0.2;
  const Body body = Body::cylinder(r, 0.01, 0.0, 0.5);
  std::vector<MassPart> made_of(3, MassPart::point(1.0, {0.002, 0.0}));
  made_of.push_back(MassPart::point(1.0, {0.0, -0.5 * r}));

  const Part disc =
      report::cutting::body_parts(body, 0.3, made_of, build).front();

  std::vector<Label> on_it;
  for (const Label& label : disc.shapes.labels) {
    if (label.centred) on_it.push_back(label);
  }
  ASSERT_EQ(on_it.size(), 7U);  // A, G, 1 to 4 and the name
  for (std::size_t i = 0; i < on_it.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_GE(std::hypot(on_it[i].at.x - on_it[j].at.x,
                           on_it[i].at.z - on_it[j].at.z),
                on_it[i].size)
          << on_it[i].text << " and " << on_it[j].text;
    }
  }
}

TEST(CuttingTemplate, SaysWhatIsRefused) {
  const Scene& scene = off_centred_solution().scene;
  Build build;
  EXPECT_THAT(why_refused([&] { check_build(build, scene); }),
              HasSubstr("a body of 666.7 mm does not fit on a sheet of 600 x "
                        "400 mm"));
  build = fifth();
  build.hole = 11.0;
  EXPECT_THAT(why_refused([&] { check_build(build, scene); }),
              HasSubstr("a strip of 40 mm has no room for holes of 11 mm"));
  build = fifth();
  Scene in_air = scene;
  in_air.world.air.linear = 0.1;
  EXPECT_THAT(why_refused([&] { check_build(build, in_air); }),
              HasSubstr("--scale is 1:1 there"));
  build.scale = 1.0;
  build.width = build.height = 1e4;
  EXPECT_EQ(why_refused([&] { check_build(build, in_air); }), "");
  // Words take most of the sheet.
  build = {};
  build.width = build.height = 150.0;
  build.strip = 60.0;
  EXPECT_THAT(why_refused([&] { drawings_of(bead_solution(), build); }),
              HasSubstr("longer ones do not fit on a sheet"));
}

/// Two strips as far apart as its rails, and no discs. Losses leave the table
/// of errors out.
TEST(CuttingTemplate, ABallRunsOnTwoStrips) {
  Scene scene = uniform_solution().scene;
  scene.body =
      Body::rolling_ball({.radius = 0.1, .k = 0.4, .gauge = 0.12}, 0.0);
  scene.world.losses.rolling = 0.01;
  scene.limits.friction = 0.5;
  const Solution solution = solve(scene);
  ASSERT_TRUE(solution.verified()) << solution.message;
  Build build = fifth();
  EXPECT_THAT(why_refused([&] { check_build(build, scene); }),
              HasSubstr("--rails 24 has the strips so"));
  build = small_rails();
  build.gauge = 24.0;

  const auto drawings = drawings_of(solution, build);

  EXPECT_FALSE(pieces_in(drawings, "L").empty());
  EXPECT_TRUE(report::cutting::body_parts(scene.body, 0.0, {}, build).empty());
  scene.body =
      Body::rolling_ball({.radius = 0.1, .k = 0.4, .groove = 1.0}, 0.0);
  EXPECT_THAT(why_refused([&] { check_build(build, scene); }),
              HasSubstr("they are for thin rails"));
}

TEST(Drawing, IsAnSvgOfItsSizeInMillimetres) {
  for (const Drawing& drawing : drawings_of(off_centred_solution(), fifth())) {
    const std::string svg = as_svg(drawing);
    EXPECT_EQ(xml_flaw(svg), "");
    EXPECT_THAT(svg, HasSubstr("width=\"600mm\" height=\"400mm\" "
                               "viewBox=\"0 0 600 400\""));
    // Nothing of an assembly is cut.
    const std::size_t cut = svg.find("<g id=\"cut\"");
    ASSERT_NE(cut, std::string::npos);
    EXPECT_EQ(svg.find("<path", cut) != std::string::npos, is_cut(drawing));
    EXPECT_EQ(svg.find("<text", cut), std::string::npos);
  }
}

TEST(Drawing, IsADxfInMillimetresWithTwoLayers) {
  for (const Drawing& drawing : drawings_of(off_centred_solution(), fifth())) {
    const Dxf dxf = read_dxf(as_dxf(drawing));
    EXPECT_TRUE(dxf.whole);
    EXPECT_EQ(dxf.header.at("$INSUNITS"), "4");
    EXPECT_EQ(dxf.header.at("$MEASUREMENT"), "1");
    std::size_t points = 0, vertices = 0;
    for (const auto& polyline : drawing.shapes.polylines) {
      points += polyline.points.size();
    }
    for (const DxfEntity& entity : dxf.entities) {
      EXPECT_TRUE(entity.layer() == "CUT" || entity.layer() == "ENGRAVE");
      if (entity.kind == "TEXT") {
        EXPECT_EQ(entity.layer(), "ENGRAVE");
      }
      if (entity.kind == "POLYLINE") vertices += corners(entity).size();
    }
    EXPECT_EQ(vertices, points);
  }
}

TEST(Drawing, BearsNamesOfAllKinds) {
  // As DXF has them; control characters and what is no UTF-8 are shown first.
  const std::pair<const char*, const char*> names[] = {
      {"\"a\" & <b>'c'", "\"a\" & <b>'c'"},
      {"d\ne\tf\xff", "d\\x0ae\\x09f\\xff"},
      {"%%u^J", "% %u^ J"},
      {"\u00fc \U0001F600", "\\U+00FC ?"}};
  for (const auto& [name, shown] : names) {
    std::vector<MassPart> made_of{MassPart::point(1.0, {0.1, 0.2})};
    made_of.front().name = name;
    Drawing drawing{"sheet-01", "Body", 100.0, 100.0, {}};
    drawing.shapes =
        report::cutting::body_parts(off_centred_solution().scene.body, 0.0,
                                    made_of, fifth())
            .front()
            .shapes;

    EXPECT_EQ(xml_flaw(as_svg(drawing)), "") << name;
    const Dxf dxf = read_dxf(as_dxf(drawing));
    EXPECT_TRUE(dxf.whole);
    EXPECT_TRUE(std::ranges::any_of(dxf.entities, [&](const DxfEntity& entity) {
      return entity.text(1) == std::string("1 ") + shown;
    })) << name;
  }
}

}  // namespace
}  // namespace brachisto
