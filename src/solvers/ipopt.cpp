// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/solvers/program_solvers.hpp"

#include <dmumps_c.h>
#include <fmt/format.h>
#include <mumps_compat.h>
#include <IpIpoptApplication.hpp>
#include <IpIpoptData.hpp>
#include <IpTimingStatistics.hpp>

#include <algorithm>
#include <array>
#include <cstdarg>
#include <cstdio>
#include <exception>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>

#include "brachisto/math/clock.hpp"
#include "brachisto/nlp/problem.hpp"
#include "solvers/chain_hook.hpp"
#include "solvers/ipopt_adapter.hpp"
#include "solvers/ma97_functions.hpp"
#include "solvers/one_at_a_time.hpp"

namespace brachisto {

namespace {

// Ipopt's differences are one-sided and err by some 1e-8 to 1e-7. Releases up
// to 3.11 compare that with the larger of an entry and one, 3.14 with the entry
// itself, so that a right one of 1e-3 is off by 3e-5.
constexpr double kDerivativeTolerance =
    IPOPT_VERSION_MAJOR == 3 && IPOPT_VERSION_MINOR < 14 ? 1e-5 : 1e-4;

void set_linear_solver(Ipopt::OptionsList& list, LinearSolver solver) {
  list.SetStringValue("linear_system_scaling", "none");
  if (solver == LinearSolver::Chain) {
    // In the place of MA97, see ChainHook. There is no pivot tolerance to
    // increase, nor a scaling to choose.
    list.SetStringValue("linear_solver", "ma97");
    list.SetStringValue("ma97_scaling", "none");
    list.SetNumericValue("ma97_u", 1e-8);
    list.SetNumericValue("ma97_umax", 1e-8);
    return;
  }
  list.SetStringValue("linear_solver", "mumps");
  // QAMD copes with the dense column of the global unknown.
  list.SetIntegerValue("mumps_pivot_order", 6);
  list.SetIntegerValue("mumps_scaling", 0);
  list.SetIntegerValue("mumps_permuting_scaling", 0);
}

/// What inequalities need besides.
void set_barrier_options(Ipopt::OptionsList& list, const IpoptOptions& options,
                         nlp::Problem& problem, const PrimalDual& start) {
  // Bounds hold as they are given, and complementarity like all conditions.
  list.SetNumericValue("bound_relax_factor", 0.0);
  list.SetNumericValue("compl_inf_tol",
                       options.complementarity.value_or(options.tolerance));
  // Where complementarity is wanted smaller than residuals, these are not asked
  // to follow the barrier parameter below what they have to be.
  if (options.complementarity) {
    list.SetNumericValue(
        "barrier_tol_factor",
        std::max(10.0, options.tolerance / *options.complementarity));
  }
  // Where a cold start begins, and a warm one at most.
  constexpr double kLargestBarrier = 0.1;
  double barrier = kLargestBarrier;
  if (!start.lambda.empty() && problem.set_point(start.x)) {
    const double there = nlp::kkt_residual(problem, start).barrier_parameter;
    barrier = std::min(
        std::max(0.1 * options.complementarity.value_or(options.tolerance),
                 there),
        kLargestBarrier);
    // So far may the start be moved away from its bounds; multipliers and
    // distances of order one have this as their partners.
    for (const char* push :
         {"warm_start_bound_push", "warm_start_bound_frac",
          "warm_start_slack_bound_push", "warm_start_slack_bound_frac",
          "warm_start_mult_bound_push"}) {
      list.SetNumericValue(push, barrier);
    }
  }
  list.SetNumericValue("mu_init", barrier);
  // A start that keeps no longer to all bounds is far from all barrier
  // problems; one that goes down step by step creeps along its bounds.
  list.SetStringValue("mu_strategy", "adaptive");
}

void set_options(Ipopt::OptionsList& list, const IpoptOptions& options,
                 nlp::Problem& problem, const PrimalDual& start) {
  list.SetStringValue("sb", "yes");
  list.SetIntegerValue("print_level", 0);
  list.SetNumericValue("tol", options.tolerance);
  list.SetNumericValue("constr_viol_tol", options.tolerance);
  list.SetIntegerValue("max_iter", options.max_iterations);
  // The wall clock is ours to watch; Ipopt knows processor time only.
  list.SetNumericValue("max_cpu_time", 1e20);
  // Solved means solved: no second, looser tolerance.
  list.SetIntegerValue("acceptable_iter", 0);
  // Problems come in natural units and with scaled defects.
  list.SetStringValue("nlp_scaling_method", "none");
  list.SetStringValue("fixed_variable_treatment", "make_parameter");
  if (problem.hess_lag_pattern().num_entries() == 0) {
    // Second derivatives that nobody knows are built up from gradients.
    list.SetStringValue("hessian_approximation", "limited-memory");
  }
  // Without it a NaN in the Hessian surfaces as a failed restoration.
  list.SetStringValue("check_derivatives_for_naninf", "yes");
  if (problem.has_inequalities()) {
    set_barrier_options(list, options, problem, start);
  } else {
    // There is no barrier to follow.
    list.SetNumericValue("mu_init", 1e-11);
  }
  if (!start.lambda.empty()) {
    list.SetStringValue("warm_start_init_point", "yes");
  }
  if (options.check_derivatives) {
    list.SetStringValue("derivative_test", "second-order");
    list.SetNumericValue("derivative_test_tol", kDerivativeTolerance);
    // Ipopt would move the start by up to 10, to where nothing is defined.
    list.SetNumericValue("point_perturbation_radius", 0.0);
  }
}

/// What Ipopt says of its own outcome, and what that means here.
struct Outcome {
  Ipopt::ApplicationReturnStatus code;
  Status status;
  std::string_view words;
};

const Outcome& outcome_of(Ipopt::ApplicationReturnStatus code) {
  using namespace Ipopt;
  constexpr Status kFailed = Status::NotConverged;
  constexpr Status kFault = Status::InternalError;
  static constexpr std::array kOutcomes{
      Outcome{Solve_Succeeded, Status::Solved, "optimal solution found"},
      Outcome{User_Requested_Stop, Status::TimeLimit, "stopped on request"},
      Outcome{Maximum_Iterations_Exceeded, Status::IterationLimit,
              "iteration limit exceeded"},
      Outcome{Maximum_CpuTime_Exceeded, Status::TimeLimit,
              "processor time exceeded"},
      Outcome{Insufficient_Memory, Status::OutOfMemory, "not enough memory"},
      Outcome{Invalid_Number_Detected, Status::NotEvaluable,
              "a function value or derivative is not finite"},
      Outcome{Solved_To_Acceptable_Level, kFailed, "acceptable level only"},
      Outcome{Infeasible_Problem_Detected, Status::Infeasible,
              "converged to a point of local infeasibility"},
      Outcome{Search_Direction_Becomes_Too_Small, kFailed,
              "search direction becomes too small"},
      Outcome{Diverging_Iterates, kFailed, "iterates diverge"},
      Outcome{Feasible_Point_Found, kFailed, "feasible point found"},
      Outcome{Restoration_Failed, kFailed, "restoration failed"},
      Outcome{Error_In_Step_Computation, kFailed, "error in step computation"},
      Outcome{Not_Enough_Degrees_Of_Freedom, kFault,
              "fewer variables than constraints"},
      Outcome{Invalid_Problem_Definition, kFault, "invalid problem definition"},
      Outcome{Invalid_Option, kFault, "invalid option"},
      Outcome{Unrecoverable_Exception, kFault, "unrecoverable exception"},
      Outcome{NonIpopt_Exception_Thrown, kFault, "foreign exception"},
      Outcome{Internal_Error, kFault, "internal error"}};
  static constexpr Outcome kUnknown{Internal_Error, kFault,
                                    "unknown return code"};
  const auto* const found =
      std::find_if(kOutcomes.begin(), kOutcomes.end(),
                   [&](const Outcome& one) { return one.code == code; });
  return found == kOutcomes.end() ? kUnknown : *found;
}

Status status_of(const Outcome& outcome, const StopCondition& stop,
                 bool at_refused_point, bool tired) {
  // A stop makes the adapter refuse points, which Ipopt answers in many ways.
  if (outcome.status != Status::Solved && stop.met()) return stopped_by(stop);
  if (outcome.status != Status::Solved && tired) return Status::IterationLimit;
  if (outcome.status == Status::NotConverged && at_refused_point) {
    return Status::NotEvaluable;
  }
  return outcome.status;
}

/// MUMPS running out of workspace surfaces as a failed restoration; only the
/// journal tells.
bool memory_failure(std::string_view log) {
  return log.find("MUMPS returned INFO(1) = -9") != std::string_view::npos ||
         log.find("MUMPS returned INFO(1) =-13") != std::string_view::npos ||
         log.find("not enough memory") != std::string_view::npos;
}

/// Ipopt's log, in which the chain solver goes by the name of the one whose
/// interface it is called through: under its own name.
std::string with_its_own_name(std::string log) {
  // The longer first, for the others are part of it.
  const std::string_view own = name(LinearSolver::Chain);
  for (const std::string_view other :
       {"Ma97SolverInterface", "HSL_MA97", "MA97", "ma97"}) {
    for (std::size_t at = log.find(other); at != std::string::npos;
         at = log.find(other, at + own.size())) {
      log.replace(at, other.size(), own);
    }
  }
  return log;
}

/// What MUMPS took, as far as Ipopt times it: with the factorisation comes what
/// Ipopt itself does in its primal-dual system, such as residuals.
void book_linear_solver(Ipopt::IpoptApplication& application) {
  if (!Ipopt::IsValid(application.IpoptDataObject())) return;
  Ipopt::TimingStatistics& times = application.IpoptDataObject()->TimingStats();
  const double analysis =
      times.LinearSystemSymbolicFactorization().TotalCpuTime();
  const double solution = times.LinearSystemBackSolve().TotalCpuTime();
  const double all = times.PDSystemSolverTotal().TotalCpuTime();
  move_phase_seconds(Phase::Ipopt, Phase::SetUp, analysis);
  move_phase_seconds(Phase::Ipopt, Phase::Solution, solution);
  move_phase_seconds(Phase::Ipopt, Phase::Factorisation,
                     std::max(0.0, all - analysis - solution));
}

/// Throws on what ended a run, unless it is that `stop` was met.
void rethrow(const std::exception_ptr& thrown, const StopCondition& stop) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const Stopped&) {
    if (!stop.met()) throw;
  }
}

/// Reads from the first line of the journal which release of Ipopt is at work,
/// before the hook is called: what was compiled against need not be what was
/// loaded.
class ReleaseReader final : public Ipopt::Journal {
 public:
  explicit ReleaseReader(ChainHook& hook)
      : Ipopt::Journal("release", Ipopt::J_ITERSUMMARY), hook_(hook) {}

  bool IsAccepted(Ipopt::EJournalCategory category,
                  Ipopt::EJournalLevel level) const override {
    return hook_.release.empty() && category == Ipopt::J_MAIN &&
           level == Ipopt::J_ITERSUMMARY;
  }

 private:
  void PrintImpl(Ipopt::EJournalCategory, Ipopt::EJournalLevel,
                 const char* line) override {
    int version[3];
    if (std::sscanf(line, "This is Ipopt version %d.%d.%d", &version[0],
                    &version[1], &version[2]) == 3) {
      hook_.release =
          fmt::format("{}.{}.{}", version[0], version[1], version[2]);
    }
  }
  void PrintfImpl(Ipopt::EJournalCategory category, Ipopt::EJournalLevel level,
                  const char* format, va_list arguments) override {
    std::array<char, 256> line{};
    std::vsnprintf(line.data(), line.size(), format, arguments);
    PrintImpl(category, level, line.data());
  }
  void FlushBufferImpl() override {}

  ChainHook& hook_;
};

/// All options of Ipopt with their defaults, once for all runs: to register
/// them takes as long as two iterations of a small problem.
/// \pre  OneAtATime, for they count their references
const Ipopt::SmartPtr<Ipopt::RegisteredOptions>& registered_options() {
  static const Ipopt::SmartPtr<Ipopt::RegisteredOptions> kRegistered = [] {
    Ipopt::SmartPtr<Ipopt::RegisteredOptions> registered =
        new Ipopt::RegisteredOptions();
    Ipopt::IpoptApplication::RegisterAllIpoptOptions(registered);
    return registered;
  }();
  return kRegistered;
}

/// Without a journal, and with all options as they are by default.
Ipopt::SmartPtr<Ipopt::IpoptApplication> new_application() {
  Ipopt::SmartPtr<Ipopt::Journalist> journalist = new Ipopt::Journalist();
  Ipopt::SmartPtr<Ipopt::RegisteredOptions> registered = registered_options();
  return new Ipopt::IpoptApplication(
      registered, new Ipopt::OptionsList(registered, journalist), journalist);
}

/// One run with the chain, if its hook is in force, or MUMPS.
SolverResult run(nlp::Problem& problem, const PrimalDual& start,
                 const IpoptOptions& options, ChainHook* hook) {
  const LinearSolver solver =
      hook != nullptr ? LinearSolver::Chain : LinearSolver::Mumps;
  Ipopt::SmartPtr<IpoptAdapter> adapter = new IpoptAdapter(
      problem, start, options, hook != nullptr ? &hook->effort : nullptr);
  Ipopt::SmartPtr<Ipopt::IpoptApplication> application = new_application();

  std::ostringstream log;
  Ipopt::SmartPtr<Ipopt::StreamJournal> journal = new Ipopt::StreamJournal(
      "log", options.verbose || options.check_derivatives
                 ? Ipopt::J_ITERSUMMARY
                 : Ipopt::J_STRONGWARNING);
  journal->SetOutputStream(&log);
  application->Jnlst()->AddJournal(Ipopt::GetRawPtr(journal));

  if (hook != nullptr) {
    application->Jnlst()->AddJournal(new ReleaseReader(*hook));
  }

  set_options(*application->Options(), options, problem, start);
  set_linear_solver(*application->Options(), solver);
  SolverResult result;
  result.linear_solver = solver;
  // The empty name keeps a stray ipopt.opt in the working directory out.
  if (application->Initialize("") != Ipopt::Solve_Succeeded) {
    result.message = "Ipopt refused its options";
    result.log = log.str();
    return result;
  }
  const Outcome& outcome = outcome_of([&] {
    const PhaseTimer timer(Phase::Ipopt);
    return application->OptimizeTNLP(Ipopt::GetRawPtr(adapter));
  }());
  // Where memory runs out while it sets up its linear system Ipopt 3.11.9 frees
  // an array twice as it is destroyed: what is left of it stays.
  if (outcome.status == Status::OutOfMemory) application->AddRef(nullptr);
  if (solver == LinearSolver::Mumps) book_linear_solver(*application);
  rethrow(adapter->exception(), options.stop);
  if (hook != nullptr) rethrow(hook->exception, options.stop);

  result.log = log.str();
  if (solver == LinearSolver::Chain) {
    result.log = with_its_own_name(std::move(result.log));
    if (options.verbose) {
      result.log =
          "The linear solver is brachisto's own, chain. Ipopt calls it through "
          "its interface to another one,\nfor which it takes it; that name is "
          "replaced in the lines below.\n" +
          result.log;
    }
  }
  result.point = adapter->final_point();
  if (result.point.x.empty() && options.stop.met()) result.point = start;
  result.iterations = adapter->iterations();
  result.refused_points = adapter->refused_points();
  if (hook != nullptr) result.effort = hook->effort;
  result.status = status_of(outcome, options.stop,
                            adapter->refused_points() > 0, adapter->tired());
  if (memory_failure(result.log)) result.status = Status::OutOfMemory;
  if (result.status == Status::Infeasible && !problem.has_inequalities()) {
    // There is a path; it was not found.
    result.status = Status::NotConverged;
  }
  result.message =
      fmt::format("Ipopt: {} after {} iterations",
                  result.status == Status::IterationLimit && adapter->tired()
                      ? "all the work it was allowed used up"
                      : outcome.words,
                  result.iterations);
  if (result.status == Status::NotEvaluable) {
    result.message += fmt::format(
        " ({} trial points refused, the last because "
        "{})",
        result.refused_points, adapter->last_refusal());
  }
  return result;
}

/// solve_with_ipopt(), but that it may be stopped on the way to a run.
SolverResult solve(nlp::Problem& problem, const PrimalDual& start,
                   const IpoptOptions& options, std::string_view release) {
  const OneAtATime one_at_a_time;
  std::string why_not;
  if (options.linear_solver != LinearSolver::Mumps) {
    if (!ChainHook::available()) {
      why_not = "this release of Ipopt has no way in for it";
    } else if (problem.chain_structure().empty()) {
      why_not = "the problem states no chain structure";
    } else {
      ChainHook hook(problem, release);
      SolverResult result = run(problem, start, options, &hook);
      if (hook.refusal.empty()) return result;
      why_not = hook.refusal;
    }
  }
  if (options.linear_solver == LinearSolver::Chain) {
    SolverResult result;
    result.status = Status::InternalError;
    result.message = "linear_solver chain cannot be used: " + why_not;
    return result;
  }
  SolverResult result = run(problem, start, options, nullptr);
  if (!why_not.empty() && options.verbose) {
    result.log =
        "linear solver mumps, not chain: " + why_not + "\n" + result.log;
  }
  return result;
}

}  // namespace

SolverResult solve_with_ipopt(nlp::Problem& problem, const PrimalDual& start,
                              const IpoptOptions& options) {
  return solve_with_ipopt(problem, start, options, ipopt_release());
}

SolverResult solve_with_ipopt(nlp::Problem& problem, const PrimalDual& start,
                              const IpoptOptions& options,
                              std::string_view release) {
  const StopScope scope(options.stop);
  try {
    return solve(problem, start, options, release);
  } catch (const Stopped&) {
    if (!options.stop.met()) throw;
    SolverResult result;
    result.status = stopped_by(options.stop);
    result.message = describe(result.status);
    result.point = start;
    return result;
  }
}

std::string ipopt_version() {
  return std::string(ipopt_release());
}
std::string mumps_version() {
  return MUMPS_VERSION;
}

}  // namespace brachisto
