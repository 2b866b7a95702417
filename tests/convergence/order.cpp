// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Collocation of degree p converges with order 2p, in T and, because the end
// angle comes from the costates, in β_end too.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <ostream>

#include "brachisto/study/solve.hpp"
#include "study/answer_kinds.hpp"
#include "support/observed_order.hpp"
#include "support/reference_values.hpp"

namespace brachisto {
namespace {

using testing::observed_order;
using testing::reference;
using testing::ReferenceValue;

// Meshes are chosen so that the constant C of an error C h^2p drifts by less
// than a fifth from the coarsest to the finest, which differ by a factor of
// four thirds to eight: a slope wrong by less than log(6/5)/log(4/3) = 0.6 at
// the very worst, and half of that by least squares over all four. 0.35 tells
// 2p from 2p ± 1, and from the p + 1 of an extrapolated end angle (p > 1).
constexpr double kSlopeTolerance = 0.35;

enum class Figure { Tau, EndAngle };

struct OrderCase {
  const ReferenceValue* row;
  Figure figure;
  int degree;
  // Finest error ≥ 1e-12 of τ and 1e-11 of β_end: ten times the digits that
  // the reference lacks.
  std::array<int, 4> elements;
};

std::ostream& operator<<(std::ostream& out, const OrderCase& c) {
  return out << c.row->name << ", degree " << c.degree << ", "
             << (c.figure == Figure::Tau ? "tau" : "end angle");
}

constexpr const ReferenceValue* kBase = &reference("reference_case");
constexpr const ReferenceValue* kTurned = &reference("theta_-30");

// Two series are missing because τ passes the exact value on its way, its
// errors of order 2p and 2p + 2 being of opposite sign: p = 3 of the base case
// (near N = 20), and p = 4 of the other one (no four meshes above rounding).
constexpr std::array kOrderCases{
    OrderCase{kBase, Figure::Tau, 1, {20, 40, 80, 160}},
    OrderCase{kBase, Figure::Tau, 2, {16, 32, 64, 128}},
    OrderCase{kBase, Figure::Tau, 4, {18, 20, 22, 24}},
    OrderCase{kBase, Figure::EndAngle, 1, {20, 40, 80, 160}},
    OrderCase{kBase, Figure::EndAngle, 2, {24, 48, 96, 192}},
    OrderCase{kBase, Figure::EndAngle, 3, {20, 24, 28, 32}},
    OrderCase{kBase, Figure::EndAngle, 4, {18, 20, 22, 24}},
    OrderCase{kTurned, Figure::Tau, 1, {20, 40, 80, 160}},
    OrderCase{kTurned, Figure::Tau, 2, {16, 32, 64, 128}},
    OrderCase{kTurned, Figure::Tau, 3, {24, 28, 32, 40}},
    OrderCase{kTurned, Figure::EndAngle, 1, {20, 40, 80, 160}},
    OrderCase{kTurned, Figure::EndAngle, 2, {20, 40, 80, 160}},
    OrderCase{kTurned, Figure::EndAngle, 3, {20, 24, 28, 32}},
    OrderCase{kTurned, Figure::EndAngle, 4, {16, 20, 24, 28}},
};

class RollingTimeOrder : public ::testing::TestWithParam<OrderCase> {};
INSTANTIATE_TEST_SUITE_P(Degrees, RollingTimeOrder,
                         ::testing::ValuesIn(kOrderCases));

TEST_P(RollingTimeOrder, IsTwiceTheDegree) {
  const OrderCase& c = GetParam();
  std::array<double, 4> h{};
  std::array<double, 4> error{};

  for (std::size_t i = 0; i < h.size(); ++i) {
    SolveOptions options;
    Discretisation& mesh = options.use<Collocation>().discretisation;
    mesh.degree = c.degree;
    mesh.elements = c.elements[i];
    const Solution solution = solve(c.row->scene(), options);
    ASSERT_TRUE(trajectory_of(solution)) << solution.message;
    h[i] = 1.0 / c.elements[i];
    error[i] =
        c.figure == Figure::Tau
            ? std::abs(solution.motion()->tau() / c.row->tau - 1.0)
            : std::abs(solution.motion()->end_angle() - c.row->end_angle);
  }

  EXPECT_NEAR(observed_order(h, error), 2.0 * c.degree, kSlopeTolerance)
      << "errors " << error[0] << ", " << error[1] << ", " << error[2] << ", "
      << error[3];
}

TEST(ClosedForm, IsMetToRoundingByAModestMesh) {
  // The cycloid is entire in σ: the error falls faster than any power of h and
  // is below rounding for p = 5 and N = 8; what is left is the KKT tolerance.
  constexpr double kRounding = 1e-12;
  const ReferenceValue& row = reference("uniform_L3");
  SolveOptions options;
  Discretisation& mesh = options.use<Collocation>().discretisation;
  mesh.degree = 5;
  mesh.elements = 8;

  const Solution solution = solve(row.scene(), options);

  ASSERT_TRUE(trajectory_of(solution));
  EXPECT_NEAR(solution.motion()->tau(), row.tau, kRounding * row.tau);
  EXPECT_NEAR(solution.motion()->end_angle(), row.end_angle, kRounding);
}

}  // namespace
}  // namespace brachisto
