// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Manual, completions and schemas say what the help and the schema say, and
// those who read them find nothing amiss.

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "app/shell.hpp"

namespace brachisto {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::content;
using testing::has_program;
using testing::lines_of;
using testing::Output;
using testing::run;
using testing::ScratchDirectory;
using testing::shell;
using testing::tree;

using Names = std::vector<std::string>;

Names matches_of(const std::string& text, const std::regex& what) {
  Names found;
  for (std::sregex_iterator it(text.begin(), text.end(), what), end; it != end;
       ++it) {
    found.push_back((*it)[1]);
  }
  return found;
}

/// As the help lists them.
Names verbs() {
  const std::string help = run({"--help"}).out;
  const std::size_t begin = help.find("Subcommands:");
  return matches_of(help.substr(begin, help.find("Examples:") - begin),
                    std::regex("\n  ([a-z-]+) "));
}

Names flags_of(const std::string& verb) {
  return matches_of(run({verb, "--help"}).out,
                    std::regex("\n *(?:-h,)?(--[a-z-]+)"));
}

/// Dotted keys of a schema of maps.
void add_keys(const json& schema, const std::string& before, Names& keys) {
  if (!schema.contains("properties")) return;
  for (const auto& [name, value] : schema["properties"].items()) {
    const std::string key = before.empty() ? name : before + "." + name;
    keys.push_back(key);
    if (key != "sweep") add_keys(value, key, keys);
  }
}

Names keys() {
  Names all;
  add_keys(json::parse(run({"schema"}).out), "", all);
  return all;
}

/// A page as it is read: without what stands for single letters and fonts.
std::string read_page(const fs::path& page) {
  std::string text = content(tree().share / "man" / page);
  for (const auto& [roff, letter] :
       std::vector<std::pair<std::string, std::string>>{
           {"\\-", "-"}, {"\\fB", ""}, {"\\fI", ""}, {"\\fR", ""}}) {
    for (std::size_t at = text.find(roff); at != std::string::npos;
         at = text.find(roff, at)) {
      text.replace(at, roff.size(), letter);
    }
  }
  return text;
}

TEST(Manual, HasEveryVerbAndEveryFlagOfTheHelp) {
  constexpr std::size_t kFew = 10;
  ASSERT_GE(verbs().size(), kFew);
  const std::string front = read_page("man1/brachisto.1");
  for (const std::string& verb : verbs()) {
    const std::string page = read_page("man1/brachisto-" + verb + ".1");

    EXPECT_NE(front.find(".TP\n" + verb + "\n"), std::string::npos) << verb;
    const Names flags = flags_of(verb);
    EXPECT_GE(flags.size(), 2u) << verb;  // --help and --color at least
    for (const std::string& flag : flags) {
      EXPECT_TRUE(std::regex_search(page, std::regex("\\.TP\n" + flag + "\\b")))
          << verb << " " << flag;
    }
  }
}

TEST(Manual, HasEveryKeyOfProblemFiles) {
  const std::string page = read_page("man5/brachisto-problem.5");
  const Names all = keys();
  constexpr std::size_t kFew = 80;
  EXPECT_GE(all.size(), kFew);
  for (const std::string& key : all) {
    EXPECT_NE(page.find(".TP\n" + key + " ("), std::string::npos) << key;
  }
}

TEST(Manual, IsCleanToThoseWhoReadIt) {
  const Names readers{"man --warnings -l $page 2>&1 > /dev/null",
                      "groff -man -Tutf8 -k -ww -z $page 2>&1",
                      "mandoc -T lint -W warning $page 2>&1"};
  int count = 0;
  for (const std::string& reader : readers) {
    if (!has_program(reader.substr(0, reader.find(' ')))) continue;
    ++count;
    // A page that every build makes anew has no date.
    const Output output = shell("export LC_ALL=C.UTF-8\nfor page in */*; do\n" +
                                    reader + " | grep -v 'missing date'\ndone",
                                tree().share / "man");

    EXPECT_EQ(output.out, "") << reader;
  }
  if (count == 0) GTEST_SKIP() << "no man, groff or mandoc";
}

/// What bash offers for the last of some words.
Names offered(const Names& words, const fs::path& where = ".") {
  std::string line =
      "source '" +
      (tree().share / "bash-completion/completions/brachisto").string() +
      "'\nCOMP_WORDS=(brachisto";
  for (const std::string& word : words) line += " '" + word + "'";
  line += ")\nCOMP_CWORD=" + std::to_string(words.size()) +
          "\n_brachisto\nprintf '%s\\n' \"${COMPREPLY[@]}\"";
  Names found = lines_of(shell(line, where, "bash").out);
  std::ranges::sort(found);
  return found;
}

TEST(Completion, OfBashOffersEveryVerbAndEveryFlagOfTheHelp) {
  if (!has_program("bash")) GTEST_SKIP() << "no bash";
  Names all = verbs();
  all.insert(all.end(), {"--help", "--version"});
  std::ranges::sort(all);
  EXPECT_EQ(offered({""}), all);
  for (const std::string& verb : verbs()) {
    Names flags = flags_of(verb);
    std::ranges::sort(flags);

    EXPECT_EQ(offered({verb, "--"}), flags) << verb;
  }
}

TEST(Completion, OfBashOffersWordsKeysFilesAndDirectories) {
  if (!has_program("bash")) GTEST_SKIP() << "no bash";
  const ScratchDirectory scratch;
  (void)scratch.file("a b.yaml", "");
  (void)scratch.file("c.json", "");
  (void)scratch.file("d.svg", "");
  fs::create_directory(scratch.path() / "dir");
  const auto here = [&](const Names& words) {
    return offered(words, scratch.path());
  };

  EXPECT_EQ(here({"so"}), Names{"solve"});
  EXPECT_EQ(here({"solve", ""}), (Names{"a b.yaml", "c.json", "dir"}));
  EXPECT_EQ(here({"solve", "a"}), Names{"a b.yaml"});
  EXPECT_EQ(here({"solve", "--out", ""}), Names{"dir"});
  EXPECT_EQ(here({"export", ""}), Names{"dir"});
  EXPECT_EQ(here({"schema", ""}), (Names{"problem", "result"}));
  EXPECT_EQ(here({"solve", "x", "--color", "a"}), (Names{"always", "auto"}));
  EXPECT_EQ(here({"solve", "--certify", ""}),
            (Names{"extremal", "none", "proof"}));
  EXPECT_EQ(here({"solve", "--set", "scene.finish."}),
            (Names{"scene.finish.H=", "scene.finish.L="}));
  // Readline makes three words of it, unless it is told otherwise.
  EXPECT_EQ(here({"solve", "--set", "solver.search", "=", "g"}),
            Names{"global"});
  EXPECT_EQ(here({"solve", "--set", "solver.search", "="}),
            (Names{"global", "principal"}));
  EXPECT_EQ(here({"solve", "--set", "solver.search=g"}),
            Names{"solver.search=global"});
}

TEST(Completion, OfFishOffersTheSame) {
  if (!has_program("fish")) GTEST_SKIP() << "no fish";
  const std::string source =
      "source '" +
      (tree().share / "fish/vendor_completions.d/brachisto.fish").string() +
      "'\n";
  const auto offers = [&](const std::string& line) {
    std::set<std::string> words;
    const std::string text =
        shell(source + "complete -C '" + line + "'", ".", "fish").out;
    for (const std::string& word : lines_of(text)) {
      words.insert(word.substr(0, word.find('\t')));
    }
    return words;
  };

  for (const std::string& verb : verbs()) {
    EXPECT_TRUE(offers("brachisto ").contains(verb)) << verb;
    for (const std::string& flag : flags_of(verb)) {
      EXPECT_TRUE(offers("brachisto " + verb + " --").contains(flag))
          << verb << " " << flag;
    }
  }
  EXPECT_EQ(offers("brachisto new x --kind d"),
            std::set<std::string>{"design"});
  EXPECT_TRUE(offers("brachisto solve x --set solver.se")
                  .contains("solver.search=global"));
}

/// What the functions of zsh are told.
TEST(Completion, OfZshOffersTheSame) {
  if (!has_program("zsh")) GTEST_SKIP() << "no zsh";
  const std::string file =
      (tree().share / "zsh/site-functions/_brachisto").string();
  const auto told = [&](const std::string& words, int current) {
    return shell(
               "_describe() { print -rl -- ${(P)2} }\n"
               "_files() { print -rl -- \"$@\" }\n"
               "compadd() { print -rl -- ${(P)${@[-1]}} }\n"
               "words=(" +
                   words + "); CURRENT=" + std::to_string(current) +
                   "\nsource '" + file + "'",
               ".", "zsh -f")
        .out;
  };

  for (const std::string& verb : verbs()) {
    EXPECT_NE(told("brachisto ''", 2).find("\n" + verb + ":"),
              verb == verbs().front() ? 0 : std::string::npos)
        << verb;
    for (const std::string& flag : flags_of(verb)) {
      EXPECT_NE(told("brachisto " + verb + " --", 3).find(flag + ":"),
                std::string::npos)
          << verb << " " << flag;
    }
  }
  EXPECT_EQ(told("brachisto solve ''", 3), "-g\n*.(yaml|json)\n");
  EXPECT_EQ(told("brachisto export ''", 3), "-/\n");
  EXPECT_NE(told("brachisto solve --set scene.", 4).find("scene.finish.L=\n"),
            std::string::npos);
}

TEST(Schemas, AreThoseThatTheVerbPrints) {
  const fs::path schemas = tree().share / "brachisto/schemas";

  EXPECT_EQ(content(schemas / "problem.schema.json"), run({"schema"}).out);
  EXPECT_EQ(content(schemas / "result.schema.json"),
            run({"schema", "result"}).out);
}

}  // namespace
}  // namespace brachisto
