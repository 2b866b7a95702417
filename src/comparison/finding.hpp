// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The result of a comparison in one sentence.

#pragma once

#include <string>
#include <vector>

namespace brachisto::comparison {

struct WorkPrecision;
struct MethodComparison;

/// A solve that has an answer.
struct Trial {
  std::string how;       ///< "rolling_time p = 3, mesh of 8"
  double seconds = 0.0;  ///< processor time
  double error = 0.0;    ///< relative, of τ
};

/// One of those that compete, with all its methods and meshes.
struct Party {
  std::string name;  ///< as a sentence has it, "the program"
  std::vector<Trial> trials;
  bool refused = false;  ///< it takes no such scene at all

  /// The quickest trial to this error, nullptr if there is none.
  [[nodiscard]] const Trial* quickest_to(double error) const;
  /// The trial of the least error, nullptr without trials.
  [[nodiscard]] const Trial* nearest() const;
};

/// In the order in which they were run, the program first.
[[nodiscard]] std::vector<Party> parties_of(const WorkPrecision& found);
[[nodiscard]] std::vector<Party> parties_of(const MethodComparison& made);

/// The error of which the sentence speaks.
inline constexpr double kSpokenError = 1e-6;

/// "To an error of 1e−6 the program needs 4.1 ms; fsolve does not reach it (at
/// best 8.8e−5)." What all parties do, each named once.
[[nodiscard]] std::string in_a_sentence(const std::vector<Party>& parties,
                                        double error = kSpokenError);

/// "8.8e−5", "1e−6": two digits at most.
[[nodiscard]] std::string error_words(double error);

/// "4.1 ms", "12 s", "125 s": two digits, or all before the point.
[[nodiscard]] std::string duration(double seconds);

}  // namespace brachisto::comparison
