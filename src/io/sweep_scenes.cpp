// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/sweep_scenes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <utility>

#include "io/problem_reader.hpp"

namespace brachisto::io {

namespace {

class Resolver {
 public:
  Resolver(const SweepSection& section, const YamlValue& root,
           Findings& findings)
      : section_(section),
        root_(root),
        findings_(findings),
        states_(section.entries.size(), State::New) {}

  [[nodiscard]] std::optional<SweepNames> resolve() {
    for (std::size_t i = 0; i < states_.size(); ++i) visit(i);
    if (!good_) return std::nullopt;
    return std::move(names_);
  }

 private:
  enum class State { New, Open, Done };

  /// Puts an entry into the order, behind those it depends on.
  void visit(std::size_t i) {
    if (states_[i] == State::Done) return;
    if (states_[i] == State::Open) {
      refuse_circle(i);
      return;
    }
    states_[i] = State::Open;
    path_.push_back(i);
    for (const auto& [quantity, text] : names_in(section_.entries[i])) {
      const SweepEntry* other = section_.find(kQuantities[quantity].path);
      if (other == nullptr) {
        take_fixed(quantity, text, section_.entries[i]);
      } else {
        visit(static_cast<std::size_t>(other - section_.entries.data()));
      }
    }
    path_.pop_back();
    states_[i] = State::Done;
    names_.order.push_back(i);
  }

  /// The quantities that an entry names, each with the first text that does.
  [[nodiscard]] static std::vector<std::pair<std::size_t, std::string>>
  names_in(const SweepEntry& entry) {
    std::vector<std::pair<std::size_t, std::string>> names;
    for (const Expression* expression : expressions_of(entry.rule)) {
      for (const std::size_t quantity : expression->quantities()) {
        const bool known = std::ranges::any_of(
            names, [&](const auto& name) { return name.first == quantity; });
        if (!known) names.emplace_back(quantity, expression->text());
      }
    }
    return names;
  }

  void take_fixed(std::size_t quantity, const std::string& text,
                  const SweepEntry& user) {
    const KeySpec& spec = *find_key(kQuantities[quantity].path);
    const Entry* entry = find_entry(root_, spec.path);
    if (entry == nullptr && spec.fallback.empty()) {
      good_ = false;
      findings_.add(
          user.position, user.key,
          fmt::format("{} names {}, but {} has no value, neither "
                      "outside of the sweep nor in it",
                      in_quotes(text), kQuantities[quantity].name, spec.path));
      return;
    }
    try {
      names_.fixed[quantity] = entry == nullptr
                                   ? evaluate(spec.fallback, unit_of(spec))
                                   : evaluate(entry->value.text, unit_of(spec));
    } catch (const ExpressionError&) {
      good_ = false;  // reported where the value is read
    }
  }

  void refuse_circle(std::size_t i) {
    good_ = false;
    std::vector<std::string_view> circle;
    for (auto at = std::ranges::find(path_, i); at != path_.end(); ++at) {
      circle.push_back(section_.entries[*at].spec->path);
    }
    const SweepEntry& entry = section_.entries[i];
    circle.push_back(entry.spec->path);
    findings_.add(entry.position, entry.key,
                  fmt::format("its value depends on itself: {}",
                              fmt::join(circle, " needs ")));
  }

  const SweepSection& section_;
  const YamlValue& root_;
  Findings& findings_;
  std::vector<State> states_;
  std::vector<std::size_t> path_;  ///< the open entries
  SweepNames names_;
  bool good_ = true;
};

}  // namespace

std::optional<SweepNames> resolve_names(const SweepSection& section,
                                        const YamlValue& root,
                                        Findings& findings) {
  return Resolver(section, root, findings).resolve();
}

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

Draft SweepScenes::problem(const Draft& base, std::size_t scene,
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
