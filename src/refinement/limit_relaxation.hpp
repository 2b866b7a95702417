// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Limits on the way from what the free extremal keeps to what is asked for.

#pragma once

#include <vector>

#include "brachisto/model/scene.hpp"
#include "model/path_inequality.hpp"
#include "transcription/extremal_curve.hpp"

namespace brachisto {

/// The free extremal's point at σ, with q = dβ/du.
[[nodiscard]] TurningPoint<double> turning_point(const ExtremalCurve& curve,
                                                 double sigma);

/// Whether limits are of the same kinds at the same places, with bounds on the
/// same sides.
[[nodiscard]] bool bounds_differ_alone(const std::vector<PathInequality>& from,
                                       const std::vector<PathInequality>& to);

/// Interpolates limits, from some that the free extremal keeps or that another
/// path does.
class LimitRelaxation {
 public:
  /// \param free  must outlive this
  LimitRelaxation(const Scene& scene, const ExtremalCurve& free);
  /// From other bounds of the same limits.
  /// \pre bounds_differ_alone()
  LimitRelaxation(const std::vector<PathInequality>& from,
                  const std::vector<PathInequality>& to);

  /// At share 0 the free extremal, or the other path, keeps them, but for u <
  /// 0.05 U, at 1 they are the scene's. With Contact::Optimal, which has no
  /// meaning without it, the bound of humps is the scene's throughout.
  [[nodiscard]] std::vector<PathInequality> at(double share) const;

 private:
  struct Way {
    PathInequality loose, wanted;
    bool geometric = false;
  };
  std::vector<Way> ways_;
};

}  // namespace brachisto
