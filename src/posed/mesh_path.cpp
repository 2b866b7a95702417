// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "posed/mesh_path.hpp"

#include <algorithm>

#include "brachisto/math/index.hpp"

namespace brachisto::ocp {

std::vector<double> PathValues::point() const {
  std::vector<double> out = states;
  out.insert(out.end(), controls.begin(), controls.end());
  return out;
}

void keep_in_bounds(const Statement& statement,
                    const std::vector<double>& scales, PathValues& values) {
  for (std::size_t k = 0; k < values.controls.size(); ++k) {
    const double scale = scales[values.states.size() + k];
    values.controls[k] =
        std::clamp(values.controls[k], statement.controls[k].lower / scale,
                   statement.controls[k].upper / scale);
  }
}

double MeshPath::duration() const {
  return point_.x[at(layout_.last())];
}

double sigma(const Mesh& mesh, int point) {
  const CollocationScheme& scheme = radau_scheme(mesh.degree);
  return mesh.sigma(point / mesh.degree,
                    scheme.rule.points[at(point % mesh.degree)]);
}

PathValues MeshPath::values(int element, double t) const {
  const CollocationScheme& scheme = radau_scheme(mesh_.degree);
  const int p = mesh_.degree;
  const double h = mesh_.length(element);
  std::vector<double> node(at(p + 1)), slope(at(p + 1)), share(at(p));
  scheme.nodes.evaluate(t, node, slope);
  scheme.points.evaluate(t, share);
  PathValues out;
  for (int s = 0; s < layout_.num_states(); ++s) {
    double value = 0.0, rate = 0.0, costate = 0.0;
    for (int j = 0; j <= p; ++j) {
      const double y = point_.x[at(layout_.state(element * p + j, s))];
      value += node[at(j)] * y;
      rate += slope[at(j)] * y;
    }
    for (int j = 0; j < p && !point_.lambda.empty(); ++j) {
      costate -= share[at(j)] *
                 point_.lambda[at(layout_.defect(element * p + j, s))] /
                 scheme.rule.weights[at(j)];
    }
    out.states.push_back(value);
    out.slopes.push_back(rate / (h * duration()));
    out.costates.push_back(costate);
  }
  for (int k = 0; k < layout_.num_controls(); ++k) {
    double value = 0.0;
    for (int j = 0; j < p; ++j) {
      value +=
          share[at(j)] * point_.x[at(layout_.control(element * p + j, k))] / h;
    }
    out.controls.push_back(value);
  }
  return out;
}

PrimalDual MeshPath::on(const Mesh& mesh, const Layout& layout) const {
  PrimalDual out;
  out.x.assign(at(layout.num_variables()), 0.0);
  out.x[at(layout.last())] = duration();
  for (int node = 0; node < layout.num_nodes(); ++node) {
    const int c = node - 1;
    const PathValues here = values(node == 0 ? 0.0 : sigma(mesh, c));
    for (int s = 0; s < layout.num_states(); ++s) {
      out.x[at(layout.state(node, s))] = here.states[at(s)];
    }
    if (node == 0) continue;
    for (int k = 0; k < layout.num_controls(); ++k) {
      out.x[at(layout.control(c, k))] =
          here.controls[at(k)] * mesh.length(c / mesh.degree);
    }
  }
  return out;
}

}  // namespace brachisto::ocp
