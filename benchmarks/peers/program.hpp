// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The programs that peers solve, each with the start that all of them get.

#pragma once

#include <filesystem>
#include <memory>

#include "brachisto/run/solve_options.hpp"
#include "transcription/extremal_curve.hpp"
#include "transcription/transcription.hpp"

namespace brachisto::benchmarks {

/// The reference case, its contact at B, and an extremal to start from.
struct ReferenceCase {
  Scene natural;           ///< in natural units
  double tau = 0.0;        ///< by shooting
  double phi = 0.0;        ///< of its contact at B [rad]
  double time_unit = 0.0;  ///< τ over the objective of a program
  /// Of a body whose centre of mass is less far from its axis, on a coarse
  /// mesh, in natural units.
  ExtremalCurve nearby;
  double nearby_phi = 0.0;  ///< of its contact [rad]

  /// \throws std::runtime_error  if one of them is not found
  [[nodiscard]] static ReferenceCase make();
};

/// A program between the fixed end points that φ has, and where it is begun.
struct PeerProgram {
  std::unique_ptr<Transcription> problem;
  PrimalDual start;  ///< with multipliers

  /// \param nodes  about so many; of degree 5, or straight pieces
  PeerProgram(const ReferenceCase& reference, Formulation formulation,
              int nodes);
  /// As an .nl file with the start in it.
  void write(const std::filesystem::path& nl_file) const;
};

}  // namespace brachisto::benchmarks
