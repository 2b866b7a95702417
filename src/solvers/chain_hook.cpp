// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "solvers/chain_hook.hpp"

#include <IpoptConfig.h>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "brachisto/math/phase_clock.hpp"
#include "brachisto/math/stop_condition.hpp"
#include "solvers/chain_kkt.hpp"

#if IPOPT_VERSION_MAJOR == 3 && IPOPT_VERSION_MINOR == 11 && \
    IPOPT_VERSION_RELEASE == 9 && __has_include(<HSLLoader.h>)
#define BRACHISTO_HAS_CHAIN_HOOK 1
#else
#define BRACHISTO_HAS_CHAIN_HOOK 0
#endif

#if BRACHISTO_HAS_CHAIN_HOOK
#include <HSLLoader.h>

/// HSLLoader.h only declares it. This is the layout Ipopt 3.11.9 was compiled
/// with; of the control struct nothing is read or written here.
struct ma97_info_d {
  int flag;  ///< 0: fine; −7: singular; other negative numbers: given up
  int flag68, flag77, matrix_dup;
  int matrix_rank;
  int matrix_outrange, matrix_missing_diag, maxdepth;
  int maxfront, num_delay;
  long num_factor, num_flops;
  int num_neg;
  int num_sup, num_two, ordering, stat;
  int ispare[5];
  double rspare[10];
};
#endif

namespace brachisto {

namespace {

/// The hook in force; OneAtATime keeps other threads from it.
ChainHook* current = nullptr;

nlp::ChainStructure in_ipopt_numbering(const nlp::Problem& problem) {
  // Ipopt drops the fixed variables (fixed_variable_treatment make_parameter)
  // and keeps the order of the others. There are no inequalities, hence no
  // slacks, and the multipliers follow in the order of the constraints.
  nlp::ChainStructure chain = chain_of_free_unknowns(problem);
  if (!chain.scale.empty()) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < chain.block.size(); ++i) {
      if (chain.block[i] == nlp::ChainStructure::kAbsent) continue;
      chain.scale[kept++] = chain.scale[i];
    }
    chain.scale.resize(kept);
  }
  std::erase(chain.block, nlp::ChainStructure::kAbsent);
  return chain;
}

#if BRACHISTO_HAS_CHAIN_HOOK

constexpr int kSingular = -7;
constexpr int kGivenUp = -1;

/// What MA97 keeps between its calls.
struct Matrix {
  std::unique_ptr<ChainLdlt> ldlt;
  int size = 0;
  std::size_t num_entries = 0;
};

Matrix& matrix_of(void** akeep) {
  return *static_cast<Matrix*>(*akeep);
}

/// Runs `work`; what it throws goes through Ipopt, which forgets what it was.
template <class Work>
void kept(Work&& work) {
  try {
    work();
  } catch (...) {
    if (current != nullptr) current->keep(std::current_exception());
    throw;
  }
}

extern "C" {

static void chain_default_control(ma97_control_d*) {}

/// Rows of a triangle, 1-based, as Ipopt's CSR_Format_1_Offset has it.
static void chain_analyse(int, int n, const int ptr[], const int row[],
                          double[], void** akeep, const ma97_control_d*,
                          ma97_info_d* info, int[]) {
  *info = {};
  info->flag = kGivenUp;
  *akeep = nullptr;
  const PhaseTimer timer(Phase::SetUp);
  if (current == nullptr) return;
  kept([&] {
    if (static_cast<std::size_t>(n) != current->structure().block.size()) {
      current->refuse("Ipopt's KKT matrix has another size than the problem's");
      return;
    }
    auto matrix = std::make_unique<Matrix>();
    matrix->size = n;
    matrix->num_entries = static_cast<std::size_t>(ptr[n] - 1);
    std::vector<int> rows;
    std::vector<int> cols;
    rows.reserve(matrix->num_entries);
    cols.reserve(matrix->num_entries);
    for (int i = 0; i < n; ++i) {
      for (int e = ptr[i] - 1; e < ptr[i + 1] - 1; ++e) {
        rows.push_back(i);
        cols.push_back(row[e] - 1);
      }
    }
    const std::array<EntryPositions, 1> positions = {
        EntryPositions{rows, cols, 0}};
    matrix->ldlt = ChainLdlt::make(current->structure(), positions);
    if (!matrix->ldlt) {
      current->refuse("Ipopt's KKT matrix is not the chain the problem states");
      return;
    }
    info->flag = 0;
    *akeep = matrix.release();
  });
}

static void chain_factor(int, const int[], const int[], const double val[],
                         void** akeep, void**, const ma97_control_d*,
                         ma97_info_d* info, const double[]) {
  *info = {};
  const PhaseTimer timer(Phase::Factorisation);
  Matrix& matrix = matrix_of(akeep);
  kept([&] {
    const std::array<std::span<const double>, 1> values = {
        std::span<const double>(val, matrix.num_entries)};
    if (current != nullptr) current->count_factorisation();
    const bool factorised = matrix.ldlt->factorise(values);
    const Inertia& inertia = matrix.ldlt->inertia();
    // Ipopt answers both with a perturbation and another try.
    if (!factorised || inertia.zero > 0) info->flag = kSingular;
    info->matrix_rank = matrix.size - inertia.zero;
    info->num_neg = inertia.negative;
  });
}

static void chain_solve(int, int nrhs, double x[], int ldx, void** akeep,
                        void**, const ma97_control_d*, ma97_info_d*) {
  const PhaseTimer timer(Phase::Solution);
  // What Ipopt read from the info struct before must stay.
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

#endif

}  // namespace

bool ChainHook::available() {
  return BRACHISTO_HAS_CHAIN_HOOK != 0;
}

ChainHook::ChainHook(const nlp::Problem& problem)
    : structure_(in_ipopt_numbering(problem)) {
#if BRACHISTO_HAS_CHAIN_HOOK
  LSL_setMA97(chain_default_control, chain_analyse, chain_factor,
              chain_factor_solve, chain_solve, chain_finalise, chain_free);
#endif
  current = this;
}

ChainHook::~ChainHook() {
  current = nullptr;
}

}  // namespace brachisto
