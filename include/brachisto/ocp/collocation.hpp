// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Collocation of a description of an optimal-control problem: objective,
/// defects, limits and their derivatives, from its one text.

#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "brachisto/math/clock.hpp"
#include "brachisto/math/index.hpp"
#include "brachisto/ocp/evaluated_points.hpp"
#include "brachisto/ocp/mesh.hpp"
#include "brachisto/ocp/program.hpp"

namespace brachisto::ocp {

/// With the global unknown U, the duration of the way in the description's
/// variable u, on elements of the lengths h of a mesh of σ ∈ [0, 1]:
///
///     minimise U Σ_e h_e Σ_j b_j L,
///     D y − h_e U f = 0 at each point, of each state,
///     lower ≤ c ≤ upper    likewise, of each limit.
///
/// The defects are in integral form: a tolerance on them means the same on
/// every mesh. Points of Gauss's scheme lie between the nodes. Those of Radau's
/// are nodes; a control's unknown is then h u, so that no entry of the
/// KKT matrix falls with h.
///
/// What a description says that nothing depends on has no entries.
template <class Description>
class Collocation : public EvaluatedPoints<Description> {
  using Base = EvaluatedPoints<Description>;

 public:
  using Base::kControl, Base::kLocals, Base::kStates;
  using Base::limit_at, Base::second;
  using typename Base::FirstJet, typename Base::Jet, typename Base::Locals;

  Collocation(Description description, const CollocationScheme& scheme,
              const Layout& layout)
      : Base(std::move(description), layout),
        scheme_(&scheme),
        layout_(layout) {}

  [[nodiscard]] const CollocationScheme& scheme() const { return *scheme_; }

  [[nodiscard]] const Layout& layout() const { return layout_; }
  /// Of states and controls at a point, those on which anything depends; the
  /// others are 0.
  [[nodiscard]] Locals locals(std::span<const double> x, const Mesh& mesh,
                              int point) const {
    Locals yu{};
    for (int a = 0; a < kLocals; ++a) {
      if (!local_.matters[at(a)]) continue;
      double sum = 0.0;
      spread(point, a,
             [&](int index, double share) { sum += share * x[at(index)]; });
      yu[at(a)] = is_control(a) ? sum * per_length(mesh, point) : sum;
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
    this->make_room();
    for (int c = 0; c < layout_.num_points(); ++c) {
      check_stop(c);
      if (const char* because = this->evaluate_point(
              c, described(c / scheme_->degree), locals(x, mesh, c),
              [&](std::size_t i) { return asked(c, static_cast<int>(i)); })) {
        return Refused{c, because};
      }
    }
    return std::nullopt;
  }

  [[nodiscard]] double objective(const Mesh& mesh, double U) const {
    double sum = 0.0;
    for (int e = 0; e < mesh.num_elements(); ++e) {
      double element = 0.0;
      for (int j = 0; j < mesh.degree; ++j) {
        element += scheme_->rule.weights[at(j)] *
                   this->template functions_at<FirstJet>(e * mesh.degree + j)(0)
                       .value();
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
      const auto of = this->template functions_at<FirstJet>(c);
      const auto cost = of(0);
      sum += h * b * cost.value();
      for (std::size_t i = 0; i < cost.of->by.size(); ++i) {
        const int a = cost.of->by[i];
        const double slope = U * (length(a, h) * b) * cost.slope(i);
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
      const auto of = this->template functions_at<FirstJet>(c);
      for (int s = 0; s < kStates; ++s) {
        if (!layout_.has_state(s)) continue;
        double difference = 0.0;
        int index = layout_.state(first, s);
        for (const double share : scheme_->derivative.row(c - first)) {
          difference += share * x[at(index)];
          index += layout_.stride();
        }
        g[at(layout_.defect(c, s))] = difference - hU * of(at(s + 1)).value();
      }
      for (int i = 0; i < layout_.num_limits(); ++i) {
        g[at(layout_.limit(c, i))] = limit_at(c, i).value();
      }
    }
  }

  void put_jac_g(const Mesh& mesh, double U, Entries& put) const {
    const int p = mesh.degree;
    put.each(0, mesh.num_elements(), [&](int e) {
      const double h = mesh.length(e);
      for (int c = e * p; c < (e + 1) * p; ++c) {
        const auto of = this->template functions_at<FirstJet>(c);
        for (int s = 0; s < kStates; ++s) {
          if (!layout_.has_state(s)) continue;
          const int row = layout_.defect(c, s);
          const auto rate = of(at(s + 1));
          put.row(row, layout_.state(e * p, s), layout_.stride(),
                  scheme_->derivative.row(c - e * p));
          for (std::size_t k = 0; k < rate.of->by.size(); ++k) {
            const int a = rate.of->by[k];
            put_slope(put, row, c, a, -length(a, h) * U * rate.slope(k));
          }
          put(row, layout_.last(), -h * rate.value());
        }
        for (int i = 0; i < layout_.num_limits(); ++i) {
          const auto limit = limit_at(c, i);
          for (std::size_t k = 0; k < limit.of->by.size(); ++k) {
            const int a = limit.of->by[k];
            put_slope(put, layout_.limit(c, i), c, a,
                      limit.slope(k) * (length(a, h) / h));
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
        for (double& entry : D.hessian) entry *= h * U;
        for (int i = 0; i < layout_.num_limits(); ++i) {
          add_second(limit_at(c, i), lambda[at(layout_.limit(c, i))], D);
        }
        for (const auto& [a, b] : local_.pairs) {
          D.hessian[Jet::pair(a, b)] *= (length(a, h) / h) * (length(b, h) / h);
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
  /// made of; of a control its unknown.
  template <class With>
  void spread(int point, int local, With&& with) const {
    if (is_control(local)) return with(control(point, local), 1.0);
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
  [[nodiscard]] static constexpr bool is_control(int local) {
    return local >= kControl;
  }
  /// The unknown of a local one that is a control.
  [[nodiscard]] int control(int point, int local) const {
    return layout_.control(point, local - kControl);
  }
  /// Derivatives of s b L − λ·f by states and controls.
  struct Density {
    std::array<double, kLocals> gradient;
    std::array<double, Jet::kPairs> hessian;
  };
  /// h of a state, 1 of a control whose unknown has h in it.
  [[nodiscard]] double length(int local, double h) const {
    return is_control(local) && scheme_->points_are_nodes ? 1.0 : h;
  }
  /// By what a control's unknown is multiplied for the control.
  [[nodiscard]] double per_length(const Mesh& mesh, int point) const {
    return scheme_->points_are_nodes
               ? 1.0 / mesh.length(point / scheme_->degree)
               : 1.0;
  }

  template <class Function>
  static void add_second(const Function& function, double factor, Density& to) {
    for (std::size_t i = 0; i < function.of->second.size(); ++i) {
      to.hessian[function.of->second[i]] += factor * function.bend(i);
    }
  }
  [[nodiscard]] Density density(int point, double weight,
                                std::span<const double> lambda) const {
    const auto of = this->template functions_at<Jet>(point);
    Density out{};
    const auto add = [&](const auto& function, double factor) {
      for (std::size_t i = 0; i < function.of->by.size(); ++i) {
        out.gradient[at(function.of->by[i])] += factor * function.slope(i);
      }
      add_second(function, factor, out);
    };
    add(of(0), weight);
    for (int s = 0; s < kStates; ++s) {
      if (!layout_.has_state(s)) continue;
      add(of(at(s + 1)), -lambda[at(layout_.defect(point, s))]);
    }
    return out;
  }

  /// A slope by a local one of a point, by the unknowns that it is made of.
  void put_slope(Entries& put, int row, int point, int local,
                 double slope) const {
    if (is_control(local)) return put(row, control(point, local), slope);
    if (scheme_->points_are_nodes) {
      return put(row, layout_.state(point + 1, local), slope);
    }
    const int j = point % scheme_->degree;
    put.row(row, layout_.state(point - j, local), layout_.stride(),
            scheme_->interpolation.row(j), slope);
  }

  void put_at_node(int point, const Density& D, Entries& put) const {
    const auto index = [&](int a) {
      return is_control(a) ? control(point, a) : layout_.state(point + 1, a);
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
      for (const auto& [a, b] : local_.pairs) {
        if (!is_control(b)) continue;
        put(control(first + j, a), control(first + j, b),
            of[at(j)].hessian[Jet::pair(a, b)]);
      }
      for (const int a : local_.by_duration) {
        if (!is_control(a)) continue;
        put(layout_.last(), control(first + j, a), of[at(j)].gradient[at(a)]);
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
      if (is_control(b)) continue;
      const std::size_t pair = Jet::pair(a, b);
      const int first_b = layout_.state(first, b);
      if (is_control(a)) {
        for (int j = 0; j < p; ++j) {
          put.lower(control(first + j, a), first_b, stride, I.row(j),
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
      if (is_control(a)) continue;
      put.row(layout_.last(), layout_.state(first, a), stride,
              interpolated(p + 1,
                           [&](int j) { return of[at(j)].gradient[at(a)]; }));
    }
  }

  using Base::local_;
  const CollocationScheme* scheme_;
  Layout layout_;
};

}  // namespace brachisto::ocp
