// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The chain factorisation on matrices made for it, against dense
// factorisations and eigenvalues.

#include "solvers/chain_ldlt.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "solvers/chain_matrix.hpp"
#include "solvers/pivot_store.hpp"
#include "support/refined_solution.hpp"

namespace brachisto::testing {
namespace {

using Eigen::VectorXd;

// After refinement with residuals in long double, x is the exact solution of
// its last system rounded to double, and so b − A x is at most u ‖A‖ ‖x‖, u the
// unit roundoff, but for the error of the last correction, which is smaller
// than u by the rate of refinement. Twice u leaves room for that.
constexpr double kBackward = 2.0 * kRoundoff;
constexpr int kRefinements = 3;

// A random matrix of n unknowns has eigenvalues down to about 1/n; the
// reference itself, an eigenvalue solver, is exact to n u ‖A‖.
double reference_accuracy(const Eigen::MatrixXd& A) {
  const auto n = static_cast<double>(A.rows());
  return n * kRoundoff * A.cwiseAbs().rowwise().sum().maxCoeff();
}

void expect_solves(const ChainMatrix& matrix, ChainLdlt& ldlt,
                   const std::string& what) {
  Random random(99);
  const int n = matrix.size();
  const std::vector<double> b = random.vector(n, -1.0, 1.0);

  const std::vector<double> x = refined_solution(ldlt, b, kRefinements);

  const auto as_vector = [](const std::vector<double>& v) {
    return Eigen::Map<const VectorXd>(v.data(),
                                      static_cast<Eigen::Index>(v.size()));
  };
  EXPECT_LE(backward_error(matrix.dense, as_vector(x), as_vector(b)), kBackward)
      << what;
  // The forward error follows from it: condition times backward error of both.
  const Eigen::PartialPivLU<Eigen::MatrixXd> lu(matrix.dense);
  const VectorXd expected = lu.solve(as_vector(b));
  const double condition = 1.0 / lu.rcond();
  EXPECT_LE((as_vector(x) - expected).cwiseAbs().maxCoeff(),
            condition * 64.0 * n * kRoundoff * expected.cwiseAbs().maxCoeff())
      << what;
}

void expect_inertia(const ChainMatrix& matrix, const ChainLdlt& ldlt,
                    const std::string& what) {
  const double zero = reference_accuracy(matrix.dense);
  const Inertia expected = by_eigenvalues(matrix.dense, zero);
  EXPECT_TRUE(ldlt.inertia().known) << what;
  EXPECT_EQ(ldlt.inertia().positive, expected.positive) << what;
  EXPECT_EQ(ldlt.inertia().negative, expected.negative) << what;
  EXPECT_EQ(ldlt.inertia().zero, expected.zero) << what;
}

void expect_factorises(const ChainMatrix& matrix, const std::string& what) {
  const auto ldlt = matrix.analysed();
  ASSERT_NE(ldlt, nullptr) << what;
  ASSERT_TRUE(matrix.factorise(*ldlt)) << what;
  expect_inertia(matrix, *ldlt, what);
  expect_solves(matrix, *ldlt, what);
}

/// All entries the structure allows, random.
ChainMatrix random_chain(std::uint32_t seed, int links, int interior,
                         int separator, int border) {
  Random random(seed);
  ChainMatrix matrix = empty_chain(links, interior, separator, border);
  for_each_coupled(matrix, [&](int i, int j) {
    matrix.add(i, j, random.uniform(-1.0, 1.0));
  });
  return matrix;
}

struct Shape {
  int links, interior, separator, border;
};

constexpr Shape kShapes[] = {{1, 0, 3, 0},  {1, 4, 0, 0},   {1, 5, 2, 1},
                             {2, 60, 3, 0}, {3, 50, 4, 1},  {8, 50, 2, 1},
                             {9, 50, 3, 2}, {25, 48, 5, 1}, {40, 1, 3, 1},
                             {40, 3, 2, 3}, {7, 0, 4, 1}};

TEST(PivotStore, FindsTheLastPivotsOfALinkThatIsNearlyTheSame) {
  // Of a full link of 9 unknowns; five entries are too many to differ by.
  const auto without = [](int count) {
    LinkPattern pattern(9, 6);
    for (int i = 0; i < 9; ++i) {
      for (int j = 0; j <= i; ++j) {
        if (j > 0 || i == 0 || i > count) pattern.set(i, j);
      }
    }
    return pattern;
  };
  PivotStore store;
  const auto full = store.add({without(0), {}});
  const auto lacking = store.add({without(5), {}});

  EXPECT_EQ(without(0).num_different(without(5)), 5);
  EXPECT_EQ(store.find(without(0)), full);
  EXPECT_EQ(store.find(without(1)), nullptr);
  EXPECT_EQ(store.find_alike(without(0)), full);
  EXPECT_EQ(store.find_alike(without(3)), lacking);
  EXPECT_EQ(store.find_alike(LinkPattern(9, 6)), nullptr);
  EXPECT_EQ(store.find_alike(LinkPattern(9, 5)), nullptr);
  EXPECT_EQ(store.find_alike(LinkPattern(8, 6)), nullptr);
}

TEST(ChainLdlt, FactorisesLikeDenseMethods) {
  std::uint32_t seed = 1;
  for (const Shape& s : kShapes) {
    for (int repetition = 0; repetition < 3; ++repetition, ++seed) {
      expect_factorises(
          random_chain(seed, s.links, s.interior, s.separator, s.border),
          "seed " + std::to_string(seed));
    }
  }
}

TEST(ChainLdlt, FactorisesSaddlePoints) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    const Shape& s = kShapes[seed % std::size(kShapes)];
    if (s.interior < 2) continue;
    expect_factorises(
        random_saddle(seed, s.links, s.interior, s.separator, s.border),
        "seed " + std::to_string(seed));
  }
}

TEST(ChainLdlt, DelaysThePivotsOfSeparatorsThatHaveNone) {
  // Without entries of its own a separator has no pivot until its neighbour is
  // assembled.
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    ChainMatrix matrix = empty_chain(12, 0, 4, 1);
    for_each_coupled(matrix, [&](int i, int j) {
      const auto block = [&](int k) {
        return matrix.structure.block[static_cast<std::size_t>(k)];
      };
      if (block(i) == block(j) && block(i) >= 0 && block(i) < 20) return;
      matrix.add(i, j, random.uniform(-1.0, 1.0));
    });
    expect_factorises(matrix, "seed " + std::to_string(seed));
  }
}

constexpr int kUnknownsOfALink = 24;

/// Nine links, of which those blocks have an interior without entries.
ChainMatrix with_empty_interiors(std::uint32_t seed,
                                 const std::set<int>& empty) {
  Random random(seed);
  ChainMatrix matrix = empty_chain(9, kUnknownsOfALink, kUnknownsOfALink, 1);
  for_each_coupled(matrix, [&](int i, int j) {
    const int a = matrix.structure.block[static_cast<std::size_t>(i)];
    const int b = matrix.structure.block[static_cast<std::size_t>(j)];
    const double value = random.uniform(-1.0, 1.0);
    if (a != b || !empty.contains(a)) matrix.add(i, j, value);
  });
  return matrix;
}

TEST(ChainLdlt, HandsInteriorsThatAreSingularToTheSeparators) {
  // Some links have an interior without entries of its own, the others not.
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    const ChainMatrix matrix = with_empty_interiors(seed, {15, 17});
    const auto ldlt = matrix.analysed();
    ASSERT_TRUE(matrix.factorise(*ldlt));
    EXPECT_GE(ldlt->num_dense_links(), 2) << "seed " << seed;
    expect_inertia(matrix, *ldlt, "seed " + std::to_string(seed));
    expect_solves(matrix, *ldlt, "seed " + std::to_string(seed));
  }
}

TEST(ChainLdlt, TellsWhatDenseLinksTake) {
  const auto effort = [](const std::set<int>& empty) {
    const ChainMatrix matrix = with_empty_interiors(1, empty);
    const auto ldlt = matrix.analysed();
    EXPECT_TRUE(matrix.factorise(*ldlt));
    return ldlt->effort();
  };
  // An interior that goes to a dense front adds its unknowns n to it. Those
  // alone change Σ i², i ≤ n, of its entries, 500 of which are one unknown.
  constexpr double kAtLeast = kUnknownsOfALink * (kUnknownsOfALink + 1) *
                              (2 * kUnknownsOfALink + 1) / 6 / 500.0;
  const double none = effort({}), one = effort({15}), two = effort({15, 17});
  EXPECT_GT(none, with_empty_interiors(1, {}).dense.rows());
  EXPECT_GT(one, none + kAtLeast);
  EXPECT_GT(two, one + kAtLeast);
}

/// Four states to a block, coupled with those of blocks next to it, and as many
/// inequalities as wanted: a slack with its barrier's curvature, from far away
/// to held, and a multiplier that couples it with the states.
ChainMatrix with_inequalities(int count, int links) {
  constexpr int kStates = 4;
  Random random(5);
  const int of_block = kStates + 2 * count;
  ChainMatrix matrix = empty_chain(links, of_block, of_block, 1);
  for_each_coupled(matrix, [&](int i, int j) {
    const int a = i % of_block, b = j % of_block, first = i - a;
    const bool border = i + 1 == matrix.size();
    const bool slack = a >= kStates && a < kStates + count && !border;
    const double value = random.uniform(-1.0, 1.0);
    if ((border || a < kStates) && b < kStates) {
      matrix.add(i, j, i == j ? 20.0 + value : value);
    } else if (slack && i == j) {
      matrix.add(i, j, std::pow(10.0, 4.0 * std::cos(a)));
    } else if (a >= kStates + count && !border && j >= first) {
      if (b < kStates) matrix.add(i, j, value);
      if (b == a - count) matrix.add(i, j, -1.0);
    }
  });
  return matrix;
}

TEST(ChainLdlt, EliminatesManyInequalitiesAsTheSparseOnesTheyAre) {
  // Of links of 133, 373 and 613 unknowns, and separators of a third of them.
  for (const auto& [count, links] : {std::pair{20, 6}, {60, 6}, {100, 2}}) {
    const ChainMatrix matrix = with_inequalities(count, links);
    const std::string what = std::to_string(count);
    const auto ldlt = matrix.analysed();
    ASSERT_TRUE(matrix.factorise(*ldlt)) << what;
    EXPECT_EQ(ldlt->num_dense_links(), 0) << what;
    expect_inertia(matrix, *ldlt, what);
    expect_solves(matrix, *ldlt, what);
    // A slack or a multiplier changes no more than the columns of the four
    // states, its partner and the border in a front of n rows, when it is
    // eliminated; a dense front of k pivots changes k n² entries, which makes
    // some sixty times as many as there are unknowns. An unknown is worth 500.
    const int k = 4 + 2 * count, n = 2 * k + 1;
    const double dense = (links + 1.0) * k * n * n / 500.0;
    EXPECT_LT(ldlt->effort(), matrix.size() + 0.2 * dense) << what;
  }
}

TEST(ChainLdlt, LeavesFullLinksOfHundredsOfUnknownsToDenseFronts) {
  const ChainMatrix matrix = random_chain(7, 2, 320, 3, 1);
  const auto ldlt = matrix.analysed();
  ASSERT_TRUE(matrix.factorise(*ldlt));
  EXPECT_EQ(ldlt->num_dense_links(), 2);
  expect_inertia(matrix, *ldlt, "full");
  expect_solves(matrix, *ldlt, "full");
}

TEST(ChainLdlt, CopesWithTinyPivots) {
  // The diagonal carries next to nothing: pivots on it would magnify rounding
  // by up to 1e15.
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    ChainMatrix matrix = empty_chain(10, 48, 4, 1);
    for_each_coupled(matrix, [&](int i, int j) {
      const double size =
          i == j ? std::pow(10.0, random.uniform(-15, -6)) : 1.0;
      matrix.add(i, j, size * random.uniform(-1.0, 1.0));
    });
    expect_factorises(matrix, "seed " + std::to_string(seed));
  }
}

TEST(ChainLdlt, CountsZeroEigenvalues) {
  // Rows of the Jacobian that repeat others: in one interior, in a separator,
  // and across the last separator and the border.
  for (std::uint32_t seed = 1; seed <= 12; ++seed) {
    ChainMatrix matrix = random_saddle(seed, 6, 50, 4, 1);
    const int copies = 1 + static_cast<int>(seed % 3);
    const int stride = 54;
    std::vector<std::pair<int, int>> pairs = {
        {4 + 1, 4 + 3},
        {2 * stride + 1, 2 * stride + 3},
        {4 * stride + 4 + 7, 4 * stride + 4 + 9}};
    pairs.resize(static_cast<std::size_t>(copies));
    // Rebuilds the matrix with row and column `to` as those of `from`.
    ChainMatrix singular = empty_chain(6, 50, 4, 1);
    const auto source = [&](int i) {
      for (const auto& [from, to] : pairs) {
        if (i == to) return from;
      }
      return i;
    };
    for_each_coupled(matrix, [&](int i, int j) {
      const double value = matrix.dense(source(i), source(j));
      if (value != 0.0) singular.add(i, j, value);
    });
    const auto ldlt = singular.analysed();

    ASSERT_TRUE(singular.factorise(*ldlt)) << "seed " << seed;

    EXPECT_EQ(ldlt->inertia().zero, copies) << "seed " << seed;
    expect_inertia(singular, *ldlt, "seed " + std::to_string(seed));
  }
}

TEST(ChainLdlt, TakesEntriesInAnyOrderAndAddsRepeatedOnes) {
  for (std::uint32_t seed = 1; seed <= 5; ++seed) {
    ChainMatrix matrix = random_saddle(seed, 10, 48, 3, 1);
    Random random(seed);
    const std::size_t count = matrix.values.size();
    for (std::size_t e = 0; e < count; e += 7) {
      const double part = random.uniform(-1.0, 1.0);
      matrix.values[e] -= part;
      matrix.rows.push_back(matrix.cols[e]);
      matrix.cols.push_back(matrix.rows[e]);
      matrix.values.push_back(part);
    }
    for (std::size_t e = matrix.values.size(); e-- > 1;) {
      const auto other = static_cast<std::size_t>(
          random.uniform(0.0, static_cast<double>(e + 1)));
      std::swap(matrix.rows[e], matrix.rows[other]);
      std::swap(matrix.cols[e], matrix.cols[other]);
      std::swap(matrix.values[e], matrix.values[other]);
    }
    expect_factorises(matrix, "seed " + std::to_string(seed));
  }
}

/// Entries that are small whole numbers, link by link as a transcription lists
/// them: sums of products with whole numbers are exact in any order.
ChainMatrix whole_numbers(std::uint32_t seed, const Shape& s) {
  Random random(seed);
  ChainMatrix matrix = empty_chain(s.links, s.interior, s.separator, s.border);
  for_each_coupled(matrix, [&](int i, int j) {
    matrix.add(i, j, std::round(random.uniform(-9.0, 9.0)));
  });
  return matrix;
}

/// Splits every 5th entry, the part on the other side of the diagonal, then
/// brings all into random order. The dense matrix stays.
void split_and_shuffle(ChainMatrix& matrix, Random& random) {
  const std::size_t count = matrix.values.size();
  for (std::size_t e = 0; e < count; e += 5) {
    const double part = std::round(random.uniform(-9.0, 9.0));
    matrix.values[e] -= part;
    matrix.rows.push_back(matrix.cols[e]);
    matrix.cols.push_back(matrix.rows[e]);
    matrix.values.push_back(part);
  }
  for (std::size_t e = matrix.values.size(); e-- > 1;) {
    const auto other = static_cast<std::size_t>(
        random.uniform(0.0, static_cast<double>(e + 1)));
    std::swap(matrix.rows[e], matrix.rows[other]);
    std::swap(matrix.cols[e], matrix.cols[other]);
    std::swap(matrix.values[e], matrix.values[other]);
  }
}

/// residual − A x of the dense matrix and of the chain, all whole numbers.
void expect_product(const ChainMatrix& matrix, const ChainLdlt& ldlt,
                    const std::string& what) {
  Random random(98);
  const int n = matrix.size();
  std::vector<double> x(static_cast<std::size_t>(n));
  for (double& value : x) value = std::round(random.uniform(-99.0, 99.0));
  constexpr double kBefore = 17.0;
  std::vector<double> residual(x.size(), kBefore);

  ldlt.subtract_product(x, residual);

  for (int i = 0; i < n; ++i) {
    double expected = kBefore;
    for (int j = 0; j < n; ++j) {
      expected -= matrix.dense(i, j) * x[static_cast<std::size_t>(j)];
    }
    ASSERT_EQ(residual[static_cast<std::size_t>(i)], expected)
        << what << ", row " << i;
  }
}

TEST(ChainLdlt, CountsEachEntryOnceInAnyOrder) {
  std::uint32_t seed = 1;
  for (const Shape& s : kShapes) {
    ++seed;
    const std::string what = "seed " + std::to_string(seed);
    const ChainMatrix ordered = whole_numbers(seed, s);
    ChainMatrix shuffled = ordered;
    Random random(seed);
    split_and_shuffle(shuffled, random);
    const auto by_order = ordered.analysed();
    const auto by_sorting = shuffled.analysed();
    ASSERT_TRUE(by_order && by_sorting) << what;
    ASSERT_TRUE(ordered.factorise(*by_order)) << what;
    ASSERT_TRUE(shuffled.factorise(*by_sorting)) << what;

    expect_product(ordered, *by_order, what + ", ordered");
    expect_product(shuffled, *by_sorting, what + ", shuffled");
    expect_inertia(ordered, *by_order, what + ", ordered");
    expect_inertia(shuffled, *by_sorting, what + ", shuffled");
  }
}

TEST(ChainLdlt, TakesOrderedAndShuffledArraysTogether) {
  // As of a KKT matrix: the entries of one array with an offset of rows, those
  // of the border alone among them.
  constexpr int kOffset = 11;
  for (const bool shuffle : {false, true}) {
    const ChainMatrix whole = whole_numbers(5, {9, 20, 3, 2});
    ChainMatrix first = whole;
    ChainMatrix second = whole;
    for (ChainMatrix* part : {&first, &second}) {
      part->rows.clear();
      part->cols.clear();
      part->values.clear();
    }
    for (std::size_t e = 0; e < whole.values.size(); ++e) {
      // Offset rows must not be negative.
      const bool to_second = e % 3 == 0 && whole.rows[e] >= kOffset;
      ChainMatrix& part = to_second ? second : first;
      part.rows.push_back(whole.rows[e]);
      part.cols.push_back(whole.cols[e]);
      part.values.push_back(whole.values[e]);
    }
    if (shuffle) {
      // Without changing sides, for only rows are offset.
      std::vector<std::size_t> order(second.values.size());
      std::iota(order.rbegin(), order.rend(), std::size_t{0});
      const ChainMatrix before = second;
      for (std::size_t e = 0; e < order.size(); ++e) {
        second.rows[e] = before.rows[order[e]];
        second.cols[e] = before.cols[order[e]];
        second.values[e] = before.values[order[e]];
      }
    }
    for (int& row : second.rows) row -= kOffset;
    const nlp::SparsityPattern one = first.positions();
    const nlp::SparsityPattern other = second.positions();
    const std::array<EntryPositions, 2> positions = {
        EntryPositions{one, 0}, EntryPositions{other, kOffset}};
    const auto ldlt = ChainLdlt::make(whole.structure, positions);
    ASSERT_NE(ldlt, nullptr);
    const std::array<std::span<const double>, 2> values = {first.values,
                                                           second.values};
    ASSERT_TRUE(ldlt->factorise(values));
    const std::string what = shuffle ? "shuffled" : "ordered";

    expect_product(whole, *ldlt, what);
    expect_inertia(whole, *ldlt, what);
  }
}

TEST(ChainLdlt, ForgetsTheMatrixBefore) {
  // Zeros come and go between factorisations, and so does regularity.
  ChainMatrix matrix = random_saddle(3, 20, 50, 4, 1, 0.5);
  const auto ldlt = matrix.analysed();
  const std::vector<double> values = matrix.values;
  for (const double delta : {0.5, 0.0, 1e-9, 0.0, 0.5}) {
    for (std::size_t e = 0; e < values.size(); ++e) {
      const bool regularised = values[e] == -0.5;
      if (!regularised) continue;
      matrix.values[e] = -delta;
      matrix.dense(matrix.rows[e], matrix.rows[e]) = -delta;
    }
    ASSERT_TRUE(matrix.factorise(*ldlt));
    expect_inertia(matrix, *ldlt, "δ = " + std::to_string(delta));
    expect_solves(matrix, *ldlt, "δ = " + std::to_string(delta));
  }
}

TEST(ChainLdlt, NoticesEntriesThatAreZeroInTheSampleOnly) {
  // The link on which the pivots are chosen lacks entries the others have.
  ChainMatrix matrix = random_chain(5, 31, 48, 3, 1);
  for (std::size_t e = 0; e < matrix.values.size(); ++e) {
    const int i = matrix.rows[e];
    const int j = matrix.cols[e];
    const int block = matrix.structure.block[static_cast<std::size_t>(j)];
    if (block != 31 || (i + j) % 3 != 0) continue;
    matrix.values[e] = 0.0;
    matrix.dense(i, j) = matrix.dense(j, i) = 0.0;
  }
  expect_factorises(matrix, "sparse sample");
}

TEST(ChainLdlt, TakesThePivotsOfAMatrixThatDiffersByChanceZeros) {
  // In a scope the second matrix, of which one entry of the link in the middle
  // vanishes, takes the pivots of the first; the third, which lacks the
  // diagonal there, finds its own.
  constexpr int kMiddle = 7;  // of the blocks
  const ChainScope scope;
  ChainMatrix matrix = random_chain(7, 7, 48, 3, 1);
  expect_factorises(matrix, "all entries");
  const auto vanish = [&](int first, int count) {
    for (std::size_t e = 0; e < matrix.values.size(); ++e) {
      const int i = matrix.rows[e];
      const int j = matrix.cols[e];
      const int block = matrix.structure.block[static_cast<std::size_t>(j)];
      if (block != kMiddle || i < j + first || i >= j + first + count) continue;
      matrix.values[e] = 0.0;
      matrix.dense(i, j) = matrix.dense(j, i) = 0.0;
      if (count == 1) return;
    }
  };
  vanish(1, 1);
  expect_factorises(matrix, "one entry vanishes");
  vanish(0, 3);
  expect_factorises(matrix, "the diagonal and what is beside it vanish");
}

TEST(ChainLdlt, TakesOtherPivotsNextToABound) {
  // In each interior slacks s, multipliers y of their inequalities, and
  // variables q: next to a bound [1 −ε; −ε 0] in s and y asks for s alone, then
  // y with q, far from it [ε −1; −1 0] for s with y.
  constexpr int kLinks = 100, kTriples = 16, kSeparator = 3;
  constexpr double kEpsilon = 1e-6;
  Random random(11);
  ChainMatrix matrix = empty_chain(kLinks, 3 * kTriples, kSeparator, 1);
  const int per_link = kSeparator + 3 * kTriples;
  for (int link = 0; link < kLinks; ++link) {
    const bool next_to_bound = link % 50 < 25;
    for (int i = 0; i < kTriples; ++i) {
      const int s = link * per_link + kSeparator + 3 * i;
      matrix.add(s, s, next_to_bound ? 1.0 : kEpsilon);
      matrix.add(s + 1, s, next_to_bound ? -kEpsilon : -1.0);
      matrix.add(s + 2, s + 1, 1.0);
      matrix.add(s + 2, s + 2, random.uniform(0.5, 1.0));
      for (int k = 0; k < kSeparator; ++k) {
        matrix.add(s + 2, link * per_link + k, random.uniform(-0.1, 0.1));
      }
    }
  }
  for (int link = 0; link <= kLinks; ++link) {
    for (int k = 0; k < kSeparator; ++k) {
      matrix.add(link * per_link + k, link * per_link + k, 5.0);
    }
  }
  matrix.add(matrix.size() - 1, matrix.size() - 1, 1.0);
  const auto ldlt = matrix.analysed();

  ASSERT_TRUE(matrix.factorise(*ldlt));

  // By one sequence for all half of them would be dense.
  EXPECT_LE(ldlt->num_dense_links(), kLinks / 10);
  Random of_b(12);
  const std::vector<double> b = of_b.vector(matrix.size(), -1.0, 1.0);
  const std::vector<double> x = refined_solution(*ldlt, b, kRefinements);
  EXPECT_LE(backward_error(matrix.dense,
                           Eigen::Map<const VectorXd>(x.data(), matrix.size()),
                           Eigen::Map<const VectorXd>(b.data(), matrix.size())),
            kBackward);
  // Of each triple [s y; y q] one pivot is negative, next to a bound y's in
  // [·1; 1 q], else that of s with y; separators and border are positive.
  EXPECT_EQ(ldlt->inertia().negative, kLinks * kTriples);
  EXPECT_EQ(ldlt->inertia().zero, 0);
}

TEST(ChainLdlt, LeavesAbsentUnknownsAlone) {
  ChainMatrix matrix = random_chain(7, 10, 48, 3, 1);
  constexpr double kUntouched = 17.0;
  std::vector<int> present;
  for (int i = 0; i < matrix.size(); ++i) {
    if (i % 11 == 3) {
      matrix.structure.block[static_cast<std::size_t>(i)] =
          nlp::ChainStructure::kAbsent;
    } else {
      present.push_back(i);
    }
  }
  const auto ldlt = matrix.analysed();
  ASSERT_TRUE(matrix.factorise(*ldlt));
  const Eigen::MatrixXd reduced = matrix.dense(present, present);
  VectorXd x = VectorXd::Constant(matrix.size(), kUntouched);
  const VectorXd b =
      VectorXd::LinSpaced(static_cast<Eigen::Index>(present.size()), -1.0, 1.0);
  Eigen::Index next = 0;
  for (const int i : present) x(i) = b(next++);

  ldlt->solve({x.data(), static_cast<std::size_t>(x.size())});

  const Inertia expected = by_eigenvalues(reduced, reference_accuracy(reduced));
  EXPECT_EQ(ldlt->inertia().negative, expected.negative);
  EXPECT_EQ(ldlt->inertia().positive, expected.positive);
  for (int i = 3; i < matrix.size(); i += 11) EXPECT_EQ(x(i), kUntouched);
  // Unrefined: the growth of multipliers, at most 10³ in a link, squared, is
  // the worst that may happen; in practice it is far from it.
  VectorXd found(b.size());
  next = 0;
  for (const int i : present) found(next++) = x(i);
  EXPECT_LE(backward_error(reduced, found, b), 1e6 * kRoundoff);
}

TEST(ChainLdlt, RefusesWhatIsNoChain) {
  ChainMatrix matrix = random_chain(1, 6, 50, 3, 1);
  matrix.add(matrix.size() - 3, 0, 1.0);

  EXPECT_EQ(matrix.analysed(), nullptr);
}

TEST(ChainLdlt, RefusesEntriesBetweenLinksThatAreNoNeighbours) {
  // Blocks of a chain of 6 links: separators 0, 2, … 12, interiors 1, 3, … 11.
  // Links of fewer unknowns would be joined first.
  struct Pair {
    int one, other;
  };
  constexpr Pair kTooFar[] = {{0, 3}, {0, 4},  {1, 3},  {1, 4},
                              {2, 5}, {0, 12}, {9, 12}, {3, 6}};
  for (const bool shuffle : {false, true}) {
    for (const Pair& pair : kTooFar) {
      ChainMatrix matrix = whole_numbers(1, {6, 50, 3, 1});
      Random random(7);
      if (shuffle) split_and_shuffle(matrix, random);
      const auto first_of = [&](int block) {
        const auto& blocks = matrix.structure.block;
        return static_cast<int>(std::ranges::find(blocks, block) -
                                blocks.begin());
      };
      ASSERT_NE(matrix.analysed(), nullptr);
      const int one = first_of(pair.one);
      const int other = first_of(pair.other);
      for (const bool transposed : {false, true}) {
        // At the end, and where it belongs among the columns.
        for (const bool at_end : {false, true}) {
          ChainMatrix wrong = matrix;
          const std::ptrdiff_t place =
              at_end ? static_cast<std::ptrdiff_t>(wrong.rows.size())
                     : std::ranges::find(wrong.cols, std::min(one, other)) -
                           wrong.cols.begin();
          wrong.rows.insert(wrong.rows.begin() + place,
                            transposed ? one : other);
          wrong.cols.insert(wrong.cols.begin() + place,
                            transposed ? other : one);
          wrong.values.insert(wrong.values.begin() + place, 1.0);

          EXPECT_EQ(wrong.analysed(), nullptr)
              << "blocks " << pair.one << " and " << pair.other
              << (shuffle ? ", shuffled" : ", ordered");
        }
      }
    }
  }
}

TEST(ChainLdlt, ReportsValuesThatAreNotFinite) {
  ChainMatrix matrix = random_chain(1, 12, 48, 3, 1);
  const auto ldlt = matrix.analysed();
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity()}) {
    for (std::size_t e = 0; e < matrix.values.size(); e += 997) {
      const double good = std::exchange(matrix.values[e], bad);
      EXPECT_FALSE(matrix.factorise(*ldlt)) << "entry " << e;
      EXPECT_FALSE(ldlt->inertia().known);
      matrix.values[e] = good;
    }
  }
  ASSERT_TRUE(matrix.factorise(*ldlt));
  expect_inertia(matrix, *ldlt, "after the bad ones");
}

TEST(ChainLdlt, OfAZeroMatrixCountsZeros) {
  ChainMatrix matrix = random_chain(1, 5, 48, 3, 1);
  std::fill(matrix.values.begin(), matrix.values.end(), 0.0);
  const auto ldlt = matrix.analysed();

  ASSERT_TRUE(matrix.factorise(*ldlt));

  EXPECT_EQ(ldlt->inertia().zero, matrix.size());
  EXPECT_EQ(ldlt->inertia().positive, 0);
}

}  // namespace
}  // namespace brachisto::testing
