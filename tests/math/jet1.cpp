// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/math/jet.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "support/rounding.hpp"

namespace brachisto::math {
namespace {

using testing::ulps;

/// A formula with every operation that both kinds of jets have.
template <class Jet>
Jet formula(const Jet& x, const Jet& y) {
  Jet sum = sin(x * y) + cos(x) / (y - Jet(3.0));
  sum += -sqrt(x * x + y * y) * atan(x + y);
  sum += exp(x) * log(x * x + Jet(1.0));
  return sum;
}

TEST(Jet1, HasTheGradientOfSecondOrderJets) {
  for (const auto& [a, b] : {std::pair{0.3, 1.2}, {-2.0, 0.7}, {1e-3, -4.0}}) {
    using First = Jet1<double, 2>;
    using Second = Jet2<double, 2>;

    const First got = formula(First::variable(a, 0), First::variable(b, 1));
    const Second expected =
        formula(Second::variable(a, 0), Second::variable(b, 1));

    EXPECT_NEAR(got.value, expected.value, ulps(10.0, 5.0));
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_NEAR(got.gradient[i], expected.gradient[i], ulps(20.0, 5.0));
    }
  }
}

}  // namespace
}  // namespace brachisto::math
