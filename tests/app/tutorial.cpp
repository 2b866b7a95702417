// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What docs/tutorial.md shows is what its commands write.

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <string>
#include <vector>

#include "app/shell.hpp"
#include "app/shown_lines.hpp"

namespace brachisto {
namespace {

namespace fs = std::filesystem;
using testing::content;
using testing::difference_of;
using testing::kRoot;
using testing::lines_of;
using testing::Output;
using testing::ScratchDirectory;
using testing::shell;

/// A command, and lines of what it writes: "…" stands for some, of the last
/// line for the rest.
struct Shown {
  std::string command;
  std::vector<std::string> lines;
};

struct Tutorial {
  std::vector<Shown> commands;
  std::string blocks, prose;
};

Tutorial tutorial() {
  Tutorial read;
  bool block = false;
  for (const std::string& line :
       lines_of(content(kRoot / "docs/tutorial.md"))) {
    if (line.starts_with("```")) {
      block = !block;
      // A block of another kind shows no commands.
      if (block) read.commands.emplace_back();
      continue;
    }
    (block ? read.blocks : read.prose) += line + "\n";
    if (block && line.starts_with("$ ")) {
      read.commands.push_back({line.substr(2), {}});
    } else if (block) {
      read.commands.back().lines.push_back(line);
    }
  }
  std::erase_if(read.commands,
                [](const Shown& one) { return one.command.empty(); });
  return read;
}

/// What is wrong with the lines that are shown of some output, or "".
std::string objection(const std::vector<std::string>& shown,
                      const std::vector<std::string>& written) {
  std::size_t at = 0;
  bool skips = false;
  for (const std::string& line : shown) {
    if (line == "…") {
      skips = true;
      continue;
    }
    std::string why = "is not written: " + line;
    for (; at < written.size(); ++at) {
      why = difference_of(line, written[at]);
      if (why.empty() || !skips) break;
    }
    if (at == written.size()) return "is not written: " + line;
    if (!why.empty()) return why;
    ++at;
    skips = false;
  }
  return skips || at == written.size() ? "" : "is left out: " + written[at];
}

/// Without lines on the progress, "[   2 s] …", which come where it is slow.
std::vector<std::string> without_progress(const std::string& text) {
  std::vector<std::string> lines = lines_of(text);
  std::erase_if(lines,
                [](const std::string& line) { return line.starts_with("[ "); });
  return lines;
}

TEST(Tutorial, ShowsWhatItsCommandsWrite) {
  const ScratchDirectory scratch;
  const Tutorial read = tutorial();
  constexpr std::size_t kFew = 10;
  ASSERT_GE(read.commands.size(), kFew);
  for (const Shown& shown : read.commands) {
    const Output output = shell(shown.command, scratch.path());

    EXPECT_EQ(output.code, 0) << shown.command << "\n" << output.out;
    EXPECT_EQ(objection(shown.lines, without_progress(output.out)), "")
        << shown.command << "\n"
        << output.out;
  }
  EXPECT_GT(fs::file_size(scratch.path() / "first/path.pdf"), 0u);
}

TEST(Tutorial, ShowsTheSceneOfTheFirstFile) {
  const ScratchDirectory scratch;
  ASSERT_EQ(shell("brachisto new first", scratch.path()).code, 0);
  std::string counting;
  for (const std::string& line :
       lines_of(content(scratch.path() / "first.yaml"))) {
    const std::size_t begin = line.find_first_not_of(' ');
    if (begin == std::string::npos || line[begin] == '#') continue;
    counting += line + "\n";
  }

  EXPECT_NE(
      content(kRoot / "docs/tutorial.md").find("```yaml\n" + counting + "```"),
      std::string::npos)
      << counting;
}

/// In sentences a number may have fewer digits.
TEST(Tutorial, NamesNoNumberThatItDoesNotShow) {
  const Tutorial read = tutorial();
  const std::regex number("[0-9]+\\.[0-9]+|[0-9]{3,}");
  int count = 0;
  for (std::sregex_iterator it(read.prose.begin(), read.prose.end(), number),
       end;
       it != end; ++it) {
    ++count;
    EXPECT_TRUE(std::regex_search(
        read.blocks,
        std::regex("(^|[^0-9.])" +
                   std::regex_replace(it->str(), std::regex("\\."), "\\."))))
        << it->str();
  }
  EXPECT_GE(count, 3);
}

}  // namespace
}  // namespace brachisto
