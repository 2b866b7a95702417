// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Whether an extremal is a minimum: extremals next to it that leave A with
/// other costates, compared where they have the same length.
///
/// They have a determinant whose sign does not change before a conjugate point;
/// and at B the least time by paths of given length to there has to be a
/// minimum in that length.

#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include "model/field_formulas.hpp"

namespace brachisto::lanes::detail {

enum : std::size_t { kX, kZ, kTheta, kW, kPX, kPZ, kPTheta, kPW };

/// Without losses: by length the states are x and z alone. Their derivatives by
/// two costates at the start, those by p across the pull G there and by p_θ, at
/// the same θ. A third would belong to the gauge, p + μ ∇(w²/2 + Φ), ∇Φ = −G,
/// which changes nothing.
template <class Rates>
class FreeNeighbours {
 public:
  using Number = typename Rates::Number;
  using Stack = typename Rates::Stack;

  /// So much of the way has too little between neighbours to be seen.
  static constexpr double kUnseen = 0.0;
  /// The sign of the determinant before a conjugate point; 0: as it begins.
  ///
  /// \param slope  at the start
  [[nodiscard]] static Number sign_at_first(const Stack&) {
    return Number(0.0);
  }

  /// \param slope    by how much a stack changes with u or with a share of it
  /// \param problem  FallingLanes
  /// \param first    the pull at the start
  FreeNeighbours(const Stack& at, const Stack& slope, const auto& problem,
                 const Pull<Number>& first, const Number& c, const Number& s)
      : at_(at),
        slope_(slope),
        turn_(problem.rotation_per_length()),
        c_(c),
        s_(s) {
    const Number size = sqrt(first.x * first.x + first.z * first.z);
    across_ = {first.z / size, -(first.x / size)};
    const Pull<Number> G = problem.pull(at);
    weight_ = (G.z * cos(at[kTheta]) - G.x * sin(at[kTheta])) *
              problem.bodies().eta_m / turn_;
    for (std::size_t j = 0; j < 2; ++j) {
      const Number length = derivative(kTheta, j) / turn_;
      x_[j] = derivative(kX, j) - c * length;
      z_[j] = derivative(kZ, j) - s * length;
    }
  }
  [[nodiscard]] Number determinant() const {
    return x_[0] * z_[1] - x_[1] * z_[0];
  }
  /// The same as a share of its size.
  [[nodiscard]] Number share() const {
    const auto size = [](const Number& a, const Number& b) {
      return abs(a) + abs(b);
    };
    return determinant() / (size(x_[0], z_[0]) * size(x_[1], z_[1]));
  }

  /// ∂²T/∂S² with x and z held, of the least time by a path of length S:
  /// ∂T/∂S = −P_θ/r with P_θ = p_θ + p_w r η G·(−sin θ, cos θ)/w, the costate
  /// with the gauge in which p_w = 0, as it is at B.
  ///
  /// \param U  what the slope is multiplied with
  [[nodiscard]] Number by_length(const Number& U) const {
    const Number& w = at_[kW];
    const Number weight = weight_ / w;
    const auto gauged = [&](const Number& p_theta, const Number& p_w) {
      return p_theta + weight * p_w;
    };
    const Number along = gauged(slope_[kPTheta] / U, slope_[kPW] / U) / w;
    std::array<Number, 2> across;
    for (std::size_t j = 0; j < 2; ++j) {
      across[j] = gauged(derivative(kPTheta, j), derivative(kPW, j)) -
                  along * (derivative(kTheta, j) / turn_);
    }
    // a (x, z)_1 + b (x, z)_2 = −(c, s): the ends stay where they are.
    const Number det = determinant();
    const Number a = (x_[1] * s_ - z_[1] * c_) / det;
    const Number b = (z_[0] * c_ - x_[0] * s_) / det;
    return -(turn_ * (a * across[0] + b * across[1] + along));
  }

 private:
  /// Of a component, by p across the pull or by p_θ.
  [[nodiscard]] Number derivative(std::size_t i, std::size_t j) const {
    const auto by = [&](std::size_t costate) {
      return Rates::derivative(at_, i, costate);
    };
    return j == 0 ? Number(by(kPX) * across_.x + by(kPZ) * across_.z)
                  : by(kPTheta);
  }

  const Stack &at_, &slope_;
  Number turn_, c_, s_;
  InPlane<Number> across_;
  Number weight_;
  std::array<Number, 2> x_, z_;
};

/// In air w is a state of its own. In its place stands the energy that was
/// lost, −Φ − w²/2, of which nothing cancels where little is.
template <class Rates>
class BrakedNeighbours {
 public:
  using Number = typename Rates::Number;
  using Stack = typename Rates::Stack;

  // The determinant grows with a higher power of u and with the square of the
  // drag: at an eighth of the way, 1/64 of the path, from 1e-5 of the latter,
  // before from less than rounding leaves.
  static constexpr double kUnseen = 0.125;
  /// By the costates of the states themselves it is that of three steps against
  /// Legendre's ∂²𝓗/∂β² > 0, negative. Here −w stands for w, and p_θ for p_w,
  /// ∂p_w/∂p_θ = −θ'/w' by 𝓗 = 0. It is not asked how the determinant begins:
  /// in thin air that may be truncation.
  [[nodiscard]] static Number sign_at_first(const Stack& slope) {
    return where(slope[kW] > Number(0.0), Number(-1.0), Number(1.0));
  }

  BrakedNeighbours(const Stack& at, const Stack& slope, const auto& problem,
                   const Pull<Number>&, const Number& c, const Number& s)
      : w_(at[kW]), turn_(problem.rotation_per_length()) {
    const Pull<Number> G = problem.pull(at);
    const auto fall = [&](const Number& x, const Number& z) {
      return G.x * x + G.z * z;
    };
    const auto along = [&](std::size_t i) {
      return slope[i] / slope[kTheta] * turn_;
    };
    along_ = {c, s, fall(c, s) - w_ * along(kW)};
    p_w_along_ = along(kPW);
    p_theta_along_ = along(kPTheta);
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t by = kPX + j;
      const Number length = Rates::derivative(at, kTheta, by) / turn_;
      const auto held = [&](std::size_t i, const Number& rate) {
        return Rates::derivative(at, i, by) - rate * length;
      };
      x_[j] = held(kX, c);
      z_[j] = held(kZ, s);
      lost_[j] = fall(x_[j], z_[j]) - w_ * held(kW, along(kW));
      p_w_[j] = held(kPW, p_w_along_);
      p_theta_[j] = held(kPTheta, p_theta_along_);
    }
  }
  [[nodiscard]] Number determinant() const { return dot(x_, cross(z_, lost_)); }
  [[nodiscard]] Number share() const {
    Number size(1.0);
    for (std::size_t j = 0; j < 3; ++j) {
      size = size * (abs(x_[j]) + abs(z_[j]) + abs(lost_[j]));
    }
    return determinant() / size;
  }

  /// The same with w free too. T(w, S) with x and z held has the derivatives
  /// −p_w and −p_θ/r, and its minimum over w the second one
  ///
  ///     T_SS − T_wS²/T_ww,   T_ww > 0.
  [[nodiscard]] Number by_length(const Number&) const {
    const Number none(std::numeric_limits<double>::quiet_NaN());
    // Where one of both grows by 1.
    const Vector by_w = following({Number(0.0), Number(0.0), -w_});
    const Vector by_S = following({-along_[0], -along_[1], -along_[2]});
    const Number T_ww = -dot(p_w_, by_w);
    const Number T_wS = -(dot(p_w_, by_S) + p_w_along_);
    const Number T_SS = -(turn_ * (dot(p_theta_, by_S) + p_theta_along_));
    return where(T_ww > Number(0.0), Number(T_SS - T_wS * T_wS / T_ww), none);
  }

 private:
  using Vector = std::array<Number, 3>;

  [[nodiscard]] static Number dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
  [[nodiscard]] static Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0]};
  }
  /// How costates at the start go with a change of (x, z, lost) here.
  [[nodiscard]] Vector following(const Vector& change) const {
    const Vector a = cross(z_, lost_), b = cross(lost_, x_), c = cross(x_, z_);
    const Number det = dot(x_, a);
    Vector out;
    for (std::size_t j = 0; j < 3; ++j) {
      out[j] = (a[j] * change[0] + b[j] * change[1] + c[j] * change[2]) / det;
    }
    return out;
  }

  Number w_, turn_;
  Vector along_;  ///< of (x, z, lost), per length
  Number p_w_along_, p_theta_along_;
  Vector x_, z_, lost_, p_w_, p_theta_;
};

/// The determinant on the way; what is no number stays.
template <class Number>
struct Jacobi {
  Number first;  ///< of its sign; 0: the first that is seen
  Number least{std::numeric_limits<double>::infinity()}, last{0.0};
  void see(const Number& now) {
    first = where(Number(first * first) > Number(0.0), first, now);
    last = where(first > Number(0.0), now, Number(-now));
    least = where(last < least, last, least) + (last - last);
  }
};

}  // namespace brachisto::lanes::detail
