// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "proof/tape.hpp"

#include <utility>

namespace brachisto::proof {

namespace {

thread_local Tape* recording = nullptr;

using Op = Tape::Op;

}  // namespace

Tape& Tape::current() {
  if (recording == nullptr) throw std::logic_error("no tape to write on");
  return *recording;
}

Tape::Recording::Recording(Tape& tape)
    : former_(std::exchange(recording, &tape)) {}
Tape::Recording::~Recording() {
  recording = former_;
}

Node Tape::put(Op op, int a, int b, double exact) {
  const std::tuple key{op, a, b, exact};
  const auto [place, is_new] =
      known_.try_emplace(key, static_cast<int>(entries_.size()));
  if (is_new) entries_.push_back({op, a, b, exact});
  return Node(Node::Place{place->second});
}

Node Tape::input(int number) {
  return put(Op::Input, number);
}

Node Tape::node(std::size_t place) const {
  return Node(Node::Place{static_cast<int>(place)});
}

std::size_t Tape::find(Op op, std::size_t operand) const {
  return static_cast<std::size_t>(
      known_.at({op, static_cast<int>(operand), -1, 0.0}));
}

bool Tape::is(const Node& node, double exact) const {
  const Entry& e = entries_[static_cast<std::size_t>(node.id)];
  return e.op == Op::Constant && e.exact == exact;
}

Node Node::constant(double exact) {
  return Tape::current().put(Op::Constant, -1, -1, exact);
}

// Zeros and ones of jets are left out: these rules are exact.
Node Node::operator-() const {
  Tape& tape = Tape::current();
  return tape.is(*this, 0.0) ? *this : tape.put(Op::Negate, id);
}
Node operator+(const Node& a, const Node& b) {
  Tape& tape = Tape::current();
  if (tape.is(a, 0.0)) return b;
  if (tape.is(b, 0.0)) return a;
  return tape.put(Op::Add, std::min(a.id, b.id), std::max(a.id, b.id));
}
Node operator-(const Node& a, const Node& b) {
  Tape& tape = Tape::current();
  if (tape.is(b, 0.0)) return a;
  if (tape.is(a, 0.0)) return -b;
  return tape.put(Op::Subtract, a.id, b.id);
}
Node operator*(const Node& a, const Node& b) {
  Tape& tape = Tape::current();
  if (tape.is(a, 0.0) || tape.is(b, 0.0)) return Node(0.0);
  if (tape.is(a, 1.0)) return b;
  if (tape.is(b, 1.0)) return a;
  return tape.put(Op::Multiply, std::min(a.id, b.id), std::max(a.id, b.id));
}
// 0/b is 0 only where b is not: 1/b stays on the tape, and no step is taken
// where it is not bounded.
Node operator/(const Node& a, const Node& b) {
  Tape& tape = Tape::current();
  if (tape.is(b, 1.0)) return a;
  return a * tape.put(Op::Reciprocal, b.id);
}
Node sin(const Node& a) {
  return Tape::current().put(Op::Sin, a.id);
}
Node cos(const Node& a) {
  return Tape::current().put(Op::Cos, a.id);
}
Node sqrt(const Node& a) {
  Tape& tape = Tape::current();
  const Node root = tape.put(Op::Sqrt, a.id);
  (void)tape.put(Op::Reciprocal, root.id);
  return root;
}

std::vector<Real> Tape::values(const std::vector<Real>& inputs) const {
  std::vector<Real> at;
  at.reserve(entries_.size());
  for (const Entry& e : entries_) {
    const auto a = static_cast<std::size_t>(e.a);
    const auto b = static_cast<std::size_t>(e.b);
    switch (e.op) {
      case Op::Constant:
        at.emplace_back(e.exact);
        break;
      case Op::Input:
        at.push_back(inputs[a]);
        break;
      case Op::Negate:
        at.push_back(-at[a]);
        break;
      case Op::Add:
        at.push_back(at[a] + at[b]);
        break;
      case Op::Subtract:
        at.push_back(at[a] - at[b]);
        break;
      case Op::Multiply:
        at.push_back(at[a] * at[b]);
        break;
      case Op::Reciprocal:
        at.push_back(Real(1.0) / at[a]);
        break;
      case Op::Sin:
        at.push_back(sin(at[a]));
        break;
      case Op::Cos:
        at.push_back(cos(at[a]));
        break;
      case Op::Sqrt:
        at.push_back(sqrt(at[a]));
        break;
    }
  }
  return at;
}

TaylorSeries::TaylorSeries(const Tape& tape, std::vector<Node> rates, int terms)
    : tape_(tape), rates_(std::move(rates)), terms_(terms) {
  const auto& entries = tape_.entries();
  arb_init(sum_);
  inputs_.resize(rates_.size());
  for (arb_ptr& series : inputs_) series = _arb_vec_init(terms_ + 1);
  nodes_.resize(entries.size());
  weighted_.resize(entries.size(), nullptr);
  partner_.resize(entries.size(), -1);
  fixed_.resize(entries.size());
  std::map<std::pair<Op, int>, int> sines;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Tape::Entry& e = entries[i];
    const auto a = static_cast<std::size_t>(e.a);
    if (e.op == Op::Input) {
      nodes_[i] = inputs_[a];
      fixed_[i] = tape_.is(rates_[a], 0.0);
      continue;
    }
    nodes_[i] = _arb_vec_init(terms_);
    fixed_[i] =
        e.op == Op::Constant ||
        (fixed_[a] && (e.b < 0 || fixed_[static_cast<std::size_t>(e.b)]));
    if (e.op == Op::Sin || e.op == Op::Cos) {
      sines[{e.op, e.a}] = static_cast<int>(i);
      if (weighted_[a] == nullptr) weighted_[a] = _arb_vec_init(terms_);
    }
  }
  for (const auto& [key, i] : sines) {
    const auto other =
        sines.find({key.first == Op::Sin ? Op::Cos : Op::Sin, key.second});
    if (other == sines.end()) {
      throw std::logic_error("a sine without its cosine");
    }
    partner_[static_cast<std::size_t>(i)] = other->second;
  }
}

TaylorSeries::~TaylorSeries() {
  const auto& entries = tape_.entries();
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (entries[i].op != Op::Input) _arb_vec_clear(nodes_[i], terms_);
    if (weighted_[i] != nullptr) _arb_vec_clear(weighted_[i], terms_);
  }
  for (arb_ptr series : inputs_) _arb_vec_clear(series, terms_ + 1);
  arb_clear(sum_);
}

void TaylorSeries::expand(const std::vector<Real>& start) {
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    arb_set_round(inputs_[i], start[i].get(), working_bits);
  }
  for (int k = 0; k < terms_; ++k) {
    for (std::size_t node = 0; node < nodes_.size(); ++node) next(node, k);
    for (std::size_t i = 0; i < inputs_.size(); ++i) {
      arb_div_si(inputs_[i] + k + 1, of(rates_[i]) + k, k + 1, working_bits);
    }
  }
}

// The recurrences of the coefficients; Moore, Kearfott, Cloud (2009), ch. 9.
void TaylorSeries::next(std::size_t node, int k) {
  const Tape::Entry& e = tape_.entries()[node];
  const slong bits = working_bits;
  arb_ptr out = nodes_[node];
  const auto ia = static_cast<std::size_t>(e.a);
  const auto ib = static_cast<std::size_t>(e.b);
  arb_srcptr a = e.a < 0 ? nullptr : nodes_[ia];
  arb_srcptr b = e.b < 0 ? nullptr : nodes_[ib];
  if (k > 0 && fixed_[node] && e.op != Op::Input) {
    arb_zero(out + k);
    return;
  }
  switch (e.op) {
    case Op::Constant:
      arb_set_d(out, e.exact);
      break;
    case Op::Input:
      break;
    case Op::Negate:
      arb_neg(out + k, a + k);
      break;
    case Op::Add:
      arb_add(out + k, a + k, b + k, bits);
      break;
    case Op::Subtract:
      arb_sub(out + k, a + k, b + k, bits);
      break;
    case Op::Multiply:
      if (fixed_[ia]) {
        arb_mul(out + k, a, b + k, bits);
      } else if (fixed_[ib]) {
        arb_mul(out + k, b, a + k, bits);
      } else {
        arb_dot(out + k, nullptr, 0, a, 1, b + k, -1, k + 1, bits);
      }
      break;
    case Op::Reciprocal:
      if (k == 0) {
        arb_inv(out, a, bits);
      } else {
        // g a = 1: g_k = −g_0 Σ_{0<j≤k} a_j g_{k−j}
        arb_dot(sum_, nullptr, 1, a + 1, 1, out + k - 1, -1, k, bits);
        arb_mul(out + k, sum_, out, bits);
      }
      break;
    case Op::Sqrt:
      if (k == 0) {
        arb_sqrt(out, a, bits);
      } else {
        // s² = a: 2 s_0 s_k = a_k − Σ_{0<j<k} s_j s_{k−j}
        arb_dot(sum_, a + k, 1, out + 1, 1, out + k - 1, -1, k - 1, bits);
        arb_div(sum_, sum_, out, bits);
        arb_mul_2exp_si(out + k, sum_, -1);
      }
      break;
    case Op::Sin:
    case Op::Cos: {
      const bool sine = e.op == Op::Sin;
      if (k == 0) {
        sine ? arb_sin(out, a, bits) : arb_cos(out, a, bits);
        break;
      }
      // k s_k = Σ_{0<j≤k} j a_j c_{k−j}, and of the cosine with −s
      arb_mul_si(weighted_[ia] + k, a + k, k, bits);
      arb_srcptr other = nodes_[static_cast<std::size_t>(partner_[node])];
      arb_dot(sum_, nullptr, sine ? 0 : 1, weighted_[ia] + 1, 1, other + k - 1,
              -1, k, bits);
      arb_div_si(out + k, sum_, k, bits);
      break;
    }
  }
}

}  // namespace brachisto::proof
