// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Maps of chains whose patterns repeat, against those of the same entries one
// by one.

#include "solvers/chain_map.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "nlp/active_set.hpp"
#include "support/limited_problems.hpp"
#include "support/scenes.hpp"
#include "transcription/arc_length.hpp"
#include "transcription/rolling_time.hpp"

namespace brachisto::testing {
namespace {

using nlp::ChainStructure;
using nlp::SparsityPattern;

SparsityPattern one_by_one(const SparsityPattern& pattern) {
  SparsityPattern out;
  pattern.for_each([&](std::size_t, int row, int col) { out.add(row, col); });
  return out;
}

void expect_equal(const ChainMap::Affine& one, const ChainMap::Affine& other,
                  const std::string& what) {
  EXPECT_EQ(one.first, other.first) << what;
  EXPECT_EQ(one.stride, other.stride) << what;
  EXPECT_EQ(one.not_in_first, other.not_in_first) << what;
  EXPECT_EQ(one.not_in_last, other.not_in_last) << what;
}

void expect_equal(const std::vector<ChainMap::Entry>& some,
                  const std::vector<ChainMap::Entry>& others,
                  const std::string& what) {
  ASSERT_EQ(some.size(), others.size()) << what;
  for (std::size_t k = 0; k < some.size(); ++k) {
    EXPECT_EQ(some[k].row, others[k].row) << what;
    EXPECT_EQ(some[k].col, others[k].col) << what;
    EXPECT_EQ(some[k].array, others[k].array) << what;
    expect_equal(some[k].source, others[k].source, what);
  }
}

void expect_equal(const ChainMap& one, const ChainMap& other,
                  const std::string& what) {
  EXPECT_EQ(one.num_links(), other.num_links()) << what;
  EXPECT_EQ(one.num_unknowns(), other.num_unknowns()) << what;
  EXPECT_EQ(one.border(), other.border()) << what;
  expect_equal(one.border_entries(), other.border_entries(), what);
  ASSERT_EQ(one.runs().size(), other.runs().size()) << what;
  for (std::size_t i = 0; i < one.runs().size(); ++i) {
    const std::string of_run = what + ", run " + std::to_string(i);
    const ChainMap::Run& a = one.runs()[i];
    const ChainMap::Run& b = other.runs()[i];
    EXPECT_EQ(a.position, b.position) << of_run;
    EXPECT_EQ(a.links(), b.links()) << of_run;
    EXPECT_EQ(a.interior, b.interior) << of_run;
    EXPECT_EQ(a.left, b.left) << of_run;
    EXPECT_EQ(a.right, b.right) << of_run;
    ASSERT_EQ(a.unknowns.size(), b.unknowns.size()) << of_run;
    for (std::size_t k = 0; k < a.unknowns.size(); ++k) {
      expect_equal(a.unknowns[k], b.unknowns[k], of_run);
    }
    expect_equal(a.entries, b.entries, of_run);
  }
  ASSERT_EQ(one.couplings().size(), other.couplings().size()) << what;
  for (std::size_t k = 0; k < one.couplings().size(); ++k) {
    const auto& [unknown, absent, array, entry] = one.couplings()[k];
    EXPECT_EQ(unknown, other.couplings()[k].unknown) << what;
    EXPECT_EQ(absent, other.couplings()[k].absent) << what;
    EXPECT_EQ(array, other.couplings()[k].array) << what;
    EXPECT_EQ(entry, other.couplings()[k].entry) << what;
  }
}

/// The entries of one absent unknown, by looking at all of them.
std::size_t num_couplings(const nlp::Problem& problem,
                          const ChainStructure& chain) {
  const int n = problem.num_variables();
  const auto absent = [&](int unknown) {
    return chain.block[static_cast<std::size_t>(unknown)] ==
           ChainStructure::kAbsent;
  };
  std::size_t count = 0;
  problem.hess_lag_pattern().for_each([&](std::size_t, int row, int col) {
    count += absent(row) != absent(col) ? 1U : 0U;
  });
  problem.jac_g_pattern().for_each([&](std::size_t, int row, int col) {
    count += absent(n + row) != absent(col) ? 1U : 0U;
  });
  return count;
}

/// The chain without what is given.
ChainStructure present(const nlp::Problem& problem,
                       const nlp::ActiveSet& active) {
  ChainStructure chain = problem.chain_structure();
  const std::size_t n = active.variables.size();
  for (std::size_t i = 0; i < chain.block.size(); ++i) {
    const bool is_there = i < n ? active.variables[i] == nlp::Held::No
                                : active.constraints[i - n] != nlp::Held::No;
    if (!is_there) chain.block[i] = ChainStructure::kAbsent;
  }
  return chain;
}

void expect_repetitions_change_nothing(const nlp::Problem& problem,
                                       const nlp::ActiveSet& active,
                                       const std::string& what) {
  const ChainStructure chain = present(problem, active);
  const SparsityPattern& hess = problem.hess_lag_pattern();
  const SparsityPattern& jac = problem.jac_g_pattern();
  const SparsityPattern all_hess = one_by_one(hess);
  const SparsityPattern all_jac = one_by_one(jac);
  const int offset = problem.num_variables();
  const std::array<EntryPositions, 2> repeated = {EntryPositions{hess, 0},
                                                  EntryPositions{jac, offset}};
  const std::array<EntryPositions, 2> listed = {
      EntryPositions{all_hess, 0}, EntryPositions{all_jac, offset}};

  for (const int join_to : {1, 45}) {
    const auto one = ChainMap::make(chain, repeated, join_to);
    const auto other = ChainMap::make(chain, listed, join_to);

    ASSERT_TRUE(one && other) << what;
    expect_equal(*one, *other, what);
    EXPECT_EQ(one->couplings().size(), num_couplings(problem, chain)) << what;
  }
}

TEST(ChainMap, LinksThatLookAlikeAreOneRunWhereverTheyStand) {
  const Scene scene = off_centred_scene();
  const auto limits = limits_of_all_kinds(scene.body);
  const Mesh mesh = uniform_mesh(3, 40);
  const LimitedTime problem(scene, limits, mesh, LimitedEnds{},
                            held_in_turn(mesh, limits, 3));
  const nlp::ActiveSet active = nlp::equations_only(problem);
  const ChainStructure chain = present(problem, active);
  const std::array<EntryPositions, 2> positions = {
      EntryPositions{problem.hess_lag_pattern(), 0},
      EntryPositions{problem.jac_g_pattern(), problem.num_variables()}};

  const auto map = ChainMap::make(chain, positions, 1);

  ASSERT_TRUE(map);
  EXPECT_LT(map->runs().size(), map->along_chain().size());
  int links = 0;
  std::vector<int> seen(chain.block.size());
  for (const auto& [r, own] : map->along_chain()) {
    const ChainMap::Run& run = map->runs()[r];
    EXPECT_EQ(run.position + own.begin, links);
    for (int link = own.begin; link < own.end; ++link, ++links) {
      for (int i = 0; i < run.interior; ++i) {
        ++seen[run.unknowns[static_cast<std::size_t>(i)].at(link)];
      }
    }
  }
  EXPECT_EQ(links, map->num_links());
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const bool inside = chain.block[i] > 0 && chain.block[i] % 2 == 1;
    EXPECT_EQ(seen[i], inside ? 1 : 0) << i;
  }
}

TEST(ChainMap, OfElementsTakesRepetitionsForWhatTheyStandFor) {
  for (const Scene& scene : {bead_scene(), off_centred_scene()}) {
    for (int p = 1; p <= 8; ++p) {
      for (const int elements : {1, 2, 3, 4, 5, 30}) {
        const RollingTime problem(natural(scene), uniform_mesh(p, elements),
                                  0.2);
        expect_repetitions_change_nothing(
            problem, nlp::equations_only(problem),
            std::to_string(elements) + " of degree " + std::to_string(p));
      }
    }
  }
}

TEST(ChainMap, OfPiecesTakesRepetitionsForWhatTheyStandFor) {
  for (const Scene& scene : {uniform_scene(), off_centred_scene()}) {
    for (const int pieces : {1, 2, 3, 8, 9, 10, 100, 101}) {
      const ArcLength problem(scene, pieces, 0.2);
      expect_repetitions_change_nothing(problem, nlp::equations_only(problem),
                                        std::to_string(pieces));
    }
  }
}

TEST(ChainMap, OfLimitsTakesRepetitionsForWhatTheyStandFor) {
  const Scene scene = off_centred_scene();
  const auto limits = limits_of_all_kinds(scene.body);
  for (const int p : {1, 3}) {
    const Mesh mesh = uniform_mesh(p, 40);
    for (const bool in_turn : {false, true}) {
      std::optional<HeldLimits> held;
      if (in_turn) held = held_in_turn(mesh, limits, 3);
      const LimitedTime problem(scene, limits, mesh, LimitedEnds{}, held);
      expect_repetitions_change_nothing(
          problem, nlp::equations_only(problem),
          (in_turn ? "held, degree " : "free, degree ") + std::to_string(p));
    }
  }
}

}  // namespace
}  // namespace brachisto::testing
