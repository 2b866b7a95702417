// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/solvers/program_solvers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "brachisto/math/clock.hpp"
#include "brachisto/nlp/problem.hpp"
#include "nlp/active_set.hpp"
#include "solvers/bordered_chain.hpp"
#include "solvers/kkt_system.hpp"
#include "solvers/newton_solver.hpp"
#include "solvers/sparse_lu.hpp"

namespace brachisto {

namespace {

struct Iterate {
  PrimalDual point;
  double phi;

  /// x, λ and φ, which are one vector, less `by` times another one.
  void subtract(double by, std::span<const double> direction, bool has_phi) {
    std::size_t i = 0;
    for (double& value : point.x) value -= by * direction[i++];
    for (double& value : point.lambda) value -= by * direction[i++];
    if (has_phi) phi -= by * direction[i];
  }
};

/// Completes the multipliers of a solution of the equations, and sees whether
/// it is one of the inequalities: those held at their bound have multipliers of
/// the right sign, the others keep to it.
void check_active_set(nlp::Problem& problem, const KktSystem& system,
                      const NewtonOptions& options, NewtonResult& result) {
  if (result.residual > options.tolerance ||
      !problem.set_point(result.point.x)) {
    return;
  }
  nlp::set_bound_multipliers(problem, system.active(), result.point);
  const nlp::KktResidual kkt = nlp::kkt_residual(problem, result.point);
  result.active_set_holds =
      std::max({kkt.sign, kkt.infeasibility, kkt.bound_violation}) <=
      options.tolerance;
}

}  // namespace

/// Steps of Newton's method: by the chain where it serves, else by sparse LU.
class NewtonSolver::StepSolver {
 public:
  StepSolver(KktSystem& system, LinearSolver solver)
      : system_(system), direction_(static_cast<std::size_t>(system.size())) {
    if (solver != LinearSolver::Mumps) chain_ = BorderedChain::make(system);
  }

  /// J d = residual at the system's point. False if J is singular.
  [[nodiscard]] bool solve(bool chain_alone) {
    system_.evaluate_jacobian();
    const auto by_chain = [&] {
      return chain_->factorise() &&
             chain_->solve(system_.residual(), direction_);
    };
    const auto by_chain_anew = [&] {
      chain_->forget_pivots();
      return by_chain();
    };
    if (chain_ && (by_chain() || by_chain_anew())) {
      determinant_sign_ = chain_->determinant_sign();
      by_chain_ = true;
      return true;
    }
    if (chain_ && chain_alone) return false;
    // What the chain cannot do may still be regular: the block of the problem
    // may be singular where the system with its tangency condition is not.
    if (!lu_) {
      const PhaseTimer timer(Phase::SetUp);
      lu_ = std::make_unique<SparseLu>(system_.pattern(),
                                       system_.elimination_order());
    }
    system_.jacobian(jacobian_);
    const bool regular = [&] {
      const PhaseTimer timer(Phase::Factorisation);
      return lu_->factorise(jacobian_);
    }();
    determinant_sign_ = lu_->determinant_sign();
    if (regular) {
      const PhaseTimer timer(Phase::Solution);
      direction_ = lu_->solve(system_.residual());
    }
    by_chain_ = false;
    return regular;
  }

  /// d; the step is −d.
  [[nodiscard]] const std::vector<double>& direction() const {
    return direction_;
  }
  [[nodiscard]] int determinant_sign() const { return determinant_sign_; }
  [[nodiscard]] bool by_chain() const { return by_chain_; }

 private:
  KktSystem& system_;
  std::unique_ptr<BorderedChain> chain_;
  std::unique_ptr<SparseLu> lu_;
  std::vector<double> direction_, jacobian_;
  int determinant_sign_ = 0;
  bool by_chain_ = false;
};

/// The equations of an active set and what solves them.
struct NewtonSolver::Structure {
  KktSystem system;
  LinearSolver linear_solver;
  std::optional<StepSolver> steps;  ///< from the first step on

  Structure(nlp::Problem& problem, nlp::TangencyCondition* tangency,
            nlp::ActiveSet active, LinearSolver solver)
      : system(problem, tangency, std::move(active)), linear_solver(solver) {}

  [[nodiscard]] bool serves(const nlp::ActiveSet& active,
                            LinearSolver solver) const {
    return system.active() == active && linear_solver == solver;
  }
  [[nodiscard]] StepSolver& step_solver() {
    if (!steps) steps.emplace(system, linear_solver);
    return *steps;
  }
};

NewtonSolver::NewtonSolver(nlp::Problem& problem,
                           nlp::TangencyCondition* tangency)
    : problem_(problem), tangency_(tangency) {}

NewtonSolver::~NewtonSolver() = default;

/// From the point in `result`, which holds the best one seen all along.
void NewtonSolver::iterate(const NewtonOptions& options, NewtonResult& result) {
  const bool inequalities = problem_.has_inequalities();
  if (inequalities && !problem_.set_point(result.point.x)) {
    result.status = Status::NotEvaluable;
    return;
  }
  nlp::ActiveSet active = nlp::active_set(problem_, result.point);
  if (!structure_ || !structure_->serves(active, options.linear_solver)) {
    structure_ = std::make_unique<Structure>(
        problem_, tangency_, std::move(active), options.linear_solver);
  }
  KktSystem& system = structure_->system;
  if (!system.evaluate(result.point.x, result.point.lambda, result.phi)) {
    result.status = Status::NotEvaluable;
    return;
  }
  double residual = system.max_residual();
  result.first_residual = result.residual = residual;

  while (result.iterations < options.max_iterations) {
    if (residual <= options.tolerance &&
        (!options.to_rounding ||
         (result.iterations > 0 && residual <= options.rounding))) {
      break;
    }
    if (residual == 0.0 || !std::isfinite(residual)) break;
    check_stop();
    StepSolver& solver = structure_->step_solver();
    const bool regular = solver.solve(options.chain_alone);
    result.determinant_sign = solver.determinant_sign();
    if (!regular) break;
    ++result.iterations;
    if (solver.by_chain()) ++result.chain_steps;

    // The first of the full, halved, … steps that makes the residual fall.
    bool moved = false;
    double by = 1.0;
    for (int halving = 0; halving <= options.max_halvings; ++halving) {
      Iterate trial{result.point, result.phi};
      trial.subtract(by, solver.direction(), tangency_ != nullptr);
      if (system.evaluate(trial.point.x, trial.point.lambda, trial.phi) &&
          system.max_residual() < residual) {
        moved = system.max_residual() <= 0.5 * residual ||
                residual > options.tolerance;
        residual = system.max_residual();
        result.point = std::move(trial.point);
        result.phi = trial.phi;
        result.residual = residual;
        break;
      }
      // Below the tolerance a step that does not help is rounding.
      if (residual <= options.tolerance) break;
      by *= 0.5;
    }
    if (!moved) break;
  }
  if (inequalities) check_active_set(problem_, system, options, result);
}

NewtonResult NewtonSolver::solve(PrimalDual start, double phi,
                                 const NewtonOptions& options) {
  NewtonResult result;
  result.point = std::move(start);
  result.phi = phi;
  result.first_residual = result.residual =
      std::numeric_limits<double>::infinity();
  const StopScope scope(options.stop);
  try {
    iterate(options, result);
  } catch (const Stopped&) {
    if (!options.stop.met()) throw;
    result.status = stopped_by(options.stop);
    return result;
  }
  if (tangency_ != nullptr) tangency_->set_parameter(result.phi);
  if (result.residual <= options.tolerance && result.active_set_holds) {
    result.status = Status::Solved;
  }
  return result;
}

NewtonResult solve_with_newton(nlp::Problem& problem, PrimalDual start,
                               const NewtonOptions& options) {
  return NewtonSolver(problem, nullptr).solve(std::move(start), 0.0, options);
}

}  // namespace brachisto
