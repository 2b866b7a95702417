// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "app/new_problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <span>
#include <stdexcept>

#include "io/key_spec.hpp"
#include "report/letters.hpp"

namespace brachisto::app {

namespace {

/// A key with a value, as in YAML.
struct Stated {
  std::string_view path;  ///< behind "sweep:" that of a key that varies
  std::string_view value;
  bool off = false;  ///< behind a #
};

struct Kind {
  std::string_view name;
  std::string_view what;
  std::string_view verb;
  std::span<const Stated> keys;
  bool writes = false;  ///< the verb wants a directory
};

constexpr std::string_view kSweep = "sweep:";
constexpr bool kOff = true;

constexpr Stated kCase[] = {
    {"scene.body.shape", "cylinder"},
    {"scene.body.radius", "1/3"},
    {"scene.body.eta_m", "2/3"},
    {"scene.body.theta_m", "-30 deg"},
    {"scene.body.k", "1/2"},
    {"scene.body.mass", "2", kOff},
    {"scene.finish.L", "3"},
    {"scene.finish.H", "1"},
    {"scene.gravity", "9.81", kOff},
    {"scene.contact", "smooth", kOff},
    {"discretisation.tolerance", "1e-10", kOff},
    {"solver.certify", "extremal", kOff},
    {"solver.sensitivities", "true", kOff},
};
constexpr Stated kUnderLimits[] = {
    {"scene.body.shape", "cylinder"},
    {"scene.body.radius", "1/3"},
    {"scene.body.eta_m", "2/3"},
    {"scene.body.k", "1/2"},
    {"scene.finish.L", "3"},
    {"scene.finish.H", "1"},
    {"scene.contact", "optimal"},
    {"scene.limits.friction", "2", kOff},
    {"scene.limits.normal_force.min", "0.2"},
    {"scene.limits.normal_force.max", "5"},
    {"scene.limits.curvature.hump", "2.7"},
    {"scene.limits.curvature.valley", "4"},
    {"scene.limits.curvature.of", "centre"},
    {"scene.limits.floor", "1.5", kOff},
    {"scene.limits.clear_of", "[{disc: {x: 1, z: 2, radius: 0.2}}]", kOff},
};
constexpr Stated kWorld[] = {
    {"scene.body.shape", "cylinder"},
    {"scene.body.radius", "1/3"},
    {"scene.body.eta_m", "1/2"},
    {"scene.body.theta_m", "20 deg"},
    {"scene.body.k", "1/2"},
    {"scene.finish.L", "3"},
    {"scene.finish.H", "1"},
    {"scene.field.sphere.centre.x", "1"},
    {"scene.field.sphere.centre.z", "10"},
    {"scene.field.sphere.radius", "8"},
    {"scene.field.sphere.surface_gravity", "9.81"},
    {"scene.start.speed", "1", kOff},
    {"scene.air.linear", "0.3", kOff},
    {"scene.air.quadratic", "0.1", kOff},
};
constexpr Stated kFamily[] = {
    {"scene.body.shape", "cylinder"},
    {"scene.body.radius", "1/3"},
    {"scene.body.k", "1/2"},
    {"scene.finish.L", "3"},
    {"scene.finish.H", "1"},
    {"discretisation.tolerance", "1e-8"},
    {"sweep:scene.body.eta_m", "{from: 0, to: 2/3, count: 5}"},
    {"sweep:scene.body.theta_m", "[-30 deg, 0, 30 deg]", kOff},
};
constexpr Stated kQuickest[] = {
    {"scene.body.shape", "cylinder"},
    {"scene.body.radius", "1/3"},
    {"scene.body.eta_m", "1/3"},
    {"scene.body.theta_m", "0"},
    {"scene.body.k", "1/2"},
    {"scene.finish.L", "3"},
    {"scene.finish.H", "1"},
    {"design.free", "[eta_m, theta_m]"},
    {"design.bounds.eta_m", "[0, 0.6]", kOff},
    {"design.bounds.theta_m", "[-60 deg, 60 deg]", kOff},
    {"design.require_feasible", "true", kOff},
    {"design.starts", "2"},
    {"design.seed", "1", kOff},
};

constexpr Kind kKinds[] = {
    {"case", "one scene", "solve", kCase},
    {"limits", "a track under limits", "solve", kUnderLimits},
    {"world", "one scene in another world", "solve", kWorld},
    {"sweep", "a family of scenes", "sweep", kFamily, true},
    {"design", "the quickest body on its own extremal", "design", kQuickest},
};

const Kind& kind_of(std::string_view name) {
  const auto* const found = std::ranges::find(kKinds, name, &Kind::name);
  if (found == std::end(kKinds)) {
    throw std::invalid_argument(fmt::format("no kind {}", name));
  }
  return *found;
}

/// A comment of lines that fit a page.
std::string comment(std::string_view text, const std::string& indent) {
  constexpr std::size_t kLetters = 88;
  std::string out;
  const std::size_t room = kLetters - indent.size() - 2;
  for (const std::string& line : report::words_in_lines(text, room)) {
    out += fmt::format("{}# {}\n", indent, line);
  }
  return out;
}

/// The maps that a key is in, then the key: "scene", "scene.body", ….
std::vector<std::string_view> way_to(std::string_view path) {
  if (path.starts_with(kSweep)) return {"sweep", path};
  std::vector<std::string_view> way;
  for (std::size_t dot = path.find('.'); dot != std::string_view::npos;
       dot = path.find('.', dot + 1)) {
    way.push_back(path.substr(0, dot));
  }
  way.push_back(path);
  return way;
}

/// Whether all keys of a map are behind a #.
bool all_off(std::span<const Stated> keys, std::string_view map) {
  return std::ranges::all_of(keys, [map](const Stated& key) {
    return key.off || !std::ranges::count(way_to(key.path), map);
  });
}

}  // namespace

std::vector<std::string> new_problem_kinds() {
  std::vector<std::string> names;
  for (const Kind& kind : kKinds) names.emplace_back(kind.name);
  return names;
}

std::string next_command(std::string_view kind, std::string_view file,
                         std::string_view name) {
  const Kind& chosen = kind_of(kind);
  return fmt::format("{} {}{}", chosen.verb, file,
                     chosen.writes ? fmt::format(" --out {}", name) : "");
}

std::string new_problem(std::string_view kind, std::string_view name) {
  const Kind& chosen = kind_of(kind);
  std::string text = comment(
      fmt::format("{}: {}. Above each key stands what it means. A key behind a "
                  "# counts once that is gone, and those before the maps that "
                  "it is in.",
                  name, chosen.what),
      "");
  std::set<std::string_view> written;
  for (const Stated& key : chosen.keys) {
    std::string indent;
    for (const std::string_view path : way_to(key.path)) {
      const bool last = path == key.path;
      if (written.insert(path).second) {
        const bool varies = path.starts_with(kSweep);
        const std::string_view known =
            varies ? path.substr(kSweep.size()) : path;
        const io::KeySpec* spec = io::find_key(known);
        if (indent.empty()) text += '\n';
        text += comment(io::described(*spec), indent);
        const bool off = last ? key.off : all_off(chosen.keys, path);
        text += fmt::format("{}{}{}:{}{}\n", indent, off ? "#" : "",
                            varies ? known : spec->name(), last ? " " : "",
                            last ? key.value : "");
      }
      indent += "  ";
    }
  }
  return text;
}

}  // namespace brachisto::app
