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
  for (std::size_t at = 0; at < words.size(); at = words.find('\0', at) + 1) {
    arguments.push_back(words.data() + at);
  }
  arguments.push_back(nullptr);
  std::error_code error;
  const fs::path here = fs::read_symlink("/proc/self/exe", error).parent_path();
  for (const char* place : {BRACHISTO_PROVER_FROM_BINARY, "brachisto-prove"}) {
    ::execv((here / place).c_str(), arguments.data());
  }
  tell_error(fmt::format(
      "brachisto: no proofs: {} cannot be run ({})\n",
      (here / BRACHISTO_PROVER_FROM_BINARY).lexically_normal().string(),
      std::generic_category().message(errno)));
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
