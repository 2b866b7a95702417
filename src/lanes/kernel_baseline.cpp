// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "lanes/kernel.hpp"

namespace brachisto::lanes {

template struct Kernel<Instructions::Baseline>;
template struct Kernel<Instructions::Baseline, kFewLanes>;

}  // namespace brachisto::lanes
