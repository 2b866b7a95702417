// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "fsolve/findings.hpp"
#include "support/power_law.hpp"
#include "support/table.hpp"

namespace brachisto::benchmarks {

namespace {

using Datum = DiscreteReading::Datum;
using Outcome = DiscreteRun::Outcome;

constexpr std::array kArms{Arm::Octave, Arm::SciPy, Arm::Hybrid, Arm::Newton,
                           Arm::Lifted};

std::string significant(double value) {
  return fmt::format("{:.2g}", value);
}

/// Without the power of ten that other formats fall into.
std::string seconds(double value) {
  if (!(value > 0.0)) return "0";
  if (value >= 10.0) return fmt::format("{:.0f}", value);
  if (value >= 1.0) return fmt::format("{:.1f}", value);
  const int digits = 1 - static_cast<int>(std::floor(std::log10(value)));
  return fmt::format("{:.{}f}", value, digits);
}

std::string time_text(const DiscreteRun* run) {
  if (run == nullptr) return "";
  switch (run->outcome) {
    case Outcome::Solved:
      return seconds(run->cpu_seconds);
    case Outcome::Capped:
      return fmt::format("> {:g}, capped", run->cpu_seconds);
    case Outcome::Absent:
      return "not installed";
    case Outcome::Failed:
      break;
  }
  return fmt::format("failed after {}", seconds(run->cpu_seconds));
}

std::string mesh_text(const RollingRun& run) {
  return fmt::format("p = {}, {} element{}", run.degree, run.elements,
                     run.elements == 1 ? "" : "s");
}

/// To two digits, with blanks between thousands.
std::string whole(double value) {
  if (value < 10.0) return fmt::format("{:.1f}", value);
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  std::string text = fmt::format("{:.0f}", std::round(value / unit) * unit);
  constexpr int kGroup = 3;
  for (int at = static_cast<int>(text.size()) - kGroup; at > 0; at -= kGroup) {
    text.insert(static_cast<std::size_t>(at), " ");
  }
  return text;
}

std::string milliseconds(double value) {
  constexpr double kMilli = 1e3;
  return fmt::format("{:.2f}", kMilli * value);
}

/// The n of all arms, ascending.
std::vector<int> sizes(const FsolveFindings& found) {
  std::vector<int> out;
  for (const DiscretePoint& point : found.arms) {
    if (out.empty() || point.task.nodes > out.back()) {
      out.push_back(point.task.nodes);
    }
  }
  return out;
}

/// The equations with ε = 1e-3, whoever solved them; null if nobody did.
const DiscreteRun* with_differences(const FsolveFindings& found, Datum datum,
                                    int nodes) {
  for (const Arm arm :
       {Arm::Hybrid, Arm::SciPy, Arm::Octave, Arm::Simplified}) {
    const DiscreteRun* run = found.find(arm, datum, nodes);
    if (run != nullptr && run->solved()) return run;
  }
  return nullptr;
}

std::string times(const FsolveFindings& found, Datum datum) {
  Rows table{{"n", "τ", "error", "τ, ε → 0", "error", "Octave [s]", "SciPy [s]",
              "hybrid [s]", "newton [s]", "lifted [s]"}};
  const auto tau = [](const DiscreteRun* run) {
    return run != nullptr && run->solved() ? fmt::format("{:.4f}", run->tau)
                                           : "";
  };
  const auto error = [](const DiscreteRun* run) {
    return run != nullptr && run->solved() ? significant(run->error) : "";
  };
  for (const int nodes : sizes(found)) {
    const DiscreteRun* differences = with_differences(found, datum, nodes);
    const DiscreteRun* exact = found.find(Arm::Lifted, datum, nodes);
    std::vector<std::string> row{fmt::format("{}", nodes), tau(differences),
                                 error(differences), tau(exact), error(exact)};
    for (const Arm arm : kArms) {
      row.push_back(time_text(found.find(arm, datum, nodes)));
    }
    table.push_back(std::move(row));
  }
  return markdown_table(table);
}

/// Of datum rest: what an arm takes, against the cheapest rolling_time that is
/// at least as accurate.
std::string ratios(const FsolveFindings& found, Work work) {
  Rows table{{"n", "arm", "error", "CPU [s]", "rolling_time", "by", "error",
              "CPU [ms]", "ratio"}};
  constexpr int kFrom = 200;
  for (const int nodes : sizes(found)) {
    if (nodes < kFrom) continue;
    for (const Arm arm : kArms) {
      const DiscreteRun* run = found.find(arm, Datum::Rest, nodes);
      if (run == nullptr || run->outcome == Outcome::Absent) continue;
      // The same equations have the same solution, whoever does not find it.
      const DiscreteRun* accuracy =
          run->solved() ? run : with_differences(found, Datum::Rest, nodes);
      if (accuracy == nullptr) continue;
      const auto ours = cheapest(found.menu, work, accuracy->error);
      if (!ours) continue;
      table.push_back(
          {fmt::format("{}", nodes), name(arm), significant(accuracy->error),
           time_text(run), mesh_text(*ours),
           ours->way.method == ProgramSolver::Ipopt ? "Ipopt" : "Newton",
           significant(ours->error), milliseconds(ours->cpu_seconds),
           run->timed()
               ? fmt::format("{}{}", run->solved() ? "" : "> ",
                             whole(run->cpu_seconds / ours->cpu_seconds))
               : "no answer"});
    }
  }
  return markdown_table(table);
}

std::string exponents(const FsolveFindings& found) {
  constexpr int kFrom = 100, kTo = 400;
  Rows table{{"arm", "datum", "nodes", "CPU [s]", "exponent"}};
  for (const Datum datum : {Datum::Rest, Datum::Release}) {
    for (const Arm arm : kArms) {
      const DiscreteRun* from = found.find(arm, datum, kFrom);
      const DiscreteRun* to = found.find(arm, datum, kTo);
      if (from == nullptr || to == nullptr || !from->solved() || !to->timed()) {
        continue;
      }
      table.push_back(
          {name(arm), name(datum), fmt::format("{} – {}", kFrom, kTo),
           fmt::format("{} – {}", time_text(from), time_text(to)),
           fmt::format("{}{:.2f}", to->solved() ? "" : "> ",
                       std::log(to->cpu_seconds / from->cpu_seconds) /
                           std::log(double{kTo} / kFrom))});
    }
  }
  for (const ProgramSolver method :
       {ProgramSolver::Ipopt, ProgramSolver::NewtonKkt}) {
    const RollingRun* previous = nullptr;
    for (const RollingRun& run : found.growth) {
      if (run.way.method != method || !run.solved) continue;
      if (previous != nullptr) {
        table.push_back(
            {fmt::format("rolling_time, {}",
                         method == ProgramSolver::Ipopt ? "Ipopt" : "Newton"),
             "", fmt::format("{} – {}", previous->nodes, run.nodes),
             fmt::format("{} – {}", seconds(previous->cpu_seconds),
                         seconds(run.cpu_seconds)),
             fmt::format("{:.2f}",
                         std::log(run.cpu_seconds / previous->cpu_seconds) /
                             std::log(static_cast<double>(run.nodes) /
                                      previous->nodes))});
      }
      previous = &run;
    }
  }
  return markdown_table(table);
}

/// Why there is no answer, in short; the CSV file has all of it.
std::string reason(const DiscreteRun& run) {
  const std::string cause = run.cause.str();
  return cause.substr(0, cause.find(';'));
}

std::string floor_over_steps(const FsolveFindings& found) {
  Rows table{{"n", "ε", "τ", "error", "hybrid [s]"}};
  int nodes = 0;
  const auto row = [&](const std::string& step, const DiscreteRun* run) {
    if (run == nullptr) return;
    table.push_back({fmt::format("{}", nodes), step,
                     run->solved() ? fmt::format("{:.6f}", run->tau) : "",
                     run->solved() ? significant(run->error) : reason(*run),
                     time_text(run)});
  };
  for (const DiscretePoint& point : found.steps) {
    nodes = point.task.nodes;
    row(fmt::format("{:g}", point.task.epsilon), &point.run);
  }
  if (table.size() == 1) return "";
  row("0, exact", found.find(Arm::Newton, Datum::Rest, nodes));
  return markdown_table(table);
}

std::string floor_over_nodes(const FsolveFindings& found) {
  Rows table{
      {"n", "τ, ε = 1e-3", "error", "τ, ε → 0", "error", "ε moves τ by"}};
  std::vector<int> all = sizes(found);
  for (const DiscretePoint& point : found.large) {
    if (point.task.nodes > all.back()) all.push_back(point.task.nodes);
  }
  for (const int nodes : all) {
    const DiscreteRun* with = with_differences(found, Datum::Rest, nodes);
    const DiscreteRun* without = found.find(Arm::Lifted, Datum::Rest, nodes);
    if (without == nullptr || !without->solved()) continue;
    table.push_back(
        {fmt::format("{}", nodes),
         with != nullptr ? fmt::format("{:.6f}", with->tau) : "—",
         with != nullptr ? significant(with->error) : "",
         fmt::format("{:.6f}", without->tau), significant(without->error),
         with != nullptr ? fmt::format("{:.1e}", with->tau / without->tau - 1.0)
                         : ""});
  }
  return markdown_table(table);
}

/// Of an arm with exact derivatives, datum rest, from n = 400 on.
std::vector<report::Datum> over_nodes(const FsolveFindings& found, Arm arm,
                                      double DiscreteRun::*what) {
  constexpr int kFrom = 400;
  std::vector<report::Datum> out;
  for (const auto* points : {&found.arms, &found.large}) {
    for (const DiscretePoint& point : *points) {
      if (point.task.arm == arm && point.task.datum == Datum::Rest &&
          point.task.nodes >= kFrom && point.run.solved()) {
        out.push_back({static_cast<double>(point.task.nodes), point.run.*what});
      }
    }
  }
  return out;
}

std::string extrapolation(const FsolveFindings& found) {
  const auto error =
      fit_power(over_nodes(found, Arm::Lifted, &DiscreteRun::error));
  const auto dense =
      fit_power(over_nodes(found, Arm::Newton, &DiscreteRun::cpu_seconds));
  const auto sparse =
      fit_power(over_nodes(found, Arm::Lifted, &DiscreteRun::cpu_seconds));
  if (!error || !sparse) return "";
  Rows table{{"error", "n", "newton [s]", "lifted [s]", "rolling_time [s]"}};
  for (const double wanted : {1e-5, 1e-6, 1e-8, 1e-12}) {
    const double n = error->inverse(wanted);
    const auto ours = cheapest(found.menu, Work::OnMesh, wanted);
    table.push_back({fmt::format("{:.0e}", wanted), fmt::format("{:.1e}", n),
                     dense ? fmt::format("{:.1e}", dense->at(n)) : "",
                     fmt::format("{:.1e}", sparse->at(n)),
                     ours ? seconds(ours->cpu_seconds) + " (measured)" : ""});
  }
  return fmt::format(
      "{}\nFitted from n = 400 on: error ∝ n^{:.2f}, lifted ∝ n^{:.2f}{}.\n",
      markdown_table(table), error->exponent, sparse->exponent,
      dense ? fmt::format(", newton ∝ n^{:.2f}", dense->exponent) : "");
}

std::string accuracy(const FsolveFindings& found) {
  Rows table{{"wanted", "how", "mesh", "nodes", "error", "CPU [ms]"}};
  const auto row = [&](double wanted, const std::string& how,
                       const RollingRun& run) {
    table.push_back({fmt::format("{:.0e}", wanted), how, mesh_text(run),
                     fmt::format("{}", run.nodes),
                     run.error < found.exact_error
                         ? fmt::format("< {:.0e}", found.exact_error)
                         : significant(run.error),
                     milliseconds(run.cpu_seconds)});
  };
  for (std::size_t i = 0; i < found.wanted.size(); ++i) {
    const double wanted = found.tolerances[i];
    row(wanted, "by tolerance", found.wanted[i]);
    for (const Work work : {Work::Whole, Work::OnMesh}) {
      if (const auto ours = cheapest(found.menu, work, wanted)) {
        row(wanted, "cheapest, " + name(ours->way), *ours);
      }
    }
  }
  return markdown_table(table);
}

}  // namespace

const DiscreteRun* FsolveFindings::find(Arm arm, Datum datum, int nodes) const {
  for (const auto* points : {&arms, &large}) {
    for (const DiscretePoint& point : *points) {
      if (point.task.arm == arm && point.task.datum == datum &&
          point.task.nodes == nodes) {
        return &point.run;
      }
    }
  }
  return nullptr;
}

std::string report(const FsolveFindings& found) {
  return fmt::format(
      "# The approach of the paper beside rolling_time\n\n"
      "The reference case, τ = {:.12f} ± {:.0e}; errors are relative, of τ, "
      "against it.\nProcessor seconds of the solve alone, from the cycloid; a "
      "solve is capped at {:g} s.\n\n{}; {}.\n{}.\n\n"
      "## Datum rest\n\n{}\n## Datum release\n\n{}\n"
      "## Equal accuracy, datum rest\n\nThe cheapest uniform mesh of "
      "rolling_time, of all degrees and both methods,\nthat is at least as "
      "accurate. Solved on the mesh from the cycloid, to a residual\nof 1e-12, "
      "as the arms of fsolve are timed:\n\n{}\n"
      "From the scene to τ with its estimated error, continuation and check "
      "included:\n\n{}\n"
      "## Growth\n\n{}\n"
      "## What ε leaves\n\nDatum rest.\n\n{}\n{}\n"
      "## The arms with exact derivatives, extrapolated\n\nDatum rest. Not "
      "measured but for the last column.\n\n{}\n"
      "## Accuracy with rolling_time\n\n{}",
      found.exact_tau, found.exact_error * found.exact_tau, found.cap,
      found.others.at(0), found.others.at(1), machine(),
      times(found, Datum::Rest), times(found, Datum::Release),
      ratios(found, Work::OnMesh), ratios(found, Work::Whole), exponents(found),
      floor_over_steps(found), floor_over_nodes(found), extrapolation(found),
      accuracy(found));
}

}  // namespace brachisto::benchmarks
