// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "proof/arc_chain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "brachisto/study/solve.hpp"
#include "extremal/shooting.hpp"
#include "model/start_under_limits.hpp"
#include "model/units.hpp"
#include "proof/tape.hpp"
#include "study/answer_kinds.hpp"
#include "study/limited_shooting.hpp"

namespace brachisto::proof {

namespace {

using Nodes = std::array<double, kNode>;

/// The order of extremal/arc_flow.hpp, β before the costates, in this one.
Nodes in_order(const ::brachisto::arcs::State& y) {
  namespace a = ::brachisto::arcs;
  Nodes out;
  out[kX] = y[a::kX];
  out[kZ] = y[a::kZ];
  out[kTheta] = y[a::kTheta];
  out[kW] = y[a::kW];
  out[kBeta] = y[a::kBeta];
  out[kPx] = y[a::kPX];
  out[kPz] = y[a::kPZ];
  out[kPtheta] = y[a::kPTheta];
  out[kPw] = y[a::kPW];
  out[kPbeta] = y[a::kPBeta];
  return out;
}

/// Of natural units in SI.
Nodes in_si(Nodes y, const Units& units) {
  y[kX] *= units.length;
  y[kZ] *= units.length;
  y[kW] *= units.speed();
  y[kPx] *= units.time / units.length;
  y[kPz] *= units.time / units.length;
  y[kPtheta] *= units.time;
  y[kPw] *= units.time / units.speed();
  y[kPbeta] *= units.time;
  return y;
}

void add(const Nodes& node, double length, std::vector<Real>& unknowns) {
  for (const double number : node) unknowns.emplace_back(number);
  unknowns.emplace_back(length);
}

/// Refuses a path on both sides of a surface where the field has a kink.
/// \param at  (x, z, θ) at a share of the path
template <class At>
void refuse_passage(const Scene& scene, const At& at) {
  constexpr int kPlaces = 256;
  if (!has_surface(scene.world)) return;
  int outside = 0;
  for (int i = 0; i <= kPlaces; ++i) {
    const auto [x, z, theta] = at(static_cast<double>(i) / kPlaces);
    if (height_of_mass(scene, x, z, theta) > 0.0) ++outside;
  }
  if (outside > 0 && outside <= kPlaces) {
    throw NotProven(
        "nothing is proven where the path crosses the surface of the field, "
        "where that has a kink");
  }
}

NearChain one_free_arc(const Scene& scene) {
  const ExtremalSolution found = solve_extremal(scene);
  if (!found.usable()) throw NotProven("no extremal: " + found.message);
  refuse_passage(scene, [&](double share) {
    const ExtremalState there = found.path.at(share);
    return std::array{there.x, there.z, there.theta};
  });
  const ExtremalState at = found.path.at(0.0);
  NearChain out{{scene, {Held{}}, {false}}, {}};
  Nodes node{};
  node[kX] = at.x;
  node[kZ] = at.z;
  node[kTheta] = scene.body.theta_m;
  node[kW] = at.w;
  node[kBeta] = at.beta;
  node[kPx] = at.p_x;
  node[kPz] = at.p_z;
  node[kPtheta] = scene.body.off_centred() ? at.p_theta : 0.0;
  node[kPw] = at.p_w;
  add(node, found.rolling_time, out.unknowns);
  return out;
}

/// The limits of each arc, in SI, as the program has them in natural units.
std::vector<Held> held_along(const Scene& scene, const std::vector<Arc>& arcs) {
  const std::vector<PathInequality> limits =
      inequalities(scene.body, scene.limits);
  std::vector<Held> out;
  for (const Arc& arc : arcs) {
    Held& held = out.emplace_back();
    if (arc.touch) {
      throw NotProven("a limit is touched while another one holds");
    }
    for (std::size_t i = 0; i < arc.held.size(); ++i) {
      if (arc.held[i] == nlp::Held::No) continue;
      if (held) throw NotProven("two limits hold on one arc");
      held = ::brachisto::arcs::HeldLimit{
          limits[i], arc.held[i] == nlp::Held::AtUpper ? limits[i].upper
                                                       : limits[i].lower};
    }
  }
  return out;
}

/// Whether a limit of the control bounds q from above there.
bool from_above(const Held& held, const Scene& scene, const Nodes& y) {
  TurningPoint<double> place{y[kX], y[kZ], y[kTheta], y[kW], y[kBeta], 0.0};
  const double without = value_of(held->limit, scene, place);
  place.q = 1.0;
  const bool grows = value_of(held->limit, scene, place) > without;
  return grows == held->at_upper();
}

NearChain under_limits(const Scene& scene) {
  const Solution solution = solve(scene);
  const auto* answer = answer_as<LimitedPathAnswer>(solution.answer);
  if (!solution.verified() || answer == nullptr) {
    throw NotProven("no extremal under the limits: " + solution.message);
  }
  if (answer->arcs.empty()) {
    throw NotProven("the answer under the limits has no arcs");
  }
  const LimitedCurve& curve = answer->motion.curve();
  const auto path =
      path_on_arcs(in_natural_units(scene), answer->arcs, answer->ends,
                   *solution.program()->degree, curve.point());
  if (!path) throw NotProven("the arcs of the answer do not fit");
  if (path->ends.corner) throw NotProven("a second limit holds at A");
  NearChain out{{scene, held_along(scene, path->arcs), {}}, {}};
  if (const std::string why = not_of_this_kind(out.chain); !why.empty()) {
    throw NotProven(why);
  }
  const LimitedExtremal found = shoot_over_arcs(*path, {});
  if (!found.solved) throw NotProven("no extremal: " + found.message);
  const Units units = natural_units(scene);
  const auto& stretches = found.path.arcs();
  if (stretches.size() != out.chain.arcs.size()) {
    throw NotProven("the arcs of the answer do not fit");
  }
  for (std::size_t a = 0; a < stretches.size(); ++a) {
    refuse_passage(scene, [&](double share) {
      const auto y = found.path.at(a, share * stretches[a].duration).y;
      namespace n = ::brachisto::arcs;
      return std::array{y[n::kX] * units.length, y[n::kZ] * units.length,
                        y[n::kTheta]};
    });
    Nodes node = in_si(in_order(found.path.at(a, 0.0).y), units);
    if (!along_bound(out.chain.arcs[a])) node[kPbeta] = 0.0;
    add(node, stretches[a].duration * units.time, out.unknowns);
    const Held& here = out.chain.arcs[a];
    const bool both =
        a > 0 && along_bound(here) && along_bound(out.chain.arcs[a - 1]);
    out.chain.opposite.push_back(
        both && from_above(here, scene, node) !=
                    from_above(out.chain.arcs[a - 1], scene, node));
  }
  // What stands in front of a boundary differs by the jump, which Newton's
  // method finds from 0: the equations are linear in it.
  out.unknowns.resize(out.chain.num_unknowns());
  return out;
}

}  // namespace

std::size_t ArcChain::num_unknowns() const {
  std::size_t out = arcs.size() * kPerArc;
  for (std::size_t a = 0; a < arcs.size(); ++a) out += jumps(a) ? 1 : 0;
  return out;
}

std::size_t ArcChain::jump(std::size_t arc) const {
  std::size_t out = arcs.size() * kPerArc;
  for (std::size_t a = 0; a < arc; ++a) out += jumps(a) ? 1 : 0;
  return out;
}

std::vector<double> ArcChain::units() const {
  const Units natural = natural_units(scene);
  Nodes one;
  one.fill(1.0);
  const Nodes node = in_si(one, natural);
  std::vector<double> out;
  for (std::size_t a = 0; a < arcs.size(); ++a) {
    out.insert(out.end(), node.begin(), node.end());
    out.push_back(natural.time);
  }
  out.resize(num_unknowns(), natural.time / natural.length);
  for (double& unit : out) unit = std::exp2(std::round(std::log2(unit)));
  return out;
}

std::vector<std::string> ArcChain::names() const {
  constexpr std::array kNames{"x",       "z",   "theta", "w",      "p_x", "p_z",
                              "p_theta", "p_w", "beta",  "p_beta", "U"};
  static_assert(kNames.size() == kPerArc);
  std::vector<std::string> out;
  for (std::size_t a = 0; a < arcs.size(); ++a) {
    for (const char* name : kNames) {
      out.push_back(fmt::format("{}.{}", a + 1, name));
    }
  }
  for (std::size_t a = 0; a < arcs.size(); ++a) {
    if (jumps(a)) out.push_back(fmt::format("{}.jump", a + 1));
  }
  return out;
}

std::string ArcChain::in_words() const {
  std::string out;
  for (const Held& held : arcs) {
    if (!out.empty()) out += ", ";
    out += held ? name(held->limit.kind) : "free";
  }
  return out;
}

std::string not_of_this_kind(const ArcChain& chain) {
  const Scene& scene = chain.scene;
  const bool rests = scene.world.start_speed == 0.0;
  const Held& first = chain.arcs.front();
  if (first && first->limit.bounds_force() && rests) {
    return "the path leaves rest along a limit of forces, where its curvature "
           "is 0/0";
  }
  if (along_boundary(first)) return "the path starts along a boundary";
  const bool optimal = ::brachisto::arcs::has_optimal_ends(scene);
  if (first && rests && !optimal &&
      !bound_valleys(inequalities(scene.body, scene.limits))) {
    return "the path leaves rest along a hump, with a slope that forces decide";
  }
  if (!first && optimal) return "the path leaves an optimal contact freely";
  if (!along_bound(chain.arcs.back()) &&
      (optimal || scene.contact == Contact::EndSlope)) {
    return "the path arrives at its slope at B freely";
  }
  for (std::size_t a = 1; a < chain.arcs.size(); ++a) {
    const Held &before = chain.arcs[a - 1], &here = chain.arcs[a];
    if (along_boundary(before) && here) {
      return "the path goes from a boundary to another limit";
    }
  }
  return "";
}

NearChain approximate_chain(const Scene& scene) {
  const bool free = !scene.limits.any() && (scene.contact == Contact::Smooth ||
                                            scene.contact == Contact::Centre);
  return free ? one_free_arc(scene) : under_limits(scene);
}

bool same_limit(const PathInequality& a, const PathInequality& b) {
  return a.kind == b.kind && a.lower == b.lower && a.upper == b.upper &&
         a.number == b.number && a.place.x == b.place.x &&
         a.place.z == b.place.z && a.normal.x == b.normal.x &&
         a.normal.z == b.normal.z;
}

Json arcs_json(const ArcChain& chain) {
  const std::vector<PathInequality> limits =
      inequalities(chain.scene.body, chain.scene.limits);
  Json out = Json::array();
  for (std::size_t a = 0; a < chain.arcs.size(); ++a) {
    Json arc = Json::object();
    if (const Held& held = chain.arcs[a]) {
      const auto limit = std::ranges::find_if(limits, [&](const auto& each) {
        return same_limit(each, held->limit);
      });
      arc = {{"holds", name(held->limit.kind)},
             {"limit", limit - limits.begin()},
             {"at", held->at_upper() ? "upper" : "lower"}};
      if (chain.opposite[a]) arc["from_the_other_side"] = true;
    }
    out.push_back(std::move(arc));
  }
  return out;
}

ArcChain chain_from(const Scene& scene, const Json& said) {
  const std::vector<PathInequality> limits =
      inequalities(scene.body, scene.limits);
  ArcChain out{scene, {}, {}};
  for (const Json& arc : said) {
    Held& held = out.arcs.emplace_back();
    if (arc.contains("limit")) {
      const auto i = arc.at("limit").get<std::size_t>();
      if (i >= limits.size()) throw Refused("its arcs are none of its scene");
      held = ::brachisto::arcs::HeldLimit{limits[i], arc.at("at") == "upper"
                                                         ? limits[i].upper
                                                         : limits[i].lower};
      if (!std::isfinite(held->bound)) {
        throw Refused("its arcs are none of its scene");
      }
    }
    out.opposite.push_back(arc.value("from_the_other_side", false));
  }
  if (out.arcs.empty() || !not_of_this_kind(out).empty() ||
      arcs_json(out) != said) {
    throw Refused("its arcs are none of its scene");
  }
  return out;
}

}  // namespace brachisto::proof
