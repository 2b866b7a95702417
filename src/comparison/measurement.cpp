// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "comparison/measurement.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <nlohmann/json.hpp>

#include "brachisto/report/result.hpp"
#include "io/input_tree.hpp"
#include "math/enum_table.hpp"
#include "plot/result_values.hpp"
#include "process/child_process.hpp"

namespace brachisto::comparison {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kBadInput = 3;  // exit code of a problem that is refused

template <class Value>
std::optional<Value> value_at(const Json& json, const char* key) {
  const Json& value = plot::at(json, key);
  return value.is_null() ? std::nullopt : std::optional(value.get<Value>());
}

Measurement from_document(const Json& json) {
  const Json& result = json.at("result");
  Measurement out;
  out.cpu = json.at("cpu").get<std::vector<double>>();
  out.start = json.value("start", std::vector<double>());
  out.unknowns = value_at<int>(json, "unknowns");
  out.iterations = value_at<int>(result, "iterations");
  out.newton_steps = value_at<int>(result, "newton_steps");
  const Json& discrete = result.at("discrete_system");
  if (!discrete.is_null()) {
    out.evaluations = value_at<int>(discrete, "evaluations");
    out.newton_steps.reset();  // those of the extremal beside it
  }
  if (const auto tau = value_at<double>(json, "tau"); tau && !out.cpu.empty()) {
    out.outcome = Measurement::Outcome::Solved;
    out.tau = *tau;
    out.verified = result.at("verified").get<bool>();
    out.estimated_error = value_at<double>(result, "estimated_error");
    out.energy_drift =
        value_at<double>(plot::at(result, "certificate"), "energy_drift");
    for (const Json& at : json.value("path", Json::array())) {
      out.path.push_back({at.at(0).get<double>(), at.at(1).get<double>()});
    }
    if (!out.verified) {
      out.cause = fmt::format(
          "{}", fmt::join(plot::words(result, "not_verified_because"), "; "));
    }
    return out;
  }
  const auto status = result.at("status").get<std::string>();
  const bool limit = status == "time_limit";
  out.outcome =
      limit ? Measurement::Outcome::Limit : Measurement::Outcome::Failed;
  out.cause = result.at("message").get<std::string>();
  if (out.cause.empty()) out.cause = status;
  return out;
}

std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

}  // namespace

const char* name(Measurement::Outcome outcome) {
  constexpr auto kNames = table_by<Measurement::Outcome>(
      "solved", "failed", "limit", "crashed", "refused");
  return kNames[outcome];
}

std::vector<double> Measurement::on_mesh() const {
  if (start.size() != cpu.size()) return {};
  std::vector<double> times(cpu.size());
  std::ranges::transform(cpu, start, times.begin(), std::minus<>{});
  return times;
}

std::string refusal_in(const std::string& document,
                       const std::string& otherwise) {
  std::vector<std::string> reasons;
  const Json json = Json::parse(document, nullptr, false);
  for (const Json& error : plot::at(json, "errors")) {
    reasons.push_back(plot::text_of(error, "message"));
  }
  return reasons.empty() ? first_line(otherwise)
                         : fmt::format("{}", fmt::join(reasons, "; "));
}

Measurement parse_measurement(const std::string& line) {
  try {
    return from_document(Json::parse(line));
  } catch (const Json::exception&) {
    Measurement out;
    out.cause = "its output is not a complete result";
    return out;
  }
}

void check_named(const std::string& file) {
  if (file != io::kStandardInput) return;
  throw io::IoError(
      "-: a process for each solve reads the problem anew; expected the name "
      "of a file");
}

Measurement measure(const Experiment& experiment,
                    const std::atomic<int>* interrupt) {
  std::vector<std::string> arguments{"measure", experiment.file, "--json"};
  for (const std::string& change : experiment.overrides) {
    arguments.insert(arguments.end(), {"--set", change});
  }
  const auto options =
      nlohmann::ordered_json::parse(report::input_json({}, experiment.options));
  for (const char* section : {"discretisation", "solver"}) {
    arguments.insert(
        arguments.end(),
        {"--set", fmt::format("{}={}", section, options.at(section).dump())});
  }
  const auto system = experiment.options.or_default<DiscreteSystem>();
  arguments.insert(arguments.end(),
                   {"--repetitions", fmt::format("{}", experiment.repetitions),
                    "--seconds", fmt::format("{}", experiment.seconds),
                    "--residual", fmt::format("{}", system.tolerance)});
  const ChildRun run =
      run_child("/proc/self/exe", arguments, experiment.seconds, interrupt);
  Measurement out;
  switch (run.end) {
    case ChildRun::End::Interrupted:
      throw Interrupted{};
    case ChildRun::End::OutOfTime:
      out.outcome = Measurement::Outcome::Limit;
      out.cause = fmt::format("killed after {:g} s", experiment.seconds);
      break;
    case ChildRun::End::Signalled:
      out.cause = fmt::format("ended by signal {} ({})", run.code,
                              ::strsignal(run.code));
      break;
    case ChildRun::End::Exited:
      if (run.code == 0) {
        out = parse_measurement(run.out);
      } else if (run.code == kBadInput) {
        out.outcome = Measurement::Outcome::Refused;
        out.cause = refusal_in(run.out, run.err);
      } else {
        out.cause = run.err.empty()
                        ? fmt::format("ended with exit code {}", run.code)
                        : first_line(run.err);
      }
  }
  out.peak_memory = run.peak_memory;
  out.seconds = run.seconds;
  return out;
}

namespace {

constexpr int kParts = 64;

/// Where the arc length is `wanted`: halving tells doubles apart.
Point place_at(const Motion& motion, double wanted) {
  double low = 0.0, high = 1.0;
  for (;;) {
    const double middle = 0.5 * (low + high);
    const TrajectoryPoint at = motion.at(middle);
    if (middle <= low || middle >= high) return at.centre;
    (at.s < wanted ? low : high) = middle;
  }
}

}  // namespace

std::vector<Point> places_along(const Solution& solution) {
  std::vector<Point> places;
  if (solution.status != Status::Solved) return places;
  const DiscreteAnswer* discrete = solution.discrete();
  for (int i = 0; i <= kParts; ++i) {
    const double share = static_cast<double>(i) / kParts;
    if (discrete != nullptr) {
      const std::vector<Point>& nodes = discrete->centre;
      const double at = share * static_cast<double>(nodes.size() - 1);
      const std::size_t below =
          std::min(static_cast<std::size_t>(at), nodes.size() - 2);
      const double part = at - static_cast<double>(below);
      places.push_back({std::lerp(nodes[below].x, nodes[below + 1].x, part),
                        std::lerp(nodes[below].z, nodes[below + 1].z, part)});
    } else if (const Motion* motion = solution.motion()) {
      places.push_back(place_at(*motion, share * motion->centre_path_length()));
    }
  }
  return places;
}

std::optional<double> path_error(const std::vector<Point>& places,
                                 const std::vector<Point>& reference,
                                 double length) {
  if (places.empty() || places.size() != reference.size()) return std::nullopt;
  double largest = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    largest = std::max(largest, std::hypot(places[i].x - reference[i].x,
                                           places[i].z - reference[i].z));
  }
  return largest / length;
}

}  // namespace brachisto::comparison
