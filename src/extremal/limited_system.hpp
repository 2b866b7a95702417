// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Multiple shooting over arcs: what an extremal under limits satisfies, for
/// the arcs it is known to have.

#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "extremal/limited_boundary.hpp"
#include "extremal/limited_integration.hpp"
#include "extremal/limited_path.hpp"

namespace brachisto::limited {

/// A stretch of the path along which the same limit holds, or none.
struct Arc {
  std::optional<HeldLimit> held;
  double duration = 0.0;  ///< of u
  /// What the path touches at its end, B or where the same limit goes on.
  std::optional<HeldLimit> touched = {};
};

/// A path to start from, in natural units; need not be accurate.
struct Guess {
  std::vector<Arc> arcs;
  /// At a share of the duration of an arc, from 0 to 1.
  std::function<State(std::size_t arc, double share)> state;
};

/// Unknowns: states and costates where pieces of arcs begin, and at B; the
/// durations of arcs; and by how much costates jump where they may.
///
/// Equations: pieces fit together, and
///
/// - at A: rest, the centre above A, and of its slope what the contact asks
///   for. A limit on forces from rest on fixes β₀ on the border of the static
///   cone. Its arc is then determined from rest on, whatever the costates,
///   which do not enter and are unknowns at its end;
/// - at the start of what follows: 𝓗 + p_β q = 0, which stays so;
/// - where a free arc begins behind a limit of the control:
///   p_β = ∂𝓗/∂β = 0; where it ends nothing, for both are constant on it;
/// - where the path lands on a boundary: c = 0 and dc/du = 0. Behind a limit of
///   the control also p_β = ∂𝓗/∂β = 0, and (p_x, p_z) may jump along the
///   normal, as they may where such a limit begins behind a boundary;
/// - between two limits of the control: p_β = 0 if they bound it from opposite
///   sides, else that the second one holds already;
/// - where a limit is touched while another holds the control: c = dc/du = 0
///   along the arc, and the costates of the states may jump along ∂c/∂y;
/// - at B: the place, p_θ = p_w = 0, and p_β = 0, or what the contact asks for.
///   A limit that is reached there while another holds the control: c = 0, and
///   in front of it the costates may differ from these along ∂c/∂y.
///
/// Some say the same twice, as the place of B does on a boundary. So they are
/// solved as a problem of least squares whose residual has to vanish.
class LimitedSystem {
 public:
  /// \param natural  the scene, in natural units; must outlive this
  LimitedSystem(const Scene& natural, const Guess& guess);

  /// Why this method does not know arcs of the kind; empty if it does.
  [[nodiscard]] const std::string& refusal() const { return refusal_; }

  /// The guess as unknowns.
  [[nodiscard]] const Eigen::VectorXd& start() const { return start_; }

  struct Linearisation {
    Eigen::VectorXd residual;
    Eigen::MatrixXd jacobian;
    std::vector<int> arc_of_row;  ///< num_arcs() at B
    double transit_time = 0.0;
    Eigen::RowVectorXd time_gradient;
    int steps = 0;
    int arc = 0;  ///< the last one that was begun
  };
  /// False where a piece cannot be integrated.
  [[nodiscard]] bool evaluate(const Eigen::VectorXd& point,
                              const shooting::StepControl& control,
                              Linearisation& out) const;

  [[nodiscard]] int num_arcs() const { return static_cast<int>(arcs_.size()); }
  [[nodiscard]] int num_nodes() const { return first_node_.back() + 1; }
  /// Where a node's components, and the duration of an arc, stand among the
  /// unknowns.
  [[nodiscard]] int of_node(int node) const { return kWidth * node; }
  [[nodiscard]] int of_duration(int arc) const {
    return of_node(num_nodes()) + arc;
  }
  /// "arc 2 of 5, along floor"; "B".
  [[nodiscard]] std::string place_of(int arc) const;
  /// Empty if a piece cannot be integrated.
  [[nodiscard]] ArcPath path(const Eigen::VectorXd& point,
                             const shooting::StepControl& control) const;

 private:
  class Rows;
  static constexpr int kWidth = static_cast<int>(kSize);

  /// Why the arcs on both sides of a junction are not known, or nothing.
  [[nodiscard]] std::string unknown_junction(int arc) const;
  void take_guess(const Guess& guess);

  [[nodiscard]] State node(const Eigen::VectorXd& point, int i) const;
  [[nodiscard]] int of_jump(int jump) const {
    return of_duration(num_arcs()) + jump;
  }
  /// Whether the costates do not enter an arc.
  [[nodiscard]] bool blind(int arc) const {
    return arc == 0 && leave_.kind() == LimitedStart::Kind::Forced;
  }
  [[nodiscard]] Judged judged(int arc) const {
    return blind(arc) ? Judged::StatesAlone : Judged::StatesAndCostates;
  }
  [[nodiscard]] double span_of(const Eigen::VectorXd& point, int arc) const;
  /// The limit along whose gradient costates jump in front of an arc.
  [[nodiscard]] const HeldLimit& jumps_along(int arc) const;
  void junction_rows(Rows& rows, int arc, const State& y) const;
  void matching_rows(Rows& rows, int arc, int piece, const PieceEnd& end,
                     const Eigen::VectorXd& point) const;

  const Scene& scene_;
  std::vector<Arc> arcs_;
  std::vector<LimitedFlow> flows_;
  LimitedStart leave_;
  std::vector<int> pieces_;      ///< of each arc
  std::vector<int> first_node_;  ///< of each arc, and the node at B
  /// In front of each arc and of B: its number, or −1.
  std::vector<int> jump_;
  std::vector<bool> opposite_;  ///< in front of each arc
  int num_jumps_ = 0;
  std::string refusal_;
  Eigen::VectorXd start_;
};

}  // namespace brachisto::limited
