// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Exactly one extremal of a chain of arcs in a box: Krawczyk's operator on
/// the unknowns of multiple shooting.

#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "proof/arc_chain.hpp"
#include "proof/flow.hpp"

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
class ArcSystem {
 public:
  /// \throws NotProven  if the equations are not as many as the unknowns
  explicit ArcSystem(const ArcChain& chain);
  ~ArcSystem();

  [[nodiscard]] const ArcChain& chain() const { return chain_; }

  struct Value {
    std::vector<Real> missed;               ///< F
    std::vector<std::vector<Real>> slopes;  ///< F', if asked for
    std::vector<State> ends;   ///< of each arc, with derivatives if asked for
    std::vector<State> rates;  ///< there
    int steps = 0;
  };
  [[nodiscard]] Value evaluate(const std::vector<Real>& at,
                               const Accuracy& accuracy,
                               bool with_slopes) const;
  /// ∂(component i at the end of an arc)/∂(number j of its node).
  [[nodiscard]] Real slope(const State& end, std::size_t arc, std::size_t i,
                           std::size_t j) const;
  /// The equations of an arc, without directions.
  [[nodiscard]] const Equations& plain(std::size_t arc) const;

 private:
  struct OfArc;
  ArcChain chain_;
  std::vector<std::unique_ptr<OfArc>> arcs_;
  std::unique_ptr<NodeConditions> at_B_;
};

/// What Krawczyk's operator has shown of a chain.
struct ArcRoot {
  std::vector<Real> searched, found;
  std::vector<State> ends;  ///< of each arc, of a mean value form
  int steps = 0;            ///< of one integration
};

/// From an approximation, as find_root().
/// \throws NotProven
[[nodiscard]] ArcRoot find_arc_root(const ArcSystem& system,
                                    std::vector<Real> near,
                                    const Accuracy& accuracy);
/// Krawczyk's operator on a box, as verify_root().
/// \throws NotProven
[[nodiscard]] ArcRoot verify_arc_root(const ArcSystem& system,
                                      const std::vector<Real>& box,
                                      const Accuracy& accuracy);

/// A part of a box in which a root is, with that root.
[[nodiscard]] std::vector<Real> narrowed(const ArcSystem& system,
                                         const std::vector<Real>& found,
                                         const Accuracy& accuracy);

}  // namespace brachisto::proof
