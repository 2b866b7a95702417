// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The sparsity of a symmetric matrix while unknowns are eliminated.

#pragma once

#include <utility>
#include <vector>

#include "brachisto/math/index.hpp"
#include "solvers/bit_set.hpp"
#include "solvers/link_pattern.hpp"
#include "solvers/symbolic_analysis.hpp"

namespace brachisto {

/// A pivot that might come next.
struct PivotCandidate {
  SymbolicAnalysis::Kind kind = SymbolicAnalysis::Kind::Single;
  int p = 0, q = 0;
  double cost = 0.0;  ///< operations per eliminated unknown
  /// Largest multiplier it would produce; negative: not asked yet.
  double growth = -1.0;
};

/// An elimination that was done, and what it reached.
struct EliminationStep {
  SymbolicAnalysis::Kind kind = SymbolicAnalysis::Kind::Single;
  int p = 0, q = 0;
  bool has_d_pp = true;
  std::vector<int> in_p, in_q;  ///< unknowns with an entry; Saddle: q's first
};

/// The structure of what is left of a matrix.
template <int kWords>
class EliminationStructure {
 public:
  using Kind = SymbolicAnalysis::Kind;
  using Set = BitSet<kWords>;

  explicit EliminationStructure(const LinkPattern& pattern)
      : adjacent(at(pattern.size)), count_(at(pattern.size)) {
    for (int i = 0; i < pattern.interior; ++i) left.set(i);
    for (int i = 0; i < pattern.size; ++i) {
      for (int j = 0; j <= i; ++j) {
        if (!pattern.has(i, j)) continue;
        adjacent[at(i)].set(j);
        adjacent[at(j)].set(i);
      }
    }
    for (int i = 0; i < pattern.size; ++i) count(i);
  }

  [[nodiscard]] bool has_diagonal(int i) const { return adjacent[at(i)][i]; }
  /// Neighbours of i but p and q.
  [[nodiscard]] Set others(int i, int p, int q) const {
    Set set = adjacent[at(i)];
    set.reset(p);
    set.reset(q);
    return set;
  }

  /// \pre has_diagonal(p)
  [[nodiscard]] PivotCandidate single(int p) const {
    const auto k = static_cast<double>(count_[at(p)] - 1);
    return {Kind::Single, p, p, 0.5 * k * (k + 1.0) + k};
  }
  /// \pre p and q are neighbours
  [[nodiscard]] PivotCandidate pair(int p, int q) const {
    if (!has_diagonal(p)) std::swap(p, q);
    // Their neighbours but for p and q.
    const auto in = [&](int i) {
      return static_cast<double>(count_[at(i)] - 1 - (has_diagonal(i) ? 1 : 0));
    };
    if (!has_diagonal(p)) {
      const double in_p = in(p);
      const double in_q = in(q);
      return {Kind::Saddle, p, q, 0.5 * (in_p * in_q + in_p + in_q)};
    }
    const auto both =
        static_cast<double>((adjacent[at(p)] | adjacent[at(q)]).count() - 2);
    if (!has_diagonal(q)) {
      const double in_q = in(q);
      return {Kind::Saddle, p, q, 0.5 * (both * in_q + both + in_q)};
    }
    return {Kind::Pair, p, q, 0.5 * (both * both + 2.0 * both)};
  }

  [[nodiscard]] EliminationStep eliminate(const PivotCandidate& pivot) {
    const int p = pivot.p;
    const int q = pivot.q;
    EliminationStep step;
    step.kind = pivot.kind;
    step.p = p;
    step.q = q;
    const auto list = [](const Set& set, std::vector<int>& out) {
      set.for_each([&](int i) { out.push_back(i); });
    };
    const Set P = others(p, p, q);
    step.in_p.reserve(adjacent.size());
    if (pivot.kind == Kind::Single) {
      list(P, step.in_p);
      P.for_each([&](int i) { adjacent[at(i)] |= P; });
      drop(p, P);
      P.for_each([&](int i) { count(i); });
      return step;
    }
    const Set Q = others(q, p, q);
    const bool saddle = pivot.kind == Kind::Saddle;
    step.has_d_pp = !saddle || has_diagonal(p);
    // A product of entries in p and q each; with d_pp ≠ 0 also one of two
    // entries in q, with d_qq ≠ 0 one of two in p.
    const Set in_p = step.has_d_pp ? P | Q : P;
    const Set in_q = saddle ? Q : P | Q;
    step.in_q.reserve(adjacent.size());
    list(in_q, step.in_q);
    list(in_p & in_q, step.in_p);
    list(in_p.without(in_q), step.in_p);
    in_p.for_each([&](int i) { adjacent[at(i)] |= in_q; });
    in_q.for_each([&](int i) { adjacent[at(i)] |= in_p; });
    drop(p, P);
    drop(q, Q);
    (P | Q).for_each([&](int i) { count(i); });
    return step;
  }

  Set left;  ///< of the interior
  std::vector<Set> adjacent;

 private:
  void drop(int i, const Set& neighbours) {
    left.reset(i);
    neighbours.for_each([&](int j) { adjacent[at(j)].reset(i); });
    adjacent[at(i)] = {};
  }
  void count(int i) { count_[at(i)] = adjacent[at(i)].count(); }

  std::vector<int> count_;  ///< of adjacent
};

}  // namespace brachisto
