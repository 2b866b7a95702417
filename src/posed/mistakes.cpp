// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "posed/mistakes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <vector>

#include "brachisto/math/index.hpp"
#include "posed/guess.hpp"

namespace brachisto::ocp {

namespace {

class Asking {
 public:
  explicit Asking(const Posed& problem)
      : problem_(problem),
        said_(problem.statement()),
        states_(said_.states.size() + said_.parameters.size()) {}

  /// Moved by itself a control changes something: along the guess, or off it,
  /// as what it is multiplied by may vanish there.
  void each_control_matters() const {
    const Mesh mesh = uniform_mesh(3, 5);
    const MeshPath path(mesh, problem_.layout(mesh), guess(problem_, mesh));
    std::vector<std::vector<double>> along, off;
    for (int c = 0; c < mesh.num_points(); ++c) {
      along.push_back(path.values(sigma(mesh, c)).point());
      off.emplace_back();
      for (std::size_t i = 0; i < problem_.scales().size(); ++i) {
        // Evenly spread, and no two variables alike.
        const double turns = (c + 1) * std::sqrt(static_cast<double>(i) + 1.5);
        off.back().push_back(within(i, turns - std::floor(turns)));
      }
    }
    for (std::size_t k = 0; k < said_.controls.size(); ++k) {
      const Variable& control = said_.controls[k];
      if (control.lower == control.upper) continue;
      if (may_change(along, states_ + k, false) ||
          may_change(off, states_ + k, true)) {
        continue;
      }
      refuse(
          fmt::format("nothing depends on {}: leave it out, or give it bounds "
                      "that are equal",
                      control.name));
    }
  }

  /// A limit that has one value at an end, whatever is not given there.
  void limits_hold_at_ends() const {
    for (const bool at_start : {true, false}) {
      for (std::size_t i = 0; i < said_.limits.size(); ++i) {
        const Limit& limit = said_.limits[i];
        const std::optional<double> value =
            given_value(at_start, 1 + states_ + i);
        if (!value) continue;
        const double by = std::max(limit.lower - *value, *value - limit.upper);
        constexpr double kRounding = 1e-9;
        if (by > kRounding * (1.0 + std::abs(*value))) {
          refuse(fmt::format(
              "{} is {:.6g} with the states given at the {}, not between its "
              "bounds {} and {}",
              limit.name, *value, at_start ? "start" : "end", limit.lower,
              limit.upper));
        }
      }
    }
  }

  [[noreturn]] void refuse(const std::string& text) const {
    throw std::invalid_argument(said_.name + ": " + text);
  }

 private:
  // Shares of a range, no three in a line with a likely function.
  static constexpr std::array kOther{0.137, 0.411, 0.873};

  /// A value of a variable, scaled.
  [[nodiscard]] double within(std::size_t i, double share) const {
    const Variable& one = variable(said_, i);
    const double scale = problem_.scales()[i];
    const double low = std::isfinite(one.lower)   ? one.lower
                       : std::isfinite(one.upper) ? one.upper - scale
                                                  : -scale;
    const double high = std::isfinite(one.upper) ? one.upper : low + 2 * scale;
    return (low + share * (high - low)) / scale;
  }
  /// Whether a formula changes with a variable at one of these places.
  ///
  /// \param unseen  what is said if a formula is finite at none of them
  [[nodiscard]] bool may_change(const std::vector<std::vector<double>>& places,
                                std::size_t i, bool unseen) const {
    std::vector<bool> seen(1 + states_ + said_.limits.size(), false);
    for (std::vector<double> yu : places) {
      const std::vector<double> before = formulas(problem_, yu);
      for (const double share : kOther) {
        yu[i] = within(i, share);
        const std::vector<double> behind = formulas(problem_, yu);
        for (std::size_t f = 0; f < behind.size(); ++f) {
          if (!std::isfinite(before[f]) && !std::isfinite(behind[f])) continue;
          if (before[f] != behind[f]) return true;
          seen[f] = true;
        }
      }
    }
    return unseen && std::ranges::count(seen, false) > 0;
  }
  [[nodiscard]] std::optional<double> given_value(bool at_start,
                                                  std::size_t formula) const {
    std::optional<double> value;
    for (const double share : kOther) {
      std::vector<double> yu;
      for (std::size_t i = 0; i < problem_.scales().size(); ++i) {
        const Variable& one = variable(said_, i);
        const std::optional<double>& given = at_start ? one.start : one.end;
        yu.push_back(given ? *given / problem_.scales()[i]
                           : within(i, i % 2 == 0 ? share : 1.0 - share));
      }
      const double here = formulas(problem_, yu)[formula];
      if (!std::isfinite(here) || (value && *value != here)) return {};
      value = here;
    }
    return value;
  }

  const Posed& problem_;
  const Statement& said_;
  std::size_t states_;
};

}  // namespace

void check(const Posed& problem, const SolveBy& by) {
  const Asking ask(problem);
  constexpr int kMostDegree = kLargestDegree - 1;
  if (!(by.tolerance > 0.0) || std::isinf(by.tolerance)) {
    ask.refuse(fmt::format("the tolerance, {}, is not positive", by.tolerance));
  }
  if (by.degree < 2 || by.degree > kMostDegree) {
    ask.refuse(fmt::format("the degree, {}, is not between 2 and {}", by.degree,
                           kMostDegree));
  }
  for (const auto& [value, name] :
       {std::pair(by.elements, "elements"),
        std::pair(by.most_elements, "most_elements"),
        std::pair(by.most_passes, "most_passes"),
        std::pair(by.most_iterations, "most_iterations")}) {
    if (value < 1)
      ask.refuse(fmt::format("{}, {}, is less than 1", name, value));
  }
  ask.each_control_matters();
  ask.limits_hold_at_ends();
}

std::string formula_name(const Statement& said, std::size_t i) {
  const std::size_t states = said.states.size() + said.parameters.size();
  return i == 0        ? "the cost's rate"
         : i <= states ? "the rate of " + variable(said, i - 1).name
                       : "the limit " + said.limits[i - 1 - states].name;
}

std::string not_finite(const Posed& problem, const MeshPath& path,
                       bool at_start) {
  const Statement& said = problem.statement();
  const int points = path.mesh().num_points();
  for (int c = at_start ? -1 : 0; c < points; ++c) {
    const double share = c < 0 ? 0.0 : sigma(path.mesh(), c);
    const std::vector<double> yu = path.values(share).point();
    const std::vector<double> out = formulas(problem, yu);
    for (std::size_t i = 0; i < out.size(); ++i) {
      if (std::isfinite(out[i])) continue;
      std::vector<std::string> where;
      for (std::size_t k = 0; k < yu.size(); ++k) {
        where.push_back(fmt::format("{} = {:.6g}", variable(said, k).name,
                                    yu[k] * problem.scales()[k]));
      }
      return fmt::format(
          "{} is not finite after {:.3g} % of the duration, where {}",
          formula_name(said, i), 100.0 * share, fmt::join(where, ", "));
    }
  }
  return {};
}

std::string not_smooth(const Posed& problem, const MeshPath& path) {
  const Statement& said = problem.statement();
  constexpr double kStep = 1e-9, kMuch = 1e-3;
  for (int c = 0; c < path.mesh().num_points(); ++c) {
    const double share = sigma(path.mesh(), c);
    std::vector<double> yu = path.values(share).point();
    for (std::size_t i = 0; i < yu.size(); ++i) {
      const double here = yu[i];
      yu[i] = here - kStep;
      const std::vector<double> left = formulas(problem, yu);
      yu[i] = here + kStep;
      const std::vector<double> right = formulas(problem, yu);
      yu[i] = here;
      for (std::size_t k = 0; k < left.size(); ++k) {
        if (std::abs(right[k] - left[k]) <= kMuch * (1.0 + std::abs(left[k]))) {
          continue;
        }
        return fmt::format(
            "{} jumps or has no derivative after {:.3g} % of the duration, at "
            "{} = {:.6g}: formulas have to be smooth",
            formula_name(said, k), 100.0 * share, variable(said, i).name,
            here * problem.scales()[i]);
      }
    }
  }
  return {};
}

std::string turned(const Posed& problem, const MeshPath& path) {
  const Statement& said = problem.statement();
  const int states = path.layout().num_states();
  constexpr double kTurn = 2.0 * std::numbers::pi, kNear = 0.1, kSame = 1e-9;
  for (int c = 0; c + 1 < path.mesh().num_points(); ++c) {
    std::vector<double> yu = path.values(sigma(path.mesh(), c)).point();
    const PathValues next = path.values(sigma(path.mesh(), c + 1));
    for (std::size_t k = 0; k < said.controls.size(); ++k) {
      double& here = yu[at(states) + k];
      const double scale = problem.scales()[at(states) + k];
      const double turns =
          std::round((next.controls[k] - here) * scale / kTurn);
      const double rest = next.controls[k] - here - turns * kTurn / scale;
      if (turns == 0.0 || std::abs(rest) * scale > kNear * kTurn) continue;
      const std::vector<double> before = formulas(problem, yu);
      const double first = here;
      here += turns * kTurn / scale;
      const std::vector<double> behind = formulas(problem, yu);
      here = first;
      const bool same =
          std::ranges::equal(before, behind, [](double a, double b) {
            return std::abs(a - b) <= kSame * (1.0 + std::abs(a));
          });
      if (!same) continue;
      return fmt::format(
          "from t = {:.4g} to the next point {} turns once more: bound it, "
          "guess it nearer, or write a direction as two controls with the "
          "limit c² + s² = 1",
          sigma(path.mesh(), c) * path.duration(), said.controls[k].name);
    }
  }
  return {};
}

std::string size_hint(const Statement& said,
                      const std::vector<double>& scales) {
  constexpr double kMany = 100.0;
  std::vector<std::string> names;
  double most = 1.0;
  for (std::size_t i = 0; i < scales.size(); ++i) {
    if (!size_of(variable(said, i))) names.push_back(variable(said, i).name);
    most = std::max({most, scales[i], 1.0 / scales[i]});
  }
  if (names.empty() || most < kMany) return {};
  return fmt::format(
      "; nothing tells the size of {}: give bounds, a guess or a scale",
      fmt::join(names, " and "));
}

}  // namespace brachisto::ocp
