// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// LDLᵀ factorisation of symmetric indefinite matrices that are chains.

#pragma once

#include <algorithm>
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
#include "solvers/lane_failures.hpp"
#include "solvers/numeric_factorisation.hpp"
#include "solvers/pivot_store.hpp"

namespace brachisto {

/// Arrays of values, in the order of the EntryPositions.
using EntryValues = std::span<const std::span<const double>>;

/// Factorisation in three stages, each with pivoting:
///
/// 1. The interiors of the links, independent of each other. Links that look
///    alike share sequences of 1×1 and 2×2 pivots, each chosen on one of them,
///    and are factorised several at once. Where the multipliers of one sequence
///    grow another one is tried: next to a bound other pivots are large than
///    far from it. A link in which the multipliers of all of them grow is
///    factorised on its own as a dense front.
/// 2. Of long chains, the separators between neighbours: two links joined are a
///    link again, whose interior is the separator between them, and so on for a
///    few levels. Links whose joining makes multipliers grow stay two.
/// 3. The Schur complement on what separators are left, a sweep of dense fronts
///    along the chain. Pivots that are too small for the rows below them are
///    delayed to the next separator. The border comes last.
///
/// The first two are done section by section, by several threads if there are
/// to be; the operations are the same for any number of them.
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
      nlp::ChainStructure structure, std::span<const EntryPositions> positions);

  /// Replaces the scale of the structure, for the factorisations to come.
  void set_scale(std::vector<double> scale) { scale_ = std::move(scale); }

  /// False if a value is not finite or the pivots could not be found. The
  /// values must stay until the next call.
  [[nodiscard]] bool factorise(EntryValues values);

  /// The next factorisation chooses pivots for its own numbers. Those that were
  /// kept from other matrices keep multipliers within bounds, which may not be
  /// enough where the matrix is nearly singular.
  /// \post not factorised
  void forget_pivots();

  /// That of the last factorisation.
  [[nodiscard]] const Inertia& inertia() const { return inertia_; }
  /// What it took: as much as that of so many unknowns whose links all kept
  /// their pivots.
  [[nodiscard]] double effort() const;

  /// Entries that are no part of the matrix, for one of their unknowns is
  /// absent and the other is not.
  [[nodiscard]] std::span<const ChainMap::Coupling> couplings() const {
    return map_.couplings();
  }

  /// Solves in place; entries of absent unknowns are left alone.
  /// \pre factorised, no zero eigenvalue
  void solve(std::span<double> x) const;

  /// residual −= A x, each component summed in long double and rounded once.
  void subtract_product(std::span<const double> x,
                        std::span<double> residual) const;

  /// Links whose interior was factorised as a dense front.
  [[nodiscard]] int num_dense_links() const;
  /// Links, joined ones counted as one, whose separators the sweep had to
  /// eliminate.
  [[nodiscard]] int num_swept() const;

 private:
  static constexpr unsigned kAllFailed = (1U << kLanes) - 1U;
  /// Links of a section that is joined: 2^kLevels batches, of which one
  /// remains.
  static constexpr int kLevels = 6;
  static constexpr int kSection = kLanes << kLevels;

  /// Pivots for a link of a run.
  struct Sequence {
    std::shared_ptr<const ChosenPivots> pivots;
    std::vector<char> nonzero;  ///< of the run's entries, on that link
    /// Of the run's entries, those that are in every link before the others.
    std::vector<LaneSource> sources;
    std::vector<std::size_t> entries;  ///< of the sources
    std::size_t num_whole = 0;         ///< sources in every link
    std::vector<int> others;           ///< slots that none of these set
    bool used = true;                  ///< in the last factorisation
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
  /// How two links of a level are joined: local unknowns are the separator
  /// between them, those on both sides, and the border.
  struct Joining {
    /// Where the Schur complement of a link goes to, entry by entry.
    struct Targets {
      const SymbolicAnalysis* from = nullptr;
      std::vector<int> as_left, as_right;
    };
    std::shared_ptr<const ChosenPivots> pivots;  ///< null: none were found
    std::vector<Targets> targets;
    [[nodiscard]] const Targets* from(const SymbolicAnalysis* link) const;
  };
  /// Pairs of links that are joined at once.
  struct Joint {
    /// Null: all stay two. Those of the Joining may be others since.
    std::shared_ptr<const ChosenPivots> pivots;
    Lanes* slots = nullptr;
    unsigned failed = kAllFailed;  ///< a bit to a pair that stays two
    unsigned left_failed = kAllFailed, right_failed = kAllFailed;

    /// One of the two of a pair.
    struct Half {
      int batch = 0, lane = 0;  ///< of those of the level below
      int first = 0, last = 0;  ///< links
    };
    /// visit(half) for what did not fail of pairs that stay two, each of so
    /// many links, the first of all being `first`.
    template <class Visit>
    void for_each_apart(int first, int links, Visit&& visit) const {
      for (int b = 0; b < kLanes; ++b, first += links) {
        if (!bit(failed, b)) continue;
        const int batch = 2 * b / kLanes;
        const int lane = 2 * b % kLanes;
        const int middle = first + links / 2;
        if (!bit(left_failed, b)) visit(Half{batch, lane, first, middle - 1});
        if (!bit(right_failed, b)) {
          visit(Half{batch, lane + 1, middle, first + links - 1});
        }
      }
    }
  };
  /// What is left of some links, joined, or of one.
  struct Piece {
    int first = 0, last = 0;
    const SymbolicAnalysis* analysis = nullptr;  ///< null: dense front
    std::size_t values = 0;                      ///< in the section's schur
  };
  /// Links of a run that are factorised by one thread.
  struct Section {
    std::size_t run = 0;
    std::vector<int> links;
    bool joined = false;  ///< neighbours, as many as can be
    std::vector<Batch> batches;
    std::vector<Joint> joints;  ///< in the order of their elimination
    std::vector<Piece> pieces;  ///< along the chain
    std::vector<double> schur;
    int negative = 0, dense_links = 0;
    double largest = 0.0;
    /// How many there are in a batch, from `begin` on.
    [[nodiscard]] int batch_at(std::size_t begin) const {
      return std::min(kLanes, static_cast<int>(links.size() - begin));
    }
  };
  /// How the links of a run are factorised.
  struct Plan {
    std::vector<std::unique_ptr<Sequence>> sequences;  ///< the likeliest first
    std::array<Joining, kLevels> joinings;
  };
  /// A batch of links, or of links that were joined, as the next level sees it.
  struct Child {
    const SymbolicAnalysis* analysis = nullptr;
    std::vector<Lanes> schur;  ///< in the order of analysis->schur
    unsigned failed = kAllFailed;
    /// What a factorisation left of them in its slots.
    void take(const SymbolicAnalysis& link, const Lanes* slots);
  };
  /// What a thread works with.
  struct Worker {
    Arena<Lanes> arena;
    std::array<std::array<Child, 2>, kLevels + 1> children;
    std::vector<Lanes> scale;  ///< of the local unknowns of a batch
  };
  using Run = ChainMap::Run;
  /// Which products make up the rows of a link: entries and their mirror
  /// images, row by row, so that sums are complete one by one.
  struct Products {
    struct Factor {
      int value, col;
    };
    std::vector<Factor> factors;
    std::vector<std::size_t> ends;  ///< of each row
    explicit Products(const Run& run);
  };

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

  // Pivots.
  void link_matrix(const Run& run, int link, std::vector<double>& matrix) const;
  [[nodiscard]] std::vector<char> nonzero_of(const Run& run, int link) const;
  [[nodiscard]] bool choose_sequence(const Run& run, Plan& plan, int link);
  [[nodiscard]] std::shared_ptr<const ChosenPivots> pivots_for(
      const Run& run, const Plan& plan, const LinkPattern& pattern, int link);
  void begin_run(const Run& run, Plan& plan);

  // The links, section by section.
  void factorise_run(std::size_t r);
  void choose_for(std::size_t r, std::span<Section* const> sections,
                  bool choosing);
  void factorise_sections(std::span<Section* const> sections, bool choosing);
  void factorise_section(Section& section, Worker& worker, bool choosing);
  [[nodiscard]] Batch factorise_batch(Section& section, Worker& worker,
                                      std::vector<Sequence*>& sequences,
                                      std::span<const int> links) const;
  [[nodiscard]] Batch with_sequence(Section& section, Worker& worker,
                                    Sequence& sequence,
                                    std::span<const int> links) const;
  [[nodiscard]] unsigned fill(Section& section, Worker& worker,
                              const Sequence& sequence,
                              std::span<const int> links, Lanes* slots) const;
  static void keep_piece(Section& section, const Child& child, int lane,
                         int first, int last);

  // What joins them.
  void join(Section& section, Worker& worker, int level, int first,
            bool choosing);
  [[nodiscard]] unsigned with_joining(const Joining& how, Worker& worker,
                                      int level, Lanes* slots,
                                      FactorisationOutcome& outcome) const;
  [[nodiscard]] std::shared_ptr<const ChosenPivots> joining_pivots(
      const Run& run, const Worker& worker, int level, const Joining& how);
  void find_targets(const Run& run, Plan& plan);

  // The sweep.
  void sweep();
  void dense_link(const Run& run, int link);
  void separator(const Section& section, const Piece& piece);
  void last_front();

  // Solutions.
  void forward(const Section& section, std::span<double> x) const;
  void backward(const Section& section, std::span<double> x) const;

  ChainMap map_;
  std::vector<double> scale_;  ///< of the structure, by unknown
  std::shared_ptr<PivotStore> store_ = ChainScope::store();
  std::vector<Products> products_;  ///< of each run
  std::vector<Plan> plans_;
  std::size_t longest_ = 0;  ///< run with the most links
  std::vector<Section> sections_;
  std::vector<Worker> workers_;
  std::vector<const double*> values_;
  FrontStack fronts_;
  FrontStack::Front front_, carried_, link_front_;
  int rejects_ = 0;         ///< interior unknowns of link_front_ left over
  std::vector<int> place_;  ///< of a link's unknowns in a front; −1: absent
  double largest_ = 0.0, zero_ = 0.0;
  bool overflow_ = false;  ///< too many pivots were delayed
  Inertia inertia_;
  std::vector<double> matrix_;  ///< scratch
};

/// The chain of a problem without what is held of variables and what is not of
/// constraints.
[[nodiscard]] nlp::ChainStructure chain_of(const nlp::Problem& problem,
                                           const nlp::ActiveSet& active);
/// For the matrix [H Jᵀ; J 0] of variables that are not held and constraints
/// that are, values in two arrays: those of hess_lag_pattern() and those of
/// jac_g_pattern(). Unknowns are numbered as they are in the problem,
/// variables, then multipliers.
///
/// \return null if the problem states no chain structure that fits its patterns
[[nodiscard]] std::unique_ptr<ChainLdlt> make_chain_ldlt(
    const nlp::Problem& problem, const nlp::ActiveSet& active);

}  // namespace brachisto
