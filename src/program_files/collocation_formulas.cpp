// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Programs of collocation: what the rolling body says of one point, as formulas
// in the unknowns of a scheme.

#include <type_traits>
#include <utility>
#include <vector>

#include "brachisto/math/index.hpp"
#include "model/field.hpp"
#include "program_files/program_in_formulas.hpp"
#include "rolling/rolling_body.hpp"
#include "transcription/limited_time.hpp"
#include "transcription/rolling_time.hpp"

namespace brachisto::program_files {

namespace {

using enum StateComponent;

constexpr int kTheta = rolling::kTheta;

/// Of L, f and c of a description: the objective's parts h_e b_j U L, one of
/// each point; the defects D X − h_e U f; and the limits c.
///
/// Gauss's points lie between the nodes: the states there are quantities, those
/// of one point after the other, and the control is an unknown. Radau's points
/// are nodes and need no quantities; of the control the unknown is h_e q.
template <class Problem, class Description>
class CollocationFormulas final : public ProgramInFormulas {
 public:
  /// \param sides  of a field's surface, by element, or none
  CollocationFormulas(const Problem& problem, const Description& described,
                      std::vector<FieldSide> sides)
      : problem_(problem),
        by_place_(described),
        inside_(described),
        outside_(described),
        sides_(std::move(sides)) {
    inside_.keep_to_side(false);
    outside_.keep_to_side(true);
  }

  [[nodiscard]] int num_quantities() const override {
    return kPointsAreNodes ? 0 : kStates * layout().num_points();
  }
  [[nodiscard]] Formula quantity(int index) const override {
    if constexpr (kPointsAreNodes) {
      return {};
    } else {
      return combined(problem_.scheme().interpolation, index / kStates,
                      index % kStates);
    }
  }
  [[nodiscard]] int num_objective_parts() const override {
    return layout().num_points();
  }
  [[nodiscard]] Formula objective_part(int point) const override {
    const double b =
        problem_.scheme().rule.weights[at(point % problem_.mesh().degree)];
    return b * duration(point) * rates(point).cost;
  }
  [[nodiscard]] Formula constraint(int index) const override {
    const int point = layout().point_of(index);
    if constexpr (kPointsAreNodes) {
      if (const int row = index - layout().contact_row(0); row >= 0) {
        const int node = problem_.is_at_start(row) ? 0 : layout().num_points();
        return problem_.at_end_row(
            row, at_node(node, rolling::kX), at_node(node, rolling::kZ),
            at_node(node, rolling::kW), at_node(node, rolling::kBeta));
      }
      if (index >= layout().limit(point, 0)) {
        return seen_from(point).limit(at(index - layout().limit(point, 0)),
                                      states_and_control(point));
      }
    }
    int state = index - layout().defect(point, X);
    if (state >= kTheta && !layout().has_theta()) ++state;
    return combined(problem_.scheme().derivative, point, state) -
           duration(point) * rates(point).states[at(state)];
  }

 private:
  static constexpr int kStates = Description::kStates;
  static constexpr bool kPointsAreNodes = std::is_same_v<Problem, LimitedTime>;
  using Point = ocp::PointOf<Description, Formula>;

  [[nodiscard]] const VariableLayout& layout() const {
    return problem_.layout();
  }
  [[nodiscard]] int element_of(int point) const {
    return point / problem_.mesh().degree;
  }
  [[nodiscard]] const Description& seen_from(int point) const {
    if (sides_.empty()) return by_place_;
    return sides_[at(element_of(point))] == FieldSide::Inside ? inside_
                                                              : outside_;
  }
  /// What the program does not have is 0, and nothing depends on it.
  [[nodiscard]] bool has(int state) const { return layout().has_state(state); }
  [[nodiscard]] Formula at_node(int node, int state) const {
    if (!has(state)) return 0.0;
    return Formula::unknown(layout().state(node, state));
  }
  /// Σ_n M_jn X_n over the nodes of a point's element.
  [[nodiscard]] Formula combined(const math::SmallMatrix& M, int point,
                                 int state) const {
    const int p = problem_.mesh().degree;
    Formula sum;
    for (int n = 0; n <= p; ++n) {
      sum += M(point % p, n) * at_node(point / p * p + n, state);
    }
    return sum;
  }
  [[nodiscard]] Point states_and_control(int point) const {
    Point out;
    for (int i = 0; i < kStates; ++i) {
      if (kPointsAreNodes) {
        out[at(i)] = at_node(point + 1, i);
      } else if (has(i)) {
        out[at(i)] = Formula::quantity(kStates * point + i);
      }
    }
    out.back() = Formula::unknown(layout().control(point));
    if (kPointsAreNodes) {
      out.back() =
          out.back() * (1.0 / problem_.mesh().length(element_of(point)));
    }
    return out;
  }
  /// Kept, as the rows of a point are asked for one after the other.
  [[nodiscard]] const ocp::Rates<Formula, kStates>& rates(int point) const {
    if (std::exchange(rated_, point) != point) {
      rates_ = seen_from(point).rates(states_and_control(point));
    }
    return rates_;
  }
  /// h_e U.
  [[nodiscard]] Formula duration(int point) const {
    return problem_.mesh().length(element_of(point)) *
           Formula::unknown(layout().rolling_time());
  }
  const Problem& problem_;
  Description by_place_, inside_, outside_;
  std::vector<FieldSide> sides_;
  mutable int rated_ = -1;
  mutable ocp::Rates<Formula, kStates> rates_;
};

template <class Description, class Problem>
std::unique_ptr<ProgramInFormulas> formulas_of(
    const Problem& problem, std::vector<PathInequality> limits,
    std::vector<FieldSide> sides) {
  const Body& body = problem.scene().body;
  const double per_length = body.off_centred() ? 1.0 / body.radius : 0.0;
  return std::make_unique<CollocationFormulas<Problem, Description>>(
      problem, Description(problem.scene(), std::move(limits), per_length),
      std::move(sides));
}

}  // namespace

std::unique_ptr<ProgramInFormulas> in_formulas(const RollingTime& problem) {
  return formulas_of<rolling::Steered>(problem, {}, problem.sides());
}

std::unique_ptr<ProgramInFormulas> in_formulas(const LimitedTime& problem) {
  return formulas_of<rolling::Turning>(problem, problem.limits(), {});
}

}  // namespace brachisto::program_files
