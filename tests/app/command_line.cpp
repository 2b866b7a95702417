// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What is said about a wrong command line, and how names of others are shown.

#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utmp.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/command.hpp"
#include "app/sweep_command.hpp"
#include "report/letters.hpp"

namespace brachisto {
namespace {

namespace fs = std::filesystem;
using testing::Output;
using testing::paper_problem;
using testing::run;
using testing::ScratchDirectory;

const std::string kBead = paper_problem("fig06_bead");

using Words = std::vector<std::string>;

struct Mistake {
  Words line;
  std::string said;
};

TEST(CommandLine, BlamesTheRightWordAndNamesTheNearest) {
  for (const auto& [line, said] : std::vector<Mistake>{
           {{"slove", kBead}, "\"slove\" is not a verb; did you mean solve?"},
           {{"slove", kBead, "--json"}, "did you mean solve?"},
           {{"work-precission", kBead}, "did you mean work-precision?"},
           {{}, "a verb is missing; there are solve, design, fit, validate, "},
           {{"help"}, "\"help\" is not a verb; there are solve, "},
           {{"solve", "--jsno", kBead},
            "--jsno is not a flag of solve; did you mean --json?"},
           {{"solve", kBead, "--jsno=1"}, "did you mean --json?"},
           {{"solve", "--jsno"}, "--jsno is not a flag of solve"},
           {{"solve", "--certfy", "extremal", kBead},
            "did you mean --certify?"},
           {{"sweep", kBead, "--out", "a", "--job", "2"}, "--jobs?"},
           {{"export", "map", "--cvs"}, "did you mean --csv?"},
           {{"--jsno"}, "--jsno is not a flag; did you mean --json?"},
           {{"--json", "solve", kBead},
            "--json stands before the verb; it belongs behind it"},
           {{"solve", kBead, "extra"}, "\"extra\" is one word too many"},
           {{"solve", kBead, "--", "extra"}, "\"extra\" is one word too many"},
           {{"solve"}, "brachisto solve: FILE is required"}}) {
    const Output output = run(line);

    EXPECT_EQ(output.code, 2) << ::testing::PrintToString(line);
    EXPECT_NE(output.err.find(said), std::string::npos)
        << ::testing::PrintToString(line) << "\n"
        << output.err;
  }
}

TEST(CommandLine, TellsTheCauseAsTheMessageOfTheDocument) {
  const Output output = run({"slove", kBead, "--json"});

  const std::string message =
      nlohmann::json::parse(output.out)["message"].get<std::string>();
  EXPECT_TRUE(message.starts_with("brachisto: \"slove\" is not a verb"))
      << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  EXPECT_TRUE(output.err.starts_with(message + "\n")) << output.err;
}

TEST(CommandLine, RefusesValuesThatMeanNothing) {
  const std::string number = "expected a number";
  const std::string name = "an empty text was read";
  for (const auto& [line, said] : std::vector<Mistake>{
           {{"solve", kBead, "--out", ""}, name},
           {{"solve", kBead, "--certify", ""}, name},
           {{"paper", "--out", ""}, name},
           {{"sweep", kBead, "--out", ""}, name},
           {{"merge", "a", "--out", ""}, name},
           {{"merge", "", "--out", "a"}, name},
           {{"export", "", "--csv"}, name},
           {{"report", ""}, name},
           {{"compare", kBead, "--out", ""}, name},
           {{"work-precision", kBead, "--out", ""}, name},
           {{"body", "disc", "--radius", ""}, name},
           {{"sweep", kBead, "--out", "a", "--timeout", "nan"}, number},
           {{"sweep", kBead, "--out", "a", "--timeout", "inf"}, number},
           {{"sweep", kBead, "--out", "a", "--timeout", "0"}, number},
           {{"sweep", kBead, "--out", "a", "--timeout", "-1"}, number},
           {{"sweep", kBead, "--out", "a", "--timeout", "1e10"}, number},
           {{"sweep", kBead, "--out", "a", "--memory", "nan"}, number},
           {{"sweep", kBead, "--out", "a", "--memory", "inf"}, number},
           {{"sweep", kBead, "--out", "a", "--memory", "-1"}, number},
           {{"sweep", kBead, "--out", "a", "--memory", "1"}, number},
           {{"sweep", kBead, "--out", "a", "--memory", "1e300"}, number},
           {{"compare", kBead, "--seconds", "nan"}, number},
           {{"compare", kBead, "--seconds", "inf"}, number},
           {{"compare", kBead, "--residual", "nan"}, number}}) {
    const Output output = run(line);

    EXPECT_EQ(output.code, 2) << ::testing::PrintToString(line);
    EXPECT_NE(output.err.find(said), std::string::npos)
        << ::testing::PrintToString(line) << "\n"
        << output.err;
  }
}

/// Exit code of a shell command.
int code_of(const std::string& command) {
  const int status = std::system(command.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(CommandLine, TellsThatHelpAndVersionAreLostOnAFullDisk) {
  for (const char* words : {"--help", "--version", "solve --help"}) {
    const auto command = std::string(BRACHISTO_APP " ")
                             .append(words)
                             .append(" > /dev/full 2> /dev/null");
    EXPECT_EQ(code_of(command), 6) << words;
  }
}

/// Bytes that a terminal would obey: controls but line feeds, C1 characters.
bool obeyed(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if ((byte < 0x20 && byte != '\n') || byte == 0x7F) return true;
    if (byte == 0xC2 && i + 1 < text.size() &&
        static_cast<unsigned char>(text[i + 1]) < 0xA0) {
      return true;
    }
  }
  return false;
}

/// Turns the terminal red, in three ways, and begins another line.
const std::string kEvil = "\x1b[31m\u009B31m\x7f\n\rred";

TEST(ControlCharacters, OfTheCommandLineDoNotReachTheTerminal) {
  const ScratchDirectory scratch;
  const std::string missing = (scratch.path() / kEvil).string();
  for (const Words& line :
       {Words{kEvil}, Words{"solve", kBead, kEvil}, Words{"solve", missing},
        Words{"solve", kBead, "--" + kEvil}, Words{"body", kEvil},
        Words{"body", "disc", "--radius", kEvil},
        Words{"export", missing, "--csv"},
        Words{"solve", kBead, "--set", kEvil},
        Words{"solve", kBead, "--set", "scene." + kEvil + "=1"},
        Words{"solve", kBead, "--set", "solver.method=" + kEvil},
        Words{"solve", kBead, "--out", kBead + "/" + kEvil},
        Words{"sweep", kBead, "--out", "a", "--jobs", kEvil},
        Words{"sweep", kBead, "--out", "a", "--shard", kEvil},
        Words{"paper", "--out", scratch.path().string(), "--problems", kEvil},
        Words{"merge", missing, "--out", missing}}) {
    const Output output = run(line);

    EXPECT_NE(output.code, 0) << ::testing::PrintToString(line);
    EXPECT_FALSE(obeyed(output.err)) << ::testing::PrintToString(output.err);
    EXPECT_EQ(output.out, "");
    EXPECT_EQ(output.err.find("\nred"), std::string::npos)
        << ::testing::PrintToString(output.err);
  }
}

TEST(ControlCharacters, OfFilesDoNotReachTheTerminal) {
  const ScratchDirectory scratch;
  const std::string good = scratch.file(
      kEvil + ".yaml", "scene: {body: {shape: bead}, finish: {L: 3, H: 1}}");
  const std::string bad = scratch.file(
      "bad" + kEvil + ".yaml",
      "scene: {body: {shape: \"\\e[31m\\x9b\"}, \"\\e[31m\\n\": 3}");
  const std::string points =
      scratch.file("points.yaml",
                   "scene: {body: {shape: bead}, finish: {L: 3, H: 1}, path: "
                   "{shape: points, file: \"\\e[31m\\n.csv\"}}");
  const std::string table = scratch.file(
      "table.yaml",
      "scene: {body: {shape: bead}, finish: {L: 3, H: 1}}\n"
      "sweep: {scene.finish.L: [2, 3], scene.path.shape: [\"\\e[31m\"]}");
  for (const Words& line :
       {Words{"validate", good}, Words{"validate", bad}, Words{"solve", bad},
        Words{"validate", points}, Words{"validate", table}}) {
    const Output output = run(line);

    EXPECT_FALSE(obeyed(output.out)) << ::testing::PrintToString(output.out);
    EXPECT_FALSE(obeyed(output.err)) << ::testing::PrintToString(output.err);
    EXPECT_NE(output.out + output.err, "");
  }
}

TEST(ControlCharacters, OfASweepDoNotReachTheTerminal) {
  const ScratchDirectory scratch;
  const std::string to = (scratch.path() / kEvil).string();
  ASSERT_EQ(run({"sweep", BRACHISTO_PROBLEMS_DIR "/sweeps/small.yaml", "--out",
                 to, "--quiet"})
                .code,
            0);
  for (const Words& line :
       {Words{"sweep", BRACHISTO_PROBLEMS_DIR "/sweeps/small.yaml", "--out", to,
              "--resume"},
        Words{"merge", to, "--out", to + "2"}, Words{"report", to},
        Words{"report", to}}) {
    const Output output = run(line);

    EXPECT_FALSE(obeyed(output.out)) << ::testing::PrintToString(output.out);
    EXPECT_FALSE(obeyed(output.err)) << ::testing::PrintToString(output.err);
    EXPECT_NE(output.out + output.err, "");
  }
}

/// What a command writes to a terminal of so many columns.
std::string on_terminal(const Words& arguments, unsigned short columns) {
  struct winsize window {};
  window.ws_col = columns;
  window.ws_row = 24;
  int terminal = -1;
  int line = -1;
  if (::openpty(&terminal, &line, nullptr, nullptr, &window) != 0) return "";
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(terminal);
    ::login_tty(line);
    std::vector<char*> argv{const_cast<char*>(BRACHISTO_APP)};
    for (const std::string& word : arguments) {
      argv.push_back(const_cast<char*>(word.c_str()));
    }
    argv.push_back(nullptr);
    ::execv(BRACHISTO_APP, argv.data());
    ::_exit(127);
  }
  // The line stays open here: when the last who has it lets go, what was not
  // read yet may be lost.
  std::string text;
  constexpr int kMilliseconds = 50;
  pollfd readable{terminal, POLLIN, 0};
  for (bool ended = false;;) {
    if (::poll(&readable, 1, kMilliseconds) > 0) {
      char buffer[4096];
      const ssize_t count = ::read(terminal, buffer, sizeof buffer);
      if (count > 0) text.append(buffer, static_cast<std::size_t>(count));
    } else if (ended) {
      break;
    } else {
      ended = ::waitpid(child, nullptr, WNOHANG) == child;
    }
  }
  ::close(line);
  ::close(terminal);
  return text;
}

TEST(ControlCharacters, OfDataDoNotReachTheTerminal) {
  const ScratchDirectory scratch;
  const std::string file = scratch.file(kEvil + ".yaml", "scene: 3");

  // The colours of our own are none of them.
  for (const Words& line :
       {Words{"validate", file, "--json", "--color=never"},
        Words{"solve", file + kEvil, "--json", "--color=never"}}) {
    const std::string text = on_terminal(line, 80);

    EXPECT_NE(text.find("\"message\""), std::string::npos) << text;
    for (const char* obeyed : {"\x1b", "\u009B", "\x7f"}) {
      EXPECT_EQ(text.find(obeyed), std::string::npos)
          << ::testing::PrintToString(text);
    }
  }
}

TEST(Progress, LinesFitTheTerminal) {
  constexpr unsigned short kColumns = 20;
  const Words arguments{"compare",       kBead, "--nodes", "11",
                        "--repetitions", "1",   "--json"};

  // Lines on the progress come first; the document begins with a brace.
  std::string text = on_terminal(arguments, kColumns);
  text.resize(std::min(text.size(), text.find('{')));

  EXPECT_NE(text.find("rolling_time p = 5…\r\n"), std::string::npos) << text;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\r', begin), text.size());
    EXPECT_LT(report::letters(text.substr(begin, end - begin)), kColumns);
    begin = end + 2;
  }
}

TEST(Progress, FitsTheTerminal) {
  constexpr unsigned short kColumns = 30;
  const ScratchDirectory scratch;

  const std::string text =
      on_terminal({"sweep", testing::small_sweep(scratch), "--out",
                   (scratch.path() / "map").string(), "--jobs", "2", "--json"},
                  kColumns);

  // Each bar stands between a return and "erase to the end of the line".
  std::size_t bars = 0;
  const std::string erase = "\x1b[K";
  for (std::size_t end = text.find(erase); end != std::string::npos;
       end = text.find(erase, end + 1)) {
    const std::size_t begin = text.rfind('\r', end) + 1;
    const std::string bar = text.substr(begin, end - begin);
    EXPECT_LT(report::letters(bar), kColumns) << bar;
    EXPECT_NE(bar.find("/36 scenes"), std::string::npos) << bar;
    ++bars;
  }
  EXPECT_GE(bars, 1u) << text;
}

}  // namespace
}  // namespace brachisto
