// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "proof/flow.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "proof/scenes.hpp"
#include "proof/theorems.hpp"

namespace brachisto {
namespace {

using namespace proof;
using brachisto::testing::bead;

/// y' = f(y) of one component, expanded from a number of 64 bits.
template <class Rate>
std::vector<Real> series_of(const Rate& rate, double start, int terms) {
  Tape tape;
  const Tape::Recording recording(tape);
  const Node y = tape.input(0);
  TaylorSeries series(tape, {rate(y)}, terms);
  series.expand({Real(start)});
  std::vector<Real> out(static_cast<std::size_t>(terms) + 1);
  for (std::size_t k = 0; k < out.size(); ++k) {
    arb_set(out[k].get(), series.input(0) + k);
  }
  return out;
}

Real factorial(int k) {
  Real out(1.0);
  for (int i = 2; i <= k; ++i) out = out * Real(static_cast<double>(i));
  return out;
}

// y' = √(1 − y²) is the sine.
TEST(TaylorSeries, OfARootIsTheSine) {
  constexpr int kTerms = 21;
  const auto found = series_of(
      [](const Node& y) { return sqrt(Node(1.0) - y * y); }, 0.0, kTerms);
  for (int k = 0; k <= kTerms; ++k) {
    const Real exact =
        k % 2 == 0 ? Real(0.0) : Real(k % 4 == 1 ? 1.0 : -1.0) / factorial(k);
    const Real off = found[static_cast<std::size_t>(k)] - exact;
    EXPECT_TRUE(off.has_zero()) << k;
    EXPECT_LT(off.radius().upper(), 1e-60) << k;
  }
}

// Of y = 1 + u nothing can be divided by u, and of y − 1 once.
TEST(Step, DividesOutOnlyWhatVanishes) {
  Tape tape;
  std::vector<Node> rates;
  {
    const Tape::Recording recording(tape);
    rates = {tape.input(0) * Node(0.0) + Node(1.0)};
  }
  Integration flow(tape, rates, {});
  State state{Real(1.0)};
  flow.go(state, Real(0.5), false, [](const Step& step) {
    if (step.begin > 0.0) return;
    const Real u(0x1p-4);
    EXPECT_THROW((void)step.value(0, u, 1), NotProven);
    EXPECT_TRUE(Real(1.0).within(step.value(0, u, 1, 1.0)));
    EXPECT_THROW((void)step.value(0, u, 2, 1.0), NotProven);
    EXPECT_TRUE(u.within(step.value(0, u, 0, 1.0)));
  });
}

// y' = cos² y is arctan, 1/(1 + u²) its rate.
TEST(TaylorSeries, OfSinesIsTheArcTangent) {
  constexpr int kTerms = 21;
  const auto found = series_of(
      [](const Node& y) {
        return Node(1.0) / (Node(1.0) + sin(y) * sin(y) / (cos(y) * cos(y)));
      },
      0.0, kTerms);
  for (int k = 0; k <= kTerms; ++k) {
    const Real exact = k % 2 == 0 ? Real(0.0)
                                  : Real(k % 4 == 1 ? 1.0 : -1.0) /
                                        Real(static_cast<double>(k));
    EXPECT_TRUE((found[static_cast<std::size_t>(k)] - exact).has_zero()) << k;
  }
}

/// E on a disc, of y' = f(y) from 0; none if no bound is found.
template <class Rate>
double left_out(const Rate& rate, double rho, int terms) {
  Tape tape;
  const Tape::Recording recording(tape);
  const Node y = tape.input(0);
  TaylorSeries series(tape, {rate(y)}, terms);
  series.expand({Real(0.0)});
  Tails tails(series);
  tails.take(rho);
  return tails.bound(rho) ? tails.input(0) : -1.0;
}

constexpr int kKnown = 21;

/// Σ_{k > N} |c_k| ρ^k from the closed form of c_k.
template <class Coefficient>
double exactly_left_out(const Coefficient& coefficient, double rho) {
  double out = 0.0;
  for (int k = kKnown + 1; k < 400; ++k) {
    out += std::fabs(coefficient(k)) * std::pow(rho, k);
  }
  return out;
}

// arctan by sines, and by a quotient of them; the sine by a root: bounds are
// never too small, and of the first two near. Terms of the root cancel, which
// norms do not see.
TEST(Tails, BoundWhatKnownSeriesLeaveOut) {
  const auto arc_tangent = [](const Node& y) {
    return cos(y) * cos(y) + Node(0.0) * sin(y);
  };
  const auto quotient = [](const Node& y) {
    return Node(1.0) / (Node(1.0) + sin(y) * sin(y) / (cos(y) * cos(y)));
  };
  constexpr double kNear = 20.0;
  const auto odd = [](int k) { return k % 2 == 0 ? 0.0 : 1.0 / k; };
  const auto root = [](const Node& y) { return sqrt(Node(1.0) - y * y); };
  const auto of_sine = [](int k) {
    return k % 2 == 0 ? 0.0 : 1.0 / std::tgamma(k + 1.0);
  };
  for (const auto& [found, exact] :
       {std::pair{left_out(arc_tangent, 0.7, kKnown),
                  exactly_left_out(odd, 0.7)},
        std::pair{left_out(quotient, 0.4, kKnown), exactly_left_out(odd, 0.4)},
        std::pair{left_out(root, 0.5, kKnown),
                  exactly_left_out(of_sine, 0.5)}}) {
    EXPECT_GE(found, exact);
    EXPECT_LE(found, kNear * exact + 1e-20);
  }
}

// tan u from 1 + y²: bounds exist up to near its pole at π/2 and none beyond,
// nor of the arc tangent beyond its own at i.
TEST(Tails, HaveNoBoundBeyondAPole) {
  const auto tangent = [](const Node& y) { return Node(1.0) + y * y; };
  EXPECT_GT(left_out(tangent, 1.2, kKnown), 0.0);
  EXPECT_LT(left_out(tangent, 1.58, kKnown), 0.0);
  const auto arc_tangent = [](const Node& y) {
    return cos(y) * cos(y) + Node(0.0) * sin(y);
  };
  EXPECT_LT(left_out(arc_tangent, 1.01, kKnown), 0.0);
}

/// The cycloid of a bead from rest, −p_x = c: β = π/2 − c u/2 and
/// w = sin(c u/2)/c, exactly.
Vector cycloid(const Real& c) {
  return {-c, Real(0.0), Real(0.0), Real(0.0)};
}

// In these units p_w(0) = −2, and 1 + w (p_x cos β + p_z sin β) + p_w sin β/2 =
// 0 along x' = w cos β, w' = sin β/2.
TEST(Flow, EnclosesTheCycloid) {
  const Accuracy accuracy;
  const Bits bits(accuracy.bits);
  const Scene scene = bead();
  const PlainSystem ends(scene);
  const Real c(0.75), length(2.5);
  Flow flow(scene, 3, accuracy);
  State state = ends.start(cycloid(c), 3);
  const int steps = flow.go(state, length);
  const Real angle = c * length * Real(0.5);
  const Real turned = Real::pi() * Real(0.5) - state[kBeta];
  EXPECT_TRUE((turned - angle).has_zero()) << turned.near() / angle.near();
  EXPECT_TRUE((state[kW] - sin(angle) / c).has_zero());
  EXPECT_TRUE((state[kTime] - length).has_zero());
  // x = (u/2 − sin(c u)/(2 c))/c
  const Real x = (length - sin(c * length) / c) / (Real(2.0) * c);
  EXPECT_TRUE((state[kX] - x).has_zero());
  EXPECT_LT(state[kX].radius().upper(), 1e-25);
  // ∂β/∂p_x = u/2
  EXPECT_TRUE(
      (state[Equations::place(kBeta, 0)] - length * Real(0.5)).has_zero());
  EXPECT_GT(steps, 5);
}

// Another end than an extremal's cannot be reached by going on beyond its
// start: w changes its sign there and the next cusp is conjugate.
TEST(Family, IsFoundConjugateBeyondTheStart) {
  const Accuracy accuracy{.bits = 128, .terms = 38};
  const Bits bits(accuracy.bits);
  const Scene scene = bead();
  const PlainSystem ends(scene);
  const Real length(2.5);
  Flow flow(scene, 0, accuracy);
  State end = ends.start(cycloid(Real(0.75)), 0);
  flow.go(end, length);
  EXPECT_TRUE(no_conjugate_point(scene, end, length, accuracy).holds);
  const Theorem beyond =
      no_conjugate_point(scene, end, length * Real(6.0), accuracy);
  EXPECT_FALSE(beyond.holds);
  EXPECT_TRUE(beyond.refuted);
  EXPECT_NE(beyond.why_not.find("conjugate"), std::string::npos);
}

}  // namespace
}  // namespace brachisto
