// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "comparison/comparison.hpp"
#include "fsolve/findings.hpp"
#include "report/provenance.hpp"
#include "support/csv.hpp"

namespace brachisto::benchmarks {

namespace {

constexpr std::pair<const char*, std::vector<DiscretePoint> FsolveFindings::*>
    kDiscreteSets[] = {{"arms", &FsolveFindings::arms},
                       {"steps", &FsolveFindings::steps},
                       {"large", &FsolveFindings::large}};
constexpr std::pair<const char*, std::vector<RollingRun> FsolveFindings::*>
    kRollingSets[] = {{"menu", &FsolveFindings::menu},
                      {"growth", &FsolveFindings::growth},
                      {"by tolerance", &FsolveFindings::wanted}};

const char* word(DiscreteRun::Outcome outcome) {
  switch (outcome) {
    case DiscreteRun::Outcome::Solved:
      return "solved";
    case DiscreteRun::Outcome::Failed:
      return "failed";
    case DiscreteRun::Outcome::Capped:
      return "capped";
    case DiscreteRun::Outcome::Absent:
      return "not installed";
  }
  return "";
}

std::string row(const char* set, const DiscretePoint& point) {
  const auto& [task, run] = point;
  const bool differences = task.arm != Arm::Newton && task.arm != Arm::Lifted;
  return fmt::format(
      "{},{},{},{},,{},{},{},{},{},{},{},{}\n", name(task.arm), set,
      name(task.datum), task.nodes,
      differences ? fmt::format("{:g}", task.epsilon) : "0", word(run.outcome),
      run.cpu_seconds > 0.0 ? fmt::format("{:.4g}", run.cpu_seconds) : "",
      run.repetitions, run.evaluations,
      run.solved() ? fmt::format("{:.12f}", run.tau) : "",
      run.solved() ? fmt::format("{:.4g}", run.error) : "",
      csv_field(run.cause.str()));
}

std::string method(const Way& way) {
  return "rolling_time, " + name(way);
}

std::string row(const char* set, const RollingRun& run) {
  return fmt::format("\"{}\",{},,{},\"p = {}, N = {}\",,{},{:.4g},{},,,{},\n",
                     method(run.way), set, run.solved ? run.nodes : 0,
                     run.degree, run.elements, run.solved ? "solved" : "failed",
                     run.cpu_seconds, run.repetitions,
                     run.solved ? fmt::format("{:.4g}", run.error) : "");
}

/// The one of `all` that `row` writes as `text`.
template <class Value>
Value called(std::initializer_list<Value> all, const auto& row,
             const std::string& text) {
  const auto found = std::ranges::find_if(
      all, [&](Value value) { return row(value) == text; });
  if (found == all.end()) throw std::runtime_error("unknown: " + text);
  return *found;
}

DiscretePoint discrete_point(const CsvRow& row) {
  using enum Arm;
  using enum DiscreteRun::Outcome;
  using Datum = DiscreteReading::Datum;
  const auto name_of = [](auto value) { return std::string(name(value)); };
  DiscretePoint point;
  point.task = {
      called({Octave, SciPy, Hybrid, Newton, Lifted, Simplified}, name_of,
             row.text("method")),
      called({Datum::Rest, Datum::Release}, name_of, row.text("datum")),
      row.integer("nodes"), row.number("epsilon")};
  point.run = {.outcome = called({Solved, Failed, Capped, Absent}, word,
                                 row.text("outcome")),
               .tau = row.number("tau"),
               .error = row.number("error"),
               .cpu_seconds = row.number("cpu_seconds"),
               .evaluations = row.integer("evaluations"),
               .repetitions = row.integer("repetitions"),
               .cause = FixedText<200>(row.text("cause"))};
  return point;
}

RollingRun rolling_run(const CsvRow& row) {
  using enum Work;
  using enum ProgramSolver;
  RollingRun run;
  run.way = called({Way{OnMesh, Ipopt}, Way{OnMesh, NewtonKkt},
                    Way{Whole, Ipopt}, Way{Whole, NewtonKkt}},
                   method, row.text("method"));
  run.nodes = row.integer("nodes");
  if (std::sscanf(row.text("mesh").c_str(), "p = %d, N = %d", &run.degree,
                  &run.elements) != 2) {
    throw std::runtime_error("no mesh: " + row.text("mesh"));
  }
  run.solved = row.text("outcome") == word(DiscreteRun::Outcome::Solved);
  run.error = row.number("error");
  run.cpu_seconds = row.number("cpu_seconds");
  run.repetitions = row.integer("repetitions");
  return run;
}

}  // namespace

std::string csv(const FsolveFindings& found) {
  std::string text =
      "method,set,datum,nodes,mesh,epsilon,outcome,cpu_seconds,repetitions,"
      "evaluations,tau,error,cause\n";
  for (const auto& [set, points] : kDiscreteSets) {
    for (const DiscretePoint& point : found.*points) text += row(set, point);
  }
  for (const auto& [set, runs] : kRollingSets) {
    for (const RollingRun& run : found.*runs) text += row(set, run);
  }
  return text;
}

FsolveFindings read_findings(const std::string& name) {
  FsolveFindings found;
  std::ifstream file(name + ".json");
  if (!file) throw std::runtime_error("cannot read " + name + ".json");
  const auto origin = nlohmann::json::parse(file);
  found.cap = origin.at("options").at("cap_seconds");
  found.exact_tau = origin.at("reference").at("tau");
  found.exact_error = origin.at("reference").at("error");
  for (const CsvRow& row : read_csv(name + ".csv")) {
    for (const auto& [set, points] : kDiscreteSets) {
      if (row.text("set") == set) {
        (found.*points).push_back(discrete_point(row));
      }
    }
    for (const auto& [set, runs] : kRollingSets) {
      if (row.text("set") == set) (found.*runs).push_back(rolling_run(row));
    }
  }
  return found;
}

std::string origin_json(const FsolveFindings& found) {
  using Json = nlohmann::ordered_json;
  const comparison::Machine machine = comparison::this_machine();
  const Json document = {
      {"reference", {{"tau", found.exact_tau}, {"error", found.exact_error}}},
      {"options",
       {{"cap_seconds", found.cap},
        {"start", "cycloid"},
        {"residual", DiscreteSystem{}.tolerance},
        {"scipy", "xtol 1.49012e-8, as fsolve has it"},
        {"octave", "TolX = TolFun = 1e-10, Updating on"},
        {"threads", 1}}},
      {"programs", found.others},
      {"machine",
       {{"cpu", machine.cpu},
        {"kernel", machine.kernel},
        {"cores", machine.cores}}},
      {"provenance", Json::parse(report::provenance_json())}};
  return document.dump(2) + "\n";
}

}  // namespace brachisto::benchmarks
