// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/turn_meshes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "brachisto/math/index.hpp"
#include "brachisto/run/solve_options.hpp"
#include "math/roots.hpp"

namespace brachisto {

namespace {

// The continuation only has to tell branches apart; degree 5 with this many
// elements per turn of the body keeps its τ right to six digits or so.
constexpr int kCoarseDegree = 5;
constexpr double kCoarseElementsPerTurn = 7.0;
constexpr int kFewestCoarseElements = 8;
// On equal parts of turns fewer do: equal parts of the rolling time are longest
// where the body is fastest.
constexpr double kMany = 20.0;
constexpr double kEqualElementsPerTurn = 5.0;
// Where an extremal is sampled instead of solved for, there have to be enough
// elements to represent it.
constexpr double kSampledElementsPerTurn = 12.0;
constexpr double kFineElementsPerTurn = 16.0;
// Polynomials of degree 8 miss a sine over a quarter of a turn by 2 J₉(π/4)
// = 1e-9, and over half of one, which halves of σ leave of some elements that
// begin slowly, by 6e-7; what follows, superconvergent, by about the square.
constexpr double kLongestTurn = 0.25;
constexpr int kResolvingDegree = 8, kMostResolvingElements = 10000;

/// Elements for so many turns, the half turn for the stretch at the start.
int elements_for(double turns, double per_turn) {
  return std::max(kFewestCoarseElements,
                  static_cast<int>(std::ceil(per_turn * (turns + 0.5))));
}

/// Whether they matter or not.
double all_turns(const Body& body, double s) {
  return s / (2.0 * std::numbers::pi * body.radius);
}
/// Whether turns matter to how a path changes with an offset, and not to it.
bool turns_are_hidden(const Body& body) {
  return body.rolls() && !body.off_centred();
}

}  // namespace

double turns(const Body& body, double s) {
  return body.off_centred() ? all_turns(body, s) : 0.0;
}

bool are_many(double turns) {
  return turns > kMany;
}

Mesh coarse_mesh(const Scene& scene, const CycloidArc& arc) {
  const double number = turns(scene.body, arc.arc_length(arc.psi_end));
  return uniform_mesh(
      kCoarseDegree,
      elements_for(number, are_many(number) ? kEqualElementsPerTurn
                                            : kCoarseElementsPerTurn));
}

Mesh mesh_of_equal_turns(const RollingTime& problem,
                         std::span<const double> x) {
  const Mesh& mesh = problem.mesh();
  const auto theta = [&](int node) {
    return x[at(problem.layout().state(node, StateComponent::Theta))];
  };
  const int p = mesh.degree;
  const int count = mesh.num_elements();
  const double first = theta(0);
  const double whole = theta(count * p) - first;
  Mesh out{p, {0.0}};
  std::vector<double> basis(at(p + 1));
  int e = 0;
  for (int i = 1; i < count; ++i) {
    const double goal = first + whole * i / count;
    while (e + 1 < count && theta((e + 1) * p) < goal) ++e;
    const auto short_of_goal = [&](double t) {
      problem.scheme().nodes.evaluate(t, basis);
      double value = -goal;
      for (int n = 0; n <= p; ++n) value += basis[at(n)] * theta(e * p + n);
      return value;
    };
    const double t =
        math::find_root(short_of_goal, 0.0, 1.0, theta(e * p) - goal,
                        theta((e + 1) * p) - goal);
    out.boundaries.push_back(mesh.sigma(e, t));
  }
  out.boundaries.push_back(1.0);
  return out;
}

Mesh sampled_mesh(const Body& body, double length) {
  return uniform_mesh(kCoarseDegree, elements_for(turns(body, length),
                                                  kSampledElementsPerTurn));
}

Mesh fine_mesh(const Body& body, double length) {
  return uniform_mesh(kMaxDegree,
                      elements_for(turns(body, length), kFineElementsPerTurn));
}

std::optional<TurnsResolved> resolve_turns(const Body& body, double longest,
                                           int elements) {
  TurnsResolved out;
  if (!turns_are_hidden(body)) return out;
  out.degree = kResolvingDegree;
  for (double turn = all_turns(body, longest); turn > kLongestTurn;
       turn *= 0.5) {
    ++out.halvings;
    if ((elements *= 2) > kMostResolvingElements) return std::nullopt;
  }
  return out;
}

double most_resolving_nodes(const Body& body, double length) {
  if (!turns_are_hidden(body)) return 0.0;
  // Halved once too often, at the most.
  const double elements = all_turns(body, length) / (0.5 * kLongestTurn);
  return kResolvingDegree * std::min(elements, 1.0 * kMostResolvingElements);
}

}  // namespace brachisto
