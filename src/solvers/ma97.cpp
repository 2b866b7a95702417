// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "solvers/ma97.hpp"

#include <stdexcept>

#include "brachisto/math/index.hpp"

namespace brachisto {

nlp::SparsityPattern triangle_pattern(int size, const int ptr[],
                                      const int row[], int first) {
  const auto check = [](bool fine) {
    if (!fine) throw std::invalid_argument("the pattern is none of a matrix");
  };
  check(size >= 0 && ptr[0] == first);
  for (int i = 0; i < size; ++i) check(ptr[i] <= ptr[i + 1]);
  nlp::SparsityPattern pattern;
  pattern.reserve(at(ptr[size] - first));
  for (int i = 0; i < size; ++i) {
    for (int e = ptr[i] - first; e < ptr[i + 1] - first; ++e) {
      const int j = row[e] - first;
      check(j >= 0 && j < size);
      pattern.add(i, j);
    }
  }
  return pattern;
}

}  // namespace brachisto
