// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The library by the names of MA97, as Ipopt calls them, against dense
// factorisations and eigenvalues.

#include "solvers/ma97.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cstdlib>
#include <vector>

#include "chain_library/kkt_matrix.hpp"

extern "C" {
void ma97_default_control_d(ma97_control_d*);
void ma97_analyse_d(int, int, const int*, const int*, double*, void**,
                    const ma97_control_d*, ma97_info_d*, int*);
void ma97_factor_d(int, const int*, const int*, const double*, void**, void**,
                   const ma97_control_d*, ma97_info_d*, const double*);
void ma97_solve_d(int, int, double*, int, void**, void**, const ma97_control_d*,
                  ma97_info_d*);
void ma97_finalise_d(void**, void**);
}

namespace brachisto::testing {
namespace {

/// One matrix, and another one of its pattern.
class Ma97 {
 public:
  explicit Ma97(const Eigen::MatrixXd& K, bool from_one = true) : K_(K) {
    const int n = static_cast<int>(K.rows()), first = from_one ? 1 : 0;
    ma97_default_control_d(&control_);
    control_.f_arrays = first;
    ptr_.push_back(first);
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j <= i; ++j) {
        if (K(i, j) == 0.0 && i != j) continue;
        row_.push_back(j + first);
      }
      ptr_.push_back(static_cast<int>(row_.size()) + first);
    }
    set(K);
    ma97_analyse_d(0, n, ptr_.data(), row_.data(), nullptr, &akeep_, &control_,
                   &info, nullptr);
  }
  ~Ma97() { ma97_finalise_d(&akeep_, &fkeep_); }
  Ma97(const Ma97&) = delete;
  Ma97& operator=(const Ma97&) = delete;

  /// Another matrix of the pattern.
  void set(const Eigen::MatrixXd& K) {
    values_.clear();
    for (int i = 0; i < K_.rows(); ++i) {
      for (int j = 0; j <= i; ++j) {
        if (K_(i, j) != 0.0 || i == j) values_.push_back(K(i, j));
      }
    }
  }
  int factor() {
    ma97_factor_d(4, ptr_.data(), row_.data(), values_.data(), &akeep_, &fkeep_,
                  &control_, &info, nullptr);
    return info.flag;
  }
  [[nodiscard]] Eigen::VectorXd solve(Eigen::VectorXd b) {
    ma97_solve_d(0, 1, b.data(), static_cast<int>(b.size()), &akeep_, &fkeep_,
                 &control_, &info);
    return b;
  }

  ma97_info_d info{};

 private:
  Eigen::MatrixXd K_;
  std::vector<int> ptr_, row_;
  std::vector<double> values_;
  void* akeep_ = nullptr;
  void* fkeep_ = nullptr;
  ma97_control_d control_{};
};

TEST(ChainLibrary, SolvesWithTheInertiaOfTheMatrix) {
  for (std::uint32_t seed = 1; seed <= 12; ++seed) {
    Random random(seed);
    const Eigen::MatrixXd K =
        kkt_matrix(60, 1 + static_cast<int>(seed % 3), 1, random);
    const Eigen::Index n = K.rows();
    Ma97 matrix(K, seed % 2 == 0);
    ASSERT_EQ(matrix.info.flag, 0);

    ASSERT_EQ(matrix.factor(), 0) << seed;

    // Eigenvalues are exact to n u ‖K‖, and none is near 0 where the condition
    // is far below 1/u.
    const Eigen::FullPivLU<Eigen::MatrixXd> lu(K);
    ASSERT_GT(lu.rcond(), 1e-10);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(
        K, Eigen::EigenvaluesOnly);
    EXPECT_EQ(matrix.info.num_neg, (eigen.eigenvalues().array() < 0.0).count())
        << seed;
    EXPECT_EQ(matrix.info.matrix_rank, n);
    Eigen::VectorXd expected(n);
    for (double& x : expected) x = random.uniform(-1.0, 1.0);
    // Ipopt 3.14 hands over what happens to be there.
    matrix.info.flag = -777;
    const Eigen::VectorXd x = matrix.solve(K * expected);
    EXPECT_EQ(matrix.info.flag, 0);
    EXPECT_GT(matrix.info.num_neg, 0);
    // Backward stable, so that the error is some n u over the condition.
    constexpr double kRoundoff = 1.1e-16, kGrowth = 64.0;
    EXPECT_LE((x - expected).cwiseAbs().maxCoeff(),
              kGrowth * static_cast<double>(n) * kRoundoff / lu.rcond())
        << seed;
  }
}

TEST(ChainLibrary, FindsTheChainAnewWhereTheFirstValuesHideIt) {
  Random random(2);
  const Eigen::MatrixXd K = kkt_matrix(60, 2, 1, random);
  Ma97 matrix(K);
  matrix.set(Eigen::MatrixXd::Zero(K.rows(), K.cols()));
  EXPECT_EQ(matrix.factor(), kMa97Singular);
  EXPECT_EQ(matrix.info.matrix_rank, 0);
  matrix.set(K);

  EXPECT_EQ(matrix.factor(), 0);

  Ma97 fresh(K);
  EXPECT_EQ(fresh.factor(), 0);
  EXPECT_EQ(matrix.info.num_neg, fresh.info.num_neg);
}

TEST(ChainLibrary, SaysWhatIsSingular) {
  Random random(5);
  Eigen::MatrixXd K = kkt_matrix(60, 2, 1, random);
  // The same equation twice.
  Eigen::Index one = 0;
  while (K(one, one) != 0.0) ++one;
  Eigen::MatrixXd more = Eigen::MatrixXd::Zero(K.rows() + 1, K.rows() + 1);
  more.topLeftCorner(K.rows(), K.rows()) = K;
  more.bottomLeftCorner(1, K.rows()) = K.row(one);
  more.topRightCorner(K.rows(), 1) = K.col(one);
  Ma97 matrix(more);

  EXPECT_EQ(matrix.factor(), kMa97Singular);
  EXPECT_EQ(matrix.info.matrix_rank, K.rows());
}

TEST(ChainLibrary, RefusesWhatIsNoChain) {
  Random random(1);
  Eigen::MatrixXd K = Eigen::MatrixXd::Identity(400, 400);
  for (int i = 0; i < 400; ++i) {
    for (int k = 0; k < 10; ++k) {
      const int j = static_cast<int>(random.uniform(0.0, 400.0));
      K(i, j) = K(j, i) = 1.0;
    }
  }
  Ma97 matrix(K);
  EXPECT_EQ(matrix.factor(), kMa97GivenUp);

  // In a process of its own, where it was not said before.
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(
      {
        matrix.factor();
        matrix.factor();
        std::exit(0);
      },
      ::testing::ExitedWithCode(0),
      "^brachisto-chain: the matrix is no chain of small blocks; take another "
      "linear solver, or set BRACHISTO_CHAIN_FALLBACK=mumps\n$");
}

}  // namespace
}  // namespace brachisto::testing
