// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "solvers/symbolic_analysis.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "brachisto/math/index.hpp"
#include "solvers/bit_set.hpp"
#include "solvers/elimination_structure.hpp"

namespace brachisto {

namespace {

using Kind = SymbolicAnalysis::Kind;

// Wanted of the multipliers, and what is still accepted where no pivot keeps
// to it.
constexpr double kWantedGrowth = 10.0;
constexpr double kLargestGrowth = 1e3;

/// The elimination on one matrix, structure and numbers.
template <int kWords>
class Elimination {
 public:
  using Set = BitSet<kWords>;

  Elimination(const LinkPattern& pattern, std::span<const double> matrix)
      : structure(pattern),
        size_(pattern.size),
        a_(matrix.begin(), matrix.end()) {
    add_candidates(structure.left);
  }

  [[nodiscard]] bool done() const { return structure.left.none(); }

  /// The cheapest stable pivot, or nothing.
  [[nodiscard]] std::optional<PivotCandidate> best() {
    for (;;) {
      PivotCandidate* cheapest = nullptr;
      for (PivotCandidate& one : candidates_) {
        if (one.growth > kWantedGrowth) continue;
        if (cheapest == nullptr || one.cost < cheapest->cost) cheapest = &one;
      }
      if (cheapest == nullptr) break;
      if (cheapest->growth < 0.0) cheapest->growth = growth(*cheapest);
      if (cheapest->growth <= kWantedGrowth) return *cheapest;
    }
    const auto least =
        std::ranges::min_element(candidates_, {}, &PivotCandidate::growth);
    if (least == candidates_.end() || least->growth > kLargestGrowth) {
      return std::nullopt;
    }
    return *least;
  }

  [[nodiscard]] EliminationStep eliminate(const PivotCandidate& pivot) {
    const int p = pivot.p;
    const int q = pivot.q;
    const Set rows = structure.others(p, p, q) | structure.others(q, p, q);
    // The columns of the pivot in these rows, one after the other.
    rows_.clear();
    in_p_.clear();
    in_q_.clear();
    rows.for_each([&](int i) {
      rows_.push_back(at(i));
      in_p_.push_back(value(i, p));
      in_q_.push_back(value(i, q));
    });
    const bool single = pivot.kind == Kind::Single;
    const double inverse = single ? 1.0 / value(p, p) : 0.0;
    const double det = value(p, p) * value(q, q) - value(p, q) * value(p, q);
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      double* const column = a_.data() + at(size_) * rows_[k];
      const double c_p = in_p_[k];
      if (single) {
        const double multiplier = inverse * c_p;
        for (std::size_t l = 0; l < rows_.size(); ++l) {
          column[rows_[l]] -= multiplier * in_p_[l];
        }
        continue;
      }
      const double c_q = in_q_[k];
      const double to_p = (value(q, q) * c_p - value(p, q) * c_q) / det;
      const double to_q = (value(p, p) * c_q - value(p, q) * c_p) / det;
      for (std::size_t l = 0; l < rows_.size(); ++l) {
        column[rows_[l]] -= to_p * in_p_[l] + to_q * in_q_[l];
      }
    }
    EliminationStep step = structure.eliminate(pivot);
    // What others would do is as before where no neighbour went.
    Set changed = rows;
    changed.set(p);
    changed.set(q);
    std::erase_if(candidates_, [&](const PivotCandidate& one) {
      return changed[one.p] || changed[one.q];
    });
    add_candidates(rows & structure.left);
    return step;
  }

  EliminationStructure<kWords> structure;

 private:
  [[nodiscard]] double value(int i, int j) const {
    return a_[at(i) + at(size_) * at(j)];
  }

  /// All pivots that one of these unknowns has part in.
  void add_candidates(const Set& unknowns) {
    unknowns.for_each([&](int p) {
      if (structure.has_diagonal(p)) candidates_.push_back(structure.single(p));
      (structure.others(p, p, p) & structure.left).for_each([&](int q) {
        if (q > p || !unknowns[q]) candidates_.push_back(structure.pair(p, q));
      });
    });
  }

  /// Largest multiplier the pivot would produce; infinite if it is singular.
  [[nodiscard]] double growth(const PivotCandidate& pivot) const {
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
      structure.others(p, p, p).for_each(
          [&](int i) { see(value(i, p) / value(p, p)); });
      return largest;
    }
    const double det = value(p, p) * value(q, q) - value(p, q) * value(p, q);
    see(1.0 / det * det);
    const Set rows = structure.others(p, p, q) | structure.others(q, p, q);
    rows.for_each([&](int i) {
      see((value(q, q) * value(i, p) - value(p, q) * value(i, q)) / det);
      see((value(p, p) * value(i, q) - value(p, q) * value(i, p)) / det);
    });
    return largest;
  }

  int size_;
  std::vector<double> a_;
  std::vector<PivotCandidate> candidates_;
  std::vector<std::size_t> rows_;  ///< scratch
  std::vector<double> in_p_, in_q_;
};

/// Numbers the slots and lists the targets of a sequence of steps.
class Numbering {
 public:
  explicit Numbering(const LinkPattern& pattern) {
    analysis.size = pattern.size;
    analysis.interior = pattern.interior;
    analysis.slot_of.assign(at(pattern.size) * at(pattern.size), 0);
  }

  /// False if there are more products by now than a full link of some 230
  /// unknowns has: a dense front needs no list of their places.
  [[nodiscard]] bool columns(const EliminationStep& step) {
    constexpr double kMostProducts = 1 << 22;
    SymbolicAnalysis::Pivot pivot;
    pivot.kind = step.kind;
    pivot.p = step.p;
    pivot.q = step.q;
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
    products_ += 1.0 * (pivot.rows_end - pivot.rows_begin) *
                 (pivot.rows_end - pivot.rows_begin);
    return products_ <= kMostProducts;
  }

  template <class Set>
  void schur(const std::vector<Set>& adjacent) {
    analysis.num_factor_slots = analysis.num_slots;
    for (int j = analysis.interior; j < analysis.size; ++j) {
      for (int i = j; i < analysis.size; ++i) {
        if (adjacent[at(j)][i]) analysis.schur.push_back({i, j, add(i, j)});
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

  double products_ = 0.0;  ///< at most, of all steps so far
};

template <int kWords>
std::optional<SymbolicAnalysis> chosen(const LinkPattern& pattern,
                                       std::span<const double> matrix) {
  Elimination<kWords> elimination(pattern, matrix);
  Numbering numbering(pattern);
  while (!elimination.done()) {
    const std::optional<PivotCandidate> pivot = elimination.best();
    if (!pivot || !numbering.columns(elimination.eliminate(*pivot))) {
      return std::nullopt;
    }
  }
  numbering.schur(elimination.structure.adjacent);
  numbering.targets();
  return std::move(numbering.analysis);
}

template <int kWords>
std::optional<SymbolicAnalysis> moved(
    const LinkPattern& pattern,
    std::span<const SymbolicAnalysis::Pivot> pivots) {
  EliminationStructure<kWords> structure(pattern);
  Numbering numbering(pattern);
  for (const SymbolicAnalysis::Pivot& pivot : pivots) {
    const bool single = pivot.kind == Kind::Single;
    const int p = pivot.p;
    const int q = pivot.q;
    if (!structure.adjacent[at(p)][q]) return std::nullopt;
    const PivotCandidate next =
        single ? structure.single(p) : structure.pair(p, q);
    if (!numbering.columns(structure.eliminate(next))) return std::nullopt;
  }
  numbering.schur(structure.adjacent);
  numbering.targets();
  return std::move(numbering.analysis);
}

/// Calls work<kWords>() with as many words as a set of `size` unknowns has.
template <class Work>
auto with_words(int size, Work&& work) {
  static_assert(SymbolicAnalysis::kMaxSize == 64 * 64);
  if (size <= 64) return work.template operator()<1>();
  if (size <= 128) return work.template operator()<2>();
  if (size <= 192) return work.template operator()<3>();
  if (size <= 512) return work.template operator()<8>();
  return work.template operator()<64>();
}

}  // namespace

std::optional<SymbolicAnalysis> SymbolicAnalysis::make(
    const LinkPattern& pattern, std::span<const double> matrix) {
  if (pattern.size > kMaxSize) return std::nullopt;
  return with_words(pattern.size, [&]<int kWords>() {
    return chosen<kWords>(pattern, matrix);
  });
}

std::optional<SymbolicAnalysis> SymbolicAnalysis::moved_to(
    const LinkPattern& pattern) const {
  if (pattern.size > kMaxSize || pattern.interior != interior) {
    return std::nullopt;
  }
  return with_words(pattern.size, [&]<int kWords>() {
    return moved<kWords>(pattern, pivots);
  });
}

}  // namespace brachisto
