// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/free_rates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "brachisto/math/index.hpp"
#include "brachisto/math/jet.hpp"
#include "brachisto/nlp/problem.hpp"
#include "math/central_difference.hpp"
#include "math/dense.hpp"
#include "model/field.hpp"
#include "model/start_angle.hpp"
#include "refinement/mesh_solve.hpp"
#include "refinement/start_closure.hpp"
#include "refinement/surface_passages.hpp"
#include "refinement/turn_meshes.hpp"
#include "transcription/prolongation.hpp"

namespace brachisto {

namespace {

/// What solutions with the factorised conditions are worth.
constexpr double kOfSolves = 1e-13;

/// σ of an element end and of its passage are the same up to this; where
/// rounding keeps them apart, up to the second.
constexpr double kPlaced = 1e-12, kAlmostPlaced = 1e-9;

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

/// With the law of the first element's side at the start too.
Scene beginning_on(Scene scene, const std::vector<FieldSide>& sides) {
  scene.world.side.reset();
  if (!sides.empty()) scene.world.side = sides.front();
  return scene;
}

/// The height h of the centre of mass above the surface of the scene's field at
/// the beginning of an element, and its derivatives by x, z and θ there.
/// h = 0 determines where that end lies, on which h itself does not depend.
nlp::TangencyCondition::Linearisation height_at_beginning(
    const RollingTime& problem, int element, std::span<const double> x) {
  using Jet = math::Jet1<double, 3>;
  const VariableLayout& layout = problem.layout();
  const int node = element * problem.mesh().degree;
  nlp::TangencyCondition::Linearisation out;
  std::array<Jet, 3> y;  // x, z and θ
  for (int i = 0; i < 3; ++i) {
    if (!layout.has_state(i)) continue;
    out.by_x.index.push_back(layout.state(node, i));
    y[at(i)] = Jet::variable(x[at(out.by_x.index.back())], i);
  }
  const Jet h = height_of_mass(problem.scene(), y[0], y[1], y[2]);
  out.residual = h.value;
  for (std::size_t i = 0; i < out.by_x.index.size(); ++i) {
    out.by_x.value.push_back(h.gradient[i]);
  }
  return out;
}

}  // namespace

FreeRates::Equations::Equations(const Scene& scene, const Elements& elements,
                                double phi)
    : problem(beginning_on(scene, elements.sides), elements.mesh, phi),
      passages(elements_beyond(elements.sides)),
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
      system(problem, nullptr, nlp::equations_only(problem)) {
  problem.hold_sides(elements.sides);
  if (start) start->set_parameter(start_angle(problem.scene()));
  if (contact) contact->set_parameter(phi);
}

std::vector<nlp::TangencyCondition*> FreeRates::Equations::slopes() {
  std::vector<nlp::TangencyCondition*> out;
  if (contact) out.push_back(&*contact);
  if (start) out.push_back(&*start);
  return out;
}

std::vector<nlp::TangencyCondition::Linearisation> FreeRates::Equations::rows(
    const PrimalDual& point) {
  std::vector<nlp::TangencyCondition::Linearisation> out;
  for (nlp::TangencyCondition* slope : slopes()) {
    out.push_back(slope->linearise(point.x, point.lambda));
  }
  for (const int element : passages) {
    out.push_back(height_at_beginning(problem, element, point.x));
  }
  return out;
}

FreeRates::FreeRates(const Scene& scene, Elements elements,
                     const PrimalDual& point, double phi)
    : elements_(std::move(elements)),
      at_(posed_for_rates(scene, elements_.mesh, point, phi), elements_, phi),
      point_(point),
      phi_(phi) {
  if (at(at_.problem.num_variables()) != point.x.size()) {
    point_ = prolong(path_of(scene, elements_.mesh, point, phi), at_.problem);
  }
  if (!at_.system.evaluate(point_.x, point_.lambda, 0.0)) return;
  time_ = at_.problem.eval_f();
  pull_ = nlp::lagrangian_gradient(at_.problem, point_.lambda);
  at_.system.evaluate_jacobian();
  chain_ = BorderedChain::make(at_.system);
  regular_ = chain_ && chain_->factorise() && linearise_around_chain();
}

std::unique_ptr<FreeRates> FreeRates::make(const ExtremalCurve& curve,
                                           const PrimalDual& point,
                                           double phi) {
  const Scene& scene = curve.scene();
  const Mesh& own = curve.mesh();
  double longest = 0.0;
  for (int e = 0; e < own.num_elements(); ++e) {
    longest = std::max(longest, curve.at_node((e + 1) * own.degree).s -
                                    curve.at_node(e * own.degree).s);
  }
  const auto turns = resolve_turns(scene.body, longest, own.num_elements());
  if (!turns) return nullptr;
  Mesh fine = own;
  for (int i = 0; i < turns->halvings; ++i) fine = halved(fine);
  fine.degree = std::max(fine.degree, turns->degree);
  Mesh mesh = with_ends_at(fine, surface_passages(scene, curve));
  const bool placed =
      mesh.degree == own.degree &&
      std::ranges::equal(mesh.boundaries, own.boundaries,
                         [](double one, double other) {
                           return std::abs(one - other) <= kAlmostPlaced;
                         });
  if (placed) mesh = own;
  Elements elements{mesh, sides_of_elements(curve, mesh)};
  if (placed) {
    return std::unique_ptr<FreeRates>(
        new FreeRates(scene, std::move(elements), point, phi));
  }
  return closed(scene, std::move(elements),
                prolong(curve, RollingTime(scene, mesh, phi)), phi);
}

std::unique_ptr<FreeRates> FreeRates::closed(Scene scene, Elements elements,
                                             PrimalDual point, double phi) {
  constexpr int kMostMoves = 12;
  constexpr double kCloser = 0.5;
  double last = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kMostMoves; ++i) {
    RollingTime problem(scene, elements.mesh, phi);
    problem.hold_sides(elements.sides);
    const MeshSolution found =
        close_start(problem, {point, phi, -1.0}, {}, stay_on_mesh);
    if (!found.solved()) return nullptr;
    scene = problem.scene();
    point = found.point;
    phi = found.tangency.phi;
    std::unique_ptr<FreeRates> out(new FreeRates(scene, elements, point, phi));
    const std::vector<int>& passages = out->at_.passages;
    if (passages.empty() || !out->regular()) return out;
    const Eigen::VectorXd miss = out->misses();
    const double apart = miss.lpNorm<Eigen::Infinity>();
    if (apart <= kPlaced || (apart <= kAlmostPlaced && apart > kCloser * last))
      return out;
    last = apart;
    std::vector<double> places;
    for (std::size_t k = 0; k < passages.size(); ++k) {
      places.push_back(elements.mesh.boundaries[at(passages[k])] +
                       miss[static_cast<Eigen::Index>(k)]);
    }
    elements.mesh = with_beginnings_at(elements.mesh, passages, places);
    // Written so that a NaN is no mesh.
    for (int e = 0; e < elements.mesh.num_elements(); ++e) {
      if (!(elements.mesh.length(e) > 0.0)) return nullptr;
    }
  }
  return nullptr;
}

FreeRates::Elements FreeRates::moved_passage(std::size_t number,
                                             double by) const {
  std::vector<double> places;
  for (const int element : at_.passages) {
    places.push_back(elements_.mesh.boundaries[at(element)]);
  }
  places[number] += by;
  return {with_beginnings_at(elements_.mesh, at_.passages, places),
          elements_.sides};
}

FreeRates::Rates FreeRates::followed(Partial by) {
  for (double& value : by.residual) value = -value;
  std::vector<double> direction(by.residual.size());
  if (!chain_->solve(by.residual, direction, kOfSolves)) {
    by.open.setConstant(std::nan(""));
    return {by.lagrangian, by.open};
  }
  for (Eigen::Index i = 0; i < by.open.size(); ++i) {
    by.open[i] += static_cast<double>(rows_[static_cast<std::size_t>(i)].times(
        direction, at_.problem.num_variables()));
  }
  return {by.lagrangian, by.open};
}

bool FreeRates::linearise_around_chain() {
  rows_ = at_.rows(point_);
  for (const nlp::TangencyCondition* slope : at_.slopes()) {
    const std::size_t i = closing_.size();
    Partial by = nothing();
    const nlp::SparseVector& rates = slope->fixed_rates();
    for (std::size_t j = 0; j < rates.index.size(); ++j) {
      by.residual[at(rates.index[j])] = -rates.value[j];
      by.lagrangian +=
          static_cast<double>(pull_[at(rates.index[j])] * rates.value[j]);
    }
    by.open[static_cast<Eigen::Index>(i)] = rows_[i].by_parameter;
    closing_.push_back(followed(std::move(by)));
  }
  for (std::size_t k = 0; k < at_.passages.size(); ++k) {
    // All is linear in it: any step will do that leaves elements their order.
    constexpr double kShare = 0.1;
    const Mesh& mesh = elements_.mesh;
    const double step = kShare * std::min(mesh.length(at_.passages[k] - 1),
                                          mesh.length(at_.passages[k]));
    closing_.push_back(followed(partial(step, [&](double place) {
      return std::pair(scene(), moved_passage(k, place));
    })));
  }
  const double determinant = math::determinant(jacobian_of(closing_));
  return std::isfinite(determinant) && determinant != 0.0;
}

Eigen::VectorXd FreeRates::misses() const {
  Eigen::VectorXd open(static_cast<Eigen::Index>(rows_.size()));
  for (Eigen::Index i = 0; i < open.size(); ++i) {
    open[i] = -rows_[static_cast<std::size_t>(i)].residual;
  }
  return math::solve_square(jacobian_of(closing_), open)
      .tail(static_cast<Eigen::Index>(at_.passages.size()));
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

FreeRates::Partial FreeRates::nothing() const {
  return {std::vector<double>(at(at_.system.size())),
          Eigen::VectorXd::Zero(static_cast<Eigen::Index>(rows_.size()))};
}

FreeRates::Partial FreeRates::partial(
    double step,
    const std::function<std::pair<Scene, Elements>(double)>& moved_to) {
  Partial out = nothing();
  double objective = 0.0;
  math::central_difference_by_place(step, [&](double place, double weight) {
    const auto [there, elements] = moved_to(place);
    const PrimalDual point = turned_to(there);
    Equations other(there, elements, phi_);
    if (!other.system.evaluate(point.x, point.lambda, 0.0)) {
      weight = std::nan("");
    }
    for (std::size_t i = 0; i < out.residual.size(); ++i) {
      out.residual[i] += weight * other.system.residual()[i];
    }
    objective += weight * other.problem.eval_f();
    out.start_angle += weight * start_angle(other.scene());
    Eigen::Index i = 0;
    for (const auto& row : other.rows(point)) {
      out.open[i++] += weight * row.residual;
    }
  });

  // 𝓛_p, the values of fixed variables moving along.
  long double lagrangian = objective;
  const int n = at_.problem.num_variables();
  for (int i = 0; i < n; ++i) {
    if (at_.system.given(i)) lagrangian -= pull_[at(i)] * out.residual[at(i)];
  }
  for (std::size_t i = 0; i < point_.lambda.size(); ++i) {
    lagrangian +=
        static_cast<long double>(point_.lambda[i]) * out.residual[at(n) + i];
  }
  out.lagrangian = static_cast<double>(lagrangian);
  return out;
}

TimeRate FreeRates::by(SceneCoordinate coordinate) {
  const Partial by =
      partial(difference_step(scene(), coordinate), [&](double place) {
        return std::pair(moved(scene(), coordinate, place), elements_);
      });
  TimeRate rate{by.lagrangian, by.lagrangian};
  if (scene().contact == Contact::Smooth && !at_.start) {
    // C_A turns about A with β₀.
    const VariableLayout& layout = at_.problem.layout();
    const double r = scene().body.radius;
    const double beta_0 = start_angle(scene());
    const auto x = pull_[at(layout.state(0, StateComponent::X))];
    const auto z = pull_[at(layout.state(0, StateComponent::Z))];
    rate.at_fixed_contacts -= static_cast<double>(
        by.start_angle * r * (x * std::cos(beta_0) + z * std::sin(beta_0)));
  }
  if (!closing_.empty()) rate.total = closed_rate(followed(by), closing_);
  return rate;
}

/// F = (∂²𝓗/∂β²) κ next to the answer.
double FreeRates::contact_response() {
  if (!at_.contact) return std::nan("");
  const double per_kink =
      at_.contact->linearise(point_.x, point_.lambda).by_parameter;
  // The slope at B is the first of what closes.
  Eigen::VectorXd right = nothing().open;
  right[0] = per_kink;
  return math::solve_square(jacobian_of(closing_), right)[0];
}

std::unique_ptr<TimeRates> FreeRates::next(SceneCoordinate coordinate,
                                           double by) {
  Scene there = moved(scene(), coordinate, by);
  there.world.side.reset();
  PrimalDual point = turned_to(there);
  return closed(std::move(there), elements_, std::move(point), phi_);
}

}  // namespace brachisto
