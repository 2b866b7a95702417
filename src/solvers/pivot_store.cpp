// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "solvers/pivot_store.hpp"

#include <algorithm>
#include <utility>

namespace brachisto {

namespace {

thread_local std::shared_ptr<PivotStore> store_in_force;

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

PivotScope::PivotScope()
    : before_(std::exchange(store_in_force, std::make_shared<PivotStore>())) {}

PivotScope::~PivotScope() {
  store_in_force = std::move(before_);
}

std::shared_ptr<PivotStore> PivotScope::store() {
  return store_in_force ? store_in_force : std::make_shared<PivotStore>();
}

}  // namespace brachisto
