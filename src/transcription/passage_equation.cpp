// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "transcription/passage_equation.hpp"

#include <array>

#include "brachisto/math/index.hpp"
#include "brachisto/math/jet.hpp"
#include "model/field.hpp"

namespace brachisto {

nlp::TangencyCondition::Linearisation height_at_beginning(
    const RollingTime& problem, int element, std::span<const double> x) {
  using Jet = math::Jet1<double, 3>;
  const VariableLayout& layout = problem.layout();
  const int node = element * problem.mesh().degree;
  nlp::TangencyCondition::Linearisation out;
  std::array<Jet, 3> y;  // x, z and θ
  for (int i = 0; i < 3; ++i) {
    if (!layout.has_state(i)) continue;
    out.by_x.index.push_back(layout.state(node, i));
    y[at(i)] = Jet::variable(x[at(out.by_x.index.back())], i);
  }
  const Jet h = height_of_mass(problem.scene(), y[0], y[1], y[2]);
  out.residual = h.value;
  for (std::size_t i = 0; i < out.by_x.index.size(); ++i) {
    out.by_x.value.push_back(h.gradient[i]);
  }
  return out;
}

}  // namespace brachisto
