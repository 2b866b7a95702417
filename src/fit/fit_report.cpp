// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "fit/fit_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "report/chart.hpp"
#include "report/provenance.hpp"
#include "report/result_field.hpp"
#include "report/text_table.hpp"

namespace brachisto::fit {

namespace {

using report::Json;
using report::or_null;

constexpr double kMilli = 1e3;  // per second

/// The digits that two of the error leave.
std::string digits_of(double value, double error) {
  if (!(error > 0.0) || !std::isfinite(error)) {
    return fmt::format("{:.9g}", value);
  }
  const int places = 1 - static_cast<int>(std::floor(std::log10(error)));
  return fmt::format("{:.{}f}", value, std::clamp(places, 0, 15));
}

/// "0.0201 ± 0.0012"
std::string with_standard_error(double value, double error) {
  return fmt::format("{} ± {}", digits_of(value, error),
                     digits_of(error, error));
}

/// "25 rows, χ²/ν = 0.97"
std::string quality(const Fit& fit) {
  const std::string rows = report::counted(fit.residuals.size(), "row");
  if (const auto reduced = fit.reduced_chi_squared()) {
    return fmt::format("{}, χ²/ν = {:.3g} with ν = {}", rows, *reduced,
                       fit.freedom);
  }
  if (const auto scatter = fit.scatter()) {
    return fmt::format("{}, which scatter by {:.3g} ms", rows,
                       kMilli * *scatter);
  }
  return rows + ", none to spare";
}

report::Rows estimate_rows(const Fit& fit) {
  report::Rows rows{{"", "value", "standard error", "before"}};
  for (const Estimate& found : fit.estimates) {
    rows.push_back({found.key, digits_of(found.value, found.error),
                    digits_of(found.error, found.error),
                    fmt::format("{:.9g}", found.start)});
  }
  return rows;
}

report::Rows residual_rows(const Fit& fit) {
  report::Rows rows{{"s [m]", "t [s]", "predicted [s]", "residual [ms]"}};
  if (fit.sigma_known) rows.front().push_back("over sigma");
  for (const Residual& row : fit.residuals) {
    rows.push_back({fmt::format("{:.6f}", row.measured.s),
                    fmt::format("{:.6f}", row.measured.t),
                    fmt::format("{:.6f}", row.predicted),
                    fmt::format("{:.3f}", kMilli * row.value())});
    if (fit.sigma_known) {
      rows.back().push_back(
          fmt::format("{:.2f}", row.value() / row.measured.sigma));
    }
  }
  return rows;
}

/// The least and the greatest value that a scene may have of a number.
struct Bounds {
  double least = 0.0;
  double greatest = std::numeric_limits<double>::infinity();

  [[nodiscard]] double nearest(double value) const {
    return std::clamp(value, least, greatest);
  }
};

Bounds bounds_of(const Parameter& parameter, const Scene& scene) {
  if (parameter.number == MotionNumber::Loss) return {};
  return {0.0, largest_k(scene.body.eta_m)};
}

}  // namespace

std::string summary(const Fit& fit) {
  std::string out;
  report::add_table(out, "fitted", estimate_rows(fit));
  for (std::size_t i = 0; i < fit.estimates.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      report::add_line(out, "correlation",
                       fmt::format("{:.3f} of {} and {}", fit.correlation[i][j],
                                   fit.estimates[j].key, fit.estimates[i].key));
    }
  }
  report::add_line(out, "from", quality(fit));
  report::add_line(
      out, "T [s]",
      with_standard_error(fit.transit_time, fit.transit_time_error));
  report::add_table(out, "residuals", residual_rows(fit));
  return out;
}

std::string to_json(const Fit& fit, const Subject& subject) {
  Json estimates = Json::array();
  for (const Estimate& found : fit.estimates) {
    estimates.push_back({{"key", found.key},
                         {"value", found.value},
                         {"standard_error", found.error},
                         {"before", found.start}});
  }
  Json residuals = Json::array();
  for (const Residual& row : fit.residuals) {
    residuals.push_back(
        {{"s", row.measured.s},
         {"t", row.measured.t},
         {"sigma", fit.sigma_known ? Json(row.measured.sigma) : Json()},
         {"predicted", row.predicted},
         {"residual", row.value()}});
  }
  const Json document = {
      {"schema_version", report::kSchemaVersion},
      {"file", subject.file},
      {"measurements", subject.measurements},
      {"estimates", estimates},
      {"correlation", fit.correlation},
      {"condition", fit.condition},
      {"rows", fit.residuals.size()},
      {"degrees_of_freedom", fit.freedom},
      {"chi_squared", fit.sigma_known ? Json(fit.chi_squared) : Json()},
      {"reduced_chi_squared", or_null(fit.reduced_chi_squared())},
      {"scatter", or_null(fit.scatter())},
      {"transit_time", fit.transit_time},
      {"transit_time_standard_error", fit.transit_time_error},
      {"evaluations", fit.evaluations},
      {"residuals", residuals},
      {"doubts", doubts(fit)},
      {"provenance", Json::parse(report::provenance_json())}};
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

report::Figure residual_figure(const Fit& fit) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  report::Chart chart;
  chart.name = "residuals";
  chart.title = "Measured less predicted times";
  chart.subtitle = quality(fit);
  chart.x.label = "arc length s of the path of the centre [m]";
  chart.y.label = "residual [ms]";
  report::Curve zero{.colour = "#666666", .width = 0.9, .id = "zero"};
  report::Curve spread{.name = fit.sigma_known ? "± sigma" : "",
                       .colour = "#4575b4",
                       .width = 0.9,
                       .id = "sigma"};
  report::Curve marks{.name = "times",
                      .colour = "#000000",
                      .width = 0.0,
                      .mark = report::Mark::Disc,
                      .id = "residual"};
  for (const Residual& row : fit.residuals) {
    const double s = row.measured.s, y = kMilli * row.value();
    const double sigma = kMilli * row.measured.sigma;
    marks.points.push_back({s, y});
    spread.points.insert(spread.points.end(),
                         {{s, y - sigma}, {s, y + sigma}, {kNone, kNone}});
  }
  zero.points = {{0.0, 0.0}, {fit.residuals.back().measured.s, 0.0}};
  chart.curves.push_back(std::move(zero));
  if (fit.sigma_known) chart.curves.push_back(std::move(spread));
  chart.curves.push_back(std::move(marks));
  return report::chart_figure(chart);
}

std::vector<std::string> doubts(const Fit& fit) {
  std::vector<std::string> out;
  for (const Estimate& found : fit.estimates) {
    const Parameter* parameter = find_parameter(found.key);
    if (parameter == nullptr) continue;
    const double allowed =
        bounds_of(*parameter, fit.scene).nearest(found.value);
    if (allowed == found.value) continue;
    out.push_back(fmt::format(
        "{} = {} is beyond {:g}, by {:.1f} standard errors: no scene may have "
        "it, and {:g} is written in its place",
        found.key, with_standard_error(found.value, found.error), allowed,
        std::abs(found.value - allowed) / found.error, allowed));
  }
  // χ² has the mean ν and the variance 2ν.
  constexpr double kStandardDeviations = 3.0;
  const auto reduced = fit.reduced_chi_squared();
  const double excess = kStandardDeviations * std::sqrt(2.0 / fit.freedom);
  if (reduced && *reduced > 1.0 + excess) {
    out.push_back(fmt::format(
        "χ²/ν = {:.3g}: the times lie further from the model than sigma "
        "explains, and the standard errors are too small",
        *reduced));
  }
  return out;
}

std::vector<std::string> overrides_of(const Fit& fit) {
  std::vector<std::string> out;
  for (const Estimate& found : fit.estimates) {
    const Parameter* parameter = find_parameter(found.key);
    if (parameter == nullptr) continue;
    out.push_back(
        fmt::format("{}={}", found.key,
                    bounds_of(*parameter, fit.scene).nearest(found.value)));
  }
  return out;
}

std::string comment(const Fit& fit, const Subject& subject) {
  std::string out =
      fmt::format("# {} with values fitted to {}: {}\n", subject.file,
                  subject.measurements, quality(fit));
  for (const Estimate& found : fit.estimates) {
    out += fmt::format("# {} = {}\n", found.key,
                       with_standard_error(found.value, found.error));
  }
  return out + fmt::format("# T = {} s on the track of these times\n",
                           with_standard_error(fit.transit_time,
                                               fit.transit_time_error));
}

}  // namespace brachisto::fit
