// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "app/proof_of_answer.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

#ifdef BRACHISTO_HAS_ARB
#include "math/cpu_clock.hpp"
#include "proof/certificate.hpp"
#endif

namespace brachisto::app {

bool asks_for_proof(const SolveOptions& options) {
  const auto* program = options.of<Collocation>();
  return program != nullptr && program->certify == Certify::Proof;
}

#ifdef BRACHISTO_HAS_ARB

namespace {

// A statement that is left open is tried again with more.
constexpr std::array kBits{160, 224, 320};

/// Whether more bits may show more.
bool left_open(const proof::Json& certificate) {
  for (const auto& [name, said] : certificate.at("theorems").items()) {
    if (said.contains("why_not") && !said.contains("refuted")) return true;
  }
  return false;
}

proof::Json best_proof(const Scene& scene, const ProgressHook& progress) {
  proof::Json best;
  for (const int bits : kBits) {
    if (progress) progress("proof", fmt::format("with {} bits", bits));
    try {
      best = proof::prove(scene, proof::accuracy_of(bits));
      if (!left_open(best)) return best;
    } catch (const proof::TooFewBits&) {
      if (bits == kBits.back() && best.is_null()) throw;
    }
  }
  return best;
}

}  // namespace

std::string no_proofs_because() {
  return {};
}

std::vector<report::OutputFile> prove_answer(Solution& solution,
                                             const StopCondition& stop,
                                             const ProgressHook& progress) {
  if (!solution.verified()) return {};
  Proof& told = solution.proof.emplace();
  const double begin = process_cpu_seconds();
  std::vector<report::OutputFile> files;
  try {
    const StopScope scope(stop);
    const proof::Json made = best_proof(solution.scene, progress);
    const proof::Json& tau = made.at("enclosures").at("tau");
    told.tau_lower = tau.at("lower").get<std::string>();
    told.tau_upper = tau.at("upper").get<std::string>();
    const double found = solution.motion()->tau();
    told.off_at_most = proof::distance_to_tau(made, found);
    // Of another method than the answer's, which may have found another one.
    constexpr double kTheSame = 1e-6;
    if (!(told.off_at_most <= kTheSame * found)) {
      throw proof::NotProven(
          fmt::format("the extremal that is proven is another one, of τ = {}",
                      told.tau_lower));
    }
    told.within_estimate =
        told.off_at_most <= solution.estimated_error.value_or(0.0) * found;
    for (const auto& [name, said] : made.at("theorems").items()) {
      told.statements.push_back(
          {name, said.at("holds").get<bool>(), said.value("why_not", "")});
    }
    told.bits = made.at("accuracy").at("bits").get<int>();
    files = {{kProofDocument, made.dump(1) + "\n"},
             {kProofPage, proof::page(made)}};
  } catch (const proof::NotProven& error) {
    told.not_proven_because = error.what();
  } catch (const Stopped&) {
    told.not_proven_because = "stopped before the end";
  }
  told.cpu_seconds = process_cpu_seconds() - begin;
  return files;
}

#else

std::string no_proofs_because() {
  return "built without Arb, no proofs: install libflint-arb-dev (Debian 12) "
         "or libflint-dev (Debian 13) and configure again";
}

std::vector<report::OutputFile> prove_answer(Solution&, const StopCondition&,
                                             const ProgressHook&) {
  return {};
}

#endif

}  // namespace brachisto::app
