// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What of a solve's time goes into checking its answer.

#pragma once

#include "brachisto/math/phase_clock.hpp"
#include "brachisto/math/stop_condition.hpp"
#include "brachisto/study/solve.hpp"
#include "math/cpu_clock.hpp"

namespace brachisto {

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
