// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/posed/statement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "brachisto/math/index.hpp"

namespace brachisto::ocp {

bool Guess::too_few() const {
  const auto* values = std::get_if<std::vector<double>>(&is_);
  return values != nullptr && values->size() < 2;
}

double Guess::at(double share) const {
  if (const double* value = std::get_if<double>(&is_)) return *value;
  if (const Function* function = std::get_if<Function>(&is_)) {
    return (*function)(share);
  }
  const std::vector<double>& values = std::get<std::vector<double>>(is_);
  if (too_few()) {
    throw std::invalid_argument("a guess by values has two of them or more");
  }
  const double place = share * static_cast<double>(values.size() - 1);
  const std::size_t left =
      std::min(values.size() - 2, static_cast<std::size_t>(place));
  const double t = place - static_cast<double>(left);
  return (1.0 - t) * values[left] + t * values[left + 1];
}

std::optional<double> size_of(const Variable& variable) {
  if (variable.scale > 0.0) return variable.scale;
  double size = 0.0;
  const auto see = [&](double value) {
    if (std::isfinite(value)) size = std::max(size, std::abs(value));
  };
  see(variable.lower);
  see(variable.upper);
  see(variable.start.value_or(0.0));
  see(variable.end.value_or(0.0));
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    if (variable.guess.given()) see(variable.guess.at(share));
  }
  return size > 0.0 ? std::optional(size) : std::nullopt;
}

std::vector<double> scales_of(const Statement& statement) {
  std::vector<double> out;
  for (const auto* group :
       {&statement.states, &statement.parameters, &statement.controls}) {
    for (const Variable& variable : *group) {
      out.push_back(
          std::exp2(std::round(std::log2(size_of(variable).value_or(1.0)))));
    }
  }
  return out;
}

namespace {

class Checker {
 public:
  explicit Checker(const Statement& statement) : said_(statement) {}

  /// \param kind  with its number, in words
  void operator()(const Variable& variable, const std::string& kind,
                  bool is_state) {
    named(variable.name, kind);
    printable(variable.unit, "the unit of " + variable.name);
    range(variable.name, variable.lower, variable.upper);
    if (!(variable.scale >= 0.0) || std::isinf(variable.scale)) {
      refuse("the scale of {} is not a positive number", variable.name);
    }
    for (const auto& [end, which] :
         {std::pair(variable.start, "start"), std::pair(variable.end, "end")}) {
      if (!end) continue;
      if (!is_state)
        refuse("{} is no state and has no {}", variable.name, which);
      if (!std::isfinite(*end)) {
        refuse("the {} of {} is not finite", which, variable.name);
      }
      if (*end < variable.lower || *end > variable.upper) {
        refuse("the {} of {}, {}, is not between its bounds {} and {}", which,
               variable.name, *end, variable.lower, variable.upper);
      }
    }
    if (!variable.guess.given()) return;
    if (variable.guess.too_few()) {
      refuse("the guess of {} has fewer than two values", variable.name);
    }
    for (int i = 0; i <= 100; ++i) {
      if (!std::isfinite(variable.guess.at(0.01 * i))) {
        refuse("the guess of {} is not finite after {} % of the duration",
               variable.name, i);
      }
    }
  }
  void operator()(const Limit& limit, const std::string& kind) {
    named(limit.name, kind);
    range(limit.name, limit.lower, limit.upper);
  }
  void range(const std::string& name, double lower, double upper) {
    if (std::isnan(lower) || std::isnan(upper)) {
      refuse("a bound of {} is not a number", name);
    }
    if (!(lower <= upper) || lower == kNoBound || upper == -kNoBound) {
      refuse("the bounds of {}, {} and {}, leave nothing between them", name,
             lower, upper);
    }
  }
  /// Texts stand in tables and pictures as they are.
  void printable(const std::string& text, const std::string& what) {
    if (text.find_first_of(",<>&\"\n") != std::string::npos) {
      refuse("{} holds one of , < > & \" or a new line", what);
    }
  }
  template <class... Values>
  [[noreturn]] void refuse(const char* text, const Values&... values) {
    throw std::invalid_argument(said_.name + ": " +
                                fmt::format(fmt::runtime(text), values...));
  }

 private:
  void named(const std::string& name, const std::string& what) {
    if (name.empty()) refuse("{} has no name", what);
    printable(name, "the name " + name);
    if (!names_.insert(name).second) refuse("two things are named {}", name);
  }

  const Statement& said_;
  std::set<std::string> names_;
};

}  // namespace

void check(const Statement& statement) {
  Checker check(statement);
  check.printable(statement.name, "this name");
  check.printable(statement.time_unit, "the unit of time");
  const auto each = [&](const auto& group, const char* kind,
                        const auto&... more) {
    for (std::size_t i = 0; i < group.size(); ++i) {
      check(group[i], fmt::format("{} {}", kind, i + 1), more...);
    }
  };
  each(statement.states, "state", true);
  each(statement.parameters, "parameter", false);
  each(statement.controls, "control", false);
  each(statement.limits, "limit");
  each(statement.end_conditions, "condition of the ends");
  const Duration& duration = statement.duration;
  check.range("the duration", duration.lower, duration.upper);
  if (!(duration.lower >= 0.0) || !(duration.upper > 0.0) ||
      (duration.lower == duration.upper && std::isinf(duration.upper)) ||
      !(duration.guess > 0.0) || std::isinf(duration.guess)) {
    check.refuse("the duration or its guess is not positive and finite");
  }
}

}  // namespace brachisto::ocp
