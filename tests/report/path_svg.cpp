// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/report/path_svg.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdio>
#include <regex>
#include <string>
#include <vector>

#include "report/solutions.hpp"

namespace brachisto {
namespace {

using report::path_svg;
using testing::bead_solution;
using testing::off_centred_solution;
using testing::uniform_solution;

/// What is not well formed about a document of elements with double-quoted
/// attributes, text and no entities; "" if nothing is.
std::string flaw(const std::string& text) {
  static const std::regex kTag(
      R"rx(<(/?)([A-Za-z]+)((?:\s+[A-Za-z][A-Za-z0-9:-]*="[^"<>&]*")*)\s*(/?)>)rx");
  std::vector<std::string> open;
  bool had_root = false;
  std::size_t position = 0;
  while (position < text.size()) {
    if (text[position] != '<') {
      const char c = text[position++];
      if (c == '&' || c == '>') return "a stray " + std::string(1, c);
      if (open.empty() && c != '\n' && c != ' ') return "text outside";
      continue;
    }
    std::smatch match;
    const auto begin = text.begin() + static_cast<std::ptrdiff_t>(position);
    if (!std::regex_search(begin, text.end(), match, kTag,
                           std::regex_constants::match_continuous)) {
      return "no tag: " + text.substr(position, 40);
    }
    const bool closing = match[1].length() > 0;
    const bool empty = match[4].length() > 0;
    if (closing) {
      if (open.empty() || open.back() != match[2]) {
        return "</" + match[2].str() + "> closes nothing";
      }
      open.pop_back();
    } else {
      if (open.empty() && had_root) return "two roots";
      had_root = true;
      if (!empty) open.push_back(match[2]);
    }
    position += static_cast<std::size_t>(match.length());
  }
  if (!open.empty()) return "<" + open.back() + "> stays open";
  return had_root ? "" : "empty";
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos;
       at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

TEST(Flaw, IsSeen) {
  EXPECT_EQ(flaw("<a b=\"1\"><c/>x</a>\n"), "");
  EXPECT_NE(flaw("<a><b></a></b>"), "");
  EXPECT_NE(flaw("<a>"), "");
  EXPECT_NE(flaw("<a b=1></a>"), "");
  EXPECT_NE(flaw("<a>x & y</a>"), "");
  EXPECT_NE(flaw("<a></a><b></b>"), "");
}

TEST(PathSvg, IsWellFormed) {
  for (const Solution* solution :
       {&off_centred_solution(), &uniform_solution(), &bead_solution()}) {
    const std::string text = path_svg(*solution->trajectory);

    EXPECT_EQ(flaw(text), "");
    EXPECT_TRUE(text.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\""));
    EXPECT_EQ(text.find("nan"), std::string::npos);
    EXPECT_EQ(text.find("inf"), std::string::npos);
  }
}

TEST(PathSvg, HasACurveForEachPathThatIsAnotherOne) {
  EXPECT_EQ(count(path_svg(*off_centred_solution().trajectory), "<polyline"),
            3u);
  EXPECT_EQ(count(path_svg(*uniform_solution().trajectory), "<polyline"), 2u);
  EXPECT_EQ(count(path_svg(*bead_solution().trajectory), "<polyline"), 1u);
}

TEST(PathSvg, TellsTauInItsTitle) {
  EXPECT_NE(path_svg(*bead_solution().trajectory).find("4.51056314"),
            std::string::npos);
}

TEST(PathSvg, DrawsToScaleWithZDown) {
  const std::string text = path_svg(*bead_solution().trajectory);
  static const std::regex kPoints(R"rx(<polyline[^>]*points="([^"]*)")rx");
  std::smatch match;
  ASSERT_TRUE(std::regex_search(text, match, kPoints));
  double x0 = 0.0, z0 = 0.0, x1 = 0.0, z1 = 0.0;
  const std::string points = match[1];
  ASSERT_EQ(std::sscanf(points.c_str(), "%lf,%lf", &x0, &z0), 2);
  const std::size_t last = points.find_last_of(' ', points.size() - 2);
  ASSERT_EQ(std::sscanf(points.c_str() + last, "%lf,%lf", &x1, &z1), 2);

  // B = (3, 1): to the right and below, in that ratio, to 0.01 px.
  EXPECT_GT(z1, z0);
  EXPECT_NEAR((x1 - x0) / 3.0, z1 - z0, 0.02);
}

}  // namespace
}  // namespace brachisto
