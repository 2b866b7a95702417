// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "transcription/transcription.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "brachisto/math/phase_clock.hpp"
#include "brachisto/math/stop_condition.hpp"
#include "math/index.hpp"

namespace brachisto {

namespace {

/// The pattern that `visit` tells, in memory for no more than it has.
template <class Visit>
nlp::SparsityPattern pattern_of(Visit&& visit) {
  Entries counted;
  visit(counted);
  nlp::SparsityPattern pattern;
  pattern.rows.reserve(counted.count());
  pattern.cols.reserve(counted.count());
  Entries recorded(pattern);
  visit(recorded);
  return pattern;
}

}  // namespace

void Entries::record(int row, int col) {
  ++count_;
  if (pattern_ == nullptr) return;
  pattern_->rows.push_back(row);
  pattern_->cols.push_back(col);
}

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
  const int p = mesh_.degree;
  // The block of a node, and of the multipliers that lead to it.
  const auto block_of_node = [p](int node) {
    return 2 * (node / p) + (node % p == 0 ? 0 : 1);
  };
  for (int i = 0; i < num_variables(); ++i) {
    check_stop(i);
    const int node = layout_.node_of(i);
    chain.block[at(i)] =
        layout_.is_state(i) ? block_of_node(node) : 2 * (node / p) + 1;
  }
  for (int i = 0; i < num_constraints(); ++i) {
    check_stop(i);
    chain.block[at(num_variables() + i)] =
        block_of_node(layout_.point_of(i) + 1);
  }
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
  jac_g_pattern_ = pattern_of([this](Entries& put) { put_jac_g(put); });
  const std::vector<double> no_lambda(at(num_constraints()));
  hess_lag_pattern_ =
      pattern_of([&](Entries& put) { put_hess_lag(0.0, no_lambda, put); });
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
