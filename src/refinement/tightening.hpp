// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// From the free extremal to a coarse path under limits, by an interior-point
/// method.

#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "brachisto/solvers/ipopt.hpp"
#include "refinement/limit_relaxation.hpp"
#include "refinement/pass_protocol.hpp"
#include "transcription/limited_curve.hpp"

namespace brachisto {

/// Solves a row of programs on a coarse mesh, from limits that the free
/// extremal keeps to those of the scene, each from the solution before.
///
/// What solves returns whether there is a solution, which is then the last();
/// if not, the protocol says why. All share one budget of iterations.
class Tightening {
 public:
  /// What is given by reference must outlive this.
  ///
  /// \param scene  in natural units, with limits
  /// \param free   the extremal without them, with the end angle φ
  Tightening(const Scene& scene, const ExtremalCurve& free, double phi,
             const IpoptOptions& ipopt, PassProtocol& protocol);

  /// To the limits of the scene, in steps that adapt; the contact follows.
  [[nodiscard]] bool tighten();

  /// Where the contact at B cannot be followed: under the limits of the scene
  /// with the slope that C_B is built from held at one place after the other,
  /// until the slope at the end less that one changes its sign between two,
  /// whose root is closed in on. Where it does so nowhere, or jumps, there is
  /// no smooth contact.
  ///
  /// \pre a loosest()
  [[nodiscard]] bool bracket_contact();

  /// Under the limits of the scene once more, elements halved where what holds
  /// changes within them or next to them.
  ///
  /// \pre a last()
  [[nodiscard]] bool solve_finer();

  /// Fails because nothing was found beyond that share of the way to the limits
  /// of the scene, for the reason that the protocol tells so far.
  bool none_found(double reached);

  [[nodiscard]] const LimitRelaxation& relaxation() const {
    return relaxation_;
  }
  /// Under the first limits; nothing if there was no path under these.
  [[nodiscard]] const std::optional<LimitedCurve>& loosest() const {
    return loosest_;
  }
  /// \pre solved before
  [[nodiscard]] const LimitedCurve& last() const { return *last_; }

 private:
  using Inequalities = std::vector<PathInequality>;

  bool solve(const Inequalities& limits, const Mesh& mesh,
             const LimitedEnds& ends,
             const std::function<PrimalDual(const LimitedTime&)>& start,
             int most_iterations);
  bool solve_first(const Inequalities& limits, const Mesh& mesh,
                   const LimitedEnds& ends);
  bool solve_again(const Inequalities& limits, const Mesh& mesh,
                   const LimitedEnds& ends);
  /// Ends for limits, as the last solution suggests them.
  [[nodiscard]] std::optional<LimitedEnds> next_ends(
      const Inequalities& limits);

  /// A slope that C_B is built from and how far the end is off it [rad].
  struct Held {
    double phi, open;
  };
  bool none_at_rest();
  bool solve_held(double phi);
  [[nodiscard]] Held held();
  /// By bisection, for slopes may jump where arcs are born.
  bool close_in(Held a, Held b);

  /// Which limit the way ahead costs most.
  [[nodiscard]] std::string tightest(double reached) const;

  const Scene& scene_;
  const ExtremalCurve& free_;
  LimitRelaxation relaxation_;
  Inequalities limits_;  ///< of the scene
  LimitedEnds first_ends_;
  IpoptOptions ipopt_;
  int budget_;  ///< iterations that are left
  PassProtocol& protocol_;
  bool tightened_ = false;  ///< tighten() reached the limits of the scene
  bool end_held_ = false;   ///< see bracket_contact()
  std::optional<LimitedCurve> last_, loosest_;
};

}  // namespace brachisto
