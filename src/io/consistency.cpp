// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/consistency.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/key_spec.hpp"
#include "io/unused_keys.hpp"

namespace brachisto::io {

namespace {

// Relative errors of the paper's cases are 0.07/N² to 0.9/N².
constexpr double kPiecesTimesRootOfError = 0.6;

void check_bead(const YamlValue& root, Findings& findings) {
  std::vector<std::string_view> allowed = keys_of("scene.body");
  std::erase_if(allowed, [](std::string_view name) {
    return find_key(fmt::format("scene.body.{}", name))->of_cylinder();
  });
  for (const KeySpec& spec : key_table()) {
    const Entry* entry =
        spec.of_cylinder() ? find_entry(root, spec.path) : nullptr;
    if (entry == nullptr) continue;
    findings.add(entry->position, std::string(spec.path),
                 fmt::format("a bead has no {}; allowed of a bead: {}",
                             spec.name(), fmt::join(allowed, ", ")));
  }
}

void check_cylinder(const YamlValue& root, Findings& findings) {
  const Entry* body = find_entry(root, "scene.body");
  for (const KeySpec& spec : key_table()) {
    if (spec.presence != Presence::RequiredOfCylinder) continue;
    if (find_entry(root, spec.path) != nullptr) continue;
    findings.add(body->position, std::string(spec.path),
                 fmt::format("missing; expected {} ({})", expected(spec),
                             spec.description));
  }
}

}  // namespace

void check_body(const YamlValue& root, const ProblemFile& problem,
                Findings& findings) {
  const bool shape_known = find_entry(root, "scene.body.shape") != nullptr &&
                           !findings.concern("scene.body.shape");
  if (!shape_known) return;
  if (problem.scene.body.shape == Shape::Bead) {
    check_bead(root, findings);
  } else {
    check_cylinder(root, findings);
  }
}

void check_solver(const YamlValue& root, const ProblemFile& problem,
                  Findings& findings) {
  const Entry* search = find_entry(root, "solver.search");
  if (search != nullptr && !findings.concern("solver.search") &&
      !findings.concern("scene.contact") &&
      problem.options.search == Search::Global &&
      problem.scene.contact == Contact::Centre) {
    findings.add(search->value.position, "solver.search",
                 "global is not allowed with contact: centre; between fixed "
                 "ends of the centre's path there is no contact to search for");
  }
  check_unused_keys(root, problem, findings);
}

namespace {

void check_arc_length(const YamlValue& root, const ProblemFile& problem,
                      Findings& findings) {
  const Discretisation& mesh = problem.options.discretisation;
  const auto too_few = [&](std::string_view key, int count, int fewest) {
    const Entry* entry = find_entry(root, key);
    if (entry == nullptr || findings.concern(key) || count >= fewest) return;
    findings.add(entry->value.position, std::string(key),
                 fmt::format("{} is not allowed with formulation: arc_length, "
                             "which needs {} or more",
                             count, fewest));
  };
  too_few("discretisation.elements", mesh.elements.value_or(kFewestPieces),
          kFewestPieces);
  too_few("discretisation.nodes", mesh.nodes.value_or(kFewestPieces + 1),
          kFewestPieces + 1);
  const std::string key = "discretisation.tolerance";
  const Entry* tolerance = find_entry(root, key);
  if (tolerance == nullptr || findings.concern(key) ||
      mesh.wanted_tolerance() >= kSmallestArcLengthTolerance) {
    return;
  }
  findings.add(
      tolerance->value.position, key,
      fmt::format("{:g} is not allowed with formulation: arc_length, whose "
                  "error falls as the square of the number of pieces: it would "
                  "take some {:.0e} of them. Allowed is {:g} or more; or take "
                  "formulation: rolling_time",
                  mesh.wanted_tolerance(),
                  kPiecesTimesRootOfError / std::sqrt(mesh.wanted_tolerance()),
                  kSmallestArcLengthTolerance));
}

}  // namespace

void check_mesh(const YamlValue& root, const ProblemFile& problem,
                Findings& findings) {
  const bool arc_length =
      problem.options.discretisation.formulation == Formulation::ArcLength;
  if (arc_length) check_arc_length(root, problem, findings);
  const std::string key = "discretisation.nodes";
  const Entry* elements = find_entry(root, "discretisation.elements");
  const Entry* nodes = find_entry(root, key);
  if (nodes == nullptr) return;
  if (elements != nullptr) {
    // The later of the two is the one too many.
    const bool nodes_later = elements->position < nodes->position;
    const Entry& extra = nodes_later ? *nodes : *elements;
    findings.add(extra.position, "discretisation." + extra.key,
                 fmt::format("{} is given too; elements and nodes both fix "
                             "the mesh, allowed is one of them",
                             nodes_later ? "elements" : "nodes"));
    return;
  }
  if (arc_length || findings.concern(key) ||
      findings.concern("discretisation.degree")) {
    return;
  }
  const Discretisation& mesh = problem.options.discretisation;
  if (problem.options.method == Method::Fsolve) {
    if (mesh.nodes.value() >= kFewestDiscreteNodes) return;
    findings.add(nodes->value.position, key,
                 fmt::format("{} is not allowed; method: fsolve needs {} or "
                             "more",
                             mesh.nodes.value(), kFewestDiscreteNodes));
    return;
  }
  const int p = mesh.degree_of_fixed();
  const int count = mesh.nodes.value();
  if ((count - 1) % p == 0) return;
  const int below = (count - 1) / p * p + 1;
  findings.add(nodes->value.position, key,
               fmt::format("{} is not allowed; nodes − 1 is a multiple of the "
                           "degree {}; nearest: {}",
                           count, p,
                           below > 1 ? fmt::format("{} or {}", below, below + p)
                                     : fmt::format("{}", below + p)));
}

void check_scene(const YamlValue& root, const ProblemFile& problem,
                 Findings& findings) {
  // NaN stands for every number that should be there and could not be read, so
  // that no bound is checked against a value nobody gave.
  ProblemFile marked = problem;
  std::vector<std::string_view> unread;
  for (const KeySpec& spec : key_table()) {
    const bool of_scene = spec.path.starts_with("scene.");
    const bool needed = spec.presence == Presence::Required ||
                        spec.presence == Presence::RequiredOfCylinder;
    const bool absent = find_entry(root, spec.path) == nullptr;
    if (of_scene && (findings.concern(spec.path) || (needed && absent))) {
      if (spec.set != nullptr) {
        spec.set(marked, std::numeric_limits<double>::quiet_NaN());
      }
      unread.push_back(spec.path);
    }
  }
  for (SceneError& error : validate(marked.scene)) {
    if (std::ranges::count(unread, error.key) > 0) continue;
    const Position position = position_of(root, error.key);
    findings.add(position, std::move(error.key), std::move(error.message));
  }
}

}  // namespace brachisto::io
