// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "solvers/pivot_store.hpp"

#include <algorithm>
#include <utility>

namespace brachisto {

namespace {

thread_local const ChainScope* scope_in_force = nullptr;

// Of a program with inequalities each combination of bounds may have a pattern.
constexpr std::size_t kMostKept = 64;

}  // namespace

std::shared_ptr<const ChosenPivots> PivotStore::find(
    const LinkPattern& pattern) const {
  const auto found =
      std::find_if(chosen_.rbegin(), chosen_.rend(),
                   [&](const auto& one) { return one->pattern == pattern; });
  return found == chosen_.rend() ? nullptr : *found;
}

std::shared_ptr<const ChosenPivots> PivotStore::add(ChosenPivots chosen) {
  if (chosen_.size() == kMostKept) chosen_.erase(chosen_.begin());
  return chosen_.emplace_back(
      std::make_shared<const ChosenPivots>(std::move(chosen)));
}

ChainScope::ChainScope(int threads)
    : before_(std::exchange(scope_in_force, this)), threads_(threads) {}

ChainScope::~ChainScope() {
  scope_in_force = before_;
}

std::shared_ptr<PivotStore> ChainScope::store() {
  return scope_in_force != nullptr ? scope_in_force->store_
                                   : std::make_shared<PivotStore>();
}

int ChainScope::threads() {
  return scope_in_force != nullptr ? scope_in_force->threads_ : 1;
}

}  // namespace brachisto
