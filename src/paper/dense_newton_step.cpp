// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <Eigen/Dense>
#include <array>

#include "paper/chord_jets.hpp"
#include "paper/layout.hpp"
#include "paper/newton_steps.hpp"

namespace brachisto::paper {

namespace {

/// Derivative of the variations (18) with respect to one unknown, forwards
/// through θ and backwards through λ.
class Column {
 public:
  Column(const DiscreteVariations& system, const ChordJets& jets)
      : jets_(jets),
        release_(system.reading().datum == DiscreteReading::Datum::Release),
        n_(system.num_nodes()),
        tangent_(at(n_ - 1)),
        lambda_(at(n_ - 1)) {}

  /// \param unknown  number of an x or a z
  /// \param values   of the rows of inner nodes, from node 1 on
  template <class Values>
  void differentiate(int unknown, Values&& values) {
    forwards(unknown);
    backwards();
    for (int j = 1; j + 1 < n_; ++j) {
      values(j - 1) = change(j - 1, kRightDrop) + change(j, kLeftDrop);
    }
  }

 private:
  using Tangent = std::array<double, kNumLocals>;

  void forwards(int unknown) {
    const Columns column{n_};
    double theta = 0.0;
    for (int i = 0; i + 1 < n_; ++i) {
      Tangent& t = tangent_[at(i)];
      const auto moved = [&](int which) {
        return unknown == which ? 1.0 : 0.0;
      };
      const double level = release_ ? moved(column.z(0)) : 0.0;
      t[kDx] = moved(column.x(i + 1)) - moved(column.x(i));
      t[kLeftDrop] = moved(column.z(i)) - level;
      t[kRightDrop] = moved(column.z(i + 1)) - level;
      t[kLeftTheta] = theta;
      const auto& slope = jets_.length(i).gradient;
      theta += jets_.turns() *
               (slope[kDx] * t[kDx] + slope[kLeftDrop] * t[kLeftDrop] +
                slope[kRightDrop] * t[kRightDrop]);
      t[kRightTheta] = theta;
    }
  }

  void backwards() {
    double lambda = 0.0;
    for (int i = n_ - 2; i >= 0; --i) {
      lambda += second(i, kRightTheta);
      if (i + 2 < n_) lambda += second(i + 1, kLeftTheta);
      lambda_[at(i)] = lambda;
    }
  }

  /// Change of ∂(q_i + λ_i l_i/r)/∂a at fixed λ_i.
  [[nodiscard]] double second(int i, int a) const {
    double sum = 0.0;
    for (int b = 0; b < kNumLocals; ++b) {
      sum += jets_.curvature(i, a, b) * tangent_[at(i)][at(b)];
    }
    return sum;
  }

  [[nodiscard]] double change(int i, int a) const {
    return second(i, a) +
           lambda_[at(i)] * jets_.turns() * jets_.length(i).gradient[at(a)];
  }

  const ChordJets& jets_;
  bool release_;
  int n_;
  std::vector<Tangent> tangent_;
  std::vector<double> lambda_;
};

}  // namespace

bool DenseNewtonStep::operator()(std::span<const double> unknowns,
                                 std::span<const double> residual,
                                 std::span<double> step) const {
  const int n = system_.num_nodes();
  const int size = system_.num_unknowns();
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(size, size);
  for_conditions(system_, unknowns,
                 [&](int row, int col, double value) { J(row, col) += value; });
  const ChordJets jets(system_, unknowns);
  Column column(system_, jets);
  for (int unknown = 0; unknown < 2 * n; ++unknown) {
    column.differentiate(unknown,
                         J.col(unknown).segment(Rows{n}.variation(1), n - 2));
  }
  if (!J.allFinite()) return false;
  const Eigen::PartialPivLU<Eigen::MatrixXd> lu(J);
  const Eigen::Map<const Eigen::VectorXd> F(residual.data(), size);
  Eigen::Map<Eigen::VectorXd> solution(step.data(), size);
  solution = -lu.solve(F);
  return solution.allFinite();
}

double DenseNewtonStep::memory_bytes(int num_nodes) {
  const double size = 2.0 * num_nodes + 1.0;
  return 2.0 * size * size * sizeof(double);
}

}  // namespace brachisto::paper
