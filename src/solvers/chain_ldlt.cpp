// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "solvers/chain_ldlt.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include "brachisto/math/stop_condition.hpp"
#include "math/index.hpp"

namespace brachisto {

namespace {

// Interiors of about this size keep the share of the separators small.
constexpr int kJoinTo = 45;
// To choose pivots takes as long as some dense fronts.
constexpr int kFewLinks = 6;
// The factorisation of a link is taken if the Frobenius norm of its multipliers
// is at most this: rounding errors are then magnified by less than its square,
// and one step of refinement makes up for them.
constexpr double kLargestGrowth = 1e3;
// A pivot below this many units of rounding of the largest entry is zero.
constexpr double kZeroUnits = 64.0;
// More delayed pivots than this, and smaller ones must do, but no smaller than
// refinement can make up for.
constexpr int kManyDelays = 24;
constexpr double kLeastThreshold = 1e-6;

/// The larger one; not a number stays what it is.
double larger(double a, double b) {
  return a >= b || std::isnan(a) ? a : b;
}

int batches(int links) {
  return (links + kLanes - 1) / kLanes;
}

}  // namespace

std::unique_ptr<ChainLdlt> ChainLdlt::make(
    const nlp::ChainStructure& structure,
    std::span<const EntryPositions> positions) {
  std::optional<ChainMap> map = ChainMap::make(structure, positions, kJoinTo);
  if (!map) return nullptr;
  return std::unique_ptr<ChainLdlt>(
      new ChainLdlt(std::move(*map), structure.scale));
}

ChainLdlt::ChainLdlt(ChainMap map, std::vector<double> scale)
    : map_(std::move(map)),
      scale_(std::move(scale)),
      plans_(map_.runs().size()) {
  std::size_t flags = 0;
  for (std::size_t r = 0; r < plans_.size(); ++r) {
    const Run& run = map_.runs()[r];
    plans_[r].failed = flags;
    plans_[r].sample = run.num_links / 2;
    plans_[r].also.assign(run.unknowns.size() * run.unknowns.size(), 0);
    flags += at(batches(run.num_links));
  }
  failed_.assign(flags, 0);
}

/// The full matrix of one link, its separators' blocks as far as they belong to
/// it.
void ChainLdlt::link_matrix(const Run& run, int link,
                            std::vector<double>& matrix) const {
  const std::size_t n = run.unknowns.size();
  matrix.assign(n * n, 0.0);
  for (const ChainMap::Entry& entry : run.entries) {
    const double value = scaled(run, entry, link);
    matrix[at(entry.row) + n * at(entry.col)] += value;
    if (entry.row != entry.col) {
      matrix[at(entry.col) + n * at(entry.row)] += value;
    }
  }
}

/// Takes the sequence for the pattern of the run's sample, or chooses one.
void ChainLdlt::analyse_run(const Run& run, Plan& plan) {
  plan.chosen = nullptr;
  if (run.num_links < kFewLinks) return;
  const std::size_t n = run.unknowns.size();
  link_matrix(run, plan.sample, matrix_);
  std::vector<char> pattern(n * n);
  for (std::size_t i = 0; i < n * n; ++i) {
    // A number that does not matter makes an entry of the structure.
    if (matrix_[i] == 0.0 && plan.also[i] != 0) {
      matrix_[i] = std::numeric_limits<double>::min();
    }
    pattern[i] = matrix_[i] != 0.0;
  }
  auto found = std::find_if(
      plan.known.begin(), plan.known.end(),
      [&](const auto& known) { return known->pattern == pattern; });
  if (found != plan.known.end() && (*found)->stale) {
    plan.known.erase(found);
    found = plan.known.end();
  }
  if (found != plan.known.end()) {
    plan.chosen = found->get();
  } else {
    std::optional<SymbolicAnalysis> analysis =
        SymbolicAnalysis::make(matrix_, run.size(), run.interior);
    if (!analysis) return;
    constexpr std::size_t kMostKnown = 4;
    if (plan.known.size() == kMostKnown) plan.known.erase(plan.known.begin());
    plan.known.push_back(std::make_unique<Known>());
    plan.known.back()->pattern = std::move(pattern);
    plan.known.back()->analysis = std::move(*analysis);
    plan.chosen = plan.known.back().get();
  }
  plan.slots.clear();
  for (const ChainMap::Entry& entry : run.entries) {
    plan.slots.push_back(plan.chosen->analysis.slot(entry.row, entry.col));
  }
}

/// Chooses sequences for all runs, and lays out their lanes.
void ChainLdlt::analyse_runs() {
  for (std::size_t r = 0; r < plans_.size(); ++r) {
    analyse_run(map_.runs()[r], plans_[r]);
  }
  std::size_t size = 0;
  std::size_t tail = 0;
  for (std::size_t r = 0; r < plans_.size(); ++r) {
    const Run& run = map_.runs()[r];
    Plan& plan = plans_[r];
    plan.storage = size;
    if (plan.chosen == nullptr) continue;
    const SymbolicAnalysis& analysis = plan.chosen->analysis;
    size += at(batches(run.num_links)) * at(analysis.num_factor_slots);
    // The Schur complement of a batch lies where the next batch will.
    tail = std::max(tail, at(analysis.num_slots));
  }
  if (size + tail <= storage_size_) return;
  storage_.reset();
  storage_size_ = size + tail;
  storage_ = std::make_unique_for_overwrite<Lanes[]>(storage_size_);
}

/// Gathers the matrices of `count` links. False if one has an entry that was
/// assumed to be zero.
bool ChainLdlt::fill(const Run& run, const Plan& plan, int first, int count,
                     Lanes* slots) {
  std::fill_n(&slots[0].lane[0],
              at(plan.chosen->analysis.num_slots) * at(kLanes), 0.0);
  double largest = largest_;
  bool as_assumed = true;
  for (std::size_t k = 0; k < run.entries.size(); ++k) {
    const ChainMap::Entry& entry = run.entries[k];
    const double* const values = values_[at(entry.array)].data();
    std::ptrdiff_t place = entry.source.first + entry.source.stride * first;
    double* const lane = slots[plan.slots[k]].lane;
    double seen = 0.0;
    if (scale_.empty()) {
      for (int b = 0; b < count; ++b) {
        const double value = values[place];
        place += entry.source.stride;
        lane[b] += value;
        seen = larger(seen, std::abs(value));
      }
    } else {
      for (int b = 0; b < count; ++b) {
        const double value = scaled(run, entry, first + b);
        lane[b] += value;
        seen = larger(seen, std::abs(value));
      }
    }
    if (plan.slots[k] == 0 && seen != 0.0) as_assumed = false;
    largest = larger(largest, seen);
  }
  largest_ = largest;
  // Idle lanes repeat the last one.
  if (count < kLanes) {
    for (int s = 0; s < plan.chosen->analysis.num_slots; ++s) {
      for (int b = count; b < kLanes; ++b) {
        slots[s].lane[b] = slots[s].lane[count - 1];
      }
    }
  }
  return as_assumed;
}

bool ChainLdlt::factorise(EntryValues values) {
  values_.assign(values.begin(), values.end());
  inertia_ = {};
  const Run& longest = *std::max_element(
      map_.runs().begin(), map_.runs().end(),
      [](const Run& a, const Run& b) { return a.num_links < b.num_links; });
  // The scale of the matrix, for what counts as zero in its first links.
  link_matrix(longest, longest.num_links / 2, matrix_);
  largest_ = 0.0;
  for (const double value : matrix_) {
    largest_ = larger(largest_, std::abs(value));
  }
  // An entry that was assumed zero and is not makes for a new start, but not
  // for ever: then the links concerned are dense.
  constexpr int kAttempts = 4;
  for (int attempt = 1; attempt <= kAttempts; ++attempt) {
    may_restart_ = attempt < kAttempts;
    restart_ = false;
    factorise_links();
    if (!restart_) break;
  }
  if (!std::isfinite(largest_) || overflow_) return false;
  inertia_.known = true;
  inertia_.negative = negative_ + fronts_.negative();
  inertia_.zero = fronts_.zero();
  inertia_.positive = map_.num_unknowns() - inertia_.negative - inertia_.zero;
  return true;
}

void ChainLdlt::factorise_links() {
  analyse_runs();
  fronts_.clear();
  negative_ = 0;
  num_dense_links_ = 0;
  overflow_ = false;
  carried_.reset(0);
  carried_.candidates = 0;
  for (std::size_t r = 0; r < plans_.size(); ++r) {
    factorise_run(r);
    if (restart_ || overflow_ || !std::isfinite(largest_)) return;
  }
  last_front();
}

/// Notes which entries of some links differ from zero.
void ChainLdlt::extend_pattern(const Run& run, Plan& plan, int first,
                               int count) {
  for (int link = first; link < first + count; ++link) {
    link_matrix(run, link, matrix_);
    for (std::size_t i = 0; i < matrix_.size(); ++i) {
      if (matrix_[i] != 0.0) plan.also[i] = 1;
    }
  }
}

void ChainLdlt::factorise_run(std::size_t r) {
  const Run& run = map_.runs()[r];
  Plan& plan = plans_[r];
  int failures = 0;
  int first_failure = 0;
  for (int first = 0; first < run.num_links; first += kLanes) {
    check_stop(first);
    const int count = std::min(kLanes, run.num_links - first);
    std::uint8_t& failed = failed_[plan.failed + at(first / kLanes)];
    failed = 0xff;
    Lanes* slots = nullptr;
    FactorisationOutcome outcome;
    if (plan.chosen != nullptr) {
      slots = &storage_[plan.storage +
                        at(first / kLanes) *
                            at(plan.chosen->analysis.num_factor_slots)];
      const bool as_assumed = fill(run, plan, first, count, slots);
      if (!std::isfinite(largest_)) return;
      if (!as_assumed) {
        extend_pattern(run, plan, first, count);
        restart_ = may_restart_;
        if (restart_) return;
      } else {
        numeric_factorisation(plan.chosen->analysis, slots, outcome);
        failed = 0;
        for (int b = 0; b < count; ++b) {
          if (outcome.growth.lane[b] <= kLargestGrowth * kLargestGrowth) {
            negative_ += static_cast<int>(outcome.negative.lane[b]);
          } else {
            failed = static_cast<std::uint8_t>(failed | (1U << b));
          }
        }
      }
    }
    zero_ = kZeroUnits * std::numeric_limits<double>::epsilon() * largest_;
    for (int b = 0; b < count; ++b) {
      const bool dense = ((failed >> b) & 1U) != 0;
      if (dense) {
        dense_link(run, first + b);
        if (++failures == 1) first_failure = first + b;
      }
      separator(run, first + b, dense ? nullptr : &plan.chosen->analysis, slots,
                b);
      if (overflow_) return;
    }
  }
  num_dense_links_ += failures;
  // Another sample next time, if this one stood for few.
  if (plan.chosen != nullptr && 8 * failures > run.num_links) {
    plan.chosen->stale = true;
    plan.sample = first_failure;
  }
}

/// Eliminates the interior of a link as a dense front.
void ChainLdlt::dense_link(const Run& run, int link) {
  link_matrix(run, link, matrix_);
  for (const double value : matrix_) {
    largest_ = larger(largest_, std::abs(value));
  }
  link_front_.reset(run.unknowns.size());
  link_front_.values.swap(matrix_);
  link_front_.candidates = run.interior;
  for (std::size_t i = 0; i < run.unknowns.size(); ++i) {
    link_front_.unknowns[i] = static_cast<int>(run.unknowns[i].at(link));
  }
  fronts_.eliminate(link_front_, {0.1, zero_, false});
  rejects_ = link_front_.candidates;
}

/// Eliminates the separator on the left of a link, with what was left over
/// before it and in the link.
///
/// \param analysis  null: the link's Schur complement is in link_front_
void ChainLdlt::separator(const Run& run, int link,
                          const SymbolicAnalysis* analysis, const Lanes* slots,
                          int lane) {
  const int border = static_cast<int>(map_.border().size());
  // carried_: delayed | left separator | border
  if (carried_.size() == 0) {
    carried_.reset(at(run.left + border));
    for (int i = 0; i < run.left; ++i) {
      carried_.unknowns[at(i)] =
          static_cast<int>(run.unknowns[at(run.interior + i)].at(link));
    }
    std::copy(map_.border().begin(), map_.border().end(),
              carried_.unknowns.begin() + run.left);
  }
  const int old = carried_.size() - border;
  const int rejects = analysis == nullptr ? rejects_ : 0;
  const int candidates = old + rejects;
  const int first_right = candidates;
  const int first_border = candidates + run.right;
  front_.reset(at(first_border + border));
  front_.candidates = candidates;
  // front_: delayed | left separator | rejects | right separator | border
  const auto from_carried = [&](int i) {
    return i < old ? i : first_border + i - old;
  };
  for (int j = 0; j < carried_.size(); ++j) {
    const int to = from_carried(j);
    front_.unknowns[at(to)] = carried_.unknowns[at(j)];
    for (int i = 0; i < old; ++i) front_.at(i, to) = carried_.at(i, j);
    for (int i = old; i < carried_.size(); ++i) {
      front_.at(first_border + i - old, to) = carried_.at(i, j);
    }
  }
  const int outside = run.left + run.right;
  // Local unknowns from `interior` on.
  const auto from_link = [&](int i) {
    if (i < run.left) return old - run.left + i;
    if (i < outside) return first_right + i - run.left;
    return first_border + i - outside;
  };
  for (int i = run.left; i < outside; ++i) {
    front_.unknowns[at(from_link(i))] =
        static_cast<int>(run.unknowns[at(run.interior + i)].at(link));
  }
  if (analysis != nullptr) {
    for (const SymbolicAnalysis::SchurEntry& entry : analysis->schur) {
      const int i = from_link(entry.row - run.interior);
      const int j = from_link(entry.col - run.interior);
      const double value = slots[entry.slot].lane[lane];
      front_.at(i, j) += value;
      if (i != j) front_.at(j, i) += value;
    }
  } else {
    const auto from_front = [&](int i) {
      return i < rejects ? old + i : from_link(i - rejects);
    };
    for (int j = 0; j < link_front_.size(); ++j) {
      const int to = from_front(j);
      if (j < rejects) front_.unknowns[at(to)] = link_front_.unknowns[at(j)];
      for (int i = 0; i < link_front_.size(); ++i) {
        front_.at(from_front(i), to) += link_front_.at(i, j);
      }
    }
  }
  FrontStack::Rule rule{0.1, zero_, false};
  fronts_.eliminate(front_, rule);
  while (front_.candidates > kManyDelays) {
    rule.threshold *= 1e-2;
    if (rule.threshold < kLeastThreshold) {
      overflow_ = true;
      return;
    }
    fronts_.eliminate(front_, rule);
  }
  std::swap(carried_, front_);
}

/// The last separator and the border.
void ChainLdlt::last_front() {
  const int border = static_cast<int>(map_.border().size());
  const int first_border = carried_.size() - border;
  for (const ChainMap::Entry& entry : map_.border_entries()) {
    double value = values_[at(entry.array)][entry.source.at(0)];
    if (!scale_.empty()) {
      value *= scale_[at(map_.border()[at(entry.row)])] *
               scale_[at(map_.border()[at(entry.col)])];
    }
    largest_ = larger(largest_, std::abs(value));
    const int i = first_border + entry.row;
    const int j = first_border + entry.col;
    carried_.at(i, j) += value;
    if (i != j) carried_.at(j, i) += value;
  }
  zero_ = kZeroUnits * std::numeric_limits<double>::epsilon() * largest_;
  carried_.candidates = carried_.size();
  fronts_.eliminate(carried_, {0.1, zero_, true});
  if (carried_.candidates > 0) overflow_ = true;
}

}  // namespace brachisto
