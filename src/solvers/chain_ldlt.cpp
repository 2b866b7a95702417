// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "solvers/chain_ldlt.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "brachisto/math/index.hpp"

namespace brachisto {

namespace {

// Interiors of about this size keep the share of the separators small.
constexpr int kJoinTo = 45;
// Sequences of a run: as many as there are kinds of links, by which bounds they
// are next to.
constexpr std::size_t kMostSequences = 8;
// A pivot below this many units of rounding of the largest entry is zero.
constexpr double kZeroUnits = 64.0;

}  // namespace

std::unique_ptr<ChainLdlt> ChainLdlt::make(
    nlp::ChainStructure structure, std::span<const EntryPositions> positions) {
  std::vector<double> scale = std::move(structure.scale);
  std::optional<ChainMap> map =
      ChainMap::make(std::move(structure), positions, kJoinTo);
  if (!map) return nullptr;
  return std::unique_ptr<ChainLdlt>(
      new ChainLdlt(std::move(*map), std::move(scale)));
}

ChainLdlt::ChainLdlt(ChainMap map, std::vector<double> scale)
    : map_(std::move(map)),
      scale_(std::move(scale)),
      products_(map_.runs().begin(), map_.runs().end()),
      plans_(map_.runs().size()),
      workers_(at(ChainScope::threads())) {
  std::size_t most = 0;
  for (std::size_t r = 0; r < plans_.size(); ++r) {
    const Run& run = map_.runs()[r];
    if (run.links().size() > most) longest_ = r;
    most = std::max(most, run.links().size());
    const auto add = [&](std::vector<int> links, bool joined) {
      Section& section = sections_.emplace_back();
      section.run = r;
      section.batches.resize((links.size() + kLanes - 1) / kLanes);
      section.links = std::move(links);
      section.joined = joined;
    };
    std::vector<int> apart;
    for (const auto& [begin, end] : run.stretches) {
      for (int first = begin; first < end; first += kSection) {
        std::vector<int> links(at(std::min(kSection, end - first)));
        std::iota(links.begin(), links.end(), first);
        if (links.size() == kSection) {
          add(std::move(links), true);
        } else {
          apart.insert(apart.end(), links.begin(), links.end());
        }
      }
    }
    if (!apart.empty()) add(std::move(apart), false);
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
/// one that is nearly such a link or is in the middle of the chain, or its own.
std::shared_ptr<const ChosenPivots> ChainLdlt::pivots_for(
    const Run& run, const Plan& plan, const LinkPattern& pattern, int link) {
  auto known = store_->find(pattern);
  const auto tried = [&](const auto& s) { return s->pivots == known; };
  if (known && std::ranges::none_of(plan.sequences, tried)) return known;
  const Plan& middle = plans_[longest_];
  std::optional<SymbolicAnalysis> analysis;
  if (const auto alike = known ? nullptr : store_->find_alike(pattern)) {
    analysis = alike->analysis.moved_to(pattern);
  } else if (plan.sequences.empty() && !middle.sequences.empty()) {
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
  const auto see = [&](bool whole) {
    for (std::size_t k = 0; k < run.entries.size(); ++k) {
      const ChainMap::Entry& entry = run.entries[k];
      const auto& source = entry.source;
      if (whole == (source.not_in_first || source.not_in_last)) continue;
      const int slot = chosen->analysis().slot(entry.row, entry.col);
      chosen->sources.push_back({entry.array, slot, set[at(slot)] != 0,
                                 entry.row, entry.col, source.first,
                                 source.stride});
      chosen->entries.push_back(k);
      set[at(slot)] = slot == 0 ? 0 : 1;
    }
  };
  see(true);
  chosen->num_whole = chosen->sources.size();
  see(false);
  for (std::size_t s = 0; s < set.size(); ++s) {
    if (set[s] == 0) chosen->others.push_back(static_cast<int>(s));
  }
  plan.sequences.insert(plan.sequences.begin(), std::move(chosen));
  return true;
}

/// Forgets sequences without use, and brings the one for the link in the middle
/// to the front.
void ChainLdlt::begin_run(const Run& run, Plan& plan) {
  auto& sequences = plan.sequences;
  if (sequences.size() == kMostSequences) {
    std::erase_if(sequences, [](const auto& s) { return !s->used; });
  }
  for (auto& sequence : sequences) sequence->used = false;
  const std::vector<int> links = run.links();
  const int sample = links[links.size() / 2];
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

double ChainLdlt::effort() const {
  // An update is a multiplication of a vectorised loop, an unknown some
  // hundreds of scattered ones.
  constexpr double kUpdatesPerUnknown = 500.0;
  return map_.num_unknowns() + fronts_.updates() / kUpdatesPerUnknown;
}

bool ChainLdlt::factorise(EntryValues values) {
  values_.clear();
  for (const std::span<const double> array : values) {
    values_.push_back(array.data());
  }
  inertia_ = {};
  for (Worker& worker : workers_) worker.arena.clear();
  // That with the most links first: others take its pivots.
  begin_run(map_.runs()[longest_], plans_[longest_]);
  for (std::size_t r = 0; r < plans_.size(); ++r) {
    if (r != longest_) begin_run(map_.runs()[r], plans_[r]);
  }
  largest_ = 0.0;
  for (std::size_t r = 0; r < plans_.size(); ++r) {
    factorise_run(r);
    if (!std::isfinite(largest_)) return false;
  }
  zero_ = kZeroUnits * std::numeric_limits<double>::epsilon() * largest_;
  sweep();
  if (!std::isfinite(largest_) || overflow_) return false;
  inertia_.known = true;
  inertia_.negative = fronts_.negative();
  for (const Section& section : sections_) {
    inertia_.negative += section.negative;
  }
  inertia_.zero = fronts_.zero();
  inertia_.positive = map_.num_unknowns() - inertia_.negative - inertia_.zero;
  return true;
}

void ChainLdlt::forget_pivots() {
  store_->clear();
  for (Plan& plan : plans_) plan = {};
}

int ChainLdlt::num_dense_links() const {
  int sum = 0;
  for (const Section& section : sections_) sum += section.dense_links;
  return sum;
}

int ChainLdlt::num_swept() const {
  std::size_t sum = 0;
  for (const Section& section : sections_) sum += section.pieces.size();
  return static_cast<int>(sum);
}

}  // namespace brachisto
