// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "transcription/transcription.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>
#include <new>
#include <utility>

#include "brachisto/math/phase_clock.hpp"
#include "brachisto/math/stop_condition.hpp"
#include "math/index.hpp"

namespace brachisto {

namespace {

using enum StateComponent;

}  // namespace

Transcription::Transcription(const Scene& scene, Mesh mesh,
                             VariableLayout layout, Point origin,
                             const char* place)
    : scene_(scene),
      mesh_(std::move(mesh)),
      layout_(layout),
      origin_(origin),
      lower_(at(num_variables()), -std::numeric_limits<double>::infinity()),
      upper_(at(num_variables()), std::numeric_limits<double>::infinity()),
      x_(at(num_variables())),
      place_(place) {}

void Transcription::bound(int variable, double lower, double upper) {
  lower_[at(variable)] = lower;
  upper_[at(variable)] = upper;
}

void Transcription::fix(int variable, double value) {
  lower_[at(variable)] = value;
  upper_[at(variable)] = value;
}

void Transcription::release(int variable) {
  lower_[at(variable)] = -std::numeric_limits<double>::infinity();
  upper_[at(variable)] = std::numeric_limits<double>::infinity();
}

void Transcription::change_lengths(Mesh mesh) {
  mesh_ = std::move(mesh);
  forget_point();
}

void Transcription::change_scene(const Scene& scene) {
  scene_ = scene;
  forget_point();
}

void Transcription::forget_point() {
  // No point is equal to this one.
  x_.front() = std::numeric_limits<double>::quiet_NaN();
}

void Transcription::set_end_angle(double phi) {
  const Point end = end_of_centre(scene_, phi);
  const int last = layout_.num_points();
  fix(layout_.state(last, StateComponent::X), end.x - origin_.x);
  fix(layout_.state(last, StateComponent::Z), end.z - origin_.z);
}

bool Transcription::refuse(int place, const char* reason) {
  refused_place_ = place;
  refused_because_ = reason;
  return false;
}

std::string Transcription::refusal() const {
  if (refused_place_ < 0) return refused_because_;
  return fmt::format("{} at {} {} of {}", refused_because_, place_,
                     refused_place_, layout_.num_points());
}

nlp::ChainStructure Transcription::chain_structure() const {
  nlp::ChainStructure chain;
  chain.num_links = mesh_.num_elements();
  chain.block.resize(at(num_variables() + num_constraints()));
  const auto fill = [&](int begin, int end, int block) {
    std::fill(chain.block.begin() + begin, chain.block.begin() + end, block);
  };
  const int p = mesh_.degree;
  const int n = num_variables();
  const int states = layout_.num_states();
  for (int element = 0; element < chain.num_links; ++element) {
    check_stop(element);
    const int left = 2 * element, interior = left + 1, right = left + 2;
    for (int j = 0; j < p; ++j) {
      // A point, the node with which it stands and the one to which it leads.
      const int point = element * p + j;
      const int node = layout_.state(point, X);
      const bool unknown = point >= layout_.node_of(0);
      if (unknown) fill(node, node + states, j == 0 ? left : interior);
      fill(node + states, layout_.state(point + 1, X), interior);
      fill(n + layout_.defect(point, X), n + layout_.defect(point + 1, X),
           j == p - 1 ? right : interior);
    }
  }
  fill(layout_.state(layout_.num_points(), X), layout_.last(),
       2 * chain.num_links);
  chain.block[at(layout_.last())] = nlp::ChainStructure::kBorder;
  return chain;
}

double Transcription::end_slope(std::span<const double> x,
                                std::span<const double> lambda) {
  const std::optional<End> at_end = end(x, lambda);
  if (!at_end) return std::numeric_limits<double>::quiet_NaN();
  return minimising_slope(scene_.body, scene_.gravity, at_end->state,
                          end_costates(lambda), at_end->last_slope);
}

double Transcription::rounding(std::span<const double> x) const {
  constexpr double kTerms = 64.0;
  double largest = 1.0;
  for (const double value : x) largest = std::max(largest, std::abs(value));
  return kTerms * std::numeric_limits<double>::epsilon() * largest;
}

void Transcription::build_patterns() {
  const PhaseTimer timer(Phase::SetUp);
  Entries jac_g(jac_g_pattern_);
  put_jac_g(jac_g);
  // Zeros of calloc() of which a few are read need a few pages.
  const std::size_t m = at(num_constraints());
  const std::unique_ptr<double, decltype(&std::free)> no_lambda(
      static_cast<double*>(std::calloc(m, sizeof(double))), &std::free);
  if (!no_lambda) throw std::bad_alloc();
  Entries hess_lag(hess_lag_pattern_);
  put_hess_lag(0.0, {no_lambda.get(), m}, hess_lag);
}

bool Transcription::do_set_point(std::span<const double> x) {
  x_.assign(x.begin(), x.end());
  return evaluate();
}

void Transcription::do_eval_jac_g(std::span<double> values) const {
  Entries put(values);
  put_jac_g(put);
}

void Transcription::do_eval_hess_lag(double objective_factor,
                                     std::span<const double> lambda,
                                     std::span<double> values) const {
  Entries put(values);
  put_hess_lag(objective_factor, lambda, put);
}

}  // namespace brachisto
