// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "support/criterion.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <optional>
#include <stdexcept>

#include "support/text.hpp"

namespace brachisto::benchmarks {

namespace {

using enum Criterion::Kind;

/// The rest of `line` after `prefix`, or nothing.
std::optional<std::string> after(const std::string& line,
                                 std::string_view prefix) {
  if (!line.starts_with(prefix)) return std::nullopt;
  return line.substr(prefix.size());
}

Criterion parse(const std::string& text) {
  Criterion criterion;
  if (text == "verified") return criterion;
  if (const auto number = after(text, "tau = ")) {
    criterion.kind = Tau;
    criterion.tau = std::stod(*number);
    const std::size_t point = number->find('.');
    const auto digits = point == std::string::npos
                            ? 0.0
                            : static_cast<double>(number->size() - point - 1);
    criterion.half_unit = 0.5 * std::pow(10.0, -digits);
    return criterion;
  }
  const auto with_text = [&](Criterion::Kind kind, std::string_view prefix) {
    const auto rest = after(text, prefix);
    if (!rest) return false;
    criterion.kind = kind;
    criterion.text = *rest;
    return true;
  };
  if (with_text(Infeasible, "infeasible: ") ||
      with_text(NotVerified, "not verified: ") ||
      with_text(Refused, "refused: ")) {
    return criterion;
  }
  throw std::runtime_error("unknown pass criterion: " + text);
}

bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

}  // namespace

Intent read_intent(const std::string& path) {
  std::ifstream file(path);
  Intent intent;
  std::string line;
  bool cold_start = false;
  while (std::getline(file, line) && line.starts_with('#')) {
    if (const auto why = after(line, "# Why: ")) intent.why = *why;
    if (const auto pass = after(line, "# Pass: ")) intent.pass = *pass;
    if (line == "# Cold start: principal") cold_start = true;
  }
  if (intent.why.empty() || intent.pass.empty()) {
    throw std::runtime_error(path + ": no \"# Why: …\" and \"# Pass: …\"");
  }
  intent.criterion = parse(intent.pass);
  intent.criterion.cold_start = cold_start;
  return intent;
}

std::string objection(const Criterion& criterion, const Solution& solution) {
  if (criterion.kind == Refused) {
    if (solution.status == Status::Solved) return "solved";
    return objection(criterion, solution.message);
  }
  if (criterion.kind == NotVerified) {
    if (solution.verified()) return "verified";
    if (solution.status != Status::Solved) return solution.message;
    const Check* check = solution.certificate.find(criterion.text);
    const bool failed = check != nullptr && !check->passed;
    return failed ? "" : why_not_verified(solution);
  }
  if (!solution.verified()) return why_not_verified(solution);
  if (criterion.cold_start &&
      !(solution.cold_start && solution.cold_start->principal)) {
    return "the cold start led elsewhere";
  }
  if (criterion.kind == Tau) {
    const double tau = solution.motion()->tau();
    const double allowed = criterion.half_unit * 1.001 +
                           solution.estimated_error.value_or(0) * tau;
    if (std::abs(tau - criterion.tau) > allowed) {
      return fmt::format("τ = {:.12g}", tau);
    }
  }
  if (criterion.kind == Infeasible) {
    for (const std::string& reason : solution.infeasible_because()) {
      if (contains(reason, criterion.text)) return {};
    }
    return "not infeasible for that reason";
  }
  return {};
}

std::string objection(const Criterion& criterion, std::string_view refusal) {
  const bool wanted =
      criterion.kind == Refused && contains(refusal, criterion.text);
  return wanted ? "" : std::string(refusal);
}

}  // namespace brachisto::benchmarks
