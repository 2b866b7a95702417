// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A register full of numbers, as a scalar that formulas are asked with.

#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace brachisto::lanes {

/// A register of so many numbers, and their bits. (A size that a template tells
/// is one that g++ 12 forgets.)
template <std::size_t Count>
struct Register;
template <>
struct Register<2> {
  typedef double Numbers __attribute__((vector_size(16)));
  typedef std::int64_t Bits __attribute__((vector_size(16)));
};
template <>
struct Register<4> {
  typedef double Numbers __attribute__((vector_size(32)));
  typedef std::int64_t Bits __attribute__((vector_size(32)));
};
template <>
struct Register<8> {
  typedef double Numbers __attribute__((vector_size(64)));
  typedef std::int64_t Bits __attribute__((vector_size(64)));
};

/// Numbers side by side, each treated alike and none looking at its neighbours.
///
/// All operations are those of IEEE 754 in a fixed order, sine and cosine
/// included, so that the digits are the same on every processor, however many
/// of the numbers its registers hold.
///
/// \tparam Set  of instructions: code compiled for different ones has different
///              names, and the linker cannot take one for the other
/// \tparam Count  of numbers
template <int Set, std::size_t Count>
struct Lane {
  using Numbers = typename Register<Count>::Numbers;
  using Bits = typename Register<Count>::Bits;

  static constexpr std::size_t kCount = Count;

  using Constant = Lane;  ///< bodies differ: see math::ConstantOf

  Numbers v;

  Lane() = default;
  Lane(double all) : v(all - Numbers{}) {}  // NOLINT: numbers are lanes
  explicit Lane(const Numbers& numbers) : v(numbers) {}

  [[nodiscard]] double operator[](std::size_t i) const { return v[i]; }
  void set(std::size_t i, double number) { v[i] = number; }

  Lane& operator+=(const Lane& b) { return v += b.v, *this; }
  Lane& operator-=(const Lane& b) { return v -= b.v, *this; }
  [[nodiscard]] Lane operator-() const { return Lane(Numbers(-v)); }
  friend Lane operator+(const Lane& a, const Lane& b) {
    return Lane(Numbers(a.v + b.v));
  }
  friend Lane operator-(const Lane& a, const Lane& b) {
    return Lane(Numbers(a.v - b.v));
  }
  friend Lane operator*(const Lane& a, const Lane& b) {
    return Lane(Numbers(a.v * b.v));
  }
  friend Lane operator/(const Lane& a, const Lane& b) {
    return Lane(Numbers(a.v / b.v));
  }

  /// A decision about each: all bits or none.
  struct Mask {
    Bits bits;
    friend Mask operator&(const Mask& a, const Mask& b) {
      return {a.bits & b.bits};
    }
    friend Mask operator|(const Mask& a, const Mask& b) {
      return {a.bits | b.bits};
    }
    [[nodiscard]] Mask operator!() const { return {~bits}; }
  };
  friend Mask operator>(const Lane& a, const Lane& b) {
    return {Bits(a.v > b.v)};
  }
  friend Mask operator<(const Lane& a, const Lane& b) {
    return {Bits(a.v < b.v)};
  }
  friend Lane where(const Mask& mask, const Lane& a, const Lane& b) {
    return Lane(Numbers(mask.bits ? a.v : b.v));
  }
  friend bool any(const Mask& mask) {
    std::int64_t bits = 0;
    for (std::size_t i = 0; i < Count; ++i) bits |= mask.bits[i];
    return bits != 0;
  }
  /// The largest absolute value; one that is no number says nothing of the
  /// others.
  friend double magnitude(const Lane& a) {
    double largest = 0.0;
    for (std::size_t i = 0; i < Count; ++i) {
      const double number = std::abs(a.v[i]);
      if (number > largest) largest = number;
    }
    return largest;
  }

  friend Lane abs(const Lane& a) { return where(a < Lane(0.0), -a, a); }
  friend Lane sqrt(const Lane& a) {
    Lane out;
#if defined(__AVX512F__)
    // Without a mask g++ 12 warns of its own header.
    if constexpr (Count == 8) {
      out.v = Numbers(_mm512_maskz_sqrt_pd(0xff, __m512d(a.v)));
      return out;
    }
#endif
#if defined(__AVX__)
    if constexpr (Count % 4 == 0) {
      const auto* from = reinterpret_cast<const double*>(&a.v);
      auto* to = reinterpret_cast<double*>(&out.v);
      for (std::size_t i = 0; i < Count; i += 4) {
        _mm256_storeu_pd(to + i, _mm256_sqrt_pd(_mm256_loadu_pd(from + i)));
      }
      return out;
    }
#endif
#if defined(__SSE2__)
    const auto* from = reinterpret_cast<const double*>(&a.v);
    auto* to = reinterpret_cast<double*>(&out.v);
    for (std::size_t i = 0; i < Count; i += 2) {
      _mm_storeu_pd(to + i, _mm_sqrt_pd(_mm_loadu_pd(from + i)));
    }
#else
    for (std::size_t i = 0; i < Count; ++i) out.v[i] = std::sqrt(a.v[i]);
#endif
    return out;
  }
  friend Lane sin(const Lane& a) {
    return Reduced(a).sine(0);
  }
  friend Lane cos(const Lane& a) {
    return Reduced(a).sine(1);
  }

 private:
  /// An angle as n π/2 + r with |r| ≤ π/4, for |n| < 2²⁰, and sine and cosine
  /// of r by the polynomials of FDLIBM (Sun Microsystems 1993), within 1 ulp.
  struct Reduced {
    Numbers s, c;
    Bits n;

    explicit Reduced(const Lane& a) {
      constexpr double kTwoOverPi = 6.36619772367581382433e-01;
      constexpr double kHalfPi1 = 1.57079632673412561417e+00;  // 33 bits of π/2
      constexpr double kHalfPi2 = 6.07710050650619224932e-11;  // the rest
      constexpr double kWhole = 6755399441055744.0;            // 1.5 · 2⁵²
      const Numbers sum = a.v * kTwoOverPi + kWhole;
      n = Bits(sum);
      const Numbers k = sum - kWhole;
      const Numbers r = (a.v - k * kHalfPi1) - k * kHalfPi2;
      const Numbers z = r * r;
      constexpr double kS1 = -1.66666666666666324348e-01,
                       kS2 = 8.33333333332248946124e-03,
                       kS3 = -1.98412698298579493134e-04,
                       kS4 = 2.75573137070700676789e-06,
                       kS5 = -2.50507602534068634195e-08,
                       kS6 = 1.58969099521155010221e-10;
      constexpr double kC1 = 4.16666666666666019037e-02,
                       kC2 = -1.38888888888741095749e-03,
                       kC3 = 2.48015872894767294178e-05,
                       kC4 = -2.75573143513906633035e-07,
                       kC5 = 2.08757232129817482790e-09,
                       kC6 = -1.13596475577881948265e-11;
      s = r +
          r * z *
              (kS1 + z * (kS2 + z * (kS3 + z * (kS4 + z * (kS5 + z * kS6)))));
      c = (1.0 - 0.5 * z) +
          z * z *
              (kC1 + z * (kC2 + z * (kC3 + z * (kC4 + z * (kC5 + z * kC6)))));
    }
    /// Of the angle and so many right angles more.
    [[nodiscard]] Lane sine(std::int64_t more) const {
      const Bits turns = n + more;
      const Numbers even = (turns & 1) != 0 ? c : s;
      return Lane(Numbers(Bits(even) ^ ((turns & 2) << 62)));
    }
  };
};

}  // namespace brachisto::lanes
