// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "solvers/blas_threads.hpp"

#include <dlfcn.h>

namespace brachisto {

namespace {

// The reference BLAS has no such functions; OpenBLAS does.
template <class Function>
Function* find_symbol(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
}

}  // namespace

SingleThreadedBlas::SingleThreadedBlas() {
  auto* get = find_symbol<int()>("openblas_get_num_threads");
  auto* set = find_symbol<void(int)>("openblas_set_num_threads");
  if (get == nullptr || set == nullptr) return;
  previous_ = get();
  set(1);
}

SingleThreadedBlas::~SingleThreadedBlas() {
  if (previous_ <= 1) return;
  find_symbol<void(int)>("openblas_set_num_threads")(previous_);
}

}  // namespace brachisto
