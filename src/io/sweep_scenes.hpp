// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The scenes of a sweep, one by one.

#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "brachisto/io/problem_file.hpp"
#include "io/draft.hpp"
#include "io/expression.hpp"
#include "io/findings.hpp"
#include "io/sweep_section.hpp"
#include "io/yaml_tree.hpp"

namespace brachisto::io {

/// How the values of a scene follow from each other.
struct SweepNames {
  std::vector<std::size_t> order;  ///< entries, each behind those it depends on
  QuantityValues fixed{};          ///< of the quantities that do not vary
};

/// Finds the value of each name: that of the key in the same scene, from the
/// sweep if the key varies, else from the file.
///
/// \param root  tree of the file; what it has for keys that vary is not used
/// \return nothing if a value is missing or depends on itself; the reason is
///         among the findings
[[nodiscard]] std::optional<SweepNames> resolve_names(
    const SweepSection& section, const YamlValue& root, Findings& findings);

/// A value of a scene is not a number; what() says why.
class SweepValueError : public std::runtime_error {
 public:
  SweepValueError(std::size_t where, const std::string& message)
      : std::runtime_error(message), entry(where) {}

  std::size_t entry;
};

/// Every scene of a section without mistakes.
class SweepScenes {
 public:
  SweepScenes(SweepSection section, SweepNames names);

  [[nodiscard]] const SweepSection& section() const { return section_; }
  [[nodiscard]] std::size_t size() const { return size_; }

  /// The value of each entry, in file order.
  /// \param[out] values  those evaluated, if one cannot be
  /// \throws SweepValueError
  void evaluate(std::size_t scene, std::vector<SweepValue>& values) const;

  /// Place of the value of an entry in a scene.
  [[nodiscard]] Position position(std::size_t entry, std::size_t scene) const;

  /// The problem with some values of evaluate(), as ProblemReader reads it.
  /// \param base  what all scenes share
  [[nodiscard]] Draft problem(const Draft& base, std::size_t scene,
                              const std::vector<SweepValue>& values,
                              Findings& findings) const;

 private:
  /// Number of the value of an entry in a scene.
  [[nodiscard]] std::size_t index(std::size_t entry, std::size_t scene) const;

  SweepSection section_;
  SweepNames names_;
  std::vector<std::size_t> strides_;     ///< scenes per value of each entry
  std::vector<std::size_t> quantities_;  ///< what each entry is, if anything
  std::size_t size_ = 1;
};

/// A value as a problem file would have it: a number with all its digits.
[[nodiscard]] std::string text_of(const SweepValue& value);

}  // namespace brachisto::io
