// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "posed/certificate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <numbers>

#include "brachisto/math/index.hpp"
#include "nlp/active_set.hpp"
#include "posed/guess.hpp"
#include "posed/mistakes.hpp"
#include "solvers/inertia.hpp"

namespace brachisto::ocp {

namespace {

/// The largest value, and where it is.
struct Worst {
  double value = 0.0;
  std::string where;
  void see(double other, const std::string& what, double time) {
    if (!(other > value) && !std::isnan(other)) return;
    value = std::isnan(other) ? kNoBound : other;
    where = fmt::format("{} at t = {:.6g}", what, time);
  }
  [[nodiscard]] Check check(const char* name, double allowed) const {
    return {name, value, allowed, where};
  }
};

class Certifier {
 public:
  Certifier(const Posed& problem, const MeshPath& path)
      : problem_(problem),
        said_(problem.statement()),
        path_(path),
        states_(said_.states.size() + said_.parameters.size()) {}

  /// The equations of motion, by steps of order 8 that know no polynomial but
  /// the control's, from node to node of what they arrive at.
  [[nodiscard]] Worst integrated() const {
    Worst worst;
    boost::numeric::odeint::runge_kutta_fehlberg78<std::vector<double>> stepper;
    const Mesh& mesh = path_.mesh();
    const double duration = path_.duration();
    std::vector<double> y = path_.values(0, 0.0).states;
    constexpr int kSteps = 4;
    for (int e = 0; e < mesh.num_elements(); ++e) {
      const auto system = [&](const std::vector<double>& state,
                              std::vector<double>& slope, double t) {
        std::vector<double> yu = state;
        const PathValues here = values(e, t);
        yu.insert(yu.end(), here.controls.begin(), here.controls.end());
        const std::vector<double> all = formulas(problem_, yu);
        slope.resize(states_);
        for (std::size_t s = 0; s < states_; ++s) {
          slope[s] = duration * mesh.length(e) * all[s + 1];
        }
      };
      for (int i = 0; i < kSteps; ++i) {
        stepper.do_step(system, y, static_cast<double>(i) / kSteps,
                        1.0 / kSteps);
      }
      const PathValues end = path_.values(e, 1.0);
      for (std::size_t s = 0; s < states_; ++s) {
        if (!std::isfinite(y[s])) {
          worst.see(std::nan(""), broken(e), duration * mesh.boundaries[at(e)]);
          return worst;
        }
        worst.see(std::abs(y[s] - end.states[s]) /
                      std::max(1.0, std::abs(end.states[s])),
                  name(s), duration * mesh.boundaries[at(e + 1)]);
      }
    }
    return worst;
  }

  /// Bounds and limits, relative to their sizes, between the points as well.
  [[nodiscard]] Worst exceeded() const {
    Worst worst;
    each_excess([&](double below, double above, double scale,
                    const std::string& what, double time) {
      worst.see(std::max(below, above) / scale, what, time);
    });
    return worst;
  }

  /// y' − f over the duration, relative to the states' sizes, in the mean:
  /// between the points as well, where no equation is asked for.
  [[nodiscard]] Worst missed() const {
    std::vector<double> sums(states_, 0.0), sizes(states_, 1.0);
    each_share([&](int, const PathValues& here, double share) {
      const std::vector<double> all = formulas(problem_, here.point());
      for (std::size_t s = 0; s < states_; ++s) {
        sums[s] += share * std::abs(here.slopes[s] - all[s + 1]);
        sizes[s] = std::max(sizes[s], std::abs(here.states[s]));
      }
    });
    Worst worst;
    for (std::size_t s = 0; s < states_; ++s) {
      worst.see(sums[s] * path_.duration() / sizes[s], name(s),
                path_.duration());
    }
    worst.where = worst.where.substr(0, worst.where.find(" at t"));
    return worst;
  }

  /// What the equations' being missed between the points comes to in the cost,
  /// to first order: ∫ L + p·(f − y') dt less what the program sums up, of each
  /// element.
  [[nodiscard]] double cost_of_missed() const {
    const Mesh& mesh = path_.mesh();
    std::vector<double> of(at(mesh.num_elements()), 0.0);
    each_share([&](int e, const PathValues& here, double share) {
      const std::vector<double> all = formulas(problem_, here.point());
      double rate = all[0];
      for (std::size_t s = 0; s < states_; ++s) {
        rate += here.costates[s] * (all[s + 1] - here.slopes[s]);
      }
      of[at(e)] += share * rate;
    });
    const CollocationScheme& scheme = radau_scheme(mesh.degree);
    double sum = 0.0;
    for (int e = 0; e < mesh.num_elements(); ++e) {
      for (int j = 0; j < mesh.degree; ++j) {
        of[at(e)] -=
            mesh.length(e) * scheme.rule.weights[at(j)] *
            formulas(problem_,
                     path_.values(e, scheme.rule.points[at(j)]).point())[0];
      }
      sum += std::abs(of[at(e)]);
    }
    return sum * path_.duration();
  }

  /// What the largest excesses over bounds of states and limits cost.
  [[nodiscard]] double cost_of_excess(
      const std::vector<Answer::Price>& prices) const {
    std::vector<std::array<double, 2>> most(prices.size());
    each_excess([&](double below, double above, double, const std::string& what,
                    double) {
      for (std::size_t i = 0; i < prices.size(); ++i) {
        if (prices[i].name != what) continue;
        most[i] = {std::max(most[i][0], below), std::max(most[i][1], above)};
      }
    });
    double sum = 0.0;
    for (std::size_t i = 0; i < prices.size(); ++i) {
      sum += std::abs(prices[i].by_lower) * most[i][0] +
             std::abs(prices[i].by_upper) * most[i][1];
    }
    return sum;
  }

  /// 𝓗 = L + p·f is the same all along.
  [[nodiscard]] Worst hamiltonian() const {
    struct Weighted {
      double value, share;
    };
    std::vector<Weighted> all;
    double size = 0.0, mean = 0.0;
    const Mesh& mesh = path_.mesh();
    const CollocationScheme& scheme = radau_scheme(mesh.degree);
    for (int e = 0; e < mesh.num_elements(); ++e) {
      for (int j = 0; j < mesh.degree; ++j) {
        const PathValues here = path_.values(e, scheme.rule.points[at(j)]);
        const std::vector<double> values = formulas(problem_, here.point());
        double h = values[0], terms = std::abs(values[0]);
        for (std::size_t s = 0; s < states_; ++s) {
          h += here.costates[s] * values[s + 1];
          terms += std::abs(here.costates[s] * values[s + 1]);
        }
        all.push_back({h, mesh.length(e) * scheme.rule.weights[at(j)]});
        mean += all.back().share * h;
        size += all.back().share * terms;
      }
    }
    // An integral: next to a junction it need not be so at each point.
    double sum = 0.0;
    for (const Weighted& one : all)
      sum += one.share * std::abs(one.value - mean);
    Worst worst;
    worst.see(sum / std::max(size, 1e-300), "mean over the path",
              path_.duration());
    return worst;
  }

  [[nodiscard]] std::string jump() const {
    constexpr int kCells = 200;
    for (int i = 0; i < kCells; ++i) {
      // Where controls jump they are left as they are: states alone move.
      for (const bool own_controls : {true, false}) {
        const std::string found =
            jump_between(static_cast<double>(i) / kCells,
                         static_cast<double>(i + 1) / kCells, own_controls);
        if (!found.empty()) return found;
      }
    }
    return {};
  }

 private:
  /// Which formula is not finite on an element.
  [[nodiscard]] std::string broken(int element) const {
    constexpr int kParts = 8;
    for (int i = 0; i <= kParts; ++i) {
      const std::vector<double> all = formulas(
          problem_, values(element, static_cast<double>(i) / kParts).point());
      for (std::size_t k = 0; k <= states_; ++k) {
        if (!std::isfinite(all[k])) {
          return formula_name(said_, k) + ", which is not finite,";
        }
      }
    }
    return "a rate, which is not finite,";
  }
  [[nodiscard]] PathValues values(int element, double t) const {
    PathValues here = path_.values(element, t);
    keep_in_bounds(said_, problem_.scales(), here);
    return here;
  }
  [[nodiscard]] const std::string& name(std::size_t i) const {
    return variable(said_, i).name;
  }
  /// Places of Gauss's rule on each element, with their shares of the duration.
  template <class With>
  void each_share(With&& with) const {
    const math::QuadratureRule& rule = gauss_scheme(kLargestDegree).rule;
    for (int e = 0; e < path_.mesh().num_elements(); ++e) {
      for (std::size_t j = 0; j < rule.points.size(); ++j) {
        with(e, values(e, rule.points[j]),
             path_.mesh().length(e) * rule.weights[j]);
      }
    }
  }
  template <class With>
  void each_place(With&& with) const {
    for (int e = 0; e < path_.mesh().num_elements(); ++e) {
      // Densely at its ends: next to junctions a path exceeds a bound there.
      constexpr int kParts = 32;
      for (int i = 0; i <= kParts; ++i) {
        const double t = 0.5 * (1.0 - std::cos(std::numbers::pi * i / kParts));
        with(path_.duration() * path_.mesh().sigma(e, t), values(e, t));
      }
    }
  }
  /// How far each variable and limit is below and above its bounds at each
  /// place, its scale and its name.
  template <class See>
  void each_excess(See&& see) const {
    each_place([&](double time, const PathValues& here) {
      const std::vector<double> yu = here.point();
      for (std::size_t i = 0; i < yu.size(); ++i) {
        const Variable& one = variable(said_, i);
        const double scale = problem_.scales()[i];
        see(one.lower - yu[i] * scale, yu[i] * scale - one.upper, scale,
            one.name, time);
      }
      const std::vector<double> all = formulas(problem_, yu);
      for (std::size_t i = 0; i < said_.limits.size(); ++i) {
        const Limit& limit = said_.limits[i];
        double scale = 1.0;
        for (const double bound : {limit.lower, limit.upper}) {
          if (std::isfinite(bound)) scale = std::max(scale, std::abs(bound));
        }
        const double value = all[1 + states_ + i];
        see(limit.lower - value, value - limit.upper, scale, limit.name, time);
      }
    });
  }
  /// Where a rate changes by half as much between points as good as one.
  [[nodiscard]] std::string jump_between(double a, double b,
                                         bool own_controls) const {
    constexpr double kOne = 1e-7, kMuch = 1e-3, kHalf = 0.5;
    const auto values_at = [&](double sigma) {
      const Mesh::Place place = path_.mesh().locate(sigma);
      return values(place.element, place.t);
    };
    const std::vector<double> controls = values_at(a).controls;
    const auto point = [&](double sigma) {
      PathValues here = values_at(sigma);
      if (!own_controls) here.controls = controls;
      return here.point();
    };
    const auto apart = [&](double l, double r) {
      const std::vector<double> one = point(l), other = point(r);
      double most = 0.0;
      for (std::size_t i = 0; i < one.size(); ++i) {
        most = std::max(most, std::abs(one[i] - other[i]));
      }
      return most;
    };
    const std::vector<double> left = formulas(problem_, point(a)),
                              right = formulas(problem_, point(b));
    for (std::size_t s = 0; s <= states_; ++s) {
      double l = a, r = b, vl = left[s], vr = right[s];
      const double first = std::abs(vr - vl);
      if (!(first > kMuch * (1.0 + std::abs(vl)))) continue;
      while (apart(l, r) > kOne && std::abs(vr - vl) >= kHalf * first) {
        const double middle = 0.5 * (l + r),
                     vm = formulas(problem_, point(middle))[s];
        if (!(l < middle && middle < r)) break;
        if (std::abs(vm - vl) > std::abs(vr - vm)) {
          r = middle, vr = vm;
        } else {
          l = middle, vl = vm;
        }
      }
      // A steep rate that is smooth does so over a part of the way alone.
      const bool narrow = r - l <= kMuch * (b - a);
      if (!narrow || apart(l, r) > kOne ||
          !(std::abs(vr - vl) >= kHalf * first)) {
        continue;
      }
      const PathValues here = values_at(l);
      std::string place;
      for (std::size_t i = 0; i < said_.states.size(); ++i) {
        place += fmt::format("{}{} = {:.6g}", i == 0 ? "" : ", ", name(i),
                             here.states[i] * problem_.scales()[i]);
      }
      return fmt::format(
          "{} jumps at t = {:.6g}, where {}: formulas have to be smooth",
          formula_name(said_, s), path_.duration() * l, place);
    }
    return {};
  }

  const Posed& problem_;
  const Statement& said_;
  const MeshPath& path_;
  std::size_t states_;
};

}  // namespace

nlp::KktResidual first_order(nlp::Problem& program, const PrimalDual& point) {
  nlp::KktResidual residual = nlp::kkt_residual(program, point);
  const nlp::KktResidual not_weighted =
      nlp::kkt_residual(program, point, [](int) { return 1.0; });
  residual.complementarity = not_weighted.complementarity;
  residual.sign = not_weighted.sign;
  return residual;
}

std::vector<Check> certify(const Posed& problem, nlp::Problem& program,
                           const PrimalDual& point, const MeshPath& path,
                           double relative_error, double tolerance,
                           bool exact) {
  const Certifier ask(problem, path);
  std::vector<Check> checks;
  const nlp::KktResidual residual = first_order(program, point);
  checks.push_back({"optimality conditions", residual.max(), kAsCertified,
                    residual.worst_variable});
  // States err by the root of what the cost does, at worst.
  const double of_states = 10.0 * std::sqrt(tolerance);
  checks.push_back(ask.integrated().check("states integrated", of_states));
  checks.push_back(ask.missed().check("equations between points", of_states));
  checks.push_back(ask.exceeded().check("limits between points", of_states));
  checks.push_back(ask.hamiltonian().check("constant Hamiltonian", of_states));
  checks.push_back({"estimated error", relative_error, tolerance, ""});
  if (!exact) return checks;
  // (n, m, 0): a strict minimum of the program.
  const nlp::ActiveSet active = nlp::active_set(program, point);
  const Inertia inertia = kkt_inertia(program, point);
  const int others = inertia.zero +
                     std::abs(inertia.positive - active.num_free()) +
                     std::abs(inertia.negative - active.num_equations());
  checks.push_back({"second order", inertia.known ? others : kNoBound, 0.0,
                    "eigenvalues of another sign"});
  return checks;
}

double cost_between_points(const Posed& problem, const MeshPath& path,
                           const std::vector<Answer::Price>& prices) {
  const Certifier ask(problem, path);
  return ask.cost_of_excess(prices) + ask.cost_of_missed();
}

std::string jump_along(const Posed& problem, const MeshPath& path) {
  return Certifier(problem, path).jump();
}

}  // namespace brachisto::ocp
