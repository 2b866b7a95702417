// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What `certify: proof` adds to an answer.

#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "brachisto/report/result.hpp"
#include "brachisto/study/solve.hpp"

namespace brachisto::app {

inline constexpr const char* kProofDocument = "proof.json";
inline constexpr const char* kProofPage = "proof.md";

/// Whether a proof is asked for.
[[nodiscard]] bool asks_for_proof(const SolveOptions& options);

/// Why this build proves nothing; empty if it does.
[[nodiscard]] std::string no_proofs_because();

/// Proves what can be proven of a verified answer's scene, with more bits as
/// long as a statement is left open, and tells it in the solution.
///
/// \param stop  ends it: nothing is proven then
/// \return proof.json and proof.md; none if nothing is proven
[[nodiscard]] std::vector<report::OutputFile> prove_answer(
    Solution& solution, const StopCondition& stop,
    const ProgressHook& progress);

}  // namespace brachisto::app
