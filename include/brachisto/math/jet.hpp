// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Numbers that carry their exact derivatives through any formula written for
/// a generic Scalar: of first order, and of second order; and numbers without a
/// value, which tell what such a formula depends on.

#pragma once

#include <array>
#include <bitset>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <type_traits>

namespace brachisto::math {

/// Value and gradient with respect to `Size` independent variables.
///
/// \tparam Real  double, long double, or a jet of either
template <class Real, int Size>
struct Jet1 {
  Real value{};
  std::array<Real, Size> gradient{};

  Jet1() = default;
  template <std::convertible_to<Real> Number>
  Jet1(const Number& constant)  // NOLINT: numbers are jets
      : value(static_cast<Real>(constant)) {}

  /// The independent variable number `index`.
  [[nodiscard]] static Jet1 variable(Real v, int index) {
    Jet1 jet(v);
    jet.gradient[static_cast<std::size_t>(index)] = Real(1);
    return jet;
  }

  /// f(jet) from f and f' at its value, by the chain rule.
  [[nodiscard]] Jet1 chain(Real f, Real df) const {
    Jet1 out(f);
    for (std::size_t i = 0; i < gradient.size(); ++i) {
      out.gradient[i] = df * gradient[i];
    }
    return out;
  }

  /// The same beside jets of the second order, whose f'' is never asked for.
  template <std::invocable Second>
  [[nodiscard]] Jet1 chain(Real f, Real df, const Second&) const {
    return chain(f, df);
  }

  Jet1& operator+=(const Jet1& other) {
    value += other.value;
    for (std::size_t i = 0; i < gradient.size(); ++i) {
      gradient[i] += other.gradient[i];
    }
    return *this;
  }
  Jet1& operator-=(const Jet1& other) {
    value -= other.value;
    for (std::size_t i = 0; i < gradient.size(); ++i) {
      gradient[i] -= other.gradient[i];
    }
    return *this;
  }
  [[nodiscard]] Jet1 operator-() const { return chain(-value, Real(-1)); }

  friend Jet1 operator+(Jet1 a, const Jet1& b) { return a += b; }
  friend Jet1 operator-(Jet1 a, const Jet1& b) { return a -= b; }
  friend Jet1 operator*(const Jet1& a, const Jet1& b) {
    Jet1 out(a.value * b.value);
    for (std::size_t i = 0; i < out.gradient.size(); ++i) {
      out.gradient[i] = a.gradient[i] * b.value + a.value * b.gradient[i];
    }
    return out;
  }
  /// With a number no gradient has to be multiplied.
  template <class Number>
  requires std::is_arithmetic_v<Number>
  friend Jet1 operator*(const Jet1& a, Number factor) {
    return a.chain(a.value * factor, Real(factor));
  }
  friend Jet1 operator/(const Jet1& a, const Jet1& b) {
    const Real inverse = Real(1) / b.value;
    return a * b.chain(inverse, -inverse * inverse);
  }
};

template <class Real, int Size>
[[nodiscard]] Jet1<Real, Size> sin(const Jet1<Real, Size>& a) {
  using std::cos;
  using std::sin;
  return a.chain(sin(a.value), cos(a.value));
}

template <class Real, int Size>
[[nodiscard]] Jet1<Real, Size> cos(const Jet1<Real, Size>& a) {
  using std::cos;
  using std::sin;
  return a.chain(cos(a.value), -sin(a.value));
}

/// Value, gradient and Hessian (lower triangle, row by row) with respect to
/// `Size` independent variables.
///
/// \tparam Real  double, long double, or a jet of either
template <class Real, int Size>
struct Jet2 {
  static constexpr int kPairs = Size * (Size + 1) / 2;

  Real value{};
  std::array<Real, Size> gradient{};
  std::array<Real, kPairs> hessian{};

  Jet2() = default;
  template <std::convertible_to<Real> Number>
  Jet2(const Number& constant)  // NOLINT: numbers are jets
      : value(static_cast<Real>(constant)) {}

  /// The independent variable number `index`.
  [[nodiscard]] static Jet2 variable(Real v, int index) {
    Jet2 jet(v);
    jet.gradient[static_cast<std::size_t>(index)] = Real(1);
    return jet;
  }

  /// Where ∂²/∂i∂j, j ≤ i, stands in `hessian`.
  [[nodiscard]] static constexpr std::size_t pair(int i, int j) {
    return static_cast<std::size_t>(i * (i + 1) / 2 + j);
  }
  /// ∂²/∂i∂j, whichever is the larger one.
  [[nodiscard]] const Real& second(std::size_t i, std::size_t j) const {
    const auto a = static_cast<int>(i), b = static_cast<int>(j);
    return hessian[a >= b ? pair(a, b) : pair(b, a)];
  }

  /// f(jet) from f, f' and f'' at its value, by the chain rule.
  [[nodiscard]] Jet2 chain(Real f, Real df, Real d2f) const {
    Jet2 out(f);
    for (int i = 0; i < Size; ++i) {
      const auto a = static_cast<std::size_t>(i);
      out.gradient[a] = df * gradient[a];
      for (int j = 0; j <= i; ++j) {
        const auto b = static_cast<std::size_t>(j);
        out.hessian[pair(i, j)] =
            df * hessian[pair(i, j)] + d2f * gradient[a] * gradient[b];
      }
    }
    return out;
  }

  /// The same, f'' being what d2f() gives.
  template <std::invocable Second>
  [[nodiscard]] Jet2 chain(Real f, Real df, const Second& d2f) const {
    return chain(f, df, Real(d2f()));
  }

  /// The same of a function that is linear.
  [[nodiscard]] Jet2 chain(Real f, Real df) const {
    Jet2 out(f);
    for (std::size_t i = 0; i < gradient.size(); ++i) {
      out.gradient[i] = df * gradient[i];
    }
    for (std::size_t i = 0; i < hessian.size(); ++i) {
      out.hessian[i] = df * hessian[i];
    }
    return out;
  }

  Jet2& operator+=(const Jet2& other) {
    value += other.value;
    for (std::size_t i = 0; i < gradient.size(); ++i) {
      gradient[i] += other.gradient[i];
    }
    for (std::size_t i = 0; i < hessian.size(); ++i) {
      hessian[i] += other.hessian[i];
    }
    return *this;
  }
  Jet2& operator-=(const Jet2& other) {
    value -= other.value;
    for (std::size_t i = 0; i < gradient.size(); ++i) {
      gradient[i] -= other.gradient[i];
    }
    for (std::size_t i = 0; i < hessian.size(); ++i) {
      hessian[i] -= other.hessian[i];
    }
    return *this;
  }

  [[nodiscard]] Jet2 operator-() const { return chain(-value, Real(-1)); }

  friend Jet2 operator+(Jet2 a, const Jet2& b) { return a += b; }
  friend Jet2 operator-(Jet2 a, const Jet2& b) { return a -= b; }

  friend Jet2 operator*(const Jet2& a, const Jet2& b) {
    Jet2 out(a.value * b.value);
    for (int i = 0; i < Size; ++i) {
      const auto p = static_cast<std::size_t>(i);
      out.gradient[p] = a.gradient[p] * b.value + a.value * b.gradient[p];
      for (int j = 0; j <= i; ++j) {
        const auto q = static_cast<std::size_t>(j);
        out.hessian[pair(i, j)] =
            a.hessian[pair(i, j)] * b.value + a.value * b.hessian[pair(i, j)] +
            a.gradient[p] * b.gradient[q] + a.gradient[q] * b.gradient[p];
      }
    }
    return out;
  }
  /// With a number no derivative of it has to be multiplied.
  template <class Number>
  requires std::is_arithmetic_v<Number>
  friend Jet2 operator*(const Jet2& a, Number factor) {
    return a.chain(a.value * Real(factor), Real(factor));
  }
  friend Jet2 operator/(const Jet2& a, const Jet2& b) {
    const Real inverse = Real(1) / b.value;
    return a * b.chain(inverse, -inverse * inverse,
                       Real(2) * inverse * inverse * inverse);
  }
};

template <class Real, int Size>
[[nodiscard]] Jet2<Real, Size> sin(const Jet2<Real, Size>& a) {
  using std::cos;
  using std::sin;
  const Real s = sin(a.value);
  return a.chain(s, cos(a.value), -s);
}

template <class Real, int Size>
[[nodiscard]] Jet2<Real, Size> cos(const Jet2<Real, Size>& a) {
  using std::cos;
  using std::sin;
  const Real c = cos(a.value);
  return a.chain(c, -sin(a.value), -c);
}

// Of jets of either order. Sines and cosines stand with theirs: a proof keeps
// the order in which it is asked for both.

template <template <class, int> class Jet, class Real, int Size>
[[nodiscard]] Jet<Real, Size> sqrt(const Jet<Real, Size>& a) {
  using std::sqrt;
  const Real root = sqrt(a.value);
  const Real slope = Real(0.5) / root;
  return a.chain(root, slope, [&] { return -slope / (Real(2) * a.value); });
}

template <template <class, int> class Jet, class Real, int Size>
[[nodiscard]] Jet<Real, Size> exp(const Jet<Real, Size>& a) {
  using std::exp;
  const Real power = exp(a.value);
  return a.chain(power, power, [&] { return power; });
}

template <template <class, int> class Jet, class Real, int Size>
[[nodiscard]] Jet<Real, Size> log(const Jet<Real, Size>& a) {
  using std::log;
  const Real slope = Real(1) / a.value;
  return a.chain(log(a.value), slope, [&] { return -slope * slope; });
}

template <template <class, int> class Jet, class Real, int Size>
[[nodiscard]] Jet<Real, Size> atan(const Jet<Real, Size>& a) {
  using std::atan;
  const Real slope = Real(1) / (Real(1) + a.value * a.value);
  return a.chain(atan(a.value), slope,
                 [&] { return Real(-2) * a.value * slope * slope; });
}

/// On which of `Size` independent variables a formula depends, whatever their
/// values: a derivative by any other is zero everywhere.
template <int Size>
struct Dependence {
  using Set = std::bitset<Size>;
  Set any;
  /// By which second variables there may be second derivatives, of each.
  std::array<Set, Size> second;

  Dependence() = default;
  Dependence(double) {}  // NOLINT: numbers depend on nothing

  [[nodiscard]] static Dependence variable(int index) {
    Dependence out;
    out.any.set(static_cast<std::size_t>(index));
    return out;
  }
  /// Of a function that is not affine.
  [[nodiscard]] Dependence bent() const {
    Dependence out = *this;
    out.couple(any, any);
    return out;
  }

  Dependence& operator+=(const Dependence& other) {
    any |= other.any;
    for (std::size_t i = 0; i < second.size(); ++i)
      second[i] |= other.second[i];
    return *this;
  }
  [[nodiscard]] Dependence operator-() const { return *this; }
  Dependence& operator-=(const Dependence& other) { return *this += other; }

  friend Dependence operator+(Dependence a, const Dependence& b) {
    return a += b;
  }
  friend Dependence operator-(const Dependence& a, const Dependence& b) {
    return a + b;
  }
  friend Dependence operator*(const Dependence& a, const Dependence& b) {
    Dependence out = a + b;
    out.couple(a.any, b.any);
    out.couple(b.any, a.any);
    return out;
  }
  friend Dependence operator/(const Dependence& a, const Dependence& b) {
    return a * b.bent();
  }
  friend Dependence sin(const Dependence& a) { return a.bent(); }
  friend Dependence cos(const Dependence& a) { return a.bent(); }
  friend Dependence sqrt(const Dependence& a) { return a.bent(); }
  friend Dependence exp(const Dependence& a) { return a.bent(); }
  friend Dependence log(const Dependence& a) { return a.bent(); }
  friend Dependence atan(const Dependence& a) { return a.bent(); }
  /// Of both, for the place of the bound is nobody's.
  template <class Above, class Below>
  friend Dependence where_above(const Dependence&, double, const Above& above,
                                const Below& below) {
    return above() + below();
  }

 private:
  void couple(const Set& these, const Set& those) {
    for (std::size_t i = 0; i < second.size(); ++i) {
      if (these[i]) second[i] |= those;
    }
  }
};

}  // namespace brachisto::math
