// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The command `brachisto`.

#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string_view>
#include <system_error>
#include <variant>

#include "app/command_line.hpp"
#include "app/exit_code.hpp"
#include "app/signals.hpp"
#include "app/terminal.hpp"
#include "app/verbs.hpp"
#include "brachisto/math/clock.hpp"
#include "brachisto/report/result.hpp"
#include "brachisto/solvers/status.hpp"
#include "comparison/work_precision.hpp"
#include "fit/fit_times.hpp"
#include "io/visible_text.hpp"
#include "report/provenance.hpp"
#include "reproduction/cases.hpp"
#include "sweep/manager.hpp"

namespace brachisto::app {

namespace {

std::string version_text() {
  const report::Provenance made_with = report::provenance();
  return fmt::format(
      "brachisto {}\nIpopt {}\nMUMPS {}\nBLAS {}\nSuiteSparse {}\ncompiler {}",
      made_with.brachisto, made_with.ipopt, made_with.mumps, made_with.blas,
      made_with.suitesparse, made_with.compiler);
}

/// What went wrong: on stderr for a person and, with --json, as the one
/// document on stdout.
int fail(ExitCode code, std::string_view status, std::string_view message,
         bool json, const io::InputError* input = nullptr) {
  tell_error(fmt::format("{}\n", message));
  if (json) {
    try {
      print_data(failure_document(status, message, input));
    } catch (const std::system_error&) {
      // That nobody listens must not hide the exit code.
    }
  }
  return code;
}

/// What follows --color. It has to be known before the command line is read,
/// for what is wrong with that may have a colour too.
std::string_view colour_in(int argc, char** argv) {
  constexpr std::string_view kFlag = "--color";
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == kFlag && i + 1 < argc) return argv[i + 1];
    if (word.starts_with(kFlag) && word.substr(kFlag.size()).starts_with('=')) {
      return word.substr(kFlag.size() + 1);
    }
  }
  return "auto";
}

CommandLine command_line() {
  static std::string colour = "auto";  // read by colour_in() already
  return {
      "Computes brachistochrones of a bead or a rolling, possibly off-centred "
      "cylinder:\nits smooth-contact extremal (docs/theory.md, section 3), or "
      "a track "
      "under limits (section 11).",
      "Examples:\n"
      "  brachisto new track\n"
      "  brachisto solve problems/paper/fig04_reference_case.yaml\n"
      "  brachisto validate problems/case.yaml\n"
      "  brachisto sweep problems/sweeps/map_eta_theta.yaml --out map\n"
      "  brachisto body ring:m=2 point:m=1,at=1@-30deg\n"
      "`brachisto VERB --help` tells more.",
      version_text,
      {solve_verb(),          design_verb(),      fit_verb(),
       validate_verb(),       schema_verb(),      sweep_verb(),
       export_verb(),         merge_verb(),       report_verb(),
       show_verb(),           race_verb(),        paper_verb(),
       body_verb(),           table_verb(),       compare_verb(),
       work_precision_verb(), nlp_verb(),         derivatives_verb(),
       prove_verb(),          check_proof_verb(), new_verb(),
       worker_verb(),         measure_verb(),     complete_verb(command_line)},
      {{.name = "--color",
        .value = &colour,
        .text = "Colours for verdicts, warnings and errors; auto: on a "
                "terminal, unless NO_COLOR is set",
        .placeholder = "WHEN",
        .check = one_of({"auto", "always", "never"}),
        .shows_default = true}}};
}

int run(int argc, char** argv) {
  const bool json = std::any_of(argv + 1, argv + argc, [](const char* a) {
    return std::string_view(a).starts_with("--json");
  });
  set_colour(colour_in(argc, argv));
  // A message of one line, whatever the names in it contain.
  constexpr const char* kName = "brachisto: ";
  const auto end = [&](ExitCode how, std::string_view status,
                       const std::exception& error, const char* before = "") {
    return fail(how, status, before + io::visible(error.what()), json);
  };
  try {
    const CommandLine command = command_line();
    const Asked asked = read_command_line(command, argc, argv);
    int code = kSuccess;
    if (const auto* text = std::get_if<std::string>(&asked)) {
      print(*text);
    } else {
      code = std::get<const Verb*>(asked)->run();
    }
    // A full disk or a closed pipe shows when the buffer is written.
    if (!flush_results()) {
      return fail(kIoError, "io_error", "brachisto: cannot write to stdout",
                  false);
    }
    return code;
  } catch (const UsageError& error) {
    fail(kUsage, "usage", error.what(), json);
    tell(fmt::format("Run {} --help for more information.\n", error.asked()));
    return kUsage;
  } catch (const io::InputError& error) {
    return fail(kBadInput, "bad_input", error.what(), json, &error);
  } catch (const io::IoError& error) {
    return end(kIoError, "io_error", error);
  } catch (const report::OutputError& error) {
    return end(kIoError, "io_error", error);
  } catch (const sweep::StoreError& error) {
    return end(kIoError, "io_error", error);
  } catch (const comparison::NoReference& error) {
    return end(kNotSolved, "no_reference", error, kName);
  } catch (const fit::CannotFit& error) {
    return end(kNotSolved, "cannot_fit", error, kName);
  } catch (const reproduction::NotVerified& error) {
    return end(kNotSolved, "not_verified", error, kName);
  } catch (const Stopped& error) {
    return end(static_cast<ExitCode>(kSignalBase + catch_signals().load()),
               "interrupted", error, kName);
  } catch (const std::bad_alloc&) {
    return fail(kLimit, name(Status::OutOfMemory),
                fmt::format("{}{}", kName, describe(Status::OutOfMemory)),
                json);
  } catch (const sweep::WorkersFail& error) {
    return fail(kInternalError, "workers_fail", error.what(), json);
  } catch (const std::system_error& error) {  // also of fmt::print
    return end(kIoError, "io_error", error, kName);
  } catch (const std::exception& error) {
    return end(kInternalError, "internal_error", error,
               "brachisto: internal error: ");
  }
}

}  // namespace

}  // namespace brachisto::app

int main(int argc, char** argv) {
  // What is longer than the shell allows cannot be written, and is told so.
  std::signal(SIGXFSZ, SIG_IGN);
  // Large arrays come and go with every mesh. Memory that was given back to the
  // kernel comes back page by page, each zeroed: it is kept.
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, -1);
  return brachisto::app::run(argc, argv);
}
