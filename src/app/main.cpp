// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The command `brachisto`.

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string_view>
#include <system_error>

#include "app/command_line.hpp"
#include "app/exit_code.hpp"
#include "app/signals.hpp"
#include "app/terminal.hpp"
#include "app/verbs.hpp"
#include "brachisto/math/stop_condition.hpp"
#include "brachisto/report/output_files.hpp"
#include "brachisto/solvers/status.hpp"
#include "comparison/work_precision.hpp"
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
  tell(fmt::format("{}\n", message));
  if (json) {
    try {
      print_data(failure_document(status, message, input));
    } catch (const std::system_error&) {
      // That nobody listens must not hide the exit code.
    }
  }
  return code;
}

/// What the command line asks for.
int run_command(int argc, char** argv) {
  Command command(
      R"(Computes brachistochrones of a bead or a rolling, possibly off-centred cylinder:
its smooth-contact extremal (docs/theory.md, section 3).)",
      R"(Examples:
  brachisto solve problems/paper/fig04_reference_case.yaml
  brachisto validate problems/case.yaml
  brachisto sweep problems/sweeps/map_eta_theta.yaml --out map
  brachisto body ring:m=2 point:m=1,at=1@-30deg
`brachisto VERB --help` tells more.)",
      version_text);
  for (const auto add :
       {add_solve, add_validate, add_schema, add_sweep, add_export, add_merge,
        add_report, add_paper, add_body, add_compare, add_work_precision,
        add_worker, add_measure}) {
    add(command);
  }
  return command.read(argc, argv)();
}

int run(int argc, char** argv) {
  const bool json = std::any_of(argv + 1, argv + argc, [](const char* a) {
    return std::string_view(a).starts_with("--json");
  });
  // A message of one line, whatever the names in it contain.
  constexpr const char* kName = "brachisto: ";
  const auto end = [&](ExitCode how, std::string_view status,
                       const std::exception& error, const char* before = "") {
    return fail(how, status, before + io::visible(error.what()), json);
  };
  try {
    const int code = run_command(argc, argv);
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
  return brachisto::app::run(argc, argv);
}
