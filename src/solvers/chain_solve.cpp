// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Solutions by a chain factorisation, and their residuals.

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

#include "brachisto/math/clock.hpp"
#include "brachisto/math/index.hpp"
#include "solvers/chain_ldlt.hpp"
#include "solvers/lane_failures.hpp"

namespace brachisto {

namespace {

using Affine = ChainMap::Affine;
using Run = ChainMap::Run;

/// visit(lane, place) for an unknown of the links `first`, `first` + `step`, …
/// that have it.
template <class Visit>
void for_each_lane(const Run& run, const Affine& unknown, int first, int step,
                   Visit&& visit) {
  const int end = first + step * (kLanes - 1) + 1;
  const auto [begin, last] = run.having(unknown, {first, end});
  if (begin == first && last == end) {
    std::size_t place = unknown.at(first);
    const std::ptrdiff_t stride = unknown.stride * step;
    for (int b = 0; b < kLanes; ++b) {
      visit(b, place);
      place += static_cast<std::size_t>(stride);
    }
    return;
  }
  for (int b = 0; b < kLanes; ++b) {
    const int link = first + b * step;
    if (run.has(unknown, link)) visit(b, unknown.at(link));
  }
}

}  // namespace

ChainLdlt::Products::Products(const Run& run) {
  const auto for_each_factor = [&](auto&& visit) {
    int value = 0;
    for (const ChainMap::Entry& entry : run.entries) {
      visit(entry.row, entry.col, value);
      if (entry.row != entry.col) visit(entry.col, entry.row, value);
      ++value;
    }
  };
  ends.resize(run.unknowns.size() + 1);
  for_each_factor([&](int row, int, int) { ++ends[at(row) + 1]; });
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  factors.resize(ends.back());
  for_each_factor([&](int row, int col, int value) {
    factors[ends[at(row)]++] = {value, col};
  });
}

void ChainLdlt::apply_scale(std::span<double> x) const {
  for (std::size_t i = 0; i < scale_.size(); ++i) x[i] *= scale_[i];
}

void ChainLdlt::solve(std::span<double> x) const {
  apply_scale(x);
  for (const Section& section : sections_) {
    check_stop();
    forward(section, x);
  }
  fronts_.forward(x);
  fronts_.backward(x);
  for (const Section& section : sections_) {
    check_stop();
    backward(section, x);
  }
  apply_scale(x);
}

/// What the links of a section, and what joins them, add to the right-hand
/// sides outside of them goes up the levels as their Schur complements did.
void ChainLdlt::forward(const Section& section, std::span<double> x) const {
  const Run& run = map_.runs()[section.run];
  const int outside = run.size() - run.interior;
  const int size = run.left;  // of a separator
  std::vector<Lanes> local;
  std::array<std::array<std::vector<Lanes>, 2>, kLevels + 1> added;
  // To x, of the links from `first` to `last`.
  const auto add = [&](std::span<const Lanes> from, int lane, int first,
                       int last) {
    for (int i = 0; i < outside; ++i) {
      const Affine& unknown = run.unknowns[at(run.interior + i)];
      const int link = i < size ? first : last;
      if (run.has(unknown, link)) x[unknown.at(link)] += from[at(i)].lane[lane];
    }
  };
  const auto join = [&](const Joint& joint, int level, int first) {
    const auto& below = added[at(level - 1)];
    const int links = 1 << level;
    joint.for_each_apart(first, links, [&](const Joint::Half& half) {
      add(below[at(half.batch)], half.lane, half.first, half.last);
    });
    // Those of pairs that stay two are not asked for.
    const auto left = [&](int i, int b) {
      return below[at(2 * b / kLanes)][at(i)].lane[2 * b % kLanes];
    };
    const auto right = [&](int i, int b) {
      return below[at(2 * b / kLanes)][at(i)].lane[2 * b % kLanes + 1];
    };
    local.resize(at(size + outside));
    for (int i = 0; i < size; ++i) {
      for_each_lane(run, run.unknowns[at(run.interior + i)], first + links / 2,
                    links, [&](int b, std::size_t place) {
                      local[at(i)].lane[b] =
                          x[place] + left(size + i, b) + right(i, b);
                    });
      for (int b = 0; b < kLanes; ++b) {
        local[at(size + i)].lane[b] = left(i, b);
        local[at(2 * size + i)].lane[b] = right(size + i, b);
      }
    }
    for (int i = 2 * size; i < outside; ++i) {
      for (int b = 0; b < kLanes; ++b) {
        local[at(size + i)].lane[b] = left(i, b) + right(i, b);
      }
    }
    if (joint.pivots) {
      forward_substitution(joint.pivots->analysis, joint.slots, local.data());
    }
    for (int i = 0; i < size; ++i) {
      for_each_lane(run, run.unknowns[at(run.interior + i)], first + links / 2,
                    links, [&](int b, std::size_t place) {
                      if (bit(joint.failed, b)) return;
                      x[place] = local[at(i)].lane[b];
                    });
    }
    for (int b = 0; b < kLanes && level == kLevels; ++b) {
      if (bit(joint.failed, b)) continue;
      add(std::span(local).subspan(at(size)), b, first + b * links,
          first + (b + 1) * links - 1);
    }
    const int batch = (first - section.links.front()) / (kLanes << level);
    added[at(level)][at(batch % 2)].assign(local.begin() + size, local.end());
  };
  auto joint = section.joints.begin();
  for (std::size_t k = 0; k < section.batches.size(); ++k) {
    const Batch& batch = section.batches[k];
    const int* const links = section.links.data() + kLanes * k;
    const int count = section.batch_at(kLanes * k);
    local.assign(run.unknowns.size(), Lanes{});
    if (batch.sequence != nullptr) {
      for (int i = 0; i < run.interior; ++i) {
        for (int b = 0; b < count; ++b) {
          local[at(i)].lane[b] = x[run.unknowns[at(i)].at(links[b])];
        }
      }
      forward_substitution(batch.sequence->analysis(), batch.slots,
                           local.data(), count);
    }
    auto& to = added[0][k % 2];
    to.assign(local.begin() + run.interior, local.end());
    for (int b = 0; b < count; ++b) {
      if (bit(batch.failed, b)) continue;
      for (int i = 0; i < run.interior; ++i) {
        x[run.unknowns[at(i)].at(links[b])] = local[at(i)].lane[b];
      }
      if (!section.joined) add(to, b, links[b], links[b]);
    }
    if (!section.joined) continue;
    const int read = static_cast<int>(k) + 1;
    for (int level = 1; level <= kLevels && read % (1 << level) == 0; ++level) {
      join(*joint++, level, links[0] + kLanes - (kLanes << level));
    }
  }
}

void ChainLdlt::backward(const Section& section, std::span<double> x) const {
  const Run& run = map_.runs()[section.run];
  const int outside = run.size() - run.interior;
  const int size = run.left;
  std::vector<Lanes> local;
  // In the order opposite to that of their elimination.
  auto joint = section.joints.end();
  const auto part = [&](const Joint& one, int level, int first) {
    const int links = 1 << level;
    if (!one.pivots) return;
    local.assign(at(size + outside), Lanes{});
    const auto take = [&](int to, int outer, int link) {
      for_each_lane(
          run, run.unknowns[at(run.interior + outer)], link, links,
          [&](int b, std::size_t place) { local[at(to)].lane[b] = x[place]; });
    };
    for (int i = 0; i < size; ++i) take(i, i, first + links / 2);
    for (int i = 0; i < outside; ++i) {
      take(size + i, i, i < size ? first : first + links - 1);
    }
    backward_substitution(one.pivots->analysis, one.slots, local.data());
    for (int i = 0; i < size; ++i) {
      for_each_lane(run, run.unknowns[at(run.interior + i)], first + links / 2,
                    links, [&](int b, std::size_t place) {
                      if (bit(one.failed, b)) return;
                      x[place] = local[at(i)].lane[b];
                    });
    }
  };
  for (std::size_t k = section.batches.size(); k-- > 0;) {
    const int* const links = section.links.data() + kLanes * k;
    const int read = static_cast<int>(k) + 1;
    for (int level = kLevels; section.joined && level > 0; --level) {
      if (read % (1 << level) != 0) continue;
      part(*--joint, level, links[0] + kLanes - (kLanes << level));
    }
    const Batch& batch = section.batches[k];
    if (batch.sequence == nullptr) continue;
    const int count = section.batch_at(kLanes * k);
    const bool at_end = links[0] == 0 || links[count - 1] == run.num_links - 1;
    local.assign(run.unknowns.size(), Lanes{});
    for (std::size_t i = 0; i < run.unknowns.size(); ++i) {
      const Affine& unknown = run.unknowns[i];
      for (int b = 0; b < count; ++b) {
        if (at_end && !run.has(unknown, links[b])) continue;
        local[i].lane[b] = x[unknown.at(links[b])];
      }
    }
    backward_substitution(batch.sequence->analysis(), batch.slots, local.data(),
                          count);
    for (int i = 0; i < run.interior; ++i) {
      for (int b = 0; b < count; ++b) {
        if (bit(batch.failed, b)) continue;
        x[run.unknowns[at(i)].at(links[b])] = local[at(i)].lane[b];
      }
    }
  }
}

void ChainLdlt::subtract_product(std::span<const double> x,
                                 std::span<double> residual) const {
  std::vector<double> local, values;
  std::vector<long double> sums, border;
  for (const int i : map_.border()) border.push_back(residual[at(i)]);
  // What a link leaves to the next one of the separator between them.
  struct SoFar {
    std::size_t unknown;
    long double value;
  };
  std::vector<SoFar> separator;
  for (const auto& [r, links] : map_.along_chain()) {
    const Run& run = map_.runs()[r];
    const std::vector<std::size_t>& ends = products_[r].ends;
    local.resize(run.unknowns.size());
    sums.resize(run.unknowns.size());
    values.resize(run.entries.size());
    const int first_right = run.interior + run.left;
    const int first_border = first_right + run.right;
    for (int link = links.begin; link < links.end; ++link) {
      check_stop(link);
      const bool at_end = link == 0 || link == run.num_links - 1;
      const auto has = [&](const Affine& place) {
        return !at_end || run.has(place, link);
      };
      for (std::size_t i = 0; i < local.size(); ++i) {
        const Affine& unknown = run.unknowns[i];
        local[i] = has(unknown) ? x[unknown.at(link)] : 0.0;
      }
      for (std::size_t i = 0; i < values.size(); ++i) {
        const ChainMap::Entry& entry = run.entries[i];
        values[i] = has(entry.source)
                        ? values_[at(entry.array)][entry.source.at(link)]
                        : 0.0;
      }
      auto factor = products_[r].factors.begin();
      for (std::size_t i = 0; i < sums.size(); ++i) {
        long double sum = 0.0L;
        for (const auto end = products_[r].factors.begin() +
                              static_cast<std::ptrdiff_t>(ends[i]);
             factor != end; ++factor) {
          sum += static_cast<long double>(values[at(factor->value)]) *
                 local[at(factor->col)];
        }
        sums[i] = sum;
      }
      // visit(unknown, its sum)
      const auto each = [&](int begin, int end, auto&& visit) {
        for (int i = begin; i < end; ++i) {
          const Affine& unknown = run.unknowns[at(i)];
          if (has(unknown)) visit(unknown.at(link), sums[at(i)]);
        }
      };
      each(0, run.interior, [&](std::size_t i, long double sum) {
        residual[i] = static_cast<double>(residual[i] - sum);
      });
      auto before = separator.begin();
      each(run.interior, first_right, [&](std::size_t i, long double sum) {
        const long double so_far =
            before == separator.end() ? residual[i] : before++->value;
        residual[i] = static_cast<double>(so_far - sum);
      });
      separator.clear();
      each(first_right, first_border, [&](std::size_t i, long double sum) {
        separator.push_back({i, residual[i] - sum});
      });
      for (std::size_t k = 0; k < border.size(); ++k) {
        border[k] -= sums[at(first_border) + k];
      }
    }
  }
  for (const SoFar& one : separator) {
    residual[one.unknown] = static_cast<double>(one.value);
  }
  for (const ChainMap::Entry& entry : map_.border_entries()) {
    const long double value = values_[at(entry.array)][entry.source.at(0)];
    const auto x_of = [&](int k) { return x[at(map_.border()[at(k)])]; };
    border[at(entry.row)] -= value * x_of(entry.col);
    if (entry.row == entry.col) continue;
    border[at(entry.col)] -= value * x_of(entry.row);
  }
  for (std::size_t k = 0; k < border.size(); ++k) {
    residual[at(map_.border()[k])] = static_cast<double>(border[k]);
  }
}

nlp::ChainStructure chain_of(const nlp::Problem& problem,
                             const nlp::ActiveSet& active) {
  nlp::ChainStructure chain = problem.chain_structure();
  const std::size_t n = active.variables.size();
  for (std::size_t i = 0; i < chain.block.size(); ++i) {
    const bool present = i < n ? active.variables[i] == nlp::Held::No
                               : active.constraints[i - n] != nlp::Held::No;
    if (present) continue;
    chain.block[i] = nlp::ChainStructure::kAbsent;
    if (!chain.scale.empty()) chain.scale[i] = 1.0;
  }
  return chain;
}

std::unique_ptr<ChainLdlt> make_chain_ldlt(const nlp::Problem& problem,
                                           const nlp::ActiveSet& active) {
  const PhaseTimer timer(Phase::SetUp);
  nlp::ChainStructure chain = chain_of(problem, active);
  if (chain.empty()) return nullptr;
  const nlp::SparsityPattern& hess = problem.hess_lag_pattern();
  const nlp::SparsityPattern& jac = problem.jac_g_pattern();
  const std::array<EntryPositions, 2> positions = {
      EntryPositions{hess, 0}, EntryPositions{jac, problem.num_variables()}};
  return ChainLdlt::make(std::move(chain), positions);
}

}  // namespace brachisto
