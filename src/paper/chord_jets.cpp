// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "paper/chord_jets.hpp"

#include "paper/chord_time.hpp"
#include "paper/layout.hpp"

namespace brachisto::paper {

ChordJets::ChordJets(const DiscreteVariations& system,
                     std::span<const double> unknowns) {
  const Unknowns u{system.num_nodes(), unknowns};
  const Roller roller(system.scene().body, system.reading());
  const bool from_rest =
      system.reading().datum != DiscreteReading::Datum::Printed;
  const double zero_level =
      system.reading().datum == DiscreteReading::Datum::Release ? u.z(0) : 0.0;
  const int chords = u.n - 1;
  turns_ = roller.turns;
  time_.reserve(at(chords));
  length_.reserve(at(chords));
  double theta = roller.body.theta_m;
  for (int i = 0; i < chords; ++i) {
    const auto dx = ChordJet::variable(u.dx(i), kDx);
    const auto left = ChordJet::variable(u.z(i) - zero_level, kLeftDrop);
    const auto right = ChordJet::variable(u.z(i + 1) - zero_level, kRightDrop);
    const ChordJet l = chord_length(dx, right - left);
    const auto theta_left = ChordJet::variable(theta, kLeftTheta);
    theta += turns_ * l.value;
    const auto theta_right = ChordJet::variable(theta, kRightTheta);
    time_.push_back(
        chord_time(roller, dx, l,
                   node_state(roller, left, theta_left, from_rest && i == 0),
                   node_state(roller, right, theta_right)));
    length_.push_back(l);
  }
  lambda_.assign(at(chords), 0.0);
  double lambda = 0.0;
  for (int i = chords - 1; i >= 0; --i) {
    lambda += time(i).gradient[kRightTheta];
    if (i + 1 < chords) lambda += time(i + 1).gradient[kLeftTheta];
    lambda_[at(i)] = lambda;
  }
}

double ChordJets::variation(int node) const {
  const int i = node - 1;
  const auto slope = [this](int chord, Local local) {
    return time(chord).gradient[local] +
           lambda(chord) * turns_ * length(chord).gradient[local];
  };
  return slope(i, kRightDrop) + slope(node, kLeftDrop);
}

}  // namespace brachisto::paper
