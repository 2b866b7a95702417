// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Bodies by their offset, its direction, their inertia and radius.

#pragma once

#include <memory>

#include "design/design_space.hpp"

namespace brachisto {

/// Those that a plan without parts chooses from.
/// \param body  what is not free
[[nodiscard]] std::unique_ptr<DesignSpace> offset_space(const DesignPlan& plan,
                                                        const Body& body);

}  // namespace brachisto
