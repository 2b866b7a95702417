// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "posed/refine.hpp"

#include <algorithm>
#include <cmath>

#include "brachisto/math/index.hpp"
#include "posed/guess.hpp"

namespace brachisto::ocp {

Mesh RefinedMesh::mesh(int degree) const {
  // A plain boundary so near to a junction leaves an element too short.
  constexpr double kNear = 0.25;
  Mesh out{degree, {}};
  for (std::size_t i = 0; i < boundaries.size(); ++i) {
    const bool inner = i > 0 && i + 1 < boundaries.size();
    const bool near =
        inner && std::ranges::any_of(junctions, [&](auto& j) {
          const double length = j.sigma > boundaries[i]
                                    ? boundaries[i + 1] - boundaries[i]
                                    : boundaries[i] - boundaries[i - 1];
          return std::abs(j.sigma - boundaries[i]) <
                 (j.half_width > 0.0 ? 3.0 * j.half_width : kNear * length);
        });
    if (!near) out.boundaries.push_back(boundaries[i]);
  }
  for (const Junction& j : junctions) {
    for (const double end : {j.sigma - j.half_width, j.sigma + j.half_width}) {
      if (end > 0.0 && end < 1.0) out.boundaries.push_back(end);
    }
  }
  std::ranges::sort(out.boundaries);
  // Junctions that lie closely together leave no slivers.
  constexpr double kShortest = 1e-10;
  std::vector<double> kept;
  for (const double end : out.boundaries) {
    if (kept.empty() || end - kept.back() > kShortest) kept.push_back(end);
  }
  kept.back() = 1.0;
  out.boundaries = std::move(kept);
  return out;
}

double RefinedMesh::moved() const {
  double most = 0.0;
  for (const Junction& j : junctions) most = std::max(most, j.moved);
  return most;
}

namespace {

struct Evaluated {
  double hamiltonian;
  std::vector<double> rates;
};

Evaluated evaluated(const Posed& problem, const std::vector<double>& yu,
                    const std::vector<double>& costates) {
  const std::vector<double> out = formulas(problem, yu);
  Evaluated all{out[0], {}};
  for (std::size_t s = 0; s < costates.size(); ++s) {
    all.hamiltonian += costates[s] * out[s + 1];
    all.rates.push_back(out[s + 1]);
  }
  return all;
}

/// Elements of the finer mesh in or between which what holds changes.
struct Window {
  int first, last;
};

/// \param last  whose kinks may lie on either side of their boundaries
std::vector<Window> windows(const TwoPaths& paths, const RefinedMesh& last) {
  const Mesh& mesh = paths.fine.mesh();
  const int p = mesh.degree;
  std::vector<Window> out;
  for (int c = 0; c + 1 < mesh.num_points(); ++c) {
    if (paths.held[at(c)] == paths.held[at(c + 1)]) continue;
    // The last point of an element is where the next one begins.
    Window here{c / p, std::min(c + 2, mesh.num_points() - 1) / p};
    for (const RefinedMesh::Junction& junction : last.junctions) {
      if (junction.half_width > 0.0) continue;
      const int behind = mesh.locate(junction.sigma).element;
      if (behind < here.first || behind > here.last + 1) continue;
      here = {std::min(here.first, behind - 1), std::max(here.last, behind)};
    }
    // Curves are continued from an element between windows.
    if (!out.empty() && here.first <= out.back().last + 1) {
      out.back().last = std::max(out.back().last, here.last);
    } else {
      out.push_back(here);
    }
  }
  return out;
}

/// Where a function of σ changes its sign.
template <class Function>
std::optional<double> sign_change(Function&& value, double from, double to) {
  constexpr int kSteps = 32, kHalvings = 50;
  double a = from, of_a = value(a);
  for (int i = 1; i <= kSteps; ++i) {
    double b = from + (to - from) * i / kSteps;
    const double of_b = value(b);
    if ((of_a < 0.0) != (of_b < 0.0)) {
      for (int k = 0; k < kHalvings; ++k) {
        const double middle = 0.5 * (a + b);
        ((value(middle) < 0.0) == (of_a < 0.0) ? a : b) = middle;
      }
      return 0.5 * (a + b);
    }
    a = b, of_a = of_b;
  }
  return std::nullopt;
}

struct Found {
  double sigma;
  bool jumps;
};

/// Where the control leaves the curve of the element before and joins that of
/// the element behind: where these meet, or else where they have the integral
/// that the control has. Nothing if it does neither.
std::optional<Found> junction_in(const MeshPath& fine, const Window& window) {
  const Mesh& mesh = fine.mesh();
  const auto [first, last] = window;
  if (first == 0 || last + 1 >= mesh.num_elements()) return std::nullopt;
  const double from = mesh.boundaries[at(first)];
  const double to = mesh.boundaries[at(last + 1)];
  const CollocationScheme& scheme = radau_scheme(mesh.degree);
  const auto beside = [&](int element, double sigma) {
    return fine
        .values(element,
                (sigma - mesh.boundaries[at(element)]) / mesh.length(element))
        .controls;
  };
  std::optional<Found> best;
  double largest = 0.0;
  const std::size_t controls = beside(first, from).size();
  for (std::size_t k = 0; k < controls; ++k) {
    const auto before = [&](double s) { return beside(first - 1, s)[k]; };
    const auto behind = [&](double s) { return beside(last + 1, s)[k]; };
    const auto gap = [&](double s) { return before(s) - behind(s); };
    const double size = std::max(std::abs(gap(from)), std::abs(gap(to)));
    if (size <= largest) continue;
    const auto integral = [&](auto&& of, double a, double b) {
      double sum = 0.0;
      for (int j = 0; j < mesh.degree; ++j) {
        sum += (b - a) * scheme.rule.weights[at(j)] *
               of(a + (b - a) * scheme.rule.points[at(j)]);
      }
      return sum;
    };
    auto found = sign_change(gap, from, to);
    const bool jumps = !found;
    if (jumps) {
      double whole = 0.0;
      for (int e = first; e <= last; ++e) {
        whole += integral([&](double s) { return beside(e, s)[k]; },
                          mesh.boundaries[at(e)], mesh.boundaries[at(e + 1)]);
      }
      found = sign_change(
          [&](double s) {
            return integral(before, from, s) + integral(behind, s, to) - whole;
          },
          from, to);
    }
    if (found) {
      best = {*found, jumps};
      largest = size;
    }
  }
  return best;
}

}  // namespace

std::vector<double> element_errors(const Posed& problem,
                                   const TwoPaths& paths) {
  const Mesh& mesh = paths.coarse.mesh();
  const CollocationScheme& scheme = radau_scheme(mesh.degree);
  std::vector<double> errors;
  for (int e = 0; e < mesh.num_elements(); ++e) {
    double error = 0.0;
    for (int half = 0; half < 2; ++half) {
      double loss = 0.0, defect = 0.0;
      for (int j = 0; j < mesh.degree; ++j) {
        const double t = scheme.rule.points[at(j)];
        const PathValues fine = paths.fine.values(2 * e + half, t);
        const PathValues coarse = paths.coarse.values(e, 0.5 * (half + t));
        std::vector<double> mixed = fine.states;
        mixed.insert(mixed.end(), coarse.controls.begin(),
                     coarse.controls.end());
        const double b = scheme.rule.weights[at(j)];
        loss +=
            b *
            std::abs(
                evaluated(problem, mixed, fine.costates).hamiltonian -
                evaluated(problem, fine.point(), fine.costates).hamiltonian);
        const Evaluated here =
            evaluated(problem, coarse.point(), fine.costates);
        for (std::size_t s = 0; s < here.rates.size(); ++s) {
          defect += b * fine.costates[s] * (here.rates[s] - coarse.slopes[s]);
        }
      }
      error += 0.5 * (loss + std::abs(defect));
    }
    errors.push_back(error * mesh.length(e) * paths.fine.duration());
  }
  return errors;
}

void cut(const Mesh& mesh, int element, double excess,
         std::vector<double>& boundaries) {
  if (!(excess > 1.0)) return;
  const int pieces = std::clamp(
      static_cast<int>(
          std::ceil(std::pow(excess, 1.0 / (2 * mesh.degree - 1)) * 1.2)),
      2, 4);
  for (int i = 1; i < pieces; ++i) {
    boundaries.push_back(mesh.sigma(element, static_cast<double>(i) / pieces));
  }
}

RefinedMesh refined(const RefinedMesh& last, const TwoPaths& paths,
                    const std::vector<double>& errors, double share) {
  const Mesh& mesh = paths.coarse.mesh();
  RefinedMesh next{last.boundaries, {}};
  // Elements that do well as they are once their junction is in its place, and
  // the most that one of them errs by: others err with it.
  std::vector<bool> left_whole(at(mesh.num_elements()), false);
  double with_junctions = 0.0;
  for (const Window& window : windows(paths, last)) {
    const auto found = junction_in(paths.fine, window);
    if (!found) continue;
    const int first = window.first / 2, behind = window.last / 2 + 1;
    const double room =
        mesh.boundaries[at(behind)] - mesh.boundaries[at(first)];
    double error = 0.0;
    for (int e = first; e < behind; ++e) error += errors[at(e)];
    const RefinedMesh::Junction* before = nullptr;
    for (const RefinedMesh::Junction& junction : last.junctions) {
      if (junction.sigma > mesh.boundaries[at(first)] - 0.1 * room &&
          junction.sigma < mesh.boundaries[at(behind)] + 0.1 * room) {
        before = &junction;
      }
    }
    if (found->jumps) {
      // An error ∝ h²: by this factor shorter it is what it may be.
      const double wanted =
          0.25 * room / std::sqrt(std::max(error / share, 1.0));
      const double half_width =
          before != nullptr && error <= share
              ? before->half_width
              : std::clamp(wanted, room / 80.0, room / 10.0);
      next.junctions.push_back(
          {found->sigma, half_width, 0.0, before == nullptr});
    } else {
      const bool seen = before != nullptr && before->half_width == 0.0;
      if (seen && before->moved == 0.0) {
        next.junctions.push_back(*before);
        continue;
      }
      const double moved = seen ? std::abs(before->sigma - found->sigma) : room;
      next.junctions.push_back({found->sigma, 0.0, moved, !seen});
      // Not nearer and nearer.
      if (seen && moved > 0.3 * before->moved) continue;
    }
    for (int e = first; e < behind; ++e) {
      left_whole[at(e)] = true;
      with_junctions = std::max(with_junctions, errors[at(e)]);
    }
  }
  for (int e = 0; e < mesh.num_elements(); ++e) {
    const double excess = errors[at(e)] / share;
    if (left_whole[at(e)] || !(errors[at(e)] > with_junctions)) {
      continue;
    }
    cut(mesh, e, excess, next.boundaries);
  }
  std::ranges::sort(next.boundaries);
  const auto twice = std::ranges::unique(next.boundaries);
  next.boundaries.erase(twice.begin(), twice.end());
  return next;
}

}  // namespace brachisto::ocp
