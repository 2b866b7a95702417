// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// An optimal-control problem of anyone: formulas, written once, and what is
/// said of them.

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "brachisto/math/index.hpp"
#include "brachisto/ocp/end_functions.hpp"
#include "brachisto/ocp/least_cost.hpp"
#include "brachisto/posed/statement.hpp"

namespace brachisto::ocp {

/// A place of the path, as formulas see it.
template <class Scalar, std::size_t States, std::size_t Controls,
          std::size_t Parameters>
struct At {
  std::array<Scalar, States> states;
  std::array<Scalar, Controls> controls;
  std::array<Scalar, Parameters> parameters;
};

/// Both ends, as formulas see them.
template <class Scalar, std::size_t States, std::size_t Parameters>
struct AtEnds {
  std::array<Scalar, States> start, end;
  std::array<Scalar, Parameters> parameters;
  Scalar duration;
};

/// What formulas derive from.
template <std::size_t States, std::size_t Controls, std::size_t Parameters = 0>
struct Sizes {
  static_assert(States >= 1 && Controls >= 1);
  static constexpr std::size_t kNumStates = States, kNumControls = Controls,
                               kNumParameters = Parameters;
  template <class Scalar>
  using Point = At<Scalar, States, Controls, Parameters>;
  template <class Scalar>
  using Ends = AtEnds<Scalar, States, Parameters>;
  template <class Scalar>
  using Rates = ocp::Rates<Scalar, States>;
};

/// What the methods ask of a problem, whatever its formulas are. Variables are
/// divided by their scales. Parameters are states that rest.
class Posed {
 public:
  virtual ~Posed() = default;
  [[nodiscard]] virtual const Statement& statement() const = 0;
  /// Of states with parameters, then controls.
  [[nodiscard]] virtual const std::vector<double>& scales() const = 0;
  [[nodiscard]] virtual std::unique_ptr<nlp::Problem> on(
      const Mesh& mesh) const = 0;
  [[nodiscard]] virtual Layout layout(const Mesh& mesh) const = 0;
  /// L, the rates and the limits at states and controls.
  virtual void evaluate(std::span<const double> yu,
                        std::span<double> out) const = 0;
};

/// \throws std::invalid_argument  for options out of their ranges, a control on
///         which nothing depends, and a limit that the given states of an end
///         break; and what a problem's evaluation throws
[[nodiscard]] Answer solve(const Posed& problem, const SolveBy& by = {});

/// Formulas as a description with scales, for LeastCost.
template <class Formulas>
class Scaled {
  static constexpr std::size_t kNumStates = Formulas::kNumStates,
                               kNumParameters = Formulas::kNumParameters;
  template <class Scalar>
  using Point = typename Formulas::template Point<Scalar>;

 public:
  static constexpr std::size_t kStates = kNumStates + kNumParameters,
                               kControls = Formulas::kNumControls;

 private:
  template <class Scalar>
  using Locals = std::array<Scalar, kStates + kControls>;
  static consteval std::size_t count_limits() {
    if constexpr (requires(const Formulas& f, const Point<double>& p) {
                    f.limits(p);
                  }) {
      return std::tuple_size_v<decltype(std::declval<const Formulas&>().limits(
          std::declval<Point<double>>()))>;
    }
    return 0;
  }
  static consteval std::size_t count_conditions() {
    using Ends = typename Formulas::template Ends<double>;
    if constexpr (requires(const Formulas& f, const Ends& e) {
                    f.end_conditions(e);
                  }) {
      return std::tuple_size_v<
          decltype(std::declval<const Formulas&>().end_conditions(
              std::declval<Ends>()))>;
    }
    return 0;
  }

 public:
  static constexpr std::size_t kLimits = count_limits(),
                               kEndConditions = count_conditions();

  Scaled(Formulas formulas, const Statement& statement,
         const std::vector<double>& scales)
      : formulas_(std::move(formulas)), said_(&statement) {
    std::ranges::copy(scales, scales_.begin());
  }

  template <class Scalar>
  [[nodiscard]] Rates<Scalar, kStates> rates(const Locals<Scalar>& yu) const {
    const auto rates = formulas_.rates(unscaled(yu));
    Rates<Scalar, kStates> out;
    out.cost = rates.cost;
    for (std::size_t i = 0; i < kNumStates; ++i) {
      out.states[i] = rates.states[i] * Scalar(1.0 / scales_[i]);
    }
    for (std::size_t i = kNumStates; i < kStates; ++i) {
      out.states[i] = Scalar(0.0);
    }
    return out;
  }

  [[nodiscard]] std::size_t num_limits() const { return kLimits; }
  template <class Scalar>
  [[nodiscard]] Scalar limit(std::size_t i, const Locals<Scalar>& yu) const {
    if constexpr (kLimits > 0) return formulas_.limits(unscaled(yu))[i];
    return Scalar(0.0);
  }
  template <class Scalar, class Asked, class Put>
  void each_limit(const Locals<Scalar>& yu, Asked&& /*asked*/,
                  Put&& put) const {
    if constexpr (kLimits > 0) {
      const auto all = formulas_.limits(unscaled(yu));
      for (std::size_t i = 0; i < kLimits; ++i) put(i, all[i]);
    }
  }
  [[nodiscard]] Bounds bounds(std::size_t i) const {
    return {said_->limits[i].lower, said_->limits[i].upper};
  }
  [[nodiscard]] std::string_view limit_name(std::size_t i) const {
    return said_->limits[i].name;
  }
  [[nodiscard]] std::string_view state_name(std::size_t i) const {
    return i < kNumStates ? said_->states[i].name
                          : said_->parameters[i - kNumStates].name;
  }
  [[nodiscard]] std::string_view control_name(std::size_t i) const {
    return said_->controls[i].name;
  }

  template <class Scalar>
  [[nodiscard]] Scalar end_cost(const EndPoints<Scalar, kStates>& ends) const {
    if constexpr (requires { formulas_.end_cost(unscaled(ends)); }) {
      return formulas_.end_cost(unscaled(ends));
    }
    return Scalar(0.0);
  }
  template <class Scalar>
  [[nodiscard]] std::array<Scalar, kEndConditions> end_conditions(
      const EndPoints<Scalar, kStates>& ends) const {
    if constexpr (kEndConditions > 0) {
      return formulas_.end_conditions(unscaled(ends));
    }
    return {};
  }
  [[nodiscard]] Bounds end_bounds(std::size_t i) const {
    return {said_->end_conditions[i].lower, said_->end_conditions[i].upper};
  }
  [[nodiscard]] std::string_view end_name(std::size_t i) const {
    return said_->end_conditions[i].name;
  }

 private:
  template <class Scalar>
  [[nodiscard]] Point<Scalar> unscaled(const Locals<Scalar>& yu) const {
    Point<Scalar> out;
    const auto value = [&](std::size_t i) {
      return yu[i] * Scalar(scales_[i]);
    };
    for (std::size_t i = 0; i < kNumStates; ++i) out.states[i] = value(i);
    for (std::size_t i = 0; i < kNumParameters; ++i) {
      out.parameters[i] = value(kNumStates + i);
    }
    for (std::size_t i = 0; i < kControls; ++i) {
      out.controls[i] = value(kStates + i);
    }
    return out;
  }
  template <class Scalar>
  [[nodiscard]] auto unscaled(const EndPoints<Scalar, kStates>& ends) const {
    typename Formulas::template Ends<Scalar> out;
    for (std::size_t i = 0; i < kNumStates; ++i) {
      out.start[i] = ends.start[i] * Scalar(scales_[i]);
      out.end[i] = ends.end[i] * Scalar(scales_[i]);
    }
    for (std::size_t i = 0; i < kNumParameters; ++i) {
      out.parameters[i] =
          ends.end[kNumStates + i] * Scalar(scales_[kNumStates + i]);
    }
    out.duration = ends.duration;
    return out;
  }

  Formulas formulas_;
  const Statement* said_;
  std::array<double, kStates + kControls> scales_{};
};

/// Minimise ∫ L dt + φ subject to y' = f, bounds, limits and conditions of the
/// ends. `Formulas` derive from Sizes and have
///
/// - `rates(point)`: {L, f};
/// - and may have `limits(point)`, an array; `end_cost(ends)`; and
///   `end_conditions(ends)`, an array,
///
/// each a template in the scalar, made of + − × /, sin, cos, sqrt, exp, log and
/// atan. What depends on time has the time among its states: t' = 1.
template <class Formulas>
class Problem final : public Posed {
  using Description = Scaled<Formulas>;

 public:
  static constexpr std::size_t kStates = Description::kStates,
                               kControls = Description::kControls;

  /// \param statement  as many variables and limits as the formulas have
  /// \throws std::invalid_argument  as check() does, and for a wrong number of
  ///         anything
  Problem(Formulas formulas, Statement statement)
      : formulas_(std::move(formulas)), statement_(std::move(statement)) {
    demand("states", statement_.states.size(), Formulas::kNumStates);
    demand("controls", statement_.controls.size(), kControls);
    demand("parameters", statement_.parameters.size(),
           Formulas::kNumParameters);
    demand("limits", statement_.limits.size(), Description::kLimits);
    demand("conditions of the ends", statement_.end_conditions.size(),
           Description::kEndConditions);
    check(statement_);
    scales_ = scales_of(statement_);
  }

  [[nodiscard]] const Statement& statement() const override {
    return statement_;
  }
  [[nodiscard]] const std::vector<double>& scales() const override {
    return scales_;
  }
  [[nodiscard]] Answer solve(const SolveBy& by = {}) const {
    return ocp::solve(*this, by);
  }

  [[nodiscard]] std::unique_ptr<nlp::Problem> on(
      const Mesh& mesh) const override {
    return std::make_unique<LeastCost<Description>>(description(), mesh, ends(),
                                                    box());
  }
  [[nodiscard]] Layout layout(const Mesh& mesh) const override {
    return {mesh.num_points(),
            {},
            static_cast<int>(kStates),
            static_cast<int>(kControls),
            static_cast<int>(kStates + Description::kLimits)};
  }
  void evaluate(std::span<const double> yu,
                std::span<double> out) const override {
    std::array<double, kStates + kControls> point{};
    std::ranges::copy(yu, point.begin());
    const Description description = this->description();
    const auto rates = description.rates(point);
    out[0] = rates.cost;
    std::ranges::copy(rates.states, out.begin() + 1);
    for (std::size_t i = 0; i < Description::kLimits; ++i) {
      out[1 + kStates + i] = description.limit(i, point);
    }
  }
  /// The formulas with their scales, for programs of one's own.
  [[nodiscard]] Description description() const {
    return {formulas_, statement_, scales_};
  }

 private:
  void demand(const char* what, std::size_t said, std::size_t wanted) const {
    if (said == wanted) return;
    throw std::invalid_argument(statement_.name + ": the formulas have " +
                                std::to_string(wanted) + " " + what + ", but " +
                                std::to_string(said) + " are stated");
  }
  [[nodiscard]] ocp::Ends<kStates> ends() const {
    ocp::Ends<kStates> out;
    for (std::size_t i = 0; i < Formulas::kNumStates; ++i) {
      const Variable& state = statement_.states[i];
      if (state.start) out.start[i] = *state.start / scales_[i];
      if (state.end) out.end[i] = *state.end / scales_[i];
    }
    const Duration& duration = statement_.duration;
    if (duration.lower == duration.upper) out.duration = duration.lower;
    return out;
  }
  [[nodiscard]] Box<kStates, kControls> box() const {
    Box<kStates, kControls> out;
    const auto scaled = [&](const Variable& variable, std::size_t i) {
      return Bounds{variable.lower / scales_[i], variable.upper / scales_[i]};
    };
    for (std::size_t i = 0; i < kStates; ++i) {
      out.states[i] =
          i < Formulas::kNumStates
              ? scaled(statement_.states[i], i)
              : scaled(statement_.parameters[i - Formulas::kNumStates], i);
    }
    for (std::size_t i = 0; i < kControls; ++i) {
      out.controls[i] = scaled(statement_.controls[i], kStates + i);
    }
    out.duration = {statement_.duration.lower, statement_.duration.upper};
    return out;
  }

  Formulas formulas_;
  Statement statement_;
  std::vector<double> scales_;
};

}  // namespace brachisto::ocp
