// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Solutions by a chain factorisation, and their residuals.

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "brachisto/math/phase_clock.hpp"
#include "brachisto/math/stop_condition.hpp"
#include "math/index.hpp"
#include "solvers/chain_ldlt.hpp"

namespace brachisto {

/// visit(run, analysis, slots, first link, number of links, flags of failure).
template <class Visit>
void ChainLdlt::for_each_batch(Visit&& visit) const {
  for (std::size_t r = 0; r < plans_.size(); ++r) {
    const Run& run = map_.runs()[r];
    const Plan& plan = plans_[r];
    for (int first = 0; first < run.num_links; first += kLanes) {
      check_stop(first);
      const Batch& batch = plan.batches[at(first / kLanes)];
      if (batch.sequence == nullptr) continue;
      visit(run, batch.sequence->analysis(), batch.slots, first,
            std::min(kLanes, run.num_links - first), batch.failed);
    }
  }
}

void ChainLdlt::apply_scale(std::span<double> x) const {
  for (std::size_t i = 0; i < scale_.size(); ++i) x[i] *= scale_[i];
}

void ChainLdlt::solve(std::span<double> x) const {
  apply_scale(x);
  std::vector<Lanes> local;
  for_each_batch([&](const Run& run, const SymbolicAnalysis& analysis,
                     const Lanes* slots, int first, int count,
                     unsigned failed) {
    const ChainMap::Links links{first, first + count};
    local.assign(run.unknowns.size(), Lanes{});
    for (int i = 0; i < run.interior; ++i) {
      for (int b = 0; b < count; ++b) {
        local[at(i)].lane[b] = x[run.unknowns[at(i)].at(first + b)];
      }
    }
    forward_substitution(analysis, slots, local.data());
    for (int i = 0; i < run.size(); ++i) {
      const auto [begin, end] = run.having(run.unknowns[at(i)], links);
      for (int link = begin; link < end; ++link) {
        const int b = link - first;
        if (((failed >> b) & 1U) != 0) continue;
        double& value = x[run.unknowns[at(i)].at(link)];
        value = local[at(i)].lane[b] + (i < run.interior ? 0.0 : value);
      }
    }
  });
  check_stop();
  fronts_.forward(x);
  fronts_.backward(x);
  for_each_batch([&](const Run& run, const SymbolicAnalysis& analysis,
                     const Lanes* slots, int first, int count,
                     unsigned failed) {
    const ChainMap::Links links{first, first + count};
    local.assign(run.unknowns.size(), Lanes{});
    for (std::size_t i = 0; i < run.unknowns.size(); ++i) {
      const auto [begin, end] = run.having(run.unknowns[i], links);
      for (int link = begin; link < end; ++link) {
        local[i].lane[link - first] = x[run.unknowns[i].at(link)];
      }
    }
    backward_substitution(analysis, slots, local.data());
    for (int i = 0; i < run.interior; ++i) {
      for (int b = 0; b < count; ++b) {
        if (((failed >> b) & 1U) != 0) continue;
        x[run.unknowns[at(i)].at(first + b)] = local[at(i)].lane[b];
      }
    }
  });
  apply_scale(x);
}

void ChainLdlt::subtract_product(std::span<const double> x,
                                 std::span<long double> residual) const {
  std::vector<double> local;
  std::vector<long double> sum;
  for (const Run& run : map_.runs()) {
    local.resize(run.unknowns.size());
    sum.resize(run.unknowns.size());
    for (int link = 0; link < run.num_links; ++link) {
      check_stop(link);
      for (std::size_t i = 0; i < local.size(); ++i) {
        const bool has = run.has(run.unknowns[i], link);
        local[i] = has ? x[run.unknowns[i].at(link)] : 0.0;
        sum[i] = 0.0L;
      }
      for (const ChainMap::Entry& entry : run.entries) {
        if (!run.has(entry.source, link)) continue;
        const long double value =
            values_[at(entry.array)][entry.source.at(link)];
        sum[at(entry.row)] += value * local[at(entry.col)];
        if (entry.row == entry.col) continue;
        sum[at(entry.col)] += value * local[at(entry.row)];
      }
      for (std::size_t i = 0; i < local.size(); ++i) {
        if (!run.has(run.unknowns[i], link)) continue;
        residual[run.unknowns[i].at(link)] -= sum[i];
      }
    }
  }
  const auto add = [&](std::size_t i, std::size_t j, double value) {
    residual[i] -= static_cast<long double>(value) * x[j];
    if (i != j) residual[j] -= static_cast<long double>(value) * x[i];
  };
  for (const ChainMap::Entry& entry : map_.border_entries()) {
    add(at(map_.border()[at(entry.row)]), at(map_.border()[at(entry.col)]),
        values_[at(entry.array)][entry.source.at(0)]);
  }
}

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
