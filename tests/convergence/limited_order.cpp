// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// On arcs whose ends are found, collocation of degree p converges with its full
// order 2p − 1 although the control jumps where limits begin to hold.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>
#include <string>

#include "brachisto/study/solve.hpp"
#include "support/limited_scenes.hpp"
#include "support/observed_order.hpp"

namespace brachisto {
namespace {

using testing::LimitedReference;
using testing::observed_order;

// Junctions cut the path anywhere, so that the elements of an arc double only
// about when those of the path do: their number is rounded, and an error C h^q
// keeps its C within a factor of two over meshes that differ by eight. That is
// a slope wrong by log 2/log 8 = 1/3 at most, which tells 2p − 1 from 2p − 2
// and 2p.
constexpr double kLimitedSlopeTolerance = 0.35;

struct LimitedOrderCase {
  std::string row;
  int degree;
};
std::ostream& operator<<(std::ostream& out, const LimitedOrderCase& c) {
  return out << c.row << ", degree " << c.degree;
}

// One row for each kind of limit: forces, curvature, a floor, optimal contacts.
// The finest error is 1e-11 at least, a hundred units of the reference's last
// digit.
const std::array kLimitedOrderCases{
    LimitedOrderCase{"friction_3", 1},
    LimitedOrderCase{"friction_3", 2},
    LimitedOrderCase{"friction_3", 3},
    LimitedOrderCase{"friction_0.3", 2},
    LimitedOrderCase{"normal_min_0.1", 1},
    LimitedOrderCase{"normal_min_0.1", 2},
    LimitedOrderCase{"normal_min_0.1", 3},
    LimitedOrderCase{"valley_4", 1},
    LimitedOrderCase{"valley_4", 3},
    LimitedOrderCase{"floor_0.8", 1},
    LimitedOrderCase{"floor_0.8", 2},
    LimitedOrderCase{"floor_0.8", 3},
    LimitedOrderCase{"optimal_K2", 2},
};

class LimitedOrder : public ::testing::TestWithParam<LimitedOrderCase> {};

INSTANTIATE_TEST_SUITE_P(Rows, LimitedOrder,
                         ::testing::ValuesIn(kLimitedOrderCases));

TEST_P(LimitedOrder, IsTwiceTheDegreeLessOne) {
  const LimitedOrderCase& c = GetParam();
  const auto rows = testing::limited_references();
  const auto row = std::ranges::find(rows, c.row, &LimitedReference::name);
  ASSERT_NE(row, rows.end());
  std::array<double, 4> h{};
  std::array<double, 4> error{};

  int elements = c.degree < 3 ? 20 : 12;
  for (std::size_t i = 0; i < h.size(); ++i, elements *= 2) {
    SolveOptions options;
    Discretisation& mesh = options.use<Collocation>().discretisation;
    mesh.degree = c.degree;
    mesh.elements = elements;
    const Solution solution = solve(row->scene, options);
    ASSERT_TRUE(solution.motion()) << solution.message;
    h[i] = 1.0 / elements;
    error[i] = std::abs(solution.motion()->tau() / row->tau - 1.0);
  }

  EXPECT_NEAR(observed_order(h, error), 2.0 * c.degree - 1.0,
              kLimitedSlopeTolerance)
      << "errors " << error[0] << ", " << error[1] << ", " << error[2] << ", "
      << error[3];
}

}  // namespace
}  // namespace brachisto
