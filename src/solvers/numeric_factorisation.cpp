// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The loops over lanes are the hot ones of the chain solver. They are compiled
// for several instruction sets, without contraction to fused operations, so
// that every machine gets the same bits.

#include "solvers/numeric_factorisation.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && \
    !defined(__SANITIZE_ADDRESS__)
#define BRACHISTO_CLONES \
  __attribute__((target_clones("default", "avx2", "avx512f")))
#else
#define BRACHISTO_CLONES
#endif

namespace brachisto {

namespace {

using Kind = SymbolicAnalysis::Kind;

typedef double Half __attribute__((vector_size(sizeof(Lanes) / 2), may_alias));
static_assert(kLanes == 8);

/// All lanes of a number, and the first half of them. (As an argument of a
/// template a type of vectors would lose its attributes.)
struct Whole {
  typedef double Some __attribute__((vector_size(sizeof(Lanes)), may_alias));
  static Some& of(Lanes& lanes) { return reinterpret_cast<Some&>(lanes); }
  static const Some& of(const Lanes& lanes) {
    return reinterpret_cast<const Some&>(lanes);
  }
};
static_assert(sizeof(Whole::Some) == sizeof(Lanes));
struct FirstHalf {
  using Some = Half;
  static Some& of(Lanes& lanes) { return reinterpret_cast<Some&>(lanes); }
  static const Some& of(const Lanes& lanes) {
    return reinterpret_cast<const Some&>(lanes);
  }
};
/// The same of slots.
template <class Which, class Number>
struct LanesOf {
  Number* slots;
  [[gnu::always_inline]] auto& operator[](int slot) const {
    return Which::of(slots[slot]);
  }
};
/// That few are as quick in half of the lanes, wherever registers are no wider.
bool in_half(int lanes) {
  return lanes <= kLanes / 2;
}

template <class Which>
[[gnu::always_inline]] inline void factorise(const SymbolicAnalysis& analysis,
                                             Lanes* slots,
                                             FactorisationOutcome& outcome) {
  using Some = typename Which::Some;
  const LanesOf<Which, Lanes> W{slots};
  const int* const targets = analysis.targets.data();
  Some growth = {};
  Some negative = {};
  const Some zero = {};
  const Some one = zero + 1.0;
  for (const SymbolicAnalysis::Pivot& pivot : analysis.pivots) {
    const SymbolicAnalysis::Row* const begin =
        analysis.rows.data() + pivot.rows_begin;
    const int num_rows = pivot.rows_end - pivot.rows_begin;
    const int* target = targets + pivot.targets_begin;
    if (pivot.kind == Kind::Saddle) {
      // [a d; d 0]⁻¹ = [0 1/d; 1/d −a/d²]; a row with entries c_p, c_q takes
      // part with t c_qᵀ + c_q tᵀ, t = (c_p − (a/2d) c_q)/d.
      const Some inverse = 1.0 / W[pivot.d_pq];
      const Some twice = W[pivot.d_pp] * inverse;
      const Some half = 0.5 * twice;
      const int num_q = pivot.q_rows_end - pivot.rows_begin;
      for (int r = 0; r < num_rows; ++r) {
        const SymbolicAnalysis::Row& row = begin[r];
        if (row.in_p == 0) continue;
        const Some c_p = W[row.in_p];
        const Some c_q = W[row.in_q];
        const Some t = (c_p - half * c_q) * inverse;
        for (int s = 0; s < num_q; ++s) {
          W[*target++] -= t * W[begin[s].in_q];
        }
        if (row.diagonal != 0) W[row.diagonal] -= t * c_q;
        const Some multiplier = (c_p - twice * c_q) * inverse;
        growth += multiplier * multiplier;
        W[row.in_p] = multiplier;
      }
      for (int s = 0; s < num_q; ++s) {
        const Some multiplier = W[begin[s].in_q] * inverse;
        growth += multiplier * multiplier;
        W[begin[s].in_q] = multiplier;
      }
      W[pivot.d_pq] = inverse;
      if (pivot.d_pp != 0) W[pivot.d_pp] = -twice * inverse;
      negative += one;
      growth += inverse - inverse;
    } else if (pivot.kind == Kind::Single) {
      const Some d = W[pivot.d_pp];
      const Some inverse = 1.0 / d;
      for (int r = num_rows - 1; r >= 0; --r) {
        const Some multiplier = W[begin[r].in_p] * inverse;
        for (int s = 0; s <= r; ++s) {
          W[*target++] -= multiplier * W[begin[s].in_p];
        }
        growth += multiplier * multiplier;
        W[begin[r].in_p] = multiplier;
      }
      W[pivot.d_pp] = inverse;
      negative += d < 0.0 ? one : zero;
      growth += inverse - inverse;
    } else {
      const Some a = W[pivot.d_pp];
      const Some b = W[pivot.d_pq];
      const Some c = W[pivot.d_qq];
      const Some det = a * c - b * b;
      const Some i_pp = c / det;
      const Some i_pq = -b / det;
      const Some i_qq = a / det;
      for (int r = num_rows - 1; r >= 0; --r) {
        const Some c_p = W[begin[r].in_p];
        const Some c_q = W[begin[r].in_q];
        const Some l_p = i_pp * c_p + i_pq * c_q;
        const Some l_q = i_pq * c_p + i_qq * c_q;
        for (int s = 0; s <= r; ++s) {
          W[*target++] -= l_p * W[begin[s].in_p] + l_q * W[begin[s].in_q];
        }
        growth += l_p * l_p + l_q * l_q;
        W[begin[r].in_p] = l_p;
        W[begin[r].in_q] = l_q;
      }
      W[pivot.d_pp] = i_pp;
      W[pivot.d_pq] = i_pq;
      W[pivot.d_qq] = i_qq;
      const Some definite = a < 0.0 ? one + one : zero;
      negative += det < 0.0 ? one : definite;
      growth += det / det - one;
    }
  }
  outcome = {};
  Which::of(outcome.negative) = negative;
  Which::of(outcome.growth) = growth;
}

template <class Which>
[[gnu::always_inline]] inline void forward(const SymbolicAnalysis& analysis,
                                           const Lanes* slots, Lanes* rhs) {
  using Some = typename Which::Some;
  const LanesOf<Which, const Lanes> W{slots};
  const LanesOf<Which, Lanes> y{rhs};
  for (const SymbolicAnalysis::Pivot& pivot : analysis.pivots) {
    const SymbolicAnalysis::Row* row = analysis.rows.data() + pivot.rows_begin;
    const SymbolicAnalysis::Row* const end =
        analysis.rows.data() + pivot.rows_end;
    const Some y_p = y[pivot.p];
    const Some y_q = y[pivot.q];
    switch (pivot.kind) {
      case Kind::Single:
        for (; row != end; ++row) y[row->unknown] -= W[row->in_p] * y_p;
        y[pivot.p] = W[pivot.d_pp] * y_p;
        break;
      case Kind::Pair:
        for (; row != end; ++row) {
          y[row->unknown] -= W[row->in_p] * y_p + W[row->in_q] * y_q;
        }
        y[pivot.p] = W[pivot.d_pp] * y_p + W[pivot.d_pq] * y_q;
        y[pivot.q] = W[pivot.d_pq] * y_p + W[pivot.d_qq] * y_q;
        break;
      case Kind::Saddle:
        // The multiplier of p stands in the column of q and conversely.
        for (; row != end; ++row) {
          y[row->unknown] -= W[row->in_p] * y_q + W[row->in_q] * y_p;
        }
        y[pivot.p] = W[pivot.d_pq] * y_q;
        y[pivot.q] = W[pivot.d_pq] * y_p + W[pivot.d_pp] * y_q;
        break;
    }
  }
}

template <class Which>
[[gnu::always_inline]] inline void backward(const SymbolicAnalysis& analysis,
                                            const Lanes* slots,
                                            Lanes* solution) {
  using Some = typename Which::Some;
  const LanesOf<Which, const Lanes> W{slots};
  const LanesOf<Which, Lanes> x{solution};
  for (std::size_t k = analysis.pivots.size(); k-- > 0;) {
    const SymbolicAnalysis::Pivot& pivot = analysis.pivots[k];
    const SymbolicAnalysis::Row* row = analysis.rows.data() + pivot.rows_begin;
    const SymbolicAnalysis::Row* const end =
        analysis.rows.data() + pivot.rows_end;
    Some by_p = {};
    Some by_q = {};
    for (; row != end; ++row) {
      by_p += W[row->in_p] * x[row->unknown];
      by_q += W[row->in_q] * x[row->unknown];
    }
    if (pivot.kind == Kind::Single) {
      x[pivot.p] -= by_p;
    } else {
      const bool saddle = pivot.kind == Kind::Saddle;
      x[pivot.p] -= saddle ? by_q : by_p;
      x[pivot.q] -= saddle ? by_p : by_q;
    }
  }
}

}  // namespace

BRACHISTO_CLONES
unsigned gather(std::span<const LaneSource> sources,
                const double* const* arrays, const LaneLinks& links,
                const Lanes* scale, Lanes* slots, Lanes& largest) {
  // In halves, for which every instruction set with wide registers has maxima.
  constexpr int kHalves = 2;
  auto* const all = reinterpret_cast<Half*>(slots);
  const auto* const by = reinterpret_cast<const Half*>(scale);
  auto* const found = reinterpret_cast<Half*>(&largest);
  Half most[kHalves] = {found[0], found[1]};
  Half misfits[kHalves] = {};
  Half zero[kHalves] = {};  // as long as all numbers are finite
  for (const LaneSource& source : sources) {
    const double* const v = arrays[source.array] + source.first;
    const std::ptrdiff_t s = source.stride;
    for (int h = 0; h < kHalves; ++h) {
      const std::ptrdiff_t* const i = links.data() + h * kLanes / kHalves;
      Half value = {v[s * i[0]], v[s * i[1]], v[s * i[2]], v[s * i[3]]};
      if (scale != nullptr) {
        value *= by[kHalves * source.row + h] * by[kHalves * source.col + h];
      }
      const Half size = value < 0.0 ? -value : value;
      most[h] = most[h] < size ? size : most[h];
      zero[h] += value - value;
      Half& to = all[kHalves * source.slot + h];
      if (source.slot == 0) {
        misfits[h] = misfits[h] < size ? size : misfits[h];
      } else {
        to = source.adds ? to + value : value;
      }
    }
  }
  unsigned bits = 0;
  for (int h = 0; h < kHalves; ++h) {
    found[h] = most[h] + zero[h];
    for (int b = 0; b < kLanes / kHalves; ++b) {
      if (misfits[h][b] != 0.0) bits |= 1U << (kLanes / kHalves * h + b);
    }
  }
  return bits;
}

BRACHISTO_CLONES
void numeric_factorisation(const SymbolicAnalysis& analysis, Lanes* slots,
                           FactorisationOutcome& outcome, int lanes) {
  if (in_half(lanes)) return factorise<FirstHalf>(analysis, slots, outcome);
  factorise<Whole>(analysis, slots, outcome);
}

BRACHISTO_CLONES
void forward_substitution(const SymbolicAnalysis& analysis, const Lanes* slots,
                          Lanes* y, int lanes) {
  if (in_half(lanes)) return forward<FirstHalf>(analysis, slots, y);
  forward<Whole>(analysis, slots, y);
}

BRACHISTO_CLONES
void backward_substitution(const SymbolicAnalysis& analysis, const Lanes* slots,
                           Lanes* y, int lanes) {
  if (in_half(lanes)) return backward<FirstHalf>(analysis, slots, y);
  backward<Whole>(analysis, slots, y);
}

BRACHISTO_CLONES
double largest_of(const double* values, int count) {
  constexpr int kWidth = sizeof(Half) / sizeof(double);
  Half most = {};
  int i = 0;
  for (; i + kWidth <= count; i += kWidth) {
    Half some;
    std::memcpy(&some, values + i, sizeof(some));
    const Half size = some < 0.0 ? -some : some;
    most = most < size ? size : most;
  }
  double largest = 0.0;
  for (int b = 0; b < kWidth; ++b) largest = std::max(largest, most[b]);
  for (; i < count; ++i) largest = std::max(largest, std::abs(values[i]));
  return largest;
}

BRACHISTO_CLONES
int subtract_outer(double* matrix, int size, int from, const double* l,
                   const double* p) {
  int columns = 0;
  for (int j = from; j < size; ++j) {
    const double p_j = p[j];
    if (p_j == 0.0) continue;
    ++columns;
    double* __restrict column = matrix + static_cast<long>(size) * j;
    for (int i = from; i < size; ++i) column[i] -= l[i] * p_j;
  }
  return columns;
}

BRACHISTO_CLONES
int subtract_outer(double* matrix, int size, int from, const double* l,
                   const double* p, const double* m, const double* q) {
  int columns = 0;
  for (int j = from; j < size; ++j) {
    const double p_j = p[j], q_j = q[j];
    if (p_j == 0.0 && q_j == 0.0) continue;
    ++columns;
    double* __restrict column = matrix + static_cast<long>(size) * j;
    for (int i = from; i < size; ++i) column[i] -= l[i] * p_j + m[i] * q_j;
  }
  return columns;
}

}  // namespace brachisto
