// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "transcription/start_equation.hpp"

#include <limits>

#include "brachisto/math/index.hpp"
#include "model/world_hamiltonian.hpp"

namespace brachisto {

namespace {

using enum StateComponent;

// Places among the variables of PhasePoint.
static_assert(static_cast<int>(X) == 0 && static_cast<int>(Z) == 1 &&
              static_cast<int>(Theta) == 2 && static_cast<int>(W) == 3);
int phase_of_state(StateComponent state) {
  return static_cast<int>(state);
}
int phase_of_costate(StateComponent state) {
  return 4 + static_cast<int>(state);
}

}  // namespace

StartEquation::StartEquation(RollingTime& problem) : problem_(problem) {
  const VariableLayout& layout = problem.layout();
  states_ =
      layout.has_theta() ? std::vector{X, Z, Theta, W} : std::vector{X, Z, W};
  const auto see = [&](int variable, int other, std::size_t place,
                       std::vector<Entry>& out) {
    for (std::size_t i = 0; i < states_.size(); ++i) {
      if (layout.state(0, states_[i]) == variable) {
        out.push_back({i, other, place});
      }
    }
  };
  problem.hess_lag_pattern().for_each([&](std::size_t entry, int i, int j) {
    see(i, j, entry, of_hess_);
    if (i != j) see(j, i, entry, of_hess_);
  });
  problem.jac_g_pattern().for_each([&](std::size_t entry, int row, int col) {
    see(col, row, entry, of_jac_);
  });
}

void StartEquation::set_parameter(double alpha) {
  alpha_ = alpha;
  problem_.set_start_slope(alpha);
  const VariableLayout& layout = problem_.layout();
  const StartRates rates = start_rates(problem_.scene());
  fixed_rates_.index = {layout.state(0, X), layout.state(0, Z),
                        layout.state(0, W)};
  fixed_rates_.value = {rates.x, rates.z, rates.w};
}

const nlp::TangencyCondition::Linearisation& StartEquation::linearise(
    std::span<const double> x, std::span<const double> lambda) {
  at_ = {};
  if (!problem_.set_point(x)) {
    at_.residual = std::numeric_limits<double>::quiet_NaN();
    return at_;
  }
  const VariableLayout& layout = problem_.layout();
  std::vector<double> grad_f(at(problem_.num_variables()));
  std::vector<double> jac(problem_.jac_g_pattern().num_entries());
  std::vector<double> hess(problem_.hess_lag_pattern().num_entries());
  problem_.eval_grad_f(grad_f);
  problem_.eval_jac_g(jac);
  problem_.eval_hess_lag(1.0, lambda, hess);

  // X₀ and ∂𝓛/∂X₀, where the jet has them.
  std::array<double, kPhaseBeta> phase{};
  for (const StateComponent state : states_) {
    const int variable = layout.state(0, state);
    phase[at(phase_of_state(state))] = x[at(variable)];
    phase[at(phase_of_costate(state))] = grad_f[at(variable)];
  }
  for (const Entry& entry : of_jac_) {
    phase[at(phase_of_costate(states_[entry.state]))] +=
        jac[entry.place] * lambda[at(entry.other)];
  }
  const Body& body = problem_.scene().body;
  const PhaseJet h =
      hamiltonian_jet(problem_.scene(), body.rolls() ? 1.0 / body.radius : 0.0,
                      {phase[0], phase[1], phase[2], phase[3], phase[4],
                       phase[5], phase[6], phase[7], alpha_});
  const auto by = [&](int place) {
    return h.hessian[PhaseJet::pair(static_cast<int>(kPhaseBeta), place)];
  };

  at_.residual = h.gradient[kPhaseBeta];
  at_.by_parameter = by(static_cast<int>(kPhaseBeta));
  const auto put = [](nlp::SparseVector& out, int index, double value) {
    out.index.push_back(index);
    out.value.push_back(value);
  };
  for (const StateComponent state : states_) {
    put(at_.by_x, layout.state(0, state), by(phase_of_state(state)));
  }
  const auto through_costates = [&](const std::vector<Entry>& entries,
                                    const std::vector<double>& values,
                                    nlp::SparseVector& out) {
    for (const Entry& entry : entries) {
      put(out, entry.other,
          by(phase_of_costate(states_[entry.state])) * values[entry.place]);
    }
  };
  through_costates(of_hess_, hess, at_.by_x);
  through_costates(of_jac_, jac, at_.by_lambda);
  return at_;
}

}  // namespace brachisto
