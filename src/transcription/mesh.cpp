// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/transcription/mesh.hpp"

namespace brachisto {

Mesh uniform_mesh(int degree, int num_elements) {
  Mesh mesh{degree, {}};
  mesh.boundaries.reserve(static_cast<std::size_t>(num_elements) + 1);
  for (int e = 0; e <= num_elements; ++e) {
    mesh.boundaries.push_back(static_cast<double>(e) / num_elements);
  }
  return mesh;
}

}  // namespace brachisto
