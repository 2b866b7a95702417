// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/provenance.hpp"

#include <SuiteSparse_config.h>
#include <dlfcn.h>
#include <fmt/format.h>

#include <filesystem>

#include "brachisto/solvers/program_solvers.hpp"
#include "brachisto/version.hpp"

namespace brachisto::report {

namespace {

/// The BLAS is exchanged at run time, so ask the loader which one it is.
std::string blas_in_use() {
  if (void* config = dlsym(RTLD_DEFAULT, "openblas_get_config")) {
    return reinterpret_cast<const char* (*)()>(config)();
  }
  Dl_info info;
  void* dgemm = dlsym(RTLD_DEFAULT, "dgemm_");
  if (dgemm == nullptr || dladdr(dgemm, &info) == 0) return "unknown";
  std::error_code error;
  const auto path = std::filesystem::canonical(info.dli_fname, error);
  return error ? std::string(info.dli_fname) : path.filename().string();
}

}  // namespace

Provenance provenance() {
  return {
      .brachisto = BRACHISTO_VERSION,
      .ipopt = ipopt_version(),
      .mumps = mumps_version(),
      .blas = blas_in_use(),
      .suitesparse =
          fmt::format("{}.{}.{}", SUITESPARSE_MAIN_VERSION,
                      SUITESPARSE_SUB_VERSION, SUITESPARSE_SUBSUB_VERSION),
      .compiler = fmt::format("g++ {}", __VERSION__),
  };
}

Fields<Provenance> version_fields() {
  using P = Provenance;
  return {{"brachisto", "", "version of this program", &P::brachisto},
          {"ipopt", "", "version", &P::ipopt},
          {"mumps", "", "version", &P::mumps},
          {"blas", "", "file or configuration", &P::blas},
          {"suitesparse", "", "version", &P::suitesparse},
          {"compiler", "", "and its version", &P::compiler}};
}

std::string provenance_json() {
  return written(version_fields(), provenance()).dump();
}

}  // namespace brachisto::report
