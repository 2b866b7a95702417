// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The linear systems of multiple shooting, solved by orthogonal elimination
/// along the chain of arcs.

#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <Eigen/QR>
#include <vector>

#include "extremal/arc_integration.hpp"

namespace brachisto::shooting {

inline constexpr int kGlobals = 5;    ///< U, p_x, p_z, φ, η
inline constexpr int kStartRows = 5;  ///< x, z, θ, w, p_w are known
inline constexpr int kEndRows = 5;    ///< x, z, p_θ, p_w, β
inline constexpr int kFinalRows = kStartRows + kEndRows + 1;

using Globals = Eigen::Matrix<double, kGlobals, 1>;

/// The linearised conditions, for changes δs_0 … δs_N of the nodes and δq of
/// the globals:
///
///     start_states δs_0 + start_globals δq           = −residual   (5 rows)
///     δs_{i+1} − arcs[i].states δs_i − arcs[i].globals δq = −residual   (6
///     each) end_states δs_N + end_globals δq               = −residual   (5
///     rows)
struct ChainJacobian {
  struct Arc {
    Matrix6 states;
    Eigen::Matrix<double, 6, kGlobals> globals;
  };
  Eigen::Matrix<double, kStartRows, 6> start_states;
  Eigen::Matrix<double, kStartRows, kGlobals> start_globals;
  std::vector<Arc> arcs;
  Eigen::Matrix<double, kEndRows, 6> end_states;
  Eigen::Matrix<double, kEndRows, kGlobals> end_globals;
};

/// Right-hand sides or residuals in the order of the rows above.
struct ChainRows {
  Eigen::Matrix<double, kStartRows, 1> start;
  std::vector<Vector6> arcs;
  Eigen::Matrix<double, kEndRows, 1> end;
};

/// Values of, or changes to, all unknowns.
struct ChainVector {
  Globals globals;
  std::vector<Vector6> nodes;  ///< one more than arcs
};

/// Factorisation of a ChainJacobian with one more row, `row`·δq = value.
///
/// From the start on, five rows are known to hold for each node; together with
/// the six of the next arc they form an 11×6 column block whose QR factors give
/// δs_i from δs_{i+1} and δq, and five rows for the next node. Orthogonal
/// transformations keep this stable whether the flow grows or shrinks, which
/// condensing by products of the arc matrices is not. Cost: linear in arcs.
class ChainElimination {
 public:
  /// \param row  the additional row, for the globals alone
  ChainElimination(const ChainJacobian& jacobian, const Globals& row);

  /// Solves for the right-hand side −rows, and `value` for the added row.
  [[nodiscard]] ChainVector solve(const ChainRows& rows, double value) const;
  /// Solves for right-hand side zero but in the added row.
  [[nodiscard]] ChainVector solve(double value) const;
  /// Sign of the determinant of the whole system, 1 or −1; 0 if singular.
  [[nodiscard]] int determinant_sign() const;

 private:
  using Stacked = Eigen::Matrix<double, kStartRows + 6, 1>;
  struct Link {
    Eigen::HouseholderQR<Eigen::Matrix<double, kStartRows + 6, 6>> qr;
    Matrix6 next;                                // times δs_{i+1}
    Eigen::Matrix<double, 6, kGlobals> globals;  // times δq
  };
  using Final = Eigen::Matrix<double, kFinalRows, kFinalRows>;

  std::vector<Link> links_;
  Eigen::PartialPivLU<Final> final_;
};

}  // namespace brachisto::shooting
