// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "solvers/chain_hook.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "brachisto/math/clock.hpp"
#include "solvers/chain_ldlt.hpp"
#include "solvers/ma97_functions.hpp"

namespace brachisto {

namespace {

/// The hook in force; OneAtATime keeps other threads from it.
ChainHook* current = nullptr;

/// What MA97 keeps between its calls.
struct Matrix {
  std::unique_ptr<ChainLdlt> ldlt;
  int size = 0;
  std::size_t num_entries = 0;
  std::vector<double> scale;  ///< as the problem states it; empty: ones
  /// Unknowns with bounds, and where their diagonal entries are.
  std::vector<std::pair<std::size_t, std::size_t>> barrier;
  /// Where the derivatives of inequalities are.
  struct Derivative {
    std::size_t inequality, variable, entry;
  };
  std::vector<Derivative> derivatives;
  std::vector<double> largest;  ///< of each inequality
};

/// Scales inequalities by powers of two for their largest derivative to be of
/// order one, slacks inversely, and unknowns with bounds for their diagonal
/// entries to be at most of order one. Next to a bound the barrier's share of
/// them grows like 1/μ; unscaled, it would hide all other entries behind the
/// rounding of the largest one.
void scale_inequalities(Matrix& matrix, const double val[]) {
  if (matrix.barrier.empty()) return;
  std::vector<double> scale = matrix.scale;
  scale.resize(static_cast<std::size_t>(matrix.size), 1.0);
  matrix.largest.assign(current->inequalities.size(), 0.0);
  for (const Matrix::Derivative& d : matrix.derivatives) {
    double& largest = matrix.largest[d.inequality];
    largest = std::max(largest, std::abs(val[d.entry]) * scale[d.variable]);
  }
  for (std::size_t i = 0; i < matrix.largest.size(); ++i) {
    const double largest = matrix.largest[i];
    const auto [slack, multiplier] = current->inequalities[i];
    double& s = scale[static_cast<std::size_t>(multiplier)];
    if (largest > 0.0 && std::isfinite(largest)) {
      s = std::ldexp(1.0, std::clamp(-std::ilogb(largest), -60, 10));
    }
    scale[static_cast<std::size_t>(slack)] = 1.0 / s;
  }
  for (const auto& [unknown, entry] : matrix.barrier) {
    double& s = scale[unknown];
    const double diagonal = std::abs(val[entry]) * s * s;
    if (!(diagonal > 1.0) || !std::isfinite(diagonal)) continue;
    s = std::ldexp(s, -(std::ilogb(diagonal) + 1) / 2);
  }
  matrix.ldlt->set_scale(std::move(scale));
}

Matrix& matrix_of(void** akeep) {
  return *static_cast<Matrix*>(*akeep);
}

/// Runs `work`; false if it throws. What it threw is kept: through Ipopt it
/// would leave behind the memory of its interface to linear solvers.
template <class Work>
bool kept(Work&& work) {
  try {
    work();
    return true;
  } catch (...) {
    if (current != nullptr) current->exception = std::current_exception();
    return false;
  }
}

extern "C" {

static void chain_default_control(ma97_control_d*) {}

/// Rows of a triangle, 1-based, as Ipopt's CSR_Format_1_Offset has it.
static void chain_analyse(int, int n, const int ptr[], const int row[],
                          double[], void** akeep, const ma97_control_d*,
                          ma97_info_d* info, int[]) {
  // Nothing else of the struct is touched before the release is known.
  info->flag = kMa97GivenUp;
  *akeep = nullptr;
  const PhaseTimer timer(Phase::SetUp);
  if (current == nullptr) return;
  kept([&] {
    if (current->release != current->wanted_release) {
      current->refusal = fmt::format(
          "it works with Ipopt {}, and this is {}", current->wanted_release,
          current->release.empty() ? "another release" : current->release);
      return;
    }
    if (static_cast<std::size_t>(n) != current->structure.block.size()) {
      current->refusal =
          "Ipopt's KKT matrix has another size than the problem's";
      return;
    }
    auto matrix = std::make_unique<Matrix>();
    matrix->size = n;
    matrix->num_entries = static_cast<std::size_t>(ptr[n] - 1);
    const nlp::SparsityPattern pattern = triangle_pattern(n, ptr, row, 1);
    const std::array<EntryPositions, 1> positions = {
        EntryPositions{pattern, 0}};
    matrix->ldlt = ChainLdlt::make(current->structure, positions);
    if (!matrix->ldlt) {
      current->refusal =
          "Ipopt's KKT matrix is not the chain the problem states";
      return;
    }
    if (!current->bounded.empty()) {
      matrix->scale = current->structure.scale;
    }
    for (const int unknown : current->bounded) {
      for (int e = ptr[unknown] - 1; e < ptr[unknown + 1] - 1; ++e) {
        if (row[e] - 1 == unknown) {
          matrix->barrier.emplace_back(unknown, e);
        }
      }
    }
    // Of each unknown: the inequality whose multiplier it is, that whose slack,
    // or neither.
    constexpr int kNeither = -1;
    constexpr int kSlack = -2;
    std::vector<int> inequality_of(static_cast<std::size_t>(n), kNeither);
    for (std::size_t i = 0; i < current->inequalities.size(); ++i) {
      const auto [slack, multiplier] = current->inequalities[i];
      inequality_of[static_cast<std::size_t>(slack)] = kSlack;
      inequality_of[static_cast<std::size_t>(multiplier)] = static_cast<int>(i);
    }
    pattern.for_each([&](std::size_t entry, int one, int other) {
      auto i = static_cast<std::size_t>(one);
      auto j = static_cast<std::size_t>(other);
      if (inequality_of[i] < 0) std::swap(i, j);
      if (inequality_of[i] < 0 || inequality_of[j] != kNeither) return;
      matrix->derivatives.push_back(
          {static_cast<std::size_t>(inequality_of[i]), j, entry});
    });
    *info = {};
    *akeep = matrix.release();
  });
}

static void chain_factor(int, const int[], const int[], const double val[],
                         void** akeep, void**, const ma97_control_d*,
                         ma97_info_d* info, const double[]) {
  *info = {};
  const PhaseTimer timer(Phase::Factorisation);
  Matrix& matrix = matrix_of(akeep);
  const bool done = kept([&] {
    // After what a solution threw there is nothing to go on with.
    if (current != nullptr && current->exception) {
      std::rethrow_exception(current->exception);
    }
    const std::array<std::span<const double>, 1> values = {
        std::span<const double>(val, matrix.num_entries)};
    scale_inequalities(matrix, val);
    const bool factorised = matrix.ldlt->factorise(values);
    if (current != nullptr) current->effort += matrix.ldlt->effort();
    const Inertia& inertia = matrix.ldlt->inertia();
    // Ipopt answers both with a perturbation and another try.
    if (!factorised || inertia.zero > 0) info->flag = kMa97Singular;
    info->matrix_rank = matrix.size - inertia.zero;
    info->num_neg = inertia.negative;
  });
  if (!done) info->flag = kMa97GivenUp;
}

static void chain_solve(int, int nrhs, double x[], int ldx, void** akeep,
                        void**, const ma97_control_d*, ma97_info_d* info) {
  const PhaseTimer timer(Phase::Solution);
  // What Ipopt read from the info struct before must stay, but 3.14 hands over
  // a flag that nobody set. A solution has no other way to fail: the next
  // evaluation or factorisation ends the run.
  info->flag = 0;
  Matrix& matrix = matrix_of(akeep);
  kept([&] {
    for (int k = 0; k < nrhs; ++k) {
      check_stop();
      matrix.ldlt->solve({x + static_cast<std::ptrdiff_t>(k) * ldx,
                          static_cast<std::size_t>(matrix.size)});
    }
  });
}

static void chain_factor_solve(int type, const int ptr[], const int row[],
                               const double val[], int nrhs, double x[],
                               int ldx, void** akeep, void** fkeep,
                               const ma97_control_d* control, ma97_info_d* info,
                               const double scale[]) {
  chain_factor(type, ptr, row, val, akeep, fkeep, control, info, scale);
  if (info->flag == 0) {
    chain_solve(0, nrhs, x, ldx, akeep, fkeep, control, info);
  }
}

static void chain_free(void** akeep) {
  delete static_cast<Matrix*>(*akeep);
  *akeep = nullptr;
}

static void chain_finalise(void** akeep, void**) {
  chain_free(akeep);
}

}  // extern "C"

}  // namespace

bool ChainHook::available() {
  return takes_ma97_functions();
}

ChainHook::ChainHook(const nlp::Problem& problem, std::string_view wanted)
    : wanted_release(wanted) {
  // Ipopt drops the fixed variables (fixed_variable_treatment make_parameter)
  // and keeps the order of the others.
  const nlp::ChainStructure chain = problem.chain_structure();
  structure.num_links = chain.num_links;
  const auto put = [&](int block, double scale) {
    structure.block.push_back(block);
    if (!chain.scale.empty()) structure.scale.push_back(scale);
  };
  const auto put_unknown = [&](int unknown) {
    const auto i = static_cast<std::size_t>(unknown);
    put(chain.block[i], chain.scale.empty() ? 1.0 : chain.scale[i]);
  };
  const int n = problem.num_variables();
  for (int i = 0; i < n; ++i) {
    const nlp::Range range = problem.variable_range(i);
    if (range.single()) continue;
    if (range.bounded()) {
      bounded.push_back(static_cast<int>(structure.block.size()));
    }
    put_unknown(i);
  }
  std::vector<int> equations, limited;
  for (int i = n; i < n + problem.num_constraints(); ++i) {
    const bool equation = problem.constraint_range(i - n).single();
    (equation ? equations : limited).push_back(i);
  }
  const auto next = [&] { return static_cast<int>(structure.block.size()); };
  // A slack has no other neighbour than its multiplier, with the entry −1: in
  // another block than it, nothing but its own diagonal entry would be there to
  // eliminate it with, which vanishes far from the bound.
  for (const int unknown : limited) {
    bounded.push_back(next());
    inequalities.push_back({.slack = next(), .multiplier = 0});
    put_unknown(unknown);
  }
  for (const int unknown : equations) put_unknown(unknown);
  for (std::size_t i = 0; i < limited.size(); ++i) {
    inequalities[i].multiplier = next();
    put_unknown(limited[i]);
  }
  set_ma97_functions({chain_default_control, chain_analyse, chain_factor,
                      chain_factor_solve, chain_solve, chain_finalise,
                      chain_free});
  current = this;
}

ChainHook::~ChainHook() {
  current = nullptr;
}

}  // namespace brachisto
