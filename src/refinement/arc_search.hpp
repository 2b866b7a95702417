// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The arcs of a path under limits, from others that are near.

#pragma once

#include <optional>

#include "refinement/arc_fit.hpp"
#include "refinement/pass_protocol.hpp"

namespace brachisto {

/// Fits arcs and corrects them until all limits are kept. What it did, and why
/// there is no path, stands in the protocol.
class ArcSearch {
 public:
  /// Both must outlive this.
  ArcSearch(PassProtocol& protocol, const MeshOptions& options)
      : protocol_(protocol), options_(options) {}

  [[nodiscard]] ArcFit fit(const LimitedCurve& nearby, PathSetting setting,
                           int degree);

  /// Arcs that keep all limits, from others that are near. Where a limit of the
  /// control is exceeded along one of the place there are two corrections: the
  /// path is led back to the place and touches it, or the limit takes over for
  /// good. If the first one fails, or comes again and again, the second one is
  /// tried.
  ///
  /// \param exceeded  see corrected()
  /// \param graded    on more elements, shorter next to junctions
  [[nodiscard]] std::optional<FittedPath> fit_corrected(LimitedCurve nearby,
                                                        PathSetting setting,
                                                        int degree,
                                                        double exceeded,
                                                        bool graded = false);

 private:
  /// The path without arcs so short that their equations are within rounding
  /// of each other, where it keeps all limits without them too.
  [[nodiscard]] FittedPath without_slivers(FittedPath path, int degree,
                                           double exceeded);
  void note(const char* what, const PathSetting& setting);

  PassProtocol& protocol_;
  const MeshOptions& options_;
};

}  // namespace brachisto
