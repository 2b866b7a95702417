// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "program_files/formula.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace brachisto::program_files {

namespace {

using Token = Formula::Token;
using Tree = std::vector<Token>;

Token token(Formula::Operation operation) {
  return {Token::Kind::Operation, static_cast<int>(operation)};
}

Token token(double constant) {
  return {Token::Kind::Constant, 0, constant};
}

Tree joined(Formula::Operation operation, const Tree& a, const Tree& b = {}) {
  Tree out{token(operation)};
  out.reserve(1 + a.size() + b.size());
  out.insert(out.end(), a.begin(), a.end());
  out.insert(out.end(), b.begin(), b.end());
  return out;
}

Tree scaled(double factor, const Tree& tree) {
  using enum Formula::Operation;
  if (factor == 1.0) return tree;
  if (factor == -1.0) return joined(Negative, tree);
  return joined(Times, {token(factor)}, tree);
}

}  // namespace

Formula Formula::unknown(int index) {
  Formula out;
  out.terms_ = {{index, 1.0}};
  return out;
}

Formula Formula::quantity(int index) {
  Formula out;
  out.tree_ = {{Token::Kind::Quantity, index}};
  return out;
}

void Formula::add_terms(const Formula& other, double factor) {
  for (const auto& [unknown, coefficient] : other.terms_) {
    const auto own = std::ranges::find(terms_, unknown, &Term::unknown);
    if (own == terms_.end()) {
      terms_.push_back({unknown, factor * coefficient});
    } else {
      own->coefficient += factor * coefficient;
    }
  }
}

void Formula::scale(double factor) {
  constant_ *= factor;
  for (Term& term : terms_) term.coefficient *= factor;
  if (!tree_.empty()) tree_ = scaled(factor, tree_);
}

Tree Formula::in_full() const {
  Tree sum = tree_;
  const auto add = [&](const Tree& summand) {
    sum = sum.empty() ? summand : joined(Operation::Plus, sum, summand);
  };
  for (const auto& [unknown, coefficient] : terms_) {
    add(scaled(coefficient, {{Token::Kind::Unknown, unknown}}));
  }
  if (constant_ != 0.0 || sum.empty()) add({token(constant_)});
  return sum;
}

Formula& Formula::operator+=(const Formula& other) {
  constant_ += other.constant_;
  add_terms(other, 1.0);
  if (tree_.empty()) {
    tree_ = other.tree_;
  } else if (!other.tree_.empty()) {
    tree_ = joined(Operation::Plus, tree_, other.tree_);
  }
  return *this;
}

Formula operator-(const Formula& a, const Formula& b) {
  if (a.tree_.empty() || b.tree_.empty()) return a + -b;
  Formula out = a;
  out.constant_ -= b.constant_;
  out.add_terms(b, -1.0);
  out.tree_ = joined(Formula::Operation::Minus, a.tree_, b.tree_);
  return out;
}

Formula operator*(const Formula& a, const Formula& b) {
  if (!a.is_constant() && !b.is_constant()) {
    Formula out;
    out.tree_ = joined(Formula::Operation::Times, a.in_full(), b.in_full());
    return out;
  }
  const double factor = a.is_constant() ? a.constant_ : b.constant_;
  if (factor == 0.0) return 0.0;
  Formula out = a.is_constant() ? b : a;
  out.scale(factor);
  return out;
}

Formula operator/(const Formula& a, const Formula& b) {
  if (a.is_constant() && b.is_constant()) return a.constant_ / b.constant_;
  Formula out;
  if (!b.is_constant()) {
    out.tree_ = joined(Formula::Operation::Divided, a.in_full(), b.in_full());
    return out;
  }
  out.constant_ = a.constant_ / b.constant_;
  out.terms_ = a.terms_;
  for (Formula::Term& term : out.terms_) term.coefficient /= b.constant_;
  if (!a.tree_.empty()) {
    out.tree_ =
        joined(Formula::Operation::Divided, a.tree_, {token(b.constant_)});
  }
  return out;
}

Formula sin(const Formula& a) {
  if (a.is_constant()) return std::sin(a.constant_);
  Formula out;
  out.tree_ = joined(Formula::Operation::Sine, a.in_full());
  return out;
}

Formula cos(const Formula& a) {
  if (a.is_constant()) return std::cos(a.constant_);
  Formula out;
  out.tree_ = joined(Formula::Operation::Cosine, a.in_full());
  return out;
}

Formula sqrt(const Formula& a) {
  if (a.is_constant()) return std::sqrt(a.constant_);
  Formula out;
  out.tree_ = joined(Formula::Operation::Root, a.in_full());
  return out;
}

double plain(const Formula& /*formula*/) {
  throw std::logic_error("a formula was asked for its value");
}

}  // namespace brachisto::program_files
