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
// Less than what the bound of one unknown changes.
constexpr int kFewEntries = 4;

}  // namespace

template <class Fits>
std::shared_ptr<const ChosenPivots> PivotStore::last(Fits&& fits) const {
  const auto found = std::find_if(chosen_.rbegin(), chosen_.rend(),
                                  [&](const auto& one) { return fits(*one); });
  return found == chosen_.rend() ? nullptr : *found;
}

std::shared_ptr<const ChosenPivots> PivotStore::find(
    const LinkPattern& pattern) const {
  return last([&](const ChosenPivots& one) { return one.pattern == pattern; });
}

std::shared_ptr<const ChosenPivots> PivotStore::find_alike(
    const LinkPattern& pattern) const {
  return last([&](const ChosenPivots& one) {
    return one.pattern.size == pattern.size &&
           one.pattern.interior == pattern.interior &&
           one.pattern.num_different(pattern) <= kFewEntries;
  });
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
