// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "extremal/contact_scan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "extremal/arc_flow.hpp"
#include "math/angle.hpp"
#include "model/contact.hpp"
#include "model/energy.hpp"
#include "model/inertia.hpp"
#include "model/units.hpp"

namespace brachisto {

namespace {

using math::kTurn;
constexpr double kScanTolerance = 1e-7;
constexpr double kPolishTolerance = 1e-10;
// A root may lie so far outside of a triangle, in its own size: the map is not
// linear, least of all where two roots are about to meet.
constexpr double kSlack = 1.0;
constexpr int kDivisions = 2;  // of cells on a border, each into four
// Two roots are the same if θ and φ agree to this [rad].
constexpr double kSame = 1e-5;

/// How a body arrives at B. An extremal is known by it: the centre ends at B,
/// or where φ places it; there β = φ, the energy gives w, p_θ and p_w are 0,
/// and 𝓗 = ∂𝓗/∂β = 0 leave
///
///     w (p_x cos φ + p_z sin φ) = −√A,
///     w (p_z cos φ − p_x sin φ) = −η cos(θ − φ)/√A.
struct TerminalCondition {
  double theta = 0.0;  ///< orientation [rad]
  double phi = 0.0;    ///< slope angle of the track, and of the path [rad]
};

/// Where the path comes from. Energy is conserved, so that w = 0 on the height
/// of C_A if θ is θ_m; what is left to ask for is x and θ.
struct InitialCondition {
  double x = 0.0;      ///< of the centre, from C_A on
  double theta = 0.0;  ///< [rad]
  double transit_time = 0.0;
};

/// Integrates Hamilton's equations back from B.
class BackwardShooting {
 public:
  /// \param natural  the scene, off-centred, with Contact::Smooth or
  ///                 Contact::Centre, in natural units
  /// \param longest  the path of the centre is given up when it gets longer
  BackwardShooting(const Scene& natural, double longest)
      : scene_(natural),
        longest_(longest),
        start_(start_of_centre(natural)),
        flow_({natural, {}, 1.0 / natural.body.radius}) {}

  /// Nothing if the body cannot be at B that way, if its path ends or makes a
  /// loop (|β| > π), or if it does not come to rest.
  ///
  /// \param tolerance  local error of a step, in natural units
  /// \param path       [out] if not null: from the start on, u ascending from 0
  [[nodiscard]] std::optional<InitialCondition> shoot(
      const TerminalCondition& terminal, double tolerance,
      std::vector<arcs::Knot>* path) const {
    using namespace arcs::free_arc;
    using Rates = ocp::FlowRates<Flow, false>;
    constexpr int kMostSteps = 100000;
    constexpr double kShortest = 1e-8;
    const auto& [theta, phi] = terminal;
    const Body& body = scene_.body;
    const double r = body.radius;
    const Point end = end_of_centre(scene_, phi);
    const double E = energy_height(body, end.z - start_.z, theta);
    if (!(E > 0.0)) return std::nullopt;
    const double w = fall_speed(scene_.gravity, E);
    const double root = std::sqrt(inertia_factor(body, theta, phi));
    const double along = -root / w;
    const double across = -body.eta_m * std::cos(theta - phi) / (root * w);
    const double p_x = along * std::cos(phi) - across * std::sin(phi);
    const double p_z = along * std::sin(phi) + across * std::cos(phi);

    ocp::AdaptiveIntegration<Rates> back(
        Rates{flow_, phi},
        Rates::stack_of({end.x, end.z, theta, w, p_x, p_z, 0.0, 0.0}));
    if (back.failed()) return std::nullopt;
    const auto& now = back.now();
    double u = 0.0;
    const auto tell = [&] {
      if (path == nullptr) return;
      path->push_back({u, Eigen::Map<const arcs::Node>(now.data(), Flow::kSize),
                       now[Rates::kCost], back.rates().control});
    };
    // A fraction of a radian of the rolling, also where w is yet to grow.
    double step = 0.3 * r / (w + std::sqrt(r));
    tell();
    for (int i = 0; now[kW] > 0.0; ++i) {
      ++steps_;
      const bool taken = back.step(-step, tolerance);
      if (i == kMostSteps) return std::nullopt;
      if (taken) u += step;
      step *= back.factor();
      if (!taken) {
        if (step < kShortest) return std::nullopt;
        continue;
      }
      const double left = longest_ - r * (theta - now[kTheta]);
      if (back.failed() || std::abs(back.rates().control) > std::numbers::pi ||
          std::abs(now[kX] - start_.x) > left) {
        return std::nullopt;
      }
      if (now[kW] > 0.0) tell();
    }
    // w is smooth through zero: Newton's method on u.
    for (int i = 0; i < 4; ++i) {
      const double by = -now[kW] / back.slope()[kW];
      back.step_unchecked(by);
      u -= by;
    }
    if (back.failed() || !(std::abs(now[kW]) <= tolerance)) return std::nullopt;
    if (path != nullptr) {
      tell();
      std::reverse(path->begin(), path->end());
      for (arcs::Knot& knot : *path) {
        knot.u = u - knot.u;
        knot.t -= now[Rates::kCost];
      }
    }
    return InitialCondition{now[kX] - start_.x, now[kTheta],
                            -now[Rates::kCost]};
  }

  [[nodiscard]] const Scene& scene() const { return scene_; }
  /// Steps of the integrator in all.
  [[nodiscard]] long steps() const { return steps_; }

 private:
  using Flow = ocp::Flow<rolling::SteeredFalling>;

  Scene scene_;
  double longest_;
  Point start_;  ///< C_A
  Flow flow_;
  mutable long steps_ = 0;
};

/// Grid over the terminal conditions.
struct Grid {
  int thetas, phis;  ///< cells

  [[nodiscard]] TerminalCondition at(int i, int j) const {
    return {kTurn * i / thetas, kTurn * (1.0 * j / phis - 0.5)};
  }
};

/// A root of x = 0, θ = target.
struct Root {
  TerminalCondition terminal;
  double target;
  double transit_time;
};

/// Where Newton's method for such a root may begin.
struct RootStart {
  TerminalCondition terminal;
  double target;
  double outside;  ///< of its triangle, in its own size
};

class Scan {
 public:
  Scan(const Scene& natural, double longest, const std::function<bool()>& stop,
       long most_steps)
      : shooting_(natural, longest), stop_(stop), most_steps_(most_steps) {}

  ContactScan run(const Grid& grid) {
    collect(grid);
    ContactScan out;
    out.whole_grid = !over();
    out.starts = static_cast<long>(starts_.size());
    // The likelier ones first, for the work is bounded.
    std::stable_sort(starts_.begin(), starts_.end(),
                     [](const RootStart& a, const RootStart& b) {
                       return a.outside < b.outside;
                     });
    for (const RootStart& start : starts_) {
      if (over()) break;
      polish(start.terminal, start.target);
      ++out.tried;
    }
    out.contacts = contacts();
    return out;
  }

 private:
  [[nodiscard]] bool over() const {
    return stop_() || shooting_.steps() >= most_steps_;
  }

  void collect(const Grid& grid) {
    using Row = std::vector<std::optional<InitialCondition>>;
    const auto row = [&](int i) {
      Row initials;
      for (int j = 0; j <= grid.phis; ++j) {
        initials.push_back(
            over() ? std::nullopt
                   : shooting_.shoot(grid.at(i, j), kScanTolerance, nullptr));
      }
      return initials;
    };
    const auto corner = [&](int i, int j,
                            const std::optional<InitialCondition>& at) {
      return Corner{grid.at(i, j), at};
    };
    Row low = row(0);
    for (int i = 0; i < grid.thetas && !over(); ++i) {
      const Row high = row(i + 1);
      for (int j = 0; j < grid.phis; ++j) {
        const auto a = static_cast<std::size_t>(j);
        look_into(
            {corner(i, j, low[a]), corner(i + 1, j, high[a]),
             corner(i, j + 1, low[a + 1]), corner(i + 1, j + 1, high[a + 1])},
            kDivisions);
      }
      low = high;
    }
  }

  /// Fastest first.
  [[nodiscard]] std::vector<ScannedContact> contacts() const {
    std::vector<Root> roots = roots_;
    std::sort(roots.begin(), roots.end(), [](const Root& a, const Root& b) {
      return a.transit_time < b.transit_time;
    });
    using namespace arcs::free_arc;
    std::vector<ScannedContact> found;
    for (const Root& root : roots) {
      std::vector<arcs::Knot> knots;
      if (!shooting_.shoot(root.terminal, kPolishTolerance, &knots)) continue;
      // The start is at θ_m, not whole turns away from it.
      const Scene& scene = shooting_.scene();
      const double turns = root.target - scene.body.theta_m;
      for (arcs::Knot& knot : knots) knot.y(kTheta) -= turns;
      const arcs::Knot end = knots.back();
      arcs::ArcPath::Stretch arc{arcs::ArcFlow(scene, std::nullopt), end.u,
                                 std::move(knots)};
      found.push_back(
          {root.terminal.phi, end.u, end.t,
           scene.body.radius * (root.terminal.theta - root.target), end.y(kPX),
           end.y(kPZ),
           ExtremalPath(scene, Units{}, {{std::move(arc)}, std::nullopt})});
    }
    return found;
  }

  struct Corner {
    TerminalCondition terminal;
    std::optional<InitialCondition> initial;
  };
  /// Corners (low, low), (high, low), (low, high), (high, high) in (θ, φ).
  using Cell = std::array<Corner, 4>;

  /// Two triangles cover a cell. One that lies on the border of where paths
  /// exist is divided, for there the map bends most.
  void look_into(const Cell& cell, int divisions) {
    const auto exist = std::count_if(
        cell.begin(), cell.end(),
        [](const Corner& corner) { return corner.initial.has_value(); });
    if (exist == 0) return;
    if (exist == 4) {
      look_into(cell[0], cell[1], cell[2]);
      look_into(cell[3], cell[1], cell[2]);
    } else if (divisions > 0) {
      const auto between = [this](const Corner& a, const Corner& b) {
        const TerminalCondition middle{
            0.5 * (a.terminal.theta + b.terminal.theta),
            0.5 * (a.terminal.phi + b.terminal.phi)};
        return Corner{middle, shooting_.shoot(middle, kScanTolerance, nullptr)};
      };
      const Corner centre = between(cell[0], cell[3]);
      const Corner south = between(cell[0], cell[1]);
      const Corner north = between(cell[2], cell[3]);
      const Corner west = between(cell[0], cell[2]);
      const Corner east = between(cell[1], cell[3]);
      look_into({cell[0], south, west, centre}, divisions - 1);
      look_into({south, cell[1], centre, east}, divisions - 1);
      look_into({west, centre, cell[2], north}, divisions - 1);
      look_into({centre, east, north, cell[3]}, divisions - 1);
    }
  }

  /// Newton's method is to start from the roots of the map that is linear in a
  /// triangle.
  void look_into(const Corner& a, const Corner& b, const Corner& c) {
    const double x_b = b.initial->x - a.initial->x;
    const double x_c = c.initial->x - a.initial->x;
    const double theta_b = b.initial->theta - a.initial->theta;
    const double theta_c = c.initial->theta - a.initial->theta;
    const double determinant = x_b * theta_c - x_c * theta_b;
    if (determinant == 0.0) return;
    const auto [low, high] = std::minmax({0.0, theta_b, theta_c});
    const double margin = kSlack * (high - low);
    const double first = a.initial->theta - shooting_.scene().body.theta_m;
    const double last = std::floor((first + high + margin) / kTurn);
    for (double n = std::ceil((first + low - margin) / kTurn); n <= last; ++n) {
      const double by_x = -a.initial->x;
      const double by_theta = kTurn * n - first;
      const double at_b = (by_x * theta_c - x_c * by_theta) / determinant;
      const double at_c = (x_b * by_theta - theta_b * by_x) / determinant;
      const double outside =
          std::max(0.0, -std::min({at_b, at_c, 1.0 - at_b - at_c}));
      if (!(outside <= kSlack)) continue;
      const auto mix = [&](double of_a, double of_b, double of_c) {
        return of_a + at_b * (of_b - of_a) + at_c * (of_c - of_a);
      };
      starts_.push_back(
          {{mix(a.terminal.theta, b.terminal.theta, c.terminal.theta),
            mix(a.terminal.phi, b.terminal.phi, c.terminal.phi)},
           shooting_.scene().body.theta_m + kTurn * n,
           outside});
    }
  }

  /// Newton's method, the derivatives by differences.
  void polish(TerminalCondition terminal, double target) {
    constexpr int kMostSteps = 12;
    constexpr int kMostHalvings = 3;
    constexpr double kDifference = 1e-6;
    constexpr double kResidual = 1e-7;
    const double r = shooting_.scene().body.radius;
    const auto shoot = [&](double theta, double phi) {
      return shooting_.shoot({theta, phi}, kPolishTolerance, nullptr);
    };
    // How far the body would have to roll for it.
    const auto miss = [&](const InitialCondition& initial) {
      return std::hypot(initial.x / r, initial.theta - target);
    };
    std::optional<InitialCondition> now = shoot(terminal.theta, terminal.phi);
    for (int i = 0; now && miss(*now) > kResidual; ++i) {
      const auto by_theta = shoot(terminal.theta + kDifference, terminal.phi);
      const auto by_phi = shoot(terminal.theta, terminal.phi + kDifference);
      if (i == kMostSteps || !by_theta || !by_phi) return;
      const double x_t = (by_theta->x - now->x) / kDifference;
      const double x_p = (by_phi->x - now->x) / kDifference;
      const double t_t = (by_theta->theta - now->theta) / kDifference;
      const double t_p = (by_phi->theta - now->theta) / kDifference;
      const double determinant = x_t * t_p - x_p * t_t;
      const double gap = target - now->theta;
      const double step_theta = (-now->x * t_p - x_p * gap) / determinant;
      const double step_phi = (x_t * gap + t_t * now->x) / determinant;
      std::optional<InitialCondition> next;
      double by = 1.0;
      for (int halving = 0; halving <= kMostHalvings; ++halving, by *= 0.5) {
        next = shoot(terminal.theta + by * step_theta,
                     terminal.phi + by * step_phi);
        if (next && miss(*next) < miss(*now)) break;
        next.reset();
      }
      if (!next) return;
      terminal.theta += by * step_theta;
      terminal.phi += by * step_phi;
      now = next;
    }
    if (!now) return;
    for (const Root& other : roots_) {
      if (std::abs(other.terminal.phi - terminal.phi) <= kSame &&
          std::abs(std::remainder(other.terminal.theta - terminal.theta,
                                  kTurn)) <= kSame) {
        return;
      }
    }
    roots_.push_back({terminal, target, now->transit_time});
  }

  BackwardShooting shooting_;
  const std::function<bool()>& stop_;
  long most_steps_;
  std::vector<RootStart> starts_;
  std::vector<Root> roots_;
};

}  // namespace

ContactScan scan_contacts(const Scene& natural, double longest,
                          const std::function<bool()>& stop, long most_steps) {
  constexpr Grid kGrid{64, 128};
  return Scan(natural, longest, stop, most_steps).run(kGrid);
}

}  // namespace brachisto
