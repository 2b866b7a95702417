// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/io/problem_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "io/body_parts.hpp"
#include "io/consistency.hpp"
#include "io/effective_input.hpp"
#include "io/input_tree.hpp"
#include "io/path_points.hpp"
#include "io/problem_reader.hpp"
#include "io/sweep_scenes.hpp"

namespace brachisto::io {

struct SweepFile::Content {
  Draft base;
  SweepScenes scenes;
  std::vector<SweepKey> keys;
  std::string stated;
};

namespace {

/// How many scenes with a mistake in the same key are told; others are counted.
constexpr std::size_t kShownScenes = 3;

/// "scene 7 (scene.body.eta_m = 0.9, scene.body.k = 0.3)".
std::string name_of(const SweepScenes& scenes, std::size_t scene,
                    const std::vector<SweepValue>& values) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::string text = text_of(values[i]);
    if (text.empty()) continue;  // could not be evaluated
    parts.push_back(
        fmt::format("{} = {}", scenes.section().entries[i].spec->path, text));
  }
  if (parts.empty()) return fmt::format("scene {}", scene);
  return fmt::format("scene {} ({})", scene, fmt::join(parts, ", "));
}

/// Mistakes of scenes in the same key.
struct Group {
  std::string key;
  std::vector<Finding> shown;
  std::size_t count = 0;
};

/// Sorts the mistakes of scenes by key.
class Groups {
 public:
  /// \param name  tells the name of the scene
  template <class Name>
  void add(const Finding& finding, Name name) {
    auto group = std::ranges::find(groups_, finding.key, &Group::key);
    if (group == groups_.end()) {
      groups_.push_back({finding.key, {}, 0});
      group = std::prev(groups_.end());
    }
    if (++group->count > kShownScenes) return;
    group->shown.push_back(
        {finding.position, finding.key, name() + ": " + finding.message});
  }

  void report(Findings& findings) {
    for (Group& group : groups_) {
      const std::size_t more = group.count - group.shown.size();
      if (more > 0) {
        group.shown.back().message +=
            fmt::format("; {} more {} a mistake in this key", more,
                        more == 1 ? "scene has" : "scenes have");
      }
      for (Finding& finding : group.shown) {
        findings.add(finding.position, std::move(finding.key),
                     std::move(finding.message));
      }
    }
  }

 private:
  std::vector<Group> groups_;
};

/// Lets the positions of the keys that vary follow the scene.
class MovingTree {
 public:
  MovingTree(const YamlValue& root, const SweepScenes& scenes)
      : root_(root), scenes_(scenes) {
    for (const SweepEntry& entry : scenes.section().entries) {
      // They are there already, but where something else is in the way.
      Entry* place =
          make_entry(root_, parts_of(entry.spec->path), entry.position);
      values_.push_back(place == nullptr ? nullptr : &place->value);
    }
  }

  [[nodiscard]] const YamlValue& at(std::size_t scene) {
    for (std::size_t i = 0; i < values_.size(); ++i) {
      if (values_[i] == nullptr) continue;
      values_[i]->position = scenes_.position(i, scene);
    }
    return root_;
  }

 private:
  YamlValue root_;
  const SweepScenes& scenes_;
  std::vector<YamlValue*> values_;
};

/// Checks what all scenes share, as far as it does not depend on keys that
/// vary.
///
/// \param root  tree of the file that has an entry for each key that varies
/// \param base  the problem as far as it does not vary
void check_shared(const SweepSection& section, const YamlValue& root,
                  const Draft& base, Findings& findings) {
  // A mistake in a key keeps the checks from using it.
  Findings marked = findings;
  for (const SweepEntry& entry : section.entries) {
    marked.add(entry.position, std::string(entry.spec->path), "varies");
  }
  const std::size_t before = marked.all().size();
  check_all(root, base, marked);
  for (std::size_t i = before; i < marked.all().size(); ++i) {
    const Finding& finding = marked.all()[i];
    findings.add(finding.position, finding.key, finding.message);
  }
}

/// Checks each scene as if it were a problem file of its own.
void check_scenes(const SweepScenes& scenes, const YamlValue& root,
                  const Draft& base, Findings& findings) {
  MovingTree tree(root, scenes);
  Groups groups;
  std::vector<SweepValue> values;
  for (std::size_t scene = 0; scene < scenes.size(); ++scene) {
    Findings found = findings;
    try {
      scenes.evaluate(scene, values);
      const Draft problem = scenes.problem(base, scene, values, found);
      check_all(tree.at(scene), problem, found);
    } catch (const SweepValueError& error) {
      found.add(scenes.position(error.entry, scene),
                scenes.section().entries[error.entry].key, error.what());
    }
    for (std::size_t i = findings.all().size(); i < found.all().size(); ++i) {
      const Finding& finding = found.all()[i];
      if (findings.concern(finding.key)) continue;
      groups.add(finding, [&] { return name_of(scenes, scene, values); });
    }
  }
  groups.report(findings);
}

/// Takes the section out of a tree.
std::optional<Entry> take_section(YamlValue& root) {
  const auto found = std::ranges::find(root.entries, "sweep", &Entry::key);
  if (found == root.entries.end()) return std::nullopt;
  Entry section = std::move(*found);
  root.entries.erase(found);
  return section;
}

/// An override of a key that varies would have no effect.
void refuse_idle_overrides(const SweepSection& section,
                           const std::vector<std::string>& overrides,
                           Findings& findings) {
  for (std::size_t i = 0; i < overrides.size(); ++i) {
    const std::string key = overrides[i].substr(0, overrides[i].find('='));
    const SweepEntry* entry = section.find(key);
    if (entry == nullptr) continue;
    findings.add({static_cast<int>(i) + 1, 1, 1}, key,
                 fmt::format("this key varies, so that the override has no "
                             "effect; --set {}=VALUE replaces how it varies",
                             entry->key));
  }
}

/// Seconds a scene, and pages that nobody reads: of results that are of
/// interest `brachisto prove` proves them.
void refuse_proofs(const SweepSection& section, const YamlValue& root,
                   const Draft& base, Findings& findings) {
  constexpr const char* kKey = "solver.certify";
  constexpr const char* kWhy =
      "a sweep proves nothing; take `brachisto prove` on one of its scenes";
  if (const SweepEntry* entry = section.find(kKey)) {
    const auto* words = std::get_if<std::vector<std::string>>(&entry->rule);
    if (words != nullptr && std::ranges::count(*words, "proof") > 0) {
      findings.add(entry->position, kKey, kWhy);
    }
  } else if (base.program.certify == Certify::Proof) {
    findings.add(position_of(root, kKey), kKey, kWhy);
  }
}

/// Makes an entry that the reader passes over for each key that varies.
void mark_swept(const SweepSection& section, YamlValue& root) {
  for (const SweepEntry& entry : section.entries) {
    Entry* place =
        make_entry(root, parts_of(entry.spec->path), entry.key_position);
    if (place == nullptr) continue;  // the reader reports what is in the way
    place->position = entry.key_position;
    place->value = YamlValue::of(YamlValue::Kind::Refused, entry.position);
  }
}

SweepFile read_sweep(InputTree input, const std::vector<std::string>& overrides,
                     const std::vector<Point>* points, Findings findings) {
  std::string stated = stated_input(input.root).dump();
  const std::optional<Entry> sweep = take_section(input.root);
  SweepSection section;
  if (sweep) {
    section = read_sweep_section(*sweep, findings);
  } else {
    findings.add(input.root.position, "sweep",
                 "missing; expected " + expected(*find_key("sweep")) +
                     "; for a single scene there is `brachisto solve FILE`");
  }
  refuse_idle_overrides(section, overrides, findings);
  const bool readable = findings.all().empty();

  mark_swept(section, input.root);
  Draft base = ProblemReader(findings).read(input.root);
  read_path_points(input, points, base, findings);
  read_body_parts(input.root, base, findings);
  check_shared(section, input.root, base, findings);
  refuse_proofs(section, input.root, base, findings);
  std::optional<SweepNames> names =
      resolve_names(section, input.root, findings);
  const bool scenes_exist = readable && names;
  if (!scenes_exist) findings.throw_if_any(input.sources);

  std::vector<SweepKey> keys;
  for (const SweepEntry& entry : section.entries) {
    keys.push_back(
        {std::string(entry.spec->path), entry.spec->type() != KeyType::Choice});
  }
  SweepScenes scenes(std::move(section), *std::move(names));
  // Of a longer list none of the scenes' mistakes would be seen.
  if (findings.all().size() < kShownDiagnostics) {
    check_scenes(scenes, input.root, base, findings);
  }
  findings.throw_if_any(input.sources);
  return SweepFile(
      std::make_shared<const SweepFile::Content>(SweepFile::Content{
          base, std::move(scenes), std::move(keys), std::move(stated)}));
}

}  // namespace

SweepFile::SweepFile(std::shared_ptr<const Content> content)
    : content_(std::move(content)) {}

const std::vector<SweepKey>& SweepFile::keys() const {
  return content_->keys;
}

const std::vector<SweepFileAxis>& SweepFile::axes() const {
  return content_->scenes.section().axes;
}

std::size_t SweepFile::num_scenes() const {
  return content_->scenes.size();
}

bool SweepFile::warm_start() const {
  return content_->scenes.section().warm_start;
}

bool SweepFile::keeps_tracks() const {
  return content_->scenes.section().keeps_tracks;
}

ProblemFile SweepFile::problem(std::size_t scene) const {
  Findings none;
  return content_->scenes.problem(content_->base, scene, values(scene), none)
      .problem();
}

std::vector<SweepValue> SweepFile::values(std::size_t scene) const {
  if (scene >= num_scenes()) {
    throw std::out_of_range(
        fmt::format("scene {} of a sweep of {} scenes", scene, num_scenes()));
  }
  std::vector<SweepValue> values;
  content_->scenes.evaluate(scene, values);
  return values;
}

const std::string& SweepFile::stated() const {
  return content_->stated;
}

SweepFile read_sweep_file(const std::filesystem::path& path,
                          const std::vector<std::string>& overrides) {
  return read_sweep_text(read_problem_bytes(path), path.string(), overrides);
}

SweepFile read_sweep_text(std::string_view text, const std::string& name,
                          const std::vector<std::string>& overrides,
                          const std::vector<Point>* points) {
  Findings findings;
  InputTree input = read_input_tree(text, name, overrides, findings);
  return read_sweep(std::move(input), overrides, points, std::move(findings));
}

std::variant<ProblemFile, SweepFile> read_problem_or_sweep_file(
    const std::filesystem::path& path,
    const std::vector<std::string>& overrides) {
  const std::string text = read_problem_bytes(path);
  const std::string name = path.string();
  Findings ignored;  // either way they are found again
  const YamlValue root = read_input_tree(text, name, overrides, ignored).root;
  if (root.find("sweep") == nullptr) {
    return read_problem_text(text, name, overrides);
  }
  return read_sweep_text(text, name, overrides);
}

}  // namespace brachisto::io
