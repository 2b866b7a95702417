// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "study/in_lanes.hpp"

#include <memory>

#include "lanes/many_scenes.hpp"
#include "math/wall_clock.hpp"
#include "model/scene_checker.hpp"
#include "model/units.hpp"
#include "study/answer_kinds.hpp"

namespace brachisto {

namespace {

bool fits(const SceneToSolve& posed) {
  const auto* program = posed.options.of<Collocation>();
  return program != nullptr && program->in_lanes &&
         posed.options.follows_the_branch() &&
         program->certify == Certify::None &&
         program->sensitivities == SensitivityOrder::None &&
         program->discretisation.formulation == Formulation::RollingTime &&
         !program->discretisation.fixed() && !program->discretisation.degree &&
         lanes::fits(posed.scene) && validate(posed.scene).empty() &&
         // With a warning of more than a turn it is told alone.
         without_whole_turns(posed.scene).body.theta_m ==
             posed.scene.body.theta_m;
}

std::optional<Solution> judged(const SceneToSolve& posed,
                               const lanes::Extremal& extremal) {
  const double wanted =
      posed.options.or_default<Collocation>().discretisation.wanted_tolerance();
  if (!extremal.found || !(extremal.error_estimate <= wanted)) {
    return std::nullopt;
  }
  const PosedScene in_units(posed.scene);
  Solution out;
  out.scene = posed.scene;
  out.options = posed.options;
  out.message = "solved side by side with other scenes";
  out.estimated_error = extremal.error_estimate;
  auto answer = std::make_shared<const Answer>(
      LaneAnswer{{in_units.natural, extremal, posed.scene, in_units.units}});
  const LaneMotion& motion = std::get<LaneAnswer>(*answer).motion;
  out.certificate = certify(motion);
  out.status = Status::Solved;
  out.answer = std::move(answer);
  if (!out.verified()) return std::nullopt;
  out.diagnostics = motion.diagnose();
  if (!out.undecided_because().empty()) return std::nullopt;
  return out;
}

}  // namespace

std::vector<std::optional<Solution>> solve_in_lanes(
    std::span<const SceneToSolve> scenes) {
  const WallClock::time_point begin = WallClock::now();
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    if (!fits(scenes[i])) continue;
    places.push_back(i);
  }
  std::vector<std::optional<Solution>> out(scenes.size());
  if (places.empty()) return out;
  for (const lanes::Fineness& fineness : {lanes::kPlain, lanes::kFine}) {
    std::vector<std::size_t> left;
    std::vector<Scene> tried;
    for (const std::size_t place : places) {
      if (out[place]) continue;
      left.push_back(place);
      tried.push_back(scenes[place].scene);
    }
    const std::vector<lanes::Extremal> found = lanes::shoot(tried, fineness);
    for (std::size_t i = 0; i < left.size(); ++i) {
      out[left[i]] = judged(scenes[left[i]], found[i]);
    }
  }
  const double each = seconds_since(begin) / static_cast<double>(places.size());
  for (const std::size_t place : places) {
    if (out[place]) out[place]->effort.seconds = each;
  }
  return out;
}

}  // namespace brachisto
