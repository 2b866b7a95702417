// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The .nl file of a stated problem, to code of others.

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <random>
#include <vector>

#include "brachisto/math/index.hpp"
#include "brachisto/ocp.hpp"
#include "program_files/asl_program.hpp"
#include "program_files/nl_file.hpp"
#include "program_files/stated_formulas.hpp"
#include "support/scratch_directory.hpp"

namespace brachisto::testing {
namespace {

/// All that a statement may have.
struct Everything : ocp::Sizes<2, 2, 1> {
  template <class S>
  [[nodiscard]] Rates<S> rates(const Point<S>& at) const {
    const auto& [x, y] = at.states;
    const auto& [u, v] = at.controls;
    return {u * u + exp(x) * v,
            {sin(y) * u + at.parameters[0], x / (y * y + 2.0) - v}};
  }
  template <class S>
  [[nodiscard]] std::array<S, 1> limits(const Point<S>& at) const {
    return {at.states[0] * at.controls[1]};
  }
  template <class S>
  [[nodiscard]] S end_cost(const Ends<S>& ends) const {
    return ends.end[0] * ends.duration - ends.parameters[0];
  }
  template <class S>
  [[nodiscard]] std::array<S, 1> end_conditions(const Ends<S>& ends) const {
    return {ends.start[0] * ends.start[0] + ends.end[1]};
  }
};

TEST(StatedNlFile, IsTheProgramToTheSolverLibrary) {
  const ocp::Problem problem(
      Everything{},
      {.name = "everything",
       .states = {{.name = "x", .lower = -9.0, .upper = 7.0},
                  {.name = "y", .start = 0.5}},
       .controls = {{.name = "u", .lower = -3.0, .upper = 3.0}, {.name = "v"}},
       .parameters = {{.name = "p", .scale = 4.0}},
       .limits = {{.name = "product", .upper = 2.0}},
       .end_conditions = {{.name = "both", .lower = 1.0, .upper = 1.0}}});
  const Mesh mesh{3, {0.0, 0.3, 1.0}};
  const auto program = problem.on(mesh);
  const auto formulas = program_files::in_formulas(problem, mesh);
  const program_files::NlNumbering order(*program, *formulas);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> anywhere(0.3, 1.3);
  PrimalDual start;
  for (int i = 0; i < program->num_variables(); ++i) {
    start.x.push_back(anywhere(random));
  }
  const ScratchDirectory folder;
  const auto path = folder.path() / "everything.nl";
  {
    std::ofstream file(path);
    program_files::TextStream out(
        [&file](std::string_view text) { file << text; });
    program_files::put_nl(*program, *formulas, order, start, out);
  }

  AslProgram read(path);
  ASSERT_TRUE(read.set_point(read.start().x));
  ASSERT_TRUE(program->set_point(start.x));

  // A sum of some hundred terms of order one.
  constexpr double kRounding = 1e-12;
  EXPECT_NEAR(read.eval_f(), program->eval_f(), kRounding);
  std::vector<double> ours(at(program->num_constraints())), theirs(ours);
  program->eval_g(ours);
  read.eval_g(theirs);
  for (std::size_t row = 0; row < ours.size(); ++row) {
    const int own = order.constraints[row];
    // The constant of a linear constraint stands in its bounds.
    const double constant =
        theirs[row] - read.constraint_range(static_cast<int>(row)).lower;
    const nlp::Range range = program->constraint_range(own);
    if (range.single()) {
      EXPECT_NEAR(constant, ours[at(own)] - range.lower, kRounding)
          << program->constraint_name(own);
    } else {
      EXPECT_NEAR(theirs[row], ours[at(own)], kRounding);
    }
  }
  for (std::size_t i = 0; i < order.variables.size(); ++i) {
    const nlp::Range range = program->variable_range(order.variables[i]);
    const nlp::Range there = read.variable_range(static_cast<int>(i));
    EXPECT_EQ(there.lower, range.lower);
    EXPECT_EQ(there.upper, range.upper);
  }
}

}  // namespace
}  // namespace brachisto::testing
