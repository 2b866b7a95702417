// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Bounds of what a Taylor series leaves out.

#pragma once

#include <vector>

#include "proof/tape.hpp"

namespace brachisto::proof {

/// Of y' = f(y), y(0) in a box, all solutions at once: with N terms c_0 …
/// c_{N−1} of every node known (of an input c_N as well),
///
///     E_i ≥ Σ_{k > N} |c_k| ρ^k of an input,  T ≥ Σ_{k ≥ N} |c_k| ρ^k of a
///     node,
///
/// so that the series converge for |u| ≤ ρ. Norms ‖a‖ = Σ |a_k| ρ^k obey
/// ‖a b‖ ≤ ‖a‖ ‖b‖, which gives T of every node from those of its operands,
/// increasing with them. E is right if
///
///     ρ T_i(E)/(N + 1) ≤ E_i   for all rates f_i.
///
/// For let the sums of E up to k = K not exceed E. The rates' coefficients up
/// to K know only these, and c_{K+1} = f_K/(K + 1) with K ≥ N: the sums up to K
/// + 1 do not exceed ρ T(E)/(N + 1) either. So no fixed point theorem is
/// needed.
class Tails {
 public:
  explicit Tails(const TaylorSeries& series);

  /// Takes the terms of the series for discs of about this radius.
  void take(double rho);
  /// Looks for E on the disc of this radius.
  /// \return false if there is none that is found
  [[nodiscard]] bool bound(double rho);

  /// E of an input.
  [[nodiscard]] double input(std::size_t i) const { return inputs_[i]; }
  /// T of a node.
  [[nodiscard]] double of(const Node& node) const {
    return tails_[static_cast<std::size_t>(node.id)];
  }

 private:
  [[nodiscard]] bool pass();
  [[nodiscard]] double tail(std::size_t node) const;
  [[nodiscard]] double spill(std::size_t a, std::size_t b) const;
  [[nodiscard]] double norm(std::size_t node) const {
    return sums_[node * stride_];
  }
  [[nodiscard]] double sine(std::size_t argument, std::size_t sine,
                            std::size_t cosine) const;

  const TaylorSeries& series_;
  std::size_t terms_, stride_, nodes_;
  double taken_ = 1.0;            ///< radius that taken terms are scaled by
  std::vector<double> scaled_;    ///< |c_k| taken_^k, k < N, node by node
  std::vector<double> last_;      ///< of inputs, k = N
  std::vector<double> terms_at_;  ///< |c_k| ρ^k, k < N; a column more, 0
  std::vector<double> sums_;      ///< Σ_{j ≥ k} of these
  std::vector<double> last_at_;
  std::vector<double> inputs_, tails_;
};

}  // namespace brachisto::proof
