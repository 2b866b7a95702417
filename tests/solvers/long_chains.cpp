// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Chains so long that their links are joined, in matrices of known inertia.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "brachisto/math/index.hpp"
#include "solvers/chain_ldlt.hpp"
#include "solvers/chain_matrix.hpp"
#include "solvers/pivot_store.hpp"
#include "support/random_points.hpp"
#include "support/refined_solution.hpp"

namespace brachisto::testing {
namespace {

constexpr int kInterior = 44;
constexpr int kSeparator = 3;
constexpr int kPerLink = kInterior + kSeparator;

/// A = Σ s_k b_k b_kᵀ, each b_k within a link or the border, as many as there
/// are unknowns: if they are independent, A has as many positive eigenvalues as
/// there are positive s_k (Sylvester).
struct LongChain : ChainEntries {
  int positive = 0;

  [[nodiscard]] std::unique_ptr<ChainLdlt> analysed(int threads) const {
    const ChainScope scope(threads);
    return ChainEntries::analysed();
  }
};

/// All links alike but for `variation`, and every `other`th one with next to
/// nothing on its diagonal, so that it needs pivots of its own. The rows of the
/// b_k are an orthogonal matrix and less than half of it, by the sum of the
/// sizes, so that they are independent, and A far from singular.
LongChain long_chain(int links, double variation, int other) {
  LongChain chain;
  chain.structure.num_links = links;
  const int last = links * kPerLink + kSeparator;
  for (int i = 0; i < last; ++i) {
    const int place = i % kPerLink;
    chain.structure.block.push_back(2 * (i / kPerLink) +
                                    (place < kSeparator ? 0 : 1));
  }
  chain.structure.block.push_back(nlp::ChainStructure::kBorder);
  constexpr int kInLink = kPerLink + kSeparator + 1;
  Random random(17);
  // Those of a link; of the last one also those of the right separator and the
  // border.
  using Vectors = std::array<std::vector<double>, kInLink>;
  const auto vectors = [&] {
    Vectors out;
    for (auto& one : out) {
      one = random.vector(kInLink, -0.5 / kInLink, 0.5 / kInLink);
    }
    return out;
  };
  const Vectors common = vectors();
  for (int link = 0; link < links; ++link) {
    Vectors b = vectors();
    for (int k = 0; k < kInLink; ++k) {
      for (int i = 0; i < kInLink; ++i) {
        b[at(k)][at(i)] = (1.0 - variation) * common[at(k)][at(i)] +
                          variation * b[at(k)][at(i)];
      }
      const bool turned = link % other == other - 1;
      const int partner = k % 2 == 0 ? k + 1 : k - 1;
      if (turned && std::max(k, partner) < kPerLink) {
        b[at(k)][at(k)] += k % 2 == 0 ? std::sqrt(0.5) : -std::sqrt(0.5);
        b[at(k)][at(partner)] += std::sqrt(0.5);
      } else {
        b[at(k)][at(k)] += 1.0;
      }
    }
    const int count = link + 1 < links ? kPerLink : kInLink;
    const auto sign = [](int k) { return k % 2 == 0 ? 1.0 : -1.0; };
    for (int k = 0; k < count; ++k) {
      if (sign(k) > 0.0) ++chain.positive;
    }
    const auto unknown = [&](int local) {
      return local + 1 < kInLink ? link * kPerLink + local : last;
    };
    for (int j = 0; j < kInLink; ++j) {
      for (int i = j; i < kInLink; ++i) {
        double sum = 0.0;
        for (int k = 0; k < count; ++k) {
          sum += sign(k) * b[at(k)][at(i)] * b[at(k)][at(j)];
        }
        chain.add(unknown(i), unknown(j), sum);
      }
    }
  }
  return chain;
}

/// b − A x relative to ‖A‖ ‖x‖, by the entries themselves.
double backward_error_of(const LongChain& chain, const std::vector<double>& b,
                         const std::vector<double>& x) {
  std::vector<long double> residual(b.begin(), b.end());
  std::vector<double> row_sums(b.size(), 0.0);
  for (std::size_t e = 0; e < chain.values.size(); ++e) {
    const std::size_t i = at(chain.rows[e]);
    const std::size_t j = at(chain.cols[e]);
    const long double value = chain.values[e];
    residual[i] -= value * x[j];
    row_sums[i] += std::abs(chain.values[e]);
    if (i == j) continue;
    residual[j] -= value * x[i];
    row_sums[j] += std::abs(chain.values[e]);
  }
  double worst = 0.0;
  double largest = 0.0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    worst = std::max(worst, std::abs(static_cast<double>(residual[i])));
    largest = std::max(largest, std::abs(x[i]));
  }
  return worst / (*std::ranges::max_element(row_sums) * largest);
}

struct Kind {
  int links;
  double variation;
  int other;
};
// Two and three sections of 512 links with and without a rest, links that are
// all alike, and links that are all strangers to each other.
constexpr Kind kKinds[] = {{1024, 0.01, 2000}, {1100, 0.1, 37}, {1536, 0.3, 5},
                           {600, 1.0, 1},      {511, 0.1, 37},  {512, 0.1, 37}};

TEST(LongChains, HaveTheInertiaTheyWereMadeWith) {
  for (const Kind& kind : kKinds) {
    const LongChain chain = long_chain(kind.links, kind.variation, kind.other);
    const auto ldlt = chain.analysed(1);
    ASSERT_NE(ldlt, nullptr);

    // The second time with the pivots of the first.
    for (int time = 0; time < 2; ++time) {
      ASSERT_TRUE(chain.factorise(*ldlt));

      const std::string what = std::to_string(kind.links) + " links";
      EXPECT_EQ(ldlt->inertia().positive, chain.positive) << what;
      EXPECT_EQ(ldlt->inertia().zero, 0) << what;
      EXPECT_EQ(ldlt->inertia().negative, chain.size() - chain.positive)
          << what;
    }
  }
}

// As on a fine mesh with what was chosen on a coarse one.
TEST(LongChains, AreJoinedWherePivotsKeptFromOthersSuitNoLink) {
  const ChainScope scope;
  const LongChain before = long_chain(20, 1e-6, 2000);
  const LongChain chain = long_chain(1026, 1e-6, 1);
  const auto other = before.ChainEntries::analysed();
  ASSERT_TRUE(before.factorise(*other));
  const auto ldlt = chain.ChainEntries::analysed();

  ASSERT_TRUE(chain.factorise(*ldlt));

  // Of each section of 512 links eight, which its lanes are joined to; the
  // links at the ends differ from the others.
  EXPECT_EQ(ldlt->num_swept(), 2 * 8 + 2);
  EXPECT_EQ(ldlt->inertia().positive, chain.positive);
  EXPECT_EQ(ldlt->inertia().negative, chain.size() - chain.positive);
}

TEST(LongChains, AreSolvedToRounding) {
  for (const Kind& kind : kKinds) {
    const LongChain chain = long_chain(kind.links, kind.variation, kind.other);
    const auto ldlt = chain.analysed(1);
    ASSERT_TRUE(chain.factorise(*ldlt));
    Random random(5);
    const std::vector<double> b = random.vector(chain.size(), -1.0, 1.0);

    const std::vector<double> x = refined_solution(*ldlt, b, 3);

    // As for short chains: the rounding of x, and as much again.
    EXPECT_LE(backward_error_of(chain, b, x), 2.0 * kRoundoff)
        << kind.links << " links";
  }
}

TEST(LongChains, GiveTheSameDigitsForAnyNumberOfThreads) {
  for (const Kind& kind : kKinds) {
    const LongChain chain = long_chain(kind.links, kind.variation, kind.other);
    Random random(6);
    const std::vector<double> b = random.vector(chain.size(), -1.0, 1.0);
    std::vector<std::vector<double>> x;
    for (const int threads : {1, 2, 3, 7}) {
      const auto ldlt = chain.analysed(threads);
      ASSERT_TRUE(chain.factorise(*ldlt));
      ASSERT_TRUE(chain.factorise(*ldlt));
      x.push_back(b);
      ldlt->solve(x.back());
    }

    for (const std::vector<double>& one : x) {
      EXPECT_EQ(one, x.front()) << kind.links << " links";
    }
  }
}

TEST(LongChains, AreFactorisedAsIfTheyWereTheFirstOnceTheyForget) {
  const LongChain before = long_chain(600, 0.1, 37);
  const LongChain chain = long_chain(600, 1.0, 1);
  Random random(7);
  const std::vector<double> b = random.vector(chain.size(), -1.0, 1.0);
  const auto solved = [&](ChainLdlt& ldlt) {
    EXPECT_TRUE(chain.factorise(ldlt));
    std::vector<double> x = b;
    ldlt.solve(x);
    return x;
  };
  const auto first = chain.analysed(1);
  const auto later = before.analysed(1);
  ASSERT_TRUE(before.factorise(*later));

  const std::vector<double> x = solved(*first);
  // With pivots of the other one the rounding is another.
  EXPECT_NE(solved(*later), x);
  later->forget_pivots();
  EXPECT_EQ(solved(*later), x);
}

TEST(LongChains, ReportValuesThatAreNotFinite) {
  LongChain chain = long_chain(1100, 0.1, 37);
  for (const int threads : {1, 2}) {
    const auto ldlt = chain.analysed(threads);
    for (const std::size_t e : {std::size_t{7}, chain.values.size() / 2}) {
      const double good = std::exchange(chain.values[e], std::nan(""));
      EXPECT_FALSE(chain.factorise(*ldlt));
      chain.values[e] = good;
    }
    ASSERT_TRUE(chain.factorise(*ldlt));
    EXPECT_EQ(ldlt->inertia().positive, chain.positive);
  }
}

}  // namespace
}  // namespace brachisto::testing
