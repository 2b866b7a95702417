// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "posed/held.hpp"

#include <algorithm>

#include "brachisto/math/index.hpp"

namespace brachisto::ocp {

HeldAlong held_along(nlp::Problem& program, const PrimalDual& point,
                     const Mesh& mesh, const Layout& layout, double between) {
  // Where a multiplier vanishes along an arc an interior-point method leaves
  // the bound by the root of its barrier parameter, and takes it for free: what
  // lies as near as that between two places where the bound holds is held too.
  constexpr double kThere = 1e-6;
  const nlp::ActiveSet active = nlp::active_set(program, point);
  std::vector<double> g(at(program.num_constraints()));
  program.eval_g(g);
  const int points = layout.num_points();
  const int variables = layout.num_states() + layout.num_controls();
  HeldAlong out(at(points),
                std::vector<nlp::Held>(at(variables + layout.num_limits()),
                                       nlp::Held::No));
  for (int i = 0; i < variables + layout.num_limits(); ++i) {
    int last = -1;  // the last point that was held, with near ones behind it
    for (int c = 0; c < points; ++c) {
      const bool is_limit = i >= variables, is_state = i < layout.num_states();
      const int index = is_limit   ? layout.limit(c, i - variables)
                        : is_state ? layout.state(c + 1, i)
                                   : layout.control(c, i - layout.num_states());
      const nlp::Range range = is_limit ? program.constraint_range(index)
                                        : program.variable_range(index);
      if (range.single()) continue;
      const double value = is_limit ? g[at(index)] : point.x[at(index)];
      const double size =
          is_limit || is_state ? 1.0 : mesh.length(c / mesh.degree);
      const double above = (value - range.lower) / size,
                   below = (range.upper - value) / size;
      nlp::Held held = is_limit ? active.constraints[at(index)]
                                : active.variables[at(index)];
      if (above < kThere) held = nlp::Held::AtLower;
      if (below < kThere) held = nlp::Held::AtUpper;
      if (held != nlp::Held::No) {
        out[at(c)][at(i)] = held;
        for (int k = last + 1; last >= 0 && k < c; ++k) {
          if (out[at(last)][at(i)] == held) out[at(k)][at(i)] = held;
        }
        last = c;
      } else if (std::min(above, below) > between) {
        last = -1;
      }
    }
  }
  return out;
}

}  // namespace brachisto::ocp
