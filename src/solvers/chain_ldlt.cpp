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
constexpr int kManyDenseLinks = 4;
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
    if (run.num_links > map_.runs()[longest_].num_links) longest_ = r;
  }
}

/// The full matrix of one link, its separators' blocks as far as they belong to
/// it.
void ChainLdlt::link_matrix(const Run& run, int link,
                            std::vector<double>& matrix) const {
  const std::size_t n = run.unknowns.size();
  matrix.assign(n * n, 0.0);
  for (const ChainMap::Entry& entry : run.entries) {
    if (!run.has(entry.source, link)) continue;
    const double value = scaled(run, entry, link);
    matrix[at(entry.row) + n * at(entry.col)] += value;
    if (entry.row != entry.col) {
      matrix[at(entry.col) + n * at(entry.row)] += value;
    }
  }
}

/// Which entries of a link differ from zero.
std::vector<char> ChainLdlt::nonzero_of(const Run& run, int link) const {
  std::vector<char> nonzero(run.entries.size());
  for (std::size_t k = 0; k < nonzero.size(); ++k) {
    const ChainMap::Entry& entry = run.entries[k];
    nonzero[k] = run.has(entry.source, link) &&
                 values_[at(entry.array)][entry.source.at(link)] != 0.0;
  }
  return nonzero;
}

/// Pivots for a link: those that were chosen for such a link before, those of
/// the links in the middle of the chain, or its own.
std::shared_ptr<const ChosenPivots> ChainLdlt::pivots_for(
    const Run& run, const Plan& plan, const LinkPattern& pattern, int link) {
  auto known = store_->find(pattern);
  const auto tried = [&](const auto& s) { return s->pivots == known; };
  if (known && std::ranges::none_of(plan.sequences, tried)) return known;
  const Plan& middle = plans_[longest_];
  std::optional<SymbolicAnalysis> analysis;
  if (plan.sequences.empty() && !middle.sequences.empty()) {
    analysis = middle.sequences.front()->analysis().moved_to(pattern);
  }
  if (!analysis) {
    link_matrix(run, link, matrix_);
    analysis = SymbolicAnalysis::make(pattern, matrix_);
  }
  if (!analysis) return nullptr;
  return store_->add({pattern, std::move(*analysis)});
}

/// Chooses a sequence for a link, to be tried first from now on. False if there
/// is none, or no more are wanted.
bool ChainLdlt::choose_sequence(const Run& run, Plan& plan, int link) {
  if (plan.sequences.size() == kMostSequences) return false;
  auto chosen = std::make_unique<Sequence>();
  chosen->nonzero = nonzero_of(run, link);
  LinkPattern pattern(run.size(), run.interior);
  for (std::size_t k = 0; k < run.entries.size(); ++k) {
    if (chosen->nonzero[k] == 0) continue;
    pattern.set(run.entries[k].row, run.entries[k].col);
  }
  chosen->pivots = pivots_for(run, plan, pattern, link);
  if (!chosen->pivots) return false;
  std::vector<char> set(at(chosen->analysis().num_slots), 0);
  for (const ChainMap::Entry& entry : run.entries) {
    const int slot = chosen->analysis().slot(entry.row, entry.col);
    chosen->slots.push_back(slot);
    chosen->sets.push_back(set[at(slot)] == 0 ? 1 : 0);
    set[at(slot)] = slot == 0 ? 0 : 1;
  }
  for (std::size_t s = 0; s < set.size(); ++s) {
    if (set[s] == 0) chosen->others.push_back(static_cast<int>(s));
  }
  plan.sequences.insert(plan.sequences.begin(), std::move(chosen));
  return true;
}

/// Forgets sequences without use, and brings the one for the link in the middle
/// to the front.
void ChainLdlt::begin_run(const Run& run, Plan& plan) {
  plan.dense_links = 0;
  plan.most_dense_links = kManyDenseLinks;
  auto& sequences = plan.sequences;
  if (sequences.size() == kMostSequences) {
    std::erase_if(sequences, [](const auto& s) { return !s->used; });
  }
  for (auto& sequence : sequences) sequence->used = false;
  const int sample = run.num_links / 2;
  const std::vector<char> nonzero = nonzero_of(run, sample);
  const auto found =
      std::find_if(sequences.begin(), sequences.end(),
                   [&](const auto& s) { return s->nonzero == nonzero; });
  if (found == sequences.end()) {
    (void)choose_sequence(run, plan, sample);
  } else {
    std::rotate(sequences.begin(), found, found + 1);
  }
}

/// An entry of `count` links; idle lanes repeat the last one.
Lanes ChainLdlt::gather(const Run& run, const ChainMap::Entry& entry, int first,
                        int count) const {
  Lanes out;
  const double* const values = values_[at(entry.array)].data();
  const auto [begin, end] = run.having(entry.source, {first, first + count});
  if (scale_.empty() && end - begin == kLanes) {
    const double* value =
        values + entry.source.first + entry.source.stride * first;
    for (double& lane : out.lane) {
      lane = *value;
      value += entry.source.stride;
    }
    return out;
  }
  for (int b = 0; b < kLanes; ++b) {
    const int link = first + std::min(b, count - 1);
    const bool has = begin <= link && link < end;
    out.lane[b] = has ? scaled(run, entry, link) : 0.0;
  }
  return out;
}

/// Gathers the matrices of `count` links. A bit to each link with an entry that
/// was assumed to be zero.
unsigned ChainLdlt::fill(const Run& run, const Sequence& sequence, int first,
                         int count, Lanes* slots) {
  for (const int slot : sequence.others) slots[slot] = {};
  Lanes largest;
  std::fill_n(largest.lane, kLanes, largest_);
  unsigned misfits = 0;
  for (std::size_t k = 0; k < run.entries.size(); ++k) {
    const Lanes value = gather(run, run.entries[k], first, count);
    for (int b = 0; b < kLanes; ++b) {
      largest.lane[b] = larger(largest.lane[b], std::abs(value.lane[b]));
    }
    const int slot = sequence.slots[k];
    if (slot == 0) {
      for (int b = 0; b < count; ++b) {
        if (value.lane[b] != 0.0) misfits |= 1U << at(b);
      }
    } else if (sequence.sets[k] != 0) {
      slots[slot] = value;
    } else {
      for (int b = 0; b < kLanes; ++b) slots[slot].lane[b] += value.lane[b];
    }
  }
  for (const double lane : largest.lane) largest_ = larger(largest_, lane);
  return misfits;
}

bool ChainLdlt::factorise(EntryValues values) {
  values_.assign(values.begin(), values.end());
  inertia_ = {};
  // The scale of the matrix, for what counts as zero in its first links.
  const Run& longest = map_.runs()[longest_];
  largest_ = 0.0;
  for (const ChainMap::Entry& entry : longest.entries) {
    const double value = scaled(longest, entry, longest.num_links / 2);
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
  // That with the most links first: others take its pivots.
  begin_run(map_.runs()[longest_], plans_[longest_]);
  for (std::size_t r = 0; r < plans_.size(); ++r) {
    if (r != longest_) begin_run(map_.runs()[r], plans_[r]);
  }
  for (std::size_t r = 0; r < plans_.size(); ++r) {
    factorise_run(map_.runs()[r], plans_[r]);
    if (overflow_ || !std::isfinite(largest_)) return;
  }
  last_front();
}

void ChainLdlt::factorise_run(const Run& run, Plan& plan) {
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
      separator(run, first + b, dense ? nullptr : &batch.sequence->analysis(),
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
  arena_.keep(at(best.sequence->analysis().num_factor_slots));
  return best;
}

/// Factorises the interiors of some links where the arena ends.
ChainLdlt::Batch ChainLdlt::with_sequence(const Run& run, Sequence& sequence,
                                          int first, int count) {
  Batch batch{.sequence = &sequence,
              .slots = arena_.top(at(sequence.analysis().num_slots))};
  batch.failed = fill(run, sequence, first, count, batch.slots);
  FactorisationOutcome outcome;
  numeric_factorisation(sequence.analysis(), batch.slots, outcome);
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
  place_.clear();
  int size = 0;
  for (const ChainMap::Affine& unknown : run.unknowns) {
    place_.push_back(run.has(unknown, link) ? size++ : -1);
  }
  link_front_.reset(at(size));
  link_front_.candidates = run.interior;
  for (std::size_t i = 0; i < run.unknowns.size(); ++i) {
    if (place_[i] < 0) continue;
    link_front_.unknowns[at(place_[i])] =
        static_cast<int>(run.unknowns[i].at(link));
  }
  for (const ChainMap::Entry& entry : run.entries) {
    if (!run.has(entry.source, link)) continue;
    const double value = scaled(run, entry, link);
    const int i = place_[at(entry.row)];
    const int j = place_[at(entry.col)];
    link_front_.at(i, j) += value;
    if (i != j) link_front_.at(j, i) += value;
    largest_ = larger(largest_, std::abs(value));
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
  const int first_right = run.interior + run.left;
  const int end_right = first_right + run.right;
  const auto count = [&](int from, int to) {
    int sum = 0;
    for (int i = from; i < to; ++i) sum += run.has(run.unknowns[at(i)], link);
    return sum;
  };
  const int left = count(run.interior, first_right);
  const int right = count(first_right, end_right);
  // carried_: delayed | left separator | border
  if (carried_.size() == 0) carried_.reset(at(left + border));
  const int old = carried_.size() - border;
  const int rejects = analysis == nullptr ? rejects_ : 0;
  const int candidates = old + rejects;
  const int first_border = candidates + right;
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
  // The link's unknowns from `interior` on.
  place_.clear();
  int next = old - left;
  for (int i = run.interior; i < run.size(); ++i) {
    if (i == first_right) next = candidates;
    const ChainMap::Affine& unknown = run.unknowns[at(i)];
    const bool has = run.has(unknown, link);
    if (has) front_.unknowns[at(next)] = static_cast<int>(unknown.at(link));
    place_.push_back(has ? next++ : -1);
  }
  if (analysis != nullptr) {
    for (const SymbolicAnalysis::SchurEntry& entry : analysis->schur) {
      const int i = place_[at(entry.row - run.interior)];
      const int j = place_[at(entry.col - run.interior)];
      if (i < 0 || j < 0) continue;
      const double value = slots[entry.slot].lane[lane];
      front_.at(i, j) += value;
      if (i != j) front_.at(j, i) += value;
    }
  } else {
    std::erase(place_, -1);
    const auto from_front = [&](int i) {
      return i < rejects ? old + i : place_[at(i - rejects)];
    };
    for (int j = 0; j < link_front_.size(); ++j) {
      const int to = from_front(j);
      front_.unknowns[at(to)] = link_front_.unknowns[at(j)];
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
