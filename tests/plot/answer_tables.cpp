// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "plot/answer_tables.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "brachisto/report/result.hpp"
#include "plot/pages.hpp"
#include "report/solutions.hpp"
#include "report/xml.hpp"

namespace brachisto {
namespace {

using plot::symbols_html;
using report::Json;
using testing::document;
using testing::has;
using testing::xml_flaw;

TEST(Symbols, AreLoweredAndKeysStay) {
  EXPECT_EQ(symbols_html("R_n ≤ μ"), "R<sub>n</sub> ≤ μ");
  EXPECT_EQ(symbols_html("β_end, θ_m"), "β<sub>end</sub>, θ<sub>m</sub>");
  EXPECT_EQ(symbols_html("closure_at_A"), "closure_at_A");
  EXPECT_EQ(symbols_html("a < b & c_1^2"), "a &lt; b &amp; c_1^2");
  EXPECT_EQ(symbols_html("R_n = -1 m g, 1e-9"), "R<sub>n</sub> = −1 m g, 1e-9");
  EXPECT_EQ(symbols_html(""), "");
}

TEST(AnswerTables, AreWellFormed) {
  for (const Solution* solution :
       {&testing::off_centred_solution(), &testing::bead_solution(),
        &testing::limited_solution(), &testing::differentiated_solution()}) {
    const Json result = document(*solution);
    for (const auto table :
         {plot::asked_table, plot::found_table, plot::limits_table,
          plot::sensitivities_tables, plot::certificate_table, plot::way_tables,
          plot::provenance_tables}) {
      EXPECT_EQ(xml_flaw("<div>" + table(result) + "</div>"), "");
    }
  }
}

/// Every key of a result is told, but lists that are empty and what is null.
TEST(AnswerTables, TellEveryKey) {
  const Json result = document(testing::off_centred_solution());
  const std::string all =
      plot::found_table(result) + plot::limits_table(result) +
      plot::certificate_table(result) + plot::way_tables(result) +
      plot::provenance_tables(result);
  for (const auto& [key, value] : result.items()) {
    // These stand at the head of the page.
    if (key == "schema_version" || key == "status" || key == "message" ||
        key == "warnings" || key == "verified" || key == "feasible" ||
        key.ends_with("_because") || key == "scene" || key == "input" ||
        key == "certificate" || key == "provenance") {
      continue;
    }
    if (value.is_null() || (value.is_array() && value.empty())) continue;
    EXPECT_TRUE(has(all, "<code>" + key + "</code>")) << key;
  }
}

TEST(AnswerTables, TellLimitsWithTheirPrices) {
  const std::string table =
      plot::limits_table(document(testing::limited_solution()));

  EXPECT_TRUE(has(table, "<code>normal_force.max</code>"));
  EXPECT_TRUE(has(table, "−0.0625"));    // price
  EXPECT_TRUE(has(table, "−0.15625"));   // multiplier
  EXPECT_TRUE(has(table, "37.5 %"));     // of the time
  EXPECT_TRUE(has(table, ">nowhere<"));  // of the half-plane
}

TEST(AnswerTables, TellSensitivitiesOnlyOfWhatTheBodyHas) {
  const std::string table =
      plot::sensitivities_tables(document(testing::differentiated_solution()));

  EXPECT_TRUE(has(table, "<code>radius</code>"));
  EXPECT_FALSE(has(table, "<code>k</code>"));
  EXPECT_EQ(
      plot::sensitivities_tables(document(testing::off_centred_solution())),
      "");
}

TEST(AnswerTables, OfADocumentWithoutKeysAreEmpty) {
  const Json none = Json::object();

  EXPECT_EQ(plot::found_table(none), "");
  EXPECT_EQ(plot::limits_table(none), "");
  EXPECT_EQ(plot::certificate_table(none), "");
  EXPECT_EQ(plot::way_tables(none), "");
}

}  // namespace
}  // namespace brachisto
