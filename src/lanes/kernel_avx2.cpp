// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "lanes/kernel.hpp"

namespace brachisto::lanes {

template void shoot_eight<Instructions::Avx2>(const Targets&, const Fineness&,
                                              Extremals&);

}  // namespace brachisto::lanes
