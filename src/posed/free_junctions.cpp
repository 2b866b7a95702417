// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "posed/free_junctions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "brachisto/math/index.hpp"
#include "nlp/active_set.hpp"
#include "posed/bounds.hpp"
#include "posed/certificate.hpp"

namespace brachisto::ocp {

namespace {

/// Of each element, of each control: the bound at which it is, all along.
using Structure = std::vector<std::vector<nlp::Held>>;

/// The program of a mesh with the places σ_i of some boundaries behind its
/// variables.
///
/// Controls are u h₀ with h₀ the lengths that the mesh began with, so that
/// their bounds stay. Then f and g are affine in the length of each element,
/// and a second mesh with σ_i moved by any Δ gives ∂/∂σ_i of them, and of the
/// Lagrangian's gradient, to rounding; ∂²/∂σ_i∂σ_j is 0.
class FreeJunctions final : public nlp::Problem {
 public:
  /// \param held  controls that are fixed at their bounds; empty: none
  FreeJunctions(const Posed& problem, Mesh mesh, std::vector<int> boundaries,
                const Structure& held)
      : problem_(problem),
        first_(std::move(mesh)),
        layout_(problem.layout(first_)),
        boundaries_(std::move(boundaries)),
        here_{first_, problem.on(first_), {}, {}},
        moved_(boundaries_.size()) {
    const nlp::Problem& inner = *here_.program;
    num_inner_ = inner.num_variables();
    ranges_.reserve(at(num_inner_) + boundaries_.size());
    for (int v = 0; v < num_inner_; ++v) {
      ranges_.push_back(inner.variable_range(v));
    }
    for (int c = 0; c < layout_.num_points() && !held.empty(); ++c) {
      for (int k = 0; k < layout_.num_controls(); ++k) {
        const nlp::Held here = held[at(c / first_.degree)][at(k)];
        if (here == nlp::Held::No) continue;
        nlp::Range& range = ranges_[at(layout_.control(c, k))];
        range.lower = range.upper = nlp::held_value(range, here);
      }
    }
    jac_ = inner.jac_g_pattern();
    hess_ = inner.hess_lag_pattern();
    for (std::size_t i = 0; i < boundaries_.size(); ++i) {
      const int b = boundaries_[i];
      constexpr double kRoom = 0.45;  // less than a half: they do not meet
      const double sigma = first_.boundaries[at(b)];
      ranges_.push_back({sigma - kRoom * first_.length(b - 1),
                         sigma + kRoom * first_.length(b)});
      const int index = num_inner_ + static_cast<int>(i);
      for (int row = first_row(b); row < end_row(b); ++row) {
        jac_.add(row, index);
      }
      for (int v = first_variable(b); v < end_variable(b); ++v) {
        hess_.add(index, v);
      }
      hess_.add(index, layout_.last());
    }
  }

  [[nodiscard]] int num_variables() const override {
    return num_inner_ + static_cast<int>(boundaries_.size());
  }
  [[nodiscard]] int num_constraints() const override {
    return here_.program->num_constraints();
  }
  [[nodiscard]] nlp::Range variable_range(int index) const override {
    return ranges_[at(index)];
  }
  [[nodiscard]] nlp::Range constraint_range(int index) const override {
    return here_.program->constraint_range(index);
  }
  [[nodiscard]] double weight(int index) const override {
    if (index < num_inner_) return here_.program->weight(index);
    const int behind = index - static_cast<int>(boundaries_.size());
    return behind < num_inner_ ? 1.0 : here_.program->weight(behind);
  }
  [[nodiscard]] const nlp::SparsityPattern& jac_g_pattern() const override {
    return jac_;
  }
  [[nodiscard]] const nlp::SparsityPattern& hess_lag_pattern() const override {
    return hess_;
  }
  /// Places are in the border.
  [[nodiscard]] nlp::ChainStructure chain_structure() const override {
    nlp::ChainStructure chain = here_.program->chain_structure();
    if (chain.empty()) return chain;
    const std::size_t count = boundaries_.size();
    chain.block.insert(chain.block.begin() + num_inner_, count,
                       nlp::ChainStructure::kBorder);
    if (!chain.scale.empty()) {
      chain.scale.insert(chain.scale.begin() + num_inner_, count, 1.0);
    }
    return chain;
  }
  [[nodiscard]] std::string variable_name(int index) const override {
    return index < num_inner_ ? here_.program->variable_name(index)
                              : fmt::format("junction[{}]", index - num_inner_);
  }
  [[nodiscard]] std::string constraint_name(int index) const override {
    return here_.program->constraint_name(index);
  }
  [[nodiscard]] std::string refusal() const override { return refusal_; }

  [[nodiscard]] const std::vector<int>& boundaries() const {
    return boundaries_;
  }
  [[nodiscard]] Mesh mesh_of(std::span<const double> x) const {
    Mesh mesh = first_;
    for (std::size_t i = 0; i < boundaries_.size(); ++i) {
      mesh.boundaries[at(boundaries_[i])] = x[at(num_inner_) + i];
    }
    return mesh;
  }
  /// By what controls are multiplied on a mesh, and other variables by 1.
  [[nodiscard]] std::vector<double> shares(const Mesh& mesh) const {
    std::vector<double> out(at(num_inner_), 1.0);
    for (int c = 0; c < layout_.num_points(); ++c) {
      const int e = c / first_.degree;
      for (int k = 0; k < layout_.num_controls(); ++k) {
        out[at(layout_.control(c, k))] = mesh.length(e) / first_.length(e);
      }
    }
    return out;
  }

 private:
  /// A program with its mesh, and values at the current point.
  struct Inner {
    Mesh mesh;
    std::unique_ptr<nlp::Problem> program;
    std::vector<double> shares, x;
  };

  // What depends on the lengths beside a boundary.
  [[nodiscard]] int first_row(int b) const {
    return layout_.defect((b - 1) * first_.degree, 0);
  }
  [[nodiscard]] int end_row(int b) const {
    return layout_.defect((b + 1) * first_.degree, 0);
  }
  [[nodiscard]] int first_variable(int b) const {
    return layout_.state((b - 1) * first_.degree, 0);
  }
  [[nodiscard]] int end_variable(int b) const {
    return layout_.state((b + 1) * first_.degree, 0) + layout_.num_states();
  }
  [[nodiscard]] double step(std::size_t i) const {
    return moved_[i].mesh.boundaries[at(boundaries_[i])] -
           here_.mesh.boundaries[at(boundaries_[i])];
  }

  bool move(Inner& inner, Mesh mesh, std::span<const double> x) {
    if (inner.program == nullptr || inner.mesh.boundaries != mesh.boundaries) {
      inner.program = problem_.on(mesh);
    }
    inner.mesh = std::move(mesh);
    inner.shares = shares(inner.mesh);
    inner.x.resize(at(num_inner_));
    for (std::size_t v = 0; v < inner.x.size(); ++v) {
      inner.x[v] = x[v] * inner.shares[v];
    }
    if (inner.program->set_point(inner.x)) return true;
    refusal_ = inner.program->refusal();
    return false;
  }
  bool do_set_point(std::span<const double> x) override {
    refusal_.clear();
    const Mesh mesh = mesh_of(x);
    if (std::ranges::adjacent_find(mesh.boundaries,
                                   std::ranges::greater_equal{}) !=
        mesh.boundaries.end()) {
      refusal_ = "junctions have met";
      return false;
    }
    if (!move(here_, mesh, x)) return false;
    for (std::size_t i = 0; i < moved_.size(); ++i) {
      constexpr double kStep = 0.25;
      Mesh other = mesh;
      other.boundaries[at(boundaries_[i])] +=
          kStep * mesh.length(boundaries_[i]);
      if (!move(moved_[i], std::move(other), x)) return false;
    }
    return true;
  }

  /// factor · ∇f + Jᵀ λ of an inner program, by the variables of this one.
  [[nodiscard]] static std::vector<double> slope(
      const Inner& inner, double factor, std::span<const double> lambda) {
    const nlp::Problem& program = *inner.program;
    std::vector<double> out(inner.x.size());
    program.eval_grad_f(out);
    for (double& value : out) value *= factor;
    if (!lambda.empty()) {
      std::vector<double> values(program.jac_g_pattern().num_entries());
      program.eval_jac_g(values);
      program.jac_g_pattern().for_each(
          [&](std::size_t entry, int row, int col) {
            out[at(col)] += values[entry] * lambda[at(row)];
          });
    }
    for (std::size_t v = 0; v < out.size(); ++v) out[v] *= inner.shares[v];
    return out;
  }
  [[nodiscard]] double do_eval_f() const override {
    return here_.program->eval_f();
  }
  void do_eval_grad_f(std::span<double> grad_f) const override {
    const std::vector<double> inner = slope(here_, 1.0, {});
    std::ranges::copy(inner, grad_f.begin());
    for (std::size_t i = 0; i < moved_.size(); ++i) {
      grad_f[at(num_inner_) + i] =
          (moved_[i].program->eval_f() - here_.program->eval_f()) / step(i);
    }
  }
  void do_eval_g(std::span<double> g) const override {
    here_.program->eval_g(g);
  }
  void do_eval_jac_g(std::span<double> values) const override {
    const nlp::SparsityPattern& inner = here_.program->jac_g_pattern();
    here_.program->eval_jac_g(values.first(inner.num_entries()));
    inner.for_each([&](std::size_t entry, int /*row*/, int col) {
      values[entry] *= here_.shares[at(col)];
    });
    auto next = values.begin() + static_cast<long>(inner.num_entries());
    std::vector<double> g(at(num_constraints())), other(g.size());
    here_.program->eval_g(g);
    for (std::size_t i = 0; i < moved_.size(); ++i) {
      moved_[i].program->eval_g(other);
      const int b = boundaries_[i];
      for (int row = first_row(b); row < end_row(b); ++row) {
        *next++ = (other[at(row)] - g[at(row)]) / step(i);
      }
    }
  }
  void do_eval_hess_lag(double objective_factor, std::span<const double> lambda,
                        std::span<double> values) const override {
    const nlp::SparsityPattern& inner = here_.program->hess_lag_pattern();
    here_.program->eval_hess_lag(objective_factor, lambda,
                                 values.first(inner.num_entries()));
    inner.for_each([&](std::size_t entry, int row, int col) {
      values[entry] *= here_.shares[at(row)] * here_.shares[at(col)];
    });
    auto next = values.begin() + static_cast<long>(inner.num_entries());
    const std::vector<double> first = slope(here_, objective_factor, lambda);
    for (std::size_t i = 0; i < moved_.size(); ++i) {
      const std::vector<double> other =
          slope(moved_[i], objective_factor, lambda);
      const auto by = [&](int v) {
        return (other[at(v)] - first[at(v)]) / step(i);
      };
      const int b = boundaries_[i];
      for (int v = first_variable(b); v < end_variable(b); ++v) *next++ = by(v);
      *next++ = by(layout_.last());
    }
  }

  const Posed& problem_;
  Mesh first_;
  Layout layout_;
  std::vector<int> boundaries_;
  Inner here_;
  std::vector<Inner> moved_;
  int num_inner_ = 0;
  std::vector<nlp::Range> ranges_;  ///< of variables
  nlp::SparsityPattern jac_, hess_;
  std::string refusal_;
};

/// At which bound a control is at most points of an element.
Structure structure(const Posed& problem, const Mesh& mesh,
                    const MeshPath& path) {
  const Statement& said = problem.statement();
  const std::size_t count = said.controls.size();
  constexpr double kNear = 1e-3;  // of the range
  constexpr std::array kPlaces{0.2, 0.35, 0.5, 0.65, 0.8};
  Structure out(at(mesh.num_elements()),
                std::vector<nlp::Held>(count, nlp::Held::No));
  for (int e = 0; e < mesh.num_elements(); ++e) {
    std::vector<std::array<int, 2>> times(count);
    for (const double t : kPlaces) {
      const PathValues here = path.values(mesh.sigma(e, t));
      for (std::size_t k = 0; k < count; ++k) {
        const Variable& control = said.controls[k];
        const double scale = problem.scales()[here.states.size() + k];
        const double value = here.controls[k] * scale;
        const double range = control.upper - control.lower;
        if (range == 0.0) continue;  // fixed: it changes nowhere
        const double near = kNear * (std::isfinite(range) ? range : scale);
        if (value < control.lower + near) ++times[k][0];
        if (value > control.upper - near) ++times[k][1];
      }
    }
    for (std::size_t k = 0; k < count; ++k) {
      constexpr int kMost = 3;
      if (times[k][0] >= kMost) out[at(e)][k] = nlp::Held::AtLower;
      if (times[k][1] >= kMost) out[at(e)][k] = nlp::Held::AtUpper;
    }
  }
  return out;
}

/// What holds changes at the given boundaries and at no other.
bool changes_at(const Structure& held, const std::vector<int>& boundaries) {
  for (std::size_t e = 1; e < held.size(); ++e) {
    const bool changes = held[e] != held[e - 1];
    const bool may = std::ranges::count(boundaries, static_cast<int>(e)) > 0;
    if (changes != may) return false;
  }
  return true;
}

/// The same solution, on a mesh that begins with its places and with controls
/// that are free within their bounds.
void rebase(const Posed& problem, OnMesh& here) {
  const auto& old = static_cast<const FreeJunctions&>(*here.program);
  PrimalDual& point = here.result.point;
  const Mesh mesh = old.mesh_of(point.x);
  const std::vector<double> shares = old.shares(mesh);
  for (std::size_t v = 0; v < shares.size(); ++v) point.x[v] *= shares[v];
  here.program = std::make_unique<FreeJunctions>(problem, mesh,
                                                 old.boundaries(), Structure{});
  here.mesh = mesh;
}

/// Bounds' multipliers, of those variables that are at bounds. False if one of
/// them has the wrong sign.
bool multiply(OnMesh& here) {
  constexpr double kVanishes = 1e-4;
  PrimalDual& point = here.result.point;
  nlp::Problem& program = *here.program;
  nlp::ActiveSet active = nlp::equations_only(program);
  for (int v = 0; v < program.num_variables(); ++v) {
    const nlp::Range range = program.variable_range(v);
    if (range.single()) continue;
    constexpr double kThere = 1e-13;
    // To the bound itself: where its multiplier vanishes it is held all the
    // same.
    double& x = point.x[at(v)];
    if (x - range.lower < kThere) {
      active.variables[at(v)] = nlp::Held::AtLower;
      x = range.lower;
    } else if (range.upper - x < kThere) {
      active.variables[at(v)] = nlp::Held::AtUpper;
      x = range.upper;
    }
  }
  if (!program.set_point(point.x)) return false;
  nlp::set_bound_multipliers(program, active, point);
  // At a jump they vanish, as nearly as the mesh tells.
  for (std::vector<double>* all : {&point.z_lower, &point.z_upper}) {
    for (double& z : *all) {
      if (z < 0.0 && z > -kVanishes) z = 0.0;
    }
  }
  return first_order(program, point).max() < kVanishes;
}

}  // namespace

std::optional<OnMesh> with_free_junctions(const Posed& problem,
                                          MeshSolver& solver, const Mesh& mesh,
                                          const std::vector<int>& boundaries,
                                          const MeshPath& nearby,
                                          int most_iterations) {
  const Structure held = structure(problem, mesh, nearby);
  if (!changes_at(held, boundaries)) return std::nullopt;
  OnMesh here{mesh,
              problem.layout(mesh),
              std::make_unique<FreeJunctions>(problem, mesh, boundaries, held),
              {},
              0.0,
              0.0,
              false};
  PrimalDual start = nearby.on(mesh, here.layout);
  for (const int b : boundaries) start.x.push_back(mesh.boundaries[at(b)]);
  for (int v = 0; v < here.program->num_variables(); ++v) {
    const nlp::Range range = here.program->variable_range(v);
    if (range.single()) start.x[at(v)] = range.lower;
  }
  solver.fill_in(here, start, most_iterations);
  if (!here.solved() || !here.exact) return std::nullopt;
  rebase(problem, here);
  if (!multiply(here)) return std::nullopt;
  here.gap = left_by_bounds(*here.program, here.result.point);
  return here;
}

}  // namespace brachisto::ocp
