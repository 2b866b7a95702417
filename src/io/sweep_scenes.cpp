// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/sweep_scenes.hpp"

#include <fmt/format.h>

#include <utility>

#include "io/problem_reader.hpp"

namespace brachisto::io {

SweepScenes::SweepScenes(SweepSection section, SweepNames names)
    : section_(std::move(section)), names_(std::move(names)) {
  strides_.resize(section_.entries.size(), 1);
  for (auto axis = section_.axes.rbegin(); axis != section_.axes.rend();
       ++axis) {
    for (const std::size_t entry : axis->keys) strides_[entry] = size_;
    size_ *= axis->count;
  }
  for (const SweepEntry& entry : section_.entries) {
    quantities_.push_back(quantity_of_key(entry.spec->path));
  }
}

std::size_t SweepScenes::index(std::size_t entry, std::size_t scene) const {
  return scene / strides_[entry] % section_.entries[entry].count;
}

void SweepScenes::evaluate(std::size_t scene,
                           std::vector<SweepValue>& values) const {
  values.assign(section_.entries.size(), std::string());
  QuantityValues quantities = names_.fixed;
  for (const std::size_t i : names_.order) {
    try {
      values[i] = value_of(section_.entries[i], index(i, scene), quantities);
    } catch (const ExpressionError& error) {
      throw SweepValueError(i, error.what());
    }
    if (quantities_[i] < quantities.size()) {
      quantities[quantities_[i]] = std::get<double>(values[i]);
    }
  }
}

Position SweepScenes::position(std::size_t entry, std::size_t scene) const {
  const SweepEntry& swept = section_.entries[entry];
  return swept.positions.empty() ? swept.position
                                 : swept.positions[index(entry, scene)];
}

ProblemFile SweepScenes::problem(const ProblemFile& base, std::size_t scene,
                                 const std::vector<SweepValue>& values,
                                 Findings& findings) const {
  ProblemReader reader(findings, base);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Position where = position(i, scene);
    reader.read_value(
        *section_.entries[i].spec,
        {"", where,
         YamlValue::of(YamlValue::Kind::Scalar, where, text_of(values[i]))});
  }
  return reader.problem();
}

std::string text_of(const SweepValue& value) {
  const double* number = std::get_if<double>(&value);
  return number != nullptr ? fmt::format("{}", *number)
                           : std::get<std::string>(value);
}

}  // namespace brachisto::io
