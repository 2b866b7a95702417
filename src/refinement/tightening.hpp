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

#include "brachisto/solvers/program_solvers.hpp"
#include "refinement/detour.hpp"
#include "refinement/limit_relaxation.hpp"
#include "refinement/pass_protocol.hpp"
#include "transcription/limited_curve.hpp"

namespace brachisto {

/// The limit that had the greatest share in giving way, and the path that came
/// nearest to keeping them all.
struct BlockingLimit {
  LimitedCurve nearest;
  std::size_t index;  ///< among the limits of the path
};

/// Solves the program of a scene under limits on a coarse mesh: first with
/// limits that give way at a price (nlp::Elastic), from the free extremal, then
/// with limits that do not.
///
/// What solves returns whether there is a solution, which is then the last();
/// if not, the protocol says why. All share one budget of iterations.
class Tightening {
 public:
  /// Rough is half of the mesh, wider tolerances, short passes, and no last one
  /// with limits that do not give way: most scenes need no more for their arcs
  /// to be read off.
  enum class Care { Rough, Full };

  /// What is given by reference must outlive this.
  ///
  /// \param scene  in natural units, with limits
  /// \param free   the extremal without them, with the end angle φ
  Tightening(const Scene& scene, const ExtremalCurve& free, double phi,
             const IpoptOptions& ipopt, PassProtocol& protocol,
             Care care = Care::Full);

  /// Takes no more iterations from now on than are left.
  void leave(int iterations) { budget_ = std::min(budget_, iterations); }

  /// Whether what is in the way leaves no way at all, or loads let the body not
  /// come down; then the protocol says so. Looked into once, however often it
  /// is asked.
  bool is_shut();

  /// To the limits of the scene, with the slopes of the free extremal if these
  /// let it keep them, else with others that do; the contact follows. If they
  /// give way as much at ten times the price, and free slopes do not help where
  /// slopes are sought, the outcome is Status::Infeasible.
  [[nodiscard]] bool tighten();

  /// The same from another path than the free extremal: a solution of the same
  /// limits, perhaps with other bounds, or what only looks like a motion.
  [[nodiscard]] bool tighten_from(const LimitedCurve& nearby);
  [[nodiscard]] bool tighten_from(RoughPath path);

  /// To the limits of the scene from a path that owes nothing to the free one:
  /// on a mesh of few elements at once at a high price, for at a low one the
  /// path would come near the free one first. The contact is closed.
  [[nodiscard]] bool tighten_cold(RoughPath path);

  /// Goes on from a path that keeps the limits of the scene.
  void take_tight(const LimitedCurve& found) { last_ = tight_ = found; }

  /// The same as tighten() from the next of other_ways() that leads to the
  /// limits of the scene. False if none of those that are left does, or half of
  /// the iterations are used up.
  [[nodiscard]] bool tighten_elsewhere();

  /// The same from the solution under limits that are looser.
  [[nodiscard]] bool tighten_after(const std::vector<PathInequality>& looser);

  /// Moves the slope that C_B is built from until it is that of the path's end,
  /// to what a mesh without junctions is worth; without effect where it is not
  /// sought. What is found then is last().
  ///
  /// \pre tighten() succeeded
  [[nodiscard]] bool close_contact();

  /// All contacts at B that are met under the limits of the scene where that
  /// slope is held at one place after the other, to both sides of that of
  /// last(); see bracket_contact().
  ///
  /// \pre tighten() succeeded
  [[nodiscard]] std::vector<LimitedCurve> contacts_along();

  /// Where the contact at B cannot be followed: under the limits of the scene
  /// with the slope that C_B is built from held at one place after the other,
  /// but where C_B itself is in the way, until the slope at the end less that
  /// one changes its sign between two, whose root is closed in on. Where it
  /// does so nowhere, or jumps, there is no smooth contact.
  ///
  /// \pre tighten() succeeded
  [[nodiscard]] bool bracket_contact();

  /// Under the limits of the scene once more, elements halved where what holds
  /// changes within them or next to them.
  ///
  /// \pre a last()
  [[nodiscard]] bool solve_finer();

  /// Under limits that the free extremal keeps, those of relaxation() at 0.
  [[nodiscard]] bool solve_loosest();

  /// Fails because nothing was found: because limits give way for good, or else
  /// for the reason that the protocol tells so far.
  bool none_found();

  /// Of the first tighten() if limits gave way in the end, and none succeeded.
  [[nodiscard]] std::optional<BlockingLimit> blocking() const {
    return tight_ ? std::nullopt : blocking_;
  }
  [[nodiscard]] const LimitRelaxation& relaxation() const {
    return relaxation_;
  }
  /// What tighten() found last under the limits of the scene, if anything.
  [[nodiscard]] const std::optional<LimitedCurve>& tight() const {
    return tight_;
  }
  /// \pre solved before
  [[nodiscard]] const LimitedCurve& last() const { return *last_; }
  /// The same, null if nothing was solved.
  [[nodiscard]] const LimitedCurve* any() const {
    return last_ ? &*last_ : nullptr;
  }

 private:
  using Inequalities = std::vector<PathInequality>;

  /// Of tolerances with full care.
  [[nodiscard]] double wider() const {
    return care_ == Care::Rough ? 30.0 : 1.0;
  }
  /// \param complementarity  with full care; see IpoptOptions
  [[nodiscard]] SolverResult run(nlp::Problem& problem, const PrimalDual& start,
                                 double complementarity, Pass pass);
  /// What was found, if anything was.
  bool take(const LimitedTime& problem, SolverResult result);
  /// The last solution, or else a rough path or the free extremal.
  [[nodiscard]] PrimalDual start_of(const LimitedTime& problem) const;
  bool solve_rigid(const Inequalities& limits, const Mesh& mesh,
                   const LimitedEnds& ends, Pass pass = Pass::Long);
  /// The same on the first mesh, from the free extremal.
  bool solve_anew(const Inequalities& limits);
  /// With limits that give way at a price.
  bool solve_elastic(const LimitedEnds& ends, double price);
  /// At rising prices, until the limits do not give way any more. False if they
  /// go on to.
  bool keep_limits(const LimitedEnds& ends);
  /// By how much each limit gives way, at most, for a start to keep it.
  [[nodiscard]] std::vector<double> give_of(LimitedTime& problem,
                                            const std::vector<double>& x) const;
  /// Of all constraints.
  /// \param most  of each limit
  [[nodiscard]] std::vector<double> give_of_rows(
      const LimitedTime& problem, const std::vector<double>& most) const;
  /// As the last solution has them, or else the path that is started from.
  [[nodiscard]] LimitedEnds known_ends() const;
  /// Ends for limits, as the last solution suggests them.
  [[nodiscard]] std::optional<LimitedEnds> next_ends(
      const Inequalities& limits);

  /// A slope that C_B is built from and how far the end is off it [rad].
  struct Held {
    double phi, open;
    /// Whether a contact lies between the two, or a jump.
    [[nodiscard]] bool beyond(const Held& other) const {
      return (open < 0.0) != (other.open < 0.0);
    }
  };
  /// Holds that slope further and further to one side of that of last(), as
  /// long as there are paths and two neighbours say to go on; slopes from which
  /// C_B lies where the limits do not let it are passed over, and have no
  /// neighbour beyond.
  void turn_end(double direction,
                const std::function<bool(const std::optional<Held>& before,
                                         const Held& here)>& go_on);
  /// Iterations and work.
  [[nodiscard]] bool has_more() const {
    return budget_ > 0 && !protocol_.stopped();
  }
  bool none_at_rest();
  /// Whether C_B(φ) keeps the limits of the place.
  [[nodiscard]] bool end_is_open(double phi) const;
  /// From where it starts, with the slope at B held at other values than one
  /// with which C_B is in the way.
  bool keep_limits_elsewhere(const LimitedEnds& ends);
  bool solve_held(double phi);
  [[nodiscard]] Held held();
  /// By bisection, for slopes may jump where arcs are born.
  bool close_in(Held a, Held b);

  /// The limit that has the greatest share in giving way.
  [[nodiscard]] std::optional<BlockingLimit> tightest() const;

  const Scene& scene_;
  const ExtremalCurve& free_;
  std::optional<RoughPath> rough_;                    ///< to start from instead
  std::optional<std::vector<RoughPath>> other_ways_;  ///< that are left
  LimitRelaxation relaxation_;
  Inequalities limits_;  ///< of the scene
  Care care_;
  Mesh mesh_;
  LimitedEnds first_ends_;
  IpoptOptions ipopt_;
  int budget_;  ///< iterations that are left
  PassProtocol& protocol_;
  bool end_held_ = false;     ///< see bracket_contact()
  std::optional<bool> shut_;  ///< see is_shut()
  std::optional<LimitedCurve> last_;
  std::optional<LimitedCurve> tight_;
  std::vector<double> give_;  ///< by constraint
  double given_way_ = 1.0;    ///< as a share of give_
  bool give_way_for_good_ = false;
  std::optional<BlockingLimit> blocking_;
};

}  // namespace brachisto
