// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/free_rates.hpp"

#include <Eigen/LU>
#include <cmath>

#include "brachisto/nlp/kkt_residual.hpp"
#include "brachisto/solvers/newton_kkt.hpp"
#include "math/central_difference.hpp"
#include "math/index.hpp"
#include "model/start_angle.hpp"
#include "refinement/mesh_solve.hpp"
#include "refinement/start_closure.hpp"
#include "transcription/prolongation.hpp"

namespace brachisto {

namespace {

/// What solutions with the factorised conditions are worth.
constexpr double kOfSolves = 1e-13;

/// The path of a solution, whose costates at the end are in a field that
/// depends on the place those of the problem's current point.
ExtremalCurve path_of(const Scene& scene, const Mesh& mesh,
                      const PrimalDual& point, double phi) {
  RollingTime problem(scene, mesh, phi);
  static_cast<void>(problem.set_point(point.x));
  return ExtremalCurve(problem, point);
}

/// The scene with θ, and with the slope that its start is built from: between
/// given ends that of a uniform body has no effect on its time, but on how the
/// time changes with an offset.
Scene posed_for_rates(const Scene& scene, const Mesh& mesh,
                      const PrimalDual& point, double phi) {
  Scene out = with_rotation(scene);
  if (slope_at_A_is_open(out) && !out.world.start_slope) {
    out.world.start_slope = path_of(scene, mesh, point, phi).at(0.0).beta;
  }
  return out;
}

/// C_y y.
double along(const nlp::TangencyCondition::Linearisation& row,
             std::span<const double> y, int num_variables) {
  long double sum = 0.0L;
  const auto add = [&](const nlp::SparseVector& part, int offset) {
    for (std::size_t i = 0; i < part.index.size(); ++i) {
      sum += static_cast<long double>(part.value[i]) *
             y[at(offset + part.index[i])];
    }
  };
  add(row.by_x, 0);
  add(row.by_lambda, num_variables);
  return static_cast<double>(sum);
}

}  // namespace

FreeRates::Equations::Equations(const Scene& scene, const Mesh& mesh,
                                double phi)
    : problem(scene, mesh, phi),
      contact([&] {
        return scene.contact == Contact::Smooth
                   ? std::optional<ContactEquation>(std::in_place, problem)
                   : std::nullopt;
      }()),
      start([&] {
        return slope_at_A_is_open(scene)
                   ? std::optional<StartEquation>(std::in_place, problem)
                   : std::nullopt;
      }()),
      system(problem, tangency(), nlp::equations_only(problem)) {
  if (!start) return;
  start->set_parameter(start_angle(scene));
  if (contact) contact->set_parameter(phi);
}

std::vector<nlp::TangencyCondition*> FreeRates::Equations::closing() {
  std::vector<nlp::TangencyCondition*> out;
  if (contact) out.push_back(&*contact);
  if (start) out.push_back(&*start);
  return out;
}

FreeRates::FreeRates(const Scene& scene, const Mesh& mesh,
                     const PrimalDual& point, double phi)
    : at_(posed_for_rates(scene, mesh, point, phi), mesh, phi),
      point_(point),
      phi_(phi) {
  if (at(at_.problem.num_variables()) != point.x.size()) {
    point_ = prolong(path_of(scene, mesh, point, phi), at_.problem);
  }
  if (!at_.system.evaluate(point_.x, point_.lambda, phi_)) return;
  time_ = at_.problem.eval_f();
  pull_ = nlp::lagrangian_gradient(at_.problem, point_.lambda);
  at_.system.evaluate_jacobian();
  chain_ = BorderedChain::make(at_.system);
  regular_ =
      chain_ && chain_->factorise() && (!at_.start || linearise_around_chain());
}

bool FreeRates::linearise_around_chain() {
  const int n = at_.problem.num_variables();
  const std::vector<nlp::TangencyCondition*> closing = at_.closing();
  const auto size = static_cast<Eigen::Index>(closing.size());
  around_.jacobian.resize(size, size);
  for (nlp::TangencyCondition* condition : closing) {
    around_.rows.push_back(condition->linearise(point_.x, point_.lambda));
    std::vector<double> moved(at(at_.system.size()), 0.0);
    const nlp::SparseVector& rates = condition->fixed_rates();
    for (std::size_t i = 0; i < rates.index.size(); ++i) {
      moved[at(rates.index[i])] = rates.value[i];
    }
    around_.turns.emplace_back(moved.size());
    if (!chain_->solve(moved, around_.turns.back(), kOfSolves)) return false;
  }
  for (Eigen::Index i = 0; i < size; ++i) {
    const auto& row = around_.rows[static_cast<std::size_t>(i)];
    for (Eigen::Index j = 0; j < size; ++j) {
      around_.jacobian(i, j) =
          along(row, around_.turns[static_cast<std::size_t>(j)], n) +
          (i == j ? row.by_parameter : 0.0);
    }
  }
  const double determinant = around_.jacobian.determinant();
  return std::isfinite(determinant) && determinant != 0.0;
}

PrimalDual FreeRates::turned_to(const Scene& scene) const {
  PrimalDual out = point_;
  const VariableLayout& layout = at_.problem.layout();
  if (!layout.has_theta()) return out;
  const double turn = scene.body.theta_m - at_.scene().body.theta_m;
  for (int node = 0; node < layout.num_nodes(); ++node) {
    out.x[at(layout.state(node, StateComponent::Theta))] += turn;
  }
  return out;
}

TimeRate FreeRates::by(SceneCoordinate coordinate) {
  std::vector<double> residual(at(at_.system.size()), 0.0);
  const std::vector<nlp::TangencyCondition*> closing = at_.closing();
  Eigen::VectorXd open =
      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(closing.size()));
  double objective = 0.0, start = 0.0;
  math::central_difference_by_place(
      difference_step(scene(), coordinate), [&](double place, double weight) {
        const Scene there = moved(scene(), coordinate, place);
        const PrimalDual point = turned_to(there);
        Equations other(there, at_.problem.mesh(), phi_);
        if (!other.system.evaluate(point.x, point.lambda, phi_)) {
          weight = std::nan("");
        }
        for (std::size_t i = 0; i < residual.size(); ++i) {
          residual[i] += weight * other.system.residual()[i];
        }
        objective += weight * other.problem.eval_f();
        if (!at_.start) {
          start += weight * start_angle(there);
          return;
        }
        Eigen::Index i = 0;
        for (nlp::TangencyCondition* condition : other.closing()) {
          open[i++] +=
              weight * condition->linearise(point.x, point.lambda).residual;
        }
      });

  // 𝓛_p, the values of fixed variables moving along.
  long double explicitly = objective;
  const int n = at_.problem.num_variables();
  for (int i = 0; i < n; ++i) {
    if (at_.system.given(i)) explicitly -= pull_[at(i)] * residual[at(i)];
  }
  for (std::size_t i = 0; i < point_.lambda.size(); ++i) {
    explicitly +=
        static_cast<long double>(point_.lambda[i]) * residual[at(n) + i];
  }
  TimeRate rate{static_cast<double>(explicitly),
                static_cast<double>(explicitly)};
  if (scene().contact == Contact::Smooth && !at_.start) {
    // C_A turns about A with β₀.
    const VariableLayout& layout = at_.problem.layout();
    const double r = scene().body.radius;
    const double beta_0 = start_angle(scene());
    const auto x = pull_[at(layout.state(0, StateComponent::X))];
    const auto z = pull_[at(layout.state(0, StateComponent::Z))];
    rate.at_fixed_contacts -= static_cast<double>(
        start * r * (x * std::cos(beta_0) + z * std::sin(beta_0)));
  }
  if (closing.empty()) return rate;
  const Eigen::VectorXd slopes = slope_rates(std::move(residual), open);
  for (std::size_t c = 0; c < closing.size(); ++c) {
    const nlp::SparseVector& turn = closing[c]->fixed_rates();
    for (std::size_t i = 0; i < turn.index.size(); ++i) {
      rate.total +=
          static_cast<double>(pull_[at(turn.index[i])] * turn.value[i] *
                              slopes[static_cast<Eigen::Index>(c)]);
    }
  }
  return rate;
}

Eigen::VectorXd FreeRates::slope_rates(std::vector<double> residual,
                                       const Eigen::VectorXd& open) {
  for (double& value : residual) value = -value;
  std::vector<double> direction(residual.size());
  if (!chain_->solve(residual, direction, kOfSolves)) {
    return Eigen::VectorXd::Constant(open.size(), std::nan(""));
  }
  if (!at_.start) return Eigen::VectorXd::Constant(1, direction.back());
  Eigen::VectorXd right = -open;
  for (Eigen::Index i = 0; i < right.size(); ++i) {
    right[i] -= along(around_.rows[static_cast<std::size_t>(i)], direction,
                      at_.problem.num_variables());
  }
  return around_.jacobian.partialPivLu().solve(right);
}

/// F = (∂²𝓗/∂β²) κ next to the answer.
double FreeRates::contact_response() {
  if (!at_.contact) return std::nan("");
  const double per_kink =
      at_.contact->linearise(point_.x, point_.lambda).by_parameter;
  if (at_.start) {
    // The slope at B is the first of the two.
    Eigen::VectorXd right = Eigen::VectorXd::Zero(around_.jacobian.rows());
    right[0] = per_kink;
    return around_.jacobian.partialPivLu().solve(right)[0];
  }
  std::vector<double> right(at(at_.system.size()), 0.0), direction = right;
  right.back() = per_kink;
  return chain_->solve(right, direction, kOfSolves) ? direction.back()
                                                    : std::nan("");
}

std::unique_ptr<TimeRates> FreeRates::next(SceneCoordinate coordinate,
                                           double by) {
  const Scene there = moved(scene(), coordinate, by);
  const Mesh& mesh = at_.problem.mesh();
  if (at_.start) {
    RollingTime problem(there, mesh, phi_);
    const MeshSolution found =
        close_start(problem, {turned_to(there), phi_, -1.0}, {}, stay_on_mesh);
    if (!found.solved()) return nullptr;
    return std::make_unique<FreeRates>(problem.scene(), mesh, found.point,
                                       found.tangency.phi);
  }
  Equations other(there, mesh, phi_);
  NewtonOptions options;
  options.to_rounding = true;
  const NewtonResult found = solve_with_newton(other.problem, other.tangency(),
                                               turned_to(there), phi_, options);
  if (found.residual >
      reachable(kRoundingResidual, other.problem, found.point.x)) {
    return nullptr;
  }
  return std::make_unique<FreeRates>(there, mesh, found.point, found.phi);
}

}  // namespace brachisto
