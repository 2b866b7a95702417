// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

#include "math/dense.hpp"
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
    column.differentiate(
        unknown, J.col(unknown).segment(EquationRows{n}.variation(1), n - 2));
  }
  if (!J.allFinite()) return false;
  const Eigen::Map<const Eigen::VectorXd> F(residual.data(), size);
  Eigen::Map<Eigen::VectorXd> solution(step.data(), size);
  solution = -math::solve_square(J, F);
  return solution.allFinite();
}

double DenseNewtonStep::memory_bytes(int num_nodes) {
  const double size = 2.0 * num_nodes + 1.0;
  return 2.0 * size * size * sizeof(double);
}

namespace {

/// Where θ and λ stand behind the unknowns of DiscreteVariations: θ at the
/// right end of a chord, λ of the chord. Their rows are that of
/// θ_i + l_i/r = θ_{i+1} and that of ∂/∂θ_{i+1}.
struct Lifted {
  int n;
  [[nodiscard]] int theta(int chord) const { return 2 * n + 1 + chord; }
  [[nodiscard]] int lambda(int chord) const { return 3 * n + chord; }
  [[nodiscard]] int size() const { return 4 * n - 1; }
};

/// Calls put(row, column, value) for every entry of the lifted matrix, always
/// the same ones in the same order.
template <class Put>
void for_entries(const DiscreteVariations& system,
                 std::span<const double> unknowns, Put&& put) {
  const int n = system.num_nodes();
  const EquationRows row{n};
  const Columns column{n};
  const Lifted lifted{n};
  const bool release =
      system.reading().datum == DiscreteReading::Datum::Release;
  const ChordJets jets(system, unknowns);
  for_conditions(system, unknowns, put);
  // A row of locals of chord i becomes a row of unknowns.
  const auto put_locals = [&](int to, int i, auto&& value) {
    put(to, column.x(i), -value(kDx));
    put(to, column.x(i + 1), value(kDx));
    put(to, column.z(i), value(kLeftDrop));
    put(to, column.z(i + 1), value(kRightDrop));
    if (release) put(to, column.z(0), -value(kLeftDrop) - value(kRightDrop));
    if (i > 0) put(to, lifted.theta(i - 1), value(kLeftTheta));
    put(to, lifted.theta(i), value(kRightTheta));
  };
  // The row in which the derivative with respect to a local is a part.
  const auto put_derivative = [&](int to, int i, Local local) {
    put_locals(to, i, [&](int b) { return jets.curvature(i, local, b); });
    put(to, lifted.lambda(i),
        jets.turns() * jets.length(i).gradient[at(local)]);
  };
  for (int i = 0; i + 1 < n; ++i) {
    if (i > 0) put_derivative(row.variation(i), i, kLeftDrop);
    if (i + 2 < n) put_derivative(row.variation(i + 1), i, kRightDrop);
    // ∂/∂θ_{i+1}: q_i + q_{i+1} − λ_i + λ_{i+1}.
    put_derivative(lifted.lambda(i), i, kRightTheta);
    put(lifted.lambda(i), lifted.lambda(i), -1.0);
    if (i > 0) {
      put_derivative(lifted.lambda(i - 1), i, kLeftTheta);
      put(lifted.lambda(i - 1), lifted.lambda(i), 1.0);
    }
    put_locals(lifted.theta(i), i, [&](int b) {
      const double slope = jets.turns() * jets.length(i).gradient[at(b)];
      return slope + (b == kLeftTheta ? 1.0 : b == kRightTheta ? -1.0 : 0.0);
    });
  }
}

/// Node by node; z_1 and S, which occur everywhere, come last.
nlp::EliminationOrder order(int n) {
  const EquationRows row{n};
  const Columns column{n};
  const Lifted lifted{n};
  nlp::EliminationOrder out;
  const auto pair = [&](int col, int r) {
    out.columns.push_back(col);
    out.rows.push_back(r);
  };
  for (int j = 0; j < n; ++j) {
    pair(column.x(j), j == 0 ? row.start_x() : row.chord(j - 1));
    if (j > 0) {
      pair(column.z(j), j + 1 < n ? row.variation(j) : row.end_z());
      pair(lifted.theta(j - 1), lifted.theta(j - 1));
    }
    if (j + 1 < n) pair(lifted.lambda(j), lifted.lambda(j));
  }
  pair(column.z(0), row.start_z());
  pair(column.S(), row.end_x());
  out.border = 2;
  return out;
}

}  // namespace

LiftedNewtonStep::LiftedNewtonStep(const DiscreteVariations& system)
    : system_(system) {}

LiftedNewtonStep::~LiftedNewtonStep() = default;

bool LiftedNewtonStep::operator()(std::span<const double> unknowns,
                                  std::span<const double> residual,
                                  std::span<double> step) {
  const int n = system_.num_nodes();
  nlp::SparsityPattern pattern;
  std::vector<double> values;
  values.reserve(num_entries_);
  for_entries(system_, unknowns, [&](int row, int col, double value) {
    values.push_back(value);
    if (!lu_) pattern.add(row, col);
  });
  if (!lu_) lu_ = std::make_unique<SparseLu>(pattern, order(n));
  num_entries_ = values.size();
  if (!std::all_of(values.begin(), values.end(),
                   [](double value) { return std::isfinite(value); }) ||
      !lu_->factorise(values)) {
    return false;
  }
  std::vector<double> rhs(at(Lifted{n}.size()), 0.0);
  std::transform(residual.begin(), residual.end(), rhs.begin(),
                 [](double value) { return -value; });
  const std::vector<double> solution = lu_->solve(rhs);
  std::copy_n(solution.begin(), step.size(), step.begin());
  return std::all_of(step.begin(), step.end(),
                     [](double value) { return std::isfinite(value); });
}

int LiftedNewtonStep::num_unknowns(int num_nodes) {
  return Lifted{num_nodes}.size();
}

double LiftedNewtonStep::memory_bytes() const {
  constexpr double kPerEntry = 2.0 * sizeof(double) + 2.0 * sizeof(int);
  return lu_ ? lu_->peak_bytes() + kPerEntry * static_cast<double>(num_entries_)
             : 0.0;
}

}  // namespace brachisto::paper
