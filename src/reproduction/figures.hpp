// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The figures of the paper, and those it lacks.

#pragma once

#include <string>
#include <vector>

#include "report/chart.hpp"
#include "reproduction/results.hpp"

namespace brachisto::reproduction {

inline constexpr const char* kBlack = "#000000";
inline constexpr const char* kBlue = "#1a3f8f";
inline constexpr const char* kBrown = "#b5651d";
inline constexpr const char* kGrey = "#888888";

/// A picture and what is to be said of it.
struct Figure {
  std::string heading;  ///< "Fig. 4. …", rich text
  std::string caption;  ///< rich text
  report::Figure drawing{};
};

/// A chart without curves.
[[nodiscard]] report::Chart chart_of(const char* name, const char* title,
                                     const char* x, const char* y);
[[nodiscard]] Figure figure(const report::Chart& chart, std::string heading,
                            std::string caption);

/// Paths: standard curves, three bodies, families.
[[nodiscard]] std::vector<Figure> path_figures(const Cases& cases);

/// Along the path: speeds, forces, friction, curvature, energies.
[[nodiscard]] std::vector<Figure> motion_figures(const Cases& cases);

/// Over parameters: τ of η_m and θ_m, the best θ_m, possible bodies.
[[nodiscard]] std::vector<Figure> parameter_figures(const Results& found);

/// All of them in the order of the paper.
[[nodiscard]] std::vector<Figure> all_figures(const Results& found);

}  // namespace brachisto::reproduction
