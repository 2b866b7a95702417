// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "plot/race_page.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace brachisto {
namespace {

using plot::racer_names;
using NameList = std::vector<std::string>;

TEST(RacerNames, AreThoseOfTheFiles) {
  EXPECT_EQ(racer_names({"/a/bead.yaml", "uniform_cylinder.yaml"}),
            (NameList{"bead", "uniform cylinder"}));
  EXPECT_EQ(racer_names({}), NameList{});
}

TEST(RacerNames, HaveAsManyFoldersAsTellThemApart) {
  EXPECT_EQ(racer_names({"/near_B/steep/a.yaml", "/near_B/flat/a.yaml",
                         "/far/flat/a.yaml", "/far/flat/b.yaml"}),
            (NameList{"steep/a", "near B/flat/a", "far/flat/a", "b"}));
  // Of a path that has no more folders.
  EXPECT_EQ(racer_names({"/a.yaml", "/steep/a.yaml"}),
            (NameList{"/a.yaml", "steep/a"}));
  EXPECT_EQ(racer_names({"steep/a.yaml", "steep/../flat/./a.yaml"}),
            (NameList{"steep/a", "flat/a"}));
}

TEST(RacerNames, AreThePathsWhereNoFolderTellsThemApart) {
  EXPECT_EQ(racer_names({"a.yaml", "a.yml", "b_c.yaml", "b c.yaml"}),
            (NameList{"a.yaml", "a.yml", "b_c.yaml", "b c.yaml"}));
  EXPECT_EQ(racer_names({"a.yaml", "a.yaml"}), (NameList{"a.yaml", "a.yaml"}));
}

}  // namespace
}  // namespace brachisto
