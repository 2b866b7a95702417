// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The program of a stated problem as formulas, for .nl files.

#pragma once

#include <memory>
#include <utility>

#include "brachisto/math/index.hpp"
#include "brachisto/posed/problem.hpp"
#include "program_files/program_in_formulas.hpp"

namespace brachisto::program_files {

/// The objective's parts h_e b_j U L, one of each point, and φ behind them; the
/// defects D y − h_e U f; the limits; the conditions of the ends. Unknowns are
/// LeastCost's: of a control h_e u.
template <class Description>
class StatedFormulas final : public ProgramInFormulas {
 public:
  StatedFormulas(Description description, Mesh mesh, ocp::Layout layout)
      : description_(std::move(description)),
        mesh_(std::move(mesh)),
        layout_(std::move(layout)) {}

  [[nodiscard]] int num_quantities() const override { return 0; }
  [[nodiscard]] Formula quantity(int /*index*/) const override { return {}; }
  [[nodiscard]] int num_objective_parts() const override {
    return layout_.num_points() + 1;
  }
  [[nodiscard]] Formula objective_part(int point) const override {
    if (point == layout_.num_points()) return description_.end_cost(ends());
    const double b = scheme().rule.weights[at(point % mesh_.degree)];
    return b * duration(point) * description_.rates(at_point(point)).cost;
  }
  [[nodiscard]] Formula constraint(int index) const override {
    if (index >= layout_.end_of_points()) {
      if constexpr (Description::kEndConditions > 0) {
        return description_.end_conditions(
            ends())[at(index - layout_.end_of_points())];
      }
    }
    const int point = layout_.point_of(index);
    const int row = index - layout_.defect(point, 0);
    if (row >= layout_.num_states()) {
      return description_.limit(at(row - layout_.num_states()),
                                at_point(point));
    }
    const int p = mesh_.degree;
    Formula sum;
    for (int n = 0; n <= p; ++n) {
      sum += scheme().derivative(point % p, n) *
             Formula::unknown(layout_.state(point / p * p + n, row));
    }
    return sum - duration(point) *
                     description_.rates(at_point(point)).states[at(row)];
  }

 private:
  static constexpr std::size_t kStates = Description::kStates;

  [[nodiscard]] const CollocationScheme& scheme() const {
    return radau_scheme(mesh_.degree);
  }
  [[nodiscard]] ocp::PointOf<Description, Formula> at_point(int point) const {
    ocp::PointOf<Description, Formula> out;
    for (std::size_t i = 0; i < kStates; ++i) {
      out[i] = Formula::unknown(layout_.state(point + 1, static_cast<int>(i)));
    }
    const double h = mesh_.length(point / mesh_.degree);
    for (std::size_t k = 0; k < Description::kControls; ++k) {
      out[kStates + k] =
          Formula::unknown(layout_.control(point, static_cast<int>(k))) *
          (1.0 / h);
    }
    return out;
  }
  [[nodiscard]] ocp::EndPoints<Formula, kStates> ends() const {
    ocp::EndPoints<Formula, kStates> out;
    for (std::size_t i = 0; i < kStates; ++i) {
      const int state = static_cast<int>(i);
      out.start[i] = Formula::unknown(layout_.state(0, state));
      out.end[i] = Formula::unknown(layout_.state(layout_.num_points(), state));
    }
    out.duration = Formula::unknown(layout_.last());
    return out;
  }
  /// h_e U.
  [[nodiscard]] Formula duration(int point) const {
    return mesh_.length(point / mesh_.degree) *
           Formula::unknown(layout_.last());
  }

  Description description_;
  Mesh mesh_;
  ocp::Layout layout_;
};

/// \pre  the problem outlives them
template <class Formulas>
[[nodiscard]] std::unique_ptr<ProgramInFormulas> in_formulas(
    const ocp::Problem<Formulas>& problem, const Mesh& mesh) {
  return std::make_unique<StatedFormulas<ocp::Scaled<Formulas>>>(
      problem.description(), mesh, problem.layout(mesh));
}

}  // namespace brachisto::program_files
