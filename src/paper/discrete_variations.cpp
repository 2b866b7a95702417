// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "paper/discrete_variations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "model/cycloid.hpp"
#include "model/units.hpp"
#include "paper/chord_jets.hpp"
#include "paper/chord_time.hpp"
#include "paper/layout.hpp"

namespace brachisto {

using namespace paper;

namespace {

using Datum = DiscreteReading::Datum;

/// The path with one node moved vertically, and its transit time.
class Path {
 public:
  Path(const Unknowns& unknowns, const Roller& roller, Datum datum)
      : u_(unknowns),
        roller_(roller),
        from_rest_(datum != Datum::Printed),
        zero_level_(datum == Datum::Release ? u_.z(0) : 0.0),
        theta_(at(u_.n), roller.body.theta_m) {
    for (int i = 0; i + 1 < u_.n; ++i) {
      theta_[at(i + 1)] =
          theta_[at(i)] + roller.turns * chord_length(u_.dx(i), u_.dz(i));
    }
  }

  /// Time of all chords from number `first` on, of the path whose node `moved`
  /// lies lower by `by`.
  [[nodiscard]] double time_from(int first, int moved, double by) const {
    double theta = theta_[at(first)];
    NodeState<double> left = state(first, drop(first), theta);
    double sum = 0.0;
    for (int i = first; i + 1 < u_.n; ++i) {
      const double below = drop(i + 1) + (i + 1 == moved ? by : 0.0);
      const double dx = u_.dx(i);
      const double l = chord_length(dx, below - left.drop);
      theta += roller_.turns * l;
      const NodeState<double> right = state(i + 1, below, theta);
      sum += chord_time(roller_, dx, l, left, right);
      left = right;
    }
    return sum;
  }

  [[nodiscard]] double energy(int node) const {
    return state(node, drop(node), theta_[at(node)]).energy;
  }

 private:
  [[nodiscard]] double drop(int node) const { return u_.z(node) - zero_level_; }
  [[nodiscard]] NodeState<double> state(int node, double below,
                                        double theta) const {
    return node_state(roller_, below, theta, from_rest_ && node == 0);
  }

  Unknowns u_;
  const Roller& roller_;
  bool from_rest_;
  double zero_level_;
  std::vector<double> theta_;
};

constexpr int kNone = -1;

/// (T(z_j + ε) − T(z_j − ε))/(2 ε), eq. (18). Chords before j − 1 do not move.
double central_difference(const Path& path, int node, double epsilon) {
  return (path.time_from(node - 1, node, epsilon) -
          path.time_from(node - 1, node, -epsilon)) /
         (2.0 * epsilon);
}

}  // namespace

DiscreteVariations::DiscreteVariations(const Scene& scene, int num_nodes,
                                       const DiscreteReading& reading)
    : scene_(in_units_of(scene.H, scene)),
      num_nodes_(num_nodes),
      reading_(reading) {
  if (num_nodes < 3 || !(reading.epsilon >= 0.0)) {
    throw std::invalid_argument(fmt::format(
        "the discrete system needs n ≥ 3 nodes and ε ≥ 0, not {} and {:g}",
        num_nodes, reading.epsilon));
  }
}

std::optional<std::vector<double>> DiscreteVariations::cycloid_guess() const {
  const std::optional<CycloidArc> arc = axisymmetric_optimum(scene_);
  if (!arc) return std::nullopt;
  const Columns column{num_nodes_};
  const double length = arc->arc_length(arc->psi_end);
  std::vector<double> u(at(num_unknowns()));
  for (int j = 0; j < num_nodes_; ++j) {
    const double s = length * j / (num_nodes_ - 1);
    // s = 4 a (1 − cos ψ/2) = 8 a sin² ψ/4.
    const double psi = 4.0 * std::asin(std::sqrt(s / (8.0 * arc->a)));
    const Point centre = arc->at(psi);
    u[at(column.x(j))] = centre.x;
    u[at(column.z(j))] = centre.z;
  }
  u[at(column.S())] = length;
  return u;
}

bool DiscreteVariations::residual(std::span<const double> unknowns,
                                  std::span<double> residual) const {
  const int n = num_nodes_;
  const Unknowns u{n, unknowns};
  const EquationRows row{n};
  const double r = contact_radius(scene_);
  const EndSlope start(reading_.slopes, u.dx(0), u.dz(0));
  const EndSlope end(reading_.slopes, u.dx(n - 2), u.dz(n - 2));
  residual[at(row.start_x())] = u.x(0) - r * start.sine;
  residual[at(row.start_z())] = u.z(0) + r * start.cosine;
  residual[at(row.end_x())] = u.x(n - 1) - r * end.sine - scene_.L;
  residual[at(row.end_z())] = u.z(n - 1) + r * end.cosine - scene_.H;
  for (int i = 0; i + 1 < n; ++i) {
    residual[at(row.chord(i))] =
        chord_length(u.dx(i), u.dz(i)) - u.S() / (n - 1);
  }
  if (reading_.epsilon > 0.0) {
    const Roller roller(scene_.body, reading_);
    const Path path(u, roller, reading_.datum);
    for (int j = 1; j + 1 < n; ++j) {
      residual[at(row.variation(j))] =
          central_difference(path, j, reading_.epsilon);
    }
  } else {
    const ChordJets jets(*this, unknowns);
    for (int j = 1; j + 1 < n; ++j) {
      residual[at(row.variation(j))] = jets.variation(j);
    }
  }
  return std::all_of(residual.begin(), residual.end(),
                     [](double value) { return std::isfinite(value); });
}

std::string DiscreteVariations::refusal(
    std::span<const double> unknowns) const {
  if (std::isfinite(tau(unknowns))) {
    return "the transit time is a number there, but not its derivatives (18)";
  }
  const Unknowns u{num_nodes_, unknowns};
  const Roller roller(scene_.body, reading_);
  const Path path(u, roller, reading_.datum);
  const int first = reading_.datum == Datum::Printed ? 0 : 1;
  for (int j = first; j < num_nodes_; ++j) {
    const double energy = path.energy(j);
    if (energy > 0.0) continue;
    return fmt::format(
        "the energy height is E = {:.3g} H at node {} of {}, so that the speed "
        "there is {}",
        energy, j + 1, num_nodes_, energy < 0.0 ? "no real number" : "zero");
  }
  return "the transit time is not a finite number";
}

double DiscreteVariations::tau(std::span<const double> unknowns) const {
  const Roller roller(scene_.body, reading_);
  return Path({num_nodes_, unknowns}, roller, reading_.datum)
      .time_from(0, kNone, 0.0);
}

}  // namespace brachisto
