// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "plot/check_texts.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

#include "report/solutions.hpp"

namespace brachisto {
namespace {

namespace fs = std::filesystem;
using plot::check_meaning;
using NameSet = std::set<std::string>;

const fs::path kSources = BRACHISTO_SOURCE_DIR;

std::string content(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

void add_matches(const std::string& text, const std::string& pattern,
                 NameSet& names) {
  const std::regex expression(pattern);
  for (std::sregex_iterator match(text.begin(), text.end(), expression), end;
       match != end; ++match) {
    for (std::size_t i = 1; i < match->size(); ++i) {
      if ((*match)[i].matched) names.insert((*match)[i]);
    }
  }
}

/// The checks that the sources add to certificates, of whatever scenes and
/// methods: Certificate::add("name", …) and add(condition ? "name" : "name",
/// …). Where the cross-check of a limited track adds several, compare("name",
/// …).
NameSet checks_of_sources() {
  NameSet names;
  for (const auto& entry : fs::recursive_directory_iterator(kSources / "src")) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string text = content(entry.path());
    add_matches(
        text, R"re(certificate\.add\(\s*(?:\w+ \? )?"(\w+)"(?: : "(\w+)")?,)re",
        names);
    add_matches(text, R"re(compare\("(\w+)",)re", names);
  }
  return names;
}

TEST(CheckTexts, AreThereForAllThatTheSourcesAddAndForNoOther) {
  NameSet told;
  for (const plot::CheckText& text : plot::check_texts()) {
    EXPECT_TRUE(told.emplace(text.check).second) << text.check << " is twice";
    EXPECT_EQ(check_meaning(text.check), text.meaning);
    EXPECT_NE(text.meaning, "") << text.check;
  }

  EXPECT_EQ(told, checks_of_sources());
  EXPECT_EQ(check_meaning("no such check"), "");
}

TEST(CheckTexts, TellWhatTheDocumentationTellsMoreOf) {
  const std::string numerics = content(kSources / "docs/numerics.md");

  for (const plot::CheckText& text : plot::check_texts()) {
    EXPECT_NE(numerics.find("`" + std::string(text.check) + "`"),
              std::string::npos)
        << text.check;
  }
}

/// That the sources were read as they are meant to be.
TEST(CheckTexts, AreThereForTheChecksOfSolutions) {
  for (const Solution* solution :
       {&testing::off_centred_solution(), &testing::bead_solution(),
        &testing::discrete_solution(), &testing::unverified_solution()}) {
    ASSERT_FALSE(solution->certificate.checks.empty());
    for (const Check& check : solution->certificate.checks) {
      EXPECT_NE(check_meaning(check.name), "") << check.name;
    }
  }
}

}  // namespace
}  // namespace brachisto
