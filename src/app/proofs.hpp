// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What `brachisto prove` and `brachisto check-proof` do, and what `certify:
// proof` adds to an answer. It stands in a program of its own: to load Arb and
// what it stands on takes longer than most of the other verbs do.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/verbs.hpp"
#include "brachisto/report/result.hpp"
#include "brachisto/study/solve.hpp"

namespace brachisto::app {

struct ProveFlags : CommonFlags {
  int bits = 160;
  std::string out;
  bool force = false;
};

struct CheckFlags {
  std::string file;
  std::string problem;
  bool json = false;
  bool quiet = false;
};

inline constexpr const char* kProofDocument = "proof.json";
inline constexpr const char* kProofPage = "proof.md";

/// In the program without proofs: starts the one that has them in its place,
/// with the same command line.
///
/// \return exit code if it cannot; nothing in the program that has them
[[nodiscard]] std::optional<int> become_prover();

/// Proves what can be proven of a verified answer's scene, with more bits as
/// long as a statement is left open, and tells it in the solution.
///
/// \param stop  ends it: nothing is proven then
/// \return proof.json and proof.md; none if nothing is proven
[[nodiscard]] std::vector<report::OutputFile> prove_answer(
    Solution& solution, const StopCondition& stop,
    const ProgressHook& progress);

/// \return exit code
[[nodiscard]] int prove(const ProveFlags& flags);
[[nodiscard]] int check_proof(const CheckFlags& flags);

}  // namespace brachisto::app
