// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Files of a sweep's page.

#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "plot/sweep_page.hpp"

namespace brachisto::testing {

/// Of a sweep whose tracks were not kept.
[[nodiscard]] inline std::vector<report::OutputFile> sweep_report(
    const SweepTable& table) {
  return plot::sweep_report(table, {}, nullptr).files;
}

/// A time τ that grows with all parameters.
[[nodiscard]] inline double sum(const std::vector<double>& at) {
  double tau = 5.0;
  for (const double value : at) tau += value;
  return tau;
}

/// Of the pictures, which each have a table and a script.
[[nodiscard]] inline std::vector<std::string> names(
    const std::vector<report::OutputFile>& files) {
  std::vector<std::string> pictures, all;
  for (const report::OutputFile& file : files) {
    all.push_back(file.name);
    if (!file.name.ends_with(".svg")) continue;
    const std::string name = file.name.substr(0, file.name.size() - 4);
    EXPECT_THAT(all, ::testing::IsSupersetOf({name + ".csv", name + ".gp"}));
    pictures.push_back(name);
  }
  EXPECT_EQ(all[all.size() - 2], "scenes.csv");
  EXPECT_EQ(all.back(), "index.html");
  return pictures;
}

}  // namespace brachisto::testing
