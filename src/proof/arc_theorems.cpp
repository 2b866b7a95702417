// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "proof/arc_theorems.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <string_view>

#include "extremal/arc_boundary.hpp"

namespace brachisto::proof {

namespace {

/// An arc of an extremal, whose ends are enclosed.
struct ShownArc {
  const ArcChain& chain;
  const Equations& equations;
  std::size_t number;
  State start, end;
  Real length;
  Real jump;  ///< of the costates in front of it, along the normal

  [[nodiscard]] const Held& held() const { return chain.arcs[number]; }
  [[nodiscard]] const Held* before() const {
    return number > 0 ? &chain.arcs[number - 1] : nullptr;
  }
  [[nodiscard]] const Held* behind() const {
    return number + 1 < chain.arcs.size() ? &chain.arcs[number + 1] : nullptr;
  }
  /// In messages; 0 of a single one.
  [[nodiscard]] std::size_t told() const {
    return chain.arcs.size() > 1 ? number + 1 : 0;
  }
  [[nodiscard]] bool leaves_rest() const {
    return number == 0 && chain.scene.world.start_speed == 0.0;
  }
  /// Whether R_n is 0 where it starts: where a free path leaves rest, and where
  /// R_n is held there.
  [[nodiscard]] bool weightless() const { return leaves_rest() && !held(); }
};

/// Whether a curvature is held from rest on: q is 0 there as w is.
bool bent_from_rest(const ShownArc& arc) {
  return arc.leaves_rest() && along_bound(arc.held()) &&
         !arc.held()->limit.bounds_force();
}

/// How often a function of u vanishes at an end of its arc: so often u, counted
/// from there, is divided out.
struct Zeros {
  int at_start = 0, at_end = 0;
};

/// Whether a function is positive between the ends of an arc: from both of them
/// to the middle.
///
/// \param value  of a step, with how often u is divided out of it
using Along = std::function<Real(const Step&, const Real& u, int drop)>;
void positive_within(const ShownArc& arc, const Accuracy& accuracy, Zeros zeros,
                     const Along& value, std::string_view what,
                     Theorem& theorem) {
  const Real half = (arc.length * Real(0x1p-1)).middle();
  for (const bool backward : {false, true}) {
    bool first = true;
    State state = backward ? arc.end : arc.start;
    Integration flow(arc.equations.tape, arc.equations.rates, accuracy);
    flow.go(state, backward ? arc.length - half : half, backward,
            [&](const Step& step) {
              const int drop = !first     ? 0
                               : backward ? zeros.at_end
                                          : zeros.at_start;
              // What is left of u < 0 is of the other sign if that is odd.
              const Real sign(backward && drop % 2 == 1 ? -1.0 : 1.0);
              Real where;
              const Sign shown = sign_along(
                  Real(0.0), backward ? -step.length : step.length,
                  [&](const Real& u) { return sign * value(step, u, drop); },
                  where);
              const double u = step.begin + std::fabs(where.near());
              theorem.meet(shown, what, backward ? arc.length.near() - u : u,
                           arc.told());
              first = false;
            });
  }
}

/// How a limit's distance from a bound vanishes where its boundary begins or
/// ends: like u², for the path touches it. Where a bend is held from rest on,
/// that of the other bend is 0 at rest as well, like w. Where rest is left
/// freely R_n is.
Zeros touches(const ShownArc& arc, const PathInequality& limit, double bound) {
  using Kind = PathInequality::Kind;
  const bool bends = limit.kind == Kind::Hump || limit.kind == Kind::Valley;
  if (bends && bent_from_rest(arc)) return {1, 0};
  if (limit.kind == Kind::NormalForce && bound == 0.0 && arc.weightless()) {
    return {1, 0};
  }
  const auto at = [&](const Held* other, std::size_t junction) {
    if (other == nullptr || !*other || (*other)->bound != bound ||
        !same_limit((*other)->limit, limit)) {
      return 0;
    }
    if (along_boundary(*other)) return 2;
    // Of one side the second holds already where the first one ends.
    return along_bound(arc.held()) && !arc.chain.opposite[junction] ? 1 : 0;
  };
  return {at(arc.before(), arc.number), at(arc.behind(), arc.number + 1)};
}

void keeps_limits(const ShownArc& arc, const Accuracy& accuracy,
                  Theorem& theorem) {
  const Scene& scene = arc.chain.scene;
  const std::vector<PathInequality> limits =
      inequalities(scene.body, scene.limits);
  const auto holds = [&](const PathInequality& limit, double bound) {
    const Held& held = arc.held();
    return held && held->bound == bound && same_limit(held->limit, limit);
  };
  for (std::size_t i = 0; i < limits.size(); ++i) {
    for (const bool upper : {false, true}) {
      const double bound = upper ? limits[i].upper : limits[i].lower;
      if (!std::isfinite(bound) || holds(limits[i], bound)) continue;
      const Node node = arc.equations.limits[i];
      const Real sign(upper ? -1.0 : 1.0);
      const std::string what =
          fmt::format("that the limit {} is kept", name(limits[i].kind));
      positive_within(
          arc, accuracy, touches(arc, limits[i], bound),
          [&](const Step& step, const Real& u, int drop) {
            return sign * step.value(node, u, drop, bound);
          },
          what, theorem);
    }
  }
}

/// p_β vanishes with its rate where a free arc is next, and by itself at A and
/// B, where the control goes from one side to the other, and in front of a
/// boundary, where h_β = 0 holds behind the jump alone.
Zeros zeros_of_costate(const ShownArc& arc) {
  const bool optimal = ::brachisto::arcs::has_optimal_ends(arc.chain.scene);
  const auto at = [&](const Held* other, std::size_t junction) {
    if (other == nullptr) return optimal ? 0 : 1;
    if (!*other) return 2;
    if (along_boundary(*other)) return 1;
    return arc.chain.opposite[junction] ? 1 : 0;
  };
  Zeros out{at(arc.before(), arc.number), at(arc.behind(), arc.number + 1)};
  if (arc.behind() == nullptr && arc.chain.scene.contact == Contact::EndSlope) {
    out.at_end = 0;
  }
  return out;
}

void has_its_sign(const ShownArc& arc, const Accuracy& accuracy,
                  Theorem& theorem) {
  if (!arc.held() || theorem.refuted) return;
  const Node multiplier = arc.equations.multiplier;
  // ≤ 0 at a lower bound.
  const Real sign(arc.held()->at_upper() ? 1.0 : -1.0);
  constexpr const char* kWhat = "that a multiplier has its sign";
  if (along_boundary(arc.held())) {
    if (arc.chain.jumps(arc.number)) {
      // The multiplier of c gathers in a point: p' = −h_y − μ n, p⁺ = p⁻ + J n.
      const Real gathered = -sign * arc.jump;
      theorem.meet(gathered.positive()      ? Sign::Positive
                   : (-gathered).positive() ? Sign::Refuted
                                            : Sign::Unknown,
                   "that the jump of the costates has its sign", 0.0,
                   arc.told());
    }
    positive_within(
        arc, accuracy, {},
        [&](const Step& step, const Real& u, int) {
          return sign * step.value(multiplier, u);
        },
        kWhat, theorem);
    return;
  }
  // μ = −p_β/c_q, and c_q, which is divided by, does not vanish.
  State middle = arc.start;
  Integration flow(arc.equations.tape, arc.equations.rates, accuracy);
  flow.go(middle, (arc.length * Real(0x1p-1)).middle());
  const Real mu = arc.equations.tape.values(
      middle)[static_cast<std::size_t>(multiplier.id)];
  const Real side(middle[kPbeta].positive() ? 1.0 : -1.0);
  if (!(sign * mu).positive()) {
    theorem.meet((-sign * mu).positive() ? Sign::Refuted : Sign::Unknown, kWhat,
                 arc.length.near() / 2.0, arc.told());
    return;
  }
  positive_within(
      arc, accuracy, zeros_of_costate(arc),
      [&](const Step& step, const Real& u, int drop) {
        return side * step.value(kPbeta, u, drop);
      },
      kWhat, theorem);
}

void physics(const ShownArc& arc, const Accuracy& accuracy, ArcTheorems& out) {
  const Equations& equations = arc.equations;
  const auto check = [&](Theorem& theorem, const char* what, Zeros zeros,
                         const Node& node) {
    positive_within(
        arc, accuracy, zeros,
        [&](const Step& step, const Real& u, int drop) {
          return step.value(node, u, drop);
        },
        what, theorem);
  };
  if (!along_bound(arc.held())) {
    check(out.legendre, "h_ββ > 0", {}, equations.legendre);
  }
  if (arc.held() &&
      arc.held()->limit.kind == PathInequality::Kind::NormalForce) {
    out.presses.meet(arc.held()->bound > 0.0 ? Sign::Positive : Sign::Refuted,
                     "R_n > 0", arc.length.near() / 2.0, arc.told());
  } else {
    check(out.presses, "R_n > 0", {arc.weightless() ? 1 : 0, 0},
          equations.normal);
  }
  // Of a bead it is 1.
  const bool at_rest = arc.chain.scene.body.rolls() && bent_from_rest(arc);
  check(out.no_fold, "r κ_c < 1", {at_rest ? 1 : 0, 0}, equations.unfolded);
  const Real pi = Real::pi();
  positive_within(
      arc, accuracy, {},
      [&](const Step& step, const Real& u, int) {
        return pi - step.value(kBeta, u).abs();
      },
      "|β| < π", out.no_loop);
}

State components(const Vector& found, std::size_t arc) {
  State out(kComponents);
  for (std::size_t i = 0; i < kNode; ++i) {
    out[i] = found[ArcChain::node(arc) + i];
  }
  return out;
}

ShownArc arc_of(const ArcSystem& system, const Root& root, std::size_t a) {
  return {
      system.chain(),
      system.plain(a),
      a,
      components(root.found, a),
      root.ends[a],
      root.found[ArcChain::length(a)],
      system.chain().jumps(a) ? root.found[system.chain().jump(a)] : Real(0.0)};
}

}  // namespace

void stays_on_its_side(const ArcSystem& system, const Root& root,
                       const Accuracy& accuracy) {
  const Bits bits(accuracy.bits);
  const Scene own = in_own_units(system.chain().scene);
  if (!own.world.side) return;
  const Real sign(*own.world.side == FieldSide::Outside ? 1.0 : -1.0);
  // Of all that start in the box: that one of them alone solves the equations
  // is said of the field as it is.
  for (std::size_t a = 0; a < root.ends.size(); ++a) {
    const Equations& equations = system.plain(a);
    State state = components(root.searched, a);
    Integration flow(equations.tape, equations.rates, accuracy);
    flow.go(state, root.searched[ArcChain::length(a)], false,
            [&](const Step& step) {
              Real where;
              const Sign shown = sign_along(
                  Real(0.0), step.length,
                  [&](const Real& u) {
                    return sign * step.value(equations.height, u);
                  },
                  where);
              if (shown == Sign::Positive) return;
              throw NotProven(
                  "the path meets the surface of the field, where that has a "
                  "kink");
            });
  }
}

Enclosures enclosures_of(const ArcChain& chain, const Root& root) {
  const Scene& scene = chain.scene;
  Real time, length;
  for (const State& end : root.ends) {
    time += end[kTime];
    length += end[kLength];
  }
  const Real H(scene.H);
  return {time * sqrt(Real(2.0) * Real(scene.gravity) / H), root.found[kBeta],
          root.ends.back()[kBeta], length / H,
          root.ends.back()[kTheta] - Real(scene.body.theta_m)};
}

FreeExtremal as_free(const ArcChain& chain, const Root& root) {
  FreeExtremal out;
  out.start = components(root.found, 0);
  out.length = root.found[ArcChain::length(0)];
  out.end = root.ends.front();
  out.enclosed = enclosures_of(chain, root);
  out.per_H = Real(1.0) / Real(chain.scene.H);
  out.rests = chain.scene.world.start_speed == 0.0;
  return out;
}

Theorem prove_limits(const ArcSystem& system, const Root& root,
                     const Accuracy& accuracy) {
  const Bits bits(accuracy.bits);
  Theorem out{.holds = true};
  for (std::size_t a = 0; a < system.chain().arcs.size(); ++a) {
    keeps_limits(arc_of(system, root, a), accuracy, out);
  }
  return out;
}

ArcTheorems prove_arc_theorems(const ArcSystem& system, const Root& root,
                               const Accuracy& accuracy) {
  const Bits bits(accuracy.bits);
  const ArcChain& chain = system.chain();
  ArcTheorems out;
  for (Theorem* each : {&out.legendre, &out.multipliers, &out.presses,
                        &out.no_fold, &out.no_loop}) {
    each->holds = true;
  }
  out.enclosed = enclosures_of(chain, root);
  const Real H(chain.scene.H);
  const Real per_time = sqrt(Real(2.0) * Real(chain.scene.gravity) / H);
  Real time;
  out.keeps = prove_limits(system, root, accuracy);
  for (std::size_t a = 0; a < chain.arcs.size(); ++a) {
    const ShownArc arc = arc_of(system, root, a);
    has_its_sign(arc, accuracy, out.multipliers);
    physics(arc, accuracy, out);
    time += arc.end[kTime];
    if (a + 1 < chain.arcs.size()) {
      out.junctions.push_back({arc.end[kX] / H, time * per_time});
    }
  }
  return out;
}

}  // namespace brachisto::proof
