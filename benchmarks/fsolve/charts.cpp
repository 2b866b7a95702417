// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "fsolve/findings.hpp"
#include "report/chart.hpp"
#include "support/table.hpp"

namespace brachisto::benchmarks {

namespace {

using report::Chart;
using report::Curve;
using report::Mark;
using report::Stroke;
using Datum = DiscreteReading::Datum;
using Outcome = DiscreteRun::Outcome;

/// How an arm looks in every figure.
struct Look {
  Arm arm;
  const char* words;
  const char* colour;
  Stroke stroke;
  Mark mark;
};

constexpr std::array kLooks{
    Look{Arm::Octave, "Octave fsolve", "#7b3294", Stroke::DashDotted,
         Mark::Diamond},
    Look{Arm::SciPy, "SciPy fsolve", "#a50026", Stroke::DashDotted,
         Mark::Square},
    Look{Arm::Hybrid, "hybrid", "#d95f02", Stroke::Solid, Mark::Triangle},
    Look{Arm::Newton, "exact gradient, dense", "#8c510a", Stroke::Dashed,
         Mark::Circle},
    Look{Arm::Lifted, "exact gradient, lifted", "#666666", Stroke::Dashed,
         Mark::Disc}};
constexpr const char* kOurs = "#08519c";
constexpr const char* kGrey = "#666666";
constexpr double kThin = 0.9;  // [px]

Chart logarithmic(const std::string& name, const char* title, const char* x,
                  const char* y) {
  Chart chart;
  chart.name = name.substr(name.find_last_of('/') + 1);
  chart.title = title;
  chart.x.label = x;
  chart.x.scale = report::Scale::Logarithmic;
  chart.y.label = y;
  chart.y.scale = report::Scale::Logarithmic;
  return chart;
}

Curve curve_of(const Look& look) {
  return {.name = look.words,
          .points = {},
          .stroke = look.stroke,
          .colour = look.colour,
          .mark = look.mark,
          .id = name(look.arm)};
}

/// All points of an arm with ε = 1e-3 or none, ascending in n.
std::vector<DiscretePoint> points_of(const FsolveFindings& found, Arm arm,
                                     Datum datum) {
  std::vector<DiscretePoint> out;
  for (const auto* points : {&found.arms, &found.large}) {
    for (const DiscretePoint& point : *points) {
      if (point.task.arm == arm && point.task.datum == datum) {
        out.push_back(point);
      }
    }
  }
  return out;
}

/// A line at the cap across the chart, and what the crosses are.
void add_cap(Chart& chart, const FsolveFindings& found, double low,
             double high) {
  chart.curves.push_back(
      {.name = fmt::format("cap of {:g} s, crosses: no answer", found.cap),
       .points = {{low, found.cap}, {high, found.cap}},
       .stroke = Stroke::Dashed,
       .colour = kGrey,
       .width = kThin,
       .id = "cap"});
}

/// Processor time over n.
Chart growth(const FsolveFindings& found, const std::string& name) {
  Chart chart = logarithmic(name, "Processor time against the number of nodes",
                            "nodes", "processor time [s]");
  bool any_crosses = false;
  double low = 1e300, high = 0.0;
  const auto include = [&](double nodes) {
    low = std::min(low, nodes);
    high = std::max(high, nodes);
  };
  for (const Look& look : kLooks) {
    Curve curve = curve_of(look);
    Curve crosses = curve;
    crosses.name.clear();
    crosses.id += "_without_answer";
    crosses.width = 0.0;
    crosses.mark = Mark::Cross;
    for (const auto& [task, run] : points_of(found, look.arm, Datum::Rest)) {
      if (!(run.cpu_seconds > 0.0)) continue;
      include(task.nodes);
      (run.solved() ? curve : crosses)
          .points.push_back({static_cast<double>(task.nodes), run.cpu_seconds});
    }
    any_crosses = any_crosses || !crosses.points.empty();
    // In grey a cross alone does not tell whose it is.
    if (!curve.points.empty() && !crosses.points.empty()) {
      chart.curves.push_back(
          {.name = {},
           .points = {curve.points.back(), crosses.points.front()},
           .stroke = Stroke::Dotted,
           .colour = look.colour,
           .width = kThin,
           .id = curve.id + "_to_no_answer"});
    }
    for (Curve* one : {&curve, &crosses}) {
      if (!one->points.empty()) chart.curves.push_back(std::move(*one));
    }
  }
  for (const ProgramSolver method :
       {ProgramSolver::Ipopt, ProgramSolver::NewtonKkt}) {
    const bool ipopt = method == ProgramSolver::Ipopt;
    Curve ours{.name = fmt::format("rolling time p = 5, {}",
                                   ipopt ? "Ipopt" : "Newton"),
               .points = {},
               .stroke = ipopt ? Stroke::Solid : Stroke::Dotted,
               .colour = kOurs,
               .mark = ipopt ? Mark::Disc : Mark::Circle,
               .id = ipopt ? "rolling_time_ipopt" : "rolling_time_newton"};
    for (const RollingRun& run : found.growth) {
      if (run.way.method != method || !run.solved) continue;
      include(run.nodes);
      ours.points.push_back({static_cast<double>(run.nodes), run.cpu_seconds});
    }
    if (!ours.points.empty()) chart.curves.push_back(std::move(ours));
  }
  if (any_crosses) add_cap(chart, found, low, high);
  return chart;
}

/// The cheapest rolling_time for every error.
Curve frontier(const FsolveFindings& found, Work work) {
  const bool whole = work == Work::Whole;
  Curve ours{
      .name = whole ? "rolling time, whole solve" : "rolling time, on the mesh",
      .points = {},
      .stroke = whole ? Stroke::Dotted : Stroke::Solid,
      .colour = kOurs,
      .mark = whole ? Mark::Circle : Mark::Disc,
      .id = whole ? "rolling_time_whole" : "rolling_time_on_mesh"};
  constexpr int kPerDecade = 2;
  constexpr int kDecades = 13;
  for (int i = kPerDecade; i <= kPerDecade * kDecades; ++i) {
    const double wanted = std::pow(10.0, -static_cast<double>(i) / kPerDecade);
    const auto run = cheapest(found.menu, work, wanted);
    if (!run) break;
    const double error = std::max(run->error, found.exact_error);
    if (!ours.points.empty() && error >= ours.points.back().x) continue;
    ours.points.push_back({error, run->cpu_seconds});
  }
  return ours;
}

/// Processor time over error; datum rest.
Chart speed(const FsolveFindings& found, const std::string& name) {
  Chart chart = logarithmic(name, "Processor time against error",
                            "relative error of τ", "processor time [s]");
  for (const Look& look : kLooks) {
    Curve curve = curve_of(look);
    for (const auto& [task, run] : points_of(found, look.arm, Datum::Rest)) {
      if (run.solved()) curve.points.push_back({run.error, run.cpu_seconds});
    }
    if (!curve.points.empty()) chart.curves.push_back(std::move(curve));
  }
  for (const Work work : {Work::Whole, Work::OnMesh}) {
    chart.curves.push_back(frontier(found, work));
  }
  return chart;
}

/// Error over n, both data: what the differences leave.
Chart floor(const FsolveFindings& found, const std::string& name) {
  Chart chart = logarithmic(name, "Error against the number of nodes", "nodes",
                            "relative error of τ");
  // Points that coincide are seen one within the other: the open ones first,
  // and larger.
  const auto add = [&](Arm arm, Datum datum, const char* words,
                       const char* colour, Mark mark, double size) {
    const bool exact = arm == Arm::Lifted;
    Curve curve{.name = fmt::format("{}, {}", benchmarks::name(datum), words),
                .points = {},
                .stroke = exact ? Stroke::Dashed : Stroke::Solid,
                .colour = colour,
                .mark = mark,
                .mark_size = size,
                .id = fmt::format("{}_{}", benchmarks::name(datum),
                                  benchmarks::name(arm))};
    for (const auto& [task, run] : points_of(found, arm, datum)) {
      if (run.solved()) {
        curve.points.push_back({static_cast<double>(task.nodes), run.error});
      }
    }
    if (!curve.points.empty()) chart.curves.push_back(std::move(curve));
  };
  add(Arm::Lifted, Datum::Rest, "exact gradient", "#d95f02", Mark::Circle, 1.2);
  add(Arm::Simplified, Datum::Rest, "ε = 1e-3, simplified Newton", "#7b3294",
      Mark::Cross, 1.0);
  add(Arm::Hybrid, Datum::Rest, "ε = 1e-3", "#d95f02", Mark::Triangle, 0.6);
  add(Arm::Lifted, Datum::Release, "exact gradient", "#08519c", Mark::Diamond,
      1.25);
  add(Arm::Hybrid, Datum::Release, "ε = 1e-3", "#08519c", Mark::Square, 0.6);
  return chart;
}

void write(const Chart& chart, const std::string& name) {
  write_figure(report::chart_figure(chart), name);
}

}  // namespace

void write_charts(const FsolveFindings& found, const std::string& name) {
  write(growth(found, name + "_growth"), name + "_growth");
  write(speed(found, name + "_error"), name + "_error");
  write(floor(found, name + "_nodes"), name + "_nodes");
}

}  // namespace brachisto::benchmarks
