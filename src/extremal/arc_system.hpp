// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Multiple shooting over arcs: what an extremal satisfies, in any world and
/// under limits, for the arcs it is known to have. Without limits it is one
/// arc.

#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "extremal/arc_boundary.hpp"
#include "extremal/arc_path.hpp"
#include "ocp/chain_elimination.hpp"

namespace brachisto::arcs {

class NodeEquations;

/// A stretch of the path along which the same limit holds, or none.
struct Arc {
  std::optional<HeldLimit> held;
  double duration = 0.0;  ///< of u
  /// What the path touches at its end, B or where the same limit goes on.
  std::optional<HeldLimit> touched = {};
  /// Of the first one: what is reached at A besides.
  std::optional<HeldLimit> corner = {};
};

/// A path to start from, in natural units; need not be accurate.
struct Guess {
  std::vector<Arc> arcs;
  /// At a share of the duration of an arc, from 0 to 1.
  std::function<State(std::size_t arc, double share)> state;
};

/// Unknowns: nodes where pieces of arcs begin, and at B; the durations of arcs;
/// and by how much costates jump where they may.
///
/// Equations: pieces fit together, in all of x, z, θ, w, β and the costates
/// that one side has as unknowns, with p_β = 0 where β is the control; and
///
/// - at A: rest or the push, the centre above A, and of its slope what the
///   contact asks for. A limit on forces from rest on fixes β₀ on the border of
///   the static cone. Its arc is then determined from rest on, whatever the
///   costates, which do not enter and are unknowns at its end;
/// - at the start of what follows: 𝓗 = 0, which stays so;
/// - where the path lands on a boundary: c = 0, and behind a free arc μ = 0,
///   which says that it does so tangentially. Behind a limit of the control μ
///   is the jump of (p_x, p_z) along the normal;
/// - where such a limit begins behind a boundary they may jump along it again;
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
class ArcSystem {
 public:
  /// \param natural  the scene, in natural units
  /// \param pieces   of all arcs; 0: from the turns of the body
  ArcSystem(const Scene& natural, const Guess& guess, int pieces = 0);

  /// The same equations of a scene that differs by numbers.
  [[nodiscard]] ArcSystem in(const Scene& natural) const;

  /// Why this method does not know arcs of the kind; empty if it does.
  [[nodiscard]] const std::string& refusal() const { return refusal_; }

  using Point = ocp::ChainVector;
  /// The guess as unknowns.
  [[nodiscard]] const Point& start() const { return start_; }

  struct Linearisation {
    std::vector<ocp::ChainLink> links;  ///< of each node
    double transit_time = 0.0;
    Point time_gradient;
    Jet slope_at_A, slope_at_B;  ///< derivatives by the nodes there
    int steps = 0;
    int arc = 0;    ///< the last one that was begun
    int piece = 0;  ///< of all pieces, the last one that was begun

    /// Largest residual, and their length.
    [[nodiscard]] double largest() const;
    [[nodiscard]] double norm() const;
    /// The node whose equations are met least.
    [[nodiscard]] int worst_node() const;
    /// All but derivatives of another one.
    void take_values(const Linearisation& other);
  };
  /// False where a piece cannot be integrated.
  /// \param derivatives  whether more than the residual is asked for
  [[nodiscard]] bool evaluate(const Point& point,
                              const ocp::StepControl& control,
                              Linearisation& out,
                              bool derivatives = true) const;

  [[nodiscard]] int num_arcs() const { return static_cast<int>(arcs_.size()); }
  [[nodiscard]] int num_nodes() const { return first_node_.back() + 1; }
  [[nodiscard]] int num_pieces() const { return first_node_.back(); }
  /// The arc that begins at a node or contains it; num_arcs() at B.
  [[nodiscard]] int arc_of_node(int node) const;
  /// "arc 2 of 5, along floor"; "B".
  [[nodiscard]] std::string place_of(int arc) const;
  /// Empty if a piece cannot be integrated.
  [[nodiscard]] ArcPath path(const Point& point,
                             const ocp::StepControl& control) const;

 private:
  /// Why the arcs on both sides of a junction are not known, or nothing.
  [[nodiscard]] std::string unknown_junction(int arc) const;
  void take_guess(const Guess& guess);

  [[nodiscard]] int of_jump(int jump) const { return num_arcs() + jump; }
  /// Whether the costates do not enter an arc.
  [[nodiscard]] bool blind(int arc) const {
    return arc == 0 && leave_.kind() == Departure::Kind::Forced;
  }
  [[nodiscard]] double span_of(const Point& point, int arc) const;
  /// The limit along whose gradient costates jump in front of an arc.
  [[nodiscard]] const HeldLimit& jumps_along(int arc) const;
  void junction_rows(NodeEquations& rows, int arc, const Node& y,
                     const LinearPoint& at) const;
  /// Between the end of a piece and the node behind it.
  [[nodiscard]] bool matching_rows(NodeEquations& rows, int arc,
                                   const PieceEnd& end, const Node& next,
                                   double next_near, double jump) const;

  Scene scene_;
  std::vector<Arc> arcs_;
  std::vector<ArcFlow> flows_;
  Departure leave_;
  double slope_near_A_;
  std::vector<int> pieces_;      ///< of each arc
  std::vector<int> first_node_;  ///< of each arc, and the node at B
  /// In front of each arc and of B: its number, or −1.
  std::vector<int> jump_;
  std::vector<bool> opposite_;  ///< in front of each arc
  int num_jumps_ = 0;
  std::string refusal_;
  Point start_;
};

/// point + factor · change.
[[nodiscard]] ocp::ChainVector moved(const ocp::ChainVector& point,
                                     double factor,
                                     const ocp::ChainVector& change);

}  // namespace brachisto::arcs
