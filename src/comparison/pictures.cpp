// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "comparison/pictures.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "comparison/finding.hpp"
#include "comparison/methods.hpp"
#include "comparison/statistics.hpp"
#include "math/enum_table.hpp"
#include "report/chart.hpp"
#include "report/rich_text.hpp"
#include "report/track_kind.hpp"

namespace brachisto::comparison {

std::string in_words(const Subject& subject) {
  const Scene& scene = subject.problem.scene;
  std::string text = report::in_words(scene);
  if (subject.limited()) {
    text += fmt::format("; {}: {}", report::track_kind(scene),
                        report::limits_in_words(scene));
  }
  return text;
}

namespace {

using report::Curve;
using report::Datum;
using report::Mark;
using report::Stroke;
using Kind = ComparedMethod::Kind;

/// Different in grey too.
struct Look {
  std::string colour;
  report::Stroke stroke;
  report::Mark mark;
};

/// \param degrees  number of lines of collocation, and which of them this is
Look look_of(const ComparedMethod& method, std::size_t degrees,
             std::size_t index) {
  constexpr std::array kMarks{Mark::Disc, Mark::Circle, Mark::Square,
                              Mark::Diamond, Mark::Triangle};
  const auto arms =
      table_by<DiscreteArm>(Look{"#a50026", Stroke::DashDotted, Mark::Triangle},
                            Look{"#d95f02", Stroke::DashDotted, Mark::Circle},
                            Look{"#8c510a", Stroke::Dotted, Mark::Diamond},
                            Look{"#666666", Stroke::Dashed, Mark::Disc});
  switch (method.kind) {
    case Kind::RollingTime:
      return {report::family_colours(degrees)[index], Stroke::Solid,
              kMarks[index % kMarks.size()]};
    case Kind::Adaptive:
      return {"#000000", Stroke::Dotted, Mark::Diamond};
    case Kind::ArcLength:
      return {"#000000", Stroke::Dashed, Mark::Square};
    case Kind::Extremal:
      return {"#000000", Stroke::Solid, Mark::Triangle};
    case Kind::DiscreteSystem:
      return arms[method.arm];
  }
  return {};
}

/// Its label without what rich text would lower.
std::string words(const ComparedMethod& method) {
  std::string text = label(method);
  std::ranges::replace(text, '_', ' ');
  return text;
}

/// A chart of processor time over an error, both logarithmic.
report::Chart chart_of(const char* name, const char* title, const char* error,
                       const Subject& subject) {
  report::Chart chart;
  chart.name = name;
  chart.title = title;
  chart.subtitle = in_words(subject);
  chart.x.label = error;
  chart.y.label = "processor time [s]";
  chart.x.scale = chart.y.scale = report::Scale::Logarithmic;
  return chart;
}

/// Sides that leave room about errors and times, as a factor.
void set_sides(report::Chart& chart, const report::Extent& errors,
               const report::Extent& times, double room) {
  chart.x.low = errors.low / room;
  chart.x.high = errors.high * room;
  chart.y.low = times.low / room;
  chart.y.high = times.high * room;
}

/// The field from one error to another.
std::vector<Datum> between(const report::Chart& chart, double left,
                           double right) {
  return {{left, *chart.y.low},
          {right, *chart.y.low},
          {right, *chart.y.high},
          {left, *chart.y.high}};
}

/// Where errors cannot be told from that of the reference.
void add_reference(report::Chart& chart, double error) {
  if (!(error > *chart.x.low)) return;
  chart.areas.push_back({.name = "error of the reference",
                         .outline = between(chart, *chart.x.low, error),
                         .fill = "#d9e6f2"});
}

/// A line upright at an error.
void add_upright(report::Chart& chart, double error, Curve line) {
  line.points = {{error, *chart.y.low}, {error, *chart.y.high}};
  chart.curves.push_back(std::move(line));
}

void add_spoken_error(report::Chart& chart) {
  add_upright(chart, kSpokenError,
              {.name = "error of " + error_words(kSpokenError),
               .stroke = Stroke::Dashed,
               .colour = "#1f5fa8",
               .width = 1.2,
               .id = "spoken_error"});
}

/// What a diagram has to the right and upwards.
struct Measure {
  const char* name;  ///< of its files
  const char* title;
  const char* label;
  std::optional<double> (*of)(const PrecisionPoint& point);
  const char* caption;
  bool of_tau = false;   ///< with orders, limits and runs without a result
  bool on_mesh = false;  ///< the time is without the start
};
constexpr Measure kMeasures[] = {
    {"work_precision", "Processor time against error of the transit time",
     "relative error of τ",
     [](const PrecisionPoint& point) { return point.error; },
     "Each mark is a whole solve, from the cycloid to the answer and its own "
     "estimate of the error; the nearer to the lower left, the better.",
     true},
    {"work_precision_mesh",
     "Processor time without the start against error of the transit time",
     "relative error of τ",
     [](const PrecisionPoint& point) {
       return point.fineness.mesh > 0 && !point.run.start.empty()
                  ? point.error
                  : std::nullopt;
     },
     "The same without the time from the cycloid to what the mesh begins with, "
     "which is alike for all meshes.",
     false, true},
    {"work_precision_path", "Processor time against error of the path",
     "distance from the reference path of the centre / max(L, H)",
     [](const PrecisionPoint& point) { return point.path_error; },
     "Of the path: the largest distance between places of the centre at equal "
     "parts of its path."},
    {"work_precision_energy", "Processor time against energy drift",
     "largest |w^2/2g − E| / max(L, H)",
     [](const PrecisionPoint& point) { return point.run.energy_drift; },
     "How far the speed is from that of the energy; methods that compute it "
     "from the energy are not there."},
};
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kThin = 0.9;  // [px]
constexpr const char* kGrey = "#666666";

/// Whether there is a point to draw.
bool is_told(const WorkPrecision& found, const Measure& measure) {
  return measure.of_tau ||
         std::ranges::any_of(found.lines, [&](const PrecisionLine& line) {
           return std::ranges::any_of(line.points,
                                      [&](const PrecisionPoint& point) {
                                        return measure.of(point).has_value();
                                      });
         });
}

class Diagram {
 public:
  Diagram(const WorkPrecision& found, const Measure& measure)
      : found_(found),
        measure_(measure),
        chart_(chart_of(measure.name, measure.title, measure.label,
                        found.subject)) {}

  [[nodiscard]] report::Chart draw() {
    const auto kind = [](const PrecisionLine& l) { return l.method.kind; };
    const auto degrees = static_cast<std::size_t>(
        std::ranges::count(found_.lines, Kind::RollingTime, kind));
    std::size_t index = 0;
    for (const PrecisionLine& line : found_.lines) {
      const Look look = look_of(line.method, degrees, index);
      if (line.method.kind == Kind::RollingTime) ++index;
      add_line(line, look);
    }
    set_ranges();
    if (!measure_.of_tau) return std::move(chart_);
    if (failures_ > 0) add_failures();
    add_reference(chart_, found_.reference.error);
    add_upright(chart_, found_.tolerance(),
                {.name = found_.polished() ? "KKT tolerance, before the polish"
                                           : "KKT tolerance",
                 .stroke = Stroke::Dotted,
                 .colour = kGrey,
                 .width = 1.2,
                 .id = "kkt_tolerance"});
    add_spoken_error(chart_);
    return std::move(chart_);
  }

 private:
  /// An error that cannot be told from that of the reference is drawn there.
  [[nodiscard]] double shown(double error) const {
    return std::max(
        {error,
         measure_.of_tau || measure_.on_mesh ? found_.reference.error : 0.0,
         std::numeric_limits<double>::epsilon()});
  }

  /// With the order that was observed.
  [[nodiscard]] std::string key_of(const PrecisionLine& line) const {
    std::string key = words(line.method);
    const std::optional<ObservedOrder>& order = line.order.order;
    if (!measure_.of_tau || !order) return key;
    key += fmt::format(", order {:.1f}", order->order);
    constexpr double kShown = 0.05;  // less is nothing in one decimal
    if (const double off = order->uncertainty.value_or(0.0); off >= kShown) {
      key += fmt::format(" ± {:.1f}", off);
    }
    return key;
  }

  void add_line(const PrecisionLine& line, const Look& look) {
    Curve curve{.name = key_of(line),
                .stroke = look.stroke,
                .colour = look.colour,
                .mark = look.mark,
                .id = identifier(line.method)};
    Curve spread = curve;
    spread.name.clear();
    spread.id += "_spread";
    spread.stroke = Stroke::Solid;
    spread.mark = Mark::None;
    spread.width = kThin;
    for (const PrecisionPoint& point : line.points) {
      const std::optional<double> error = measure_.of(point);
      if (!error) continue;
      const double x = shown(*error);
      const Spread times =
          spread_of(measure_.on_mesh ? point.run.on_mesh() : point.run.cpu);
      curve.points.push_back({x, times.median});
      spread.points.insert(
          spread.points.end(),
          {{x, times.least}, {x, times.greatest}, {kNone, kNone}});
      xs_.include(x);
      ys_.include(times.least);
      ys_.include(times.greatest);
    }
    looks_.push_back(look);
    if (curve.points.empty()) return;
    chart_.curves.push_back(std::move(spread));
    chart_.curves.push_back(std::move(curve));
  }

  [[nodiscard]] static bool at_limit(const PrecisionPoint& point) {
    return point.run.outcome == Measurement::Outcome::Limit;
  }
  [[nodiscard]] double time_of_failure(const PrecisionPoint& point) const {
    if (at_limit(point)) return found_.plan.seconds_per_point;
    return point.run.cpu.empty() ? point.run.seconds
                                 : spread_of(point.run.cpu).median;
  }

  /// With room for marks and words at the edges.
  void set_ranges() {
    if (measure_.of_tau) {
      for (const PrecisionLine& line : found_.lines) {
        for (const PrecisionPoint& point : line.points) {
          if (point.run.solved()) continue;
          ys_.include(time_of_failure(point));
          ++failures_;
        }
      }
      xs_.include(found_.tolerance());
      xs_.include(kSpokenError);
    }
    if (!(xs_.low <= xs_.high)) return;  // nothing to show
    constexpr double kRoom = 2.5;
    set_sides(chart_, xs_, ys_, kRoom);
  }

  /// Runs without a result have no error: they stand in a field of their own,
  /// at the time that they took or, at most, were given.
  void add_failures() {
    constexpr double kWidth = 1.6;  // decades
    const double left = *chart_.x.high;
    chart_.x.high = left * std::pow(10.0, kWidth);
    chart_.areas.push_back({.name = "no result",
                            .outline = between(chart_, left, *chart_.x.high)});
    bool limited = false;
    int place = 0;
    for (std::size_t i = 0; i < found_.lines.size(); ++i) {
      const PrecisionLine& line = found_.lines[i];
      Curve crosses{.name = words(line.method) + ": none",
                    .colour = looks_[i].colour,
                    .width = 0.0,
                    .mark = Mark::Cross,
                    .id = identifier(line.method) + "_without_result"};
      std::vector<int> meshes;
      for (const PrecisionPoint& point : line.points) {
        if (point.run.solved()) continue;
        limited = limited || at_limit(point);
        const double share = (place++ + 0.5) / failures_;
        crosses.points.push_back(
            {left * std::pow(10.0, kWidth * share), time_of_failure(point)});
        if (point.fineness.mesh > 0) meshes.push_back(point.fineness.mesh);
      }
      // More would make the key wider than it should be.
      constexpr std::size_t kNamed = 2;
      if (meshes.size() > kNamed) {
        crosses.name += fmt::format(" on {} meshes", meshes.size());
      } else if (!meshes.empty()) {
        crosses.name += fmt::format(" on {}", fmt::join(meshes, ", "));
      }
      if (crosses.points.empty()) continue;
      chart_.curves.push_back(std::move(crosses));
    }
    if (!limited) return;
    const double cap = found_.plan.seconds_per_point;
    chart_.curves.push_back(
        {.name = fmt::format("limit of {:g} s", cap),
         .points = {{*chart_.x.low, cap}, {*chart_.x.high, cap}},
         .stroke = Stroke::Dashed,
         .colour = kGrey,
         .width = kThin,
         .id = "limit"});
  }

  const WorkPrecision& found_;
  const Measure& measure_;
  report::Chart chart_;
  report::Extent xs_, ys_;
  std::vector<Look> looks_;  ///< of each line
  int failures_ = 0;
};

}  // namespace

std::vector<std::string> work_precision_picture_files() {
  std::vector<std::string> names;
  for (const Measure& measure : kMeasures) {
    for (const char* ending : {".svg", ".csv", ".gp"}) {
      names.push_back(fmt::format("{}{}", measure.name, ending));
    }
  }
  return names;
}

std::vector<Picture> pictures_of(const WorkPrecision& found) {
  std::vector<Picture> out;
  for (const Measure& measure : kMeasures) {
    if (!is_told(found, measure)) continue;
    out.push_back({report::chart_figure(Diagram(found, measure).draw()),
                   measure.caption});
  }
  return out;
}

std::vector<Picture> pictures_of(const MethodComparison& made) {
  constexpr double kRoom = 4.0;  // factors at the sides, for names
  constexpr double kBar = 0.9;   // of a range of times [px]
  if (!made.reference) return {};
  report::Chart chart =
      chart_of("compare", "Processor time against error, method by method",
               "relative error of τ", made.subject);
  chart.notes_apart = true;
  report::Extent xs, ys;
  for (const ComparisonRow& row : made.rows) {
    if (!row.error || row.run.cpu.empty()) continue;
    const Look look = look_of(row.method, 1, 0);
    const Spread times = spread_of(row.run.cpu);
    const double x = std::max({*row.error, made.reference->error,
                               std::numeric_limits<double>::epsilon()});
    const std::string name = report::as_rich_text(row.label);
    chart.curves.push_back({.points = {{x, times.least}, {x, times.greatest}},
                            .colour = look.colour,
                            .width = kBar,
                            .id = row.label + " spread"});
    chart.curves.push_back({.points = {{x, times.median}},
                            .colour = look.colour,
                            .width = 0.0,
                            .mark = look.mark,
                            .mark_size = 1.0,
                            .id = row.label});
    chart.notes.push_back(
        {.at = {x, times.median}, .text = name, .mark = report::Mark::None});
    xs.include(x);
    ys.include(times.least);
    ys.include(times.greatest);
  }
  if (chart.curves.empty()) return {};
  xs.include(kSpokenError);
  set_sides(chart, xs, ys, kRoom);
  add_spoken_error(chart);
  add_reference(chart, made.reference->error);
  return {
      {report::chart_figure(chart),
       fmt::format("Each mark is a method, those with a mesh on {} nodes; "
                   "the nearer to the lower left, the better.",
                   made.options.nodes) +
           (made.subject.limited()
                ? " The extremal method begins on the arcs that the program "
                  "found, whose time is part of its own."
                : "")}};
}

}  // namespace brachisto::comparison
