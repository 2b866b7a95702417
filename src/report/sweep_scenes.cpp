// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/sweep_scenes.hpp"
#include "math/enum_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>

namespace brachisto::report {

void check(const SweepTable& table) {
  const std::size_t scenes = table.outcomes.size();
  for (const SweepColumn& column : table.columns) {
    const std::size_t values =
        column.numeric() ? column.numbers.size() : column.words.size();
    if (values != scenes) {
      throw std::invalid_argument(
          fmt::format("sweep: column {} has {} values for {} scenes",
                      column.key, values, scenes));
    }
  }
  std::size_t product = 1;
  for (const SweepAxis& axis : table.axes) {
    product *= axis.count;
    for (const std::size_t column : axis.columns) {
      if (column < table.columns.size()) continue;
      throw std::invalid_argument(fmt::format(
          "sweep: an axis has column {} of {}", column, table.columns.size()));
    }
  }
  if (table.axes.empty() ? scenes > 1 : product != scenes) {
    throw std::invalid_argument(fmt::format(
        "sweep: axes of {} scenes, but {} outcomes", product, scenes));
  }
  for (const SweepOutcome& outcome : table.outcomes) {
    if (outcome.state == SweepOutcome::State::Verified &&
        !std::isfinite(outcome.tau)) {
      throw std::invalid_argument("sweep: a verified scene without τ");
    }
  }
}

Scenes all_scenes(const SweepTable& table) {
  Scenes scenes(table.outcomes.size());
  std::iota(scenes.begin(), scenes.end(), std::size_t{0});
  return scenes;
}

std::size_t index_along(const SweepTable& table, std::size_t axis,
                        std::size_t scene) {
  for (std::size_t a = table.axes.size() - 1; a > axis; --a) {
    scene /= table.axes[a].count;
  }
  return scene % table.axes[axis].count;
}

std::vector<Scenes> scenes_along(const SweepTable& table,
                                 const std::vector<std::size_t>& inner) {
  std::map<std::vector<std::size_t>, Scenes> groups;
  for (const std::size_t scene : all_scenes(table)) {
    std::vector<std::size_t> group;
    for (std::size_t a = 0; a < table.axes.size(); ++a) {
      if (std::ranges::find(inner, a) != inner.end()) continue;
      group.push_back(index_along(table, a, scene));
    }
    groups[group].push_back(scene);
  }
  std::vector<Scenes> out;
  out.reserve(groups.size());
  for (auto& [group, scenes] : groups) out.push_back(std::move(scenes));
  return out;
}

SweepDigest digest(const SweepTable& table, const Scenes& scenes) {
  SweepDigest found;
  const auto of = [&](std::size_t scene) -> const SweepOutcome& {
    return table.outcomes[scene];
  };
  for (const std::size_t scene : scenes) {
    const SweepOutcome& outcome = of(scene);
    found.failed += outcome.state == SweepOutcome::State::Failed;
    found.missing += outcome.state == SweepOutcome::State::Missing;
    if (outcome.state != SweepOutcome::State::Verified) continue;
    ++found.verified;
    found.infeasible += !outcome.feasible;
    const auto stands_out = [&](std::optional<std::size_t>& best, auto value,
                                double sign) {
      if (!best || sign * value(outcome) > sign * value(of(*best))) {
        best = scene;
      }
    };
    const auto tau = [](const SweepOutcome& o) { return o.tau; };
    stands_out(found.fastest, tau, -1.0);
    stands_out(found.slowest, tau, 1.0);
    if (outcome.feasible) stands_out(found.fastest_feasible, tau, -1.0);
    if (std::isfinite(outcome.estimated_error)) {
      stands_out(
          found.least_accurate,
          [](const SweepOutcome& o) { return o.estimated_error; }, 1.0);
    }
  }
  if (found.fastest &&
      (!found.fastest_feasible ||
       of(*found.fastest).tau < of(*found.fastest_feasible).tau)) {
    found.faster_infeasible = found.fastest;
  }
  return found;
}

std::vector<std::size_t> columns_that_vary(const SweepTable& table,
                                           const Scenes& scenes, bool vary) {
  std::vector<std::size_t> found;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const SweepColumn& column = table.columns[c];
    const bool varies = std::ranges::any_of(scenes, [&](std::size_t scene) {
      return column.numeric()
                 ? column.numbers[scene] != column.numbers[scenes.front()]
                 : column.words[scene] != column.words[scenes.front()];
    });
    if (varies == vary) found.push_back(c);
  }
  return found;
}

std::vector<std::string> distinct_words(const SweepColumn& column,
                                        const Scenes& scenes) {
  std::vector<std::string> words;
  for (const std::size_t scene : scenes) {
    const std::string& word = column.words[scene];
    if (std::ranges::find(words, word) == words.end()) {
      words.push_back(word);
    }
  }
  return words;
}

const char* name(SweepOutcome::State state) {
  constexpr auto kNames =
      table_by<SweepOutcome::State>("missing", "failed", "verified");
  return kNames[state];
}

}  // namespace brachisto::report
