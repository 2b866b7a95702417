// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Limits and clocks of a solve.

#pragma once

#include <functional>
#include <string>

#include "brachisto/math/clock.hpp"
#include "math/cpu_clock.hpp"
#include "study/pose.hpp"

namespace brachisto {

/// Thrown by work that time ended when it had a verified answer and sought a
/// better one.
struct AnswerStands {};

/// Does the work that fills a solution, with the limits in force, and times it.
/// If they were met, or memory ran out, the solution says so and has no answer,
/// but what was recorded of its search; unless the work throws AnswerStands.
[[nodiscard]] Solution within_limits(
    const PosedProblem& posed, const std::function<void(Solution&)>& work);

/// "the limit of 5 s was reached (solver.limits.seconds)".
[[nodiscard]] std::string time_limit_reached(double seconds);

/// Adds the time for which it lives to that of the certificate.
class CertificateTimer {
 public:
  /// \param effort  must outlive it
  explicit CertificateTimer(Effort& effort) : effort_(effort) {}
  ~CertificateTimer() {
    effort_.certificate_seconds +=
        std::chrono::duration<double>(StopCondition::Clock::now() - begin_)
            .count();
    effort_.certificate_cpu_seconds += process_cpu_seconds() - cpu_begin_;
  }
  CertificateTimer(const CertificateTimer&) = delete;
  CertificateTimer& operator=(const CertificateTimer&) = delete;

 private:
  Effort& effort_;
  StopCondition::Clock::time_point begin_ = StopCondition::Clock::now();
  double cpu_begin_ = process_cpu_seconds();
  PhaseTimer phase_{Phase::Certificate};
};

}  // namespace brachisto
