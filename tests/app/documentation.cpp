// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What the documentation shows is what the command does.

#include <gtest/gtest.h>

#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "app/pages.hpp"
#include "app/shown_lines.hpp"

namespace brachisto {
namespace {

namespace fs = std::filesystem;
using testing::content;
using testing::kRoot;
using testing::lines_of;
using testing::Page;
using testing::pages;
using testing::paper_problem;
using testing::run;
using testing::ScratchDirectory;

/// Lines of the answer of the reference case in the README.
std::vector<std::string> shown_answer() {
  const std::string readme = content(kRoot / "README.md");
  const std::size_t begin = readme.find("\ncylinder r = ") + 1;
  return lines_of(readme.substr(begin, readme.find("```", begin) - begin));
}

TEST(Readme, ShowsTheAnswerThatTheCommandGives) {
  const std::vector<std::string> shown = shown_answer();
  const std::vector<std::string> answer =
      lines_of(run({"solve", paper_problem("fig04_reference_case")}).out);

  ASSERT_EQ(shown.size(), answer.size());
  for (std::size_t i = 0; i < shown.size(); ++i) {
    EXPECT_EQ(testing::difference_of(shown[i], answer[i]), "");
  }
}

TEST(Readme, ShowsTheSceneToBeginWith) {
  const std::string readme = content(kRoot / "README.md");
  const std::string fence = "```yaml\n";
  const std::size_t begin = readme.find(fence) + fence.size();
  const std::string scene =
      readme.substr(begin, readme.find("```", begin) - begin);

  EXPECT_TRUE(content(kRoot / "problems/case.yaml").ends_with(scene)) << scene;
}

/// Without limits there is none, and what is computed is another one
/// (docs/theory.md, section 3).
TEST(Words, NothingIsCalledTheFastestTrack) {
  std::vector<std::string> texts{run({"--help"}).out,
                                 run({"solve", "--help"}).out};
  for (const char* file : {"README.md", "CMakeLists.txt", "CITATION.cff",
                           "docs/images/reference_case.svg"}) {
    texts.push_back(content(kRoot / file));
    EXPECT_FALSE(texts.back().empty()) << file;
  }
  for (const std::string& text : texts) {
    EXPECT_NE(text.find("mooth-contact extremal"), std::string::npos) << text;
  }
  for (const auto& page : fs::directory_iterator(kRoot / "docs")) {
    if (page.path().extension() == ".md") {
      texts.push_back(content(page.path()));
    }
  }
  for (const std::string& text : texts) {
    const std::string words = "astest track";
    for (std::size_t at = text.find(words); at != std::string::npos;
         at = text.find(words, at + 1)) {
      constexpr std::size_t kBefore = 4;  // "no f"
      ASSERT_GE(at, kBefore);
      EXPECT_EQ(text.substr(at - kBefore, kBefore), "no f")
          << text.substr(at - kBefore, 80);
    }
  }
}

/// What GitHub makes of a heading for links to it.
std::string anchor_of(const std::string& heading) {
  std::string anchor;
  for (const char c : heading.substr(heading.find_first_not_of("# "))) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == ' ') anchor += '-';
    if (std::isalnum(byte) || c == '-' || c == '_') {
      anchor += static_cast<char>(std::tolower(byte));
    }
  }
  return anchor;
}

TEST(Links, LeadToFilesAndHeadingsThatAreThere) {
  // A name has a dot or is empty; code such as [](int) is no link.
  const std::regex link(R"(\]\(([^)#:\s]*\.[^)#:\s]*)?(#([^)\s]*))?\))");
  int count = 0;
  for (const Page& page : pages()) {
    const fs::path here = kRoot / page.name;
    for (std::sregex_iterator it(page.text.begin(), page.text.end(), link), end;
         it != end; ++it) {
      const std::string name = (*it)[1], anchor = (*it)[3];
      const fs::path target = name.empty() ? here : here.parent_path() / name;
      ++count;
      EXPECT_TRUE(fs::exists(target)) << page.name << ": " << it->str();
      if (anchor.empty()) continue;
      bool found = false;
      for (const std::string& line : lines_of(content(target))) {
        found = found || (line.starts_with('#') && anchor_of(line) == anchor);
      }
      EXPECT_TRUE(found) << page.name << ": " << it->str();
    }
  }
  constexpr int kFew = 50;
  EXPECT_GE(count, kFew);
}

/// All Python of a page, one block after the other.
std::string python_of(const std::string& page) {
  const std::string fence = "```python\n";
  std::string code;
  for (std::size_t at = page.find(fence); at != std::string::npos;
       at = page.find(fence, at + 1)) {
    const std::size_t begin = at + fence.size();
    code += page.substr(begin, page.find("```", begin) - begin) + "\n";
  }
  return code;
}

TEST(PythonPage, RunsTwiceInTheSamePlace) {
  if (std::system("python3 --version > /dev/null 2>&1") != 0) {
    GTEST_SKIP() << "no python3";
  }
  const ScratchDirectory scratch;
  fs::create_directory_symlink(kRoot / "problems", scratch.path() / "problems");
  const std::string script =
      scratch.file("page.py", python_of(content(kRoot / "docs/python.md")));
  const std::string command = "cd '" + scratch.path().string() + "' && PATH='" +
                              fs::path(BRACHISTO_APP).parent_path().string() +
                              "':$PATH python3 '" + script + "' > out 2>&1";

  for (int time = 1; time <= 2; ++time) {
    const int status = std::system(command.c_str());

    const std::string out = content(scratch.path() / "out");
    EXPECT_EQ(status, 0) << "time " << time << ": " << out;
    // By the indirect method: the reference case, and with L = 4.
    EXPECT_NE(out.find("tau = 5.093444466"), std::string::npos) << out;
    EXPECT_NE(out.find("6.33555708"), std::string::npos) << out;
  }
}

}  // namespace
}  // namespace brachisto
