// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The last stage of the chain factorisation: what separators are left, in a
// sweep of dense fronts.

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "brachisto/math/clock.hpp"
#include "brachisto/math/index.hpp"
#include "solvers/chain_ldlt.hpp"
#include "solvers/larger.hpp"

namespace brachisto {

namespace {

// More delayed pivots than this, and smaller ones must do, but no smaller than
// refinement can make up for.
constexpr int kManyDelays = 24;

}  // namespace

void ChainLdlt::sweep() {
  fronts_.clear();
  overflow_ = false;
  carried_.reset(0);
  carried_.candidates = 0;
  int turn = 0;
  std::vector<std::pair<const Section*, const Piece*>> along;
  for (const Section& section : sections_) {
    for (const Piece& piece : section.pieces)
      along.push_back({&section, &piece});
  }
  std::ranges::sort(along, {}, [&](const auto& one) {
    return map_.runs()[one.first->run].position + one.second->first;
  });
  for (const auto& [section, piece] : along) {
    check_stop(turn++);
    if (piece->analysis == nullptr) {
      dense_link(map_.runs()[section->run], piece->first);
    }
    separator(*section, *piece);
    if (overflow_) return;
  }
  last_front();
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
  }
  fronts_.eliminate(link_front_, {zero_, false});
  rejects_ = link_front_.candidates;
}

/// Eliminates the separator on the left of a piece, with what was left over
/// before it and in it. The Schur complement of a dense link is in link_front_.
void ChainLdlt::separator(const Section& section, const Piece& piece) {
  const Run& run = map_.runs()[section.run];
  const int border = static_cast<int>(map_.border().size());
  const int first_right = run.interior + run.left;
  const int end_right = first_right + run.right;
  const auto link_of = [&](int i) {
    return i < first_right ? piece.first : piece.last;
  };
  const auto count = [&](int from, int to) {
    int sum = 0;
    for (int i = from; i < to; ++i) {
      if (run.has(run.unknowns[at(i)], link_of(i))) ++sum;
    }
    return sum;
  };
  const int left = count(run.interior, first_right);
  const int right = count(first_right, end_right);
  // carried_: delayed | left separator | border
  if (carried_.size() == 0) carried_.reset(at(left + border));
  const int old = carried_.size() - border;
  const int rejects = piece.analysis == nullptr ? rejects_ : 0;
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
  // The unknowns outside of the interior.
  place_.clear();
  int next = old - left;
  for (int i = run.interior; i < run.size(); ++i) {
    if (i == first_right) next = candidates;
    const ChainMap::Affine& unknown = run.unknowns[at(i)];
    const bool has = run.has(unknown, link_of(i));
    if (has) {
      front_.unknowns[at(next)] = static_cast<int>(unknown.at(link_of(i)));
    }
    place_.push_back(has ? next++ : -1);
  }
  if (piece.analysis != nullptr) {
    const double* next_value = section.schur.data() + piece.values;
    for (const auto& entry : piece.analysis->schur) {
      const double value = *next_value++;
      const int i = place_[at(entry.row - piece.analysis->interior)];
      const int j = place_[at(entry.col - piece.analysis->interior)];
      if (i < 0 || j < 0) continue;
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
  FrontStack::Rule rule{zero_, false};
  fronts_.eliminate(front_, rule);
  for (const double threshold : {1e-3, 1e-5}) {
    if (front_.candidates <= kManyDelays) break;
    rule.threshold = threshold;
    fronts_.eliminate(front_, rule);
  }
  if (front_.candidates > kManyDelays) {
    overflow_ = true;
    return;
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
  carried_.candidates = carried_.size();
  fronts_.eliminate(carried_, {zero_, true});
  if (carried_.candidates > 0) overflow_ = true;
}

}  // namespace brachisto
