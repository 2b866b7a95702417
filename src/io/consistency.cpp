// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/consistency.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "io/design_check.hpp"
#include "io/key_spec.hpp"

namespace brachisto::io {

namespace {

// Relative errors of the paper's cases are 0.07/N² to 0.9/N².
constexpr double kPiecesTimesRootOfError = 0.6;

/// The entry of a key, unless there is none or a mistake in it.
const Entry* sound_entry(const YamlValue& root, std::string_view key,
                         const Findings& findings) {
  return findings.concern(key) ? nullptr : find_entry(root, key);
}

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
  const bool has_parts = find_entry(root, "scene.body.parts") != nullptr;
  for (const KeySpec& spec : key_table()) {
    if (spec.presence != Presence::RequiredOfCylinder) continue;
    if (find_entry(root, spec.path) != nullptr) continue;
    if (has_parts && follows_from_parts(spec)) continue;
    findings.add(body->position, std::string(spec.path),
                 fmt::format("missing; expected {} ({})", expected(spec),
                             spec.description));
  }
}

void check_body(const YamlValue& root, const Draft& problem,
                Findings& findings) {
  if (!sound_entry(root, "scene.body.shape", findings)) return;
  if (problem.scene.body.shape == Shape::Bead) {
    check_bead(root, findings);
  } else {
    check_cylinder(root, findings);
  }
}

/// "method: fsolve".
std::string stated(const KeyWord& choice) {
  return fmt::format("{}: {}", choice.key->name(), choice.word);
}

/// Refuses keys that have a value of their own and that the problem has no use
/// for.
void check_use(const YamlValue& root, const Draft& draft, Findings& findings) {
  for (const KeySpec& spec : key_table()) {
    const bool of_solve = spec.path.starts_with("discretisation.") ||
                          spec.path.starts_with("solver.");
    const Entry* entry =
        of_solve ? sound_entry(root, spec.path, findings) : nullptr;
    if (entry == nullptr || !spec.value.get || spec.used(draft) ||
        spec.value.get(draft) == spec.value.get({})) {
      continue;
    }
    std::string message = "has no effect here; leave it out";
    if (const auto other = word_that_uses(spec, draft)) {
      const Json now = other->key->value.get(draft);
      message =
          fmt::format("has no effect with {}; leave it out, or take {}",
                      stated({other->key, now.get_ref<const std::string&>()}),
                      stated(*other));
    }
    findings.add(entry->value.position, std::string(spec.path),
                 std::move(message));
  }
}

void check_solver(const YamlValue& root, const Draft& problem,
                  Findings& findings) {
  const Entry* search = sound_entry(root, "solver.search", findings);
  if (search != nullptr && !findings.concern("scene.contact") &&
      problem.program.search == Search::Global &&
      problem.scene.contact == Contact::Centre) {
    findings.add(search->value.position, "solver.search",
                 "global is not allowed with contact: centre; between fixed "
                 "ends of the centre's path there is no contact to search for");
  }
  const Entry* rates = sound_entry(root, "solver.sensitivities", findings);
  if (rates != nullptr && problem.scene.path &&
      problem.program.sensitivities != SensitivityOrder::None) {
    findings.add(rates->value.position, "solver.sensitivities",
                 "is not allowed with scene.path; what is evaluated and not "
                 "optimised has no conditions to follow");
  }
  if (!findings.concern("solver.method")) {
    check_use(root, problem, findings);
  }
}

/// What knows the free motion between smooth contacts or fixed ends alone.
struct OfFreeMotion {
  std::string_view key, word, reason;
};
constexpr std::string_view kOtherStarts =
    "starts elsewhere are tried for the free motion alone";
constexpr std::array<OfFreeMotion, 5> kOfFreeMotion{
    {{"discretisation.formulation", "arc_length",
      "straight pieces have neither forces nor curvatures to bound"},
     {"solver.method", "fsolve",
      "the paper's discrete system consists of equations alone"},
     {"solver.search", "global",
      "the search is for smooth contacts of the free motion"},
     {"solver.guess", "straight", kOtherStarts},
     {"solver.guess", "random", kOtherStarts}}};

/// Limits, and the contacts that need them, have a method of their own.
void check_limited(const YamlValue& root, const Draft& problem,
                   Findings& findings) {
  const Contact contact = problem.scene.contact;
  const bool other_contact =
      contact == Contact::Optimal || contact == Contact::EndSlope;
  if (!problem.scene.limits.any() && !other_contact) return;
  const std::string_view with = problem.scene.limits.any() ? "scene.limits"
                                : contact == Contact::Optimal
                                    ? "contact: optimal"
                                    : "a given slope at B";
  for (const auto& [key, word, reason] : kOfFreeMotion) {
    const KeySpec& spec = *find_key(key);
    if (findings.concern(key) || !spec.used(problem) ||
        spec.value.get(problem) != word) {
      continue;
    }
    findings.add(
        position_of(root, key), std::string(key),
        fmt::format("{} is not allowed with {}: {}", word, with, reason));
  }
}

/// What is derived for a uniform field without air, left from rest.
constexpr std::string_view kOrdinaryStarts =
    "starts elsewhere are made for a body that leaves rest in a uniform field";
constexpr std::array<OfFreeMotion, 5> kOfOrdinaryWorld{
    {{"discretisation.formulation", "arc_length",
      "its speed is that of the energy height, which knows neither losses nor "
      "another potential"},
     {"solver.method", "fsolve",
      "the paper's discrete system is one of a uniform field, left from rest"},
     {"solver.search", "global",
      "the search goes back from B to rest with constant costates p_x and p_z, "
      "as they are in a uniform field"},
     {"solver.guess", "straight", kOrdinaryStarts},
     {"solver.guess", "random", kOrdinaryStarts}}};

void check_world(const YamlValue& root, const Draft& problem,
                 Findings& findings) {
  const Entry* uniform = find_entry(root, "scene.field.uniform");
  const Entry* sphere = find_entry(root, "scene.field.sphere");
  const Entry* gravity = find_entry(root, "scene.gravity");
  const Entry* field = find_entry(root, "scene.field");
  if (field != nullptr && field->value.kind == YamlValue::Kind::Map &&
      field->value.entries.empty()) {
    findings.add(field->position, "scene.field",
                 "has nothing in it; expected uniform or sphere");
  }
  const auto one_too_many = [&](const Entry* entry, const char* key) {
    findings.add(entry->position, key,
                 "says again what pulls the body; allowed is one of "
                 "scene.gravity, scene.field.uniform and scene.field.sphere");
  };
  if (uniform != nullptr && (sphere != nullptr || gravity != nullptr)) {
    one_too_many(uniform, "scene.field.uniform");
  } else if (sphere != nullptr && gravity != nullptr) {
    one_too_many(sphere, "scene.field.sphere");
  }
  if (problem.scene.world.ordinary()) return;
  for (const auto& [key, word, reason] : kOfOrdinaryWorld) {
    const KeySpec& spec = *find_key(key);
    if (findings.concern(key) || !spec.used(problem) ||
        spec.value.get(problem) != word) {
      continue;
    }
    findings.add(position_of(root, key), std::string(key),
                 fmt::format("{} is not allowed with a sphere's field, a start "
                             "speed or air: {}",
                             word, reason));
  }
}

void check_arc_length(const YamlValue& root, const Draft& problem,
                      Findings& findings) {
  const Discretisation& mesh = problem.program.discretisation;
  const auto too_few = [&](std::string_view key, int count, int fewest) {
    const Entry* entry = sound_entry(root, key, findings);
    if (entry == nullptr || count >= fewest) return;
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
  const Entry* tolerance = sound_entry(root, key, findings);
  if (tolerance == nullptr ||
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

void check_mesh(const YamlValue& root, const Draft& problem,
                Findings& findings) {
  if (problem.method == MethodWord::Extremal) return;
  const bool arc_length = problem.of_pieces();
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
  const Discretisation& mesh = problem.program.discretisation;
  if (problem.method == MethodWord::Fsolve) {
    if (problem.system.nodes >= kFewestDiscreteNodes) return;
    findings.add(nodes->value.position, key,
                 fmt::format("{} is not allowed; method: fsolve needs {} or "
                             "more",
                             problem.system.nodes, kFewestDiscreteNodes));
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

/// Whether every problem needs a key, not only those with the maps it is in.
bool is_required(const KeySpec& spec) {
  if (!spec.is_required()) return false;
  const KeySpec* map = find_key(spec.parent());
  return map == nullptr || is_required(*map);
}

void check_scene(const YamlValue& root, const Draft& problem,
                 Findings& findings) {
  // NaN stands for every number that should be there and could not be read, so
  // that no bound is checked against a value nobody gave.
  Draft marked = problem;
  std::vector<std::string_view> unread;
  const bool has_parts = find_entry(root, "scene.body.parts") != nullptr;
  for (const KeySpec& spec : key_table()) {
    if (!spec.path.starts_with("scene.")) continue;
    const bool of_other_body = spec.presence == Presence::RequiredOfCylinder &&
                               !problem.scene.body.rolls();
    const bool of_parts = has_parts && follows_from_parts(spec);
    const bool absent = is_required(spec) && !of_other_body && !of_parts &&
                        find_entry(root, spec.path) == nullptr;
    if (findings.concern(spec.path) || absent) {
      if (spec.type() == KeyType::Number || spec.type() == KeyType::Angle) {
        spec.value.set(marked, std::numeric_limits<double>::quiet_NaN());
      }
      unread.push_back(spec.path);
    }
  }
  const bool listed = find_entry(root, "scene.path.points") != nullptr;
  const bool in_field = find_entry(root, "scene.field.uniform") != nullptr;
  for (SceneError& error : validate(marked.scene)) {
    if (listed && error.key == "scene.path.file") {
      error.key = "scene.path.points";
    }
    if (in_field && error.key == "scene.gravity") {
      error.key = "scene.field.uniform";
    }
    if (std::ranges::count(unread, error.key) > 0) continue;
    const Position position = position_of(root, error.key);
    findings.add(position, std::move(error.key), std::move(error.message));
  }
}

}  // namespace

void check_all(const YamlValue& root, const Draft& problem,
               Findings& findings) {
  check_body(root, problem, findings);
  check_mesh(root, problem, findings);
  check_solver(root, problem, findings);
  check_limited(root, problem, findings);
  check_world(root, problem, findings);
  check_scene(root, problem, findings);
  check_design(root, problem, findings);
}

}  // namespace brachisto::io
