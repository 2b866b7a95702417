// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "comparison/documents.hpp"
#include "fsolve/findings.hpp"
#include "report/provenance.hpp"

namespace brachisto::benchmarks {

namespace {

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

std::string row(const DiscretePoint& point) {
  const auto& [task, run] = point;
  const bool differences = task.arm != Arm::Newton && task.arm != Arm::Lifted;
  return fmt::format(
      "{},{},{},,{},{},{},{},{},{},{},{}\n", name(task.arm), name(task.datum),
      task.nodes, differences ? fmt::format("{:g}", task.epsilon) : "0",
      word(run.outcome),
      run.cpu_seconds > 0.0 ? fmt::format("{:.4g}", run.cpu_seconds) : "",
      run.repetitions, run.evaluations,
      run.solved() ? fmt::format("{:.12f}", run.tau) : "",
      run.solved() ? fmt::format("{:.4g}", run.error) : "",
      csv_field(run.cause.str()));
}

std::string row(const char* set, const RollingRun& run) {
  return fmt::format(
      "\"rolling_time, {}\",{},{},\"p = {}, N = {}\",,{},{:.4g},{},,,{},\n",
      name(run.way), set, run.solved ? run.nodes : 0, run.degree, run.elements,
      run.solved ? "solved" : "failed", run.cpu_seconds, run.repetitions,
      run.solved ? fmt::format("{:.4g}", run.error) : "");
}

}  // namespace

std::string csv(const FsolveFindings& found) {
  std::string text =
      "method,datum_or_set,nodes,mesh,epsilon,outcome,cpu_seconds,repetitions,"
      "evaluations,tau,error,cause\n";
  for (const auto* points : {&found.arms, &found.steps, &found.large}) {
    for (const DiscretePoint& point : *points) text += row(point);
  }
  for (const RollingRun& run : found.menu) text += row("menu", run);
  for (const RollingRun& run : found.growth) text += row("growth", run);
  for (const RollingRun& run : found.wanted) text += row("by tolerance", run);
  return text;
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
