// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Balls of real and of complex numbers, as Arb has them: every result encloses
/// all that its operands enclose. Numbers of 64 bits are exact.

#pragma once

#include <acb.h>
#include <arb.h>
#include <arb_poly.h>

#include <string>
#include <utility>

namespace brachisto::proof {

/// Bits that results are rounded to, outward; of this thread.
inline thread_local slong working_bits = 256;

/// Other bits as long as it lives.
class Bits {
 public:
  explicit Bits(slong bits) : former_(std::exchange(working_bits, bits)) {}
  ~Bits() { working_bits = former_; }
  Bits(const Bits&) = delete;
  Bits& operator=(const Bits&) = delete;

 private:
  slong former_;
};

/// [m − ρ, m + ρ].
class Real {
 public:
  Real() { arb_init(ball_); }
  Real(double exact) : Real() { arb_set_d(ball_, exact); }  // NOLINT: exact
  Real(const Real& other) : Real() { arb_set(ball_, other.ball_); }
  Real(Real&& other) noexcept : Real() { arb_swap(ball_, other.ball_); }
  Real& operator=(const Real& other) {
    arb_set(ball_, other.ball_);
    return *this;
  }
  Real& operator=(Real&& other) noexcept {
    arb_swap(ball_, other.ball_);
    return *this;
  }
  ~Real() { arb_clear(ball_); }

  [[nodiscard]] arb_ptr get() { return ball_; }
  [[nodiscard]] arb_srcptr get() const { return ball_; }

  [[nodiscard]] static Real pi() {
    Real out;
    arb_const_pi(out.get(), working_bits);
    return out;
  }
  /// All between two exact numbers.
  [[nodiscard]] static Real between(double lower, double upper) {
    Real out;
    arf_t a, b;
    arf_init(a);
    arf_init(b);
    arf_set_d(a, lower);
    arf_set_d(b, upper);
    arb_set_interval_arf(out.get(), a, b, working_bits);
    arf_clear(a);
    arf_clear(b);
    return out;
  }
  /// The ball that exact() wrote.
  /// \return false if it wrote none such
  [[nodiscard]] static bool read(const std::string& text, Real& out) {
    return arb_load_str(out.get(), text.c_str()) == 0;
  }
  /// Midpoint and radius without loss, in hexadecimal digits.
  [[nodiscard]] std::string exact() const {
    char* text = arb_dump_str(ball_);
    std::string out = text;
    flint_free(text);
    return out;
  }

  /// a/b, or a little more.
  [[nodiscard]] static double quotient(double a, double b) {
    return (Real(a) / Real(b)).upper();
  }

  [[nodiscard]] Real middle() const {
    Real out;
    arb_get_mid_arb(out.get(), ball_);
    return out;
  }
  /// ρ as an exact number, and with it the ball about zero.
  [[nodiscard]] Real radius() const {
    Real out;
    arb_get_rad_arb(out.get(), ball_);
    return out;
  }
  [[nodiscard]] Real widened(const Real& by) const {
    Real out = *this;
    arb_add_error(out.get(), by.get());
    return out;
  }
  [[nodiscard]] double near() const {
    return arf_get_d(arb_midref(ball_), ARF_RND_NEAR);
  }
  /// A bound that no number of the ball exceeds, or that none falls below.
  [[nodiscard]] double upper() const {
    arf_t end;
    arf_init(end);
    arb_get_ubound_arf(end, ball_, working_bits);
    const double out = arf_get_d(end, ARF_RND_CEIL);
    arf_clear(end);
    return out;
  }
  [[nodiscard]] double lower() const { return -negated().upper(); }
  [[nodiscard]] Real negated() const {
    Real out;
    arb_neg(out.get(), ball_);
    return out;
  }
  [[nodiscard]] Real abs() const {
    Real out;
    arb_abs(out.get(), ball_);
    return out;
  }
  [[nodiscard]] bool finite() const { return arb_is_finite(ball_) != 0; }
  [[nodiscard]] bool positive() const { return arb_is_positive(ball_) != 0; }
  [[nodiscard]] bool has_zero() const { return arb_contains_zero(ball_) != 0; }
  /// Whether all of this lies within the other, its edge included.
  [[nodiscard]] bool within(const Real& other) const {
    return arb_contains(other.ball_, ball_) != 0;
  }
  /// The same without the edge.
  [[nodiscard]] bool inside(const Real& other) const {
    return arb_contains_interior(other.ball_, ball_) != 0;
  }

  Real& operator+=(const Real& other) { return *this = *this + other; }
  [[nodiscard]] Real operator-() const { return negated(); }
  friend Real operator+(const Real& a, const Real& b) {
    Real out;
    arb_add(out.get(), a.get(), b.get(), working_bits);
    return out;
  }
  friend Real operator-(const Real& a, const Real& b) {
    Real out;
    arb_sub(out.get(), a.get(), b.get(), working_bits);
    return out;
  }
  friend Real operator*(const Real& a, const Real& b) {
    Real out;
    arb_mul(out.get(), a.get(), b.get(), working_bits);
    return out;
  }
  friend Real operator/(const Real& a, const Real& b) {
    Real out;
    arb_div(out.get(), a.get(), b.get(), working_bits);
    return out;
  }
  friend Real sin(const Real& a) {
    Real out;
    arb_sin(out.get(), a.get(), working_bits);
    return out;
  }
  friend Real cos(const Real& a) {
    Real out;
    arb_cos(out.get(), a.get(), working_bits);
    return out;
  }
  /// \pre a > 0; of another it is no number
  friend Real sqrt(const Real& a) {
    Real out;
    arb_sqrt(out.get(), a.get(), working_bits);
    return out;
  }

 private:
  arb_t ball_;
};

/// A rectangle of complex numbers.
class Complex {
 public:
  Complex() { acb_init(box_); }
  Complex(double exact) : Complex() { acb_set_d(box_, exact); }  // NOLINT
  Complex(const Complex& other) : Complex() { acb_set(box_, other.box_); }
  Complex(Complex&& other) noexcept : Complex() { acb_swap(box_, other.box_); }
  Complex& operator=(const Complex& other) {
    acb_set(box_, other.box_);
    return *this;
  }
  Complex& operator=(Complex&& other) noexcept {
    acb_swap(box_, other.box_);
    return *this;
  }
  ~Complex() { acb_clear(box_); }

  [[nodiscard]] static Complex rectangle(const Real& real, const Real& imag) {
    Complex out;
    acb_set_arb_arb(out.box_, real.get(), imag.get());
    return out;
  }
  /// Of a real polynomial.
  [[nodiscard]] static Complex value(arb_srcptr coefficients, slong terms,
                                     const Complex& at) {
    Complex out;
    _arb_poly_evaluate_acb_horner(out.box_, coefficients, terms, at.box_,
                                  working_bits);
    return out;
  }
  /// All that lie no farther from the box than so, and more: a rectangle.
  [[nodiscard]] Complex widened(double distance) const {
    Complex out = *this;
    mag_t by;
    mag_init(by);
    mag_set_d(by, distance);
    acb_add_error_mag(out.box_, by);
    mag_clear(by);
    return out;
  }

  [[nodiscard]] acb_ptr get() { return box_; }
  [[nodiscard]] acb_srcptr get() const { return box_; }
  [[nodiscard]] bool finite() const { return acb_is_finite(box_) != 0; }
  /// A bound of the modulus.
  [[nodiscard]] double modulus() const {
    mag_t bound;
    mag_init(bound);
    acb_get_mag(bound, box_);
    const double out = mag_get_d(bound);  // upward
    mag_clear(bound);
    return out;
  }

  [[nodiscard]] Complex operator-() const {
    Complex out;
    acb_neg(out.get(), box_);
    return out;
  }
  friend Complex operator+(const Complex& a, const Complex& b) {
    Complex out;
    acb_add(out.get(), a.get(), b.get(), working_bits);
    return out;
  }
  friend Complex operator-(const Complex& a, const Complex& b) {
    Complex out;
    acb_sub(out.get(), a.get(), b.get(), working_bits);
    return out;
  }
  friend Complex operator*(const Complex& a, const Complex& b) {
    Complex out;
    acb_mul(out.get(), a.get(), b.get(), working_bits);
    return out;
  }
  /// Of a divisor that may be zero it is no number.
  friend Complex operator/(const Complex& a, const Complex& b) {
    Complex out;
    acb_div(out.get(), a.get(), b.get(), working_bits);
    return out;
  }
  friend Complex sin(const Complex& a) {
    Complex out;
    acb_sin(out.get(), a.get(), working_bits);
    return out;
  }
  friend Complex cos(const Complex& a) {
    Complex out;
    acb_cos(out.get(), a.get(), working_bits);
    return out;
  }
  /// Where it is analytic: of what may have no positive real part it is no
  /// number.
  friend Complex sqrt(const Complex& a) {
    Complex out;
    if (arb_is_positive(acb_realref(a.get())) == 0) {
      acb_indeterminate(out.get());
    } else {
      acb_sqrt(out.get(), a.get(), working_bits);
    }
    return out;
  }

 private:
  acb_t box_;
};

}  // namespace brachisto::proof
