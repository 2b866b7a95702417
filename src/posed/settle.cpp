// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "posed/settle.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "brachisto/math/index.hpp"
#include "brachisto/solvers/program_solvers.hpp"
#include "nlp/active_set.hpp"
#include "posed/bounds.hpp"
#include "posed/certificate.hpp"
#include "solvers/square_system.hpp"

namespace brachisto::ocp {

namespace {

class Settling {
 public:
  Settling(const Posed& problem, const MeshPath& path, const PrimalDual& point,
           HeldAlong held)
      : problem_(problem),
        layout_(path.layout()),
        first_mesh_(path.mesh()),
        first_(point),
        held_(std::move(held)) {}

  /// Makes elements uniform. False if that cannot be done.
  ///
  /// \param whole  whether a bound holds on an element if it does at all of its
  ///               points, and not at most of them
  [[nodiscard]] bool find_kinks(
      const std::vector<RefinedMesh::Junction>& junctions, bool whole);
  [[nodiscard]] std::optional<Settled> run();

 private:
  [[nodiscard]] Mesh mesh_of(std::span<const double> sigmas) const;
  /// The solution for kinks at given places.
  [[nodiscard]] std::optional<Settled> at_kinks(
      std::span<const double> sigmas) const;
  [[nodiscard]] PrimalDual start(nlp::Problem& program, const Mesh& mesh) const;
  /// By how much the control that has the kink jumps at each.
  void jumps(const Settled& here, std::span<double> out) const;

  const Posed& problem_;
  const Layout& layout_;
  const Mesh& first_mesh_;
  const PrimalDual& first_;
  HeldAlong held_;
  struct Kink {
    int boundary;
    std::size_t control = 0;
  };
  std::vector<Kink> kinks_;
};

bool Settling::find_kinks(const std::vector<RefinedMesh::Junction>& junctions,
                          bool whole) {
  const Mesh& mesh = first_mesh_;
  const int p = mesh.degree, elements = mesh.num_elements();
  const std::size_t count = held_.front().size();
  std::vector<bool> encloses(at(elements), false);
  for (const RefinedMesh::Junction& junction : junctions) {
    for (int e = 0; e < elements; ++e) {
      if (std::abs(mesh.sigma(e, 0.5) - junction.sigma) <
          junction.half_width * 1.01) {
        encloses[at(e)] = true;
      }
    }
    const int behind = mesh.locate(junction.sigma).element;
    if (junction.half_width == 0.0 && behind > 0) kinks_.push_back({behind});
  }
  std::ranges::sort(kinks_, {}, &Kink::boundary);
  // What holds on most of an element's points.
  HeldAlong most(at(elements), std::vector<nlp::Held>(count, nlp::Held::No));
  for (int e = 0; e < elements; ++e) {
    for (std::size_t i = 0; i < count; ++i) {
      for (const nlp::Held side : {nlp::Held::AtLower, nlp::Held::AtUpper}) {
        int times = 0;
        for (int c = e * p; c < (e + 1) * p; ++c) {
          times += held_[at(c)][i] == side ? 1 : 0;
        }
        if (whole ? times == p : 2 * times > p) most[at(e)][i] = side;
      }
    }
  }
  for (int b = 1; b < elements; ++b) {
    const bool kink = std::ranges::any_of(
        kinks_, [&](const Kink& one) { return one.boundary == b; });
    const bool differs = most[at(b - 1)] != most[at(b)];
    const bool enclosed = encloses[at(b - 1)] || encloses[at(b)];
    if (differs != kink && !enclosed) return false;
  }
  for (int e = 0; e < elements; ++e) {
    if (encloses[at(e)]) continue;
    for (int c = e * p; c < (e + 1) * p; ++c) held_[at(c)] = most[at(e)];
  }
  // A state that is held on an element is so where it begins.
  for (int e = 1; e < elements; ++e) {
    for (std::size_t i = 0; i < at(layout_.num_states()); ++i) {
      if (most[at(e)][i] != nlp::Held::No && !encloses[at(e)]) {
        held_[at(e * p - 1)][i] = most[at(e)][i];
      }
    }
  }
  return !kinks_.empty();
}

Mesh Settling::mesh_of(std::span<const double> sigmas) const {
  Mesh mesh = first_mesh_;
  for (std::size_t i = 0; i < kinks_.size(); ++i) {
    mesh.boundaries[at(kinks_[i].boundary)] = sigmas[i];
  }
  return mesh;
}

PrimalDual Settling::start(nlp::Problem& program, const Mesh& mesh) const {
  PrimalDual out = first_;
  out.z_lower.assign(out.x.size(), 0.0);
  out.z_upper.assign(out.x.size(), 0.0);
  // A distance that no multiplier reaches, where a bound is not to hold.
  constexpr double kOff = 1e-7;
  const int states = layout_.num_states();
  const int variables = states + layout_.num_controls();
  for (int c = 0; c < layout_.num_points(); ++c) {
    const int e = c / mesh.degree;
    for (int i = 0; i < variables; ++i) {
      const int index =
          i < states ? layout_.state(c + 1, i) : layout_.control(c, i - states);
      double& x = out.x[at(index)];
      if (i >= states) x *= mesh.length(e) / first_mesh_.length(e);
      const nlp::Range range = program.variable_range(index);
      if (range.single()) continue;
      const double size = i < states ? 1.0 : mesh.length(e);
      switch (held_[at(c)][at(i)]) {
        case nlp::Held::AtLower:
          x = range.lower;
          break;
        case nlp::Held::AtUpper:
          x = range.upper;
          break;
        case nlp::Held::No:
          x = std::max(std::min(x, range.upper - kOff * size),
                       range.lower + kOff * size);
      }
    }
  }
  if (layout_.num_limits() == 0 || !program.set_point(out.x)) return out;
  std::vector<double> g(at(program.num_constraints()));
  program.eval_g(g);
  for (int c = 0; c < layout_.num_points(); ++c) {
    for (int i = 0; i < layout_.num_limits(); ++i) {
      const int row = layout_.limit(c, i);
      const nlp::Range range = program.constraint_range(row);
      if (range.single()) continue;
      double& lambda = out.lambda[at(row)];
      const double weight = program.weight(program.num_variables() + row);
      const auto reaches = [&](double distance) {
        return weight * (2.0 * std::abs(distance) + kOff);
      };
      switch (held_[at(c)][at(variables + i)]) {
        case nlp::Held::AtLower:
          lambda = std::min(lambda, -reaches(g[at(row)] - range.lower));
          break;
        case nlp::Held::AtUpper:
          lambda = std::max(lambda, reaches(range.upper - g[at(row)]));
          break;
        case nlp::Held::No:
          lambda = 0.0;
      }
    }
  }
  return out;
}

std::optional<Settled> Settling::at_kinks(
    std::span<const double> sigmas) const {
  Mesh mesh = mesh_of(sigmas);
  if (std::ranges::adjacent_find(mesh.boundaries,
                                 std::ranges::greater_equal{}) !=
      mesh.boundaries.end()) {
    return std::nullopt;
  }
  Settled out{std::move(mesh), {}, {}, 0.0};
  out.program = problem_.on(out.mesh);
  NewtonOptions newton;
  newton.tolerance = 1e-10;
  newton.to_rounding = true;
  newton.max_iterations = 12;
  NewtonResult result =
      solve_with_newton(*out.program, start(*out.program, out.mesh), newton);
  if (!(result.residual <= newton.tolerance) ||
      !out.program->set_point(result.point.x)) {
    return std::nullopt;
  }
  out.point = std::move(result.point);
  out.cost = out.program->eval_f();
  return out;
}

void Settling::jumps(const Settled& here, std::span<double> out) const {
  const MeshPath path(here.mesh, layout_, here.point);
  // At the first points of an arc a control makes good what a state's rate errs
  // by where the arc begins: its curve is read from the next element.
  for (std::size_t i = 0; i < kinks_.size(); ++i) {
    const auto [boundary, control] = kinks_[i];
    const bool next_is_arc =
        boundary + 1 < here.mesh.num_elements() &&
        (i + 1 == kinks_.size() || kinks_[i + 1].boundary > boundary + 1);
    const int behind = next_is_arc ? boundary + 1 : boundary;
    const double t = (here.mesh.boundaries[at(boundary)] -
                      here.mesh.boundaries[at(behind)]) /
                     here.mesh.length(behind);
    out[i] = path.values(boundary - 1, 1.0).controls[control] -
             path.values(behind, t).controls[control];
  }
}

std::optional<Settled> Settling::run() {
  // The control that turns most at a kink.
  const MeshPath first(first_mesh_, layout_, first_);
  constexpr double kBeside = 0.5;
  std::vector<double> sigmas;
  for (Kink& kink : kinks_) {
    sigmas.push_back(first_mesh_.boundaries[at(kink.boundary)]);
    double most = -1.0;
    for (std::size_t k = 0; k < at(layout_.num_controls()); ++k) {
      const auto slope = [&](int e, double from, double to) {
        return (first.values(e, to).controls[k] -
                first.values(e, from).controls[k]) /
               ((to - from) * first_mesh_.length(e));
      };
      const double turn = std::abs(slope(kink.boundary - 1, kBeside, 1.0) -
                                   slope(kink.boundary, 0.0, kBeside));
      if (turn > most) most = turn, kink.control = k;
    }
  }
  SquareOptions options;
  options.tolerance = 1e-13;
  options.max_iterations = 20;
  const SquareResult found = solve_by_hybrid(
      [&](std::span<const double> x, std::span<double> residual) {
        const auto here = at_kinks(x);
        if (here) jumps(*here, residual);
        return here.has_value();
      },
      sigmas, options);
  constexpr double kContinuous = 1e-7;
  if (!(found.residual < kContinuous)) return std::nullopt;
  auto out = at_kinks(found.x);
  if (!out) return std::nullopt;
  // Multipliers that vanish have any sign, and no more of it than certified.
  constexpr double kGood = 1e-9;
  const nlp::KktResidual kkt = first_order(*out->program, out->point);
  if (std::max(kkt.infeasibility, kkt.bound_violation) > kGood ||
      kkt.sign > kAsCertified) {
    return std::nullopt;
  }
  return out;
}

}  // namespace

std::optional<Settled> settled(
    const Posed& problem, nlp::Problem& program, const MeshPath& path,
    const PrimalDual& point,
    const std::vector<RefinedMesh::Junction>& junctions) {
  for (const double between : {1e-4, 1e-2}) {
    const auto held =
        held_along(program, point, path.mesh(), path.layout(), between);
    for (const bool whole : {false, true}) {
      Settling settling(problem, path, point, held);
      if (!settling.find_kinks(junctions, whole)) continue;
      if (auto found = settling.run()) return found;
    }
  }
  return std::nullopt;
}

}  // namespace brachisto::ocp
