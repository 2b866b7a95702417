// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/path_figure.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "report/solutions.hpp"
#include "report/xml.hpp"

namespace brachisto {
namespace {

using report::Figure;
using testing::bead_solution;
using testing::limited_solution;
using testing::off_centred_solution;
using testing::uniform_solution;
using testing::xml_flaw;

Figure figure_of(const Solution& solution) {
  return report::path_figure(solution);
}

/// The numbers in the rows of one part.
std::vector<std::vector<double>> rows(const Figure& figure,
                                      const std::string& part) {
  std::vector<std::vector<double>> out;
  std::istringstream table(figure.table);
  for (std::string line; std::getline(table, line);) {
    if (!line.starts_with(part + ",")) continue;
    std::istringstream fields(line.substr(part.size() + 1));
    out.emplace_back();
    for (std::string field; std::getline(fields, field, ',');) {
      out.back().push_back(std::stod(field));
    }
  }
  return out;
}

bool says(const Figure& figure, const std::string& words) {
  return figure.commands.find(words) != std::string::npos;
}

// Columns behind `part`.
constexpr std::size_t kT = 0, kX = 1, kZ = 2;

TEST(PathFigure, SaysByItsTitleWhatItIs) {
  EXPECT_TRUE(figure_of(off_centred_solution())
                  .title.starts_with("Smooth-contact extremal: τ = "));
  EXPECT_TRUE(figure_of(bead_solution())
                  .title.starts_with("Brachistochrone of a bead: τ = "));
}

TEST(PathFigure, IsDrawn) {
  for (const Solution* solution :
       {&off_centred_solution(), &uniform_solution(), &bead_solution()}) {
    const report::DrawnFiles drawn =
        report::draw(figure_of(*solution), report::Format::Svg, nullptr);

    ASSERT_EQ(drawn.missing, "");
    EXPECT_EQ(xml_flaw(drawn.files.back().content), "");
  }
}

TEST(PathFigure, HasACurveForEachPathThatIsAnotherOne) {
  EXPECT_TRUE(says(figure_of(off_centred_solution()), "its centre of mass"));
  EXPECT_FALSE(says(figure_of(uniform_solution()), "its centre of mass"));
  EXPECT_TRUE(says(figure_of(uniform_solution()), "its centre"));
  EXPECT_FALSE(says(figure_of(bead_solution()), "its centre"));
}

TEST(PathFigure, SaysInItsTitleWhatTheTrackIs) {
  Scene given = off_centred_solution().scene;
  given.path = std::make_shared<const GivenPath>();
  Scene between_centres = off_centred_solution().scene;
  between_centres.contact = Contact::Centre;
  const auto titled = [](const Solution& solution, const std::string& words) {
    return says(figure_of(solution), "'" + words + ": τ = ");
  };

  EXPECT_TRUE(titled(off_centred_solution(), "Smooth-contact extremal"));
  EXPECT_TRUE(titled(uniform_solution(), "Smooth-contact extremal"));
  EXPECT_TRUE(titled(bead_solution(), "Brachistochrone of a bead"));
  EXPECT_TRUE(titled(solve(given), "Given path"));
  EXPECT_TRUE(titled(solve(between_centres),
                     "Extremal between fixed ends of the centre''s path"));
  EXPECT_TRUE(says(figure_of(bead_solution()), "τ = 4.51056314"));
}

// A bead on a cycloid x = a (φ − sin φ), z = a (1 − cos φ) has φ̇ = √(g/a):
// at equal times φ is at equal steps up to its end.
TEST(PathFigure, ShowsTheBodyAtEqualTimes) {
  const auto steps = rows(figure_of(bead_solution()), "step");
  const Scene& scene = bead_solution().scene;
  const double T = bead_solution().motion()->transit_time();
  // The end: (φ − sin φ) / (1 − cos φ) = L / H, by bisection.
  double low = 1e-3;
  double high = 2.0 * std::numbers::pi - 1e-3;
  while (high - low > 1e-14 * high) {
    const double phi = 0.5 * (low + high);
    const bool before =
        (phi - std::sin(phi)) * scene.H < scene.L * (1.0 - std::cos(phi));
    (before ? low : high) = phi;
  }
  const double a = scene.H / (1.0 - std::cos(low));

  ASSERT_EQ(steps.size(), 11u);
  // Between samples, of which there are 600 or more, the place of a time is
  // taken as linear: half the square of their distance at most, 3e-6.
  constexpr double kTolerance = 1e-5;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double share = static_cast<double>(i) / 10.0;
    const double phi = low * share;
    EXPECT_NEAR(steps[i][kT], T * share, kTolerance * T) << i;
    EXPECT_NEAR(steps[i][kX], a * (phi - std::sin(phi)), kTolerance * scene.L);
    EXPECT_NEAR(steps[i][kZ], a * (1.0 - std::cos(phi)), kTolerance * scene.L);
  }
}

TEST(PathFigure, MarksWhereTheBodyLiftsOffAndSaysSo) {
  Scene steep = off_centred_solution().scene;
  steep.H = 10.0;
  const Figure figure = figure_of(solve(steep));

  EXPECT_TRUE(says(figure, "Infeasible: the body would lift off"));
  EXPECT_TRUE(says(figure, "lifts off'"));
  EXPECT_FALSE(says(figure_of(off_centred_solution()), "lifts off"));
}

/// The floor where the body just touches it.
Solution above_a_floor() {
  Solution solution = limited_solution();
  double lowest = 0.0;
  for (const TrajectoryPoint& p : solution.motion()->fine_sample(1000)) {
    lowest = std::max(lowest, p.centre.z);
  }
  solution.scene.limits.floor = lowest + solution.scene.body.radius;
  solution.scene.limits.discs = {{{1.5, 0.25}, 0.125}};
  return solution;
}

TEST(PathFigure, OfLimitsIsDrawn) {
  for (const Solution& solution : {limited_solution(), above_a_floor()}) {
    const report::DrawnFiles drawn =
        report::draw(figure_of(solution), report::Format::Svg, nullptr);

    ASSERT_EQ(drawn.missing, "");
    EXPECT_EQ(xml_flaw(drawn.files.back().content), "");
  }
}

TEST(PathFigure, SaysWhichLimitsThereAreAndWhichHold) {
  const Figure figure = figure_of(limited_solution());

  EXPECT_TRUE(figure.title.starts_with("Smooth-contact extremal under limits"));
  EXPECT_TRUE(figure.title.ends_with(
      "Limits: |Rt| ≤ 0.5 Rn, Rn ≤ 5 m g, clear of 1 half-plane"))
      << figure.title;
  EXPECT_TRUE(says(figure, "title 'friction active'"));
  EXPECT_TRUE(says(figure, "title 'normal\\_force.max active'"));
  EXPECT_FALSE(says(figure, "half\\_plane active"));
  EXPECT_FALSE(says(figure_of(off_centred_solution()), "active"));
}

TEST(PathFigure, HasABandForEachArcFromItsBeginToItsEnd) {
  const Solution& solution = limited_solution();
  const Figure figure = figure_of(solution);

  for (const LimitOnPath& limit : solution.limits) {
    for (std::size_t i = 0; i < limit.active.size(); ++i) {
      const ActiveArc& arc = limit.active[i];
      const auto band = rows(figure, limit.name + " " + std::to_string(i + 1));
      ASSERT_GE(band.size(), 10u) << limit.name;
      // Nine digits are written.
      constexpr double kWritten = 1e-8;
      EXPECT_NEAR(band.front()[kT], arc.t.from, kWritten);
      EXPECT_NEAR(band.front()[kX], arc.x.from, kWritten);
      EXPECT_NEAR(band.back()[kT], arc.t.to, kWritten);
      EXPECT_NEAR(band.back()[kX], arc.x.to, kWritten);
      EXPECT_TRUE(std::ranges::is_sorted(band));
    }
  }
}

TEST(PathFigure, ShowsWhereTheBodyMustNotBe) {
  const Solution solution = above_a_floor();
  const Figure figure = figure_of(solution);
  const auto corners = [&](int number) {
    std::vector<Point> out;
    std::istringstream table(figure.table);
    const std::string part = fmt::format("obstacle {} of track,,", number);
    for (std::string line; std::getline(table, line);) {
      if (!line.starts_with(part)) continue;
      std::istringstream numbers(line.substr(part.size()));
      Point p;
      char comma = ' ';
      numbers >> p.x >> comma >> p.z;
      out.push_back(p);
    }
    return out;
  };

  const std::vector<Point> floor = corners(1);
  const std::vector<Point> disc = corners(2);

  ASSERT_GE(floor.size(), 4u);
  const double D = *solution.scene.limits.floor;
  double deepest = 0.0;
  for (const Point p : floor) {
    EXPECT_GE(p.z, D - 1e-8);
    deepest = std::max(deepest, p.z);
  }
  EXPECT_GT(deepest, D + 0.1);  // seen, in a picture some 2 m high
  ASSERT_GE(disc.size(), 100u);
  for (const Point p : disc) {
    EXPECT_NEAR(std::hypot(p.x - 1.5, p.z - 0.25), 0.125, 1e-8);
  }
  EXPECT_TRUE(says(figure, "title 'out of bounds'"));
  EXPECT_TRUE(corners(3).empty());  // the wall is too far to the right
  EXPECT_FALSE(says(figure_of(off_centred_solution()), "out of bounds"));
}

// A key in a reason has an underscore that is none of a formula.
TEST(PathFigure, NamesTheRemedyForLiftOff) {
  Solution solution = limited_solution();
  solution.scene.limits.friction.reset();
  solution.diagnostics->min_normal_force = {-0.5, 1.25};

  const Figure figure = figure_of(solution);

  EXPECT_TRUE(says(figure, "normal\\_force: \\{min: 0\\}")) << figure.commands;
  EXPECT_TRUE(says(figure, "R_{n} = -0.5 m g")) << figure.commands;
}

TEST(PathFigure, EnlargesBumpsThatWouldVanish) {
  Scene small = off_centred_solution().scene;
  small.body.radius = 0.02;
  const Figure figure = figure_of(solve(small));

  EXPECT_TRUE(says(figure, "times as large"));
  EXPECT_EQ(rows(figure, "body").size(), 1u);
  EXPECT_FALSE(says(figure_of(off_centred_solution()), "times as large"));
}

}  // namespace
}  // namespace brachisto
