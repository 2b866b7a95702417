// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/figure.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <string>
#include <vector>

#include "brachisto/math/clock.hpp"
#include "report/xml.hpp"

namespace brachisto::report {
namespace {

using testing::xml_flaw;

Figure line() {
  return {.name = "line",
          .table = "part,x,y\na,0,1\na,1,3\nb,0,7\n",
          .commands =
              "plot data using (part('a', 'x')):(column('y')) "
              "with lines title 'a'\n"};
}

std::vector<std::string> names(const DrawnFiles& drawn) {
  std::vector<std::string> out;
  for (const OutputFile& file : drawn.files) out.push_back(file.name);
  return out;
}

/// Sets a variable of the environment for a while.
class Environment {
 public:
  Environment(const char* name, const char* value)
      : name_(name), before_(std::getenv(name)) {
    ::setenv(name, value, 1);
  }
  ~Environment() { ::setenv(name_, before_.c_str(), 1); }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  const char* name_;
  std::string before_;
};

TEST(Figure, IsATableAScriptAndAPicture) {
  const DrawnFiles drawn = draw(line(), Format::Svg, nullptr);

  ASSERT_EQ(drawn.missing, "");
  EXPECT_EQ(names(drawn),
            (std::vector<std::string>{"line.csv", "line.gp", "line.svg"}));
  EXPECT_EQ(drawn.files[0].content, line().table);
  EXPECT_EQ(xml_flaw(drawn.files[2].content), "");
}

TEST(Figure, HasATitleForThoseWhoCannotSeeIt) {
  Figure figure = line();
  figure.title = "a < b & c";

  const DrawnFiles drawn = draw(figure, Format::Svg, nullptr);

  EXPECT_NE(drawn.files.back().content.find("<title>a &lt; b &amp; c</title>"),
            std::string::npos);
}

TEST(Figure, WithoutGnuplotIsATableAndAScriptAndSaysSo) {
  const Environment nothing("PATH", "/no/such/directory");

  const DrawnFiles drawn = draw(line(), Format::Svg, nullptr);

  EXPECT_EQ(names(drawn), (std::vector<std::string>{"line.csv", "line.gp"}));
  EXPECT_NE(drawn.missing.find("line.svg is not drawn"), std::string::npos);
  EXPECT_NE(drawn.missing.find("gnuplot-nox"), std::string::npos);
}

TEST(Figure, OfCommandsThatGnuplotRefusesIsNotDrawn) {
  Figure figure = line();
  figure.commands = "plot no_such_function(x)\n";

  const DrawnFiles drawn = draw(figure, Format::Svg, nullptr);

  EXPECT_EQ(names(drawn), (std::vector<std::string>{"line.csv", "line.gp"}));
  EXPECT_NE(drawn.missing, "");
}

TEST(Figure, IsGivenUpAtASignal) {
  const std::atomic<int> signal{15};

  EXPECT_THROW((void)draw(line(), Format::Svg, &signal), Stopped);
}

TEST(Figure, ShowsWordsOfOthersAsTheyAre) {
  Figure figure = line();
  const std::string words = R"(a_b^c {d} \n 'e' "f" @g & ~h `id` $i)";
  figure.commands =
      "set title '" + gnuplot_escaped(words) + "'\n" + figure.commands;

  const DrawnFiles drawn = draw(figure, Format::Svg, nullptr);

  ASSERT_EQ(drawn.missing, "");
  EXPECT_NE(drawn.files.back().content.find(
                R"(a_b^c {d} \n 'e' "f" @g &amp; ~h `id` $i)"),
            std::string::npos);
}

}  // namespace
}  // namespace brachisto::report
