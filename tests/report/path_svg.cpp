// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/report/path_svg.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdio>
#include <memory>
#include <string>

#include "report/solutions.hpp"
#include "report/xml.hpp"

namespace brachisto {
namespace {

using report::path_svg;
using testing::bead_solution;
using testing::off_centred_solution;
using testing::uniform_solution;
using testing::xml_flaw;

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos;
       at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

TEST(PathSvg, IsWellFormed) {
  for (const Solution* solution :
       {&off_centred_solution(), &uniform_solution(), &bead_solution()}) {
    const std::string text = path_svg(*solution->trajectory());

    EXPECT_EQ(xml_flaw(text), "");
    EXPECT_TRUE(text.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\""));
    EXPECT_EQ(text.find("nan"), std::string::npos);
    EXPECT_EQ(text.find("inf"), std::string::npos);
  }
}

TEST(PathSvg, HasACurveForEachPathThatIsAnotherOne) {
  EXPECT_EQ(count(path_svg(*off_centred_solution().trajectory()), "<polyline"),
            3u);
  EXPECT_EQ(count(path_svg(*uniform_solution().trajectory()), "<polyline"), 2u);
  EXPECT_EQ(count(path_svg(*bead_solution().trajectory()), "<polyline"), 1u);
}

TEST(PathSvg, TellsTauInItsTitle) {
  EXPECT_NE(path_svg(*bead_solution().trajectory()).find("4.51056314"),
            std::string::npos);
}

TEST(PathSvg, SaysInItsTitleWhatTheTrackIs) {
  Scene given = off_centred_solution().scene;
  given.path = std::make_shared<const GivenPath>();
  Scene between_centres = off_centred_solution().scene;
  between_centres.contact = Contact::Centre;
  const auto title = [](const Solution& solution, const std::string& words) {
    return path_svg(*solution.motion()).find(">" + words + ": τ = ") !=
           std::string::npos;
  };

  EXPECT_TRUE(title(off_centred_solution(), "Smooth-contact extremal"));
  EXPECT_TRUE(title(uniform_solution(), "Smooth-contact extremal"));
  EXPECT_TRUE(title(bead_solution(), "Brachistochrone of a bead"));
  EXPECT_TRUE(title(solve(given), "Given path"));
  EXPECT_TRUE(title(solve(between_centres),
                    "Extremal between fixed ends of the centre's path"));
}

TEST(PathSvg, DrawsToScaleWithZDown) {
  const std::string text = path_svg(*bead_solution().trajectory());
  const std::string before = "points=\"";
  const std::size_t begin = text.find(before, text.find("<polyline"));
  ASSERT_NE(begin, std::string::npos);
  const std::size_t from = begin + before.size();
  const std::string points = text.substr(from, text.find('"', from) - from);
  double x0 = 0.0, z0 = 0.0, x1 = 0.0, z1 = 0.0;
  ASSERT_EQ(std::sscanf(points.c_str(), "%lf,%lf", &x0, &z0), 2);
  const std::size_t last = points.find_last_of(' ', points.size() - 2);
  ASSERT_EQ(std::sscanf(points.c_str() + last, "%lf,%lf", &x1, &z1), 2);

  // B = (3, 1): to the right and below, in that ratio, to 0.01 px.
  EXPECT_GT(z1, z0);
  EXPECT_NEAR((x1 - x0) / 3.0, z1 - z0, 0.02);
}

}  // namespace
}  // namespace brachisto
