// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "fsolve/others.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>

#include "process/child_process.hpp"

namespace brachisto::benchmarks {

namespace {

using Json = nlohmann::json;

constexpr double kSoon = 30.0;  // for a program to tell its version [s]

/// What a program prints, without the line's end; nothing if it fails.
std::optional<std::string> answer_of(
    const std::filesystem::path& program,
    const std::vector<std::string>& arguments) {
  const ChildRun run = run_child(program, arguments, kSoon, nullptr);
  if (run.end != ChildRun::End::Exited || run.code != 0) return std::nullopt;
  return run.out.substr(0, run.out.find('\n'));
}

std::string script(const char* name) {
  return std::string(BRACHISTO_SOURCE_DIR "/benchmarks/compare/") + name;
}

std::vector<std::string> options_of(const Scene& scene,
                                    const DiscreteTask& task, double cap) {
  const auto text = [](double value) { return fmt::format("{}", value); };
  return {"--n",       fmt::format("{}", task.nodes),
          "--datum",   name(task.datum),
          "--epsilon", text(task.epsilon),
          "--seconds", text(cap),
          "--L",       text(scene.L),
          "--H",       text(scene.H),
          "--r",       text(scene.body.radius),
          "--eta",     text(scene.body.eta_m),
          "--theta",   text(scene.body.theta_m),
          "--k",       text(scene.body.k)};
}

DiscreteRun read(const ChildRun& child, double cap) {
  DiscreteRun run;
  run.repetitions = 1;
  // It stops itself at the cap; here it is long past it, or was not run at all.
  if (child.end == ChildRun::End::OutOfTime) {
    run.outcome = DiscreteRun::Outcome::Capped;
    run.cpu_seconds = cap;
    return run;
  }
  try {
    const Json json = Json::parse(child.out);
    run.cpu_seconds = json.at("seconds_cpu").get<double>();
    run.evaluations = json.at("calls").get<int>();
    if (json.at("solved").get<bool>()) {
      run.outcome = DiscreteRun::Outcome::Solved;
      run.tau = json.at("tau").get<double>();
    } else if (run.cpu_seconds >= cap) {
      run.outcome = DiscreteRun::Outcome::Capped;
      run.cpu_seconds = cap;
    } else {
      run.cause = FixedText<200>(json.at("message").get<std::string>());
    }
  } catch (const Json::exception&) {
    run.cause = FixedText<200>("no result: " +
                               child.err.substr(0, child.err.find('\n')));
  }
  return run;
}

}  // namespace

std::optional<OtherProgram> find_octave() {
  for (const auto& program : programs_on_path("octave-cli")) {
    const auto version = answer_of(
        program, {"--no-init-file", "-q", "--eval", "disp (version ())"});
    if (version) {
      return OtherProgram{Arm::Octave,
                          program,
                          {"--no-init-file", "-q", script("paper_fsolve.m")},
                          "GNU Octave " + *version};
    }
  }
  return std::nullopt;
}

std::optional<OtherProgram> find_scipy() {
  for (const auto& program : programs_on_path("python3")) {
    const auto version =
        answer_of(program, {"-c",
                            "import numpy, platform, scipy; print('SciPy',"
                            "scipy.__version__ + ', NumPy', numpy.__version__ +"
                            "', Python', platform.python_version())"});
    if (version) {
      return OtherProgram{
          Arm::SciPy, program, {script("paper_fsolve.py")}, *version};
    }
  }
  return std::nullopt;
}

DiscreteRun run_there(const OtherProgram& other, const Scene& scene,
                      const DiscreteTask& task, double cap) {
  constexpr int kRepetitions = 3;
  constexpr double kSlow = 2.0;  // [s]
  // A machine busy with other work gives it its share late.
  constexpr double kWall = 5.0;
  std::vector<std::string> arguments = other.arguments;
  for (std::string& one : options_of(scene, task, cap)) {
    arguments.push_back(std::move(one));
  }
  const auto once = [&] {
    return read(
        run_child(other.program, arguments, kSoon + kWall * cap, nullptr), cap);
  };
  DiscreteRun best = once();
  if (!best.solved() || best.cpu_seconds >= kSlow) return best;
  for (int i = 1; i < kRepetitions; ++i) {
    const DiscreteRun again = once();
    if (!again.solved()) continue;
    best.cpu_seconds = std::min(best.cpu_seconds, again.cpu_seconds);
    ++best.repetitions;
  }
  return best;
}

}  // namespace brachisto::benchmarks
