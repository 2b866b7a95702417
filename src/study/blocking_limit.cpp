// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "study/blocking_limit.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

#include "brachisto/model/scene.hpp"
#include "trajectory/stated_limits.hpp"
#include "trajectory/trajectory.hpp"

namespace brachisto {

namespace {

constexpr std::string_view kNoFixedMesh =
    "no fixed mesh (discretisation.elements or nodes)";

/// What was asked for and what came nearest. Next to rest curvatures are those
/// of a quotient 0/0: the first twentieth is left out, as of the free path.
struct Miss {
  const StatedLimit* limit = nullptr;
  double slack = std::numeric_limits<double>::infinity();
  double x = 0.0;         ///< x_b where it is least [m]
  double friction = 0.0;  ///< the largest μ needed; ∞ where R_n ≤ 0
  double x_of_friction = 0.0;
};

Miss worst(const std::vector<StatedLimit>& limits, const LimitedMotion& motion,
           const BlockingLimit& blocking) {
  constexpr double kStart = 0.05;
  const auto& all = blocking.nearest.problem().limits();
  const std::size_t i = blocking.index;
  int index = 0;
  for (std::size_t k = i; k > 0 && all[k - 1].kind == all[i].kind; --k) ++index;
  const double wall_ratio = motion.scene().body.wall_ratio;
  Miss miss;
  for (const StatedLimit& limit : limits) {
    if (!limit.is(all[i].kind, index, true) &&
        !limit.is(all[i].kind, index, false)) {
      continue;
    }
    for (const TrajectoryPoint& at : motion.at_nodes()) {
      if (at.sigma < kStart) continue;
      const double slack = limit.slack(at);
      if (slack < miss.slack) {
        miss.slack = slack;
        miss.x = at.motion.contact.x;
        miss.limit = &limit;
      }
      const double friction =
          at.motion.R_n > 0.0
              ? std::abs(at.motion.R_t) / (wall_ratio * at.motion.R_n)
              : std::numeric_limits<double>::infinity();
      if (friction > miss.friction) {
        miss.friction = friction;
        miss.x_of_friction = at.motion.contact.x;
      }
    }
  }
  return miss;
}

/// A contact whose slopes are free; nothing of a bead.
/// \param more_limits  whether to name what the scene lacks for it too
std::string optimal_contact(const Scene& scene, bool more_limits) {
  if (!scene.body.rolls() || scene.contact != Contact::Smooth) return {};
  Scene optimal = scene;
  optimal.contact = Contact::Optimal;
  if (validate(optimal).empty()) return "contact: optimal";
  return more_limits ? "contact: optimal, with limits.curvature" : "";
}

/// Any of what follows may help, if these limits are in the way.
std::string advice(const Scene& scene,
                   const std::vector<StatedLimit>& in_the_way) {
  bool of_friction = false, of_forces = false;
  std::vector<std::string> ways;
  for (const StatedLimit& limit : in_the_way) {
    ways.push_back(limit.looser);
    of_friction = of_friction || limit.name == "friction";
    of_forces = of_forces || limit.name.starts_with("normal_force");
  }
  if ((of_friction || of_forces) && scene.body.off_centred()) {
    ways.emplace_back("a smaller eta_m");
  }
  if (of_friction) ways.emplace_back("a longer L");
  const std::string optimal = optimal_contact(scene, false);
  if (!optimal.empty()) ways.push_back(optimal);
  return fmt::format("{}", fmt::join(ways, ", "));
}

/// ". The tightest limit is friction: …".
std::string in_words(const PosedProblem& posed, const BlockingLimit& blocking) {
  const LimitedMotion motion(blocking.nearest, posed.asked, posed.units);
  const std::vector<StatedLimit> limits = stated_limits(posed.asked);
  const Miss miss = worst(limits, motion, blocking);
  if (miss.limit == nullptr) return {};
  const StatedLimit& limit = *miss.limit;
  const bool of_friction = limit.name == "friction";
  std::string text = fmt::format(". The tightest limit is {}", limit.name);
  if (of_friction && miss.friction > *limit.bound) {
    text += fmt::format(
        ": {:.6g} is asked for, and the path that came nearest {} "
        "at x_b = {:.3g} m",
        *limit.bound,
        std::isfinite(miss.friction)
            ? fmt::format("needs {:.3g}", miss.friction)
            : "lifts off",
        miss.x_of_friction);
  } else if (!of_friction && miss.slack < 0.0) {
    const std::string_view unit = limit.words ? limit.words->unit : "m";
    text += fmt::format(
        "{}, which the path that came nearest violates by "
        "{:.3g}{}{} at x_b = {:.3g} m",
        limit.bound ? fmt::format(": {:.6g}{}{}", *limit.bound,
                                  unit.empty() ? "" : " ", unit)
                    : "",
        -miss.slack, unit.empty() ? "" : " ", unit, miss.x);
  }
  return text + ". To try: " + advice(posed.asked, {limit});
}

}  // namespace

std::string looser_limits(const Scene& asked) {
  const std::vector<StatedLimit> limits = stated_limits(asked);
  if (limits.empty()) return {};
  return advice(asked, limits);
}

std::string advice_without_answer(const PosedProblem& posed,
                                  const LimitedRefinement& refinement) {
  std::string text;
  if (refinement.blocking) {
    text = in_words(posed, *refinement.blocking);
  } else if (refinement.status == Status::NoSmoothContact) {
    const std::string optimal = optimal_contact(posed.asked, true);
    if (!optimal.empty()) text = ". To try: " + optimal;
  } else if (refinement.status == Status::NotConverged ||
             refinement.status == Status::NoAdmissiblePath) {
    std::string ways = looser_limits(posed.asked);
    // A mesh that is given may be too coarse for where limits begin to hold.
    if (refinement.status == Status::NotConverged &&
        posed.program.discretisation.fixed()) {
      ways =
          fmt::format("{}{}{}", kNoFixedMesh, ways.empty() ? "" : ", ", ways);
    }
    if (!ways.empty()) text = ". To try: " + ways;
  }
  if (refinement.tried.empty() || (refinement.status != Status::NotConverged &&
                                   refinement.status != Status::Infeasible)) {
    return text;
  }
  return text + fmt::format(". A path was looked for {}",
                            fmt::join(refinement.tried, ", "));
}

}  // namespace brachisto
