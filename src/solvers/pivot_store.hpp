// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Pivots that were chosen once, for all matrices of a solve.

#pragma once

#include <memory>
#include <vector>

#include "solvers/link_pattern.hpp"
#include "solvers/symbolic_analysis.hpp"

namespace brachisto {

/// Pivots chosen on a link, and its pattern.
struct ChosenPivots {
  LinkPattern pattern;
  SymbolicAnalysis analysis;
};

/// To choose pivots takes as long as many factorisations with them, and the
/// next step of a continuation or the next mesh, of the same degree, asks for
/// the same. Whether they suit its numbers is seen from their multipliers.
class PivotStore {
 public:
  /// The last ones for such a link, or null.
  [[nodiscard]] std::shared_ptr<const ChosenPivots> find(
      const LinkPattern& pattern) const;
  /// The last ones for a link of which a few entries more or less differ from
  /// zero, or null: some vanish by chance, at one point and not at another.
  [[nodiscard]] std::shared_ptr<const ChosenPivots> find_alike(
      const LinkPattern& pattern) const;
  std::shared_ptr<const ChosenPivots> add(ChosenPivots chosen);
  void clear() { chosen_.clear(); }

 private:
  /// The last one that fits, or null.
  template <class Fits>
  [[nodiscard]] std::shared_ptr<const ChosenPivots> last(Fits&& fits) const;

  std::vector<std::shared_ptr<const ChosenPivots>> chosen_;
};

/// All chain factorisations of this thread share one store for as long as this
/// lives, apart from what was before, and work with so many threads. What a
/// solve finds thus depends on nothing that was solved before it: whatever is
/// to give the same digits in any order has a scope of its own.
class ChainScope {
 public:
  explicit ChainScope(int threads = 1);
  ~ChainScope();
  ChainScope(const ChainScope&) = delete;
  ChainScope& operator=(const ChainScope&) = delete;

  /// That of the innermost scope; without one, a new store.
  [[nodiscard]] static std::shared_ptr<PivotStore> store();
  /// Without a scope one.
  [[nodiscard]] static int threads();

 private:
  const ChainScope* before_;
  std::shared_ptr<PivotStore> store_ = std::make_shared<PivotStore>();
  int threads_;
};

}  // namespace brachisto
