// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "posed/guess.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "brachisto/math/index.hpp"

namespace brachisto::ocp {

const Variable& variable(const Statement& said, std::size_t i) {
  if (i < said.states.size()) return said.states[i];
  i -= said.states.size();
  if (i < said.parameters.size()) return said.parameters[i];
  return said.controls[i - said.parameters.size()];
}

std::vector<double> formulas(const Posed& problem,
                             const std::vector<double>& yu) {
  const Statement& said = problem.statement();
  std::vector<double> out(1 + said.states.size() + said.parameters.size() +
                          said.limits.size());
  problem.evaluate(yu, out);
  return out;
}

PrimalDual guess(const Posed& problem, const Mesh& mesh) {
  const Statement& said = problem.statement();
  const std::size_t states = said.states.size() + said.parameters.size();
  const Layout layout = problem.layout(mesh);
  PrimalDual out;
  out.x.assign(at(layout.num_variables()), 0.0);
  const Duration& duration = said.duration;
  out.x[at(layout.last())] =
      std::clamp(duration.guess, duration.lower, duration.upper);
  const auto value = [&](std::size_t i, double share) {
    const Variable& here = variable(said, i);
    double at_share = 0.0;
    if (here.guess.given()) {
      at_share = here.guess.at(share);
    } else if (here.start || here.end) {
      const double from = here.start ? *here.start : *here.end;
      at_share = from + share * (here.end.value_or(from) - from);
    } else if (std::isfinite(here.lower) && std::isfinite(here.upper)) {
      at_share = 0.5 * (here.lower + here.upper);
    }
    return std::clamp(at_share, here.lower, here.upper) / problem.scales()[i];
  };
  for (int node = 0; node < layout.num_nodes(); ++node) {
    const double share = node == 0 ? 0.0 : sigma(mesh, node - 1);
    for (std::size_t s = 0; s < states; ++s) {
      out.x[at(layout.state(node, static_cast<int>(s)))] = value(s, share);
    }
    if (node == 0) continue;
    const double h = mesh.length((node - 1) / mesh.degree);
    for (std::size_t k = 0; k < said.controls.size(); ++k) {
      out.x[at(layout.control(node - 1, static_cast<int>(k)))] =
          h * value(states + k, share);
    }
  }
  for (std::size_t s = 0; s < said.states.size(); ++s) {
    const int state = static_cast<int>(s);
    if (variable(said, s).start) {
      out.x[at(layout.state(0, state))] =
          *variable(said, s).start / problem.scales()[s];
    }
    if (variable(said, s).end) {
      out.x[at(layout.state(layout.num_points(), state))] =
          *variable(said, s).end / problem.scales()[s];
    }
  }
  return out;
}

}  // namespace brachisto::ocp
