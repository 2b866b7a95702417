// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "solvers/inertia.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "brachisto/math/index.hpp"
#include "nlp/active_set.hpp"
#include "solvers/chain_ldlt.hpp"
#include "solvers/mumps.hpp"
#include "solvers/one_at_a_time.hpp"

namespace brachisto {

namespace {

/// The inertia from the two arrays of values, by MUMPS.
///
/// \param below  −δ, on the diagonal of the constraints
Inertia mumps_inertia(const nlp::Problem& problem, const nlp::ActiveSet& active,
                      std::span<const double> hess, std::span<const double> jac,
                      double below = 0.0) {
  const OneAtATime one_at_a_time;
  // Numbers of the unknowns from 1 on; 0 for what is no part of the matrix.
  int size = 0;
  std::vector<int> variable, row;
  for (const nlp::Held held : active.variables) {
    variable.push_back(held == nlp::Held::No ? ++size : 0);
  }
  for (const nlp::Held held : active.constraints) {
    row.push_back(held == nlp::Held::No ? 0 : ++size);
  }
  std::vector<int> rows;
  std::vector<int> cols;
  std::vector<double> values;
  const auto put = [&](int i, int j, double value) {
    if (i == 0 || j == 0) return;
    rows.push_back(i);
    cols.push_back(j);
    values.push_back(value);
  };
  problem.hess_lag_pattern().for_each([&](std::size_t entry, int i, int j) {
    put(variable[at(i)], variable[at(j)], hess[entry]);
  });
  problem.jac_g_pattern().for_each([&](std::size_t entry, int i, int j) {
    put(row[at(i)], variable[at(j)], jac[entry]);
  });
  if (below != 0.0) {
    for (const int i : row) put(i, i, below);
  }
  // These have no inertia, and MUMPS would look for room to put pivots off.
  if (!std::ranges::all_of(values, [](double v) { return std::isfinite(v); })) {
    return {};
  }
  return Mumps(dmumps_c).factorise(size, std::move(rows), std::move(cols),
                                   std::move(values));
}

}  // namespace

Inertia kkt_inertia(nlp::Problem& problem, const PrimalDual& point,
                    LinearSolver solver) {
  const nlp::ActiveSet active = nlp::active_set(problem, point);
  if (!problem.set_point(point.x)) {
    throw std::domain_error("KKT inertia: " + problem.refusal());
  }
  std::vector<double> hess(problem.hess_lag_pattern().num_entries());
  problem.eval_hess_lag(1.0, point.lambda, hess);
  std::vector<double> jac(problem.jac_g_pattern().num_entries());
  problem.eval_jac_g(jac);

  const auto despite_dependence = [&]() -> Inertia {
    if (solver == LinearSolver::Chain) return {};
    constexpr double kBelow = -1e-8;
    Inertia found = mumps_inertia(problem, active, hess, jac, kBelow);
    found.known = found.known && found.positive == active.num_free();
    return found;
  };
  if (active.num_equations() > active.num_free()) return despite_dependence();
  Inertia inertia;
  if (solver != LinearSolver::Mumps) {
    const std::unique_ptr<ChainLdlt> chain = make_chain_ldlt(problem, active);
    const std::array<std::span<const double>, 2> values = {hess, jac};
    if (chain && chain->factorise(values)) inertia = chain->inertia();
  }
  if (!inertia.known && solver != LinearSolver::Chain) {
    inertia = mumps_inertia(problem, active, hess, jac);
  }
  const bool beyond = inertia.known && inertia.positive > active.num_free();
  return beyond ? despite_dependence() : inertia;
}

}  // namespace brachisto
