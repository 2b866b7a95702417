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
  std::shared_ptr<const ChosenPivots> add(ChosenPivots chosen);

 private:
  std::vector<std::shared_ptr<const ChosenPivots>> chosen_;
};

/// All factorisations of this thread share one store for as long as this lives,
/// apart from what was before. What a solve finds thus depends on nothing that
/// was solved before it: whatever is to give the same digits in any order has a
/// scope of its own.
class PivotScope {
 public:
  PivotScope();
  ~PivotScope();
  PivotScope(const PivotScope&) = delete;
  PivotScope& operator=(const PivotScope&) = delete;

  /// That of the innermost scope; without one, a new store.
  [[nodiscard]] static std::shared_ptr<PivotStore> store();

 private:
  std::shared_ptr<PivotStore> before_;
};

}  // namespace brachisto
