// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The commands that the documentation shows run as they stand.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/shell.hpp"

namespace brachisto {
namespace {

namespace fs = std::filesystem;
using testing::content;
using testing::kRoot;
using testing::lines_of;
using testing::Output;
using testing::Page;
using testing::pages;
using testing::run;
using testing::tree;

/// The lines of a page's blocks of code, fenced or indented, that begin with
/// `brachisto` or `./`; a line that ends in a backslash goes on. The last cell
/// of a table's row, if it is such a line in quotes.
std::vector<std::string> commands_of(const std::string& page) {
  const std::regex last_cell(R"(\| `((?:brachisto |\./)[^`]+)` \|$)");
  std::vector<std::string> commands;
  bool fenced = false, goes_on = false;
  for (const std::string& line : lines_of(page)) {
    std::smatch cell;
    if (!fenced && std::regex_search(line, cell, last_cell)) {
      commands.push_back(cell[1]);
      continue;
    }
    const std::size_t indent = line.find_first_not_of(' ');
    if (indent == std::string::npos) continue;
    std::string code = line.substr(indent);
    if (code.starts_with("```")) fenced = !fenced;
    constexpr std::size_t kIndentOfCode = 2;  // of the help's examples
    if (!fenced && indent < kIndentOfCode) continue;
    if (code.starts_with("$ ")) code.erase(0, 2);
    const bool begins =
        code.starts_with("brachisto ") || code.starts_with("./");
    if (goes_on) commands.back() += " " + code;
    if (begins) commands.push_back(code);
    if (!begins && !goes_on) continue;
    goes_on = commands.back().ends_with('\\');
    if (goes_on) commands.back().pop_back();
  }
  return commands;
}

/// A problem file that takes its time, and what is replaced in it for a run of
/// less than a second. The file as it stands is checked all the same.
struct Slow {
  const char* file;
  const char* words;
  const char* instead;
};
constexpr Slow kSlow[] = {
    {"sweeps/map_eta_theta.yaml", "count: 41", "count: 3"},
    {"sweeps/map_eta_theta.yaml", "count: 61", "count: 4"},
    {"sweeps/grip.yaml", "count: 26", "count: 2"},
    {"sweeps/sharper_valleys.yaml", "[4, 6, 8, 12, 16, 24, 32, 40]", "[4, 6]"},
    {"work_precision/base.yaml", ", 40, 64, 80, 160, 400]", "]"},
    {"work_precision/base.yaml", "repetitions: 5", "repetitions: 1"},
    {"large/million_nodes.yaml", "1000001", "1001"},
    {"large/r_0.0002.yaml", "radius: 0.0002", "radius: 0.02"},
};

/// Problem files that a pattern names among others, which take seconds each and
/// which test_hard_problems solves.
constexpr const char* kSolvedElsewhere[] = {
    "hard/H_100.yaml", "hard/global_search.yaml",
    "hard/global_search_r_0.1.yaml", "hard/r_0.001.yaml"};

/// Commands that are not run here: test_paper_command runs the first; the
/// second takes the answer of another solver, as test_asl does; the others
/// install packages and build.
constexpr const char* kLeft[] = {
    "brachisto paper --out paper",
    "brachisto nlp problems/paper/fig04_reference_case.yaml --check",
    "./bootstrap.sh "};

bool is_left(const std::string& command) {
  return std::any_of(std::begin(kLeft), std::end(kLeft), [&](const char* left) {
    return command.starts_with(left);
  });
}

/// A place to run the commands of a page in: the problem files, slow ones quick
/// or left out, and nothing else.
class Place {
 public:
  Place() {
    fs::copy(tree().problems, path() / "problems", fs::copy_options::recursive);
    for (const Slow& slow : kSlow) {
      const fs::path file = path() / "problems" / slow.file;
      std::string text = content(file);
      const std::size_t at = text.find(slow.words);
      if (at == std::string::npos) throw std::runtime_error(slow.file);
      text.replace(at, std::string(slow.words).size(), slow.instead);
      std::ofstream(file, std::ios::binary) << text;
    }
    for (const char* file : kSolvedElsewhere) {
      if (!fs::remove(path() / "problems" / file))
        throw std::runtime_error(file);
    }
  }
  [[nodiscard]] const fs::path& path() const { return scratch_.path(); }

  /// Runs a line as a shell does; the exit code and all that was written.
  [[nodiscard]] Output shell(const std::string& line) const {
    return testing::shell(line, path());
  }

 private:
  testing::ScratchDirectory scratch_;
};

TEST(Commands, OfThePagesRunAsTheyStand) {
  int count = 0;
  for (const Page& page : pages()) {
    const Place place;
    for (const std::string& command : commands_of(page.text)) {
      if (is_left(command)) continue;
      ++count;

      const Output output = place.shell(command);

      constexpr int kInfeasible = 5;  // verified: the body would lift off
      EXPECT_TRUE(output.code == 0 || output.code == kInfeasible)
          << page.name << ": " << command << "\nexit code " << output.code
          << "\n"
          << output.out;
    }
  }
  constexpr int kFew = 20;  // fewer would mean that they are not found
  EXPECT_GE(count, kFew);
}

TEST(Commands, OfSlowFilesAreRunOnTheFilesAsTheyStandToo) {
  for (const Slow& slow : kSlow) {
    const Output output =
        run({"validate", (tree().problems / slow.file).string()});

    EXPECT_EQ(output.code, 0) << output.err;
  }
}

/// Wherever a page names a verb, in a block or in a sentence, with flags.
TEST(Commands, HaveTheFlagsThatThePagesName) {
  const std::regex use("brachisto ([a-z][a-z-]*)([^`\n]*)");
  const std::regex flag("--[a-z][a-z-]*");
  std::map<std::string, std::string> help;
  int count = 0;
  for (const Page& page : pages()) {
    // A line that a backslash continues is one.
    const std::string text =
        std::regex_replace(page.text, std::regex("\\\\\n"), " ");
    for (std::sregex_iterator it(text.begin(), text.end(), use), end; it != end;
         ++it) {
      const std::string verb = (*it)[1], rest = (*it)[2];
      for (std::sregex_iterator f(rest.begin(), rest.end(), flag); f != end;
           ++f) {
        if (!help.contains(verb)) help[verb] = run({verb, "--help"}).out;
        ++count;
        EXPECT_TRUE(std::regex_search(help[verb],
                                      std::regex("[ ,]" + f->str() + "[ \n]")))
            << page.name << ": " << it->str();
      }
    }
  }
  constexpr int kFew = 20;
  EXPECT_GE(count, kFew);
}

/// Flags that a sentence names without their verb.
TEST(Commands, HaveTheFlagsThatSentencesName) {
  std::string help;
  for (const char* verb :
       {"solve", "validate", "sweep", "export", "merge", "report", "show",
        "race", "paper", "compare", "work-precision", "body", "design", "new",
        "nlp", "fit", "prove", "check-proof"}) {
    help += run({verb, "--help"}).out;
  }
  const std::regex use("`(--[a-z][a-z-]*)");
  for (const Page& page : pages()) {
    // The programs that measure and compare have their own.
    if (page.name.find("benchmarks") != std::string::npos ||
        page.name == "CONTRIBUTING.md") {
      continue;
    }
    for (std::sregex_iterator it(page.text.begin(), page.text.end(), use), end;
         it != end; ++it) {
      EXPECT_NE(help.find(it->str(1) + " "), std::string::npos)
          << page.name << ": " << it->str(1);
    }
  }
}

TEST(Commands, OfBootstrapAreKnownToIt) {
  const std::string script = content(kRoot / "bootstrap.sh");
  const std::regex use("\\./bootstrap\\.sh ([a-z]+)");
  for (const Page& page : pages()) {
    for (std::sregex_iterator it(page.text.begin(), page.text.end(), use), end;
         it != end; ++it) {
      EXPECT_NE(script.find("\n  " + it->str(1) + ")\n"), std::string::npos)
          << page.name << ": " << it->str();
    }
  }
}

}  // namespace
}  // namespace brachisto
