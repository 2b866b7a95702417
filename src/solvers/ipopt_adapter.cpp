// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "solvers/ipopt_adapter.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "brachisto/math/index.hpp"

namespace brachisto {

using Ipopt::Index;
using Ipopt::Number;

namespace {

// Ipopt counts ±1e19 and beyond as "no bound".
constexpr Number kNoBound = 2e19;

/// Gives Ipopt the positions of a pattern.
void copy_pattern(const nlp::SparsityPattern& pattern, Index* rows,
                  Index* cols) {
  pattern.for_each([&](std::size_t entry, int row, int col) {
    rows[entry] = row;
    cols[entry] = col;
  });
}

}  // namespace

IpoptAdapter::IpoptAdapter(nlp::Problem& problem, const PrimalDual& start,
                           const IpoptOptions& options, const double* effort)
    : problem_(problem), start_(start), options_(options), effort_(effort) {}

template <class Evaluate>
bool IpoptAdapter::guarded(const Number* x, bool new_x, Evaluate&& evaluate) {
  // What is thrown here ends the run at once: Ipopt lets it through, catches it
  // at its own outermost call and forgets what it was.
  try {
    check_stop();
    if (new_x || !have_point_) {
      accepted_ = problem_.set_point({x, at(problem_.num_variables())});
      have_point_ = true;
      if (!accepted_) {
        ++refused_points_;
        last_refusal_ = problem_.refusal();
      }
    }
    if (accepted_) evaluate();
    return accepted_;
  } catch (...) {
    exception_ = std::current_exception();
    throw;
  }
}

// Of the gradient and the Hessian Ipopt's callers hold an array that they would
// leak if an exception passed, where variables are fixed. Of these functions it
// takes the answer false for the end, too.
template <class Evaluate>
bool IpoptAdapter::answered(const Number* x, bool new_x, Evaluate&& evaluate) {
  try {
    return guarded(x, new_x, std::forward<Evaluate>(evaluate));
  } catch (...) {
    return false;
  }
}

bool IpoptAdapter::get_nlp_info(Index& n, Index& m, Index& nnz_jac_g,
                                Index& nnz_h_lag, IndexStyleEnum& index_style) {
  n = problem_.num_variables();
  m = problem_.num_constraints();
  nnz_jac_g = static_cast<Index>(problem_.jac_g_pattern().num_entries());
  nnz_h_lag = static_cast<Index>(problem_.hess_lag_pattern().num_entries());
  index_style = C_STYLE;
  return true;
}

bool IpoptAdapter::get_bounds_info(Index n, Number* x_l, Number* x_u, Index m,
                                   Number* g_l, Number* g_u) {
  for (Index i = 0; i < n; ++i) {
    const nlp::Range range = problem_.variable_range(i);
    x_l[i] = std::max(range.lower, -kNoBound);
    x_u[i] = std::min(range.upper, kNoBound);
  }
  for (Index i = 0; i < m; ++i) {
    const nlp::Range range = problem_.constraint_range(i);
    g_l[i] = std::max(range.lower, -kNoBound);
    g_u[i] = std::min(range.upper, kNoBound);
  }
  return true;
}

bool IpoptAdapter::get_starting_point(Index n, bool init_x, Number* x,
                                      bool init_z, Number* z_L, Number* z_U,
                                      Index m, bool init_lambda,
                                      Number* lambda) {
  if (init_x) std::copy_n(start_.x.begin(), n, x);
  if (init_z) {
    // Without inequalities there are no bounds but those of fixed variables,
    // which are no variables to Ipopt.
    const auto copy = [n](const std::vector<double>& z, Number* to) {
      if (z.empty()) {
        std::fill_n(to, n, 0.0);
      } else {
        std::copy_n(z.begin(), n, to);
      }
    };
    copy(start_.z_lower, z_L);
    copy(start_.z_upper, z_U);
  }
  if (init_lambda) std::copy_n(start_.lambda.begin(), m, lambda);
  return true;
}

bool IpoptAdapter::eval_f(Index, const Number* x, bool new_x,
                          Number& obj_value) {
  return guarded(x, new_x, [&] { obj_value = problem_.eval_f(); });
}

bool IpoptAdapter::eval_grad_f(Index n, const Number* x, bool new_x,
                               Number* grad_f) {
  return answered(x, new_x, [&] { problem_.eval_grad_f({grad_f, at(n)}); });
}

bool IpoptAdapter::eval_g(Index, const Number* x, bool new_x, Index m,
                          Number* g) {
  // Ipopt 3.11.9 reads the norm of constraints it has no storage for yet if
  // this answers false at a trial point of a second-order correction, and
  // crashes. Not-a-number is refused by the same check, and safely.
  if (!guarded(x, new_x, [&] { problem_.eval_g({g, at(m)}); })) {
    std::fill_n(g, m, std::numeric_limits<Number>::quiet_NaN());
  }
  return true;
}

bool IpoptAdapter::eval_jac_g(Index, const Number* x, bool new_x, Index,
                              Index nele_jac, Index* iRow, Index* jCol,
                              Number* values) {
  if (values == nullptr) {
    copy_pattern(problem_.jac_g_pattern(), iRow, jCol);
    return true;
  }
  return guarded(x, new_x, [&] {
    problem_.eval_jac_g({values, at(nele_jac)});
  });
}

bool IpoptAdapter::eval_h(Index, const Number* x, bool new_x, Number obj_factor,
                          Index m, const Number* lambda, bool, Index nele_hess,
                          Index* iRow, Index* jCol, Number* values) {
  if (values == nullptr) {
    copy_pattern(problem_.hess_lag_pattern(), iRow, jCol);
    return true;
  }
  return answered(x, new_x, [&] {
    problem_.eval_hess_lag(obj_factor, {lambda, at(m)},
                           {values, at(nele_hess)});
  });
}

bool IpoptAdapter::intermediate_callback(Ipopt::AlgorithmMode, Index iter,
                                         Number, Number, Number, Number, Number,
                                         Number, Number, Number, Index,
                                         const Ipopt::IpoptData*,
                                         Ipopt::IpoptCalculatedQuantities*) {
  iterations_ = iter;
  if (options_.stop.met()) return false;
  tired_ = effort_ != nullptr && *effort_ > options_.most_effort;
  return !tired_;
}

void IpoptAdapter::finalize_solution(Ipopt::SolverReturn, Index n,
                                     const Number* x, const Number* z_L,
                                     const Number* z_U, Index m, const Number*,
                                     const Number* lambda, Number,
                                     const Ipopt::IpoptData*,
                                     Ipopt::IpoptCalculatedQuantities*) {
  final_point_.x.assign(x, x + n);
  final_point_.lambda.assign(lambda, lambda + m);
  if (!problem_.has_inequalities()) return;
  final_point_.z_lower.assign(z_L, z_L + n);
  final_point_.z_upper.assign(z_U, z_U + n);
}

}  // namespace brachisto
