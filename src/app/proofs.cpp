// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "app/proofs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/exit_code.hpp"
#include "app/solution_output.hpp"
#include "app/terminal.hpp"
#include "brachisto/io/problem_file.hpp"
#include "io/input_tree.hpp"
#include "math/cpu_clock.hpp"
#include "proof/certificate.hpp"
#include "report/text_table.hpp"

namespace brachisto::app {

namespace {

namespace fs = std::filesystem;

int not_shown(const std::string& status, const std::string& why, bool json) {
  if (json) print_json({{"status", status}, {"message", why}});
  tell_error(fmt::format("brachisto: {}: {}\n", status, why));
  return kNotSolved;
}

/// What the numbers of a result are worth beside the enclosure; null of a
/// result without any.
proof::Json compared(const fs::path& result, const proof::Json& certificate) {
  const proof::Json said =
      proof::Json::parse(io::read_file_bytes(result, "a result"));
  if (!said.at("tau").is_number() || !said.at("estimated_error").is_number()) {
    return {};
  }
  const double tau = said.at("tau").get<double>();
  const double estimated = said.at("estimated_error").get<double>() * tau;
  const double off = proof::distance_to_tau(certificate, tau);
  return {{"tau", tau},
          {"off_at_most", off},
          {"estimated_error_of_tau", estimated},
          {"within_estimate", off <= estimated}};
}

std::string in_words_compared(const proof::Json& compared) {
  return fmt::format(
      "  The result's τ = {:.15g} is off by at most {}: {} its estimated "
      "error, {:.1e}\n",
      compared.at("tau").get<double>(),
      report::at_most(compared.at("off_at_most").get<double>()),
      compared.at("within_estimate").get<bool>() ? "within" : "more than",
      compared.at("estimated_error_of_tau").get<double>());
}

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
    } catch (const std::exception&) {
      if (best.is_null()) throw;
      return best;
    }
  }
  return best;
}

}  // namespace

std::optional<int> become_prover() {
  return {};
}

std::vector<report::OutputFile> prove_answer(Solution& solution,
                                             const StopCondition& stop,
                                             const ProgressHook& progress) {
  Proof& told = solution.proof.emplace();
  if (!solution.verified()) {
    told.not_proven_because = "the answer is not verified";
    return {};
  }
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
    const double estimated = solution.estimated_error.value_or(0.0);
    const double the_same = std::max(1e-6, 10.0 * estimated);
    if (!(told.off_at_most <= the_same * found)) {
      throw proof::NotProven(
          fmt::format("the extremal that is proven is another one, of τ = {}",
                      told.tau_lower));
    }
    told.within_estimate = told.off_at_most <= estimated * found;
    for (const auto& [name, said] : made.at("theorems").items()) {
      told.statements.push_back(
          {name, said.at("holds").get<bool>(), said.value("why_not", "")});
    }
    told.bits = made.at("accuracy").at("bits").get<int>();
    files = {{kProofDocument, made.dump(1) + "\n"},
             {kProofPage, proof::page(made)}};
  } catch (const Stopped&) {
    told.not_proven_because = "stopped before the end";
  } catch (const std::exception& error) {  // the answer is not to be lost
    told.not_proven_because = error.what();
  }
  told.cpu_seconds = process_cpu_seconds() - begin;
  return files;
}

int prove(const ProveFlags& flags) {
  std::error_code unknown;
  const bool of_result = fs::is_directory(flags.file, unknown);
  const fs::path file =
      of_result ? fs::path(flags.file) / kResultFile : fs::path(flags.file);
  const io::ProblemFile problem = io::read_problem_file(file, flags.overrides);
  if (!flags.out.empty()) {
    report::check_writable(flags.out, {kProofDocument, kProofPage},
                           flags.force);
  }
  try {
    const proof::Json certificate =
        proof::prove(problem.scene, proof::accuracy_of(flags.bits));
    if (!flags.out.empty()) {
      report::write_files(flags.out,
                          {{kProofDocument, certificate.dump(1) + "\n"},
                           {kProofPage, proof::page(certificate)}},
                          flags.force);
    }
    const proof::Json result = of_result && flags.overrides.empty()
                                   ? compared(file, certificate)
                                   : proof::Json();
    if (flags.json) {
      proof::Json out = certificate;
      if (!result.is_null()) out["result"] = result;
      print_json(out);
    } else if (!flags.quiet) {
      print(proof::in_words(certificate));
      if (!result.is_null()) print(in_words_compared(result));
      if (!flags.out.empty())
        print_paths(flags.out, {{kProofDocument, ""}, {kProofPage, ""}});
    }
  } catch (const proof::NotProven& error) {
    return not_shown("not proven", error.what(), flags.json);
  }
  return kSuccess;
}

int check_proof(const CheckFlags& flags) {
  const proof::Json certificate = proof::Json::parse(
      io::read_file_bytes(flags.file, "a file of `brachisto prove --out`"),
      nullptr, false);
  try {
    // What is no certificate is refused before a scene is compared with it.
    (void)proof::scene_of(certificate);
    if (!flags.problem.empty() &&
        !proof::is_of(certificate,
                      io::read_problem_file(flags.problem).scene)) {
      throw proof::Refused("it is of another scene than " + flags.problem);
    }
    const proof::Json again = proof::check(certificate);
    if (flags.json) {
      print_json(again);
    } else if (!flags.quiet) {
      print("Shown again with more bits, more terms and shorter steps.\n" +
            proof::in_words(again));
    }
  } catch (const proof::Refused& error) {
    return not_shown("refused", error.what(), flags.json);
  } catch (const proof::NotProven& error) {
    return not_shown("not proven again", error.what(), flags.json);
  } catch (const proof::Json::exception&) {
    return not_shown("refused", "it is not as `brachisto prove` writes it",
                     flags.json);
  } catch (const std::logic_error&) {  // of a number that cannot be read
    return not_shown("refused", "a number in it cannot be read", flags.json);
  }
  return kSuccess;
}

}  // namespace brachisto::app
