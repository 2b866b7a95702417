// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>
#include <vector>

#include "app/exit_code.hpp"
#include "app/proofs.hpp"
#include "app/terminal.hpp"

namespace brachisto::app {

namespace {

#ifdef BRACHISTO_HAS_ARB

namespace fs = std::filesystem;

/// Becomes the program with proofs, which stands where it is installed or, in a
/// build, beside this one.
int hand_over() {
  std::ifstream file("/proc/self/cmdline", std::ios::binary);
  std::string words{std::istreambuf_iterator<char>(file), {}};
  std::vector<char*> arguments;
  if (words.empty() || words.back() != '\0') words.push_back('\0');
  for (std::size_t at = 0; at < words.size(); at = words.find('\0', at) + 1) {
    arguments.push_back(words.data() + at);
  }
  arguments.push_back(nullptr);
  std::error_code error;
  const fs::path here = fs::read_symlink("/proc/self/exe", error).parent_path();
  const fs::path installed =
      (here / BRACHISTO_PROVER_FROM_BINARY).lexically_normal();
  if (!error) {  // it is known where this program stands
    ::execv(installed.c_str(), arguments.data());
    error.assign(errno, std::generic_category());
    if (error == std::errc::no_such_file_or_directory) {
      ::execv((here / "brachisto-prove").c_str(), arguments.data());
    }
  }
  tell_error(fmt::format("brachisto: no proofs: {} cannot be run ({})\n",
                         installed.string(), error.message()));
  return kIoError;
}

#else

int hand_over() {
  tell_error(
      "brachisto: built without Arb, no proofs: install libflint-arb-dev "
      "(Debian 12) or libflint-dev (Debian 13) and configure again\n");
  return kUsage;
}

#endif

}  // namespace

std::optional<int> become_prover() {
  return hand_over();
}
// Nobody comes here without become_prover().
std::vector<report::OutputFile> prove_answer(Solution&, const StopCondition&,
                                             const ProgressHook&) {
  return {};
}
int prove(const ProveFlags&) {
  return hand_over();
}
int check_proof(const CheckFlags&) {
  return hand_over();
}

}  // namespace brachisto::app
