// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The program of straight pieces in the paper's variables, whose time between
// two nodes is no rate at a point: it has the formulas of a piece.

#include "model/energy.hpp"
#include "program_files/program_in_formulas.hpp"
#include "transcription/arc_length.hpp"
#include "transcription/program_formulas.hpp"

namespace brachisto::program_files {

namespace {

using enum StateComponent;

/// Quantities are those of one piece after the other, and the objective's parts
/// the times of the pieces.
class PieceFormulas final : public ProgramInFormulas {
 public:
  explicit PieceFormulas(const ArcLength& problem) : problem_(problem) {}

  [[nodiscard]] int num_quantities() const override {
    return kParts * problem_.num_intervals();
  }
  [[nodiscard]] Formula quantity(int index) const override {
    const Scene& scene = problem_.scene();
    const int node = index / kParts + 1;
    const auto growth = [&](StateComponent component) {
      return state(node, component) - state(node - 1, component);
    };
    switch (static_cast<Part>(index % kParts)) {
      case kDx:
        return growth(X);
      case kDz:
        return growth(Z);
      case kLength:
        return problem_.layout().has_theta() ? scene.body.radius * growth(Theta)
                                             : S() * problem_.share(node);
      case kMiddle:
        return scene.body.theta_m + (state(node - 1, Theta) +
                                     ArcLength::middle(node) * growth(Theta));
      case kSpeed:
        return fall_speed(scene.gravity,
                          energy_height_after(scene.body, state(node, Z),
                                              state(node, Theta)));
    }
    return {};
  }
  [[nodiscard]] int num_objective_parts() const override {
    return problem_.num_intervals();
  }
  [[nodiscard]] Formula objective_part(int index) const override {
    const int node = index + 1;
    const Formula middle = of(node, kMiddle);
    const Formula before = index == 0 ? 0.0 : of(index, kSpeed);
    return sqrt(piece_square(problem_.scene().body, of(node, kDx),
                             of(node, kDz), of(node, kLength), sin(middle),
                             cos(middle))) *
           inverse_mean_speed(before, of(node, kSpeed));
  }
  [[nodiscard]] Formula constraint(int index) const override {
    const int node = problem_.layout().point_of(index) + 1;
    if (index == problem_.layout().no_slip(node)) {
      return slip(of(node, kDx), of(node, kDz), of(node, kLength),
                  problem_.reference_length(node));
    }
    return misplacement(problem_.scene().body.radius, state(node, Theta), S(),
                        problem_.sigma(node));
  }

 private:
  /// Δx, Δz, r Δθ, the rotation in the middle, and w at the node it leads to.
  enum Part { kDx, kDz, kLength, kMiddle, kSpeed };
  static constexpr int kParts = 5;
  /// Of the piece that leads to `node`, as a quantity.
  [[nodiscard]] static Formula of(int node, Part part) {
    return Formula::quantity(kParts * (node - 1) + part);
  }
  /// Since the start, which is no unknown; θ of a body without one is 0.
  [[nodiscard]] Formula state(int node, StateComponent component) const {
    const VariableLayout& layout = problem_.layout();
    if (node == 0 || (component == Theta && !layout.has_theta())) return 0.0;
    return Formula::unknown(layout.state(node, component));
  }
  [[nodiscard]] Formula S() const {
    return Formula::unknown(problem_.layout().arc_length());
  }

  const ArcLength& problem_;
};

}  // namespace

std::unique_ptr<ProgramInFormulas> in_formulas(const ArcLength& problem) {
  return std::make_unique<PieceFormulas>(problem);
}

}  // namespace brachisto::program_files
