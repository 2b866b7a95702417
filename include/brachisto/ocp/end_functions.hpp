// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What a description says of both ends of a path: a cost and conditions.

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "brachisto/math/index.hpp"
#include "brachisto/math/jet.hpp"
#include "brachisto/ocp/mesh.hpp"
#include "brachisto/ocp/point_function.hpp"
#include "brachisto/ocp/program.hpp"

namespace brachisto::ocp {

/// The states at both ends, and U.
template <class Scalar, std::size_t States>
struct EndPoints {
  std::array<Scalar, States> start, end;
  Scalar duration;
};

/// A description may have an `end_cost(ends)`, φ(y(0), y(U), U), and
/// `kEndConditions` values ψ_i of `end_conditions(ends)`, an array, with
/// `end_bounds(i)` and `end_name(i)`. Their rows stand behind those of points.
template <class Description>
class EndFunctions {
  static constexpr int kStates = static_cast<int>(Description::kStates);
  static constexpr int kLocals = 2 * kStates + 1;
  using Jet = math::Jet2<double, kLocals>;
  using On = math::Dependence<kLocals>;
  template <class Scalar>
  using EndsOf = EndPoints<Scalar, Description::kStates>;
  static constexpr bool kHasCost =
      requires(const Description& of, const EndsOf<double>& ends) {
    of.end_cost(ends);
  };
  static consteval int conditions() {
    if constexpr (requires { Description::kEndConditions; }) {
      return static_cast<int>(Description::kEndConditions);
    }
    return 0;
  }

 public:
  static constexpr int kConditions = conditions();

  EndFunctions(const Description& description, const Layout& layout)
      : layout_(layout), values_(at(kConditions + 1)) {
    if constexpr (kHasCost || kConditions > 0) {
      const std::vector<On> on = values_of(
          description, ends_of<On>([](int a) { return On::variable(a); }));
      for (const On& one : on) {
        std::vector<int> row;
        for (int a = 0; a < kLocals; ++a) {
          if (one.any[at(a)]) row.push_back(a);
          for (int b = 0; b <= a; ++b) {
            if (one.second[at(a)][at(b)]) pairs_.push_back({a, b});
          }
        }
        rows_.push_back(std::move(row));
      }
      std::ranges::sort(pairs_);
      const auto twice = std::ranges::unique(pairs_);
      pairs_.erase(twice.begin(), twice.end());
    }
  }

  /// Index of a condition's constraint.
  [[nodiscard]] int row(int condition) const {
    return layout_.end_of_points() + condition;
  }
  /// Whether a condition asks nothing of the end.
  [[nodiscard]] bool is_of_start(int condition) const {
    return std::ranges::none_of(rows_[at(condition + 1)], at_end);
  }
  /// Whether start and end occur together.
  [[nodiscard]] bool couple() const {
    for (int i = 0; i < kConditions; ++i) {
      const std::vector<int>& row = rows_[at(i + 1)];
      if (std::ranges::any_of(row, at_start) &&
          std::ranges::any_of(row, at_end)) {
        return true;
      }
    }
    return std::ranges::any_of(pairs_, [](const std::pair<int, int>& pair) {
      return at_end(pair.first) && at_start(pair.second);
    });
  }

  /// \return false if something is not finite
  [[nodiscard]] bool evaluate(const Description& description,
                              std::span<const double> x) {
    if constexpr (kHasCost || kConditions > 0) {
      values_ = values_of(description, ends_of<Jet>([&](int a) {
                            return Jet::variable(x[at(index(a))], a);
                          }));
    }
    return std::ranges::all_of(
        values_, [](const Jet& jet) { return std::isfinite(jet.value); });
  }

  [[nodiscard]] double cost() const { return values_.front().value; }
  void add_gradient(std::span<double> grad) const {
    if (!kHasCost) return;
    for (const int a : rows_.front()) {
      grad[at(index(a))] += values_.front().gradient[at(a)];
    }
  }
  void put_conditions(std::span<double> g) const {
    for (int i = 0; i < kConditions; ++i) {
      g[at(row(i))] = values_[at(i + 1)].value;
    }
  }
  void put_jac_g(Entries& put) const {
    for (int i = 0; i < kConditions; ++i) {
      for (const int a : rows_[at(i + 1)]) {
        put(row(i), index(a), values_[at(i + 1)].gradient[at(a)]);
      }
    }
  }
  void put_hess_lag(double objective_factor, std::span<const double> lambda,
                    Entries& put) const {
    for (const auto& [a, b] : pairs_) {
      const std::size_t pair = Jet::pair(a, b);
      double sum = objective_factor * values_.front().hessian[pair];
      for (int i = 0; i < kConditions; ++i) {
        sum += lambda[at(row(i))] * values_[at(i + 1)].hessian[pair];
      }
      const auto [low, high] = std::minmax({index(a), index(b)});
      put(high, low, sum);
    }
  }

 private:
  [[nodiscard]] static bool at_start(int local) { return local < kStates; }
  [[nodiscard]] static bool at_end(int local) {
    return local >= kStates && local < 2 * kStates;
  }
  [[nodiscard]] int index(int local) const {
    if (local == 2 * kStates) return layout_.last();
    return at_start(local)
               ? layout_.state(0, local)
               : layout_.state(layout_.num_points(), local - kStates);
  }
  template <class Scalar, class Of>
  [[nodiscard]] static EndsOf<Scalar> ends_of(Of&& of) {
    EndsOf<Scalar> ends;
    for (int s = 0; s < kStates; ++s) {
      ends.start[at(s)] = of(s);
      ends.end[at(s)] = of(kStates + s);
    }
    ends.duration = of(2 * kStates);
    return ends;
  }
  /// The cost, then the conditions.
  template <class Scalar>
  [[nodiscard]] static std::vector<Scalar> values_of(
      const Description& description, const EndsOf<Scalar>& ends) {
    std::vector<Scalar> out(1);
    if constexpr (kHasCost) out.front() = description.end_cost(ends);
    if constexpr (kConditions > 0) {
      for (const Scalar& value : description.end_conditions(ends)) {
        out.push_back(value);
      }
    }
    return out;
  }

  Layout layout_;
  std::vector<Jet> values_;                 ///< the cost, then the conditions
  std::vector<std::vector<int>> rows_;      ///< on what each depends
  std::vector<std::pair<int, int>> pairs_;  ///< of all, the larger first
};

}  // namespace brachisto::ocp
