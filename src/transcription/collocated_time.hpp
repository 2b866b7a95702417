// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The least time as a nonlinear program by the collocation of a description.

#pragma once

#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "brachisto/math/index.hpp"
#include "brachisto/ocp/collocation.hpp"
#include "transcription/transcription.hpp"

namespace brachisto {

/// f, g and their stencils follow from the description of the body, whichever
/// of several it is; an instance says what is fixed, and adds rows of its own.
template <class... Descriptions>
class CollocatedTime : public Transcription {
 public:
  /// From now on element e takes the law of sides[e] for a field with a kink,
  /// wherever its points lie: so all is smooth in its ends and in the scene. A
  /// point is forgotten.
  ///
  /// \param sides  of as many elements, or none: each point by its place
  void hold_sides(std::vector<FieldSide> sides) {
    sides_ = std::move(sides);
    forget_point();
  }
  [[nodiscard]] const std::vector<FieldSide>& sides() const { return sides_; }

 protected:
  using Collocation = std::variant<ocp::Collocation<Descriptions>...>;

  /// \param collocated  the collocation on a layout
  template <class Collocated>
  CollocatedTime(const Scene& scene, const Mesh& mesh,
                 const VariableLayout& layout, const Collocated& collocated)
      : Transcription(scene, mesh, layout, {}, "collocation point"),
        collocation_(collocated(this->layout())) {}

  /// Whether a limit is asked for at a point; else it is 0.
  [[nodiscard]] virtual bool asks_for(int, int) const { return true; }
  [[nodiscard]] double rolling_time() const {
    return x(layout().rolling_time());
  }

  void do_eval_g(std::span<double> g) const override {
    visit([&](const auto& by) { by.put_constraints(x(), mesh(), g); });
  }
  void put_jac_g(Entries& put) const override {
    visit([&](const auto& by) { by.put_jac_g(mesh(), rolling_time(), put); });
  }
  void put_hess_lag(double objective_factor, std::span<const double> lambda,
                    Entries& put) const override {
    visit([&](const auto& by) {
      by.put_hess_lag(mesh(), rolling_time(), objective_factor, lambda, put);
    });
  }
  template <class Visit>
  decltype(auto) visit(Visit&& visitor) const {
    return std::visit(visitor, collocation_);
  }

  Collocation collocation_;

 private:
  bool evaluate() final {
    if (!(rolling_time() > 0.0)) {
      return refuse(-1, "the rolling time U is not positive");
    }
    return std::visit(
        [&](auto& collocation) {
          const auto& by_place = collocation.description();
          using Description = std::remove_cvref_t<decltype(by_place)>;
          std::vector<Description> by_side(sides_.empty() ? 0 : 2, by_place);
          for (std::size_t i = 0; i < by_side.size(); ++i) {
            by_side[i].keep_to_side(i == 1);
          }
          const auto refused = collocation.evaluate(
              x(), mesh(),
              [&](int e) -> const auto& {
                if (sides_.empty()) return by_place;
                return by_side[sides_[at(e)] == FieldSide::Inside ? 0 : 1];
              },
              [&](int point, int limit) { return asks_for(point, limit); });
          return !refused || refuse(refused->point, refused->because);
        },
        collocation_);
  }
  [[nodiscard]] double do_eval_f() const final {
    return visit(
        [&](const auto& by) { return by.objective(mesh(), rolling_time()); });
  }
  void do_eval_grad_f(std::span<double> grad_f) const final {
    visit([&](const auto& by) {
      by.put_gradient(mesh(), rolling_time(), grad_f);
    });
  }

  std::vector<FieldSide> sides_;  ///< held, by element, or none
};

}  // namespace brachisto
