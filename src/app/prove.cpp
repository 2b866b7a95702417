// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto prove FILE, and brachisto check-proof FILE.

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "app/exit_code.hpp"
#include "app/proof_of_answer.hpp"
#include "app/solution_output.hpp"
#include "app/terminal.hpp"
#include "app/verbs.hpp"
#include "brachisto/io/problem_file.hpp"
#include "brachisto/report/result.hpp"
#include "io/input_tree.hpp"
#ifdef BRACHISTO_HAS_ARB
#include "proof/certificate.hpp"
#endif

namespace brachisto::app {

namespace {

namespace fs = std::filesystem;

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

#ifdef BRACHISTO_HAS_ARB

int not_shown(const std::string& status, const std::string& why, bool json) {
  if (json) print_json({{"status", status}, {"message", why}});
  tell_error(fmt::format("brachisto: {}: {}\n", status, why));
  return kNotSolved;
}

/// What the numbers of a result are worth beside the enclosure; null of a
/// result without any.
proof::Json compared(const fs::path& result, const proof::Json& certificate) {
  const proof::Json said = proof::Json::parse(
      io::read_file_bytes(result, fs::file_size(result), "a result"));
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
      "  The result's τ = {:.15g} is off by at most {:.1e}: {} its estimated "
      "error, {:.1e}\n",
      compared.at("tau").get<double>(),
      compared.at("off_at_most").get<double>(),
      compared.at("within_estimate").get<bool>() ? "within" : "more than",
      compared.at("estimated_error_of_tau").get<double>());
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

int check(const CheckFlags& flags) {
  const proof::Json certificate = proof::Json::parse(
      io::read_file_bytes(flags.file, fs::file_size(flags.file),
                          "a file of `brachisto prove --out`"),
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
            proof::in_words(certificate));
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

#else

int without_arb() {
  tell_error(fmt::format("brachisto: {}\n", no_proofs_because()));
  return kUsage;
}
int prove(const ProveFlags&) {
  return without_arb();
}
int check(const CheckFlags&) {
  return without_arb();
}

#endif

}  // namespace

Verb prove_verb() {
  const auto flags = std::make_shared<ProveFlags>();
  std::vector<Flag> all = flags->with(
      {{.name = "--bits",
        .value = &flags->bits,
        .text = "Precision; terms of series follow",
        .placeholder = "BITS",
        .check = integer_within(96, 1024),
        .shows_default = true},
       directory_flag(
           "--out", flags->out,
           "Write proof.json and proof.md, a page for people, there"),
       {"--force", &flags->force, "Replace existing ones"}});
  all.front().text = "Problem file, or directory of `brachisto solve --out`";
  all.front().check = not_empty();
  return {
      .name = "prove",
      .text =
          "Prove that the extremal of a scene exists, with bounds of τ, and "
          "what else can be shown",
      .flags = std::move(all),
      .footer = R"(docs/proofs.md says what is shown and what is trusted.
Examples:
  brachisto prove case.yaml
  brachisto prove case.yaml --out proof
  brachisto check-proof proof/proof.json
Exit codes: 0 existence and bounds are proven, 2 built without Arb,
3 bad input file, 4 not proven, 6 I/O.)",
      .run = [flags] { return prove(*flags); }};
}

Verb check_proof_verb() {
  const auto flags = std::make_shared<CheckFlags>();
  return {.name = "check-proof",
          .text = "Show again what a proof says, with another precision",
          .flags = {{.name = "FILE",
                     .value = &flags->file,
                     .text = "proof.json of `brachisto prove --out`",
                     .check = existing_file(),
                     .required = true},
                    {.name = "--problem",
                     .value = &flags->problem,
                     .text = "Refuse it if it is not of this problem file",
                     .placeholder = "FILE",
                     .check = existing_file()},
                    json_flag(flags->json),
                    {"--quiet", &flags->quiet, "Print nothing"}},
          .footer = R"(An edited file and one of another version are refused.
Example:
  brachisto check-proof proof/proof.json --problem case.yaml
Exit codes: 0 shown again, 2 built without Arb, 4 refused or not shown
again, 6 I/O.)",
          .run = [flags] { return check(*flags); }};
}

}  // namespace brachisto::app
