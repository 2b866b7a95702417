// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The links of the chain, section by section.

#include <algorithm>
#include <bit>
#include <cmath>
#include <exception>
#include <span>
#include <thread>
#include <vector>

#include "brachisto/math/clock.hpp"
#include "brachisto/math/index.hpp"
#include "solvers/chain_ldlt.hpp"
#include "solvers/lane_failures.hpp"
#include "solvers/larger.hpp"

namespace brachisto {

namespace {

// To choose pivots takes as long as some dense fronts,
constexpr int kManyDenseLinks = 4;
// and a dense front as long as some batches of links with their joining.
constexpr int kBatchesOfDenseLink = 4;

}  // namespace

/// Pivots are chosen for the section in the middle before others are asked for
/// theirs: what was kept from a coarser mesh may suit no link of this one, and
/// how to join them is then for other pivots too.
void ChainLdlt::factorise_run(std::size_t r) {
  std::vector<Section*> all, joined;
  for (Section& section : sections_) {
    if (section.run != r) continue;
    all.push_back(&section);
    if (section.joined) joined.push_back(&section);
  }
  find_targets(map_.runs()[r], plans_[r]);
  std::vector<Section*> left = all;
  if (!joined.empty()) {
    Section* const middle = joined[joined.size() / 2];
    factorise_sections({&middle, 1}, true);
    choose_for(r, {&middle, 1}, true);
    std::erase(left, middle);
  }
  factorise_sections(left, false);
  choose_for(r, all, false);
  for (const Section* section : all) {
    for (const Batch& batch : section->batches) {
      if (batch.sequence != nullptr) batch.sequence->used = true;
    }
  }
}

/// Chooses pivots until most links have theirs; hard ones must not take all the
/// time. Sections with few of them are left as they are: what is chosen serves
/// the matrices to come.
void ChainLdlt::choose_for(std::size_t r, std::span<Section* const> sections,
                           bool choosing) {
  const Run& run = map_.runs()[r];
  for (int many = kManyDenseLinks;; many *= 2) {
    std::vector<int> dense;
    std::vector<Section*> left;
    for (Section* section : sections) {
      largest_ = larger(largest_, section->largest);
      for (const Piece& piece : section->pieces) {
        if (piece.analysis == nullptr) dense.push_back(piece.first);
      }
      if (kBatchesOfDenseLink * section->dense_links >=
          static_cast<int>(section->batches.size())) {
        left.push_back(section);
      }
    }
    if (std::ssize(dense) < many || !std::isfinite(largest_)) return;
    // Another one each time, for some have no pivots at all.
    if (!choose_sequence(run, plans_[r], dense[at(many - 1)])) continue;
    find_targets(run, plans_[r]);
    factorise_sections(left, choosing);
  }
}

/// Shares sections out to the threads, each its part of the chain.
///
/// \param choosing  how to join links too: one section alone
void ChainLdlt::factorise_sections(std::span<Section* const> sections,
                                   bool choosing) {
  const std::size_t threads = std::min(workers_.size(), sections.size());
  const auto part = [&](std::size_t t) {
    return sections.size() * t / threads;
  };
  std::vector<std::exception_ptr> thrown(threads);
  std::vector<std::jthread> others;
  for (std::size_t t = 1; t < threads; ++t) {
    others.emplace_back([&, t](const std::stop_token& stop) {
      try {
        for (std::size_t s = part(t); s < part(t + 1); ++s) {
          if (stop.stop_requested()) return;
          factorise_section(*sections[s], workers_[t], choosing);
        }
      } catch (...) {
        thrown[t] = std::current_exception();
      }
    });
  }
  for (std::size_t s = 0; threads > 0 && s < part(1); ++s) {
    check_stop();
    factorise_section(*sections[s], workers_[0], choosing);
  }
  for (std::jthread& other : others) other.join();
  for (const std::exception_ptr& one : thrown) {
    if (one) std::rethrow_exception(one);
  }
}

void ChainLdlt::factorise_section(Section& section, Worker& worker,
                                  bool choosing) {
  section.joints.clear();
  section.pieces.clear();
  section.schur.clear();
  section.negative = section.dense_links = 0;
  section.largest = 0.0;
  std::vector<Sequence*> sequences;
  for (const auto& sequence : plans_[section.run].sequences) {
    sequences.push_back(sequence.get());
  }
  int k = 0;
  for (std::size_t begin = 0; begin < section.links.size();
       begin += kLanes, ++k) {
    const int count = section.batch_at(begin);
    const auto links = std::span(section.links).subspan(begin, at(count));
    Batch& batch = section.batches[at(k)];
    batch = factorise_batch(section, worker, sequences, links);
    section.negative += batch.negative;
    Child& child = worker.children[0][at(k % 2)];
    child.failed = batch.failed;
    child.analysis = nullptr;
    if (batch.sequence != nullptr) {
      child.take(batch.sequence->analysis(), batch.slots);
    }
    for (int b = 0; b < count; ++b) {
      const int link = links[at(b)];
      if (bit(batch.failed, b)) {
        section.pieces.push_back({link, link});
        ++section.dense_links;
      } else if (!section.joined) {
        keep_piece(section, child, b, link, link);
      }
    }
    if (!section.joined) continue;
    for (int level = 1; (k + 1) % (1 << level) == 0; ++level) {
      join(section, worker, level, links.front() + kLanes - (kLanes << level),
           choosing);
      if (level == kLevels) break;
    }
  }
  std::ranges::sort(section.pieces, {}, &Piece::first);
}

/// Factorises the interiors of some links by the sequence that does it for most
/// of them, which is tried first from then on.
ChainLdlt::Batch ChainLdlt::factorise_batch(Section& section, Worker& worker,
                                            std::vector<Sequence*>& sequences,
                                            std::span<const int> links) const {
  Batch best;
  const Sequence* last = nullptr;
  const auto done_by = [&](Sequence* sequence) {
    const Batch batch = with_sequence(section, worker, *sequence, links);
    last = sequence;
    if (std::popcount(batch.failed) < std::popcount(best.failed)) best = batch;
    return best.failed == 0;
  };
  const auto found = std::ranges::find_if(sequences, done_by);
  if (found != sequences.end()) {
    std::rotate(sequences.begin(), found, found + 1);
  }
  if (best.sequence == nullptr) return best;
  if (best.sequence != last) {
    best = with_sequence(section, worker, *best.sequence, links);
  }
  worker.arena.keep(at(best.sequence->analysis().num_factor_slots));
  return best;
}

/// Factorises the interiors of some links where the arena ends.
ChainLdlt::Batch ChainLdlt::with_sequence(Section& section, Worker& worker,
                                          Sequence& sequence,
                                          std::span<const int> links) const {
  const int count = static_cast<int>(links.size());
  const SymbolicAnalysis& analysis = sequence.analysis();
  Batch batch{.sequence = &sequence,
              .slots = worker.arena.top(at(analysis.num_slots))};
  batch.failed = fill(section, worker, sequence, links, batch.slots);
  FactorisationOutcome outcome;
  numeric_factorisation(analysis, batch.slots, outcome, count);
  batch.failed |= grown(outcome);
  batch.failed &= (1U << at(count)) - 1U;
  batch.negative = negative_in(outcome, batch.failed, count);
  return batch;
}

/// Gathers the matrices of links, idle lanes repeating the last one. A
/// bit to each link with an entry that was assumed to be zero.
unsigned ChainLdlt::fill(Section& section, Worker& worker,
                         const Sequence& sequence, std::span<const int> of,
                         Lanes* slots) const {
  const Run& run = map_.runs()[section.run];
  for (const int slot : sequence.others) slots[slot] = {};
  Lanes largest;
  std::fill_n(largest.lane, kLanes, section.largest);
  LaneLinks links;
  for (int b = 0; b < kLanes; ++b) {
    links[at(b)] = of[std::min(at(b), of.size() - 1)];
  }
  std::vector<Lanes>& scale = worker.scale;
  if (!scale_.empty()) {
    scale.resize(run.unknowns.size());
    for (std::size_t i = 0; i < scale.size(); ++i) {
      const ChainMap::Affine& unknown = run.unknowns[i];
      for (int b = 0; b < kLanes; ++b) {
        const int link = static_cast<int>(links[at(b)]);
        const bool has = run.has(unknown, link);
        scale[i].lane[b] = has ? scale_[unknown.at(link)] : 0.0;
      }
    }
  }
  // Of those at the ends some have no place: one by one.
  const bool at_end = of.front() == 0 || of.back() == run.num_links - 1;
  const std::span<const LaneSource> sources = sequence.sources;
  std::size_t k = at_end ? sequence.num_whole : sources.size();
  unsigned misfits =
      gather(sources.first(k), values_.data(), links,
             scale_.empty() ? nullptr : scale.data(), slots, largest);
  for (; k < sources.size(); ++k) {
    const ChainMap::Entry& entry = run.entries[sequence.entries[k]];
    Lanes one;
    for (int b = 0; b < kLanes; ++b) {
      const int link = static_cast<int>(links[at(b)]);
      const bool has = run.has(entry.source, link);
      one.lane[b] = has ? scaled(run, entry, link) : 0.0;
    }
    const double* const array = one.lane;
    const LaneSource source{0, sources[k].slot, sources[k].adds, 0, 0, 0, 1};
    misfits |= gather({&source, 1}, &array, {0, 1, 2, 3, 4, 5, 6, 7}, nullptr,
                      slots, largest);
  }
  for (const double lane : largest.lane) {
    section.largest = larger(section.largest, lane);
  }
  return misfits;
}

void ChainLdlt::Child::take(const SymbolicAnalysis& link, const Lanes* slots) {
  analysis = &link;
  schur.clear();
  for (const auto& entry : link.schur) schur.push_back(slots[entry.slot]);
}

void ChainLdlt::keep_piece(Section& section, const Child& child, int lane,
                           int first, int last) {
  section.pieces.push_back({first, last, child.analysis, section.schur.size()});
  for (const Lanes& value : child.schur) {
    section.schur.push_back(value.lane[lane]);
  }
}

}  // namespace brachisto
