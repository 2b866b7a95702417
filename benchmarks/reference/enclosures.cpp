// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "reference/enclosures.hpp"

#ifdef BRACHISTO_HAS_ARB

#include "proof/real.hpp"

namespace brachisto::proof {

template <class Function>
static Real applied(Function&& function, const Real& a) {
  Real out;
  function(out.get(), a.get(), working_bits);
  return out;
}
// Found by their argument, as sin() and cos() of Real are.
static Real atan(const Real& a) {
  return applied(arb_atan, a);
}
static Real sinh(const Real& a) {
  return applied(arb_sinh, a);
}
static Real cosh(const Real& a) {
  return applied(arb_cosh, a);
}
static Real atanh(const Real& a) {
  return applied(arb_atanh, a);
}

}  // namespace brachisto::proof

#include "support/closed_forms.hpp"

namespace brachisto::testing {

template <>
struct Constants<proof::Real> {
  [[nodiscard]] static proof::Real pi() { return proof::Real::pi(); }
};

}  // namespace brachisto::testing

namespace brachisto::benchmarks {

namespace {

using proof::Real;

std::optional<Enclosure> bounds(const Real& value) {
  if (!value.finite()) return std::nullopt;
  return Enclosure{value.lower(), value.upper()};
}

/// A root near a number: it is there, and the only one so near, if one step of
/// Newton's method leads inside.
template <class Equation>
std::optional<Real> root(const Equation& equation, long double low,
                         long double high) {
  const auto near = static_cast<double>(testing::bisected(
      [&](long double x) { return equation.value(x); }, low, high));
  constexpr int kSteps = 12;
  constexpr double kAround = 1e-3;
  Real in = Real::between(near - kAround, near + kAround);
  bool is_proven = false;
  for (int i = 0; i < kSteps; ++i) {
    const Real middle = in.middle();
    const Real next = middle - equation.value(middle) / equation.slope(in);
    if (!next.finite()) return std::nullopt;
    if (!next.inside(in)) break;
    is_proven = true;
    in = next;
  }
  return is_proven ? std::optional(in) : std::nullopt;
}

}  // namespace

std::optional<Enclosure> enclosed_root_of_3() {
  return bounds(sqrt(Real(3.0)));
}

std::optional<Enclosure> enclosed_least_fuel() {
  return bounds(Real(3.0) - sqrt(Real(5.0)));
}

std::optional<Enclosure> enclosed_hanging_chain() {
  const auto a = root(testing::CatenaryParameter(), 0.05L, 10.0L);
  return a ? bounds(testing::catenary_cost(*a)) : std::nullopt;
}

std::optional<Enclosure> enclosed_cycloid_time(double L) {
  const auto phi = root(testing::CycloidAngle{L}, 0.1L, 6.28L);
  return phi ? bounds(testing::cycloid_time(*phi)) : std::nullopt;
}

std::optional<Enclosure> enclosed_time_to_line(double thousand_g) {
  return bounds(testing::time_to_line(Real(thousand_g) / Real(1000.0)));
}

std::optional<Enclosure> enclosed_time_along_wall(double thousand_g) {
  return bounds(testing::time_along_wall(Real(thousand_g) / Real(1000.0)));
}

}  // namespace brachisto::benchmarks

#else

namespace brachisto::benchmarks {

std::optional<Enclosure> enclosed_root_of_3() {
  return {};
}
std::optional<Enclosure> enclosed_least_fuel() {
  return {};
}
std::optional<Enclosure> enclosed_hanging_chain() {
  return {};
}
std::optional<Enclosure> enclosed_cycloid_time(double /*L*/) {
  return {};
}
std::optional<Enclosure> enclosed_time_to_line(double /*thousand_g*/) {
  return {};
}
std::optional<Enclosure> enclosed_time_along_wall(double /*thousand_g*/) {
  return {};
}

}  // namespace brachisto::benchmarks

#endif
