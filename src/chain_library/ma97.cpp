// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The chain factorisation under the names of HSL's MA97, for any Ipopt that
// loads its linear solvers from a shared library.

#include "solvers/ma97.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "brachisto/math/index.hpp"
#include "solvers/chain_detection.hpp"
#include "solvers/chain_ldlt.hpp"

namespace brachisto {

namespace {

/// What is kept between calls. The chain is looked for when there are values:
/// a pattern alone does not tell multipliers of equations from variables.
class Matrix {
 public:
  /// \param offset  0 or 1, of the indices
  Matrix(int size, const int ptr[], const int row[], int offset)
      : size_(size), num_entries_(at(ptr[size] - offset)) {
    pattern_.reserve(num_entries_);
    for (int i = 0; i < size; ++i) {
      for (int e = ptr[i] - offset; e < ptr[i + 1] - offset; ++e) {
        pattern_.add(i, row[e] - offset);
      }
    }
  }

  /// False if the matrix is no chain.
  /// \param quality  Ipopt raises it for more accurate pivots
  [[nodiscard]] bool factorise(const double val[], double quality,
                               ma97_info_d& info) {
    const std::span<const double> values(val, num_entries_);
    if (!ldlt_ && !find(values)) return false;
    if (std::exchange(quality_, quality) != quality) ldlt_->forget_pivots();
    ldlt_->set_scale(scale_of(values));
    const std::array<std::span<const double>, 1> arrays = {values};
    const bool factorised = ldlt_->factorise(arrays);
    const Inertia& inertia = ldlt_->inertia();
    if (!factorised || inertia.zero > 0) info.flag = kMa97Singular;
    info.matrix_rank = size_ - inertia.zero;
    info.num_neg = inertia.negative;
    // Zeros may have hidden which unknowns have diagonal entries.
    if (info.flag == kMa97Singular) ldlt_.reset();
    return true;
  }
  [[nodiscard]] bool factorised() const { return ldlt_ != nullptr; }
  /// \pre factorised()
  void solve(int count, double x[], int stride) const {
    for (int k = 0; k < count; ++k) {
      ldlt_->solve({x + static_cast<std::ptrdiff_t>(k) * stride, at(size_)});
    }
  }

 private:
  bool find(std::span<const double> values) {
    std::vector<bool> no_diagonal(at(size_), true);
    pattern_.for_each([&](std::size_t entry, int i, int j) {
      if (i == j && values[entry] != 0.0) no_diagonal[at(i)] = false;
    });
    auto chain =
        find_chain(MatrixGraph::of_pattern(size_, pattern_), no_diagonal);
    if (!chain) return false;
    const std::array<EntryPositions, 1> positions = {
        EntryPositions{pattern_, 0}};
    ldlt_ = ChainLdlt::make(*std::move(chain), positions);
    return ldlt_ != nullptr;
  }

  /// Powers of two that bring large diagonal entries, those of variables next
  /// to a bound, down to order one and the largest entry beside a small
  /// diagonal one, in rows of constraints, to order one.
  [[nodiscard]] std::vector<double> scale_of(
      std::span<const double> values) const {
    constexpr int kMost = 60;
    std::vector<double> scale(at(size_), 1.0), largest(at(size_), 0.0);
    std::vector<char> small(at(size_), 1);
    pattern_.for_each([&](std::size_t entry, int i, int j) {
      const double a = std::abs(values[entry]);
      if (i != j || !std::isfinite(a) || a == 0.0) return;
      small[at(i)] = 0;
      if (a > 1.0) scale[at(i)] = std::ldexp(1.0, -(std::ilogb(a) + 1) / 2);
    });
    pattern_.for_each([&](std::size_t entry, int i, int j) {
      if (i == j) return;
      const double a = std::abs(values[entry]);
      if (small[at(i)] != 0) {
        largest[at(i)] = std::max(largest[at(i)], a * scale[at(j)]);
      }
      if (small[at(j)] != 0) {
        largest[at(j)] = std::max(largest[at(j)], a * scale[at(i)]);
      }
    });
    for (std::size_t i = 0; i < largest.size(); ++i) {
      if (small[i] == 0 || !(largest[i] > 0.0)) continue;
      if (!std::isfinite(largest[i])) continue;
      scale[i] =
          std::ldexp(1.0, std::clamp(-std::ilogb(largest[i]), -kMost, kMost));
    }
    return scale;
  }

  int size_;
  std::size_t num_entries_;
  double quality_ = 0.0;
  nlp::SparsityPattern pattern_;
  std::unique_ptr<ChainLdlt> ldlt_;
};

void say_once(const char* what) {
  static bool said = false;
  if (std::exchange(said, true)) return;
  std::fprintf(stderr, "brachisto-chain: %s\n", what);
}

/// Runs `work`; nothing may be thrown through the caller.
template <class Work>
void guarded(ma97_info_d* info, Work&& work) {
  try {
    work();
  } catch (const std::exception& error) {
    say_once(error.what());
    info->flag = kMa97GivenUp;
  }
}

}  // namespace

}  // namespace brachisto

using brachisto::guarded;
using brachisto::Matrix;

extern "C" {

void ma97_default_control_d(ma97_control_d* control) {
  *control = {};
  control->u = 0.01;
  control->small = 1e-20;
}

void ma97_analyse_d(int /*check*/, int n, const int ptr[], const int row[],
                    double /*val*/[], void** akeep,
                    const ma97_control_d* control, ma97_info_d* info,
                    int /*order*/[]) {
  *info = {};
  *akeep = nullptr;
  guarded(info, [&] {
    *akeep = new Matrix(n, ptr, row, control->f_arrays != 0 ? 1 : 0);
  });
}

void ma97_factor_d(int /*type*/, const int /*ptr*/[], const int /*row*/[],
                   const double val[], void** akeep, void** /*fkeep*/,
                   const ma97_control_d* control, ma97_info_d* info,
                   const double /*scale*/[]) {
  *info = {};
  guarded(info, [&] {
    // Ipopt leaves analyse out where an ordering asks for values.
    if (*akeep == nullptr) {
      brachisto::say_once(
          "matched orderings are not known; ma97_order best is");
      info->flag = brachisto::kMa97GivenUp;
      return;
    }
    if (static_cast<Matrix*>(*akeep)->factorise(val, control->u, *info)) return;
    brachisto::say_once(
        "the matrix is no chain of small blocks; take another linear solver");
    info->flag = brachisto::kMa97GivenUp;
  });
}

void ma97_solve_d(int job, int nrhs, double x[], int ldx, void** akeep,
                  void** /*fkeep*/, const ma97_control_d* /*control*/,
                  ma97_info_d* info) {
  // What the factorisation told stays; partial solutions are none of ours.
  info->flag = 0;
  guarded(info, [&] {
    const auto* const matrix = static_cast<const Matrix*>(*akeep);
    if (job != 0 || matrix == nullptr || !matrix->factorised()) {
      info->flag = brachisto::kMa97GivenUp;
      return;
    }
    matrix->solve(nrhs, x, ldx);
  });
}

void ma97_factor_solve_d(int type, const int ptr[], const int row[],
                         const double val[], int nrhs, double x[], int ldx,
                         void** akeep, void** fkeep,
                         const ma97_control_d* control, ma97_info_d* info,
                         const double scale[]) {
  ma97_factor_d(type, ptr, row, val, akeep, fkeep, control, info, scale);
  if (info->flag == 0) {
    ma97_solve_d(0, nrhs, x, ldx, akeep, fkeep, control, info);
  }
}

void ma97_free_akeep_d(void** akeep) {
  delete static_cast<Matrix*>(*akeep);
  *akeep = nullptr;
}

void ma97_finalise_d(void** akeep, void** /*fkeep*/) {
  ma97_free_akeep_d(akeep);
}

}  // extern "C"
