// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What a description says of all points of a path, with derivatives, and on
/// which states it depends.

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <utility>
#include <vector>

#include "brachisto/math/index.hpp"
#include "brachisto/math/jet.hpp"
#include "brachisto/ocp/mesh.hpp"
#include "brachisto/ocp/point_function.hpp"

namespace brachisto::ocp {

/// Read off the description's own text. What has no entry here is 0 wherever
/// the point is.
///
/// \tparam kStates  how many of the locals are states; the others are controls
template <int kStates, int kLocals>
struct LocalStructure {
  using On = math::Dependence<kLocals>;
  using Jet = math::Jet2<double, kLocals>;
  /// A derivative of the cost, 0, or of rate s, s + 1.
  struct Term {
    std::size_t of, where;
  };

  std::array<bool, kLocals> matters{};  ///< whether anything depends on it
  std::vector<std::vector<int>> rows;   ///< of the cost, then of each rate
  std::vector<std::vector<int>> limit_rows;
  std::vector<int> by_duration;            ///< of any of cost and rates
  std::vector<std::pair<int, int>> pairs;  ///< of anything, the larger first
  std::vector<Term> first_terms, second_terms;

  template <class Description>
  LocalStructure(const Description& description, const Layout& layout) {
    PointOf<Description, On> variables;
    for (int a = 0; a < kLocals; ++a) {
      if (a >= kStates || layout.has_state(a)) {
        variables[at(a)] = On::variable(a);
      }
    }
    On all;
    const auto rates = description.rates(variables);
    const auto see = [&](const On& on) {
      for (int a = 0; a < kLocals; ++a) {
        if (on.any[at(a)]) first_terms.push_back({rows.size(), at(a)});
        for (int b = 0; b <= a; ++b) {
          if (on.second[at(a)][at(b)]) {
            second_terms.push_back({rows.size(), Jet::pair(a, b)});
          }
        }
      }
      rows.push_back(members(on));
      all += on;
    };
    see(rates.cost);
    for (int s = 0; s < kStates; ++s) {
      see(layout.has_state(s) ? rates.states[at(s)] : On());
    }
    by_duration = members(all);
    for (int i = 0; i < layout.num_limits(); ++i) {
      const On on = description.limit(at(i), variables);
      limit_rows.push_back(members(on));
      all += on;
    }
    for (int a = 0; a < kLocals; ++a) {
      matters[at(a)] = all.any[at(a)];
      for (int b = 0; b <= a; ++b) {
        if (all.second[at(a)][at(b)]) pairs.push_back({a, b});
      }
    }
  }

 private:
  [[nodiscard]] static std::vector<int> members(const On& on) {
    std::vector<int> out;
    for (int a = 0; a < kLocals; ++a) {
      if (on.any[at(a)]) out.push_back(a);
    }
    return out;
  }
};

/// What is kept of an evaluated point: its rates as jets, unless a description
/// has something smaller, `kept(yu)`, that its rates follow from by
/// `rates_of<Number>(kept)`, as numbers and as jets.
template <class Description>
inline constexpr bool kKeepsLess =
    requires(const Description& of, const PointOf<Description, double>& yu) {
  of.kept(yu);
};

/// Cost, rates and limits at the points of a layout, once they were evaluated.
template <class Description>
class EvaluatedPoints {
 public:
  static constexpr int kStates = static_cast<int>(Description::kStates);
  static constexpr int kControl = kStates;  ///< the first
  /// States and controls.
  static constexpr int kLocals =
      kStates + static_cast<int>(num_controls<Description>());
  using Jet = math::Jet2<double, kLocals>;
  using FirstJet = math::Jet1<double, kLocals>;
  using Locals = PointOf<Description, double>;

  [[nodiscard]] const Description& description() const { return description_; }
  /// Another one of the same kind, on which as much depends.
  void describe(Description description) {
    description_ = std::move(description);
  }
  [[nodiscard]] const LocalStructure<kStates, kLocals>& local() const {
    return local_;
  }

  /// L and f at an evaluated point with their first two derivatives by states
  /// and controls.
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
    return limits_[at(point) * num_limits_ + at(number)];
  }

  /// Whether a limit depends on none but these states.
  [[nodiscard]] bool limit_is_of(int number,
                                 std::initializer_list<int> states) const {
    return std::ranges::all_of(local_.limit_rows[at(number)], [&](int local) {
      return std::ranges::find(states, local) != states.end();
    });
  }

  /// Of each limit whether it depends on a control.
  [[nodiscard]] std::vector<bool> limits_of_control() const {
    std::vector<bool> out;
    for (const std::vector<int>& row : local_.limit_rows) {
      out.push_back(!row.empty() && row.back() >= kControl);
    }
    return out;
  }

 protected:
  EvaluatedPoints(Description description, const Layout& layout)
      : description_(std::move(description)),
        num_points_(at(layout.num_points())),
        num_limits_(at(layout.num_limits())),
        local_(description_, layout) {
    make_room();
  }

  /// Before points are evaluated.
  void make_room() {
    points_.resize(num_points_);
    limits_.resize(num_points_ * num_limits_);
  }
  /// \param here   the description that holds there
  /// \param asked  whether a limit is asked for, by its number; else it is 0
  /// \return why the point is none of the program; null if it is one
  template <class Asked>
  [[nodiscard]] const char* evaluate_point(int point, const Description& here,
                                           const Locals& yu, Asked&& asked) {
    points_[at(point)] = kept(here, yu);
    if (const char* because = refusal(here, yu, point)) return because;
    if (num_limits_ == 0) return nullptr;
    Jet* const values = &limits_[at(point) * num_limits_];
    each_limit(here, present(yu), asked,
               [&](std::size_t i, const Jet& value) { values[i] = value; });
    return nullptr;
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

 private:
  static auto kept_type() {
    if constexpr (kKeepsLess<Description>) {
      return decltype(std::declval<const Description&>().kept(Locals{})){};
    } else {
      return Rates<Jet, kStates>{};
    }
  }
  using Kept = decltype(kept_type());

  [[nodiscard]] Kept kept(const Description& here, const Locals& yu) const {
    if constexpr (kKeepsLess<Description>) {
      return here.kept(yu);
    } else {
      return here.rates(present(yu));
    }
  }
  /// States and controls as variables; what is absent is a constant.
  [[nodiscard]] PointOf<Description, Jet> present(const Locals& yu) const {
    PointOf<Description, Jet> jets;
    for (int a = 0; a < kLocals; ++a) {
      if (local_.matters[at(a)]) jets[at(a)] = Jet::variable(yu[at(a)], a);
    }
    return jets;
  }
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

  /// What a copy of the program would not look at before it moves to a point of
  /// its own: the largest part of it.
  template <class T>
  struct NotCopied : std::vector<T> {
    NotCopied() = default;
    NotCopied(const NotCopied& /*other*/) : std::vector<T>() {}
    NotCopied(NotCopied&&) = default;
    NotCopied& operator=(const NotCopied& /*other*/) {
      this->clear();
      return *this;
    }
    NotCopied& operator=(NotCopied&&) = default;
  };

  Description description_;
  std::size_t num_points_, num_limits_;
  NotCopied<Kept> points_;
  NotCopied<Jet> limits_;  ///< of a point, one after the other

 protected:
  LocalStructure<kStates, kLocals> local_;
};

}  // namespace brachisto::ocp
