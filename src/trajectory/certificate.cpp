// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/trajectory/motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace brachisto {

bool Certificate::verified() const {
  return !checks.empty() &&
         std::all_of(checks.begin(), checks.end(),
                     [](const Check& check) { return check.passed; });
}

const Check* Certificate::find(const std::string& name) const {
  const auto found =
      std::find_if(checks.begin(), checks.end(),
                   [&](const Check& check) { return check.name == name; });
  return found == checks.end() ? nullptr : &*found;
}

void Certificate::add(std::string name, double value, double threshold,
                      std::string where) {
  checks.push_back({std::move(name), value, threshold, std::move(where),
                    value <= threshold});
}

std::vector<std::string> not_verified_because(const Certificate& certificate) {
  std::vector<std::string> reasons;
  for (const Check& check : certificate.checks) {
    if (check.passed) continue;
    const std::string where =
        check.where.empty() ? "" : fmt::format(" ({})", check.where);
    reasons.push_back(
        std::isnan(check.value)
            ? fmt::format("{} cannot be measured{}", check.name, where)
        : std::isnan(check.threshold)
            ? fmt::format("{} is {:.3g}, and nothing is known of the error of "
                          "T that could justify it{}",
                          check.name, check.value, where)
            : fmt::format("{} is {:.3g}, more than {:.3g}{}", check.name,
                          check.value, check.threshold, where));
  }
  return reasons;
}

}  // namespace brachisto
