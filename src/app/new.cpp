// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto new NAME: a problem file with comments, to begin with.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/exit_code.hpp"
#include "app/installed.hpp"
#include "app/terminal.hpp"
#include "app/verbs.hpp"
#include "brachisto/report/result.hpp"
#include "io/key_spec.hpp"
#include "io/visible_text.hpp"
#include "report/letters.hpp"
#include "report/rich_text.hpp"

namespace brachisto::app {

namespace {

namespace fs = std::filesystem;

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
    {"scene.losses.rolling", "0.01", kOff},
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

/// A problem file of a kind, with comments. A key behind a # and no space may
/// be stated too: the file is as good without any of these #, if those before
/// the maps that the key is in go with it.
/// \param name  as it is called in its first line, without control characters
std::string new_problem(const Kind& chosen, std::string_view name) {
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

struct NewFlags {
  std::string name;
  std::string kind = "case";
  bool quiet = false;
  bool force = false;
};

/// A file as a URI, which has no spaces (RFC 3986).
std::string uri_of(const fs::path& file) {
  constexpr std::string_view kAsTheyAre =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~/";
  std::string uri = "file://";
  for (const char c : file.string()) {
    uri += kAsTheyAre.find(c) != std::string_view::npos
               ? std::string(1, c)
               : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return uri;
}

/// The schema of problem files: installed with the program, or made with it in
/// its build tree; nothing if there is none.
std::optional<fs::path> schema_file() {
  constexpr const char* kProblemSchema = "schemas/problem.schema.json";
  if (auto file = installed(kProblemSchema)) return file;
  std::error_code error;
  const fs::path built = fs::path(BRACHISTO_BUILT_DATA) / kProblemSchema;
  if (!fs::exists(built, error)) return std::nullopt;
  return built;
}

/// By this line the YAML language server finds the schema.
std::string schema_line() {
  const auto schema = schema_file();
  return schema ? fmt::format("# yaml-language-server: $schema={}\n",
                              uri_of(*schema))
                : "";
}

/// A text as one word of a shell, in single quotes if it needs them.
std::string shell_word(std::string_view text) {
  constexpr std::string_view kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._/";
  if (!text.empty() && text.find_first_not_of(kPlain) == text.npos) {
    return std::string(text);
  }
  return "'" + report::replaced(text, "'", "'\\''") + "'";
}

int write_new(const NewFlags& flags) {
  const Kind& kind = *std::ranges::find(kKinds, flags.kind, &Kind::name);
  fs::path file = flags.name;
  if (!file.has_filename()) {
    throw UsageError("brachisto new", io::in_quotes(flags.name) +
                                          " is a directory; expected "
                                          "the name of a file");
  }
  if (file.extension() != ".yaml" && file.extension() != ".yml") {
    file += ".yaml";
  }
  const std::string stem = io::visible(file.stem().string());
  // Of a name without a directory the parent is empty.
  report::write_files(
      file.has_parent_path() ? file.parent_path() : fs::path("."),
      {{file.filename().string(), schema_line() + new_problem(kind, stem)}},
      flags.force);
  if (!flags.quiet) {
    const std::string shown = io::visible(file.string());
    print(fmt::format("{}: written; to go on:\n  brachisto {} {}{}\n", shown,
                      kind.verb, shell_word(shown),
                      kind.writes ? " --out " + shell_word(stem) : ""));
  }
  return kSuccess;
}

}  // namespace

Verb new_verb() {
  const auto flags = std::make_shared<NewFlags>();
  std::vector<std::string> kinds;
  for (const Kind& kind : kKinds) kinds.emplace_back(kind.name);
  return {
      .name = "new",
      .text = "Write a problem file with comments, to begin with",
      .flags = {{.name = "NAME",
                 .value = &flags->name,
                 .text = "Name of the file; .yaml is added",
                 .check = not_empty(),
                 .required = true},
                {.name = "--kind",
                 .value = &flags->kind,
                 .text = "What it is about: one scene, a track under limits, "
                         "another world, a family of scenes, the quickest body",
                 .placeholder = "KIND",
                 .check = one_of(kinds),
                 .shows_default = true},
                {"--force", &flags->force, "Replace an existing file"},
                {"--quiet", &flags->quiet, "Print nothing"}},
      .footer =
          R"(Above each key stands what it means. A key behind a # counts once that is gone,
and those before the maps that it is in. The first line tells editors with the
YAML language server where the schema of problem files is.
Examples:
  brachisto new track
  brachisto new wide --kind sweep
Exit codes: 0 written, 6 I/O, or the file exists.)",
      .run = [flags] { return write_new(*flags); }};
}

}  // namespace brachisto::app
