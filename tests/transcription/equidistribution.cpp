// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/ocp/mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <vector>

#include "derivatives/problems.hpp"

namespace brachisto::testing {
namespace {

/// The model that elements are shared out by: an element of length h has the
/// error C h^(2p+1), C varying along the path. For a C that varies within the
/// element, (∫ C^(1/(2p+1)) dσ)^(2p+1).
class MadeUpError {
 public:
  MadeUpError(int degree, std::function<double(double)> constant)
      : degree_(degree), constant_(std::move(constant)) {}

  [[nodiscard]] std::vector<double> shares(const Mesh& mesh) const {
    constexpr int kParts = 50;
    const double order = 2.0 * degree_ + 1.0;
    std::vector<double> out;
    for (int e = 0; e < mesh.num_elements(); ++e) {
      const double h = mesh.length(e) / kParts;
      double mass = 0.0;
      for (int i = 0; i < kParts; ++i) {
        const double sigma =
            mesh.boundaries[static_cast<std::size_t>(e)] + (i + 0.5) * h;
        mass += h * std::pow(constant_(sigma), 1.0 / order);
      }
      out.push_back(std::pow(mass, order));
    }
    return out;
  }

 private:
  int degree_;
  std::function<double(double)> constant_;
};

double growing(double sigma) {
  return std::exp(8.0 * sigma);
}
double peaked(double sigma) {
  return 1.0 / (1e-2 + std::pow(sigma - 0.6, 2));
}

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

void expect_a_mesh(const Mesh& mesh) {
  ASSERT_GE(mesh.boundaries.size(), 2u);
  EXPECT_EQ(mesh.boundaries.front(), 0.0);
  EXPECT_EQ(mesh.boundaries.back(), 1.0);
  for (int e = 0; e < mesh.num_elements(); ++e) {
    EXPECT_GT(mesh.length(e), 0.0) << "element " << e;
  }
}

TEST(Equidistribution, GivesEveryElementTheSameShare) {
  for (const auto& constant : {growing, peaked}) {
    for (int p = 1; p <= 5; ++p) {
      const MadeUpError error(p, constant);
      const Mesh mesh = uniform_mesh(p, 200);
      const std::vector<double> before = error.shares(mesh);

      const Mesh after = equidistribute(mesh, before, 1e-3 * sum(before));

      expect_a_mesh(after);
      EXPECT_EQ(after.degree, p);
      // The density is taken as constant in each old element, where log C
      // changes by up to 10/200: the mass of a new element is off by half of
      // that, its share by 2p + 1 times as much, at either of its ends.
      const double tolerance = 0.03 * (2.0 * p + 1.0);
      const std::vector<double> shares = error.shares(after);
      const auto [least, most] =
          std::minmax_element(shares.begin(), shares.end());
      EXPECT_LE(*most / *least, 1.0 + tolerance) << "degree " << p;
    }
  }
}

TEST(Equidistribution, MeetsItsTarget) {
  for (const auto& constant : {growing, peaked}) {
    for (int p = 1; p <= 5; ++p) {
      const MadeUpError error(p, constant);
      const Mesh mesh = uniform_mesh(p, 100);
      const std::vector<double> before = error.shares(mesh);
      for (const double factor : {1e-3, 1e-1, 10.0}) {
        const double target = factor * sum(before);

        const Mesh after = equidistribute(mesh, before, target);

        // The number of elements is rounded up to the next one, and lies
        // between a quarter and some eight times what it was.
        const double n = after.num_elements();
        const double least = std::pow((n - 1.0) / n, 2.0 * p);
        if (n < 800.0) {
          EXPECT_LE(sum(error.shares(after)), 1.05 * target)
              << "degree " << p << " factor " << factor;
        }
        if (n > 25.0) {
          EXPECT_GE(sum(error.shares(after)), 0.95 * least * target)
              << "degree " << p << " factor " << factor;
        }
      }
    }
  }
}

TEST(Equidistribution, NeedsElementsLikeTheErrorToTheOneOverTwoP) {
  // N (mass/N)^(2p+1) = target: N ~ target^(−1/2p), but for rounding up.
  for (int p = 1; p <= 6; ++p) {
    const MadeUpError error(p, growing);
    const Mesh mesh = uniform_mesh(p, 100);
    const std::vector<double> shares = error.shares(mesh);
    const double total = sum(shares);
    // The constant from a target met exactly by 100 equal shares.
    const auto count = [&](double factor) {
      return static_cast<double>(
          equidistribute(mesh, shares, factor * total).num_elements());
    };
    // Within the bounds of a quarter and eight times the old number.
    const double wide = std::pow(2.0, 2.0 * p);

    for (const double ratio : {wide, 1.0 / wide}) {
      const double expected = count(1.0) * std::pow(ratio, -1.0 / (2.0 * p));
      EXPECT_NEAR(count(ratio), expected, 2.0) << "degree " << p;
    }
  }
}

TEST(Equidistribution, DoesNotMindSigns) {
  const Mesh mesh = uniform_mesh(3, 20);
  std::vector<double> errors = MadeUpError(3, peaked).shares(mesh);
  const Mesh expected = equidistribute(mesh, errors, 1e-3 * sum(errors));
  const double target = 1e-3 * sum(errors);
  for (std::size_t e = 0; e < errors.size(); e += 2) errors[e] = -errors[e];

  EXPECT_EQ(equidistribute(mesh, errors, target).boundaries,
            expected.boundaries);
}

TEST(Equidistribution, SurvivesSharesThatVanish) {
  const Mesh mesh = uniform_mesh(4, 10);
  std::vector<double> one(10, 0.0);
  one[3] = 1e-8;

  expect_a_mesh(equidistribute(mesh, one, 1e-10));
  expect_a_mesh(equidistribute(mesh, std::vector<double>(10, 0.0), 1e-10));
}

TEST(Equidistribution, HalvesEveryElementWhereAnErrorIsNoNumber) {
  const Mesh mesh = graded_mesh(3, 7);
  for (const double unknown : {std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::infinity()}) {
    std::vector<double> errors(7, 1e-8);
    errors[2] = unknown;

    const Mesh after = equidistribute(mesh, errors, 1e-10, 5, 1.0);

    expect_a_mesh(after);
    EXPECT_EQ(after.degree, 5);
    ASSERT_EQ(after.num_elements(), 14);
    for (std::size_t e = 0; e <= 7; ++e) {
      EXPECT_NEAR(after.boundaries[2 * e], mesh.boundaries[e], 1e-15);
    }
  }
}

TEST(Equidistribution, KeepsAtLeastAQuarterAndFour) {
  const Mesh mesh = uniform_mesh(3, 100);
  const std::vector<double> errors(100, 1e-12);

  EXPECT_EQ(equidistribute(mesh, errors, 1.0).num_elements(), 25);
  EXPECT_EQ(equidistribute(uniform_mesh(3, 6), std::vector(6, 1e-12), 1.0)
                .num_elements(),
            4);
}

TEST(Stretch, KeepsTheMeshIfTheCountDoes) {
  const Mesh mesh = graded_mesh(2, 9);

  const Mesh same = stretch(mesh, 9);

  ASSERT_EQ(same.num_elements(), 9);
  EXPECT_EQ(same.degree, 2);
  for (std::size_t i = 0; i < same.boundaries.size(); ++i) {
    EXPECT_NEAR(same.boundaries[i], mesh.boundaries[i], 1e-15) << i;
  }
}

TEST(Stretch, CutsOrJoinsElementsEvenly) {
  const Mesh mesh = graded_mesh(3, 12);

  const Mesh fine = stretch(mesh, 36);
  const Mesh coarse = stretch(mesh, 4);

  expect_a_mesh(fine);
  expect_a_mesh(coarse);
  ASSERT_EQ(fine.num_elements(), 36);
  ASSERT_EQ(coarse.num_elements(), 4);
  for (std::size_t e = 0; e < 12; ++e) {
    const double h = mesh.length(static_cast<int>(e)) / 3.0;
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(fine.boundaries[3 * e + i],
                  mesh.boundaries[e] + static_cast<double>(i) * h, 1e-15);
    }
  }
  for (std::size_t e = 0; e <= 4; ++e) {
    EXPECT_NEAR(coarse.boundaries[e], mesh.boundaries[3 * e], 1e-15);
  }
}

}  // namespace
}  // namespace brachisto::testing
