// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "lanes/kernel.hpp"

namespace brachisto::lanes {

template struct Kernel<Instructions::Avx2, kLanes, Surroundings{}>;
template struct Kernel<Instructions::Avx2, kLanes, Surroundings{.air = true}>;

}  // namespace brachisto::lanes
