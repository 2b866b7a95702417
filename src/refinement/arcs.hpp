// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The arcs of a path under limits, and the junctions between them.

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "transcription/limited_curve.hpp"

namespace brachisto {

/// A limit that is reached at one point alone.
struct Touch {
  std::size_t limit;
  nlp::Held at;
  double multiplier = 0.0;  ///< of its equation, as far as it is known
};

/// A stretch of the path along which the same limits hold.
struct Arc {
  std::vector<nlp::Held> held;  ///< of each limit; all No on a free arc
  double end = 1.0;             ///< σ
  /// Where its elements meet, as shares of its length, from 0 to 1.
  std::vector<double> cuts{0.0, 1.0};
  /// At the end of an arc whose control another limit holds: the only way to
  /// keep a limit that the control cannot. Behind it the same arc goes on, or
  /// what is touched holds the control.
  std::optional<Touch> touch = {};

  [[nodiscard]] int elements() const {
    return static_cast<int>(cuts.size()) - 1;
  }
};

/// An arc's share of σ.
[[nodiscard]] double length_of(const std::vector<Arc>& arcs, std::size_t i);

/// The arc before it, or else the one behind, takes its place, and neighbours
/// along which the same holds become one.
void leave_out(std::vector<Arc>& arcs, std::size_t i);

/// Whether a limit of the control holds on an arc.
[[nodiscard]] bool holds_control(const Arc& arc,
                                 const std::vector<PathInequality>& limits);

/// For people: "free to 0.0963, friction to 0.7029, free", ends being σ.
[[nodiscard]] std::string in_words(const std::vector<Arc>& arcs,
                                   const std::vector<PathInequality>& limits);

/// So many elements of equal length.
[[nodiscard]] std::vector<double> equal_cuts(int elements);
/// So many that are short next to both ends, where Chebyshev's polynomial has
/// its extrema: what a limit asks of the control may grow steeply there.
[[nodiscard]] std::vector<double> graded_cuts(int elements);

/// From the collocation points of a solution whose limits are inequalities:
/// junctions lie half-way between two points. A single point between two parts
/// of one arc belongs to it. Where two limits of the control hold, the second
/// is touched if the first one goes on, or if it bounds the control from the
/// other side and goes on itself; a limit of the place is touched if one of the
/// control holds all along with it.
[[nodiscard]] std::vector<Arc> arcs_of(const LimitedCurve& curve);

/// Arcs, and what is reached where a push begins.
struct ArcsFromA {
  std::vector<Arc> arcs;
  std::optional<StartCorner> corner;
};

/// Where the first arc of a pushed body ends, before the end of its first
/// element, at a touch with the same limit going on, that is a corner at A.
/// From rest the one there is stays if the first arc turns.
[[nodiscard]] ArcsFromA with_corner(const LimitedTime& problem,
                                    std::vector<Arc> arcs,
                                    std::optional<StartCorner> corner = {});

/// What becomes of a limit of the place along which one of the control is
/// exceeded.
enum class Takeover {
  LedBack,  ///< the path leaves it before, is led back and touches it
  ForGood,  ///< the path leaves it where the other one is reached
};

/// Other arcs, if a solution with these is none of the inequalities: where a
/// limit is exceeded it is held, where a multiplier has the wrong sign it is
/// not. If another limit holds the control already, and cannot give way, the
/// path touches the one that is exceeded where it is so most.
///
/// \param exceeded  by more than this
[[nodiscard]] std::optional<ArcsFromA> corrected(const LimitedCurve& curve,
                                                 const std::vector<Arc>& arcs,
                                                 Takeover takeover,
                                                 double exceeded);
/// What polynomials on elements that have not been divided yet may exceed
/// limits by.
inline constexpr double kExceeded = 1e-7;

/// The constraints that stand for what is touched, arc by arc.
[[nodiscard]] std::vector<int> touched_rows(const std::vector<Arc>& arcs,
                                            const LimitedTime& problem);

[[nodiscard]] Mesh mesh_of(const std::vector<Arc>& arcs, int degree);
/// At rest what holds on the first arc, and at the corner.
[[nodiscard]] HeldLimits held_limits(const std::vector<Arc>& arcs,
                                     const std::optional<StartCorner>& corner);

/// Whether slopes at A that are free lead to a kink upwards at rest, where no
/// valley is bounded: the path begins with a free arc, which leaves rest under
/// an angle of its own, and C_A is best above another. Of greatest normal
/// forces the turn per doubling of the length alone is bounded there, so that
/// there is no fastest track.
[[nodiscard]] bool kinks_at_rest(const LimitedCurve& curve,
                                 const std::vector<Arc>& arcs);

/// The same arcs with one before them, along which the limit on forces holds
/// that the static cone at A ends at, if the costates of a free first arc ask
/// for a slope beyond it there: up to where they ask for the slope at A. As
/// long as such an arc is shorter than an element, no limit need be exceeded on
/// it. Nothing if there is none.
[[nodiscard]] std::optional<std::vector<Arc>> held_from_rest(
    const LimitedCurve& curve, const std::vector<Arc>& arcs);

/// The same arcs but that the path turns as fast as humps may until it comes to
/// the limit on forces that the first arc holds from rest on, which friction
/// and a least load make it do from the flatter side, if the static cone at A
/// holds back a free slope that would rather be within it, as the multiplier of
/// what is held at rest says. Nothing if it does not.
[[nodiscard]] std::optional<std::vector<Arc>> turned_from_rest(
    const LimitedCurve& curve, std::vector<Arc> arcs);

/// By how much a condition of optimality fails at the junction behind an arc:
///
/// - between a free arc and one on a limit of the control the slope β less the
///   one that makes 𝓗 minimal: the free arc is singular, with p_β = 0 and
///   ∂𝓗/∂β = 0, and β is continuous. If the junction is misplaced by δ, the
///   rest of the path errs by δ² alone;
/// - between two limits that bound the control from the same side the other
///   limit's distance from its bound, from opposite sides p_β;
/// - where a limit of the place begins to hold, the angle under which the path
///   reaches it; where it ceases to, what a free arc asks for behind it, or
///   p_β if a limit of the control holds there;
/// - where the path touches a limit, by how much that changes along an element.
[[nodiscard]] double junction_residual(const LimitedCurve& curve,
                                       const std::vector<Arc>& arcs,
                                       std::size_t arc);

}  // namespace brachisto
