// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// On which states, and on what pairs of them, what a description says of a
/// point depends, the control counted as the last one.

#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "brachisto/math/dependence.hpp"
#include "brachisto/math/index.hpp"
#include "brachisto/math/jet2.hpp"
#include "brachisto/ocp/layout.hpp"
#include "brachisto/ocp/point_function.hpp"

namespace brachisto::ocp {

/// Read off the description's own text. What has no entry here is 0 wherever
/// the point is.
///
/// \tparam kLocals  states and the control
template <int kLocals>
struct LocalStructure {
  using On = math::Dependence<kLocals>;
  using Jet = math::Jet2<double, kLocals>;
  /// A derivative of the cost, 0, or of rate s, s + 1.
  struct Term {
    std::size_t of, where;
  };

  std::array<bool, kLocals> matters{};  ///< whether anything depends on it
  std::vector<std::vector<int>> rows;   ///< of the cost, then of each rate
  std::vector<std::vector<int>> limit_rows;
  std::vector<int> by_duration;            ///< of any of cost and rates
  std::vector<std::pair<int, int>> pairs;  ///< of anything, the larger first
  std::vector<Term> first_terms, second_terms;

  template <class Description>
  LocalStructure(const Description& description, const Layout& layout) {
    PointOf<Description, On> variables;
    for (int a = 0; a < kLocals; ++a) {
      if (a == kLocals - 1 || layout.has_state(a)) {
        variables[at(a)] = On::variable(a);
      }
    }
    On all;
    const auto rates = description.rates(variables);
    const auto see = [&](const On& on) {
      for (int a = 0; a < kLocals; ++a) {
        if (on.any[at(a)]) first_terms.push_back({rows.size(), at(a)});
        for (int b = 0; b <= a; ++b) {
          if (on.second[at(a)][at(b)]) {
            second_terms.push_back({rows.size(), Jet::pair(a, b)});
          }
        }
      }
      rows.push_back(members(on));
      all += on;
    };
    see(rates.cost);
    for (int s = 0; s + 1 < kLocals; ++s) {
      see(layout.has_state(s) ? rates.states[at(s)] : On());
    }
    by_duration = members(all);
    for (int i = 0; i < layout.num_limits(); ++i) {
      const On on = description.limit(at(i), variables);
      limit_rows.push_back(members(on));
      all += on;
    }
    for (int a = 0; a < kLocals; ++a) {
      matters[at(a)] = all.any[at(a)];
      for (int b = 0; b <= a; ++b) {
        if (all.second[at(a)][at(b)]) pairs.push_back({a, b});
      }
    }
  }

 private:
  [[nodiscard]] static std::vector<int> members(const On& on) {
    std::vector<int> out;
    for (int a = 0; a < kLocals; ++a) {
      if (on.any[at(a)]) out.push_back(a);
    }
    return out;
  }
};

}  // namespace brachisto::ocp
