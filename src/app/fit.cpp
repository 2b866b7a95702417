// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto fit FILE TIMES: numbers of a scene from measured times.

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/exit_code.hpp"
#include "app/signals.hpp"
#include "app/solution_output.hpp"
#include "app/terminal.hpp"
#include "app/verbs.hpp"
#include "brachisto/io/problem_file.hpp"
#include "brachisto/math/clock.hpp"
#include "brachisto/report/result.hpp"
#include "fit/fit_report.hpp"
#include "io/input_tree.hpp"
#include "io/visible_text.hpp"
#include "io/yaml_writer.hpp"
#include "model/centre_curve.hpp"
#include "trajectory/held_path.hpp"

namespace brachisto::app {

namespace {

struct FitFlags : CommonFlags {
  std::string times;
  std::vector<std::string> parameters;
  bool offset = false;
  std::string out;
  bool force = false;
};

constexpr const char* kFitDocument = "fit.json";
constexpr const char* kFittedProblem = "fit.yaml";
const std::vector<std::string> kFiles{"residuals.svg", "residuals.csv",
                                      "residuals.gp", kFittedProblem,
                                      kFitDocument};

std::vector<std::string> parameter_keys() {
  std::vector<std::string> keys;
  for (const fit::Parameter& parameter : fit::kParameters) {
    keys.emplace_back(parameter.key);
  }
  return keys;
}

/// That a key of --parameter is one that can be fitted, or the nearest.
TextCheck parameter_check() {
  TextCheck check;
  check.words = parameter_keys();
  check.objection = [](const std::string& word) {
    const std::vector<std::string> keys = parameter_keys();
    const std::vector<std::string_view> known(keys.begin(), keys.end());
    return fit::find_parameter(word) != nullptr
               ? std::string()
               : io::unknown_word(word, "a key that can be fitted", known);
  };
  return check;
}

/// Why the file cannot have another k, as where it follows from parts; "" if it
/// can.
std::string objection_to_inertia(const FitFlags& flags, std::string_view stated,
                                 double k) {
  std::vector<std::string> overrides = flags.overrides;
  overrides.push_back(fmt::format("scene.body.k={}", k));
  try {
    (void)io::read_problem_text(stated, flags.file, overrides);
  } catch (const io::InputError& error) {
    return "scene.body.k: " + error.diagnostics().front().message;
  }
  return "";
}

/// \throws UsageError  for a parameter that is given twice or that the scene
///                     does not have
fit::Wanted wanted(const FitFlags& flags, std::string_view stated,
                   const Scene& scene, const fit::Measurements& times) {
  fit::Wanted out{{}, flags.offset, times.has_sigma()};
  for (const std::string& key : flags.parameters) {
    const fit::Parameter* parameter = fit::find_parameter(key);
    std::string why = fit::objection(*parameter, scene);
    if (std::ranges::find(out.parameters, parameter) != out.parameters.end()) {
      why = fmt::format("{} is given twice", key);
    }
    if (why.empty() && parameter->number == MotionNumber::Inertia) {
      why = objection_to_inertia(flags, stated, scene.body.k);
    }
    if (!why.empty()) throw UsageError("brachisto fit", "--parameter: " + why);
    out.parameters.push_back(parameter);
  }
  return out;
}

/// The problem with the fitted values, and why it is none yet, if so.
struct FittedProblem {
  std::string text;
  std::string objection;
};

FittedProblem fitted_problem(const FitFlags& flags, std::string_view stated,
                             const fit::Fit& found,
                             const fit::Subject& subject) {
  std::vector<std::string> overrides = flags.overrides;
  std::ranges::copy(fit::overrides_of(found), std::back_inserter(overrides));
  FittedProblem out;
  out.text = fit::comment(found, subject) +
             io::problem_yaml(stated, flags.file, overrides, flags.out);
  try {
    (void)io::read_problem_text(stated, flags.file, overrides);
  } catch (const io::InputError& error) {
    out.objection =
        fmt::format("{} asks for more before it can be solved: {}",
                    kFittedProblem, error.diagnostics().front().message);
  }
  return out;
}

int run(const FitFlags& flags) {
  if (!flags.out.empty())
    report::check_writable(flags.out, kFiles, flags.force);
  const std::string stated = io::read_problem_bytes(flags.file);
  const io::ProblemFile problem =
      io::read_problem_text(stated, flags.file, flags.overrides);
  const fit::Measurements measured = fit::read_measurements(flags.times);
  warn_of(problem);
  const fit::Wanted asked = wanted(flags, stated, problem.scene, measured);
  const std::atomic<int>& signal = catch_signals();

  // The answer to the scene as it stands is the track: what is fitted does not
  // move it.
  const Solution solution =
      solve_in_time(problem, flags.json, {.interrupt = &signal});
  if (!solution.verified() || solution.motion() == nullptr) {
    tell_error(fmt::format("brachisto: {}: there is no track to fit on: {}{}\n",
                           flags.file, complaint(solution),
                           problem.scene.path
                               ? " (the fit starts from the parameters in the "
                                 "file)"
                               : ""));
    return std::max<int>(exit_code(solution, signal.load()), kNotSolved);
  }
  const Scene scene = without_whole_turns(problem.scene);
  const PlaneCurvePtr centre = centre_curve(on_its_path(*solution.motion()));
  const StopScope scope{StopCondition(&signal)};
  const fit::Fit found = fit::fit_times(
      scene, centre, fit::places_of(measured, PrescribedMotion(scene, centre)),
      asked);

  const fit::Subject subject{flags.file, flags.times};
  for (const std::string& doubt : fit::doubts(found)) warn(doubt);
  const std::string document = fit::to_json(found, subject);
  if (!flags.out.empty()) {
    FittedProblem fitted = fitted_problem(flags, stated, found, subject);
    warn(fitted.objection);
    report::DrawnFiles drawn =
        report::draw(fit::residual_figure(found), report::Format::Svg, &signal);
    warn(drawn.missing);
    std::vector<report::OutputFile> files = std::move(drawn.files);
    files.push_back({kFittedProblem, std::move(fitted.text)});
    files.push_back({kFitDocument, document});
    report::write_files(flags.out, files, flags.force, kFiles);
  }
  if (flags.json) {
    print_data(document);
  } else if (!flags.quiet) {
    print(fit::summary(found));
    if (!flags.out.empty()) {
      print_paths(flags.out, {{kFittedProblem, ""}, {kFiles.front(), ""}});
    }
  }
  return kSuccess;
}

}  // namespace

Verb fit_verb() {
  const auto flags = std::make_shared<FitFlags>();
  std::vector<Flag> all = flags->with(
      {{.name = "--parameter",
        .value = &flags->parameters,
        .text = "What to fit, again and again: scene.losses.rolling, "
                "scene.losses.sliding or scene.body.k",
        .placeholder = "KEY",
        .check = parameter_check(),
        .required = true},
       {"--offset", &flags->offset,
        "Fit the time at which the clock starts too"},
       directory_flag("--out", flags->out,
                      "Write fit.json, fit.yaml, which is the file with the "
                      "fitted values, and residuals.svg there"),
       {"--force", &flags->force, "Replace existing files in DIR"}});
  all.insert(all.begin() + 1,
             {.name = "TIMES",
              .value = &flags->times,
              .text = "Measured times: CSV with the columns s or x of the "
                      "centre [m], t [s] and, if known, sigma [s]",
              .placeholder = "FILE",
              .check = not_empty(),
              .required = true});
  return {
      .name = "fit",
      .text = "Losses and inertia from measured times, with their errors",
      .flags = std::move(all),
      .footer =
          R"(The track is the given path of the scene, or else its answer, held as the
file has it.
Example:
  brachisto fit ramp.yaml times.csv --parameter scene.losses.rolling
Exit codes: 0 fitted, 3 bad input file, 4 no track, or the times do
not tell what is asked, 6 I/O, 7 limit of time, 130/143 after
SIGINT/SIGTERM.)",
      .run = [flags] { return run(*flags); }};
}

}  // namespace brachisto::app
