// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Points of the plane.

#pragma once

namespace brachisto {

/// A point of the plane, z down [m].
struct Point {
  double x = 0.0;
  double z = 0.0;

  friend bool operator==(const Point&, const Point&) = default;
};

}  // namespace brachisto
