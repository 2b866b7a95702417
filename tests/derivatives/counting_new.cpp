// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "derivatives/counting_new.hpp"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<long> calls = 0;
std::atomic<std::size_t> bytes = 0;

void count(std::size_t size) {
  ++calls;
  bytes += size;
}

}  // namespace

namespace brachisto::testing {

long num_allocations() {
  return calls;
}

double allocated_bytes() {
  return static_cast<double>(bytes);
}

}  // namespace brachisto::testing

// The array and nothrow forms of the standard library call these; no type of
// ours is over-aligned. They stand in a file of their own because a compiler
// that sees through them to malloc and free warns of mismatches.
void* operator new(std::size_t size) {
  count(size);
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

// For types that ask for more alignment than malloc gives.
void* operator new(std::size_t size, std::align_val_t alignment) {
  count(size);
  const auto unit = static_cast<std::size_t>(alignment);
  if (void* memory = std::aligned_alloc(unit, (size + unit) / unit * unit)) {
    return memory;
  }
  throw std::bad_alloc();
}
void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}
