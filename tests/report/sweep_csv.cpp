// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/csv.hpp"

#include <gtest/gtest.h>

#include <string>

#include "report/sweep_tables.hpp"

namespace brachisto::report {
namespace {

using brachisto::testing::fail;
using brachisto::testing::sweep_over;

TEST(SweepCsv, HasARowPerSceneInTheUnitsOfTheTable) {
  SweepTable table = sweep_over({{"scene.body.theta_m", 0.1, 0.2, 3}},
                                [](const std::vector<double>&) { return 0.1; });
  fail(table, 1, "a \"b\", c");
  table.outcomes[2] = {};

  const std::string csv = sweep_csv(table);

  EXPECT_EQ(csv,
            "scene,scene.body.theta_m,state,status,feasible,tau,transit_time,"
            "estimated_error,end_angle,message\n"
            "0,0.10000000000000001,verified,solved,true,0.10000000000000001,"
            "0.025000000000000001,9.9999999999999994e-12,1,\n"
            "1,0.15000000000000002,failed,max_iterations,,,,,,\"a \"\"b\"\", "
            "c\"\n"
            "2,0.20000000000000001,missing,,,,,,,\n");
}

}  // namespace
}  // namespace brachisto::report
