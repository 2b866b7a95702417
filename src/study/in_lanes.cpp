// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "study/in_lanes.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>

#include "lanes/many_scenes.hpp"
#include "math/wall_clock.hpp"
#include "model/scene_checker.hpp"
#include "model/units.hpp"
#include "study/answer.hpp"
#include "study/answer_kinds.hpp"
#include "trajectory/stated_limits.hpp"

namespace brachisto {

namespace {

/// For less of T own solves have first derivatives with more digits than lanes:
/// see LaneRates.
constexpr double kLeastOfRates = 1e-11;

/// What is asked of an extremal.
enum class Asked { Certificate, Estimate };

Scene within_no_limits(Scene scene) {
  scene.limits = {};
  return scene;
}

/// Under limits the motion has to be known, and its derivatives are those of
/// arcs.
bool limits_fit(const SceneToSolve& posed, Asked asked) {
  return !posed.scene.limits.any() ||
         (asked == Asked::Certificate &&
          posed.options.or_default<Collocation>().sensitivities ==
              SensitivityOrder::None);
}

bool fits(const SceneToSolve& posed, Asked asked) {
  const auto* program = posed.options.of<Collocation>();
  return program != nullptr && program->in_lanes &&
         posed.options.follows_the_branch() &&
         program->certify == Certify::None &&
         program->sensitivities != SensitivityOrder::Second &&
         (program->sensitivities == SensitivityOrder::None ||
          program->discretisation.wanted_tolerance() >= kLeastOfRates) &&
         program->discretisation.formulation == Formulation::RollingTime &&
         !program->discretisation.fixed() && !program->discretisation.degree &&
         lanes::fits(within_no_limits(posed.scene)) &&
         limits_fit(posed, asked) && validate(posed.scene).empty() &&
         // With a warning of more than a turn it is told alone.
         without_whole_turns(posed.scene).body.theta_m ==
             posed.scene.body.theta_m;
}

double wanted(const SceneToSolve& posed) {
  return posed.options.or_default<Collocation>()
      .discretisation.wanted_tolerance();
}

/// By how much the limit is exceeded that is exceeded most, in natural units:
/// less than 0 within all.
double excess(const std::vector<LimitOnPath>& limits, const Scene& scene) {
  const std::vector<StatedLimit> stated = stated_limits(scene);
  double most = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const double here = -limits[i].least_slack * stated[i].natural;
    // In this order no number stays.
    if (std::isnan(here) || here > most) most = here;
  }
  return most;
}

std::optional<Solution> judged(const SceneToSolve& posed,
                               const lanes::Extremal& extremal, Asked asked) {
  if (!extremal.found || !(extremal.error_estimate <= wanted(posed))) {
    return std::nullopt;
  }
  const PosedScene in_units(within_no_limits(posed.scene));
  Solution out;
  out.scene = posed.scene;
  out.options = posed.options;
  out.message = "solved side by side with other scenes";
  out.estimated_error = extremal.error_estimate;
  auto answer = std::make_shared<const Answer>(
      LaneAnswer{{in_units.natural, extremal, posed.scene, in_units.units}});
  const LaneMotion& motion = std::get<LaneAnswer>(*answer).motion;
  out.status = Status::Solved;
  out.answer = std::move(answer);
  if (asked == Asked::Estimate) return out;
  out.certificate = certify(motion);
  if (posed.scene.limits.any()) {
    // Next to a bound it may take arcs, which its own solve has.
    constexpr double kClear = 1e-4;
    out.limits = limits_held_nowhere(motion);
    out.certificate.add("limits", excess(out.limits, posed.scene), -kClear);
  }
  if (!out.verified()) return std::nullopt;
  out.diagnostics = motion.diagnose();
  if (!out.undecided_because().empty()) return std::nullopt;
  if (posed.options.or_default<Collocation>().sensitivities ==
      SensitivityOrder::First) {
    out.sensitivities = sensitivities(out);
    if (!out.sensitivities) return std::nullopt;
  }
  return out;
}

/// How an attempt comes to a scene.
enum class Tried { Another, Same };

/// Scenes with what became of them.
class Batch {
 public:
  Batch(std::span<const SceneToSolve> scenes, Asked asked)
      : scenes_(scenes),
        asked_(asked),
        lost_(scenes.size()),
        out_(scenes.size()) {
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      if (fits(scenes[i], asked)) places_.push_back(i);
    }
  }

  /// Those that nothing is known of yet, as far as this is enough for them and
  /// its way is not the one that they were lost on.
  void attempt(double least_tolerance, Tried how, auto&& shoot) {
    std::vector<std::size_t> left;
    std::vector<Scene> tried;
    for (const std::size_t place : places_) {
      if (out_[place] || wanted(scenes_[place]) < least_tolerance) continue;
      if (lost_[place] && how == Tried::Same) continue;
      left.push_back(place);
      tried.push_back(within_no_limits(scenes_[place].scene));
    }
    if (left.empty()) return;
    const std::vector<lanes::Extremal> found = shoot(tried);
    for (std::size_t i = 0; i < left.size(); ++i) {
      out_[left[i]] = judged(scenes_[left[i]], found[i], asked_);
      lost_[left[i]] = !found[i].found;
    }
  }

  /// \param seconds  that all of them took
  [[nodiscard]] std::vector<std::optional<Solution>> take(double seconds) {
    for (const std::size_t place : places_) {
      if (!out_[place]) continue;
      out_[place]->effort.seconds =
          seconds / static_cast<double>(places_.size());
    }
    return std::move(out_);
  }

 private:
  std::span<const SceneToSolve> scenes_;
  Asked asked_;
  std::vector<std::size_t> places_;  ///< of those that fit
  std::vector<bool> lost_;  ///< without an extremal at the last attempt
  std::vector<std::optional<Solution>> out_;
};

/// From the cycloid.
void solve_anew(Batch& batch) {
  for (const lanes::Fineness& fineness : {lanes::kPlain, lanes::kFine}) {
    batch.attempt(0.0, Tried::Another, [&](const std::vector<Scene>& tried) {
      return lanes::shoot(tried, fineness);
    });
  }
}

}  // namespace

std::vector<std::optional<Solution>> solve_in_lanes(
    std::span<const SceneToSolve> scenes) {
  const WallClock::time_point begin = WallClock::now();
  Batch batch(scenes, Asked::Certificate);
  solve_anew(batch);
  return batch.take(seconds_since(begin));
}

std::vector<std::optional<Solution>> seek_in_lanes(
    std::span<const SceneToSolve> scenes, const Solution* beside) {
  constexpr lanes::Fineness kRough{2, 10, lanes::kPlain.places / 2, 1};
  constexpr double kOfRough = 1e-8;
  constexpr lanes::Fineness kBeside{2, 10, lanes::kPlain.places, 1};
  const WallClock::time_point begin = WallClock::now();
  Batch batch(scenes, Asked::Estimate);
  const auto* known =
      beside == nullptr ? nullptr : answer_as<LaneAnswer>(beside->answer);
  if (known != nullptr) {
    for (const auto& [fineness, least] :
         {std::pair(kRough, kOfRough), std::pair(kBeside, 0.0)}) {
      batch.attempt(least, Tried::Same, [&](const std::vector<Scene>& tried) {
        return lanes::shoot_beside(tried, beside->scene,
                                   *known->motion.extremal(), fineness);
      });
    }
  }
  solve_anew(batch);
  return batch.take(seconds_since(begin));
}

}  // namespace brachisto
