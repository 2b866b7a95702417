// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "solvers/chain_kkt.hpp"

#include <array>
#include <cstddef>

#include "brachisto/math/phase_clock.hpp"

namespace brachisto {

nlp::ChainStructure chain_of_free_unknowns(const nlp::Problem& problem) {
  nlp::ChainStructure chain = problem.chain_structure();
  if (chain.empty()) return chain;
  const auto n = static_cast<std::size_t>(problem.num_variables());
  for (std::size_t i = 0; i < n; ++i) {
    if (problem.lower()[i] == problem.upper()[i]) {
      chain.block[i] = nlp::ChainStructure::kAbsent;
      if (!chain.scale.empty()) chain.scale[i] = 1.0;
    }
  }
  return chain;
}

std::unique_ptr<ChainLdlt> make_chain_ldlt(const nlp::Problem& problem) {
  const PhaseTimer timer(Phase::SetUp);
  const nlp::ChainStructure chain = chain_of_free_unknowns(problem);
  if (chain.empty()) return nullptr;
  const nlp::SparsityPattern& hess = problem.hess_lag_pattern();
  const nlp::SparsityPattern& jac = problem.jac_g_pattern();
  const std::array<EntryPositions, 2> positions = {
      EntryPositions{hess.rows, hess.cols, 0},
      EntryPositions{jac.rows, jac.cols, problem.num_variables()}};
  return ChainLdlt::make(chain, positions);
}

}  // namespace brachisto
