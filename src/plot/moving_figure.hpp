// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The motion as a picture that moves, motion.gif.

#pragma once

#include "brachisto/model/scene.hpp"
#include "plot/trajectory_table.hpp"
#include "report/figure.hpp"

namespace brachisto::plot {

/// Frames at equal times, some seconds long whatever the motion takes.
[[nodiscard]] report::Figure moving_figure(const Scene& scene,
                                           const TrajectoryTable& table);

}  // namespace brachisto::plot
