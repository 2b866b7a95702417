// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/ocp/program.hpp"

#include <algorithm>
#include <cmath>

#include "brachisto/math/clock.hpp"
#include "brachisto/math/index.hpp"

namespace brachisto::ocp {

nlp::ChainStructure element_chain(const Layout& layout, const Mesh& mesh,
                                  int num_constraints) {
  nlp::ChainStructure chain;
  chain.num_links = mesh.num_elements();
  const int n = layout.num_variables();
  chain.block.resize(at(n + num_constraints));
  const auto fill = [&](int begin, int end, int block) {
    std::fill(chain.block.begin() + begin, chain.block.begin() + end, block);
  };
  const int p = mesh.degree;
  const int states = layout.num_states();
  for (int element = 0; element < chain.num_links; ++element) {
    check_stop(element);
    const int left = 2 * element, interior = left + 1, right = left + 2;
    for (int j = 0; j < p; ++j) {
      // A point, the node with which it stands and the one to which it leads.
      const int point = element * p + j;
      const int node = layout.state(point, 0);
      const bool unknown = point >= layout.node_of(0);
      if (unknown) fill(node, node + states, j == 0 ? left : interior);
      fill(node + states, layout.state(point + 1, 0), interior);
      fill(n + layout.defect(point, 0), n + layout.defect(point + 1, 0),
           j == p - 1 ? right : interior);
    }
  }
  fill(layout.state(layout.num_points(), 0), layout.last(),
       2 * chain.num_links);
  chain.block[at(layout.last())] = nlp::ChainStructure::kBorder;
  return chain;
}

nlp::ChainStructure element_chain(const Layout& layout, const Mesh& mesh,
                                  int num_constraints,
                                  const std::vector<bool>& of_control) {
  nlp::ChainStructure chain = element_chain(layout, mesh, num_constraints);
  chain.scale.assign(chain.block.size(), 1.0);
  const int n = layout.num_variables();
  const int p = mesh.degree;
  // On elements much shorter than others defects and limits of states count for
  // more: where a limit holds the place, the pivots of its defects are what the
  // slope moves it by, like h, and would pass for rounding of the longer ones.
  constexpr double kNotShort = 1e-3, kMost = 8192.0;
  double longest = 0.0;
  for (int element = 0; element < mesh.num_elements(); ++element) {
    longest = std::max(longest, mesh.length(element));
  }
  longest = std::min(longest, kNotShort);
  for (int c = 0; c < layout.num_points(); ++c) {
    const int element = c / p;
    const bool last = c % p == p - 1;
    const double root = root_of_length(mesh, element);
    const double lift = std::exp2(
        std::round(std::log2(std::clamp(longest / (root * root), 1.0, kMost))));
    for (int i = 0; i < layout.num_states(); ++i) {
      chain.scale[at(layout.state(c + 1, 0) + i)] = 1.0 / root;
      if (c == 0) chain.scale[at(i)] = 1.0 / root;
      chain.scale[at(n + layout.defect(c, 0) + i)] = lift * root;
    }
    const int block = last ? 2 * (element + 1) : 2 * element + 1;
    for (int k = 0; k < layout.num_controls(); ++k) {
      chain.scale[at(layout.control(c, k))] = 1.0 / root;
      if (last) chain.block[at(layout.control(c, k))] = block;
    }
    for (int i = 0; i < layout.num_limits(); ++i) {
      const std::size_t row = at(n + layout.limit(c, i));
      chain.block[row] = block;
      // By the unknown h u of the control a limit of the control has a
      // derivative like 1/h, one of a state that the control drives one like 1,
      // and one of states driven by that, as the place is by the slope, one
      // like h: on short elements the pivots that hold it would pass for
      // rounding.
      constexpr double kShort = 1e-4;
      chain.scale[row] = of_control[at(i)]
                             ? root * root * root
                             : root * std::max(lift, kShort / (root * root));
    }
  }
  return chain;
}

double root_of_length(const Mesh& mesh, int element) {
  return std::exp2(std::round(0.5 * std::log2(mesh.length(element))));
}

double element_weight(const Layout& layout, const CollocationScheme& scheme,
                      const Mesh& mesh, int index) {
  const auto of_point = [&](int c, bool by_length) {
    const double b = scheme.rule.weights[at(c % scheme.degree)];
    return by_length ? b * mesh.length(c / scheme.degree) : b;
  };
  if (index == layout.last()) return 1.0;
  if (index < layout.last()) {
    const int node = layout.node_of(index);
    return layout.is_state(index) ? of_point(std::max(node - 1, 0), true)
                                  : of_point(node, false);
  }
  const int row = index - layout.num_variables();
  if (row >= layout.end_of_points()) return 1.0;
  return of_point(layout.point_of(row), layout.limit_of(row) >= 0);
}

}  // namespace brachisto::ocp
