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
#include <span>

#include "io/body_parts.hpp"
#include "io/check.hpp"
#include "io/key_spec.hpp"

namespace brachisto::io {

namespace {

// Relative errors of the paper's cases are 0.07/N² to 0.9/N².
constexpr double kPiecesTimesRootOfError = 0.6;

void check_bead(const Check& check) {
  std::vector<std::string_view> allowed = keys_of("scene.body");
  std::erase_if(allowed, [](std::string_view name) {
    return find_key(fmt::format("scene.body.{}", name))->of_cylinder();
  });
  for (const KeySpec& spec : key_table()) {
    if (!spec.of_cylinder() || !check.entry(spec.path)) continue;
    check.refuse_key(spec.path, "a bead has no {}; allowed of a bead: {}",
                     spec.name(), fmt::join(allowed, ", "));
  }
}

/// What says k, and what a ball alone runs in.
void check_rolling(const Check& check) {
  const bool has_parts = check.entry(kPartsKey) != nullptr;
  const bool has_inertia = check.entry(kInertiaKey) != nullptr;
  if (has_inertia && check.entry("scene.body.k") != nullptr) {
    check.refuse_key(kInertiaKey,
                     "says again what k does; allowed is one of them");
  }
  if (check.problem.scene.body.shape != Shape::Ball) {
    for (const char* key : {"scene.body.rails", "scene.body.groove"}) {
      if (check.entry(key) == nullptr) continue;
      check.refuse_key(
          key,
          "not allowed of a cylinder, which runs on a plain track; "
          "take shape: ball");
    }
  }
  for (const KeySpec& spec : key_table()) {
    if (spec.presence != Presence::RequiredOfCylinder) continue;
    if (check.entry(spec.path) != nullptr) continue;
    if (has_parts && follows_from_parts(spec)) continue;
    if (has_inertia && follows_from_inertia(spec)) continue;
    check.refuse(spec.path, "missing; expected {} ({})", expected(spec),
                 spec.description);
  }
}

void check_body(const Check& check) {
  if (!check.sound_entry("scene.body.shape")) return;
  if (check.problem.scene.body.shape == Shape::Bead) {
    check_bead(check);
  } else {
    check_rolling(check);
  }
}

/// "method: fsolve".
std::string stated(const KeyWord& choice) {
  return fmt::format("{}: {}", choice.key->name(), choice.word);
}

/// Refuses keys that have a value of their own and that the problem has no use
/// for.
void check_use(const Check& check) {
  const Draft& draft = check.problem;
  for (const KeySpec& spec : key_table()) {
    const bool of_solve = spec.path.starts_with("discretisation.") ||
                          spec.path.starts_with("solver.");
    if (!of_solve || !check.sound_entry(spec.path) || !spec.value.is_echoed() ||
        spec.used(draft) || spec.value.get(draft) == spec.value.get({})) {
      continue;
    }
    if (const auto other = word_that_uses(spec, draft)) {
      const Json now = other->key->value.get(draft);
      check.refuse(spec.path, "has no effect with {}; leave it out, or take {}",
                   stated({other->key, now.get_ref<const std::string&>()}),
                   stated(*other));
    } else {
      check.refuse(spec.path, "has no effect here; leave it out");
    }
  }
}

void check_solver(const Check& check) {
  const auto& [root, problem, findings] = check;
  if (check.sound_entry("solver.sensitivities") && problem.scene.path &&
      problem.program.sensitivities != SensitivityOrder::None) {
    check.refuse("solver.sensitivities",
                 "is not allowed with scene.path; what is evaluated and not "
                 "optimised has no conditions to follow");
  }
  if (!findings.concern("solver.method")) check_use(check);
}

/// A word that is not allowed with something else, and why.
struct Excluded {
  std::string_view key, word, reason;
};

void exclude(const Check& check, std::span<const Excluded> words,
             std::string_view with) {
  for (const auto& [key, word, reason] : words) {
    const KeySpec& spec = *find_key(key);
    if (check.findings.concern(key) || !spec.used(check.problem) ||
        spec.value.get(check.problem) != word) {
      continue;
    }
    check.refuse(key, "{} is not allowed with {}: {}", word, with, reason);
  }
}

/// What knows the free motion between smooth contacts or fixed ends alone.
constexpr std::string_view kOtherStarts =
    "starts elsewhere are tried for the free motion alone";
constexpr std::array<Excluded, 4> kOfFreeMotion{
    {{"discretisation.formulation", "arc_length",
      "straight pieces have neither forces nor curvatures to bound"},
     {"solver.method", "fsolve",
      "the paper's discrete system consists of equations alone"},
     {"solver.guess", "straight", kOtherStarts},
     {"solver.guess", "random", kOtherStarts}}};

/// Limits, and the contacts that need them, have a method of their own.
void check_limited(const Check& check) {
  const Scene& scene = check.problem.scene;
  if (scene.limits.any()) {
    exclude(check, kOfFreeMotion, "scene.limits");
  } else if (scene.contact == Contact::Optimal) {
    exclude(check, kOfFreeMotion, "contact: optimal");
  } else if (scene.contact == Contact::EndSlope) {
    exclude(check, kOfFreeMotion, "a given slope at B");
  }
}

/// What finds, searches for or compares with an extremal.
constexpr std::string_view kEvaluated = "what is given is evaluated, not found";
constexpr std::array<Excluded, 9> kOfExtremals{
    {{"discretisation.formulation", "arc_length", kEvaluated},
     {"solver.method", "extremal", kEvaluated},
     {"solver.method", "fsolve", kEvaluated},
     {"solver.method", "newton_kkt", kEvaluated},
     {"solver.certify", "extremal", kEvaluated},
     {"solver.certify", "proof", kEvaluated},
     {"solver.search", "global", kEvaluated},
     {"solver.guess", "straight", kEvaluated},
     {"solver.guess", "random", kEvaluated}}};

/// What is derived for a uniform field without air and losses, left from rest.
constexpr std::string_view kOrdinaryStarts =
    "starts elsewhere are made for a body that leaves rest in a uniform field";
constexpr std::array<Excluded, 4> kOfOrdinaryWorld{
    {{"discretisation.formulation", "arc_length",
      "its speed is that of the energy height, which knows neither losses nor "
      "another potential"},
     {"solver.method", "fsolve",
      "the paper's discrete system is one of a uniform field, left from rest"},
     {"solver.guess", "straight", kOrdinaryStarts},
     {"solver.guess", "random", kOrdinaryStarts}}};
constexpr std::array<Excluded, 1> kOfOrdinaryWorldWithoutLimits{
    {{"solver.search", "global",
      "without limits the search goes back from B to rest with constant "
      "costates p_x and p_z, as they are in a uniform field"}}};

void check_world(const Check& check) {
  constexpr std::string_view kUniform = "scene.field.uniform";
  std::vector<std::string> names, keys;
  const char* stated = nullptr;  // the last of the fields
  int fields = 0;
  for (const FieldKind& kind : kFieldKinds) {
    keys.emplace_back(kind.key);
    names.push_back(keys.back().substr(keys.back().rfind('.') + 1));
    if (check.entry(kind.key) == nullptr) continue;
    stated = kind.key;
    ++fields;
  }
  const bool gravity = check.entry("scene.gravity") != nullptr;
  const Entry* field = check.entry("scene.field");
  if (field != nullptr && field->value.kind == YamlValue::Kind::Map &&
      field->value.entries.empty()) {
    check.refuse_key("scene.field", "has nothing in it; expected uniform or {}",
                     fmt::join(names, " or "));
  }
  const bool uniform_too = check.entry(kUniform) && (fields > 0 || gravity);
  if (uniform_too || fields + (gravity ? 1 : 0) > 1) {
    check.refuse_key(
        uniform_too ? kUniform : stated,
        "says again what pulls the body; allowed is one of scene.gravity, "
        "scene.field.uniform and {}",
        fmt::join(keys, " and "));
  }
  const Scene& scene = check.problem.scene;
  if (scene.world.ordinary()) return;
  constexpr std::string_view kWorld =
      "a field that varies, a start speed, air or losses";
  exclude(check, kOfOrdinaryWorld, kWorld);
  const bool any_limits_refused =
      std::ranges::any_of(check.findings.all(), [](const Finding& finding) {
        return finding.key.starts_with("scene.limits");
      });
  if (!scene.limits.any() && !any_limits_refused) {
    exclude(check, kOfOrdinaryWorldWithoutLimits, kWorld);
  }
}

void check_arc_length(const Check& check) {
  const Discretisation& mesh = check.problem.program.discretisation;
  const auto too_few = [&](std::string_view key, int count, int fewest) {
    if (!check.sound_entry(key) || count >= fewest) return;
    check.refuse(key,
                 "{} is not allowed with formulation: arc_length, which needs "
                 "{} or more",
                 count, fewest);
  };
  too_few("discretisation.elements", mesh.elements.value_or(kFewestPieces),
          kFewestPieces);
  too_few("discretisation.nodes", mesh.nodes.value_or(kFewestPieces + 1),
          kFewestPieces + 1);
  constexpr std::string_view kTolerance = "discretisation.tolerance";
  const double tolerance = mesh.wanted_tolerance();
  if (!check.sound_entry(kTolerance) ||
      tolerance >= kSmallestArcLengthTolerance) {
    return;
  }
  check.refuse(kTolerance,
               "{:g} is not allowed with formulation: arc_length, whose error "
               "falls as the square of the number of pieces: it would take "
               "some {:.0e} of them. Allowed is {:g} or more; or take "
               "formulation: rolling_time",
               tolerance, kPiecesTimesRootOfError / std::sqrt(tolerance),
               kSmallestArcLengthTolerance);
}

void check_mesh(const Check& check) {
  const auto& [root, problem, findings] = check;
  if (problem.method == MethodWord::Extremal) return;
  const bool arc_length = problem.of_pieces();
  if (arc_length) check_arc_length(check);
  constexpr std::string_view kNodes = "discretisation.nodes";
  constexpr std::string_view kElements = "discretisation.elements";
  const Entry* elements = check.entry(kElements);
  const Entry* nodes = check.entry(kNodes);
  if (nodes == nullptr) return;
  if (elements != nullptr) {
    // The later of the two is the one too many.
    const bool nodes_later = elements->position < nodes->position;
    return check.refuse_key(
        nodes_later ? kNodes : kElements,
        "{} is given too; elements and nodes both fix the mesh, allowed is one "
        "of them",
        nodes_later ? "elements" : "nodes");
  }
  if (arc_length || findings.concern(kNodes) ||
      findings.concern("discretisation.degree")) {
    return;
  }
  if (problem.method == MethodWord::Fsolve) {
    if (problem.system.nodes >= kFewestDiscreteNodes) return;
    return check.refuse(kNodes,
                        "{} is not allowed; method: fsolve needs {} or more",
                        problem.system.nodes, kFewestDiscreteNodes);
  }
  const Discretisation& mesh = problem.program.discretisation;
  const int p = mesh.degree_of_fixed();
  const int count = mesh.nodes.value();
  if ((count - 1) % p == 0) return;
  const int below = (count - 1) / p * p + 1;
  check.refuse(kNodes,
               "{} is not allowed; nodes − 1 is a multiple of the degree {}; "
               "nearest: {}",
               count, p,
               below > 1 ? fmt::format("{} or {}", below, below + p)
                         : fmt::format("{}", below + p));
}

/// Whether every problem needs a key, not only those with the maps it is in.
bool is_required(const KeySpec& spec) {
  if (!spec.is_required()) return false;
  const KeySpec* map = find_key(spec.parent());
  return map == nullptr || is_required(*map);
}

void check_scene(const Check& check) {
  const auto& [root, problem, findings] = check;
  // NaN stands for every number that should be there and could not be read, so
  // that no bound is checked against a value nobody gave.
  Draft marked = problem;
  std::vector<std::string_view> unread;
  const bool has_parts = check.entry(kPartsKey) != nullptr;
  const bool has_inertia = check.entry(kInertiaKey) != nullptr;
  for (const KeySpec& spec : key_table()) {
    if (!spec.path.starts_with("scene.")) continue;
    const bool of_other_body = spec.presence == Presence::RequiredOfCylinder &&
                               !problem.scene.body.rolls();
    const bool follows = (has_parts && follows_from_parts(spec)) ||
                         (has_inertia && follows_from_inertia(spec));
    const bool absent = is_required(spec) && !of_other_body && !follows &&
                        check.entry(spec.path) == nullptr;
    if (findings.concern(spec.path) || absent) {
      if (spec.type() == KeyType::Number || spec.type() == KeyType::Angle) {
        spec.value.set(marked, std::numeric_limits<double>::quiet_NaN());
      }
      unread.push_back(spec.path);
    }
  }
  const auto in_place_of = [&](std::string& key, const char* other,
                               const char* stated) {
    if (key == other && check.entry(stated)) key = stated;
  };
  marked.scene.body = as_it_rolls(marked.scene.body);
  // That of which forces are multiples, where the field is known and pulls.
  const double gravity = gravity_at_A(marked.scene);
  if (gravity > 0.0) marked.scene.gravity = gravity;
  for (SceneError& error : validate(marked.scene)) {
    in_place_of(error.key, "scene.path.file", "scene.path.points");
    in_place_of(error.key, "scene.gravity", "scene.field.uniform");
    if (std::ranges::count(unread, error.key) > 0) continue;
    check.refuse(error.key, "{}", error.message);
  }
}

}  // namespace

void check_all(const YamlValue& root, const Draft& problem,
               Findings& findings) {
  const Check check{root, problem, findings};
  check_body(check);
  check_mesh(check);
  check_solver(check);
  if (check.problem.scene.path) exclude(check, kOfExtremals, "scene.path");
  check_limited(check);
  check_world(check);
  check_scene(check);
  check_design(check);
}

void require_design(const ProblemFile& problem, const std::string& file) {
  if (!problem.design.empty()) return;
  throw InputError({{.file = file,
                     .key = "design.free",
                     .message = "missing; expected what the design may "
                                "choose, as in design: {free: [eta_m, "
                                "theta_m, k]}"}});
}

}  // namespace brachisto::io
