// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "program_files/formula.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace brachisto::program_files {

namespace {

using Token = Formula::Token;
using Tree = std::vector<Token>;

/// Room that an operation leaves for what is affine: one allocation, not five.
constexpr std::size_t kUsualTokens = 16;

Token token(Formula::Operation operation) {
  return {Token::Kind::Operation, static_cast<int>(operation)};
}

Token token(double constant) {
  return {Token::Kind::Constant, 0, constant};
}

/// factor · what follows; nothing for the factor 1.
void append_factor(double factor, Tree& out) {
  using enum Formula::Operation;
  if (factor == 1.0) return;
  if (factor == -1.0) return out.push_back(token(Negative));
  out.push_back(token(Times));
  out.push_back(token(factor));
}

Tree joined(Formula::Operation operation, const Tree& a, const Tree& b) {
  Tree out;
  out.reserve(1 + a.size() + b.size());
  out.push_back(token(operation));
  out.insert(out.end(), a.begin(), a.end());
  out.insert(out.end(), b.begin(), b.end());
  return out;
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
  if (tree_.empty() || factor == 1.0) return;
  Tree scaled;
  scaled.reserve(2 + tree_.size());
  append_factor(factor, scaled);
  scaled.insert(scaled.end(), tree_.begin(), tree_.end());
  tree_ = std::move(scaled);
}

void Formula::append_to(Tree& out) const {
  const bool has_constant = constant_ != 0.0 || is_constant();
  const std::size_t summands =
      terms_.size() + (tree_.empty() ? 0 : 1) + (has_constant ? 1 : 0);
  out.insert(out.end(), summands - 1, token(Operation::Plus));
  out.insert(out.end(), tree_.begin(), tree_.end());
  for (const auto& [unknown, coefficient] : terms_) {
    append_factor(coefficient, out);
    out.push_back({Token::Kind::Unknown, unknown});
  }
  if (has_constant) out.push_back(token(constant_));
}

Formula Formula::applied(Operation operation, double (*value)(double),
                         const Formula& a) {
  if (a.is_constant()) return value(a.constant_);
  Formula out;
  out.tree_.reserve(kUsualTokens + a.tree_.size());
  out.tree_.push_back(token(operation));
  a.append_to(out.tree_);
  return out;
}

Formula Formula::applied(Operation operation, const Formula& a,
                         const Formula& b) {
  Formula out;
  out.tree_.reserve(kUsualTokens + a.tree_.size() + b.tree_.size());
  out.tree_.push_back(token(operation));
  a.append_to(out.tree_);
  b.append_to(out.tree_);
  return out;
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
    return Formula::applied(Formula::Operation::Times, a, b);
  }
  const double factor = a.is_constant() ? a.constant_ : b.constant_;
  if (factor == 0.0) return 0.0;
  Formula out = a.is_constant() ? b : a;
  out.scale(factor);
  return out;
}

Formula operator/(const Formula& a, const Formula& b) {
  if (a.is_constant() && b.is_constant()) return a.constant_ / b.constant_;
  if (!b.is_constant() || !a.tree_.empty()) {
    return Formula::applied(Formula::Operation::Divided, a, b);
  }
  Formula out = a;
  out.constant_ /= b.constant_;
  for (Formula::Term& term : out.terms_) term.coefficient /= b.constant_;
  return out;
}

Formula Formula::either(const Formula& a, double bound, const Formula& above,
                        const Formula& below) {
  Formula out;
  out.tree_ = {token(Operation::If), token(Operation::Greater)};
  for (const Formula& operand : {a, Formula(bound), above, below}) {
    operand.append_to(out.tree_);
  }
  return out;
}

Formula sin(const Formula& a) {
  return Formula::applied(Formula::Operation::Sine, std::sin, a);
}

Formula cos(const Formula& a) {
  return Formula::applied(Formula::Operation::Cosine, std::cos, a);
}

Formula sqrt(const Formula& a) {
  return Formula::applied(Formula::Operation::Root, std::sqrt, a);
}

Formula exp(const Formula& a) {
  return Formula::applied(Formula::Operation::Power, std::exp, a);
}

Formula log(const Formula& a) {
  return Formula::applied(Formula::Operation::Logarithm, std::log, a);
}

Formula atan(const Formula& a) {
  return Formula::applied(Formula::Operation::Arctangent, std::atan, a);
}

}  // namespace brachisto::program_files
