// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/io/sweep_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <utility>

#include "io/effective_input.hpp"
#include "io/input_tree.hpp"
#include "io/path_points.hpp"
#include "io/problem_reader.hpp"
#include "io/sweep_check.hpp"

namespace brachisto::io {

struct SweepFile::Content {
  Draft base;
  SweepScenes scenes;
  std::vector<SweepKey> keys;
  std::string stated;
};

namespace {

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
  check_shared(section, input.root, base, findings);
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
