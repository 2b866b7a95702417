// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "lanes/kernel.hpp"

namespace brachisto::lanes {

template struct Kernel<Instructions::Baseline, kLanes, Surroundings{}>;
template struct Kernel<Instructions::Baseline, kLanes,
                       Surroundings{.air = true}>;
template struct Kernel<Instructions::Baseline, kFewLanes, Surroundings{}>;
template struct Kernel<Instructions::Baseline, kFewLanes,
                       Surroundings{.air = true}>;

}  // namespace brachisto::lanes
