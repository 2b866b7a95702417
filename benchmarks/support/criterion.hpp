// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Pass criteria of problem files, written in their first comment.
///
///     # Why: small radius, twenty bumps
///     # Pass: tau = 5.7071701888
///
/// and, where a start other than the cycloid has to lead to the same extremal,
///
///     # Cold start: principal
///
/// A criterion is one of
///
///     tau = NUMBER         verified, and τ is NUMBER to its last digit
///     verified             verified, whatever the number
///     infeasible: TEXT     verified, but the body cannot run there because
///     TEXT not verified: TEXT   solved, and the check that failed is named
///     TEXT refused: TEXT        not solved, or not even read, and the message
///                          contains TEXT

#pragma once

#include <string>
#include <string_view>

#include "brachisto/study/solve.hpp"

namespace brachisto::benchmarks {

struct Criterion {
  enum class Kind { Tau, Verified, Infeasible, NotVerified, Refused };
  Kind kind = Kind::Verified;
  double tau = 0.0;
  double half_unit = 0.0;  ///< of the last digit of tau
  std::string text;
  bool cold_start = false;  ///< it has to lead to the principal branch

  [[nodiscard]] bool wants_a_path() const {
    return kind != Kind::Refused && kind != Kind::NotVerified;
  }
};

/// What the comments of a problem file say.
struct Intent {
  std::string why;
  std::string pass;  ///< the criterion as written
  Criterion criterion;
};

/// \throws std::runtime_error if one of the lines is missing or malformed
[[nodiscard]] Intent read_intent(const std::string& path);

/// Empty if the solution is what was wanted, otherwise what it is instead.
[[nodiscard]] std::string objection(const Criterion& criterion,
                                    const Solution& solution);

/// The same for a file that was refused with this message.
[[nodiscard]] std::string objection(const Criterion& criterion,
                                    std::string_view refusal);

}  // namespace brachisto::benchmarks
