// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What a campaign keeps of one scene.

#pragma once

#include <limits>
#include <string>

#include "brachisto/model/scene.hpp"
#include "support/text.hpp"
#include "support/witness.hpp"

namespace brachisto::benchmarks {

/// How solve() and its witness, the indirect method, stand to each other.
enum class Verdict {
  Agrees,      ///< verified, and the witness found the same path
  Disagrees,   ///< verified, and the witness found another
  NoWitness,   ///< verified, but the witness found nothing
  Unverified,  ///< solved, but a check of the certificate failed
  NotSolved,
  NoCycloid,  ///< no uniform cylinder has a path, so there is no branch
  Lost,       ///< the process crashed or hung
};
[[nodiscard]] std::string_view word(Verdict verdict);

/// Largest differences that still count as agreement. At element ends the path
/// has the order 2p of T, between them p + 1 only: what makes 1e-10 of the
/// former makes 1e-10^(7/12) ≈ 1e-6 of the latter for degree 6.
inline constexpr double kSameTau = 1e-10;   // relative, as asked for by default
inline constexpr double kSameNodes = 1e-7;  // of max(L, H)
inline constexpr double kSamePath = 1e-5;   // of max(L, H), all along

struct Record {
  Verdict verdict = Verdict::Lost;
  Status status = Status::InternalError;
  bool verified = false, feasible = false;
  double tau = std::numeric_limits<double>::quiet_NaN();
  double estimated_error = std::numeric_limits<double>::quiet_NaN();
  int degree = 0, elements = 0, meshes = 0, iterations = 0, newton_steps = 0;
  int folds = 0;  ///< of the branch, as solve() met them
  double seconds = 0.0;
  ExtremalStatus witness_status = ExtremalStatus::NewtonFailed;
  double witness_tau = std::numeric_limits<double>::quiet_NaN();
  double witness_error = std::numeric_limits<double>::quiet_NaN();
  int witness_folds = 0;
  double witness_seconds = 0.0;
  Difference difference;
  FixedText<400> reason;          ///< why solve() has no verified result
  FixedText<400> witness_reason;  ///< why the witness has none
};

/// Solves the scene both ways.
[[nodiscard]] Record examine(const Scene& scene);

[[nodiscard]] std::string csv_head();
[[nodiscard]] std::string csv_line(int index, const Scene& scene,
                                   const Record& record);

}  // namespace brachisto::benchmarks
