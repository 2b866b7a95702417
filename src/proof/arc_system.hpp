// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The equations of multiple shooting over a chain of arcs.

#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "proof/arc_chain.hpp"
#include "proof/root.hpp"

namespace brachisto::proof {

/// A condition at a node with its derivatives by the node's numbers.
using NodeRow = math::Jet1<Node, static_cast<int>(kNode)>;
using NodeValues = std::array<NodeRow, kComponents>;

/// Conditions at a node, written down once.
class NodeConditions {
 public:
  using Write = std::function<std::vector<NodeRow>(const NodeValues&)>;
  explicit NodeConditions(const Write& write);
  NodeConditions(const NodeConditions&) = delete;
  NodeConditions& operator=(const NodeConditions&) = delete;

  [[nodiscard]] std::size_t size() const { return rows_.size(); }
  struct Value {
    Real value;
    std::array<Real, kNode> gradient;
  };
  /// \param y  the numbers of a node, or more
  [[nodiscard]] std::vector<Value> at(const State& y) const;

 private:
  Tape tape_;
  std::vector<NodeRow> rows_;
};

/// The equations of a chain:
///
/// - at A: rest or the push, the centre above A, θ = θ_m, 𝓗 = 0; h_β = 0 of a
///   free arc, and of one along a limit of the control p_β = 0 or what an
///   optimal contact asks for;
/// - arcs fit together in all numbers of a node; where a boundary begins behind
///   a limit of the control (p_x, p_z) jump along its normal;
/// - where a boundary begins: c = 0, tangentially;
/// - where an arc whose control was held ends: p_β = 0, and h_β = 0 unless
///   another limit of the control follows, from the other side, or whose bound
///   is reached already;
/// - at B: its place, p_θ = p_w = 0, and of an arc whose control is held
///   p_β = 0 or what the contact asks for. Along a boundary one coordinate of B
///   follows from the other, and from cos β > 0, which is shown.
class ArcSystem final : public ShootingSystem {
 public:
  /// \throws NotProven  if the equations are not as many as the unknowns
  explicit ArcSystem(const ArcChain& chain);
  ~ArcSystem() override;

  [[nodiscard]] const ArcChain& chain() const { return chain_; }

  [[nodiscard]] Value evaluate(const Vector& at, const Accuracy& accuracy,
                               bool with_slopes) const override;
  [[nodiscard]] std::size_t per_arc() const override {
    return ArcChain::kPerArc;
  }
  [[nodiscard]] Real slope(const State& end, std::size_t arc, std::size_t i,
                           std::size_t j) const override;
  [[nodiscard]] std::vector<double> units() const override {
    return chain_.units();
  }
  /// Where nothing depends on θ an approximation need not have it.
  void settle(Vector& near) const override;
  /// z of B follows from the floor below the body, not above it.
  void check_ends(const std::vector<State>& ends) const override;

  /// The equations of an arc, without directions.
  [[nodiscard]] const Equations& plain(std::size_t arc) const;

 private:
  struct OfArc;
  ArcChain chain_;
  std::vector<std::unique_ptr<OfArc>> arcs_;
  std::unique_ptr<NodeConditions> at_B_;
};

}  // namespace brachisto::proof
