// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "lanes/kernel.hpp"

namespace brachisto::lanes {

template struct Kernel<Instructions::Avx2, Surroundings{}>;
template struct Kernel<Instructions::Avx2, Surroundings{.air = true}>;
template struct Kernel<Instructions::Avx2, Surroundings{.field = true}>;
template struct Kernel<Instructions::Avx2,
                       Surroundings{.air = true, .field = true}>;

}  // namespace brachisto::lanes
