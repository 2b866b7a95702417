// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "posed/refine.hpp"

#include <algorithm>
#include <cmath>

#include "brachisto/math/index.hpp"

namespace brachisto::ocp {

Mesh RefinedMesh::mesh(int degree) const {
  Mesh out{degree, {}};
  for (const double plain : boundaries) {
    const bool near = std::ranges::any_of(junctions, [&](const Junction& j) {
      return std::abs(plain - j.sigma) < 3.0 * j.half_width;
    });
    if (!near || plain == 0.0 || plain == 1.0) out.boundaries.push_back(plain);
  }
  for (const Junction& j : junctions) {
    for (const double end : {j.sigma - j.half_width, j.sigma + j.half_width}) {
      if (end > 0.0 && end < 1.0) out.boundaries.push_back(end);
    }
  }
  std::ranges::sort(out.boundaries);
  // Junctions that lie closely together leave no slivers.
  std::vector<double> kept;
  for (const double end : out.boundaries) {
    if (kept.empty() || end - kept.back() > 1e-10) kept.push_back(end);
  }
  kept.back() = 1.0;
  out.boundaries = std::move(kept);
  return out;
}

namespace {

struct Evaluated {
  double hamiltonian;
  std::vector<double> rates;
};

Evaluated evaluated(const Posed& problem, const std::vector<double>& yu,
                    const std::vector<double>& costates) {
  std::vector<double> out(1 + costates.size() +
                          problem.statement().limits.size());
  problem.evaluate(yu, out);
  Evaluated all{out[0], {}};
  for (std::size_t s = 0; s < costates.size(); ++s) {
    all.hamiltonian += costates[s] * out[s + 1];
    all.rates.push_back(out[s + 1]);
  }
  return all;
}

/// Where the control leaves the curve of the elements before and joins that of
/// the elements behind: where these meet, or else where they have the integral
/// that the control has. Nothing if it does neither.
std::optional<double> junction_between(const MeshPath& fine, int first,
                                       int last) {
  const Mesh& mesh = fine.mesh();
  if (first == 0 || last + 1 >= mesh.num_elements()) return std::nullopt;
  const double from = mesh.boundaries[at(first)];
  const double to = mesh.boundaries[at(last + 1)];
  constexpr int kSteps = 64;
  const double step = (to - from) / kSteps;
  const auto beside = [&](int element, double sigma) {
    return fine
        .values(element,
                (sigma - mesh.boundaries[at(element)]) / mesh.length(element))
        .controls;
  };
  std::optional<double> best;
  double largest = 0.0;
  const std::size_t controls = beside(first, from).size();
  for (std::size_t k = 0; k < controls; ++k) {
    std::vector<double> gap, before{0.0}, behind{0.0}, of_control{0.0};
    for (int i = 0; i <= kSteps; ++i) {
      const double sigma = from + step * i;
      gap.push_back(beside(first - 1, sigma)[k] - beside(last + 1, sigma)[k]);
      if (i == kSteps) break;
      const double middle = sigma + 0.5 * step;
      before.push_back(before.back() + step * beside(first - 1, middle)[k]);
      behind.push_back(behind.back() + step * beside(last + 1, middle)[k]);
      of_control.push_back(of_control.back() +
                           step * fine.values(middle).controls[k]);
    }
    const double size = std::max(std::abs(gap.front()), std::abs(gap.back()));
    if (size <= largest) continue;
    const auto root = [&](auto&& value) -> std::optional<double> {
      for (int i = 0; i < kSteps; ++i) {
        const double a = value(at(i)), b = value(at(i + 1));
        if (a == 0.0) return from + step * i;
        if ((a < 0.0) != (b < 0.0)) return from + step * (i + a / (a - b));
      }
      return std::nullopt;
    };
    auto found = root([&](std::size_t i) { return gap[i]; });
    if (!found) {
      found = root([&](std::size_t i) {
        return before[i] + behind.back() - behind[i] - of_control.back();
      });
    }
    if (found) {
      best = found;
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

RefinedMesh refined(const RefinedMesh& last, const TwoPaths& paths,
                    const std::vector<double>& errors, double share) {
  const Mesh& mesh = paths.coarse.mesh();
  const int p = mesh.degree;
  const auto held = [&](int point) -> const std::vector<int>& {
    return paths.held[at(point)];
  };
  // Elements in which bounds begin to hold or cease to.
  std::vector<bool> changes(at(mesh.num_elements()), false);
  for (int e = 0; e < mesh.num_elements(); ++e) {
    for (int c = 2 * p * e; c + 1 < 2 * p * (e + 1); ++c) {
      if (held(c) != held(c + 1)) changes[at(e)] = true;
    }
  }
  RefinedMesh next{last.boundaries, {}};
  const auto is_short = [&](int e) {
    return std::ranges::any_of(last.junctions, [&](const auto& junction) {
      return junction.sigma > mesh.boundaries[at(e)] &&
             junction.sigma < mesh.boundaries[at(e + 1)];
    });
  };
  std::vector<double> cuts;
  const auto cut = [&](int e, int pieces) {
    for (int i = 1; i < pieces; ++i) {
      cuts.push_back(mesh.sigma(e, static_cast<double>(i) / pieces));
    }
  };
  for (int e = 0; e < mesh.num_elements(); ++e) {
    const double excess = errors[at(e)] / share;
    if (changes[at(e)] && (excess > 1.0 || is_short(e))) {
      const double h = mesh.length(e);
      const auto place = excess > 1.0
                             ? junction_between(paths.fine, 2 * e, 2 * e + 1)
                             : std::nullopt;
      const double middle = mesh.sigma(e, 0.5);
      // An error ∝ h²: by this factor shorter it is what it may be.
      const double wanted = 0.5 * h / std::sqrt(std::max(excess, 1.0)) * 0.5;
      if (excess <= 1.0) {
        next.junctions.push_back({middle, 0.5 * h});
      } else if (place) {
        next.junctions.push_back(
            {*place, std::clamp(wanted, 0.5 * h / 40.0, 0.5 * h / 5.0)});
      } else {
        cut(e, 2);
      }
    } else if (excess > 1.0) {
      const int pieces = static_cast<int>(
          std::ceil(std::pow(excess, 1.0 / (2 * p - 1)) * 1.2));
      cut(e, std::clamp(pieces, 2, 4));
    }
  }
  next.boundaries.insert(next.boundaries.end(), cuts.begin(), cuts.end());
  std::ranges::sort(next.boundaries);
  const auto twice = std::ranges::unique(next.boundaries);
  next.boundaries.erase(twice.begin(), twice.end());
  return next;
}

}  // namespace brachisto::ocp
