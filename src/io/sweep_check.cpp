// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/sweep_check.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "io/consistency.hpp"

namespace brachisto::io {

namespace {

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

}  // namespace

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

}  // namespace brachisto::io
