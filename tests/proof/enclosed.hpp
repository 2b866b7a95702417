// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The balls of a certificate.

#pragma once

#include <gtest/gtest.h>

#include "proof/certificate.hpp"

namespace brachisto::testing {

[[nodiscard]] inline proof::Real ball_of(const proof::Json& enclosure) {
  proof::Real out;
  EXPECT_TRUE(proof::Real::read(enclosure["ball"].get<std::string>(), out));
  return out;
}

[[nodiscard]] inline proof::Real enclosed(const proof::Json& certificate,
                                          const char* name) {
  return ball_of(certificate["enclosures"][name]);
}

}  // namespace brachisto::testing
