// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/unused_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace brachisto::io {

namespace {

/// A key and where it means nothing.
struct UnusedKey {
  std::string_view path;
  bool (*differs)(const SolveOptions&);  ///< from what holds if it is absent
  std::string_view by_shooting = {};     ///< why; empty: it has a use
  std::string_view by_fsolve = {};
  std::string_view by_arc_length = {};
  std::string_view by_newton = {};
};

constexpr std::string_view kOwnMesh = "which has no elements";
constexpr std::string_view kNoProgram = "which solves no nonlinear program";
constexpr std::string_view kOwnNodes = "whose mesh is its nodes";
constexpr std::string_view kOneBranch = "which follows one branch";
constexpr std::string_view kOneStart = "which starts from the cycloid";

constexpr std::array kUnused{
    UnusedKey{"discretisation.formulation",
              [](const SolveOptions& o) {
                return o.discretisation.formulation !=
                       Discretisation{}.formulation;
              },
              kOwnMesh, "which is a formulation of its own"},
    UnusedKey{"discretisation.tolerance",
              [](const SolveOptions& o) {
                return o.discretisation.tolerance.has_value();
              },
              {},
              "whose error is what its nodes leave"},
    UnusedKey{"discretisation.degree",
              [](const SolveOptions& o) {
                return o.discretisation.degree.has_value();
              },
              kOwnMesh, kOwnNodes, "whose pieces are straight"},
    UnusedKey{"discretisation.elements",
              [](const SolveOptions& o) {
                return o.discretisation.elements.has_value();
              },
              kOwnMesh, kOwnNodes},
    UnusedKey{"discretisation.nodes",
              [](const SolveOptions& o) {
                return o.discretisation.nodes.has_value();
              },
              kOwnMesh},
    UnusedKey{"solver.linear_solver",
              [](const SolveOptions& o) {
                return o.linear_solver != SolveOptions{}.linear_solver;
              },
              kNoProgram, kNoProgram},
    UnusedKey{"solver.tolerance",
              [](const SolveOptions& o) {
                return o.tolerance != SolveOptions{}.tolerance;
              },
              kNoProgram, kNoProgram},
    UnusedKey{"solver.search",
              [](const SolveOptions& o) { return o.search == Search::Global; },
              kOneBranch, kOneStart, kOneBranch},
    UnusedKey{"solver.polish", [](const SolveOptions& o) { return !o.polish; },
              kNoProgram, kNoProgram},
    UnusedKey{
        "solver.certify",
        [](const SolveOptions& o) { return o.certify == Certify::Extremal; },
        "whose second opinion on itself would be its first",
        "which is compared with the extremal anyway"},
    UnusedKey{"solver.guess",
              [](const SolveOptions& o) { return o.guess != Guess::Cycloid; },
              kOneStart, kOneStart, kOneStart,
              "which starts from the continuation"},
    UnusedKey{"solver.limits.iterations",
              [](const SolveOptions& o) {
                return o.limits.iterations != Limits{}.iterations;
              },
              kNoProgram}};

/// A key of method: fsolve alone.
struct FsolveKey {
  std::string_view path;
  bool (*differs)(const FsolveOptions&);
};

constexpr std::array kOfFsolve{
    FsolveKey{"solver.fsolve.quadrature",
              [](const FsolveOptions& o) {
                return o.reading.quadrature != DiscreteReading{}.quadrature;
              }},
    FsolveKey{"solver.fsolve.datum",
              [](const FsolveOptions& o) {
                return o.reading.datum != DiscreteReading{}.datum;
              }},
    FsolveKey{"solver.fsolve.slopes",
              [](const FsolveOptions& o) {
                return o.reading.slopes != DiscreteReading{}.slopes;
              }},
    FsolveKey{"solver.fsolve.epsilon",
              [](const FsolveOptions& o) {
                return o.reading.epsilon != DiscreteReading{}.epsilon;
              }},
    FsolveKey{"solver.fsolve.variant", [](const FsolveOptions& o) {
                return o.variant != FsolveOptions{}.variant;
              }}};

std::string_view why_unused(const UnusedKey& key, Method method) {
  switch (method) {
    case Method::Ipopt:
      return {};
    case Method::NewtonKkt:
      return key.by_newton;
    case Method::Extremal:
      return key.by_shooting;
    case Method::Fsolve:
      return key.by_fsolve;
  }
  return {};
}

std::string_view name_of(Method method) {
  switch (method) {
    case Method::Ipopt:
      return "ipopt";
    case Method::NewtonKkt:
      return "newton_kkt";
    case Method::Extremal:
      return "extremal";
    case Method::Fsolve:
      return "fsolve";
  }
  return {};
}

/// Adds a finding about the value of a key, if the file has it and it could be
/// read.
void refuse(const YamlValue& root, std::string_view path, std::string message,
            Findings& findings) {
  const Entry* entry = find_entry(root, path);
  if (entry == nullptr || findings.concern(path)) return;
  findings.add(entry->value.position, std::string(path), std::move(message));
}

}  // namespace

void check_unused_keys(const YamlValue& root, const ProblemFile& problem,
                       Findings& findings) {
  const SolveOptions& options = problem.options;
  if (findings.concern("solver.method")) return;
  const bool fsolve = options.method == Method::Fsolve;
  for (const UnusedKey& key : kUnused) {
    const std::string_view because = why_unused(key, options.method);
    if (because.empty() || !key.differs(options)) continue;
    refuse(root, key.path,
           fmt::format("has no effect with method: {}, {}; leave it out, or "
                       "take method: ipopt",
                       name_of(options.method), because),
           findings);
  }
  const bool arc_length =
      (options.method == Method::Ipopt ||
       options.method == Method::NewtonKkt) &&
      options.discretisation.formulation == Formulation::ArcLength;
  for (const UnusedKey& key : kUnused) {
    if (!arc_length || key.by_arc_length.empty() || !key.differs(options)) {
      continue;
    }
    refuse(root, key.path,
           fmt::format("not allowed with formulation: arc_length, {}; leave it "
                       "out, or take formulation: rolling_time",
                       key.by_arc_length),
           findings);
  }
  for (const FsolveKey& key : kOfFsolve) {
    if (fsolve || !key.differs(options.fsolve)) continue;
    refuse(root, key.path,
           "has no effect without method: fsolve; leave it out, or take that "
           "method",
           findings);
  }
  constexpr std::string_view kEpsilon = "solver.fsolve.epsilon";
  if (fsolve && options.fsolve.variant != FsolveVariant::Hybrid &&
      options.fsolve.reading.epsilon != DiscreteReading{}.epsilon) {
    refuse(root, kEpsilon,
           "has no effect with exact derivatives; leave it out, or take "
           "variant: hybrid",
           findings);
  }
}

}  // namespace brachisto::io
