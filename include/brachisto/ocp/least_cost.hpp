// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The least cost of a described problem between given ends, as a nonlinear
/// program.

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "brachisto/math/index.hpp"
#include "brachisto/nlp/problem.hpp"
#include "brachisto/ocp/collocation.hpp"
#include "brachisto/ocp/end_functions.hpp"
#include "brachisto/ocp/mesh.hpp"
#include "brachisto/ocp/point_function.hpp"
#include "brachisto/ocp/program.hpp"

namespace brachisto::ocp {

/// What is given at the ends of the way; nothing: free.
template <std::size_t States>
struct Ends {
  std::array<std::optional<double>, States> start, end;
  /// U, how far s runs in y' = dy/ds.
  std::optional<double> duration;
};

/// Between what states stay all along, and controls, and U.
template <std::size_t States, std::size_t Controls>
struct Box {
  std::array<Bounds, States> states = filled<States>();
  std::array<Bounds, Controls> controls = filled<Controls>();
  Bounds duration{0.0, std::numeric_limits<double>::infinity()};

 private:
  template <std::size_t Size>
  static constexpr std::array<Bounds, Size> filled() {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    std::array<Bounds, Size> out{};
    out.fill({-kNone, kNone});
    return out;
  }
};

/// A place of an answer.
template <std::size_t States>
struct PathPlace {
  double s;
  std::array<double, States> states;
  /// What the least cost to go changes by with each state.
  std::array<double, States> costates;
  double control;
};

/// Radau IIA collocation of
///
///     minimise ∫₀ᵁ L(y, u) ds + φ(y(0), y(U), U)  subject to
///     y' = f(y, u),  lower ≤ c(y, u) ≤ upper,  lower ≤ ψ(y(0), y(U), U) ≤
///     upper,
///
/// states given or free at the ends, U > 0 as well, states and controls within
/// a box. Limits and the box are asked for at the collocation points.
template <ControlProblem Description>
class LeastCost final : public Program {
 public:
  static constexpr std::size_t kStates = Description::kStates;
  static constexpr std::size_t kControls = num_controls<Description>();
  static_assert(kStates >= 1 && kStates <= std::size_t{Layout::kMostStates});

  /// \throws std::invalid_argument for a degree that is not 1 … kLargestDegree,
  ///         boundaries that do not ascend from 0 to 1, a duration that is not
  ///         positive and finite, an end that is not finite, and bounds of
  ///         which the upper one is the smaller
  LeastCost(Description description, const Mesh& mesh,
            const Ends<kStates>& ends, const Box<kStates, kControls>& box = {});

  [[nodiscard]] const Description& description() const {
    return collocation_.description();
  }
  [[nodiscard]] const Layout& layout() const { return collocation_.layout(); }
  /// States straight from end to end, a free one as at the other end, controls
  /// 0, without multipliers.
  ///
  /// \param duration  U where it is free
  [[nodiscard]] PrimalDual straight_guess(double duration = 1.0) const;

  /// The start and each collocation point. Costates are −λ/b there and follow
  /// from the multipliers of the first element at the start, where the control
  /// is extrapolated; NaN without multipliers.
  ///
  /// \throws std::invalid_argument for a point of another program
  [[nodiscard]] std::vector<PathPlace<kStates>> path(
      const PrimalDual& point) const requires(kControls == 1);

  /// Within the box, unless it is given. Bounds of limits are asked of the
  /// description each time.
  [[nodiscard]] nlp::Range variable_range(int index) const override;
  [[nodiscard]] nlp::Range constraint_range(int index) const override;
  [[nodiscard]] double weight(int index) const override {
    return element_weight(layout(), collocation_.scheme(), mesh(), index);
  }
  /// None where the ends of the path are coupled by a condition.
  [[nodiscard]] nlp::ChainStructure chain_structure() const override;
  /// "v[3]", "U"; of a control "h u[3]", h being the length of an element of
  /// the mesh.
  [[nodiscard]] std::string variable_name(int index) const override;
  /// "defect of v[3]", "thrust[3]".
  [[nodiscard]] std::string constraint_name(int index) const override;

 private:
  [[nodiscard]] static Layout layout_of(const Description& description,
                                        const Mesh& mesh) {
    const int states = static_cast<int>(kStates);
    return {mesh.num_points(),
            {},
            states,
            static_cast<int>(kControls),
            states + static_cast<int>(description.num_limits())};
  }
  [[nodiscard]] static const Mesh& checked(const Mesh& mesh);
  [[nodiscard]] double duration() const { return x(layout().last()); }

  bool evaluate() override;
  [[nodiscard]] double do_eval_f() const override {
    return collocation_.objective(mesh(), duration()) + ends_.cost();
  }
  void do_eval_grad_f(std::span<double> grad_f) const override {
    collocation_.put_gradient(mesh(), duration(), grad_f);
    ends_.add_gradient(grad_f);
  }
  void do_eval_g(std::span<double> g) const override {
    collocation_.put_constraints(x(), mesh(), g);
    ends_.put_conditions(g);
  }
  void put_jac_g(Entries& put) const override {
    collocation_.put_jac_g(mesh(), duration(), put);
    ends_.put_jac_g(put);
  }
  void put_hess_lag(double objective_factor, std::span<const double> lambda,
                    Entries& put) const override {
    collocation_.put_hess_lag(mesh(), duration(), objective_factor, lambda,
                              put);
    ends_.put_hess_lag(objective_factor, lambda, put);
  }

  Collocation<Description> collocation_;
  EndFunctions<Description> ends_;
  Box<kStates, kControls> box_;
};

template <ControlProblem Description>
LeastCost<Description>::LeastCost(Description description, const Mesh& mesh,
                                  const Ends<kStates>& ends,
                                  const Box<kStates, kControls>& box)
    : Program(checked(mesh), layout_of(description, mesh).num_variables(),
              layout_of(description, mesh).end_of_points() +
                  EndFunctions<Description>::kConditions,
              "collocation point"),
      collocation_(description, radau_scheme(mesh.degree),
                   layout_of(description, mesh)),
      ends_(collocation_.description(), layout()),
      box_(box) {
  const int last = layout().num_points();
  for (std::size_t s = 0; s < kStates; ++s) {
    const int state = static_cast<int>(s);
    for (const auto& end : {ends.start[s], ends.end[s]}) {
      if (!std::isfinite(end.value_or(0.0))) {
        throw std::invalid_argument("an end of " +
                                    std::string(description.state_name(s)) +
                                    " is not finite");
      }
    }
    if (ends.start[s]) fix(layout().state(0, state), *ends.start[s]);
    if (ends.end[s]) fix(layout().state(last, state), *ends.end[s]);
  }
  if (ends.duration) {
    if (!(*ends.duration > 0.0) || std::isinf(*ends.duration)) {
      throw std::invalid_argument("the duration is not positive and finite");
    }
    fix(layout().last(), *ends.duration);
  }
  for (int i = 0; i < layout().num_limits(); ++i) {
    const Bounds bounds = description.bounds(at(i));
    if (!(bounds.lower <= bounds.upper)) {
      throw std::invalid_argument("the bounds of " +
                                  std::string(description.limit_name(at(i))) +
                                  " leave nothing between them");
    }
  }
  build_patterns();
}

template <ControlProblem Description>
nlp::Range LeastCost<Description>::variable_range(int index) const {
  const nlp::Range given = Program::variable_range(index);
  if (given.single()) return given;
  const auto within = [](const Bounds& bounds, double unit = 1.0) {
    return nlp::Range{unit * bounds.lower, unit * bounds.upper};
  };
  if (index == layout().last()) return within(box_.duration);
  const std::size_t place = at(index % layout().stride());
  if (place < kStates) return within(box_.states[place]);
  return within(box_.controls[place - kStates],
                mesh().length(layout().node_of(index) / mesh().degree));
}

template <ControlProblem Description>
nlp::Range LeastCost<Description>::constraint_range(int index) const {
  const auto range = [](const Bounds& bounds) {
    return nlp::Range{bounds.lower, bounds.upper};
  };
  if (index >= layout().end_of_points()) {
    if constexpr (EndFunctions<Description>::kConditions > 0) {
      return range(description().end_bounds(at(index - ends_.row(0))));
    }
  }
  const int limit = layout().limit_of(index);
  return limit < 0 ? nlp::Range{} : range(description().bounds(at(limit)));
}

template <ControlProblem Description>
nlp::ChainStructure LeastCost<Description>::chain_structure() const {
  if (ends_.couple()) return {};
  nlp::ChainStructure chain = element_chain(layout(), mesh(), num_constraints(),
                                            collocation_.limits_of_control());
  for (int i = 0; i < EndFunctions<Description>::kConditions; ++i) {
    chain.block[at(num_variables() + ends_.row(i))] =
        ends_.is_of_start(i) ? 0 : 2 * mesh().num_elements();
  }
  return chain;
}

template <ControlProblem Description>
const Mesh& LeastCost<Description>::checked(const Mesh& mesh) {
  if (mesh.degree < 1 || mesh.degree > kLargestDegree) {
    throw std::invalid_argument("the degree of a mesh is 1 to " +
                                std::to_string(kLargestDegree));
  }
  const std::vector<double>& all = mesh.boundaries;
  const auto descends = [](double a, double b) { return !(a < b); };
  if (all.size() < 2 || all.front() != 0.0 || all.back() != 1.0 ||
      std::ranges::adjacent_find(all, descends) != all.end()) {
    throw std::invalid_argument(
        "the boundaries of a mesh do not ascend from 0 to 1");
  }
  return mesh;
}

template <ControlProblem Description>
PrimalDual LeastCost<Description>::straight_guess(double duration) const {
  PrimalDual guess;
  guess.x.assign(at(num_variables()), 0.0);
  const nlp::Range given_duration = variable_range(layout().last());
  guess.x[at(layout().last())] =
      given_duration.single() ? given_duration.lower : duration;
  const int last = layout().num_points();
  const CollocationScheme& scheme = collocation_.scheme();
  for (int s = 0; s < static_cast<int>(kStates); ++s) {
    const auto given = [&](int node) {
      const nlp::Range range = variable_range(layout().state(node, s));
      return range.single() ? std::optional(range.lower) : std::nullopt;
    };
    const double from = given(0).value_or(given(last).value_or(0.0));
    const double to = given(last).value_or(from);
    for (int node = 0; node <= last; ++node) {
      const int c = node - 1;
      const double sigma =
          node == 0 ? 0.0
                    : mesh().sigma(c / scheme.degree,
                                   scheme.rule.points[at(c % scheme.degree)]);
      guess.x[at(layout().state(node, s))] = from + sigma * (to - from);
    }
  }
  return guess;
}

template <ControlProblem Description>
std::vector<PathPlace<LeastCost<Description>::kStates>>
LeastCost<Description>::path(const PrimalDual& point) const
    requires(kControls == 1) {
  const bool costates = !point.lambda.empty();
  if (point.x.size() != at(num_variables()) ||
      (costates && point.lambda.size() != at(num_constraints()))) {
    throw std::invalid_argument("the point is one of another program");
  }
  const auto multiplier = [&](int row) {
    return costates ? point.lambda[at(row)]
                    : std::numeric_limits<double>::quiet_NaN();
  };
  const CollocationScheme& scheme = collocation_.scheme();
  const int p = scheme.degree;
  const double U = point.x[at(layout().last())];
  std::vector<PathPlace<kStates>> places(at(layout().num_nodes()));
  for (int node = 0; node < layout().num_nodes(); ++node) {
    PathPlace<kStates>& place = places[at(node)];
    const int c = node - 1;
    for (int s = 0; s < static_cast<int>(kStates); ++s) {
      place.states[at(s)] = point.x[at(layout().state(node, s))];
      if (node > 0) {
        place.costates[at(s)] =
            -multiplier(layout().defect(c, s)) / scheme.rule.weights[at(c % p)];
      }
    }
    if (node == 0) continue;
    const int e = c / p;
    place.s = U * mesh().sigma(e, scheme.rule.points[at(c % p)]);
    place.control = point.x[at(layout().control(c))] / mesh().length(e);
  }
  PathPlace<kStates>& start = places.front();
  start = {.s = 0.0, .states = start.states, .costates = {}, .control = 0.0};
  std::vector<double> at_start(at(p));
  scheme.points.evaluate(0.0, at_start);
  for (int j = 0; j < p; ++j) {
    start.control += at_start[at(j)] * places[at(j + 1)].control;
    for (int s = 0; s < static_cast<int>(kStates); ++s) {
      start.costates[at(s)] +=
          scheme.derivative(j, 0) * multiplier(layout().defect(j, s));
    }
  }
  return places;
}

template <ControlProblem Description>
std::string LeastCost<Description>::variable_name(int index) const {
  if (index == layout().last()) return "U";
  const std::string place = "[" + std::to_string(layout().node_of(index)) + "]";
  if (!layout().is_state(index)) {
    const int control = index % layout().stride() - layout().num_states();
    if constexpr (requires { description().control_name(0); }) {
      return "h " + std::string(description().control_name(at(control))) +
             place;
    }
    return "h u" + (kControls == 1 ? "" : std::to_string(control)) + place;
  }
  return std::string(description().state_name(at(index % layout().stride()))) +
         place;
}

template <ControlProblem Description>
std::string LeastCost<Description>::constraint_name(int index) const {
  if constexpr (EndFunctions<Description>::kConditions > 0) {
    if (index >= layout().end_of_points()) {
      return std::string(
          description().end_name(at(index - layout().end_of_points())));
    }
  }
  const int point = layout().point_of(index);
  const int row = index - layout().defect(point, 0);
  const std::string place = "[" + std::to_string(point) + "]";
  if (row < layout().num_states()) {
    return "defect of " + std::string(description().state_name(at(row))) +
           place;
  }
  return std::string(
             description().limit_name(at(row - layout().num_states()))) +
         place;
}

template <ControlProblem Description>
bool LeastCost<Description>::evaluate() {
  if (!(duration() > 0.0)) return refuse(-1, "the duration is not positive");
  const auto refused = collocation_.evaluate(
      x(), mesh(), [&](int) -> const auto& { return description(); },
      [](int, int) { return true; });
  if (refused) return refuse(refused->point, refused->because);
  return ends_.evaluate(description(), x()) ||
         refuse(-1, "what is asked of the ends is not finite");
}

}  // namespace brachisto::ocp
