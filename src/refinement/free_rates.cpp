// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/free_rates.hpp"

#include <cmath>

#include "brachisto/nlp/kkt_residual.hpp"
#include "brachisto/solvers/newton_kkt.hpp"
#include "math/central_difference.hpp"
#include "math/index.hpp"
#include "model/start_angle.hpp"
#include "refinement/mesh_solve.hpp"
#include "transcription/prolongation.hpp"

namespace brachisto {

namespace {

/// What solutions with the factorised conditions are worth.
constexpr double kOfSolves = 1e-13;

}  // namespace

FreeRates::Equations::Equations(const Scene& scene, const Mesh& mesh,
                                double phi)
    : problem(scene, mesh, phi),
      contact([&] {
        return scene.contact == Contact::Smooth
                   ? std::optional<ContactEquation>(std::in_place, problem)
                   : std::nullopt;
      }()),
      system(problem, tangency(), nlp::equations_only(problem)) {}

FreeRates::FreeRates(const Scene& scene, const Mesh& mesh,
                     const PrimalDual& point, double phi)
    : at_(with_rotation(scene), mesh, phi), point_(point), phi_(phi) {
  if (at(at_.problem.num_variables()) != point.x.size()) {
    point_ = prolong(ExtremalCurve(RollingTime(scene, mesh, phi), point),
                     at_.problem);
  }
  if (!at_.system.evaluate(point_.x, point_.lambda, phi_)) return;
  time_ = at_.problem.eval_f();
  pull_ = nlp::lagrangian_gradient(at_.problem, point_.lambda);
  at_.system.evaluate_jacobian();
  chain_ = BorderedChain::make(at_.system);
  regular_ = chain_ && chain_->factorise();
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
        start += weight * start_angle(there);
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
  if (scene().contact == Contact::Smooth) {
    // C_A turns about A with β₀.
    const VariableLayout& layout = at_.problem.layout();
    const double r = scene().body.radius;
    const double beta_0 = start_angle(scene());
    const auto x = pull_[at(layout.state(0, StateComponent::X))];
    const auto z = pull_[at(layout.state(0, StateComponent::Z))];
    rate.at_fixed_contacts -= static_cast<double>(
        start * r * (x * std::cos(beta_0) + z * std::sin(beta_0)));
  }
  if (nlp::TangencyCondition* tangency = at_.tangency()) {
    for (double& value : residual) value = -value;
    std::vector<double> direction(residual.size());
    const bool solved = chain_->solve(residual, direction, kOfSolves);
    const double phi = solved ? direction.back() : std::nan("");
    const nlp::SparseVector& turn = tangency->fixed_rates();
    for (std::size_t i = 0; i < turn.index.size(); ++i) {
      rate.total +=
          static_cast<double>(pull_[at(turn.index[i])] * turn.value[i] * phi);
    }
  }
  return rate;
}

/// F = (∂²𝓗/∂β²) κ next to the answer.
double FreeRates::contact_response() {
  nlp::TangencyCondition* tangency = at_.tangency();
  if (tangency == nullptr) return std::nan("");
  std::vector<double> right(at(at_.system.size()), 0.0), direction = right;
  right.back() = tangency->linearise(point_.x, point_.lambda).by_parameter;
  return chain_->solve(right, direction, kOfSolves) ? direction.back()
                                                    : std::nan("");
}

std::unique_ptr<TimeRates> FreeRates::next(SceneCoordinate coordinate,
                                           double by) {
  const Scene there = moved(scene(), coordinate, by);
  Equations other(there, at_.problem.mesh(), phi_);
  NewtonOptions options;
  options.to_rounding = true;
  const NewtonResult found = solve_with_newton(other.problem, other.tangency(),
                                               turned_to(there), phi_, options);
  if (found.residual >
      reachable(kRoundingResidual, other.problem, found.point.x)) {
    return nullptr;
  }
  return std::make_unique<FreeRates>(there, at_.problem.mesh(), found.point,
                                     found.phi);
}

}  // namespace brachisto
