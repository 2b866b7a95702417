// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "peers/ipopt_with_mumps.hpp"

#include <fmt/format.h>
#include <IpIpoptApplication.hpp>

#include <algorithm>

#include "solvers/ipopt_adapter.hpp"

namespace brachisto::benchmarks {

std::string MumpsOptions::str() const {
  const auto* const order =
      std::ranges::find(kPivotOrders, pivot_order, &PivotOrder::number);
  return fmt::format("{}, permuting_scaling {}, scaling {}, pivtol {:g}",
                     order->name, permuting_scaling, scaling, pivot_tolerance);
}

SolverResult solve_with_mumps(nlp::Problem& problem, const PrimalDual& start,
                              double tolerance, int max_iterations,
                              const MumpsOptions& mumps) {
  const StopCondition no_stop;
  Ipopt::SmartPtr<IpoptAdapter> adapter =
      new IpoptAdapter(problem, start, no_stop);
  Ipopt::SmartPtr<Ipopt::IpoptApplication> application =
      new Ipopt::IpoptApplication(false);
  Ipopt::OptionsList& list = *application->Options();
  list.SetStringValue("sb", "yes");
  list.SetIntegerValue("print_level", 0);
  list.SetNumericValue("tol", tolerance);
  list.SetNumericValue("constr_viol_tol", tolerance);
  list.SetIntegerValue("max_iter", max_iterations);
  list.SetIntegerValue("acceptable_iter", 0);
  list.SetStringValue("nlp_scaling_method", "none");
  list.SetStringValue("warm_start_init_point", "yes");
  list.SetNumericValue("mu_init", 1e-11);
  list.SetStringValue("linear_system_scaling", "none");
  list.SetStringValue("linear_solver", "mumps");
  list.SetIntegerValue("mumps_pivot_order", mumps.pivot_order);
  list.SetIntegerValue("mumps_permuting_scaling", mumps.permuting_scaling);
  list.SetIntegerValue("mumps_scaling", mumps.scaling);
  list.SetNumericValue("mumps_pivtol", mumps.pivot_tolerance);
  SolverResult result;
  if (application->Initialize("") != Ipopt::Solve_Succeeded) {
    result.message = "Ipopt refused its options";
    return result;
  }
  const bool solved = application->OptimizeTNLP(Ipopt::GetRawPtr(adapter)) ==
                      Ipopt::Solve_Succeeded;
  if (adapter->exception()) std::rethrow_exception(adapter->exception());
  result.status = solved ? Status::Solved : Status::NotConverged;
  result.point = adapter->final_point();
  result.iterations = adapter->iterations();
  result.refused_points = adapter->refused_points();
  result.linear_solver = LinearSolver::Mumps;
  return result;
}

}  // namespace brachisto::benchmarks
