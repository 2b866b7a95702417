// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// τ as a function of the body: each value is a whole closed solution, its
/// contacts where they belong.

#pragma once

#include <Eigen/Core>
#include <array>
#include <atomic>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "brachisto/study/design.hpp"
#include "brachisto/study/solve.hpp"
#include "design/design_space.hpp"
#include "math/wall_clock.hpp"

namespace brachisto {

/// The options of a solve that is to end by then.
/// \throws Stopped  if that time has come
[[nodiscard]] SolveOptions options_until(SolveOptions options,
                                         WallClock::time_point end);
/// atan μ less the friction angle that a motion needs [rad].
[[nodiscard]] double grip_margin(const Motion& motion, const MaxGrip& max_grip);

/// How far a body is from losing its track, all > 0 where it does not. The
/// first is of the branch: with q = dφ/dκ, how the contact at B answers to a
/// kink, atan q, which is 0 where the track ceases to be a minimum between its
/// ends and ±π/2 where the branch turns; 1 where that is not known.
///
/// The others are of a body that can run on its track: the smallest R_n after
/// its first rise [m g], R_n at the start, or where that is 0 how it rises
/// there, dR_n/du √(H/g) [m g], the smallest 1 − r κ_c, the distance of B from
/// the body at its start [r], and, of a design with MaxGrip, grip_margin().
/// That tracks cross themselves has no number.
inline constexpr std::array<std::string_view, 6> kMargins{
    "branch", "normal_force", "start", "fold_margin", "room", "max_grip.mu"};
inline constexpr std::string_view kBranchMargin = kMargins.front();
inline constexpr std::size_t kGripMargin = kMargins.size() - 1;
using Margins = Eigen::Vector<double, kMargins.size()>;

/// The first of them.
/// \param contact_response  see Sensitivities
[[nodiscard]] double branch_margin(double contact_response);
/// \param contact_response  see Sensitivities
/// \param max_grip          if there is none, its margin is 1
[[nodiscard]] Margins margins_of(const Solution& solution,
                                 double contact_response,
                                 const std::optional<MaxGrip>& max_grip);

/// d(margins)/d(traits).
using MarginGradient = Eigen::Matrix<double, kMargins.size(), 4>;

/// Where the track of a body is sought.
enum class Follow {
  Neighbours,  ///< beside the last body that was held on to
  Principal,   ///< from the cycloid, through folds if need be: τ may jump
};

/// Solves a scene for one body after the other, and stays on one branch: what
/// cannot be followed is refused. Lanes solve what they can, which is all on
/// the principal branch; from where a body had to be followed from its
/// neighbour on, the others are followed from theirs.
class ClosedTimes {
 public:
  /// \param options    of every solve; their limit of time, which begins now,
  ///                   is that of all solves together
  /// \param max_grip   that margins are told of
  /// \param interrupt  nonzero: stop; may be null
  ClosedTimes(Scene scene, const SolveOptions& options,
              std::optional<MaxGrip> max_grip,
              const std::atomic<int>* interrupt);

  /// Moves to a body. False if it is refused: refusal() says why.
  /// \param wanted  nonzero for those traits that τ is to have derivatives by
  /// \throws Stopped  if a limit of time or the interrupt ends its solve
  [[nodiscard]] bool move_to(const Traits& traits, const Traits& wanted);
  /// Bodies that come are followed from here.
  void hold_on();
  /// Solves with other options from now on.
  void use(const SolveOptions& options);
  /// Forgets what it holds on to, but for what is on the principal branch as
  /// lanes are: the next body is solved from the cycloid, and those after it as
  /// is said.
  void begin(Follow follow) {
    follow_ = follow;
    held_.reset();
    held_alone_ = false;
    if (follow == Follow::Principal) held_in_lanes_.reset();
    followed_ = held_followed_ = false;
  }

  [[nodiscard]] const Solution& solution() const { return solution_; }
  [[nodiscard]] double tau() const { return solution_.motion()->tau(); }
  [[nodiscard]] double branch_margin() const {
    return brachisto::branch_margin(contact_response_);
  }
  [[nodiscard]] Margins margins() const {
    return margins_of(solution_, contact_response_, max_grip_);
  }
  /// dτ/d(traits), the contacts moving along.
  [[nodiscard]] const Traits& gradient() const { return gradient_; }
  /// By central differences of whole solves, of the traits
  /// that `wanted` is nonzero for.
  [[nodiscard]] MarginGradient margin_gradient(const Traits& wanted);

  [[nodiscard]] const std::optional<MaxGrip>& max_grip() const {
    return max_grip_;
  }
  [[nodiscard]] const std::string& refusal() const { return refusal_; }
  /// Of the time for all solves.
  [[nodiscard]] WallClock::time_point end() const { return end_; }
  [[nodiscard]] int solves() const { return solves_; }
  [[nodiscard]] double cpu_seconds() const { return cpu_seconds_; }

 private:
  /// A solution, and whether it was followed from its neighbour.
  struct Solved {
    Solution solution;
    bool followed = false;
  };
  [[nodiscard]] Solved solved(const Body& body, const Neighbour* neighbour);
  /// In lanes, as far as they can.
  [[nodiscard]] std::vector<std::optional<Solution>> in_lanes(
      const std::vector<Scene>& scenes, const Solution* beside);
  /// The same track on a mesh, to follow others from; null if the body's own
  /// solve comes to another one.
  [[nodiscard]] std::shared_ptr<const Neighbour> on_a_mesh(
      const Solution& from_lanes);
  [[nodiscard]] Scene scene_of(const Traits& traits, const Body& like) const;
  /// The margins of bodies next to this one; nothing where there are none.
  [[nodiscard]] std::vector<std::optional<Margins>> margins_at(
      const std::vector<Traits>& places);

  Scene scene_;
  SolveOptions options_;
  std::optional<MaxGrip> max_grip_;
  const std::atomic<int>* interrupt_;
  WallClock::time_point end_;
  Traits here_ = Traits::Zero();
  Solution solution_;
  Traits gradient_ = Traits::Zero();
  double contact_response_ = 0.0;
  Follow follow_ = Follow::Neighbours;
  std::shared_ptr<const Neighbour> held_;
  std::shared_ptr<const Solution> held_in_lanes_;
  bool followed_ = false, held_followed_ = false;
  bool held_alone_ = false;  ///< what lanes found is not found on a mesh
  std::string refusal_;
  int solves_ = 0;
  double cpu_seconds_ = 0.0;
};

}  // namespace brachisto
