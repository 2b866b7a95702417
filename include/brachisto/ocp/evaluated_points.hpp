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
  /// Of the cost, a rate or a limit the derivatives that it has.
  struct Function {
    std::vector<int> by;              ///< of the first order, by which locals
    std::vector<std::size_t> second;  ///< as in Jet::hessian

    /// How many numbers it is together with them.
    [[nodiscard]] std::size_t size() const {
      return 1 + by.size() + second.size();
    }
    void pack(const Jet& jet, double* to) const {
      *to++ = jet.value;
      for (const int a : by) *to++ = jet.gradient[at(a)];
      for (const std::size_t ab : second) *to++ = jet.hessian[ab];
    }
  };
  /// Its numbers as they are kept, one after the other.
  struct Numbers {
    const Function* of;
    const double* first;

    [[nodiscard]] double value() const { return *first; }
    /// ∂/∂by[i], and the derivative second[i].
    [[nodiscard]] double slope(std::size_t i) const { return first[1 + i]; }
    [[nodiscard]] double bend(std::size_t i) const {
      return first[1 + of->by.size() + i];
    }
    /// As a jet of either order.
    template <class AnyJet>
    [[nodiscard]] AnyJet unpacked() const {
      AnyJet out(value());
      for (std::size_t i = 0; i < of->by.size(); ++i) {
        out.gradient[at(of->by[i])] = slope(i);
      }
      if constexpr (requires { out.hessian; }) {
        for (std::size_t i = 0; i < of->second.size(); ++i) {
          out.hessian[of->second[i]] = bend(i);
        }
      }
      return out;
    }
  };
  /// The same of a jet.
  template <class AnyJet>
  struct InJet {
    const Function* of;
    const AnyJet* jet;

    [[nodiscard]] double value() const { return jet->value; }
    [[nodiscard]] double slope(std::size_t i) const {
      return jet->gradient[at(of->by[i])];
    }
    [[nodiscard]] double bend(std::size_t i) const {
      return jet->hessian[of->second[i]];
    }
  };

  std::array<bool, kLocals> matters{};      ///< whether anything depends on it
  std::array<Function, kStates + 1> rates;  ///< the cost, then each rate
  std::vector<Function> limits;
  std::vector<int> by_duration;            ///< of any of cost and rates
  std::vector<std::pair<int, int>> pairs;  ///< of anything, the larger first

  template <class Description>
  LocalStructure(const Description& description, const Layout& layout) {
    PointOf<Description, On> variables;
    for (int a = 0; a < kLocals; ++a) {
      if (a >= kStates || layout.has_state(a)) {
        variables[at(a)] = On::variable(a);
      }
    }
    const auto cost_and_rates = description.rates(variables);
    On all = cost_and_rates.cost;
    rates[0] = function(all);
    for (int s = 0; s < kStates; ++s) {
      if (!layout.has_state(s)) continue;
      const On& rate = cost_and_rates.states[at(s)];
      rates[at(s + 1)] = function(rate);
      all += rate;
    }
    by_duration = function(all).by;
    for (int i = 0; i < layout.num_limits(); ++i) {
      const On on = description.limit(at(i), variables);
      limits.push_back(function(on));
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
  [[nodiscard]] static Function function(const On& on) {
    Function out;
    for (int a = 0; a < kLocals; ++a) {
      if (on.any[at(a)]) out.by.push_back(a);
      for (int b = 0; b <= a; ++b) {
        if (on.second[at(a)][at(b)]) out.second.push_back(Jet::pair(a, b));
      }
    }
    return out;
  }
};

/// What is kept of an evaluated point: of its rates the numbers that are not
/// always 0, unless a description has something smaller, `kept(yu)`, that its
/// rates follow from by `rates_of<Number>(kept)`, as numbers and as jets.
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
  using Structure = LocalStructure<kStates, kLocals>;
  [[nodiscard]] const Structure& local() const { return local_; }

  /// L and f at an evaluated point with their first two derivatives by states
  /// and controls.
  [[nodiscard]] Rates<Jet, kStates> second(int point) const {
    return as<Jet>(point);
  }
  /// The same at any point of the variables.
  [[nodiscard]] Rates<Jet, kStates> jets_at(const Locals& yu) const {
    if constexpr (kKeepsLess<Description>) {
      return description_.template rates_of<Jet>(description_.kept(yu));
    } else {
      return jets_of(description_, yu);
    }
  }
  [[nodiscard]] typename Structure::Numbers limit_at(int point,
                                                     int number) const {
    return {&local_.limits[at(number)],
            numbers_of(point) + starts_[local_.rates.size() + at(number)]};
  }

  /// Whether a limit depends on none but these states.
  [[nodiscard]] bool limit_is_of(int number,
                                 std::initializer_list<int> states) const {
    return std::ranges::all_of(local_.limits[at(number)].by, [&](int local) {
      return std::ranges::find(states, local) != states.end();
    });
  }

  /// Of each limit whether it depends on a control.
  [[nodiscard]] std::vector<bool> limits_of_control() const {
    std::vector<bool> out;
    for (const auto& limit : local_.limits) {
      out.push_back(!limit.by.empty() && limit.by.back() >= kControl);
    }
    return out;
  }

 protected:
  EvaluatedPoints(Description description, const Layout& layout)
      : description_(std::move(description)),
        num_points_(at(layout.num_points())),
        local_(description_, layout) {
    for (const auto& rate : local_.rates) {
      starts_.push_back(size_);
      if constexpr (!kKeepsLess<Description>) size_ += rate.size();
    }
    for (const auto& limit : local_.limits) {
      starts_.push_back(size_);
      size_ += limit.size();
    }
    make_room();
  }

  /// Before points are evaluated.
  void make_room() {
    if constexpr (kKeepsLess<Description>) kept_.resize(num_points_);
    numbers_.resize(num_points_ * size_);
  }
  /// \param here   the description that holds there
  /// \param asked  whether a limit is asked for, by its number; else it is 0
  /// \return why the point is none of the program; null if it is one
  template <class Asked>
  [[nodiscard]] const char* evaluate_point(int point, const Description& here,
                                           const Locals& yu, Asked&& asked) {
    double* const numbers = numbers_.data() + at(point) * size_;
    if constexpr (kKeepsLess<Description>) {
      kept_[at(point)] = here.kept(yu);
    } else {
      const Rates<Jet, kStates> rates = jets_of(here, yu);
      local_.rates[0].pack(rates.cost, numbers);
      for (std::size_t s = 0; s < kStates; ++s) {
        local_.rates[s + 1].pack(rates.states[s], numbers + starts_[s + 1]);
      }
    }
    if (const char* because = refusal(here, yu, point)) return because;
    if (local_.limits.empty()) return nullptr;
    each_limit(here, present(yu), asked, [&](std::size_t i, const Jet& value) {
      local_.limits[i].pack(value, numbers + starts_[local_.rates.size() + i]);
    });
    return nullptr;
  }

  /// Of an evaluated point the cost, by 0, and the rates, by s + 1.
  ///
  /// \tparam AnyJet  of the order that is looked at
  template <class AnyJet>
  [[nodiscard]] auto functions_at(int point) const {
    if constexpr (kKeepsLess<Description>) {
      return [this, rates = as<AnyJet>(point)](std::size_t number) {
        return typename Structure::template InJet<AnyJet>{
            &local_.rates[number],
            number == 0 ? &rates.cost : &rates.states[number - 1]};
      };
    } else {
      return [this, numbers = numbers_of(point)](std::size_t number) {
        return typename Structure::Numbers{&local_.rates[number],
                                           numbers + starts_[number]};
      };
    }
  }
  template <class Number>
  [[nodiscard]] Rates<Number, kStates> as(int point) const {
    if constexpr (kKeepsLess<Description>) {
      return description_.template rates_of<Number>(kept_[at(point)]);
    } else {
      const auto of = functions_at<Number>(point);
      Rates<Number, kStates> out{of(0).template unpacked<Number>(), {}};
      for (std::size_t s = 0; s < kStates; ++s) {
        out.states[s] = of(s + 1).template unpacked<Number>();
      }
      return out;
    }
  }

 private:
  [[nodiscard]] const double* numbers_of(int point) const {
    return numbers_.data() + at(point) * size_;
  }
  static auto kept_type() {
    if constexpr (kKeepsLess<Description>) {
      return decltype(std::declval<const Description&>().kept(Locals{})){};
    } else {
      return 0;
    }
  }
  using Kept = decltype(kept_type());

  [[nodiscard]] Rates<Jet, kStates> jets_of(const Description& here,
                                            const Locals& yu) const {
    if constexpr (requires { here.template jets<Jet>(yu); }) {
      return here.template jets<Jet>(yu);
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
      return here.refusal(yu, functions_at<FirstJet>(point)(0).value());
    } else {
      const auto of = functions_at<FirstJet>(point);
      for (std::size_t i = 0; i < local_.rates.size(); ++i) {
        if (!std::isfinite(of(i).value())) {
          return "the cost or a rate is not finite";
        }
      }
      return nullptr;
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
  std::size_t num_points_;
  std::size_t size_ = 0;  ///< of a point, in `numbers_`
  /// Of cost, rates and limits, in those of a point.
  std::vector<std::size_t> starts_;
  NotCopied<Kept> kept_;
  NotCopied<double> numbers_;

 protected:
  Structure local_;
};

}  // namespace brachisto::ocp
