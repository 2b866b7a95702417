// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "app/exit_code.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/terminal.hpp"
#include "brachisto/report/result.hpp"

namespace brachisto::app {

namespace {

/// Of a design no less than one of its bodies, which may have to do with less
/// grip than their tracks ask for.
bool can_run(const Solution& solution, const DesignAnswer* design) {
  if (!solution.feasible()) return false;
  return design == nullptr || design->best ||
         std::ranges::any_of(design->minima, &DesignMinimum::feasible);
}

}  // namespace

int exit_code(const Solution& solution, int signal,
              const DesignAnswer* design) {
  switch (solution.status) {
    case Status::Solved:
      if (design != nullptr && design->stopped) return kLimit;
      if (!solution.verified()) return kNotSolved;
      return can_run(solution, design) ? kSuccess : kInfeasible;
    case Status::IterationLimit:
    case Status::TimeLimit:
    case Status::OutOfMemory:
      return kLimit;
    case Status::Interrupted:
      return kSignalBase + signal;
    case Status::InternalError:
      return kInternalError;
    case Status::NotConverged:
    case Status::NotEvaluable:
    case Status::NoAdmissiblePath:
    case Status::NotReached:
    case Status::NoSmoothContact:
    case Status::NoFastestTrack:
    case Status::Infeasible:
    case Status::Stalled:
      return kNotSolved;
  }
  return kInternalError;
}

std::string failure_document(std::string_view status, std::string_view message,
                             const io::InputError* input) {
  nlohmann::ordered_json document = {{"schema_version", report::kSchemaVersion},
                                     {"status", status},
                                     {"verified", false},
                                     {"message", message}};
  if (input != nullptr) {
    for (const io::Diagnostic& d : input->diagnostics()) {
      document["errors"].push_back({{"file", d.file},
                                    {"line", d.line},
                                    {"column", d.column},
                                    {"key", d.key},
                                    {"message", d.message}});
    }
  }
  return json_text(document);
}

void tell_damage(const sweep::Store& store, std::string_view remedy) {
  if (!store.damage()) return;
  tell(fmt::format("{}\n{}", store.damage_text(), remedy));
}

int exit_code(const sweep::Store& store) {
  tell_damage(store);
  return store.damage() ? kIoError : kSuccess;
}

}  // namespace brachisto::app
