// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "lanes/kernel.hpp"

namespace brachisto::lanes {

template struct Kernel<Instructions::Baseline, kLanes, Falling::Free>;
template struct Kernel<Instructions::Baseline, kLanes, Falling::InAir>;
template struct Kernel<Instructions::Baseline, kFewLanes, Falling::Free>;
template struct Kernel<Instructions::Baseline, kFewLanes, Falling::InAir>;

}  // namespace brachisto::lanes
