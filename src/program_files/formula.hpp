// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Numbers without a value, which write down the formula they come from.

#pragma once

#include <concepts>
#include <vector>

namespace brachisto::program_files {

/// What a formula written for a generic Scalar is, in the unknowns of a program
/// and in quantities that are defined once and used by several formulas:
///
///     constant + Σ coefficient · unknown + tree,
///
/// the tree in Polish notation, as .nl files have it. What is affine stays out
/// of the tree as long as nothing bends it. Constants are computed with, so
/// that a formula at a fixed point is a number.
class Formula {
 public:
  /// Numbered as in .nl files.
  enum class Operation {
    Plus = 0,
    Minus = 1,
    Times = 2,
    Divided = 3,
    Negative = 16,
    Greater = 29,
    If = 35,
    Root = 39,
    Sine = 41,
    Logarithm = 43,
    Power = 44,
    Cosine = 46,
    Arctangent = 49,
  };
  struct Token {
    enum class Kind { Operation, Constant, Unknown, Quantity };
    Kind kind;
    int number;          ///< of an Operation, an Unknown or a Quantity
    double value = 0.0;  ///< of a Constant
  };
  struct Term {
    int unknown;
    double coefficient;
  };

  Formula() = default;
  template <std::convertible_to<double> Number>
  Formula(const Number& constant)  // NOLINT: numbers are formulas
      : constant_(static_cast<double>(constant)) {}
  [[nodiscard]] static Formula unknown(int index);
  [[nodiscard]] static Formula quantity(int index);

  [[nodiscard]] double constant() const { return constant_; }
  /// One entry for each unknown.
  [[nodiscard]] const std::vector<Term>& terms() const { return terms_; }
  /// In Polish notation; empty if there is none.
  [[nodiscard]] const std::vector<Token>& tree() const { return tree_; }

  [[nodiscard]] Formula operator-() const { return *this * -1.0; }
  friend Formula operator+(Formula a, const Formula& b) { return a += b; }
  friend Formula operator-(const Formula& a, const Formula& b);
  friend Formula operator*(const Formula& a, const Formula& b);
  friend Formula operator/(const Formula& a, const Formula& b);
  Formula& operator+=(const Formula& other);

  /// One where a > bound, otherwise the other.
  [[nodiscard]] static Formula either(const Formula& a, double bound,
                                      const Formula& above,
                                      const Formula& below);
  friend Formula sin(const Formula& a);
  friend Formula cos(const Formula& a);
  friend Formula sqrt(const Formula& a);
  friend Formula exp(const Formula& a);
  friend Formula log(const Formula& a);
  friend Formula atan(const Formula& a);

 private:
  [[nodiscard]] bool is_constant() const {
    return terms_.empty() && tree_.empty();
  }
  void add_terms(const Formula& other, double factor);
  void scale(double factor);
  /// All of it as one tree.
  void append_to(std::vector<Token>& out) const;
  /// `value` of a constant.
  [[nodiscard]] static Formula applied(Operation operation,
                                       double (*value)(double),
                                       const Formula& a);
  [[nodiscard]] static Formula applied(Operation operation, const Formula& a,
                                       const Formula& b);

  double constant_ = 0.0;
  std::vector<Term> terms_;
  std::vector<Token> tree_;
};

/// A formula has no value to decide by and says what holds on either side.
template <class Above, class Below>
[[nodiscard]] Formula where_above(const Formula& a, double bound,
                                  const Above& above, const Below& below) {
  return Formula::either(a, bound, above(), below());
}

}  // namespace brachisto::program_files
