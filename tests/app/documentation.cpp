// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What the documentation shows is what the command does.

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/command.hpp"

namespace brachisto {
namespace {

namespace fs = std::filesystem;
using testing::Output;
using testing::paper_problem;
using testing::run;
using testing::ScratchDirectory;

const fs::path kRoot = fs::path(BRACHISTO_PROBLEMS_DIR).parent_path();

std::string content(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A line cut into its numbers and what stands between them.
struct Parts {
  std::vector<std::string> words{""}, numbers;
};

Parts parts_of(const std::string& line) {
  Parts parts;
  for (std::size_t i = 0; i < line.size();) {
    const std::size_t end = line.find_first_not_of("0123456789.", i);
    const std::string number = line.substr(i, end - i);
    if (number.find_first_of("0123456789") != std::string::npos) {
      parts.numbers.push_back(number);
      parts.words.emplace_back();
      i += number.size();
    } else {
      parts.words.back() += line[i++];
    }
  }
  return parts;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

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
    const Parts ours = parts_of(answer[i]);
    const Parts theirs = parts_of(shown[i]);
    EXPECT_EQ(theirs.words, ours.words) << shown[i] << "\n" << answer[i];
    // Iterations and seconds, and the size of an error, are not the same
    // everywhere.
    if (shown[i].starts_with("  work ")) continue;
    const bool has_error = shown[i].find("error about") != std::string::npos;
    const std::size_t compared = has_error ? 1 : ours.numbers.size();
    ASSERT_EQ(theirs.numbers.size(), ours.numbers.size()) << answer[i];
    for (std::size_t j = 0; j < compared; ++j) {
      // The wanted accuracy; numbers of few digits are the same.
      constexpr double kAccuracy = 1e-10;
      constexpr std::size_t kFew = 8;
      if (ours.numbers[j].size() <= kFew) {
        EXPECT_EQ(theirs.numbers[j], ours.numbers[j]) << answer[i];
      } else {
        const double number = std::stod(ours.numbers[j]);
        EXPECT_NEAR(std::stod(theirs.numbers[j]), number, kAccuracy * number)
            << answer[i];
      }
    }
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

/// What a user reads.
struct Page {
  std::string name, text;
};

/// All pages, and the help of the command.
std::vector<Page> pages() {
  std::vector<Page> all{
      {"README.md", content(kRoot / "README.md")},
      {"CONTRIBUTING.md", content(kRoot / "CONTRIBUTING.md")},
      {"benchmarks/README.md", content(kRoot / "benchmarks/README.md")},
      {"brachisto --help", run({"--help"}).out}};
  for (const auto& entry : fs::directory_iterator(kRoot / "docs")) {
    if (entry.path().extension() != ".md") continue;
    all.push_back(
        {"docs/" + entry.path().filename().string(), content(entry.path())});
  }
  return all;
}

/// The lines of a page's blocks of code, fenced or indented, that begin with
/// `brachisto` or `./`; a line that ends in a backslash goes on.
std::vector<std::string> commands_of(const std::string& page) {
  std::vector<std::string> commands;
  bool fenced = false, goes_on = false;
  for (const std::string& line : lines_of(page)) {
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

/// The program and the problem files: of the build tree, or of an install tree
/// whose prefix the environment names.
struct Tree {
  fs::path programs, problems;
};

Tree tree() {
  const char* prefix = std::getenv("BRACHISTO_PREFIX");
  if (prefix == nullptr) {
    return {fs::path(BRACHISTO_APP).parent_path(), BRACHISTO_PROBLEMS_DIR};
  }
  const fs::path installed = prefix;
  return {installed / "bin", installed / "share/brachisto/problems"};
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
    {"work_precision/base.yaml", ", 40, 64, 80, 160, 400]", "]"},
    {"work_precision/base.yaml", "repetitions: 5", "repetitions: 1"},
    {"large/million_nodes.yaml", "1000001", "1001"},
    {"large/r_0.0002.yaml", "radius: 0.0002", "radius: 0.02"},
};

/// Commands that are not run here: test_paper_command runs the first; the
/// others install packages and build.
constexpr const char* kLeft[] = {"brachisto paper --out paper",
                                 "./bootstrap.sh "};

bool is_left(const std::string& command) {
  return std::any_of(std::begin(kLeft), std::end(kLeft), [&](const char* left) {
    return command.starts_with(left);
  });
}

/// A place to run the commands of a page in: the problem files, the slow ones
/// quick, and nothing else.
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
  }
  [[nodiscard]] const fs::path& path() const { return scratch_.path(); }

  /// Runs a line as a shell does; the exit code and all that was written.
  [[nodiscard]] Output shell(const std::string& line) const {
    const std::string script = tools_.file("line", line + "\n");
    const fs::path out = tools_.path() / "out";
    const int status =
        std::system(("cd '" + path().string() + "' && PATH='" +
                     tree().programs.string() + "':$PATH timeout 60 sh '" +
                     script + "' < /dev/null > '" + out.string() + "' 2>&1")
                        .c_str());
    return {WEXITSTATUS(status), content(out), ""};
  }

 private:
  testing::ScratchDirectory scratch_, tools_;
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
       {"solve", "validate", "sweep", "export", "merge", "report", "paper",
        "compare", "work-precision", "body"}) {
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
  const std::regex link(R"(\]\(([^)#:\s]*)(#([^)\s]*))?\))");
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
