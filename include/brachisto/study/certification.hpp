// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The certificate of an answer, and a second opinion on it.

#pragma once

#include <string>

#include "brachisto/math/stop_condition.hpp"
#include "brachisto/model/units.hpp"
#include "brachisto/study/adaptive_mesh.hpp"
#include "brachisto/trajectory/certificate.hpp"
#include "brachisto/transcription/discretisation.hpp"

namespace brachisto {

/// With a fixed mesh and no wanted tolerance, what its error has to be below
/// for its numbers to mean anything.
inline constexpr double kCoarsestAgreement = 1e-2;

/// A second opinion from the indirect method.
struct ExtremalOpinion {
  bool solved = false;  ///< ExtremalSolution::usable()
  std::string message;
  double tau = 0.0;
  double error_estimate = 0.0;  ///< relative, of the extremal method
  double difference = 0.0;  ///< relative, |τ − τ_extremal| / τ_extremal
};

/// certify(), and the check "agreement": the estimated error against the wanted
/// tolerance, or kCoarsestAgreement where none is wanted of a fixed mesh.
[[nodiscard]] Certificate certify_answer(MeshAnswer& answer,
                                         const Discretisation& wanted);

/// True if checks failed, and all that did are of the kind that a finer mesh
/// mends.
[[nodiscard]] bool under_resolved(const Certificate& certificate);

/// Solves `scene` by multiple shooting, started from `answer`, and adds the
/// check "extremal": two right answers differ by no more than both their
/// errors.
[[nodiscard]] ExtremalOpinion ask_extremal(const Scene& scene,
                                           const MeshAnswer& answer,
                                           const StopCondition& stop,
                                           Certificate& certificate);

/// The same of a time T [s] with the given relative error, started from an
/// extremal nearby that need not be accurate.
[[nodiscard]] ExtremalOpinion ask_extremal(const Scene& scene,
                                           const ExtremalCurve& nearby,
                                           double phi, double T, double error,
                                           const StopCondition& stop,
                                           Certificate& certificate);

}  // namespace brachisto
