// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A track between the same points that is faster than the smooth contact.

#pragma once

#include "brachisto/model/scene.hpp"
#include "reproduction/cases.hpp"

namespace brachisto::reproduction {

/// The track of an extremal to another end of the centre's path, bent next to B
/// so that it arrives there with the slope that this end belongs to (third trap
/// in section 3 of docs/theory.md): a scene with that track as its path.
///
/// On its last piece the centre turns upwards on an arc of a small radius, and
/// the track is a groove that much wider than the body.
///
/// \param scene   of an optimised track, with Contact::Smooth
/// \param phi     slope angle at B, less than that of the extremal [rad]
/// \param radius  of the arc [m]; where it begins the spline through points of
///                the track overshoots, and below some H/12 the body may not
///                fit there
/// \throws NotVerified, Interrupted
[[nodiscard]] Scene bent_track(const Scene& scene, double phi, double radius,
                               const Interrupt& interrupt);

/// τ of that track where the arc shrinks to a kink at B, which no body can
/// follow: the least time to that end of the centre's path.
/// \throws NotVerified, Interrupted
[[nodiscard]] double tau_of_kinked_track(const Scene& scene, double phi,
                                         const Interrupt& interrupt);

}  // namespace brachisto::reproduction
