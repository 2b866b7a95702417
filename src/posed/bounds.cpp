// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "posed/bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "brachisto/math/index.hpp"
#include "posed/guess.hpp"

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

double left_by_bounds(const nlp::Problem& program, const PrimalDual& point) {
  double sum = 0.0;
  for (int i = 0; i < program.num_variables(); ++i) {
    const nlp::Range range = program.variable_range(i);
    if (range.single()) continue;
    if (!point.z_lower.empty() && std::isfinite(range.lower)) {
      sum += std::abs(point.z_lower[at(i)] * (point.x[at(i)] - range.lower));
    }
    if (!point.z_upper.empty() && std::isfinite(range.upper)) {
      sum += std::abs(point.z_upper[at(i)] * (range.upper - point.x[at(i)]));
    }
  }
  return sum;
}

void put_prices(const Posed& problem, nlp::Problem& program,
                const MeshPath& path, const PrimalDual& point, Answer& answer) {
  const Statement& said = problem.statement();
  const std::size_t states = said.states.size() + said.parameters.size();
  const Layout& layout = path.layout();
  const std::vector<long double> slope =
      nlp::lagrangian_gradient(program, point.lambda);
  const auto by = [&](int index, double scale) {
    return program.variable_range(index).single()
               ? static_cast<double>(slope[at(index)]) / scale
               : std::numeric_limits<double>::quiet_NaN();
  };
  answer.by_start.clear();
  answer.by_end.clear();
  answer.prices.clear();
  for (std::size_t s = 0; s < said.states.size(); ++s) {
    const double scale = problem.scales()[s];
    const int state = static_cast<int>(s);
    answer.by_start.push_back(by(layout.state(0, state), scale));
    answer.by_end.push_back(
        by(layout.state(layout.num_points(), state), scale));
  }
  answer.by_duration = by(layout.last(), 1.0);
  const auto put = [&](const std::string& name, double lower, double upper) {
    if (lower != 0.0 || upper != 0.0) {
      answer.prices.push_back({name, lower, upper});
    }
  };
  for (std::size_t i = 0; i < states + said.controls.size(); ++i) {
    double lower = 0.0, upper = 0.0;
    const bool is_state = i < states;
    for (int c = is_state ? -1 : 0; c < layout.num_points(); ++c) {
      const int index = is_state
                            ? layout.state(c + 1, static_cast<int>(i))
                            : layout.control(c, static_cast<int>(i - states));
      if (program.variable_range(index).single()) continue;
      const double h =
          is_state ? 1.0 : path.mesh().length(c / path.mesh().degree);
      const double share = h / problem.scales()[i];
      if (!point.z_lower.empty()) lower += share * point.z_lower[at(index)];
      if (!point.z_upper.empty()) upper -= share * point.z_upper[at(index)];
    }
    put(variable(said, i).name, lower, upper);
  }
  const auto put_rows = [&](const std::string& name, auto&& rows) {
    double lower = 0.0, upper = 0.0;
    for (const int row : rows) {
      const double value = -point.lambda[at(row)];
      (value > 0.0 ? lower : upper) += value;
    }
    put(name, lower, upper);
  };
  for (std::size_t i = 0; i < said.limits.size(); ++i) {
    std::vector<int> rows;
    for (int c = 0; c < layout.num_points(); ++c) {
      rows.push_back(layout.limit(c, static_cast<int>(i)));
    }
    put_rows(said.limits[i].name, rows);
  }
  for (std::size_t i = 0; i < said.end_conditions.size(); ++i) {
    put_rows(said.end_conditions[i].name,
             std::vector{layout.end_of_points() + static_cast<int>(i)});
  }
}

}  // namespace brachisto::ocp
