// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What Matrix Market files of an answer hold is stationary, and is read back as
// it was.

#include <gtest/gtest.h>

#include <Eigen/SparseCore>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <unsupported/Eigen/SparseExtra>

#include "brachisto/study/solve.hpp"
#include "program_files/matrix_files.hpp"
#include "program_files/program_directory.hpp"
#include "support/scenes.hpp"
#include "support/scratch_directory.hpp"
#include "transcription/rolling_time.hpp"

namespace brachisto {
namespace {

namespace fs = std::filesystem;
using program_files::ProgramFormat;
using program_files::ProgramOutput;
using program_files::ProgramStart;
using testing::ScratchDirectory;

/// By a reader of others.
Eigen::SparseMatrix<double> matrix_in(const fs::path& file) {
  Eigen::SparseMatrix<double> out;
  EXPECT_TRUE(Eigen::loadMarket(out, file.string())) << file;
  return out;
}

Eigen::VectorXd vector_in(const fs::path& file) {
  std::ifstream in(file);
  std::string header;
  std::getline(in, header);
  Eigen::Index size = 0, cols = 0;
  in >> size >> cols;
  EXPECT_EQ(cols, 1);
  Eigen::VectorXd out(size);
  for (double& value : out) in >> value;
  return out;
}

std::vector<std::string> lines_in(const fs::path& file) {
  std::ifstream in(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

class MatrixFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    const Solution solution =
        solve(testing::off_centred_scene(-testing::kPi / 6.0), {});
    ASSERT_TRUE(solution.verified()) << solution.message;
    program_ = program_files::solved_program(solution);
    ASSERT_TRUE(program_);
    write_program(*program_, output_);
  }

  [[nodiscard]] fs::path file(const char* name) const {
    return directory_.path() / name;
  }

  const ScratchDirectory directory_;
  const ProgramOutput output_{ProgramFormat::Matrices, directory_.path(),
                              ProgramStart::Guess, false};
  std::optional<program_files::SolvedProgram> program_;
};

TEST_F(MatrixFiles, AreStationaryAtTheAnswer) {
  const auto J = matrix_in(file("jacobian.mtx"));
  const Eigen::VectorXd gradient = vector_in(file("gradient.mtx"));
  const Eigen::VectorXd lambda = vector_in(file("lambda.mtx"));

  const Eigen::VectorXd pull = gradient + J.transpose() * lambda;

  // The tolerance of the solve, scaled by multipliers of order one to ten.
  constexpr double kResidual = 1e-10;
  const std::vector<std::string> names = lines_in(file("program.col"));
  ASSERT_EQ(names.size(), static_cast<std::size_t>(pull.size()));
  for (int i = 0; i < program_->problem->num_variables(); ++i) {
    if (program_->problem->variable_range(i).single()) continue;
    EXPECT_NEAR(pull(i), 0.0, kResidual) << names[static_cast<std::size_t>(i)];
  }
  EXPECT_LE(vector_in(file("constraints.mtx")).cwiseAbs().maxCoeff(),
            kResidual);
}

TEST_F(MatrixFiles, HaveBothDerivativesInTheKktMatrix) {
  const auto J = matrix_in(file("jacobian.mtx"));
  const auto H = matrix_in(file("hessian.mtx"));
  const auto K = matrix_in(file("kkt.mtx"));
  const Eigen::Index n = J.cols(), m = J.rows();

  ASSERT_EQ(H.rows(), n);
  ASSERT_EQ(K.rows(), n + m);
  EXPECT_EQ(K.nonZeros(), H.nonZeros() + J.nonZeros());
  const Eigen::MatrixXd K_dense(K), J_dense(J), H_dense(H);
  EXPECT_EQ(K_dense.topLeftCorner(n, n), H_dense);
  EXPECT_EQ(K_dense.bottomLeftCorner(m, n), J_dense);
  // The lower triangle, as the format wants it.
  EXPECT_EQ(Eigen::MatrixXd(H_dense.triangularView<Eigen::StrictlyUpper>())
                .cwiseAbs()
                .maxCoeff(),
            0.0);
}

TEST_F(MatrixFiles, AreThoseOfTheProgramDigitByDigit) {
  Transcription& problem = *program_->problem;
  ASSERT_TRUE(problem.set_point(program_->answer.x));
  std::vector<double> values(problem.jac_g_pattern().num_entries());
  problem.eval_jac_g(values);
  Eigen::MatrixXd expected =
      Eigen::MatrixXd::Zero(problem.num_constraints(), problem.num_variables());
  for (std::size_t i = 0; i < values.size(); ++i) {
    expected(problem.jac_g_pattern()[i].row, problem.jac_g_pattern()[i].col) +=
        values[i];
  }

  EXPECT_EQ(Eigen::MatrixXd(matrix_in(file("jacobian.mtx"))), expected);
}

TEST(MatrixFilesOfNoPoint, AreRefusedWithTheReason) {
  RollingTime problem(testing::natural(testing::off_centred_scene(0.0)),
                      uniform_mesh(2, 3), 0.0);
  const PrimalDual nowhere{
      std::vector<double>(static_cast<std::size_t>(problem.num_variables())),
      {}};

  EXPECT_THROW(program_files::ProgramMatrices(problem, nowhere),
               std::runtime_error);
}

}  // namespace
}  // namespace brachisto
