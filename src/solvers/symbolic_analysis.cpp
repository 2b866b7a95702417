// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "solvers/symbolic_analysis.hpp"

#include <algorithm>
#include <bitset>
#include <cmath>

#include "math/index.hpp"

namespace brachisto {

namespace {

using Kind = SymbolicAnalysis::Kind;
using Set = std::bitset<SymbolicAnalysis::kMaxSize>;

// Wanted of the multipliers, and what is still accepted where no pivot keeps
// to it.
constexpr double kWantedGrowth = 10.0;
constexpr double kLargestGrowth = 1e3;

struct Candidate {
  double cost = 0.0;  ///< operations per eliminated unknown
  Kind kind = Kind::Single;
  int p = 0, q = 0;
};

struct Step {
  Candidate pivot;
  bool has_d_pp = true;
  std::vector<int> in_p, in_q;  ///< unknowns with an entry; Saddle: q's first
};

/// The elimination on one matrix, structure and numbers.
class Elimination {
 public:
  Elimination(std::span<const double> matrix, int size, int interior)
      : size_(size), a_(matrix.begin(), matrix.end()), adjacent_(at(size)) {
    for (int i = 0; i < interior; ++i) left_.set(at(i));
    for (int j = 0; j < size; ++j) {
      for (int i = 0; i < size; ++i) {
        if (value(i, j) != 0.0) adjacent_[at(j)].set(at(i));
      }
    }
  }

  [[nodiscard]] bool done() const { return left_.none(); }
  [[nodiscard]] const std::vector<Set>& adjacent() const { return adjacent_; }

  /// The cheapest stable pivot, or nothing.
  [[nodiscard]] std::optional<Candidate> best() const {
    std::vector<Candidate> candidates = all_candidates();
    std::sort(
        candidates.begin(), candidates.end(),
        [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
    const Candidate* least = nullptr;
    double least_growth = kLargestGrowth;
    for (const Candidate& candidate : candidates) {
      const double found = growth(candidate);
      if (found <= kWantedGrowth) return candidate;
      if (!(found <= least_growth)) continue;
      least_growth = found;
      least = &candidate;
    }
    if (least == nullptr) return std::nullopt;
    return *least;
  }

  /// Eliminates, structure and numbers.
  [[nodiscard]] Step eliminate(const Candidate& pivot) {
    Step step;
    step.pivot = pivot;
    const int p = pivot.p;
    const int q = pivot.q;
    const Set P = others(p, p, q);
    if (pivot.kind == Kind::Single) {
      step.in_p = list(P);
      const double inverse = 1.0 / value(p, p);
      for (const int i : step.in_p) {
        const double multiplier = inverse * value(i, p);
        for (const int j : step.in_p) value(i, j) -= multiplier * value(j, p);
        adjacent_[at(i)] |= P;
      }
      drop(p);
      return step;
    }
    const Set Q = others(q, p, q);
    const double det = value(p, p) * value(q, q) - value(p, q) * value(p, q);
    const bool saddle = pivot.kind == Kind::Saddle;
    step.has_d_pp = !saddle || adjacent_[at(p)][at(p)];
    // Structure: a product of entries in p and q each; with d_pp ≠ 0 also one
    // of two entries in q, with d_qq ≠ 0 one of two in p.
    const Set in_p = step.has_d_pp ? P | Q : P;
    const Set in_q = saddle ? Q : P | Q;
    step.in_q = list(in_q);
    step.in_p = list(in_p & in_q);
    for (const int i : list(in_p & ~in_q)) step.in_p.push_back(i);
    const Set all = P | Q;
    std::vector<double> to_p(at(size_)), to_q(at(size_));
    for (const int i : list(all)) {
      const double c_p = value(i, p);
      const double c_q = value(i, q);
      to_p[at(i)] = (value(q, q) * c_p - value(p, q) * c_q) / det;
      to_q[at(i)] = (value(p, p) * c_q - value(p, q) * c_p) / det;
    }
    const std::vector<int> rows = list(all);
    for (const int i : rows) {
      for (const int j : rows) {
        value(i, j) -= to_p[at(i)] * value(j, p) + to_q[at(i)] * value(j, q);
      }
    }
    for (const int i : list(in_p)) adjacent_[at(i)] |= in_q;
    for (const int i : list(in_q)) adjacent_[at(i)] |= in_p;
    drop(p);
    drop(q);
    return step;
  }

 private:
  double& value(int i, int j) { return a_[at(i) + at(size_) * at(j)]; }
  [[nodiscard]] double value(int i, int j) const {
    return a_[at(i) + at(size_) * at(j)];
  }
  [[nodiscard]] std::vector<int> list(const Set& set) const {
    std::vector<int> out;
    for (int i = 0; i < size_; ++i) {
      if (set[at(i)]) out.push_back(i);
    }
    return out;
  }
  /// Neighbours of i but p and q.
  [[nodiscard]] Set others(int i, int p, int q) const {
    Set set = adjacent_[at(i)];
    set.reset(at(p));
    set.reset(at(q));
    return set;
  }
  void drop(int i) {
    left_.reset(at(i));
    for (Set& set : adjacent_) set.reset(at(i));
    adjacent_[at(i)].reset();
  }
  [[nodiscard]] std::vector<Candidate> all_candidates() const {
    std::vector<Candidate> out;
    for (const int p : list(left_)) {
      if (adjacent_[at(p)][at(p)]) {
        const auto k = static_cast<double>(others(p, p, p).count());
        out.push_back({0.5 * k * (k + 1.0) + k, Kind::Single, p, p});
      }
      for (const int q : list(adjacent_[at(p)] & left_)) {
        if (q <= p) continue;
        const bool p_zero = !adjacent_[at(p)][at(p)];
        const bool q_zero = !adjacent_[at(q)][at(q)];
        const Set P = others(p, p, q);
        const Set Q = others(q, p, q);
        const auto both = static_cast<double>((P | Q).count());
        const auto in_p = static_cast<double>(P.count());
        const auto in_q = static_cast<double>(Q.count());
        if (p_zero && q_zero) {
          out.push_back(
              {0.5 * (in_p * in_q + in_p + in_q), Kind::Saddle, p, q});
        } else if (q_zero) {
          out.push_back(
              {0.5 * (both * in_q + both + in_q), Kind::Saddle, p, q});
        } else if (p_zero) {
          out.push_back(
              {0.5 * (both * in_p + both + in_p), Kind::Saddle, q, p});
        } else {
          out.push_back({0.5 * (both * both + 2.0 * both), Kind::Pair, p, q});
        }
      }
    }
    return out;
  }

  /// Largest multiplier the pivot would produce; infinite if it is singular.
  [[nodiscard]] double growth(const Candidate& pivot) const {
    const int p = pivot.p;
    const int q = pivot.q;
    double largest = 0.0;
    const auto see = [&](double multiplier) {
      largest = std::isfinite(multiplier)
                    ? std::max(largest, std::abs(multiplier))
                    : INFINITY;
    };
    if (pivot.kind == Kind::Single) {
      see(1.0 / value(p, p) * value(p, p));
      for (const int i : list(others(p, p, p))) {
        see(value(i, p) / value(p, p));
      }
      return largest;
    }
    const double det = value(p, p) * value(q, q) - value(p, q) * value(p, q);
    see(1.0 / det * det);
    for (const int i : list(others(p, p, q) | others(q, p, q))) {
      see((value(q, q) * value(i, p) - value(p, q) * value(i, q)) / det);
      see((value(p, p) * value(i, q) - value(p, q) * value(i, p)) / det);
    }
    return largest;
  }

  int size_;
  std::vector<double> a_;
  std::vector<Set> adjacent_;
  Set left_;
};

/// Numbers the slots and lists the targets of a sequence of steps.
class Numbering {
 public:
  Numbering(int size, int interior) {
    analysis.size = size;
    analysis.interior = interior;
    analysis.slot_of.assign(at(size) * at(size), 0);
  }

  void columns(const Step& step) {
    SymbolicAnalysis::Pivot pivot;
    pivot.kind = step.pivot.kind;
    pivot.p = step.pivot.p;
    pivot.q = step.pivot.q;
    if (step.has_d_pp) pivot.d_pp = add(pivot.p, pivot.p);
    if (pivot.kind != Kind::Single) pivot.d_pq = add(pivot.p, pivot.q);
    if (pivot.kind == Kind::Pair) pivot.d_qq = add(pivot.q, pivot.q);
    pivot.rows_begin = static_cast<int>(analysis.rows.size());
    for (const int i : step.in_q) {
      SymbolicAnalysis::Row row;
      row.unknown = i;
      row.in_q = add(i, pivot.q);
      analysis.rows.push_back(row);
    }
    pivot.q_rows_end = static_cast<int>(analysis.rows.size());
    for (const int i : step.in_p) {
      auto row = std::find_if(analysis.rows.begin() + pivot.rows_begin,
                              analysis.rows.end(),
                              [&](const auto& r) { return r.unknown == i; });
      if (row == analysis.rows.end()) {
        row = analysis.rows.emplace(analysis.rows.end());
        row->unknown = i;
      }
      row->in_p = add(i, pivot.p);
    }
    pivot.rows_end = static_cast<int>(analysis.rows.size());
    analysis.pivots.push_back(pivot);
  }

  void schur(const std::vector<Set>& adjacent) {
    analysis.num_factor_slots = analysis.num_slots;
    for (int j = analysis.interior; j < analysis.size; ++j) {
      for (int i = j; i < analysis.size; ++i) {
        if (adjacent[at(j)][at(i)]) analysis.schur.push_back({i, j, add(i, j)});
      }
    }
  }

  void targets() {
    for (SymbolicAnalysis::Pivot& pivot : analysis.pivots) {
      pivot.targets_begin = static_cast<int>(analysis.targets.size());
      const auto row = [&](int r) -> SymbolicAnalysis::Row& {
        return analysis.rows[at(r)];
      };
      if (pivot.kind == Kind::Saddle) {
        for (int r = pivot.rows_begin; r < pivot.rows_end; ++r) {
          const int i = row(r).unknown;
          if (row(r).in_p == 0) continue;
          if (row(r).in_q != 0) row(r).diagonal = analysis.slot(i, i);
          for (int s = pivot.rows_begin; s < pivot.q_rows_end; ++s) {
            analysis.targets.push_back(analysis.slot(i, row(s).unknown));
          }
        }
        continue;
      }
      for (int r = pivot.rows_end - 1; r >= pivot.rows_begin; --r) {
        for (int s = pivot.rows_begin; s <= r; ++s) {
          analysis.targets.push_back(
              analysis.slot(row(r).unknown, row(s).unknown));
        }
      }
    }
  }

  SymbolicAnalysis analysis;

 private:
  int add(int i, int j) {
    const int slot = analysis.num_slots++;
    analysis.slot_of[at(i) + at(analysis.size) * at(j)] = slot;
    analysis.slot_of[at(j) + at(analysis.size) * at(i)] = slot;
    return slot;
  }
};

}  // namespace

std::optional<SymbolicAnalysis> SymbolicAnalysis::make(
    std::span<const double> matrix, int size, int interior) {
  if (size > kMaxSize) return std::nullopt;
  Elimination elimination(matrix, size, interior);
  Numbering numbering(size, interior);
  while (!elimination.done()) {
    const std::optional<Candidate> pivot = elimination.best();
    if (!pivot) return std::nullopt;
    numbering.columns(elimination.eliminate(*pivot));
  }
  numbering.schur(elimination.adjacent());
  numbering.targets();
  return std::move(numbering.analysis);
}

}  // namespace brachisto
