// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "solvers/one_at_a_time.hpp"

#include <dlfcn.h>

#include <chrono>

#include "brachisto/math/clock.hpp"

namespace brachisto {

namespace {

std::recursive_timed_mutex place;

// The reference BLAS has no such functions; OpenBLAS does.
template <class Function>
Function* find_symbol(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
}

}  // namespace

OneAtATime::OneAtATime() : lock_(place, std::defer_lock) {
  constexpr std::chrono::milliseconds kPatience{50};
  while (!lock_.try_lock_for(kPatience)) check_stop();
  auto* get = find_symbol<int()>("openblas_get_num_threads");
  auto* set = find_symbol<void(int)>("openblas_set_num_threads");
  if (get == nullptr || set == nullptr) return;
  blas_threads_ = get();
  set(1);
}

OneAtATime::~OneAtATime() {
  if (blas_threads_ <= 1) return;
  find_symbol<void(int)>("openblas_set_num_threads")(blas_threads_);
}

}  // namespace brachisto
