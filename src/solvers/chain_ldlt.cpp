// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "solvers/chain_ldlt.hpp"

#include <algorithm>
#include <bit>
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
constexpr int kManyDenseLinks = 16;
// Sequences of a run: as many as there are kinds of links, by which bounds they
// are next to; and how many of them are chosen in one factorisation at most.
constexpr std::size_t kMostSequences = 8;
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
  for (std::size_t r = 0; r < plans_.size(); ++r) {
    const Run& run = map_.runs()[r];
    plans_[r].batches.resize(at(batches(run.num_links)));
  }
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

/// Which entries of a link's matrix, which is left in matrix_, differ from
/// zero.
std::vector<char> ChainLdlt::pattern_of(const Run& run, int link) {
  link_matrix(run, link, matrix_);
  std::vector<char> pattern(matrix_.size());
  for (std::size_t i = 0; i < matrix_.size(); ++i) {
    pattern[i] = matrix_[i] != 0.0;
  }
  return pattern;
}

/// Chooses a sequence on one link, to be tried first from now on. False if
/// there is none, or no more are wanted.
bool ChainLdlt::choose_sequence(const Run& run, Plan& plan, int link) {
  if (plan.sequences.size() == kMostSequences) return false;
  std::vector<char> pattern = pattern_of(run, link);
  std::optional<SymbolicAnalysis> analysis =
      SymbolicAnalysis::make(matrix_, run.size(), run.interior);
  if (!analysis) return false;
  auto chosen = std::make_unique<Sequence>();
  chosen->pattern = std::move(pattern);
  chosen->analysis = std::move(*analysis);
  for (const ChainMap::Entry& entry : run.entries) {
    chosen->slots.push_back(chosen->analysis.slot(entry.row, entry.col));
  }
  plan.sequences.insert(plan.sequences.begin(), std::move(chosen));
  return true;
}

/// Forgets sequences without use, and brings the one for the link in the middle
/// to the front.
void ChainLdlt::begin_run(const Run& run, Plan& plan) {
  plan.dense_links = 0;
  plan.most_dense_links = kManyDenseLinks;
  if (run.num_links < kFewLinks) return;
  auto& sequences = plan.sequences;
  if (sequences.size() == kMostSequences) {
    std::erase_if(sequences, [](const auto& s) { return !s->used; });
  }
  for (auto& sequence : sequences) sequence->used = false;
  const int sample = run.num_links / 2;
  const std::vector<char> pattern = pattern_of(run, sample);
  const auto found =
      std::find_if(sequences.begin(), sequences.end(),
                   [&](const auto& s) { return s->pattern == pattern; });
  if (found == sequences.end()) {
    (void)choose_sequence(run, plan, sample);
  } else {
    std::rotate(sequences.begin(), found, found + 1);
  }
}

/// Gathers the matrices of `count` links. A bit to each link with an entry that
/// was assumed to be zero.
unsigned ChainLdlt::fill(const Run& run, const Sequence& sequence, int first,
                         int count, Lanes* slots) {
  const int num_slots = sequence.analysis.num_slots;
  std::fill_n(&slots[0].lane[0], at(num_slots) * at(kLanes), 0.0);
  double largest = largest_;
  unsigned misfits = 0;
  for (std::size_t k = 0; k < run.entries.size(); ++k) {
    const ChainMap::Entry& entry = run.entries[k];
    const double* const values = values_[at(entry.array)].data();
    std::ptrdiff_t place = entry.source.first + entry.source.stride * first;
    double* const lane = slots[sequence.slots[k]].lane;
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
    largest = larger(largest, seen);
    if (sequence.slots[k] != 0 || seen == 0.0) continue;
    for (int b = 0; b < count; ++b) {
      if (lane[b] != 0.0) misfits |= 1U << at(b);
    }
    std::fill_n(lane, kLanes, 0.0);
  }
  largest_ = largest;
  // Idle lanes repeat the last one.
  if (count < kLanes) {
    for (int s = 0; s < num_slots; ++s) {
      for (int b = count; b < kLanes; ++b) {
        slots[s].lane[b] = slots[s].lane[count - 1];
      }
    }
  }
  return misfits;
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
  factorise_links();
  if (!std::isfinite(largest_) || overflow_) return false;
  inertia_.known = true;
  inertia_.negative = negative_ + fronts_.negative();
  inertia_.zero = fronts_.zero();
  inertia_.positive = map_.num_unknowns() - inertia_.negative - inertia_.zero;
  return true;
}

int ChainLdlt::num_dense_links() const {
  int sum = 0;
  for (const Plan& plan : plans_) sum += plan.dense_links;
  return sum;
}

void ChainLdlt::factorise_links() {
  arena_.clear();
  fronts_.clear();
  negative_ = 0;
  overflow_ = false;
  carried_.reset(0);
  carried_.candidates = 0;
  for (std::size_t r = 0; r < plans_.size(); ++r) {
    factorise_run(map_.runs()[r], plans_[r]);
    if (overflow_ || !std::isfinite(largest_)) return;
  }
  last_front();
}

void ChainLdlt::factorise_run(const Run& run, Plan& plan) {
  begin_run(run, plan);
  for (int first = 0; first < run.num_links; first += kLanes) {
    check_stop(first);
    const int count = std::min(kLanes, run.num_links - first);
    Batch& batch = plan.batches[at(first / kLanes)];
    batch = factorise_batch(run, plan, first, count);
    if (!std::isfinite(largest_)) return;
    negative_ += batch.negative;
    zero_ = kZeroUnits * std::numeric_limits<double>::epsilon() * largest_;
    for (int b = 0; b < count; ++b) {
      const bool dense = ((batch.failed >> at(b)) & 1U) != 0;
      if (dense) {
        dense_link(run, first + b);
        ++plan.dense_links;
      }
      separator(run, first + b, dense ? nullptr : &batch.sequence->analysis,
                batch.slots, b);
      if (overflow_) return;
    }
  }
}

/// Factorises the interiors of some links by the sequence that does it for most
/// of them.
ChainLdlt::Batch ChainLdlt::factorise_batch(const Run& run, Plan& plan,
                                            int first, int count) {
  Batch best;
  const Sequence* last = nullptr;
  const auto done_by = [&](Sequence& sequence) {
    const Batch batch = with_sequence(run, sequence, first, count);
    last = &sequence;
    if (std::popcount(batch.failed) < std::popcount(best.failed)) best = batch;
    return best.failed == 0;
  };
  auto& sequences = plan.sequences;
  const auto found =
      std::find_if(sequences.begin(), sequences.end(),
                   [&](const auto& sequence) { return done_by(*sequence); });
  if (found != sequences.end()) {
    std::rotate(sequences.begin(), found, found + 1);
  } else if (plan.dense_links >= plan.most_dense_links) {
    // Twice as many the next time: hard links must not take all the time.
    plan.most_dense_links *= 2;
    const int hard = first + std::countr_zero(best.failed);
    if (choose_sequence(run, plan, hard)) done_by(*sequences.front());
  }
  if (best.sequence == nullptr) return best;
  if (best.sequence != last) {
    best = with_sequence(run, *best.sequence, first, count);
  }
  best.sequence->used = true;
  arena_.keep(at(best.sequence->analysis.num_factor_slots));
  return best;
}

/// Factorises the interiors of some links where the arena ends.
ChainLdlt::Batch ChainLdlt::with_sequence(const Run& run, Sequence& sequence,
                                          int first, int count) {
  Batch batch{.sequence = &sequence,
              .slots = arena_.top(at(sequence.analysis.num_slots))};
  batch.failed = fill(run, sequence, first, count, batch.slots);
  FactorisationOutcome outcome;
  numeric_factorisation(sequence.analysis, batch.slots, outcome);
  for (int b = 0; b < count; ++b) {
    if (!(outcome.growth.lane[b] <= kLargestGrowth * kLargestGrowth)) {
      batch.failed |= 1U << at(b);
    }
    if (((batch.failed >> at(b)) & 1U) == 0) {
      batch.negative += static_cast<int>(outcome.negative.lane[b]);
    }
  }
  return batch;
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
