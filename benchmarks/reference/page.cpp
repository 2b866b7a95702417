// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "brachisto/solvers/program_solvers.hpp"
#include "brachisto/version.hpp"
#include "reference/rows.hpp"

namespace brachisto::benchmarks {

namespace {

double difference(const ClassicRow& row) {
  return row.value - row.classic->second.value;
}

/// Whether the digits are what is promised: verified, and as the second method
/// has them.
bool met(const ClassicRow& row) {
  constexpr double kTenDigits = 1e-10;
  return row.verified && std::abs(difference(row)) <
                             kTenDigits * std::max(1.0, std::abs(row.value));
}

/// What stands behind a value beside ours.
std::string ground(const Classic& classic) {
  return classic.enclosure     ? "closed form, enclosed"
         : classic.closed_form ? "closed form"
                               : "second method";
}

std::string in_full(double value) {
  return std::isnan(value) ? "–" : fmt::format("{:.13g}", value);
}

std::string values(const ReferenceSet& set) {
  std::string out =
      "| problem | value | estimated error | beside it | by | difference | "
      "literature | ours − literature |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- |\n";
  for (const ClassicRow& row : set.classics) {
    const Classic& one = *row.classic;
    out += fmt::format(
        "| {} | {} | {} | {} | {} | {} | {} | {} |\n", one.name,
        in_full(row.value), brief(row.estimate), ground(one), one.second.by,
        brief(difference(row)),
        one.literature ? fmt::format("{:.15g}, {}", one.literature->value,
                                     one.literature->source)
                       : "–",
        one.literature ? brief(row.value - one.literature->value) : "–");
  }
  return out;
}

std::string work(const ReferenceSet& set) {
  std::string out =
      "| problem | 1e-4 | 1e-6 | 1e-8 | 1e-10 | honest |\n"
      "| --- | --- | --- | --- | --- | --- |\n";
  for (const ClassicRow& row : set.classics) {
    out += "| " + row.classic->name;
    bool honest = true;
    for (const WorkPoint& point : row.work) {
      out += fmt::format(" | {} / {} / {:.2f} s{}", brief(point.error),
                         brief(point.estimate), point.seconds,
                         point.verified ? "" : ", not verified");
      // The second method has about fifteen digits.
      const double rounding = 1e-14 * std::max(1.0, std::abs(row.value));
      if (point.verified && point.error > point.estimate + rounding) {
        honest = false;
      }
    }
    out += honest ? " | yes |\n" : " | no |\n";
  }
  return out;
}

std::string beside(const ReferenceSet& set) {
  std::string out =
      "| problem | elements | variables | equations and limits | ours [s], all "
      "meshes | MUMPS [s], the last | its end | its value − ours |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- |\n";
  for (const ClassicRow& row : set.classics) {
    out += fmt::format("| {} | {} | {} | {} | {:.3f} | {:.3f} | {} | {} |\n",
                       row.classic->name, row.elements, row.variables,
                       row.constraints, row.seconds, row.peer_seconds,
                       row.peer_status, brief(row.peer_value - row.value));
  }
  return out;
}

std::string rolling(const ReferenceSet& set) {
  std::string out =
      "| row | τ | by | difference | seconds |\n"
      "| --- | --- | --- | --- | --- |\n";
  for (const RollingRow& row : set.rolling) {
    out +=
        fmt::format("| {} | {} | {} | {} | {:.3f} |\n", row.name,
                    row.verified ? in_full(row.tau) : "not verified",
                    row.second, brief(row.tau - row.second_tau), row.seconds);
  }
  return out;
}

}  // namespace

std::string brief(double value) {
  if (std::isnan(value)) return "–";
  return value == 0.0 ? "0" : fmt::format("{:.1e}", value);
}

std::string page_of(const ReferenceSet& set) {
  std::string out =
      "# A reference set of optimal-control problems\n\n"
      "`cmake --build --preset release --target reference_set` solves all "
      "problems below and writes this page, and `reference_set.json` with the "
      "`.nl` files into `build/release/benchmarks/reference_set`. The classics "
      "are stated in `brachisto/ocp.hpp` alone, in `benchmarks/reference`. "
      "Beside each value stands that of a closed form, or of shooting that "
      "shares no code with the library; and what the literature says. "
      "Enclosed is a closed form whose bounds are proven by Arb, with Newton's "
      "method for intervals where it has an equation to solve; the bounds "
      "stand in the table for machines. That the closed form is the least cost "
      "is taken from theory. Our values have no proof: beside them stands an "
      "estimate.\n\n"
      "## Formulas\n\n";
  for (const ClassicRow& row : set.classics) {
    out += fmt::format("- **{}**: {}.\n", row.classic->name,
                       row.classic->formulas);
  }
  out += "\n## Values\n\nA relative error of 1e-10 was asked for.\n\n" +
         set.stamp + "\n\n" + values(set) + "\nNot met:\n\n";
  bool all = true;
  for (const ClassicRow& row : set.classics) {
    if (met(row)) continue;
    all = false;
    out += row.verified ? "- " + row.classic->name +
                              ": the difference is larger than 1e-10.\n"
                        : "- " + row.why_not + ".\n";
  }
  if (all) out += "- none.\n";
  out +=
      "\n## Work and precision\n\nFor each wanted error: the true one (by the "
      "second method), the estimate, and the processor time. Honest: no "
      "verified answer errs by more than its estimate.\n\n"
      "The classics were in view when the estimate was made, so the last "
      "column is no independent test.\n\n" +
      set.stamp + "\n\n" + work(set) +
      "\n## Beside Ipopt with MUMPS\n\n"
      "The `.nl` file has the program of the last mesh and the stated guess. "
      "It is read by the AMPL Solver Library, with its automatic derivatives, "
      "and solved once by Ipopt with MUMPS, tolerance 1e-9 and "
      "complementarity 1e-12, without any refinement, for 20 s at most; ours "
      "is "
      "the time of the whole solve, all meshes, with the certificate. Where "
      "its "
      "value lies below ours it ended at a path that zigzags from point to "
      "point.\n\n" +
      set.stamp + "\n\n" + beside(set) +
      "\n## Rolling bodies\n\n"
      "Rows of `tests/support/reference_values.hpp` and, under limits, of "
      "`limited_scenes.hpp`, solved by `solve()`.\n\n" +
      set.stamp + "\n\n" + rolling(set) +
      "\n## Sources\n\n"
      "- COPS 3.0: Dolan, Moré and Munson, Benchmarking optimization software "
      "with COPS 3.0, ANL/MCS-TM-273, 2004; values as the tests of "
      "OptimizationProblems.jl cite them.\n"
      "- YAPSS: tests of the example `brachistochrone` of github.com/"
      "stevenrhall/yapss; g = 32.174 ft/s², the wall is y = x/2 + 0.1 ft.\n"
      "- PROPT's manual: Rutquist and Edvall, Tomlab Optimization, case "
      "studies van der Pol oscillator and batch reactor (dynopt, example 6).\n"
      "- Betts: Practical methods for optimal control and estimation using "
      "nonlinear programming, 2nd edition, SIAM, 2010.\n"
      "- Bryson, Denham and Dreyfus: Optimal programming problems with "
      "inequality constraints, AIAA Journal 1 (1963).\n";
  return out;
}

nlohmann::ordered_json json_of(const ReferenceSet& set) {
  using Json = nlohmann::ordered_json;
  const auto number = [](double value) {
    return std::isnan(value) ? Json(nullptr) : Json(value);
  };
  Json out{{"schema", "reference_set_1"},
           {"licence", "MIT"},
           {"citation",
            "The brachisto authors, brachisto: a reference set of "
            "optimal-control problems, version " +
                std::string(BRACHISTO_VERSION)},
           {"measured", set.stamp},
           {"ipopt", ipopt_version()},
           {"mumps", mumps_version()},
           {"tolerance", 1e-10}};
  for (const ClassicRow& row : set.classics) {
    const Classic& one = *row.classic;
    Json entry{{"name", one.name},
               {"formulas", one.formulas},
               {"value", number(row.value)},
               {"estimated_error", number(row.estimate)},
               {"verified", row.verified},
               {"met", met(row)},
               {"seconds", row.seconds},
               {"elements", row.elements},
               {"junctions", row.junctions},
               {"nl_file", row.nl_file},
               {"mumps",
                {{"end", row.peer_status},
                 {"value", number(row.peer_value)},
                 {"seconds", number(row.peer_seconds)}}}};
    if (!row.verified) entry["why_not"] = row.why_not;
    entry["second"] = {{"by", one.second.by},
                       {"ground", ground(one)},
                       {"value", one.second.value},
                       {"difference", number(difference(row))}};
    if (one.enclosure) {
      entry["second"]["enclosure"] = {one.enclosure->lower,
                                      one.enclosure->upper};
    }
    if (one.literature) {
      entry["literature"] = {{"source", one.literature->source},
                             {"value", one.literature->value}};
    }
    for (const WorkPoint& point : row.work) {
      entry["work_precision"].push_back({{"tolerance", point.tolerance},
                                         {"error", number(point.error)},
                                         {"estimate", number(point.estimate)},
                                         {"seconds", point.seconds},
                                         {"verified", point.verified}});
    }
    out["classics"].push_back(std::move(entry));
  }
  for (const RollingRow& row : set.rolling) {
    out["rolling_bodies"].push_back({{"name", row.name},
                                     {"limited", row.limited},
                                     {"tau", number(row.tau)},
                                     {"second_by", row.second},
                                     {"second_tau", row.second_tau},
                                     {"verified", row.verified},
                                     {"seconds", row.seconds}});
  }
  return out;
}

}  // namespace brachisto::benchmarks
