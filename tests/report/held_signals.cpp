// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/in_full.hpp"

#include <gtest/gtest.h>

#include <csignal>

namespace brachisto::report {
namespace {

volatile std::sig_atomic_t caught = 0;

extern "C" void note(int signal) {
  caught = signal;
}

class HeldSignalsTest : public ::testing::TestWithParam<int> {
 protected:
  HeldSignalsTest() : before_(std::signal(GetParam(), note)) { caught = 0; }
  ~HeldSignalsTest() override { std::signal(GetParam(), before_); }

 private:
  void (*before_)(int);
};

INSTANTIATE_TEST_SUITE_P(Kinds, HeldSignalsTest,
                         ::testing::Values(SIGINT, SIGTERM, SIGHUP, SIGQUIT));

TEST_P(HeldSignalsTest, ComeAfterwards) {
  {
    const HeldSignals held;
    std::raise(GetParam());
    EXPECT_EQ(caught, 0);
  }
  EXPECT_EQ(caught, GetParam());
}

TEST_P(HeldSignalsTest, StayAwayIfNoneCame) {
  { const HeldSignals held; }
  EXPECT_EQ(caught, 0);
}

TEST_P(HeldSignalsTest, StayIgnored) {
  std::signal(GetParam(), SIG_IGN);
  {
    const HeldSignals held;
    std::raise(GetParam());
  }
  EXPECT_EQ(std::signal(GetParam(), note), SIG_IGN);
  EXPECT_EQ(caught, 0);
}

TEST(HeldSignals, EndTheProcessAfterwards) {
  EXPECT_EXIT(
      {
        const HeldSignals held;
        std::raise(SIGTERM);
        std::fputs("the last word", stderr);
      },
      ::testing::KilledBySignal(SIGTERM), "the last word");
}

}  // namespace
}  // namespace brachisto::report
