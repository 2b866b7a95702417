// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Formulas as lists of operations. A formula written for any scalar is asked
/// once with Node for its scalar; what it did can then be repeated with balls,
/// and coefficient by coefficient with power series.

#pragma once

#include <map>
#include <stdexcept>
#include <tuple>
#include <type_traits>
#include <vector>

#include "proof/real.hpp"

namespace brachisto::proof {

/// A step that arithmetic could not take; what was to be proven is not.
class NotProven : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The same where more digits may help.
class TooFewBits : public NotProven {
 public:
  using NotProven::NotProven;
};

class Tape;

/// A number of a formula that is being written down.
struct Node {
  /// Numbers that a formula computes with beside its scalars are to be as
  /// exact as these: see math::ConstantOf.
  using Constant = Node;

  int id = -1;

  Node() : Node(0.0) {}
  template <class Number>
  requires std::is_arithmetic_v<Number> Node(Number exact)  // NOLINT: numbers
      : Node(constant(static_cast<double>(exact))) {}

  /// No number yet, which needs no tape.
  [[nodiscard]] static Node none() { return Node(Place{-1}); }

  [[nodiscard]] Node operator-() const;
  friend Node operator+(const Node& a, const Node& b);
  friend Node operator-(const Node& a, const Node& b);
  friend Node operator*(const Node& a, const Node& b);
  friend Node operator/(const Node& a, const Node& b);
  friend Node sin(const Node& a);
  friend Node cos(const Node& a);
  friend Node sqrt(const Node& a);
  Node& operator+=(const Node& b) { return *this = *this + b; }
  Node& operator-=(const Node& b) { return *this = *this - b; }

  // What losses in proportion to the load ask for, of which nothing is proven.
  friend Node exp(const Node&) { return refuse(); }
  friend Node log(const Node&) { return refuse(); }
  friend Node atan(const Node&) { return refuse(); }
  explicit operator double() const { return refuse().id; }

 private:
  friend class Tape;
  struct Place {
    int id;
  };
  explicit Node(Place place) : id(place.id) {}
  [[nodiscard]] static Node constant(double exact);
  static Node refuse() { throw NotProven("no proof of a scene with losses"); }
};

/// The operations, each with operands that stand before it; none stands twice.
/// Behind every root stands its reciprocal.
class Tape {
 public:
  enum class Op {
    Constant,
    Input,
    Negate,
    Add,
    Subtract,
    Multiply,
    Reciprocal,
    Sin,
    Cos,
    Sqrt
  };
  struct Entry {
    Op op;
    int a, b;
    double exact;  ///< of a constant
  };

  /// Nodes made in this thread go there as long as it lives.
  class Recording {
   public:
    explicit Recording(Tape& tape);
    ~Recording();
    Recording(const Recording&) = delete;
    Recording& operator=(const Recording&) = delete;

   private:
    Tape* former_;
  };

  [[nodiscard]] Node input(int number);
  [[nodiscard]] Node put(Op op, int a, int b = -1, double exact = 0.0);
  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }
  [[nodiscard]] Node node(std::size_t place) const;
  /// Where an operation of one operand stands.
  [[nodiscard]] std::size_t find(Op op, std::size_t operand) const;
  /// Whether a node is this exact number.
  [[nodiscard]] bool is(const Node& node, double exact) const;
  /// The tape that is being written.
  [[nodiscard]] static Tape& current();

  /// Every node, for these inputs.
  [[nodiscard]] std::vector<Real> values(const std::vector<Real>& inputs) const;

 private:
  std::vector<Entry> entries_;
  std::map<std::tuple<Op, int, int, double>, int> known_;
};

/// The Taylor series of the solution of y' = f(y), and of every node on its
/// way, f being nodes of a tape whose inputs are y.
class TaylorSeries {
 public:
  /// \param rates  f, one of each input
  /// \param terms  N: coefficients 0 … N − 1
  TaylorSeries(const Tape& tape, std::vector<Node> rates, int terms);
  ~TaylorSeries();
  TaylorSeries(const TaylorSeries&) = delete;
  TaylorSeries& operator=(const TaylorSeries&) = delete;

  /// \param start  y(0)
  void expand(const std::vector<Real>& start);
  /// Of an input.
  [[nodiscard]] arb_srcptr input(std::size_t i) const { return inputs_[i]; }
  [[nodiscard]] arb_srcptr of(const Node& node) const {
    return nodes_[static_cast<std::size_t>(node.id)];
  }
  [[nodiscard]] int terms() const { return terms_; }
  /// Of a node that is no series: constant along the solution.
  [[nodiscard]] bool fixed(std::size_t node) const { return fixed_[node]; }
  /// Of a sine its cosine, and back.
  [[nodiscard]] std::size_t partner(std::size_t sine) const {
    return static_cast<std::size_t>(partner_[sine]);
  }
  [[nodiscard]] const Tape& tape() const { return tape_; }
  [[nodiscard]] const std::vector<Node>& rates() const { return rates_; }

 private:
  void next(std::size_t node, int k);

  const Tape& tape_;
  std::vector<Node> rates_;
  int terms_;
  std::vector<arb_ptr> inputs_;
  std::vector<arb_ptr> nodes_;     ///< of an input its own
  std::vector<arb_ptr> weighted_;  ///< of the argument of sines: k a_k
  std::vector<int> partner_;       ///< of a sine its cosine, and back
  std::vector<bool> fixed_;        ///< constant along the solution
  arb_t sum_;
};

}  // namespace brachisto::proof
