// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// All that one run of the benchmark measures.

#pragma once

#include <string>
#include <vector>

#include "fsolve/arm.hpp"
#include "fsolve/rolling.hpp"

namespace brachisto::benchmarks {

struct FsolveFindings {
  double cap = 60.0;  ///< of processor time, of one solve [s]
  double exact_tau = 0.0;
  double exact_error = 0.0;         ///< relative, its own
  std::vector<std::string> others;  ///< versions, or that they are not there

  /// Every arm on both data, by datum, n and arm.
  std::vector<DiscretePoint> arms;
  /// Hybrid, datum rest, on one n with smaller and larger ε.
  std::vector<DiscretePoint> steps;
  /// On n beyond those of `arms`, and Simplified on all n.
  std::vector<DiscretePoint> large;

  std::vector<RollingRun> menu;    ///< uniform meshes of every degree
  std::vector<RollingRun> growth;  ///< degree 5, 1e2 to 1e5 nodes
  std::vector<RollingRun> wanted;  ///< by tolerance, 1e-6 to 1e-12
  std::vector<double> tolerances;  ///< of these

  /// The run of a task with ε = 1e-3, wherever it stands; null if there is
  /// none.
  [[nodiscard]] const DiscreteRun* find(Arm arm, DiscreteReading::Datum datum,
                                        int nodes) const;
};

/// The tables, in Markdown.
[[nodiscard]] std::string report(const FsolveFindings& found);

/// One row per run.
[[nodiscard]] std::string csv(const FsolveFindings& found);

/// The findings of NAME.csv and NAME.json, to the digits that are written
/// there; without tolerances and versions, which the figures do not show.
/// \throws std::exception if they cannot be read
[[nodiscard]] FsolveFindings read_findings(const std::string& name);

/// Versions, options and machine, beside the figures.
[[nodiscard]] std::string origin_json(const FsolveFindings& found);

/// Writes NAME_growth, NAME_error and NAME_nodes, each as .svg, .csv and .gp.
void write_charts(const FsolveFindings& found, const std::string& name);

}  // namespace brachisto::benchmarks
