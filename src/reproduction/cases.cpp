// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "reproduction/cases.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "process/child_process.hpp"

namespace brachisto::reproduction {

namespace {

/// Names of the problem files of a directory, in order.
std::vector<std::string> problem_names(const std::filesystem::path& directory) {
  std::error_code error;
  std::vector<std::string> names;
  for (const auto& entry :
       std::filesystem::directory_iterator(directory, error)) {
    if (entry.path().extension() == ".yaml") {
      names.push_back(entry.path().stem().string());
    }
  }
  if (error) {
    throw io::IoError(fmt::format("{}: cannot be read: {}", directory.string(),
                                  error.message()));
  }
  if (names.empty()) {
    throw io::IoError(
        fmt::format("{}: has no problem files", directory.string()));
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

Measured Case::tau() const {
  const double tau = motion().tau();
  return {tau, fine.estimated_error.value_or(0.0) * tau};
}

Measured Case::measure(
    const std::function<double(const Solution&)>& quantity) const {
  const double value = quantity(fine);
  return {value, std::abs(value - quantity(rough))};
}

io::IoError Cases::missing(const std::string& name) const {
  return io::IoError(fmt::format("{}: the problem file {}.yaml is missing",
                                 directory_.string(), name));
}

Cases::Cases(const std::filesystem::path& directory,
             const std::vector<std::string>& required,
             const Interrupt& interrupt, const Announce& announce)
    : directory_(directory) {
  constexpr double kFiner = 1e-2;
  const std::vector<std::string> names = problem_names(directory);
  for (const std::string& name : required) {
    if (!std::ranges::binary_search(names, name)) throw missing(name);
  }
  for (const std::string& name : names) {
    announce(name);
    Case one{name, io::read_problem_file(directory / (name + ".yaml")), {}, {}};
    SolveOptions options = one.file.options;
    const SolveHooks hooks{.interrupt = &interrupt};
    one.rough = solve(one.file.scene, options, hooks);
    if (one.file.scene.path) {
      one.fine = one.rough;
    } else {
      auto& program = options.use<Collocation>();
      program.certify = Certify::Extremal;
      program.discretisation.tolerance =
          kFiner * program.discretisation.wanted_tolerance();
      one.fine = solve(one.file.scene, options, hooks);
    }
    check(interrupt);
    if (!one.verified()) {
      throw NotVerified(
          fmt::format("{}: no verified answer: {}", name,
                      (one.rough.verified() ? one.fine : one.rough).message));
    }
    cases_.emplace(name, std::move(one));
  }
}

const Case& Cases::operator[](const std::string& name) const {
  const auto found = cases_.find(name);
  if (found == cases_.end()) {
    throw missing(name);
  }
  return found->second;
}

void check(const Interrupt& interrupt) {
  if (interrupt.load() != 0) throw Interrupted();
}

Solution verified_solution(const Scene& scene, const Interrupt& interrupt,
                           double tolerance) {
  SolveOptions options;
  options.use<Collocation>().discretisation.tolerance = tolerance;
  return verified_solution(scene, interrupt, options);
}

Solution verified_solution(const Scene& scene, const Interrupt& interrupt,
                           const SolveOptions& options) {
  Solution solution = solve(scene, options, {.interrupt = &interrupt});
  check(interrupt);
  if (!solution.verified()) {
    const std::vector<std::string> checks = solution.not_verified_because();
    throw NotVerified(fmt::format(
        "η_m = {:.6g}, θ_m = {:.6g} rad, k = {:.6g}: no verified answer: {}",
        scene.body.eta_m, scene.body.theta_m, scene.body.k,
        checks.empty() ? solution.message
                       : fmt::format("{}", fmt::join(checks, "; "))));
  }
  return solution;
}

double verified_tau(const Scene& scene, const Interrupt& interrupt) {
  return verified_solution(scene, interrupt).motion()->tau();
}

}  // namespace brachisto::reproduction
