// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/without_arcs.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "brachisto/math/index.hpp"
#include "math/dense.hpp"
#include "nlp/elastic.hpp"
#include "refinement/arc_elements.hpp"
#include "refinement/open_conditions.hpp"
#include "trajectory/reintegration.hpp"

namespace brachisto {

namespace {

/// What is done first where a path exceeds a limit between the points of its
/// mesh, as it does where the control jumps: elements are quartered as long as
/// to draw their bounds in would cost much, or bounds are drawn in, and what
/// then costs much is quartered. Where the one leads nowhere the other may.
enum class First { DrawnIn, Finer };

/// By element, then limit.
using Margins = std::vector<std::vector<double>>;

double sum_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

class WithoutArcs {
 public:
  /// \param tolerance  relative, of T
  WithoutArcs(const LimitedCurve& coarse, double tolerance,
              const IpoptOptions& ipopt, PassProtocol& protocol)
      : scene_(coarse.problem().scene()),
        limits_(coarse.problem().limits()),
        tolerance_(tolerance),
        ipopt_(ipopt),
        protocol_(protocol),
        curve_(coarse),
        ends_(coarse.problem().ends()) {}

  /// To where it matters what is done first. False if a mesh has no solution.
  [[nodiscard]] bool begin() {
    if (!close(curve_.problem().mesh())) return false;
    at_changes_ = halve_at_changes(kShare * tolerance_);
    before_ = curve_.transit_time();
    protocol_.message.clear();
    if (close(halved(curve_.problem().mesh()))) return true;
    return not_accurate(protocol_.message);
  }
  /// On from there.
  [[nodiscard]] SolvedWithoutArcs go_on(First first) {
    auto path = accurate(first);
    return {std::move(path), closed_};
  }
  [[nodiscard]] const std::optional<LimitedCurve>& closed() const {
    return closed_;
  }

 private:
  /// Of the tolerance, for what is one of several.
  static constexpr double kShare = 0.1;

  [[nodiscard]] std::optional<PathWithoutArcs> accurate(First first) {
    constexpr int kMostRounds = 8;
    constexpr double kMostCost = 0.3, kLess = 0.6, kHalf = 0.5;
    // An error of order three or more has lost seven eighths by a halving.
    constexpr double kSmooth = 1.0 / 7.0;
    // What the certificate lets slack times multiplier come to.
    constexpr double kComplementarity = 0.1;
    double of_halving = 0.0;
    double cost_before = std::numeric_limits<double>::infinity();
    Mesh next;
    bool everywhere = true;  // it is finer
    std::string because;
    for (int i = 0; i < kMostRounds; ++i) {
      ends_as_it_does_ = false;
      protocol_.message.clear();
      if (i > 0 && !close(next)) {
        because = protocol_.message;
        break;
      }
      // With least margins, as before: what the mesh alone has changed.
      const double free_time = curve_.transit_time();
      const double changed =
          std::abs(free_time / std::exchange(before_, free_time) - 1.0);
      if (everywhere) of_halving = changed;
      // Where no more elements came the halving tells: of smooth stretches; and
      // of changes what the last ones there did.
      const double elsewhere =
          std::min(2.0 * of_halving, kSmooth * of_halving + 2.0 * at_changes_);
      const double of_mesh =
          everywhere ? 2.0 * changed : std::max(2.0 * changed, elsewhere);
      const double cost = sum_of(cost_of_keeping());
      next = finer_where_costly(kShare * tolerance_);
      everywhere = false;
      if (first == First::Finer && i + 1 < kMostRounds &&
          next.num_elements() <= kMostElements &&
          cost > kMostCost * tolerance_) {
        if (cost > kLess * cost_before) break;  // it does not help
        cost_before = cost;
        continue;
      }
      if (keep_between()) {
        const double drawn_in = sum_of(cost_of_keeping());
        const double others =
            of_mesh + std::abs(curve_.transit_time() / free_time - 1.0) +
            mismatch_.largest() + kRounding;
        double error = (1.0 + kComplementarity) * (others + drawn_in);
        if (error <= tolerance_) {
          error = (1.0 + kComplementarity) *
                  (others + std::max(drawn_in, cost_of_margins()));
        }
        protocol_.record.estimated_error = error;
        protocol_.keep_record("mesh", curve_.transit_time());
        if (error <= tolerance_) {
          return PathWithoutArcs{{{}, ends_, curve_, mismatch_}, error};
        }
      }
      const Mesh& mesh = curve_.problem().mesh();
      next = finer_where_costly(kShare * tolerance_);
      everywhere = next.num_elements() == mesh.num_elements() ||
                   of_mesh > kHalf * tolerance_;
      if (everywhere) next = halved(mesh);
      if (next.num_elements() > kMostElements) break;
    }
    static_cast<void>(not_accurate(because));
    return std::nullopt;
  }
  bool not_accurate(const std::string& because) {
    return protocol_.fail(Status::NotConverged,
                          "without arcs the mesh did not become accurate" +
                              (because.empty() ? "" : ": " + because));
  }

  /// Elements in which what holds changes, until T changes by no more than so
  /// much, relative, or the contact is not closed any more.
  /// \return what it changed by last
  double halve_at_changes(double enough) {
    constexpr int kMostMeshes = 12;
    double change = 1.0;
    for (int i = 0; i < kMostMeshes && change > enough; ++i) {
      const Mesh next = finer_at_changes(curve_);
      if (next.num_elements() > kMostElements) break;
      const LimitedCurve last = curve_;
      const LimitedEnds last_ends = ends_;
      if (!close(next)) {
        curve_ = last;
        ends_ = last_ends;
        break;
      }
      change = std::abs(curve_.transit_time() / last.transit_time() - 1.0);
    }
    return change;
  }

  static constexpr int kMostElements = 800;
  static constexpr double kRounding = 1e-13;
  /// What limits are kept by in any case, well above what a certificate allows
  /// them to be exceeded by.
  static constexpr double kLeastMargin = 1e-7;

  [[nodiscard]] Margins least_margins(const Mesh& mesh) const {
    return Margins(at(mesh.num_elements()),
                   std::vector<double>(limits_.size(), kLeastMargin));
  }

  /// On a mesh, from the last path.
  [[nodiscard]] bool close(const Mesh& mesh) {
    margins_ = least_margins(mesh);
    if (!close_contact(mesh)) return false;
    closed_ = curve_;
    return true;
  }

  [[nodiscard]] LimitedTime problem_on(const Mesh& mesh,
                                       const LimitedEnds& ends) const {
    LimitedTime problem(scene_, limits_, mesh, ends);
    problem.draw_in(margins_);
    problem.bound_slopes(std::numbers::pi);
    return problem;
  }

  /// The slopes that the contacts are built from, by Broyden's method from the
  /// fixed-point iteration on.
  /// \param near  the last path is one on this mesh with nearly these bounds
  [[nodiscard]] bool close_contact(const Mesh& mesh, bool near = false) {
    constexpr int kMostPasses = 40;
    constexpr double kClosed = 1e-10, kLargestStep = 0.1, kSmallestStep = 1e-3;
    auto ends = with_start(ends_, scene_, limits_, curve_.holds_control(0));
    if (!ends || !solve(problem_on(mesh, *ends), near)) return false;
    ends_ = *ends;
    Eigen::VectorXd open = open_now();
    Eigen::MatrixXd B = -Eigen::MatrixXd::Identity(open.size(), open.size());
    double largest = kLargestStep;
    for (int i = 0; i < kMostPasses; ++i) {
      if (mismatch_.largest() <= kClosed) return true;
      Eigen::VectorXd step = math::solve_next_to_singular(B, -open);
      if (!step.allFinite()) return false;
      step *= std::min(1.0, largest / step.cwiseAbs().maxCoeff());
      ends = moved(ends_, step);
      if (!solve(problem_on(mesh, *ends), true)) {
        largest = 0.3 * step.cwiseAbs().maxCoeff();
        if (largest < kSmallestStep || protocol_.stopped()) return false;
        continue;
      }
      ends_ = *ends;
      const Eigen::VectorXd before = std::exchange(open, open_now());
      B += (open - before - B * step) * step.transpose() / step.squaredNorm();
    }
    return protocol_.fail(Status::NotConverged,
                          "without arcs the contact was not closed");
  }
  [[nodiscard]] Eigen::VectorXd open_now() {
    mismatch_ = mismatch_of(curve_, ends_);
    if (ends_as_it_does_ && end_is_sought(scene_)) {
      mismatch_.at_B = curve_.at(1.0).state.beta - ends_.phi;
    }
    std::vector<double> out;
    if (end_is_sought(scene_)) out.push_back(mismatch_.at_B);
    if (start_is_sought(scene_, ends_)) out.push_back(mismatch_.at_A);
    return Eigen::Map<Eigen::VectorXd>(out.data(),
                                       static_cast<Eigen::Index>(out.size()));
  }
  [[nodiscard]] LimitedEnds moved(LimitedEnds ends,
                                  const Eigen::VectorXd& step) const {
    Eigen::Index i = 0;
    if (end_is_sought(scene_)) ends.phi += step[i++];
    if (start_is_sought(scene_, ends)) *ends.start += step[i];
    return ends;
  }

  /// \param near  the last path is one of a scene next to this one
  [[nodiscard]] bool solve(LimitedTime problem, bool near) {
    constexpr double kComplementarity = 1e-13;
    if (protocol_.stopped()) return false;
    PrimalDual start = near ? curve_.point() : prolong(curve_, problem);
    if (near && polish(problem, start)) return true;
    SolverResult result = run(problem, start, kComplementarity);
    if (result.status != Status::Solved && !protocol_.stopped()) {
      if (!give_way(problem, start)) return false;
      result = run(problem, start, kComplementarity);
    }
    if (result.status != Status::Solved) {
      return protocol_.fail(Status::NotConverged,
                            "without arcs: " + result.message);
    }
    if (!polish(problem, result.point)) {
      curve_ = LimitedCurve(problem, std::move(result.point));
    }
    return true;
  }
  [[nodiscard]] SolverResult run(nlp::Problem& problem, const PrimalDual& start,
                                 double complementarity) {
    constexpr double kTolerance = 1e-11;
    IpoptOptions ipopt = of_pass(Pass::Short, protocol_.left(ipopt_), problem);
    ipopt.tolerance = std::max(ipopt.tolerance, kTolerance);
    ipopt.complementarity = complementarity;
    SolverResult result = solve_with_ipopt(problem, start, ipopt);
    protocol_.add(result, problem);
    return result;
  }
  /// Moves a start to where limits that give way at a price are kept.
  [[nodiscard]] bool give_way(LimitedTime& problem, PrimalDual& start) {
    constexpr double kGive = 0.1, kPrice = 100.0, kNone = 1e-6;
    constexpr double kComplementarity = 1e-9;
    const VariableLayout& layout = problem.layout();
    std::vector<double> give(at(problem.num_constraints()), 0.0);
    for (int i = 0; i < layout.num_limits(); ++i) {
      for (int c = 0; c < layout.num_points(); ++c) {
        const int row = layout.limit(c, i);
        if (problem.constraint_range(row).bounded()) give[at(row)] = kGive;
      }
    }
    nlp::Elastic elastic(problem, give, kPrice);
    SolverResult result =
        run(elastic, elastic.with_elasticity(start, 1.0), kComplementarity);
    if (result.status != Status::Solved || result.point.x.back() > kNone) {
      return protocol_.fail(Status::NotConverged,
                            "without arcs: " + result.message);
    }
    start = elastic.without_elasticity(std::move(result.point));
    return true;
  }
  [[nodiscard]] bool polish(LimitedTime& problem, const PrimalDual& start) {
    NewtonOptions newton;
    newton.tolerance = 1e-11;
    newton.to_rounding = true;
    newton.chain_alone = true;
    newton.stop = ipopt_.stop;
    NewtonResult result = solve_with_newton(problem, start, newton);
    protocol_.record.newton_steps += result.iterations;
    protocol_.book(result.iterations, problem);
    if (result.status != Status::Solved || !result.active_set_holds) {
      return false;
    }
    curve_ = LimitedCurve(problem, std::move(result.point));
    return true;
  }

  /// Draws bounds in until limits are kept between the points, by the solution
  /// and by the motion that its control makes: more where that did not do, for
  /// between the points of an element in which the control jumps a limit may
  /// hardly follow what it is drawn in by. The track is to end where the
  /// path does, whose slope there is less accurate than that of costates.
  [[nodiscard]] bool keep_between() {
    constexpr int kMostPasses = 12;
    constexpr double kMore = 1.2, kMoreOfMotion = 2.0;
    constexpr double kMoreEachTime = 2.0;
    ends_as_it_does_ = true;
    std::vector<double> more(margins_.size(), kMore);  // by element
    for (int i = 0; i < kMostPasses; ++i) {
      const Mesh mesh = curve_.problem().mesh();
      if (!close_contact(mesh)) return false;
      bool kept = true;
      for (int e = 0; e < mesh.num_elements(); ++e) {
        const Excess excess = curve_.excess_on(e);
        if (!std::isfinite(excess.value)) return false;
        if (excess.value <= kAllowedExcess) continue;
        kept = false;
        margins_[at(e)][at(excess.limit)] += more[at(e)] * excess.value;
        more[at(e)] *= kMoreEachTime;
      }
      if (!kept) continue;
      const double of_motion = reintegrate(curve_).excess;
      if (of_motion <= kAllowedExcess) return true;
      for (std::vector<double>& margins : margins_) {
        for (double& margin : margins) margin += kMoreOfMotion * of_motion;
      }
    }
    return protocol_.fail(Status::NotConverged,
                          "without arcs limits were not kept between points");
  }

  /// What it costs on each element that limits are kept between its points, as
  /// a share of T: to first order by how much bounds are drawn in, times their
  /// multipliers, and what they are still exceeded by, times the largest
  /// multiplier next to it. Where the control jumps that of the limit itself is
  /// about zero until its bound is drawn in.
  [[nodiscard]] std::vector<double> cost_of_keeping() const {
    const LimitedTime& problem = curve_.problem();
    const Mesh& mesh = problem.mesh();
    const int p = mesh.degree, N = mesh.num_elements();
    std::vector<double> cost;
    for (int e = 0; e < N; ++e) {
      double sum = 0.0;
      for (int c = e * p; c < (e + 1) * p; ++c) {
        for (int i = 0; i < problem.layout().num_limits(); ++i) {
          sum +=
              problem.margin(c, i) *
              std::abs(curve_.point().lambda[at(problem.layout().limit(c, i))]);
        }
      }
      const double excess = curve_.excess_on(e).value;
      if (excess > kAllowedExcess) {
        sum +=
            excess * mesh.length(e) * curve_.rolling_time() *
            curve_.largest_multiplier(std::max(0, e - 1), std::min(N, e + 2));
      }
      cost.push_back(sum / curve_.transit_time());
    }
    return cost;
  }
  /// What it costs that bounds are drawn in where the contacts move along,
  /// which multipliers do not know of: twice what the last half of it costs, as
  /// a share of T, for the more bounds are drawn in the more that costs.
  /// Infinite if the half has no solution.
  [[nodiscard]] double cost_of_margins() const {
    if (!end_is_sought(scene_) && !start_is_sought(scene_, ends_)) return 0.0;
    WithoutArcs half(*this);
    for (std::vector<double>& margins : half.margins_) {
      for (double& margin : margins) margin *= 0.5;
    }
    if (!half.close_contact(curve_.problem().mesh(), true)) {
      return std::numeric_limits<double>::infinity();
    }
    return 2.0 *
           std::abs(half.curve_.transit_time() / curve_.transit_time() - 1.0);
  }
  /// Elements that cost more than their share of so much are quartered: bounds
  /// are then drawn in along a stretch a quarter as long.
  [[nodiscard]] Mesh finer_where_costly(double most) const {
    constexpr int kPieces = 4;
    const Mesh& mesh = curve_.problem().mesh();
    const std::vector<double> cost = cost_of_keeping();
    Mesh next{mesh.degree, {0.0}};
    for (int e = 0; e < mesh.num_elements(); ++e) {
      const bool costly = cost[at(e)] * mesh.num_elements() > most;
      for (int piece = 1; costly && piece < kPieces; ++piece) {
        next.boundaries.push_back(
            mesh.sigma(e, static_cast<double>(piece) / kPieces));
      }
      next.boundaries.push_back(mesh.boundaries[at(e + 1)]);
    }
    return next;
  }

  Scene scene_;
  std::vector<PathInequality> limits_;
  double tolerance_;
  IpoptOptions ipopt_;
  PassProtocol& protocol_;
  LimitedCurve curve_;
  double before_ = 0.0;      ///< T on the last mesh
  double at_changes_ = 0.0;  ///< what T changed by last as they were halved
  std::optional<LimitedCurve> closed_;  ///< see SolvedWithoutArcs
  LimitedEnds ends_;
  ContactMismatch mismatch_;
  bool ends_as_it_does_ = false;  ///< see keep_between()
  Margins margins_;
};

}  // namespace

void solve_without_arcs(
    const LimitedCurve& coarse, double tolerance, const IpoptOptions& ipopt,
    PassProtocol& protocol,
    const std::function<bool(SolvedWithoutArcs solved)>& suffices) {
  constexpr double kOfTheFirst = 0.6;
  WithoutArcs begun(coarse, tolerance, ipopt, protocol);
  if (!begun.begin()) {
    static_cast<void>(suffices({{}, begun.closed()}));
    return;
  }
  for (const First first : {First::DrawnIn, First::Finer}) {
    bool enough = false;
    {
      const PassProtocol::Share part(
          protocol, first == First::DrawnIn ? kOfTheFirst : 1.0);
      enough = suffices(WithoutArcs(begun).go_on(first));
    }
    if (enough || protocol.stopped()) return;
  }
}

}  // namespace brachisto
