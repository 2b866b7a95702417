// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The transit time of a scene as a function.

#pragma once

#include <stdexcept>

#include "brachisto/model/scene.hpp"

namespace brachisto::reproduction {

/// Something has no verified answer; what() says what and why.
class NotVerified : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// τ of the fastest track, to a relative error of 1e-12.
/// \throws NotVerified  without a verified answer
[[nodiscard]] double verified_tau(const Scene& scene);

}  // namespace brachisto::reproduction
