// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "proof/arc_system.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "extremal/arc_boundary.hpp"

namespace brachisto::proof {

namespace {

using Rows = std::vector<NodeRow>;

/// The numbers of a node as extremal/arc_boundary.hpp orders them.
::brachisto::arcs::Values<NodeRow> in_other_order(const NodeValues& y) {
  return {y[kX],  y[kZ],  y[kTheta],  y[kW],  y[kBeta],
          y[kPx], y[kPz], y[kPtheta], y[kPw], y[kPbeta]};
}

/// c − b and n·t of the boundary that begins.
void add_landing(const ::brachisto::arcs::HeldLimit& held, const NodeValues& y,
                 Rows& rows) {
  TurningPoint<NodeRow> place;
  place.x = y[kX];
  place.z = y[kZ];
  rows.push_back(value_of(held.limit, ContactForce<NodeRow>{}, place) -
                 NodeRow(held.bound));
  const auto n = rolling::normal_of(held.limit, y[kX], y[kZ]);
  rows.push_back(n.x * cos(y[kBeta]) + n.z * sin(y[kBeta]));
}

Rows rows_at_A(const Scene& own, const Held& held, const NodeValues& y) {
  const ::brachisto::arcs::Departure leave(own, held, 0.0);
  Rows rows = leave.conditions(in_other_order(y));
  const At<NodeRow> here = at(own, held, y);
  rows.push_back(here.hamiltonian);
  if (!held) {
    rows.push_back(y[kPbeta]);
    rows.push_back(here.by_slope);
  }
  return rows;
}

Rows rows_between(const Scene& own, const ArcChain& chain, std::size_t arc,
                  const NodeValues& y) {
  const Held &before = chain.arcs[arc - 1], &here = chain.arcs[arc];
  Rows rows;
  if (along_boundary(here)) add_landing(*here, y, rows);
  if (!along_bound(before)) return rows;
  if (!along_bound(here)) {
    rows.push_back(y[kPbeta]);
    rows.push_back(at(own, here, y).by_slope);
  } else if (chain.opposite[arc]) {
    rows.push_back(y[kPbeta]);
  } else {
    rows.push_back(value_of(here->limit, own, at(own, before, y).place) -
                   NodeRow(here->bound));
  }
  return rows;
}

/// z of B follows from a floor, if its numbers say exactly the same.
bool same_floor(const Scene& scene, const ::brachisto::arcs::HeldLimit& held) {
  if (held.limit.kind != PathInequality::Kind::Floor) return false;
  const Real off =
      Real(held.limit.number) - Real(scene.H) + Real(contact_radius(scene));
  return arb_is_zero(off.get()) != 0;
}

Rows rows_at_B(const Scene& own, const Held& held, const NodeValues& y) {
  Rows rows = ::brachisto::arcs::end_conditions(own, in_other_order(y),
                                                along_bound(held));
  if (along_boundary(held)) {
    if (!same_floor(own, *held)) {
      throw NotProven("B lies on a boundary only as far as its digits go");
    }
    rows.erase(rows.begin() + 1);
  }
  return rows;
}

}  // namespace

NodeConditions::NodeConditions(const Write& write) {
  const Tape::Recording recording(tape_);
  NodeValues y;
  for (std::size_t i = 0; i < kNode; ++i) {
    y[i] = NodeRow::variable(tape_.input(static_cast<int>(i)),
                             static_cast<int>(i));
  }
  rows_ = write(y);
}

std::vector<NodeConditions::Value> NodeConditions::at(const State& y) const {
  const std::vector<Real> values =
      tape_.values(State(y.begin(), y.begin() + kNode));
  const auto of = [&](const Node& node) {
    return values[static_cast<std::size_t>(node.id)];
  };
  std::vector<Value> out;
  for (const NodeRow& row : rows_) {
    Value& value = out.emplace_back();
    value.value = of(row.value);
    for (std::size_t j = 0; j < kNode; ++j) {
      value.gradient[j] = of(row.gradient[j]);
    }
  }
  return out;
}

/// What belongs to one arc.
struct ArcSystem::OfArc {
  /// Numbers of the node that directions belong to; on the others nothing
  /// depends but themselves.
  static std::vector<std::size_t> directions_of(const Scene& scene,
                                                const Held& held) {
    std::vector<std::size_t> out;
    const bool by_place = scene.world.field_varies() ||
                          (along_boundary(held) &&
                           held->limit.kind == PathInequality::Kind::Disc);
    for (std::size_t i = 0; i < kNode; ++i) {
      if (i == kPbeta && !along_bound(held) && !by_place) continue;
      if (by_place || (i != kX && i != kZ)) out.push_back(i);
    }
    return out;
  }

  OfArc(const Scene& scene, const Held& held,
        const NodeConditions::Write& write)
      : directions(directions_of(scene, held)),
        plain(scene, 0, held),
        sloped(scene, static_cast<int>(directions.size()), held),
        first(write) {}

  std::vector<std::size_t> directions;
  Equations plain, sloped;
  NodeConditions first;  ///< at its node
  std::unique_ptr<NodeConditions> normal;
};

ArcSystem::~ArcSystem() = default;

ArcSystem::ArcSystem(const ArcChain& chain) : chain_(chain) {
  const Scene own = in_own_units(chain.scene);
  std::size_t equations = 0;
  for (std::size_t a = 0; a < chain_.arcs.size(); ++a) {
    const Held& held = chain_.arcs[a];
    arcs_.push_back(
        std::make_unique<OfArc>(chain.scene, held, [&](const NodeValues& y) {
          return a == 0 ? rows_at_A(own, held, y)
                        : rows_between(own, chain_, a, y);
        }));
    equations += arcs_.back()->first.size() + (a > 0 ? kNode : 0);
    if (chain_.jumps(a)) {
      arcs_.back()->normal =
          std::make_unique<NodeConditions>([&](const NodeValues& y) {
            const auto n = rolling::normal_of(held->limit, y[kX], y[kZ]);
            return Rows{n.x, n.z};
          });
    }
  }
  at_B_ = std::make_unique<NodeConditions>([&](const NodeValues& y) {
    return rows_at_B(own, chain_.arcs.back(), y);
  });
  equations += at_B_->size();
  if (equations != chain_.num_unknowns()) {
    throw NotProven("the arcs of the path leave something open");
  }
}

const Equations& ArcSystem::plain(std::size_t arc) const {
  return arcs_[arc]->plain;
}

Real ArcSystem::slope(const State& end, std::size_t arc, std::size_t i,
                      std::size_t j) const {
  const std::vector<std::size_t>& directions = arcs_[arc]->directions;
  const auto found = std::find(directions.begin(), directions.end(), j);
  if (found == directions.end()) return Real(i == j ? 1.0 : 0.0);
  return end[Equations::place(
      i, static_cast<std::size_t>(found - directions.begin()))];
}

ShootingSystem::Value ArcSystem::evaluate(const Vector& at,
                                          const Accuracy& accuracy,
                                          bool with_slopes) const {
  const std::size_t size = chain_.num_unknowns();
  Value out;
  // A row by the numbers of a node.
  const auto add = [&](const NodeConditions::Value& row) -> std::size_t {
    out.missed.push_back(row.value);
    if (with_slopes) out.slopes.emplace_back(size);
    return out.missed.size() - 1;
  };
  for (std::size_t a = 0; a < arcs_.size(); ++a) {
    const OfArc& arc = *arcs_[a];
    const std::size_t begin = ArcChain::node(a);
    State y(at.begin() + static_cast<std::ptrdiff_t>(begin),
            at.begin() + static_cast<std::ptrdiff_t>(begin + kNode));
    const std::vector<NodeConditions::Value> rows = arc.first.at(y);
    for (const NodeConditions::Value& row : rows) {
      const std::size_t i = add(row);
      for (std::size_t j = 0; with_slopes && j < kNode; ++j) {
        out.slopes[i][begin + j] = row.gradient[j];
      }
    }
    if (a > 0) {
      // y − Φ(node before), less the jump.
      const State& end = out.ends.back();
      const State& rates = out.rates.back();
      const bool jumps = chain_.jumps(a);
      std::vector<NodeConditions::Value> normal;
      if (jumps) normal = arc.normal->at(y);
      for (std::size_t i = 0; i < kNode; ++i) {
        NodeConditions::Value row;
        row.value = y[i] - end[i];
        row.gradient[i] = Real(1.0);
        const bool along = jumps && (i == kPx || i == kPz);
        if (along) {
          const Real& jump = at[chain_.jump(a)];
          const NodeConditions::Value& n = normal[i == kPx ? 0 : 1];
          row.value = row.value - jump * n.value;
          for (std::size_t j = 0; j < kNode; ++j) {
            row.gradient[j] = row.gradient[j] - jump * n.gradient[j];
          }
        }
        const std::size_t place = add(row);
        if (!with_slopes) continue;
        std::vector<Real>& slopes = out.slopes[place];
        for (std::size_t j = 0; j < kNode; ++j) {
          slopes[begin + j] = row.gradient[j];
          slopes[ArcChain::node(a - 1) + j] = -slope(end, a - 1, i, j);
        }
        slopes[ArcChain::length(a - 1)] = -rates[i];
        if (along) slopes[chain_.jump(a)] = -normal[i == kPx ? 0 : 1].value;
      }
    }
    const Equations& equations = with_slopes ? arc.sloped : arc.plain;
    y.resize(equations.size());
    for (std::size_t j = 0; with_slopes && j < arc.directions.size(); ++j) {
      y[Equations::place(arc.directions[j], j)] = Real(1.0);
    }
    Integration flow(equations.tape, equations.rates, accuracy);
    out.steps += flow.go(y, at[ArcChain::length(a)]);
    const State components(y.begin(), y.begin() + kComponents);
    const std::vector<Real> there = arc.plain.tape.values(components);
    State& rates = out.rates.emplace_back();
    for (const Node& rate : arc.plain.rates) {
      rates.push_back(there[static_cast<std::size_t>(rate.id)]);
    }
    out.ends.push_back(std::move(y));
  }
  const std::size_t last = arcs_.size() - 1;
  for (const NodeConditions::Value& row : at_B_->at(out.ends.back())) {
    const std::size_t place = add(row);
    if (!with_slopes) continue;
    std::vector<Real>& slopes = out.slopes[place];
    for (std::size_t i = 0; i < kNode; ++i) {
      for (std::size_t j = 0; j < kNode; ++j) {
        slopes[ArcChain::node(last) + j] +=
            row.gradient[i] * slope(out.ends.back(), last, i, j);
      }
      slopes[ArcChain::length(last)] += row.gradient[i] * out.rates.back()[i];
    }
  }
  return out;
}

void ArcSystem::settle(Vector& near) const {
  if (chain_.scene.body.off_centred()) return;
  const Vector given = near;
  const Value found = evaluate(near, kRough, false);
  for (std::size_t a = 1; a < found.ends.size(); ++a) {
    const std::size_t before = ArcChain::node(a - 1) + kTheta;
    near[ArcChain::node(a) + kTheta] =
        (near[before] + found.ends[a - 1][kTheta] - given[before]).middle();
  }
}

void ArcSystem::check_ends(const std::vector<State>& ends) const {
  if (along_boundary(chain_.arcs.back()) &&
      !cos(ends.back()[kBeta]).positive()) {
    throw NotProven("the path arrives at B upside down");
  }
}

}  // namespace brachisto::proof
