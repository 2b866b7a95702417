// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Sweeps: problem files whose section `sweep` makes one scene into many.

#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "brachisto/io/diagnostics.hpp"
#include "brachisto/io/problem_file.hpp"

namespace brachisto::io {

/// Value of a swept key in one scene: a number (SI units, rad) or a word.
using SweepValue = std::variant<double, std::string>;

/// A key of the problem file that differs between scenes.
struct SweepKey {
  std::string path;     ///< dotted, "scene.body.eta_m"
  bool numeric = true;  ///< false: its values are words
};

/// A direction of the product.
struct SweepFileAxis {
  std::vector<std::size_t> keys;  ///< indices of those that run along it
  std::size_t count = 0;          ///< values, ≥ 1
  bool ordered = true;            ///< false: a random sample
};

/// Most scenes that a sweep may have.
inline constexpr std::size_t kMaxScenes = 10'000'000;

/// A family of problems: the product of some axes.
///
/// Scenes are numbered from 0 in the order of the product, the last axis being
/// the fastest. Copies are cheap, and several threads may read one object.
class SweepFile {
 public:
  struct Content;
  explicit SweepFile(std::shared_ptr<const Content> content);

  /// All keys of the section in file order. One that belongs to no axis has the
  /// same value in all scenes or depends on other keys.
  [[nodiscard]] const std::vector<SweepKey>& keys() const;

  /// The axes in file order, the last one the fastest.
  [[nodiscard]] const std::vector<SweepFileAxis>& axes() const;

  /// Product of the counts of the axes.
  [[nodiscard]] std::size_t num_scenes() const;

  /// Whether a scene may start from the solution of a neighbour.
  [[nodiscard]] bool warm_start() const;

  /// Whether the track of each scene is kept beside its numbers.
  [[nodiscard]] bool keeps_tracks() const;

  /// The problem of a scene, as if the file had values(scene) in place of its
  /// own. Satisfies what read_problem_file() promises.
  /// \throws std::out_of_range  unless scene < num_scenes()
  [[nodiscard]] ProblemFile problem(std::size_t scene) const;

  /// The values of all keys() in a scene.
  /// \throws std::out_of_range  unless scene < num_scenes()
  [[nodiscard]] std::vector<SweepValue> values(std::size_t scene) const;

  /// What the file and its overrides state, as one JSON document, which is a
  /// problem file again. Expressions stay text.
  [[nodiscard]] const std::string& stated() const;

 private:
  std::shared_ptr<const Content> content_;
};

/// Reads a problem file with a section `sweep`, and checks all its scenes.
///
/// \param overrides  as of read_problem_file(); after "sweep." a dotted key of
///                   the problem counts as one key of the section
/// \throws IoError     if the file cannot be read
/// \throws InputError  with every mistake of its content, or if it has no
///                     section `sweep`. A mistake that comes with the values of
///                     scenes is told for the first few of them.
[[nodiscard]] SweepFile read_sweep_file(
    const std::filesystem::path& path,
    const std::vector<std::string>& overrides = {});

/// Reads a sweep from memory; `name` stands for the file in messages.
///
/// \param points  those of scene.path, where the file that it names was read
///                before; nullptr: it is read now
/// \throws IoError, InputError  as read_sweep_file()
[[nodiscard]] SweepFile read_sweep_text(
    std::string_view text, const std::string& name,
    const std::vector<std::string>& overrides = {},
    const std::vector<Point>* points = nullptr);

/// Reads a file once, as a sweep if it has a section `sweep`.
/// \throws IoError, InputError  as read_problem_file() and read_sweep_file()
[[nodiscard]] std::variant<ProblemFile, SweepFile> read_problem_or_sweep_file(
    const std::filesystem::path& path,
    const std::vector<std::string>& overrides = {});

}  // namespace brachisto::io
