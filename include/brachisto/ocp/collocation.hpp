// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Collocation of a description of an optimal-control problem: objective,
/// defects, limits and their derivatives, from its one text.

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "brachisto/math/index.hpp"
#include "brachisto/math/jet1.hpp"
#include "brachisto/math/jet2.hpp"
#include "brachisto/math/stop_condition.hpp"
#include "brachisto/ocp/entries.hpp"
#include "brachisto/ocp/layout.hpp"
#include "brachisto/ocp/local_structure.hpp"
#include "brachisto/ocp/mesh.hpp"
#include "brachisto/ocp/point_function.hpp"
#include "brachisto/ocp/scheme.hpp"

namespace brachisto::ocp {

/// What is kept of an evaluated point: its rates as jets, unless a description
/// has something smaller, `kept(yu)`, that its rates follow from by
/// `rates_of<Number>(kept)`, as numbers and as jets.
template <class Description>
inline constexpr bool kKeepsLess =
    requires(const Description& of, const PointOf<Description, double>& yu) {
  of.kept(yu);
};

/// With the global unknown U, the duration of the way in the description's
/// variable u, on elements of the lengths h of a mesh of σ ∈ [0, 1]:
///
///     minimise U Σ_e h_e Σ_j b_j L,
///     D y − h_e U f = 0 at each point, of each state,
///     lower ≤ c ≤ upper    likewise, of each limit.
///
/// The defects are in integral form: a tolerance on them means the same on
/// every mesh. Points of Gauss's scheme lie between the nodes. Those of Radau's
/// are nodes; the control's unknown is then h u, so that no entry of the
/// KKT matrix falls with h.
///
/// What a description says that nothing depends on has no entries.
template <class Description>
class Collocation {
 public:
  static constexpr int kStates = static_cast<int>(Description::kStates);
  static constexpr int kControl = kStates;
  static constexpr int kLocals = kStates + 1;  ///< states and the control
  using Jet = math::Jet2<double, kLocals>;
  using FirstJet = math::Jet1<double, kLocals>;
  using Locals = PointOf<Description, double>;

  Collocation(Description description, const CollocationScheme& scheme,
              const Layout& layout)
      : description_(std::move(description)),
        scheme_(&scheme),
        layout_(layout),
        points_(at(layout.num_points())),
        limits_(points_.size() * at(layout.num_limits())),
        local_(description_, layout) {}

  [[nodiscard]] const Description& description() const { return description_; }
  /// Another one of the same kind, on which as much depends.
  void describe(Description description) {
    description_ = std::move(description);
  }
  [[nodiscard]] const CollocationScheme& scheme() const { return *scheme_; }

  [[nodiscard]] const Layout& layout() const { return layout_; }
  [[nodiscard]] const LocalStructure<kLocals>& local() const { return local_; }

  /// Of states and control at a point, those on which anything depends; the
  /// others are 0.
  [[nodiscard]] Locals locals(std::span<const double> x, const Mesh& mesh,
                              int point) const {
    Locals yu{};
    for (int a = 0; a < kLocals; ++a) {
      if (!local_.matters[at(a)]) continue;
      double sum = 0.0;
      spread(point, a,
             [&](int index, double share) { sum += share * x[at(index)]; });
      yu[at(a)] = a == kControl ? sum * per_length(mesh, point) : sum;
    }
    return yu;
  }

  /// Why a point of the path is none of the program.
  struct Refused {
    int point;
    const char* because;
  };
  /// Evaluates all points.
  ///
  /// \param described  the description that holds on an element
  /// \param asked      whether a limit is asked for at a point; else it is 0
  template <class Described, class Asked>
  [[nodiscard]] std::optional<Refused> evaluate(std::span<const double> x,
                                                const Mesh& mesh,
                                                Described&& described,
                                                Asked&& asked) {
    for (int c = 0; c < layout_.num_points(); ++c) {
      check_stop(c);
      const Description& here = described(c / scheme_->degree);
      const Locals yu = locals(x, mesh, c);
      points_[at(c)] = evaluated(here, yu);
      if (const char* because = refusal(here, yu, c)) {
        return Refused{c, because};
      }
      if (layout_.num_limits() == 0) continue;
      const auto jets = present(yu);
      Jet* const values = &limits_[at(c) * at(layout_.num_limits())];
      each_limit(
          here, jets,
          [&](std::size_t i) { return asked(c, static_cast<int>(i)); },
          [&](std::size_t i, const Jet& value) { values[i] = value; });
    }
    return std::nullopt;
  }

  /// L and f at an evaluated point with their first two derivatives by states
  /// and control.
  [[nodiscard]] decltype(auto) second(int point) const {
    return as<Jet>(point);
  }
  /// The same at any point of the variables.
  [[nodiscard]] Rates<Jet, kStates> jets_at(const Locals& yu) const {
    if constexpr (kKeepsLess<Description>) {
      return description_.template rates_of<Jet>(description_.kept(yu));
    } else {
      return description_.rates(present(yu));
    }
  }
  [[nodiscard]] const Jet& limit_at(int point, int number) const {
    return limits_[at(point) * at(layout_.num_limits()) + at(number)];
  }

  /// Whether a limit depends on none but these states.
  [[nodiscard]] bool limit_is_of(int number,
                                 std::initializer_list<int> states) const {
    return std::ranges::all_of(local_.limit_rows[at(number)], [&](int local) {
      return std::ranges::find(states, local) != states.end();
    });
  }

  /// Of each limit whether it depends on the control.
  [[nodiscard]] std::vector<bool> limits_of_control() const {
    std::vector<bool> out;
    for (const std::vector<int>& row : local_.limit_rows) {
      out.push_back(!row.empty() && row.back() == kControl);
    }
    return out;
  }

  [[nodiscard]] double objective(const Mesh& mesh, double U) const {
    double sum = 0.0;
    for (int e = 0; e < mesh.num_elements(); ++e) {
      double element = 0.0;
      for (int j = 0; j < mesh.degree; ++j) {
        element += scheme_->rule.weights[at(j)] * cost_at(e * mesh.degree + j);
      }
      sum += mesh.length(e) * element;
    }
    return U * sum;
  }

  /// \param grad  all of it is written
  void put_gradient(const Mesh& mesh, double U, std::span<double> grad) const {
    std::fill(grad.begin(), grad.end(), 0.0);
    double sum = 0.0;
    for (int c = 0; c < layout_.num_points(); ++c) {
      const double b = scheme_->rule.weights[at(c % mesh.degree)];
      const double h = mesh.length(c / mesh.degree);
      const auto& cost = as<FirstJet>(c).cost;
      sum += h * b * cost.value;
      for (const int a : local_.rows.front()) {
        const double slope = U * (length(a, h) * b) * cost.gradient[at(a)];
        spread(c, a, [&](int index, double share) {
          grad[at(index)] += slope * share;
        });
      }
    }
    grad[at(layout_.last())] = sum;
  }

  /// Defects and limits.
  void put_constraints(std::span<const double> x, const Mesh& mesh,
                       std::span<double> g) const {
    const int p = mesh.degree;
    const double U = x[at(layout_.last())];
    for (int c = 0; c < layout_.num_points(); ++c) {
      const int first = c / p * p;
      const double hU = mesh.length(c / p) * U;
      const auto& rates = as<FirstJet>(c);
      for (int s = 0; s < kStates; ++s) {
        if (!layout_.has_state(s)) continue;
        double difference = 0.0;
        int index = layout_.state(first, s);
        for (const double share : scheme_->derivative.row(c - first)) {
          difference += share * x[at(index)];
          index += layout_.stride();
        }
        g[at(layout_.defect(c, s))] =
            difference - hU * rates.states[at(s)].value;
      }
      for (int i = 0; i < layout_.num_limits(); ++i) {
        g[at(layout_.limit(c, i))] = limit_at(c, i).value;
      }
    }
  }

  void put_jac_g(const Mesh& mesh, double U, Entries& put) const {
    const int p = mesh.degree;
    put.each(0, mesh.num_elements(), [&](int e) {
      const double h = mesh.length(e);
      for (int c = e * p; c < (e + 1) * p; ++c) {
        const auto& rates = as<FirstJet>(c);
        for (int s = 0; s < kStates; ++s) {
          if (!layout_.has_state(s)) continue;
          const int row = layout_.defect(c, s);
          const auto& rate = rates.states[at(s)];
          put.row(row, layout_.state(e * p, s), layout_.stride(),
                  scheme_->derivative.row(c - e * p));
          for (const int a : local_.rows[at(s + 1)]) {
            put_slope(put, row, c, a, -length(a, h) * U * rate.gradient[at(a)]);
          }
          put(row, layout_.last(), -h * rate.value);
        }
        for (int i = 0; i < layout_.num_limits(); ++i) {
          for (const int a : local_.limit_rows[at(i)]) {
            put_slope(put, layout_.limit(c, i), c, a,
                      limit_at(c, i).gradient[at(a)] * (length(a, h) / h));
          }
        }
      }
    });
  }

  /// At each point the Lagrangian is h U { s b L − λ·f } + Σ_i μ_i c_i plus
  /// terms linear in the states, s being the objective's factor.
  void put_hess_lag(const Mesh& mesh, double U, double objective_factor,
                    std::span<const double> lambda, Entries& put) const {
    const int p = mesh.degree;
    std::array<Density, kLargestDegree> of;  // NOLINT: filled below
    put.each(0, mesh.num_elements(), [&](int e) {
      const double h = mesh.length(e);
      for (int j = 0; j < p; ++j) {
        const int c = e * p + j;
        Density& D = of[at(j)];
        D = density(c, objective_factor * scheme_->rule.weights[at(j)], lambda);
        for (const auto& [a, b] : local_.pairs) {
          double& second = D.hessian[Jet::pair(a, b)];
          second *= h * U;
          for (int i = 0; i < layout_.num_limits(); ++i) {
            second += lambda[at(layout_.limit(c, i))] *
                      limit_at(c, i).hessian[Jet::pair(a, b)];
          }
          second *= (length(a, h) / h) * (length(b, h) / h);
        }
        for (const int a : local_.by_duration) {
          D.gradient[at(a)] *= length(a, h);
        }
      }
      if (scheme_->points_are_nodes) {
        for (int j = 0; j < p; ++j) put_at_node(e * p + j, of[at(j)], put);
      } else {
        put_between_nodes(e, of, put);
      }
    });
  }

  /// Calls with(index, share) for each unknown that a local one of a point is
  /// made of; of the control its unknown.
  template <class With>
  void spread(int point, int local, With&& with) const {
    if (local == kControl) return with(layout_.control(point), 1.0);
    if (scheme_->points_are_nodes) {
      return with(layout_.state(point + 1, local), 1.0);
    }
    const int j = point % scheme_->degree;
    int index = layout_.state(point - j, local);
    for (const double share : scheme_->interpolation.row(j)) {
      with(index, share);
      index += layout_.stride();
    }
  }

 private:
  static auto kept_type() {
    if constexpr (kKeepsLess<Description>) {
      return decltype(std::declval<const Description&>().kept(Locals{})){};
    } else {
      return Rates<Jet, kStates>{};
    }
  }
  using Kept = decltype(kept_type());

  /// Derivatives of s b L − λ·f by states and control.
  struct Density {
    std::array<double, kLocals> gradient;
    std::array<double, Jet::kPairs> hessian;
  };
  [[nodiscard]] const char* refusal(const Description& here, const Locals& yu,
                                    int point) const {
    if constexpr (requires { here.refusal(yu, 0.0); }) {
      return here.refusal(yu, cost_at(point));
    } else {
      const auto& rates = second(point);
      const bool finite =
          std::isfinite(rates.cost.value) &&
          std::ranges::all_of(rates.states, [](const Jet& rate) {
            return std::isfinite(rate.value);
          });
      return finite ? nullptr : "the cost or a rate is not finite";
    }
  }
  [[nodiscard]] Kept evaluated(const Description& here,
                               const Locals& yu) const {
    if constexpr (kKeepsLess<Description>) {
      return here.kept(yu);
    } else {
      return here.rates(present(yu));
    }
  }
  /// States and control as variables; what is absent is a constant.
  [[nodiscard]] PointOf<Description, Jet> present(const Locals& yu) const {
    PointOf<Description, Jet> jets;
    for (int a = 0; a < kLocals; ++a) {
      if (local_.matters[at(a)]) jets[at(a)] = Jet::variable(yu[at(a)], a);
    }
    return jets;
  }
  template <class Number>
  [[nodiscard]] decltype(auto) as(int point) const {
    if constexpr (kKeepsLess<Description>) {
      return description_.template rates_of<Number>(points_[at(point)]);
    } else {
      return static_cast<const Rates<Jet, kStates>&>(points_[at(point)]);
    }
  }
  [[nodiscard]] double cost_at(int point) const {
    return as<FirstJet>(point).cost.value;
  }

  /// h of a state, 1 of a control whose unknown has h in it.
  [[nodiscard]] double length(int local, double h) const {
    return local == kControl && scheme_->points_are_nodes ? 1.0 : h;
  }
  /// By what the control's unknown is multiplied for the control.
  [[nodiscard]] double per_length(const Mesh& mesh, int point) const {
    return scheme_->points_are_nodes
               ? 1.0 / mesh.length(point / scheme_->degree)
               : 1.0;
  }

  [[nodiscard]] Density density(int point, double weight,
                                std::span<const double> lambda) const {
    const auto& rates = second(point);
    std::array<double, kStates + 1> factor{weight};
    std::array<const Jet*, kStates + 1> of{&rates.cost};
    for (int s = 0; s < kStates; ++s) {
      of[at(s + 1)] = &rates.states[at(s)];
      if (layout_.has_state(s)) {
        factor[at(s + 1)] = -lambda[at(layout_.defect(point, s))];
      }
    }
    Density out{};
    for (const auto& [number, where] : local_.first_terms) {
      out.gradient[where] += factor[number] * of[number]->gradient[where];
    }
    for (const auto& [number, where] : local_.second_terms) {
      out.hessian[where] += factor[number] * of[number]->hessian[where];
    }
    return out;
  }

  /// A slope by a local one of a point, by the unknowns that it is made of.
  void put_slope(Entries& put, int row, int point, int local,
                 double slope) const {
    if (local == kControl) return put(row, layout_.control(point), slope);
    if (scheme_->points_are_nodes) {
      return put(row, layout_.state(point + 1, local), slope);
    }
    const int j = point % scheme_->degree;
    put.row(row, layout_.state(point - j, local), layout_.stride(),
            scheme_->interpolation.row(j), slope);
  }

  void put_at_node(int point, const Density& D, Entries& put) const {
    const auto index = [&](int a) {
      return a == kControl ? layout_.control(point)
                           : layout_.state(point + 1, a);
    };
    for (const auto& [a, b] : local_.pairs) {
      const auto [low, high] = std::minmax({index(a), index(b)});
      put(high, low, D.hessian[Jet::pair(a, b)]);
    }
    for (const int a : local_.by_duration) {
      put(layout_.last(), index(a), D.gradient[at(a)]);
    }
  }

  /// Second derivatives by states at the points, spread to the nodes by the
  /// interpolation.
  void put_between_nodes(int element,
                         const std::array<Density, kLargestDegree>& of,
                         Entries& put) const {
    const int p = scheme_->degree;
    const int first = element * p;
    const math::SmallMatrix& I = scheme_->interpolation;
    // What the controls have alone comes first: an entry of the element's first
    // node alone would be counted as one of the element before.
    for (int j = 0; j < p; ++j) {
      const int control = layout_.control(first + j);
      if (local_.pairs.back() == std::pair(kControl, kControl)) {
        put(control, control, of[at(j)].hessian[Jet::pair(kControl, kControl)]);
      }
      if (local_.by_duration.back() == kControl) {
        put(layout_.last(), control, of[at(j)].gradient[kControl]);
      }
    }
    const int stride = layout_.stride();
    std::array<double, kLargestDegree + 1> sums;  // NOLINT: filled below
    // Σ_j factor(j) I(j, m) of the first nodes m.
    const auto interpolated = [&](int nodes, auto&& factor) {
      const std::span<double> out = std::span(sums).first(at(nodes));
      std::ranges::fill(out, 0.0);
      for (int j = 0; j < p; ++j) {
        const std::span<const double> shares = I.row(j);
        const double f = factor(j);
        for (std::size_t m = 0; m < out.size(); ++m) out[m] += f * shares[m];
      }
      return out;
    };
    for (const auto& [a, b] : local_.pairs) {
      if (b == kControl) continue;
      const std::size_t pair = Jet::pair(a, b);
      const int first_b = layout_.state(first, b);
      if (a == kControl) {
        for (int j = 0; j < p; ++j) {
          put.lower(layout_.control(first + j), first_b, stride, I.row(j),
                    of[at(j)].hessian[pair]);
        }
        continue;
      }
      for (int n = 0; n <= p; ++n) {
        put.lower(layout_.state(first + n, a), first_b, stride,
                  interpolated(a == b ? n + 1 : p + 1, [&](int j) {
                    return I(j, n) * of[at(j)].hessian[pair];
                  }));
      }
    }
    for (const int a : local_.by_duration) {
      if (a == kControl) continue;
      put.row(layout_.last(), layout_.state(first, a), stride,
              interpolated(p + 1,
                           [&](int j) { return of[at(j)].gradient[at(a)]; }));
    }
  }

  Description description_;
  const CollocationScheme* scheme_;
  Layout layout_;
  std::vector<Kept> points_;
  std::vector<Jet> limits_;  ///< of a point, one after the other
  LocalStructure<kLocals> local_;
};

}  // namespace brachisto::ocp
