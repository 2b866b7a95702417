// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "chain_library/matrix.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "brachisto/math/index.hpp"
#include "solvers/chain_detection.hpp"

namespace brachisto::chain_library {

namespace {

/// dmumps_c() of the sequential MUMPS as Debian names it; nullptr if it is not
/// wanted. It stays loaded.
/// \throws std::runtime_error
Mumps::Call wanted_mumps() {
  const char* const wanted = std::getenv("BRACHISTO_CHAIN_FALLBACK");
  if (wanted == nullptr || *wanted == '\0') return nullptr;
  if (std::string_view(wanted) != "mumps") {
    throw std::runtime_error(
        std::string("BRACHISTO_CHAIN_FALLBACK is mumps or empty, not ") +
        wanted);
  }
  const std::string version = MUMPS_VERSION;
  const std::string file =
      "libdmumps_seq-" + version.substr(0, version.rfind('.')) + ".so";
  void* const library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  void* const call = library == nullptr ? nullptr : dlsym(library, "dmumps_c");
  if (call == nullptr) throw std::runtime_error(dlerror());
  return reinterpret_cast<Mumps::Call>(call);
}

}  // namespace

Inertia Matrix::factorise(std::span<const double> values, double quality) {
  if (!ldlt_ && (mumps_ || !find(values))) return factorise_by_mumps(values);
  if (std::exchange(quality_, quality) != quality) ldlt_->forget_pivots();
  ldlt_->set_scale(scale_of(values));
  const std::array<std::span<const double>, 1> arrays = {values};
  const bool factorised = ldlt_->factorise(arrays);
  Inertia inertia = ldlt_->inertia();
  inertia.known = true;
  if (!factorised && inertia.zero == 0) inertia.zero = 1;
  // Zeros may have hidden which unknowns have diagonal entries.
  if (inertia.zero > 0) ldlt_.reset();
  return inertia;
}

Inertia Matrix::factorise_by_mumps(std::span<const double> values) {
  if (!mumps_) {
    const Mumps::Call call = wanted_mumps();
    if (call == nullptr) {
      say_once(
          "the matrix is no chain of small blocks; take another linear solver, "
          "or set BRACHISTO_CHAIN_FALLBACK=mumps");
      return {};
    }
    say_once("the matrix is no chain of small blocks; MUMPS factorises it");
    mumps_ = std::make_unique<Mumps>(call);
  }
  std::vector<int> rows, cols;
  pattern_.for_each([&](std::size_t, int i, int j) {
    rows.push_back(i + 1);
    cols.push_back(j + 1);
  });
  return mumps_->factorise(size_, std::move(rows), std::move(cols),
                           {values.begin(), values.end()});
}

void Matrix::solve(std::span<double> x) const {
  if (ldlt_) {
    ldlt_->solve(x);
  } else {
    mumps_->solve(x);
  }
}

bool Matrix::find(std::span<const double> values) {
  std::vector<bool> no_diagonal(at(size_), true);
  pattern_.for_each([&](std::size_t entry, int i, int j) {
    if (i == j && values[entry] != 0.0) no_diagonal[at(i)] = false;
  });
  auto chain =
      find_chain(MatrixGraph::of_pattern(size_, pattern_), no_diagonal);
  if (!chain) return false;
  const std::array<EntryPositions, 1> positions = {EntryPositions{pattern_, 0}};
  ldlt_ = ChainLdlt::make(*std::move(chain), positions);
  return ldlt_ != nullptr;
}

/// Powers of two that bring large diagonal entries, those of variables next to
/// a bound, down to order one and the largest entry beside a small diagonal
/// one, in rows of constraints, to order one.
std::vector<double> Matrix::scale_of(std::span<const double> values) const {
  constexpr int kMost = 60;
  std::vector<double> scale(at(size_), 1.0), largest(at(size_), 0.0);
  std::vector<char> small(at(size_), 1);
  pattern_.for_each([&](std::size_t entry, int i, int j) {
    const double a = std::abs(values[entry]);
    if (i != j || !std::isfinite(a) || a == 0.0) return;
    small[at(i)] = 0;
    if (a > 1.0) scale[at(i)] = std::ldexp(1.0, -(std::ilogb(a) + 1) / 2);
  });
  pattern_.for_each([&](std::size_t entry, int i, int j) {
    if (i == j) return;
    const double a = std::abs(values[entry]);
    if (small[at(i)] != 0) {
      largest[at(i)] = std::max(largest[at(i)], a * scale[at(j)]);
    }
    if (small[at(j)] != 0) {
      largest[at(j)] = std::max(largest[at(j)], a * scale[at(i)]);
    }
  });
  for (std::size_t i = 0; i < largest.size(); ++i) {
    if (small[i] == 0 || !(largest[i] > 0.0)) continue;
    if (!std::isfinite(largest[i])) continue;
    scale[i] =
        std::ldexp(1.0, std::clamp(-std::ilogb(largest[i]), -kMost, kMost));
  }
  return scale;
}

void say_once(const std::string& what) {
  static std::mutex mutex;
  static std::set<std::string> said;
  const std::lock_guard lock(mutex);
  if (said.insert(what).second) {
    std::fprintf(stderr, "brachisto-chain: %s\n", what.c_str());
  }
}

}  // namespace brachisto::chain_library
