// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "support/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace brachisto::benchmarks {

std::string_view word(ExtremalStatus status) {
  switch (status) {
    case ExtremalStatus::Solved:
      return "solved";
    case ExtremalStatus::AccuracyNotReached:
      return "accuracy_not_reached";
    case ExtremalStatus::NoCycloid:
      return "no_cycloid";
    case ExtremalStatus::BranchTurnsBack:
      return "branch_turns_back";
    case ExtremalStatus::StepTooSmall:
      return "step_too_small";
    case ExtremalStatus::NewtonFailed:
      return "newton_failed";
    case ExtremalStatus::BadGuess:
      return "bad_guess";
    case ExtremalStatus::Loop:
      return "loop";
    case ExtremalStatus::Stalls:
      return "stalls";
    case ExtremalStatus::NotMinimal:
      return "not_minimal";
    case ExtremalStatus::TimeLimit:
      return "time_limit";
    case ExtremalStatus::Interrupted:
      return "interrupted";
  }
  return "unknown";
}

std::vector<std::string> problem_files(const std::string& folder,
                                       std::string_view part) {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::filesystem::path& path = entry.path();
    if (path.extension() == ".yaml" &&
        path.filename().string().find(part) != std::string::npos) {
      files.push_back(path.string());
    }
  }
  std::ranges::sort(files);
  return files;
}

std::string failed_checks(const Certificate& certificate) {
  std::string text;
  for (const Check& check : certificate.checks) {
    if (check.passed) continue;
    if (!text.empty()) text += "; ";
    text += fmt::format("{} {:.2g} > {:.2g}", check.name, check.value,
                        check.threshold);
    if (!check.where.empty()) text += " (" + check.where + ")";
  }
  return text;
}

std::string why_not_verified(const Solution& solution) {
  if (solution.verified()) return {};
  if (solution.status != Status::Solved) return solution.message;
  return "failed checks: " + failed_checks(solution.certificate);
}

}  // namespace brachisto::benchmarks
