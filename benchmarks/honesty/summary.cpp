// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "honesty/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "support/csv.hpp"
#include "support/table.hpp"

namespace brachisto::benchmarks {

namespace {

double resolved(double error) {
  return std::max(error, kResolution);
}

std::vector<std::string> line(const std::vector<Named>& all, double tolerance) {
  const auto count = [&](const std::function<bool(const Measurement&)>& what) {
    const auto n = std::count_if(all.begin(), all.end(), [&](const Named& one) {
      return one.measured.tolerance == tolerance && what(one.measured);
    });
    return std::to_string(n);
  };
  const auto among = [&](const std::function<double(const Measurement&)>& value,
                         double q) {
    std::vector<double> values;
    for (const Named& one : all) {
      if (one.measured.tolerance == tolerance && one.measured.verified) {
        values.push_back(value(one.measured));
      }
    }
    return percentile(values, q);
  };
  return {
      fmt::format("{:.0e}", tolerance),
      count([](const Measurement&) { return true; }),
      count([](const Measurement& one) { return one.verified; }),
      count([](const Measurement& one) { return one.too_small_an_estimate(); }),
      count([](const Measurement& one) { return one.misses_tolerance(); }),
      count([](const Measurement& one) { return one.too_large_an_estimate(); }),
      fmt::format(
          "{:.1e}",
          among([](const Measurement& one) { return one.true_error; }, 0.5)),
      fmt::format(
          "{:.1e}",
          among([](const Measurement& one) { return one.true_error; }, 1.0)),
      fmt::format(
          "{:.1e}",
          among([](const Measurement& one) { return one.estimate; }, 0.5)),
      fmt::format("{:.2g}", among(
                                [](const Measurement& one) {
                                  return resolved(one.true_error) /
                                         resolved(one.estimate);
                                },
                                1.0)),
      fmt::format("{:.2g}", among(
                                [](const Measurement& one) {
                                  return resolved(one.estimate) /
                                         resolved(one.true_error);
                                },
                                0.5)),
      fmt::format("{:.2g}", among(
                                [](const Measurement& one) {
                                  return resolved(one.estimate) /
                                         resolved(one.true_error);
                                },
                                1.0)),
      fmt::format(
          "{:.3f}",
          among([](const Measurement& one) { return one.seconds; }, 0.5))};
}

}  // namespace

std::string csv(const std::vector<Named>& all) {
  std::string text =
      "scene,tolerance,verified,true_error,estimate,ratio,degree,elements,"
      "meshes,iterations,newton_steps,seconds,estimate_too_small,"
      "tolerance_missed,estimate_too_large,reason\n";
  for (const Named& one : all) {
    const Measurement& m = one.measured;
    text += fmt::format(
        "{},{:.0e},{:d},{:.3g},{:.3g},{:.3g},{},{},{},{},{},{:.4f},{:d},{:d},"
        "{:d},{}\n",
        csv_field(one.name), m.tolerance, m.verified, m.true_error, m.estimate,
        resolved(m.estimate) / resolved(m.true_error), m.degree, m.elements,
        m.meshes, m.iterations, m.newton_steps, m.seconds,
        m.too_small_an_estimate(), m.misses_tolerance(),
        m.too_large_an_estimate(), csv_field(m.reason.str()));
  }
  return text;
}

std::string summary(const std::vector<Named>& all,
                    const std::vector<double>& tolerances) {
  Rows table{{"tolerance", "scenes", "verified", "true > estimate",
              "true > tolerance", "estimate > 100 × true", "median true",
              "largest true", "median estimate", "worst true/estimate",
              "median estimate/true", "largest estimate/true", "seconds"}};
  for (const double tolerance : tolerances)
    table.push_back(line(all, tolerance));

  Rows violations{{"scene", "tolerance", "true", "estimate", "mesh", "what"}};
  for (const Named& one : all) {
    const Measurement& m = one.measured;
    std::string what = m.reason.str();
    if (m.too_small_an_estimate()) what += "estimate too small; ";
    if (m.misses_tolerance()) what += "tolerance missed; ";
    if (m.too_large_an_estimate()) what += "estimate too large; ";
    if (what.empty()) continue;
    violations.push_back({one.name, fmt::format("{:.0e}", m.tolerance),
                          fmt::format("{:.1e}", m.true_error),
                          fmt::format("{:.1e}", m.estimate),
                          fmt::format("{} × {}", m.degree, m.elements), what});
  }
  return markdown_table(table) + '\n' +
         (violations.size() == 1 ? "No violations.\n"
                                 : markdown_table(violations));
}

}  // namespace brachisto::benchmarks
