// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "solvers/chain_kkt.hpp"

#include <array>
#include <cstddef>

#include "brachisto/math/phase_clock.hpp"

namespace brachisto {

std::unique_ptr<ChainLdlt> make_chain_ldlt(const nlp::Problem& problem,
                                           const nlp::ActiveSet& active) {
  const PhaseTimer timer(Phase::SetUp);
  nlp::ChainStructure chain = problem.chain_structure();
  if (chain.empty()) return nullptr;
  const std::size_t n = active.variables.size();
  for (std::size_t i = 0; i < chain.block.size(); ++i) {
    const bool present = i < n ? active.variables[i] == nlp::Held::No
                               : active.constraints[i - n] != nlp::Held::No;
    if (present) continue;
    chain.block[i] = nlp::ChainStructure::kAbsent;
    if (!chain.scale.empty()) chain.scale[i] = 1.0;
  }
  const nlp::SparsityPattern& hess = problem.hess_lag_pattern();
  const nlp::SparsityPattern& jac = problem.jac_g_pattern();
  const std::array<EntryPositions, 2> positions = {
      EntryPositions{hess.rows, hess.cols, 0},
      EntryPositions{jac.rows, jac.cols, problem.num_variables()}};
  return ChainLdlt::make(chain, positions);
}

}  // namespace brachisto
