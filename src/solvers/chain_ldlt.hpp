// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// LDLᵀ factorisation of symmetric indefinite matrices that are chains.

#pragma once

#include <array>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "brachisto/nlp/problem.hpp"
#include "nlp/active_set.hpp"
#include "solvers/chain_map.hpp"
#include "solvers/dense_front.hpp"
#include "solvers/inertia.hpp"
#include "solvers/lane_arena.hpp"
#include "solvers/numeric_factorisation.hpp"
#include "solvers/pivot_store.hpp"

namespace brachisto {

/// Arrays of values, in the order of the EntryPositions.
using EntryValues = std::span<const std::span<const double>>;

/// Factorisation in two stages, each with pivoting:
///
/// 1. The interiors of the links, independent of each other. Links that look
///    alike share sequences of 1×1 and 2×2 pivots, each chosen on one of them,
///    and are factorised several at once. Where the multipliers of one sequence
///    grow another one is tried: next to a bound other pivots are large than
///    far from it. A link in which the multipliers of all of them grow is
///    factorised on its own as a dense front.
/// 2. The Schur complement on the separators, a sweep of dense fronts along the
///    chain. Pivots that are too small for the rows below them are delayed to
///    the next separator. The border comes last.
///
/// The inertia is exact as far as rounding allows: the factorisation is that of
/// a matrix within a few units of rounding of the given one.
///
/// Memory is linear in the length of the chain.
class ChainLdlt {
 public:
  /// Null if the positions are no chain of that structure. The positions need
  /// not outlive the call.
  [[nodiscard]] static std::unique_ptr<ChainLdlt> make(
      const nlp::ChainStructure& structure,
      std::span<const EntryPositions> positions);

  /// Replaces the scale of the structure, for the factorisations to come.
  void set_scale(std::vector<double> scale) { scale_ = std::move(scale); }

  /// False if a value is not finite or the pivots could not be found. The
  /// values must stay until the next call.
  [[nodiscard]] bool factorise(EntryValues values);

  /// That of the last factorisation.
  [[nodiscard]] const Inertia& inertia() const { return inertia_; }

  /// Solves in place; entries of absent unknowns are left alone.
  /// \pre factorised, no zero eigenvalue
  void solve(std::span<double> x) const;

  /// residual −= A x, summed in long double.
  void subtract_product(std::span<const double> x,
                        std::span<long double> residual) const;

  /// Links whose interior was factorised as a dense front.
  [[nodiscard]] int num_dense_links() const;

 private:
  static constexpr unsigned kAllFailed = (1U << kLanes) - 1U;

  /// Pivots for a link of a run.
  struct Sequence {
    std::shared_ptr<const ChosenPivots> pivots;
    std::vector<char> nonzero;  ///< of the run's entries, on that link
    std::vector<int> slots;     ///< of the run's entries
    std::vector<char> sets;     ///< entries that are the first of their slots
    std::vector<int> others;    ///< slots that no such entry sets
    bool used = true;           ///< since the last factorisation began
    [[nodiscard]] const SymbolicAnalysis& analysis() const {
      return pivots->analysis;
    }
  };
  /// Links that are factorised at once.
  struct Batch {
    Sequence* sequence = nullptr;  ///< null: dense fronts
    Lanes* slots = nullptr;
    unsigned failed = kAllFailed;  ///< a bit to a link that is a dense front
    int negative = 0;              ///< pivots of the other ones
  };
  /// How the links of a run are factorised.
  struct Plan {
    std::vector<std::unique_ptr<Sequence>> sequences;  ///< the likeliest first
    std::vector<Batch> batches;
    int dense_links = 0;       ///< since the last factorisation began
    int most_dense_links = 0;  ///< with more, another sequence is wanted
  };
  using Run = ChainMap::Run;

  ChainLdlt(ChainMap map, std::vector<double> scale);

  /// The value of an entry of a link in the matrix that is factorised.
  [[nodiscard]] double scaled(const Run& run, const ChainMap::Entry& entry,
                              int link) const {
    const double value =
        values_[static_cast<std::size_t>(entry.array)][entry.source.at(link)];
    if (scale_.empty()) return value;
    const auto unknown = [&](int local) {
      return run.unknowns[static_cast<std::size_t>(local)].at(link);
    };
    return value * (scale_[unknown(entry.row)] * scale_[unknown(entry.col)]);
  }
  void apply_scale(std::span<double> x) const;

  void factorise_links();
  void link_matrix(const Run& run, int link, std::vector<double>& matrix) const;
  [[nodiscard]] std::vector<char> nonzero_of(const Run& run, int link) const;
  [[nodiscard]] bool choose_sequence(const Run& run, Plan& plan, int link);
  [[nodiscard]] std::shared_ptr<const ChosenPivots> pivots_for(
      const Run& run, const Plan& plan, const LinkPattern& pattern, int link);
  void begin_run(const Run& run, Plan& plan);
  void factorise_run(const Run& run, Plan& plan);
  [[nodiscard]] Batch factorise_batch(const Run& run, Plan& plan, int first,
                                      int count);
  [[nodiscard]] Batch with_sequence(const Run& run, Sequence& sequence,
                                    int first, int count);
  [[nodiscard]] Lanes gather(const Run& run, const ChainMap::Entry& entry,
                             int first, int count) const;
  [[nodiscard]] unsigned fill(const Run& run, const Sequence& sequence,
                              int first, int count, Lanes* slots);
  void dense_link(const Run& run, int link);
  void separator(const Run& run, int link, const SymbolicAnalysis* analysis,
                 const Lanes* slots, int lane);
  void last_front();
  template <class Visit>
  void for_each_batch(Visit&& visit) const;

  ChainMap map_;
  std::vector<double> scale_;  ///< of the structure, by unknown
  std::shared_ptr<PivotStore> store_ = PivotScope::store();
  std::vector<Plan> plans_;
  std::size_t longest_ = 0;  ///< run with the most links
  std::vector<std::span<const double>> values_;
  LaneArena arena_;
  FrontStack fronts_;
  FrontStack::Front front_, carried_, link_front_;
  int rejects_ = 0;         ///< interior unknowns of link_front_ left over
  std::vector<int> place_;  ///< of a link's unknowns in a front; −1: absent
  double largest_ = 0.0, zero_ = 0.0;
  int negative_ = 0;
  bool overflow_ = false;  ///< too many pivots were delayed
  Inertia inertia_;
  std::vector<double> matrix_;  ///< scratch
};

/// For the matrix [H Jᵀ; J 0] of variables that are not held and constraints
/// that are, values in two arrays: those of hess_lag_pattern() and those of
/// jac_g_pattern(). Unknowns are numbered as they are in the problem,
/// variables, then multipliers.
///
/// \return null if the problem states no chain structure that fits its patterns
[[nodiscard]] std::unique_ptr<ChainLdlt> make_chain_ldlt(
    const nlp::Problem& problem, const nlp::ActiveSet& active);

}  // namespace brachisto
