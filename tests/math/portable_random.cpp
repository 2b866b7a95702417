// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "math/portable_random.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace brachisto {
namespace {

TEST(PortableRandom, PartsAreThePublishedOnes) {
  // First outputs of splitmix64 from state 0; FNV-1a of the empty text and of
  // "foobar".
  SplitMix64 random(0);
  EXPECT_EQ(random.next(), 0xE220A8397B1DCDAFU);
  EXPECT_EQ(random.next(), 0x6E789E6AA1B965F4U);
  EXPECT_EQ(hash_of(""), 0xCBF29CE484222325U);
  EXPECT_EQ(hash_of("foobar"), 0x85944171F73967E8U);
}

TEST(PortableRandom, DrawsStayAsTheyAre) {
  // Computed with Python's integers from the description of RandomStream.
  EXPECT_EQ(RandomStream(7, "scene.body.eta_m").draw(0), 3226143477112213.0);
  EXPECT_EQ(RandomStream(7, "scene.body.eta_m").draw(1), 1230790487806156.0);
  EXPECT_EQ(RandomStream(7, "scene.body.eta_m").draw(99), 4476607565206361.0);
  EXPECT_EQ(RandomStream(7, "scene.body.theta_m").draw(0), 7742312041239991.0);
  EXPECT_EQ(RandomStream(0, "scene.body.eta_m").draw(0), 8952756466682675.0);
  EXPECT_EQ(RandomStream(2147483647, "scene.finish.L").draw(9'999'999),
            3182402136953495.0);
}

TEST(PortableRandom, DrawsAreUniform) {
  constexpr int kDraws = 100'000;
  const RandomStream stream(1, "scene.body.k");
  double sum = 0.0;
  double sum_of_squares = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const double u =
        stream.draw(static_cast<std::uint64_t>(i)) / RandomStream::kWhole;
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    sum += u;
    sum_of_squares += u * u;
  }

  // Mean and second moment of a uniform number, within 5 standard deviations,
  // which are √(1/12) and √(4/45) over √draws.
  const double root = std::sqrt(double{kDraws});
  EXPECT_NEAR(sum / kDraws, 1.0 / 2.0, 5 * std::sqrt(1.0 / 12.0) / root);
  EXPECT_NEAR(sum_of_squares / kDraws, 1.0 / 3.0,
              5 * std::sqrt(4.0 / 45.0) / root);
}

TEST(PortableRandom, StreamsAreIndependent) {
  constexpr int kDraws = 100'000;
  const RandomStream one(1, "scene.body.k");
  for (const RandomStream& other :
       {RandomStream(2, "scene.body.k"), RandomStream(1, "scene.body.eta_m")}) {
    double covariance = 0.0;
    for (std::uint64_t i = 0; i < kDraws; ++i) {
      covariance += (one.draw(i) / RandomStream::kWhole - 0.5) *
                    (other.draw(i) / RandomStream::kWhole - 0.5) / kDraws;
    }
    // The product has the standard deviation 1/12.
    EXPECT_LT(std::abs(covariance), 5.0 / 12.0 / std::sqrt(double{kDraws}));
  }
}

}  // namespace
}  // namespace brachisto
