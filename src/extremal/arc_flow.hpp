// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Hamilton's equations on one arc, along which a limit holds or none, in any
/// world.

#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <optional>
#include <variant>

#include "brachisto/math/jet.hpp"
#include "brachisto/model/scene.hpp"
#include "model/path_inequality.hpp"
#include "ocp/flow.hpp"
#include "ocp/integration.hpp"
#include "rolling/rolling_body.hpp"

namespace brachisto::arcs {

/// Order of states and costates; everything is in natural units.
enum Component : std::size_t {
  kX,
  kZ,
  kTheta,
  kW,
  kBeta,
  kPX,
  kPZ,
  kPTheta,
  kPW,
  kPBeta,
  kSize
};
inline constexpr std::size_t kStates = kPX;

template <class Scalar>
using Values = std::array<Scalar, kSize>;
using State = Values<double>;
/// Numbers with their derivatives by all components of a node.
using Jet = math::Jet1<double, static_cast<int>(kSize)>;

/// Order in the nodes of arcs whose control is β.
namespace free_arc {
enum : Eigen::Index { kX, kZ, kTheta, kW, kPX, kPZ, kPTheta, kPW };
}

/// dθ/ds of a scene: 1/r, or 1 for a bead, whose θ is the arc length then.
/// Under limits 0 without an offset, for programs have no θ then: one that no
/// row but its own knew would be all that Newton's method sees of a guess from
/// them.
[[nodiscard]] double rotation_per_length(const Scene& natural);

/// A limit that holds at one of its bounds.
struct HeldLimit {
  PathInequality limit;
  double bound = 0.0;

  [[nodiscard]] bool at_upper() const { return bound == limit.upper; }
};

/// What is integrated along an arc, states and then their costates.
///
/// - Free: β is the control and no state, from ∂𝓗/∂β = 0.
/// - A limit c = b of the control holds: β is a state, q = dβ/du is from
///   c(y, q) = b.
/// - A limit c = b of the place holds: β is the control, from dc/du = 0. With
///   μ dc/du in 𝓗 costates are continuous where the arc ends but for a term
///   along the normal ∂c/∂(x, z): (p_x, p_z) + μ ∂c/∂(x, z) are the costates
///   that c itself with the multiplier ν = dμ/du would give.
using Node = Eigen::VectorXd;

/// Where a piece of an arc ends.
struct PieceEnd {
  Node y, rates;
  double t = 0.0;  ///< ∫√A du along the piece
  double control = 0.0;
  double time_rate = 0.0;
  Eigen::MatrixXd by_start;  ///< ∂y/∂(y at the start)
  Eigen::RowVectorXd time_by_start;
  int steps = 0;
};

/// A place on the way.
struct Knot {
  double u = 0.0;
  Node y;
  double t = 0.0, control = 0.0;
};

/// All at one place of an arc. The costates are those of c itself.
struct ArcPoint {
  State y{};
  double q = 0.0;         ///< dβ/du
  double nu = 0.0;        ///< multiplier of the limit that holds, per u
  double jump = 0.0;      ///< μ along a boundary: of a jump that begins it
  double legendre = 0.0;  ///< ∂²𝓗/∂β² on a free arc
  double root = 0.0;      ///< √A
};

/// The same with derivatives by the node.
struct LinearPoint {
  Values<Jet> y;
  Jet p_x, p_z;  ///< of the node
  Jet multiplier;
  Jet hamiltonian;
};

/// A limit along an arc whose control another one holds, a function of the
/// states alone so.
struct AlongArc {
  Jet value, rate;  ///< c, dc/du
  std::array<Jet, kStates> by_state;
};

class ArcFlow {
 public:
  enum class Kind { Free, Control, Place };

  /// \param natural  the scene, in natural units
  ArcFlow(const Scene& natural, std::optional<HeldLimit> held);

  [[nodiscard]] Kind kind() const { return kind_; }
  [[nodiscard]] const std::optional<HeldLimit>& held() const { return held_; }
  /// Components of a node.
  [[nodiscard]] Eigen::Index width() const {
    return kind_ == Kind::Control ? 10 : 8;
  }
  /// Lets the error control look at the states alone, where costates mean
  /// nothing.
  void judge_states_alone();

  /// What a node has of a state; the control near which it finds its own.
  [[nodiscard]] Node node_of(const State& y) const;
  [[nodiscard]] double near(const State& y) const {
    return kind_ == Kind::Control ? 0.0 : y[kBeta];
  }

  /// \param control  [in,out] near which it is searched
  /// \return false if there is none
  [[nodiscard]] bool find(const Node& y, double& control, ArcPoint& at) const;
  [[nodiscard]] bool find(const Node& y, double& control,
                          LinearPoint& at) const;
  /// \pre kind() is Control
  [[nodiscard]] AlongArc along(const PathInequality& limit,
                               const Node& y) const;
  /// The value of a limit at a place of the arc, and ∂c/∂q.
  [[nodiscard]] double value(const PathInequality& limit,
                             const ArcPoint& at) const;
  [[nodiscard]] double by_control(const PathInequality& limit,
                                  const ArcPoint& at) const;

  /// Integrates over `span` with derivatives by Fehlberg's pair; false if the
  /// steps become too small.
  /// \param step  [in,out] step to try first, 0: any; the last one taken
  /// \param derivatives  zero if they are not asked for
  [[nodiscard]] bool integrate(const Node& start, double near, double span,
                               const ocp::StepControl& control, double& step,
                               PieceEnd& end, bool derivatives = true) const;
  /// The same without derivatives; tells of the start and of every step, u from
  /// the start of the piece.
  [[nodiscard]] bool follow(const Node& start, double near, double span,
                            const ocp::StepControl& control,
                            const std::function<void(const Knot&)>& tell) const;
  /// One step of length `span`, unchecked: for interpolation. `towards` is the
  /// knot behind it, which tells the side of a surface.
  [[nodiscard]] Knot step_from(const Knot& from, const Knot& towards,
                               double span) const;

 private:
  using SteeredFlow = ocp::Flow<rolling::Steered>;
  using FallingFlow = ocp::Flow<rolling::SteeredFalling>;
  using TurningFlow = ocp::Flow<rolling::Turning>;
  using AnyFlow = std::variant<SteeredFlow, FallingFlow, TurningFlow>;

  std::optional<HeldLimit> held_;
  Kind kind_;
  AnyFlow flow_;
};

/// ∂c/∂(x, z) of a limit of the place.
[[nodiscard]] inline rolling::Normal<Jet> normal_at(const PathInequality& limit,
                                                    const Values<Jet>& y) {
  return rolling::normal_of(limit, y[kX], y[kZ]);
}

}  // namespace brachisto::arcs
