// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The certificate of an answer, and its cross-check.

#pragma once

#include "brachisto/math/clock.hpp"
#include "brachisto/study/solution.hpp"
#include "brachisto/trajectory/motion.hpp"
#include "extremal/shooting.hpp"
#include "model/units.hpp"
#include "refinement/limited_refinement.hpp"
#include "refinement/refinement.hpp"
#include "trajectory/arc_length_motion.hpp"

namespace brachisto {

/// With a fixed mesh and no wanted tolerance, what its error has to be below
/// for its numbers to mean anything.
inline constexpr double kCoarsestAgreement = 1e-2;

/// certify(), and the check "agreement": the estimated error against the wanted
/// tolerance, or kCoarsestAgreement where none is wanted of a fixed mesh.
/// \param curve  of `answer`
[[nodiscard]] Certificate certify_answer(MeshAnswer& answer,
                                         const ExtremalCurve& curve,
                                         const Discretisation& wanted);

/// certify(), and the check "agreement" as in certify_answer().
[[nodiscard]] Certificate certify_answer(ArcLengthAnswer& answer,
                                         const ArcLengthMotion& motion,
                                         const Discretisation& wanted);

/// certify(), and the check "agreement" as in certify_answer().
[[nodiscard]] Certificate certify_answer(const LimitedAnswer& answer,
                                         const Discretisation& wanted);

/// True if checks failed, and all that did are of the kind that a finer mesh
/// mends.
[[nodiscard]] bool under_resolved(const Certificate& certificate);

/// \param ratio  of a time to that of the extremal; of no matter if that is not
///               usable()
[[nodiscard]] CrossCheck compare_with(const ExtremalSolution& extremal,
                                      double ratio);

/// Solves the scene by multiple shooting, started from an extremal nearby that
/// need not be accurate, compares its time with T [s], and adds the check
/// "extremal": two right answers differ by no more than both their errors.
/// \param nearby  in natural units, with the end angle φ
/// \param error   relative, of T
[[nodiscard]] CrossCheck cross_check(const PosedScene& scene,
                                     const ExtremalCurve& nearby, double phi,
                                     double T, double error,
                                     const StopCondition& stop,
                                     Certificate& certificate);

/// The same of a path under limits, by multiple shooting over its arcs; and the
/// checks "extremal_slopes" and "extremal_junctions". Where T is right to ε,
/// slopes are to 100 ε and junctions, as shares of U, to 1000 ε; or both to as
/// much as they move where the conditions err by ε, if that is more.
/// \param error  relative, of T
[[nodiscard]] CrossCheck cross_check(const FittedPath& found, double error,
                                     const StopCondition& stop,
                                     Certificate& certificate);

/// The checks "discrete_residual" and "discretisation", the relative error of
/// τ. The latter is held against the accuracy that the other methods have by
/// default, which a discretisation of order one cannot reach: its solution is
/// compared with the extremal and never taken for it.
[[nodiscard]] Certificate certify_discrete(const DiscreteAnswer& answer,
                                           const CrossCheck& check);

}  // namespace brachisto
