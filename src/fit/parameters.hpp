// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The numbers of a scene that times on its track tell.

#pragma once

#include <array>
#include <string>
#include <string_view>

#include "brachisto/model/scene.hpp"
#include "trajectory/time_sensitivity.hpp"

namespace brachisto::fit {

/// A number that can be fitted.
struct Parameter {
  const char* key;      ///< of problem files
  MotionNumber number;  ///< by which times are derived
  bool of_bead;         ///< or of what rolls
  double& (*of)(Scene&);
};

inline constexpr std::array<Parameter, 3> kParameters{{
    {"scene.losses.rolling", MotionNumber::Loss, false,
     [](Scene& scene) -> double& { return scene.world.losses.rolling; }},
    {"scene.losses.sliding", MotionNumber::Loss, true,
     [](Scene& scene) -> double& { return scene.world.losses.sliding; }},
    {"scene.body.k", MotionNumber::Inertia, false,
     [](Scene& scene) -> double& { return scene.body.k; }},
}};

/// The one of that key, or null.
[[nodiscard]] const Parameter* find_parameter(std::string_view key);

/// Why a scene has no such number; "" if it has.
[[nodiscard]] std::string objection(const Parameter& parameter,
                                    const Scene& scene);

}  // namespace brachisto::fit
