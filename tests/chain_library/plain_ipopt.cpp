// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// A program of someone who knows Ipopt and nothing of this project: a pendulum
// on a motor is brought to rest upside down, in a compromise of time and
// effort, by the trapezoidal rule.
//
//     plain_ipopt LINEAR_SOLVER INTERVALS
//
// prints Ipopt's status, its iterations, the cost and the seconds it took.

#include <IpIpoptApplication.hpp>
#include <IpSolveStatistics.hpp>
#include <IpTNLP.hpp>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <string>

using Ipopt::Index;
using Ipopt::Number;

namespace {

/// a' = w, w' = u − sin a, |u| ≤ 1.5; the cost is T + ∫ u².
class SwingUp final : public Ipopt::TNLP {
 public:
  explicit SwingUp(int intervals) : N_(intervals) {}

  bool get_nlp_info(Index& n, Index& m, Index& nnz_jac_g, Index& nnz_h_lag,
                    IndexStyleEnum& style) override {
    n = T() + 1;
    m = 2 * N_;
    nnz_jac_g = 12 * N_;
    nnz_h_lag = 5 * (N_ + 1);
    style = C_STYLE;
    return true;
  }
  bool get_bounds_info(Index n, Number* l, Number* u, Index m, Number* g_l,
                       Number* g_u) override {
    constexpr double kNone = 1e20, kTorque = 1.5;
    for (int i = 0; i < n; ++i) {
      const bool torque = i != T() && i % 3 == 2;
      l[i] = torque ? -kTorque : -kNone;
      u[i] = torque ? kTorque : kNone;
    }
    l[a(0)] = u[a(0)] = l[w(0)] = u[w(0)] = l[w(N_)] = u[w(N_)] = 0.0;
    l[a(N_)] = u[a(N_)] = std::numbers::pi;
    l[T()] = 0.1;
    for (int i = 0; i < m; ++i) g_l[i] = g_u[i] = 0.0;
    return true;
  }
  bool get_starting_point(Index, bool, Number* x, bool, Number*, Number*, Index,
                          bool, Number*) override {
    for (int k = 0; k <= N_; ++k) {
      x[a(k)] = std::numbers::pi * k / N_;
      x[w(k)] = 0.5;
      x[u(k)] = 0.1;
    }
    x[T()] = 6.0;
    return true;
  }
  bool eval_f(Index, const Number* x, bool, Number& f) override {
    f = x[T()] * (1.0 + effort(x));
    return true;
  }
  bool eval_grad_f(Index n, const Number* x, bool, Number* grad) override {
    for (int i = 0; i < n; ++i) grad[i] = 0.0;
    for (int k = 0; k <= N_; ++k) {
      grad[u(k)] = 2.0 * x[T()] * weight(k) * x[u(k)];
    }
    grad[T()] = 1.0 + effort(x);
    return true;
  }
  bool eval_g(Index, const Number* x, bool, Index, Number* g) override {
    const double half = 0.5 * x[T()] / N_;
    for (int k = 0; k < N_; ++k) {
      g[2 * k] = x[a(k + 1)] - x[a(k)] - half * (x[w(k)] + x[w(k + 1)]);
      g[2 * k + 1] =
          x[w(k + 1)] - x[w(k)] - half * (pull(x, k) + pull(x, k + 1));
    }
    return true;
  }
  bool eval_jac_g(Index, const Number* x, bool, Index, Index, Index* row,
                  Index* col, Number* values) override {
    int e = 0;
    const auto put = [&](int i, int j, auto&& value) {
      if (values == nullptr) {
        row[e] = i;
        col[e++] = j;
      } else {
        values[e++] = value();
      }
    };
    const auto half = [&] { return 0.5 * x[T()] / N_; };
    for (int k = 0; k < N_; ++k) {
      const int i = 2 * k;
      for (const int end : {0, 1}) {
        const int j = k + end;
        const double sign = end == 0 ? -1.0 : 1.0;
        put(i, a(j), [&] { return sign; });
        put(i, w(j), [&] { return -half(); });
        put(i + 1, a(j), [&] { return half() * std::cos(x[a(j)]); });
        put(i + 1, w(j), [&] { return sign; });
        put(i + 1, u(j), [&] { return -half(); });
      }
      put(i, T(), [&] { return -0.5 * (x[w(k)] + x[w(k + 1)]) / N_; });
      put(i + 1, T(),
          [&] { return -0.5 * (pull(x, k) + pull(x, k + 1)) / N_; });
    }
    return true;
  }
  bool eval_h(Index, const Number* x, bool, Number factor, Index,
              const Number* lambda, bool, Index, Index* row, Index* col,
              Number* values) override {
    int e = 0;
    const auto put = [&](int i, int j, auto&& value) {
      if (values == nullptr) {
        row[e] = i;
        col[e++] = j;
      } else {
        values[e++] = value();
      }
    };
    // Of the equations before and behind a node, or none.
    const auto around = [&](int k, int which) {
      return (k > 0 ? lambda[2 * k - 2 + which] : 0.0) +
             (k < N_ ? lambda[2 * k + which] : 0.0);
    };
    for (int k = 0; k <= N_; ++k) {
      put(a(k), a(k), [&] {
        return -0.5 * x[T()] / N_ * around(k, 1) * std::sin(x[a(k)]);
      });
      put(u(k), u(k), [&] { return 2.0 * factor * x[T()] * weight(k); });
      put(T(), a(k),
          [&] { return 0.5 / N_ * around(k, 1) * std::cos(x[a(k)]); });
      put(T(), w(k), [&] { return -0.5 / N_ * around(k, 0); });
      put(T(), u(k), [&] {
        return 2.0 * factor * weight(k) * x[u(k)] - 0.5 / N_ * around(k, 1);
      });
    }
    return true;
  }
  void finalize_solution(Ipopt::SolverReturn, Index, const Number*,
                         const Number*, const Number*, Index, const Number*,
                         const Number*, Number f, const Ipopt::IpoptData*,
                         Ipopt::IpoptCalculatedQuantities*) override {
    cost = f;
  }

  double cost = 0.0;

 private:
  [[nodiscard]] static int a(int k) { return 3 * k; }
  [[nodiscard]] static int w(int k) { return 3 * k + 1; }
  [[nodiscard]] static int u(int k) { return 3 * k + 2; }
  [[nodiscard]] int T() const { return 3 * (N_ + 1); }
  [[nodiscard]] double weight(int k) const {
    return (k == 0 || k == N_ ? 0.5 : 1.0) / N_;
  }
  [[nodiscard]] static double pull(const Number* x, int k) {
    return x[u(k)] - std::sin(x[a(k)]);
  }
  [[nodiscard]] double effort(const Number* x) const {
    double sum = 0.0;
    for (int k = 0; k <= N_; ++k) sum += weight(k) * x[u(k)] * x[u(k)];
    return sum;
  }

  int N_;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const Ipopt::SmartPtr<Ipopt::IpoptApplication> ipopt =
      IpoptApplicationFactory();
  ipopt->Options()->SetIntegerValue("print_level", 0);
  ipopt->Options()->SetStringValue("sb", "yes");
  ipopt->Options()->SetStringValue("linear_solver", argv[1]);
  ipopt->Options()->SetNumericValue("tol", 1e-10);
  if (ipopt->Initialize("") != Ipopt::Solve_Succeeded) return 3;
  const Ipopt::SmartPtr<SwingUp> problem = new SwingUp(std::atoi(argv[2]));
  const auto begin = std::chrono::steady_clock::now();
  const int status = ipopt->OptimizeTNLP(GetRawPtr(problem));
  const std::chrono::duration<double> taken =
      std::chrono::steady_clock::now() - begin;
  const bool counted = IsValid(ipopt->Statistics());
  std::printf("%d %d %.15g %.4g\n", status,
              counted ? ipopt->Statistics()->IterationCount() : -1,
              problem->cost, taken.count());
  return status == Ipopt::Solve_Succeeded ? 0 : 1;
}
