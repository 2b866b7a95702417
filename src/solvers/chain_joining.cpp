// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Links of the chain joined at the separators between them.

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "brachisto/math/index.hpp"
#include "solvers/chain_ldlt.hpp"
#include "solvers/lane_failures.hpp"

namespace brachisto {

namespace {

/// Numbers of what is outside of a link, left, right and border, in two links
/// that are joined at a separator of `size` unknowns: there, left, right,
/// border.
int as_left(int outside, int size) {
  if (outside < size) return outside + size;
  return outside < 2 * size ? outside - size : outside + size;
}
int as_right(int outside, int size) {
  return outside < size ? outside : outside + size;
}

/// An entry of the matrix of a pair.
struct Place {
  int row, col;
};

/// Calls visit(left, right) for each entry of the Schur complement of a link:
/// the places it has in pairs as their left link and as their right one.
template <class Visit>
void for_each_in_pair(const SymbolicAnalysis& link, int size, Visit&& visit) {
  for (const auto& entry : link.schur) {
    const int row = entry.row - link.interior;
    const int col = entry.col - link.interior;
    visit(Place{as_left(row, size), as_left(col, size)},
          Place{as_right(row, size), as_right(col, size)});
  }
}

}  // namespace

const ChainLdlt::Joining::Targets* ChainLdlt::Joining::from(
    const SymbolicAnalysis* link) const {
  const auto found = std::ranges::find(targets, link, &Targets::from);
  return found == targets.end() ? nullptr : &*found;
}

/// Joins the links of two batches of the level below.
///
/// \param first  the first link of all
void ChainLdlt::join(Section& section, Worker& worker, int level, int first,
                     bool choosing) {
  const Run& run = map_.runs()[section.run];
  Joining& how = plans_[section.run].joinings[at(level - 1)];
  auto& below = worker.children[at(level - 1)];
  Joint joint;
  joint.left_failed = joint.right_failed = 0;
  for (int b = 0; b < kLanes; ++b) {
    const unsigned failed = below[at(2 * b / kLanes)].failed;
    const int left = 2 * b % kLanes;
    if (bit(failed, left)) joint.left_failed |= 1U << at(b);
    if (bit(failed, left + 1)) joint.right_failed |= 1U << at(b);
  }
  const unsigned before = joint.left_failed | joint.right_failed;
  FactorisationOutcome outcome;
  const auto factorise = [&] {
    joint.pivots = how.pivots;
    if (!how.pivots) return;
    joint.slots = worker.arena.top(at(how.pivots->analysis.num_slots));
    joint.failed =
        before | with_joining(how, worker, level, joint.slots, outcome);
  };
  factorise();
  if (choosing && (joint.failed & ~before) != 0) {
    if (auto chosen = joining_pivots(run, worker, level, how)) {
      how.pivots = std::move(chosen);
      find_targets(run, plans_[section.run]);
      factorise();
    }
  }
  const int links = 1 << level;  // of a pair
  joint.for_each_apart(first, links, [&](const Joint::Half& half) {
    keep_piece(section, below[at(half.batch)], half.lane, half.first,
               half.last);
  });
  const int batch = (first - section.links.front()) / (kLanes << level);
  Child& joined = worker.children[at(level)][at(batch % 2)];
  joined.failed = joint.failed;
  joined.analysis = nullptr;
  if (joint.pivots) {
    joined.take(joint.pivots->analysis, joint.slots);
    section.negative += negative_in(outcome, joint.failed, kLanes);
    worker.arena.keep(at(joined.analysis->num_factor_slots));
  }
  section.joints.push_back(joint);
  if (level < kLevels) return;
  for (int b = 0; b < kLanes; ++b) {
    if (bit(joint.failed, b)) continue;
    const int begin = first + b * links;
    keep_piece(section, joined, b, begin, begin + links - 1);
  }
}

/// Assembles and factorises pairs of links. A bit to each that fails.
unsigned ChainLdlt::with_joining(const Joining& how, Worker& worker, int level,
                                 Lanes* slots,
                                 FactorisationOutcome& outcome) const {
  const SymbolicAnalysis& analysis = how.pivots->analysis;
  std::fill_n(slots, analysis.num_slots, Lanes{});
  constexpr int kHalf = kLanes / 2;
  unsigned failed = 0;
  for (int half = 0; half < 2; ++half) {
    const Child& child = worker.children[at(level - 1)][at(half)];
    const Joining::Targets* targets = how.from(child.analysis);
    if (child.analysis == nullptr || targets == nullptr) {
      failed |= ((1U << kHalf) - 1U) << at(kHalf * half);
      continue;
    }
    const auto put = [&](int target, const Lanes& value, int parity) {
      double* const lane = slots[target].lane + kHalf * half;
      for (int b = 0; b < kHalf; ++b) lane[b] += value.lane[2 * b + parity];
      if (target != 0) return;
      // Assumed to be zero.
      for (int b = 0; b < kHalf; ++b) {
        if (lane[b] != 0.0) failed |= 1U << at(kHalf * half + b);
        lane[b] = 0.0;
      }
    };
    for (std::size_t k = 0; k < child.schur.size(); ++k) {
      put(targets->as_left[k], child.schur[k], 0);
      put(targets->as_right[k], child.schur[k], 1);
    }
  }
  numeric_factorisation(analysis, slots, outcome);
  return failed | grown(outcome);
}

/// Other pivots than there are: those of such a pair before, or chosen on the
/// first pair whose links did not fail. Null if there are none.
std::shared_ptr<const ChosenPivots> ChainLdlt::joining_pivots(
    const Run& run, const Worker& worker, int level, const Joining& how) {
  const auto& below = worker.children[at(level - 1)];
  const int size = run.left;
  LinkPattern pattern(run.size() - run.interior + size, size);
  const Child* sample = nullptr;
  int lane = 0;
  for (const Child& child : below) {
    if (child.analysis == nullptr) continue;
    for_each_in_pair(*child.analysis, size,
                     [&](const Place& left, const Place& right) {
                       pattern.set(left.row, left.col);
                       pattern.set(right.row, right.col);
                     });
    for (int b = kLanes - 2; b >= 0; b -= 2) {
      if (bit(child.failed, b) || bit(child.failed, b + 1)) continue;
      sample = &child;
      lane = b;
    }
  }
  const auto known = store_->find(pattern);
  if (known && known != how.pivots) return known;
  if (sample == nullptr) return nullptr;
  const std::size_t n = at(pattern.size);
  matrix_.assign(n * n, 0.0);
  const auto add = [&](const Place& place, double value) {
    const auto [i, j] = place;
    matrix_[at(i) + n * at(j)] += value;
    if (i != j) matrix_[at(j) + n * at(i)] += value;
  };
  auto value = sample->schur.begin();
  for_each_in_pair(*sample->analysis, size,
                   [&](const Place& left, const Place& right) {
                     add(left, value->lane[lane]);
                     add(right, value->lane[lane + 1]);
                     ++value;
                   });
  auto analysis = SymbolicAnalysis::make(pattern, matrix_);
  if (!analysis) return nullptr;
  return store_->add({pattern, std::move(*analysis)});
}

void ChainLdlt::find_targets(const Run& run, Plan& plan) {
  if (run.num_links < kSection) return;
  std::vector<const SymbolicAnalysis*> below;
  for (const auto& sequence : plan.sequences) {
    below.push_back(&sequence->analysis());
  }
  for (Joining& how : plan.joinings) {
    how.targets.clear();
    if (!how.pivots) {
      below.clear();
      continue;
    }
    const SymbolicAnalysis& to = how.pivots->analysis;
    const int size = run.left;
    for (const SymbolicAnalysis* from : below) {
      Joining::Targets& targets = how.targets.emplace_back();
      targets.from = from;
      for_each_in_pair(*from, size, [&](const Place& left, const Place& right) {
        targets.as_left.push_back(to.slot(left.row, left.col));
        targets.as_right.push_back(to.slot(right.row, right.col));
      });
    }
    below.assign(1, &to);
  }
}

}  // namespace brachisto
