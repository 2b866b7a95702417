// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Rates along the share of a rolling time, with a first guess of the control
/// from the places about.

#pragma once

#include <array>
#include <cstddef>

namespace brachisto::lanes::detail {

/// The control at the places of the last stages, and by the parabola through
/// three of them about at another one: stages come back and forth, and the last
/// one may be far.
template <class Number>
class LastControls {
 public:
  [[nodiscard]] Number near(double sigma) const {
    Number out(0.0);
    for (std::size_t i = 0; i < known_; ++i) {
      double weight = 1.0;
      for (std::size_t j = 0; j < known_; ++j) {
        if (j != i) weight *= (sigma - at_[j]) / (at_[i] - at_[j]);
      }
      out = out + controls_[i] * Number(weight);
    }
    return out;
  }
  [[nodiscard]] bool any() const { return known_ > 0; }
  void see(double sigma, const Number& control) {
    // A place that comes again keeps its turn: no two are the same.
    std::size_t place = 0;
    while (place < known_ && at_[place] != sigma) ++place;
    if (place == known_) {
      place = known_ < kMost ? known_++ : oldest_;
      if (known_ == kMost) oldest_ = (place + 1) % kMost;
    }
    at_[place] = sigma;
    controls_[place] = control;
  }

 private:
  static constexpr std::size_t kMost = 3;
  std::array<double, kMost> at_{};
  std::array<Number, kMost> controls_{};
  std::size_t known_ = 0, oldest_ = 0;
};

/// The rates of a flow by the share σ = u/U of each scene's own rolling time.
template <class Inner, class Number>
struct ByShare {
  using Stack = typename Inner::Stack;

  Inner inner;
  Number rolling_time;
  LastControls<Number>* controls;  ///< one for all copies of this
  bool failed = false;

  void operator()(const Stack& stack, Stack& rates, double sigma) {
    if (controls->any()) inner.control = controls->near(sigma);
    inner(stack, rates, sigma);
    controls->see(sigma, inner.control);
    failed = inner.failed;
    for (Number& rate : rates) rate = rate * rolling_time;
  }
};

}  // namespace brachisto::lanes::detail
