// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How the conditions of a collocation change with the lengths of its elements.

#pragma once

#include <cstddef>
#include <span>

#include "brachisto/math/index.hpp"
#include "brachisto/ocp/collocation.hpp"

namespace brachisto::ocp {

/// Adds rate times the derivative of ∇ₓL (n values), then g (m), by the length
/// h of an element. With v = h u the control's unknown, of each point
///
///     ∂L/∂h = U (b L̃ − λ·f̃) − Σ μ ∂c/∂u u/h,   f̃ = f − u ∂f/∂u, L̃ alike.
///
/// \param collocation  evaluated at x; its points are nodes
/// \param U            the duration in x
template <class Description>
void add_rates_by_length(const Collocation<Description>& collocation,
                         int element, double h, double U, double rate,
                         std::span<const double> x,
                         std::span<const double> lambda,
                         std::span<double> out) {
  using Jet = typename Collocation<Description>::Jet;
  constexpr int kControl = Collocation<Description>::kControl;
  const Layout& layout = collocation.layout();
  const CollocationScheme& scheme = collocation.scheme();
  const int n = layout.num_variables();
  for (int j = 0; j < scheme.degree; ++j) {
    const int c = element * scheme.degree + j;
    const double u = x[at(layout.control(c))] / h;
    const auto [cost, states] = collocation.second(c);
    const auto index = [&](int a) {
      return at(a == kControl ? layout.control(c) : layout.state(c + 1, a));
    };
    // By the unknown of a local one.
    const auto by_unknown = [&](int a) {
      return a == kControl ? 1.0 / h : 1.0;
    };
    // f̃ and its derivatives, a factor standing before it. Of a rate that is the
    // control, f − u ∂f/∂u is 0 without rounding.
    const auto add = [&](const Jet& f, double factor) {
      out[at(layout.last())] +=
          rate * factor * (f.value - u * f.gradient[kControl]);
      for (const int a : collocation.local().by_duration) {
        const double by_a = a == kControl ? 0.0 : f.gradient[at(a)];
        out[index(a)] += rate * U * factor *
                         (by_a - u * f.hessian[Jet::pair(kControl, a)]) *
                         by_unknown(a);
      }
    };
    add(cost, scheme.rule.weights[at(j)]);
    for (std::size_t s = 0; s < Description::kStates; ++s) {
      if (!layout.has_state(static_cast<int>(s))) continue;
      const int row = layout.defect(c, static_cast<int>(s));
      const Jet& f = states[s];
      add(f, -lambda[at(row)]);
      out[at(n + row)] -= rate * U * (f.value - u * f.gradient[kControl]);
    }
    for (int i = 0; i < layout.num_limits(); ++i) {
      const int row = layout.limit(c, i);
      const auto value = collocation.limit_at(c, i).template unpacked<Jet>();
      const double mu = rate * lambda[at(row)];
      out[at(n + row)] -= rate * (u / h) * value.gradient[kControl];
      for (const int a : collocation.local().limits[at(i)].by) {
        out[index(a)] -= mu * (u / h) * value.hessian[Jet::pair(kControl, a)] *
                         by_unknown(a);
      }
      out[index(kControl)] -= mu * value.gradient[kControl] / (h * h);
    }
  }
}

}  // namespace brachisto::ocp
