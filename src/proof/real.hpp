// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Balls of real numbers, as Arb has them: every result encloses
/// all that its operands enclose. Numbers of 64 bits are exact.

#pragma once

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

  [[nodiscard]] static Real pi() { return made(arb_const_pi, working_bits); }
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

  [[nodiscard]] Real middle() const { return made(arb_get_mid_arb, ball_); }
  /// ρ as an exact number, and with it the ball about zero.
  [[nodiscard]] Real radius() const { return made(arb_get_rad_arb, ball_); }
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
  [[nodiscard]] Real negated() const { return made(arb_neg, ball_); }
  [[nodiscard]] Real abs() const { return made(arb_abs, ball_); }
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
    return made(arb_add, a.get(), b.get(), working_bits);
  }
  friend Real operator-(const Real& a, const Real& b) {
    return made(arb_sub, a.get(), b.get(), working_bits);
  }
  friend Real operator*(const Real& a, const Real& b) {
    return made(arb_mul, a.get(), b.get(), working_bits);
  }
  friend Real operator/(const Real& a, const Real& b) {
    return made(arb_div, a.get(), b.get(), working_bits);
  }
  friend Real sin(const Real& a) {
    return made(arb_sin, a.get(), working_bits);
  }
  friend Real cos(const Real& a) {
    return made(arb_cos, a.get(), working_bits);
  }
  /// \pre a > 0; of another it is no number
  friend Real sqrt(const Real& a) {
    return made(arb_sqrt, a.get(), working_bits);
  }

 private:
  /// What a function of Arb puts out.
  template <class Function, class... Arguments>
  [[nodiscard]] static Real made(Function function, Arguments... arguments) {
    Real out;
    function(out.get(), arguments...);
    return out;
  }

  arb_t ball_;
};

}  // namespace brachisto::proof
