// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What the AMPL Solver Library reads from an .nl file is the program, and Ipopt
// finds the same answer there.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>

#include "brachisto/io/problem_file.hpp"
#include "brachisto/math/index.hpp"
#include "brachisto/solvers/program_solvers.hpp"
#include "brachisto/study/solve.hpp"
#include "program_files/asl_program.hpp"
#include "program_files/foreign_answer.hpp"
#include "program_files/nl_file.hpp"
#include "program_files/program_directory.hpp"
#include "program_files/programs.hpp"
#include "support/scratch_directory.hpp"

namespace brachisto {
namespace {

namespace fs = std::filesystem;
using program_files::ProgramOutput;
using program_files::ProgramStart;
using program_files::SolvedProgram;
using program_files::word_of;
using testing::AslProgram;
using testing::program_cases;
using testing::ProgramCase;
using testing::Random;
using testing::rounding_of;
using testing::ScratchDirectory;

/// Where the file has the program's variables and constraints, by their names.
struct Places {
  Places(const Transcription& ours, const AslProgram& theirs) {
    std::map<std::string, int> cols, rows;
    for (int i = 0; i < theirs.num_variables(); ++i) {
      cols[theirs.variable_name(i)] = i;
    }
    for (int i = 0; i < theirs.num_constraints(); ++i) {
      rows[theirs.constraint_name(i)] = i;
    }
    for (int i = 0; i < ours.num_variables(); ++i) {
      variable.push_back(cols.at(word_of(ours.variable_name(i))));
    }
    for (int i = 0; i < ours.num_constraints(); ++i) {
      constraint.push_back(rows.at(word_of(ours.constraint_name(i))));
    }
  }
  [[nodiscard]] static std::vector<double> moved(
      const std::vector<double>& from, const std::vector<int>& to) {
    std::vector<double> out(from.size());
    for (std::size_t i = 0; i < from.size(); ++i) out[at(to[i])] = from[i];
    return out;
  }

  std::vector<int> variable, constraint;
};

/// Values and derivatives at a point, with variables and constraints at the
/// given places.
struct Dense {
  double f;
  Eigen::VectorXd grad_f, g;
  Eigen::MatrixXd jac_g, hess_lag;
};

Dense at_point(nlp::Problem& problem, const std::vector<double>& x,
               double factor, const std::vector<double>& lambda) {
  const int n = problem.num_variables(), m = problem.num_constraints();
  Dense out{0.0, Eigen::VectorXd(n), Eigen::VectorXd(m),
            Eigen::MatrixXd::Zero(m, n), Eigen::MatrixXd::Zero(n, n)};
  if (!problem.set_point(x)) {
    ADD_FAILURE() << problem.refusal();
    return out;
  }
  out.f = problem.eval_f();
  problem.eval_grad_f({out.grad_f.data(), at(n)});
  problem.eval_g({out.g.data(), at(m)});
  const auto add = [](const nlp::SparsityPattern& pattern,
                      const std::vector<double>& values, Eigen::MatrixXd& to) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      to(pattern[i].row, pattern[i].col) += values[i];
    }
  };
  std::vector<double> values(problem.jac_g_pattern().num_entries());
  problem.eval_jac_g(values);
  add(problem.jac_g_pattern(), values, out.jac_g);
  values.assign(problem.hess_lag_pattern().num_entries(), 0.0);
  problem.eval_hess_lag(factor, lambda, values);
  add(problem.hess_lag_pattern(), values, out.hess_lag);
  out.hess_lag = Eigen::MatrixXd(out.hess_lag.selfadjointView<Eigen::Lower>());
  return out;
}

/// The first with rows and columns where the other has them.
template <class Matrix>
Matrix placed(const Matrix& matrix, const std::vector<int>& rows,
              const std::vector<int>& cols) {
  Matrix out(matrix.rows(), matrix.cols());
  for (int i = 0; i < matrix.rows(); ++i) {
    for (int j = 0; j < matrix.cols(); ++j) {
      out(rows[at(i)], matrix.cols() == 1 ? 0 : cols[at(j)]) = matrix(i, j);
    }
  }
  return out;
}

template <class Matrix>
void expect_equal(const char* what, const Matrix& got, const Matrix& expected,
                  double tolerance) {
  Eigen::Index row = 0, col = 0;
  const double worst = (got - expected).cwiseAbs().maxCoeff(&row, &col);
  EXPECT_LE(worst, tolerance)
      << what << " entry (" << row << ", " << col << "): " << got(row, col)
      << " instead of " << expected(row, col);
}

double largest(const Eigen::MatrixXd& matrix) {
  return matrix.cwiseAbs().maxCoeff();
}

/// Writes a problem with a start.
fs::path written(const ScratchDirectory& directory,
                 const Transcription& problem, const PrimalDual& start) {
  const auto formulas = program_files::in_formulas(problem);
  const program_files::NlNumbering order(problem, *formulas);
  const auto put = [&](const char* name, const auto& tell) {
    std::ofstream file(directory.path() / name, std::ios::binary);
    program_files::TextStream out(
        [&file](std::string_view piece) { file << piece; });
    tell(out);
  };
  put("case.nl", [&](program_files::TextStream& out) {
    put_nl(problem, *formulas, order, start, out);
  });
  put("case.row", [&](program_files::TextStream& out) {
    put_row_names(problem, order, out);
  });
  put("case.col", [&](program_files::TextStream& out) {
    put_col_names(problem, order, out);
  });
  return directory.path() / "case.nl";
}

class NlFile : public ::testing::TestWithParam<ProgramCase> {};

TEST_P(NlFile, IsTheProgramToTheSolverLibrary) {
  constexpr std::uint32_t kSeed = 7;
  constexpr int kPoints = 3;
  Random random(kSeed);
  const auto problem = GetParam().make();
  const int m = problem->num_constraints();
  const PrimalDual start{GetParam().point(*problem, random),
                         random.vector(m, -1.0, 1.0)};
  const ScratchDirectory directory;
  AslProgram theirs(written(directory, *problem, start));
  ASSERT_EQ(theirs.num_variables(), problem->num_variables());
  ASSERT_EQ(theirs.num_constraints(), m);
  const Places places(*problem, theirs);

  EXPECT_EQ(theirs.start().x, Places::moved(start.x, places.variable));
  EXPECT_EQ(theirs.start().lambda,
            Places::moved(start.lambda, places.constraint));
  for (int i = 0; i < problem->num_variables(); ++i) {
    const nlp::Range range = theirs.variable_range(places.variable[at(i)]);
    EXPECT_EQ(range.lower, problem->variable_range(i).lower);
    EXPECT_EQ(range.upper, problem->variable_range(i).upper);
  }
  // A linear constraint leaves its constant to its bounds.
  std::vector<double> moved(at(m));
  for (int i = 0; i < m; ++i) {
    const nlp::Range range = theirs.constraint_range(places.constraint[at(i)]);
    const nlp::Range ours = problem->constraint_range(i);
    const program_files::Formula formula =
        program_files::in_formulas(*problem)->constraint(i);
    if (formula.tree().empty()) moved[at(i)] = formula.constant();
    EXPECT_EQ(range.lower, ours.lower - moved[at(i)]);
    EXPECT_EQ(range.upper, ours.upper - moved[at(i)]);
  }

  for (int k = 0; k < kPoints; ++k) {
    SCOPED_TRACE(::testing::Message() << "seed " << kSeed << " point " << k);
    const std::vector<double> x = GetParam().point(*problem, random);
    const std::vector<double> lambda = random.vector(m, -1.0, 1.0);
    const double factor = random.uniform(0.5, 1.5);
    const int p = problem->mesh().degree;

    const Dense ours = at_point(*problem, x, factor, lambda);
    const Dense got =
        at_point(theirs, Places::moved(x, places.variable), factor,
                 Places::moved(lambda, places.constraint));

    const auto& rows = places.constraint;
    const auto& cols = places.variable;
    EXPECT_NEAR(got.f, ours.f, rounding_of(p, std::abs(ours.f)));
    expect_equal("∇f", got.grad_f,
                 placed<Eigen::VectorXd>(ours.grad_f, cols, cols),
                 rounding_of(p, largest(ours.grad_f)));
    // Defects cancel: their size is that of their terms, the states times the
    // entries of D.
    constexpr double kLargestState = 8.0;
    Eigen::VectorXd g = ours.g;
    for (int i = 0; i < m; ++i) g(i) -= moved[at(i)];
    expect_equal("g", got.g, placed<Eigen::VectorXd>(g, rows, cols),
                 rounding_of(p, kLargestState * largest(ours.jac_g)));
    expect_equal("∂g/∂x", got.jac_g,
                 placed<Eigen::MatrixXd>(ours.jac_g, rows, cols),
                 rounding_of(p, largest(ours.jac_g)));
    expect_equal("∇²(f + λᵀg)", got.hess_lag,
                 placed<Eigen::MatrixXd>(ours.hess_lag, cols, cols),
                 rounding_of(p, largest(ours.hess_lag)));
  }
}

INSTANTIATE_TEST_SUITE_P(ProgramFiles, NlFile,
                         ::testing::ValuesIn(program_cases()),
                         [](const auto& row) { return row.param.name; });

/// Of Ipopt's KKT residual, scaled; T is stationary, so that it errs less.
constexpr double kTolerance = 1e-11;
/// What each bound of some hundred inequalities leaves in T.
constexpr double kComplementarity = 1e-13;
/// Wanted of T and of the unknowns, which are of order one.
constexpr double kSame = 1e-9;

/// What Ipopt finds in the file that a scene's program is written to, from the
/// start that is in it.
struct Found {
  SolverResult result;
  double f = 0.0;
  double distance = 0.0;  ///< of x from the answer, the largest
};

Found found_in_file(const SolvedProgram& program, ProgramStart start) {
  const ScratchDirectory directory;
  const ProgramOutput output{.path = directory.path() / "case.nl",
                             .start = start};
  write_program(program, output);
  AslProgram theirs(output.path);
  const Places places(*program.problem, theirs);
  IpoptOptions options;
  options.tolerance = kTolerance;
  options.complementarity = kComplementarity;
  Found out;
  out.result = solve_with_ipopt(theirs, theirs.start(), options);
  if (out.result.point.x.empty() || !theirs.set_point(out.result.point.x)) {
    return out;
  }
  out.f = theirs.eval_f();
  const std::vector<double> answer =
      Places::moved(program.answer.x, places.variable);
  for (std::size_t i = 0; i < answer.size(); ++i) {
    out.distance =
        std::max(out.distance, std::abs(out.result.point.x[i] - answer[i]));
  }
  return out;
}

SolvedProgram program_of(const Scene& scene, const SolveOptions& options) {
  const Solution solution = solve(scene, options);
  EXPECT_TRUE(solution.verified()) << solution.message;
  auto program = program_files::solved_program(solution);
  if (!program) throw std::runtime_error("no program");
  return std::move(*program);
}

TEST(NlOptimum, IsOurAnswerFromTheGuessAndFromTheAnswer) {
  const SolvedProgram program =
      program_of(testing::off_centred_scene(-testing::kPi / 6.0), {});
  ASSERT_TRUE(program.problem->set_point(program.answer.x));
  const double T = program.problem->eval_f();

  for (const ProgramStart start : {ProgramStart::Guess, ProgramStart::Answer}) {
    const Found found = found_in_file(program, start);

    EXPECT_EQ(found.result.status, Status::Solved) << found.result.message;
    EXPECT_NEAR(found.f, T, kSame * T);
    EXPECT_LE(found.distance, kSame);
    if (start == ProgramStart::Answer) {
      constexpr int kAFew = 2;
      EXPECT_LE(found.result.iterations, kAFew);
    }
  }
}

/// What is said of an answer that somebody wrote with AMPL's own function.
class ForeignAnswer : public ::testing::Test {
 protected:
  void solve_case(const Scene& scene, const SolveOptions& options) {
    solution_ = solve(scene, options);
    ASSERT_TRUE(solution_.verified()) << solution_.message;
    program_.emplace(*program_files::solved_program(solution_));
    write_program(*program_, {.path = file("case.nl"), .force = true});
  }
  /// What Ipopt finds in the file, to a tolerance.
  void answer_to(double tolerance) {
    AslProgram theirs(file("case.nl"));
    IpoptOptions options;
    options.tolerance = tolerance;
    options.complementarity = 1e-2 * tolerance;
    const SolverResult found =
        solve_with_ipopt(theirs, theirs.start(), options);
    ASSERT_EQ(found.status, Status::Solved) << found.message;
    theirs.write_solution(" \na solver\nof others ", found.point);
  }
  [[nodiscard]] program_files::CheckedAnswer check() const {
    return check_answer(solution_, *program_,
                        program_files::read_sol(file("case.sol")), "case.sol");
  }
  /// The first mistake that is found.
  [[nodiscard]] std::string refusal() const {
    try {
      static_cast<void>(check());
    } catch (const io::InputError& error) {
      return to_string(error.diagnostics().front());
    }
    return "none";
  }
  [[nodiscard]] fs::path file(const char* name) const {
    return directory_.path() / name;
  }
  /// Replaces the line that follows `before` by `line`.
  void change_line_after(const std::string& before, const std::string& line) {
    std::vector<std::string> lines;
    {
      std::ifstream in(file("case.sol"));
      for (std::string one; std::getline(in, one);) lines.push_back(one);
    }
    const auto found = std::ranges::find(lines, before);
    ASSERT_LT(std::distance(lines.begin(), found) + 1, std::ssize(lines));
    *(found + 1) = line;
    std::ofstream out(file("case.sol"));
    for (const std::string& one : lines) out << one << '\n';
  }

  ScratchDirectory directory_;
  Solution solution_;
  std::optional<SolvedProgram> program_;
};

TEST_F(ForeignAnswer, IsVerifiedIfItIsAsExactAsOurs) {
  solve_case(testing::off_centred_scene(-testing::kPi / 6.0), {});
  answer_to(kTolerance);

  const program_files::CheckedAnswer checked = check();

  EXPECT_TRUE(checked.certificate.verified())
      << not_verified_because(checked.certificate).front();
  EXPECT_EQ(checked.solver, "a solver; of others");
  EXPECT_EQ(checked.code, 0);
  EXPECT_LE(std::abs(checked.difference), kSame);
  EXPECT_LE(checked.farthest, kSame);
  EXPECT_NEAR(checked.transit_time, solution_.motion()->transit_time(),
              kSame * checked.transit_time);
}

/// As the file has it the junctions of arcs are not known: what keeps the
/// limits at all points need not keep them between.
TEST_F(ForeignAnswer, IsHeldToTheLimitsBetweenNodes) {
  Scene scene = testing::off_centred_scene(0.0);
  scene.limits = testing::friction(0.5);
  solve_case(scene, {});
  answer_to(kTolerance);
  const program_files::CheckedAnswer inside = check();
  AslProgram theirs(file("case.nl"));
  const Places places(*program_->problem, theirs);
  theirs.write_solution(
      "ours", {Places::moved(program_->answer.x, places.variable),
               Places::moved(program_->answer.lambda, places.constraint)});

  const program_files::CheckedAnswer ours = check();

  EXPECT_TRUE(ours.certificate.verified())
      << not_verified_because(ours.certificate).front();
  EXPECT_EQ(ours.difference, 0.0);
  EXPECT_FALSE(inside.certificate.verified());
  EXPECT_FALSE(inside.certificate.find("limits")->passed);
  EXPECT_TRUE(inside.certificate.find("defects")->passed);
}

TEST_F(ForeignAnswer, IsNotVerifiedIfItIsBentOrCoarse) {
  solve_case(testing::off_centred_scene(-testing::kPi / 6.0), {});
  answer_to(1e-3);
  const program_files::CheckedAnswer coarse = check();
  AslProgram theirs(file("case.nl"));
  PrimalDual bent{Places::moved(program_->answer.x,
                                Places(*program_->problem, theirs).variable),
                  std::vector<double>(at(theirs.num_constraints()))};
  const int moved = Places(*program_->problem, theirs).variable[40];
  bent.x[at(moved)] += 1e-4;
  theirs.write_solution("bent", bent);

  const program_files::CheckedAnswer checked = check();

  EXPECT_FALSE(coarse.certificate.verified());
  EXPECT_FALSE(checked.certificate.verified());
  EXPECT_FALSE(checked.certificate.find("defects")->passed);
  EXPECT_FALSE(checked.certificate.find("kkt_residual")->passed);
  EXPECT_NEAR(checked.farthest, 1e-4, 1e-12);
  EXPECT_EQ(word_of(checked.farthest_variable), theirs.variable_name(moved));
}

TEST_F(ForeignAnswer, IsNamedForWhatItIsIfItIsNone) {
  solve_case(testing::off_centred_scene(-testing::kPi / 6.0), {});
  answer_to(kTolerance);
  const SolvedProgram same_size = std::move(*program_);
  const Solution solution = solution_;

  // Of another mesh, and of another end.
  SolveOptions coarse;
  coarse.use<Collocation>().discretisation.elements = 3;
  solve_case(testing::off_centred_scene(-testing::kPi / 6.0), coarse);
  EXPECT_THAT(refusal(),
              ::testing::HasSubstr("an answer to another program: "));
  solution_ = solution;
  Scene longer = testing::off_centred_scene(-testing::kPi / 6.0);
  longer.L *= 1.01;
  SolveOptions as_many;
  Discretisation& mesh = as_many.use<Collocation>().discretisation;
  mesh.degree = same_size.problem->mesh().degree;
  mesh.elements = same_size.problem->mesh().num_elements();
  solve_case(longer, as_many);
  EXPECT_THAT(refusal(), ::testing::HasSubstr("and the program fixes it at"));

  change_line_after("Options", "three");
  EXPECT_THAT(
      refusal(),
      ::testing::HasSubstr(
          ":6:1: expected the number of options, a number; read \"three\""));
  std::ofstream(file("case.sol")) << "no solution\n";
  EXPECT_THAT(refusal(), ::testing::HasSubstr("no .sol file in text"));
  std::ofstream(file("case.sol")) << "\nOptions\n3\n1\n1\n0\n5\n";
  EXPECT_THAT(refusal(), ::testing::HasSubstr(
                             "the file ends before the number of multipliers"));
  fs::remove(file("case.sol"));
  EXPECT_THROW(static_cast<void>(check()), io::IoError);
}

/// Through the surface, outside, and inside.
TEST(NlOptimum, IsOurAnswerInTheFieldOfASphere) {
  for (const char* name :
       {"into_the_planet", "small_planet", "gravity_train"}) {
    SCOPED_TRACE(name);
    const io::ProblemFile file = io::read_problem_file(
        std::string(BRACHISTO_PROBLEMS_DIR "/worlds/") + name + ".yaml", {});
    const SolvedProgram program = program_of(file.scene, file.options);
    const auto& smooth = dynamic_cast<const RollingTime&>(*program.problem);
    EXPECT_EQ(smooth.sides().size(), at(smooth.mesh().num_elements()));
    ASSERT_TRUE(program.problem->set_point(program.answer.x));
    const double T = program.problem->eval_f();

    const Found found = found_in_file(program, ProgramStart::Guess);

    EXPECT_EQ(found.result.status, Status::Solved) << found.result.message;
    EXPECT_NEAR(found.f, T, kSame * T);
    EXPECT_LE(found.distance, kSame);
  }
}

TEST(NlOptimum, IsOurAnswerUnderLimits) {
  Scene scene = testing::off_centred_scene(0.0);
  scene.limits = testing::friction(0.5);
  const SolvedProgram program = program_of(scene, {});
  ASSERT_TRUE(program.problem->set_point(program.answer.x));
  const double T = program.problem->eval_f();

  const Found found = found_in_file(program, ProgramStart::Guess);

  EXPECT_EQ(found.result.status, Status::Solved) << found.result.message;
  EXPECT_NEAR(found.f, T, kSame * T);
}

TEST(NlOptimum, IsOurAnswerWithLosses) {
  Scene scene = testing::off_centred_scene(0.0);
  scene.world.losses.rolling = 0.05;
  scene.limits = testing::friction(0.6);
  const SolvedProgram program = program_of(scene, {});
  ASSERT_TRUE(program.problem->set_point(program.answer.x));
  const double T = program.problem->eval_f();

  const Found found = found_in_file(program, ProgramStart::Guess);

  EXPECT_EQ(found.result.status, Status::Solved) << found.result.message;
  EXPECT_NEAR(found.f, T, kSame * T);
}

TEST(NlOptimum, IsOurAnswerInThePapersVariables) {
  SolveOptions options;
  auto& mesh = options.use<Collocation>().discretisation;
  mesh.formulation = Formulation::ArcLength;
  mesh.elements = 60;
  mesh.tolerance = 1e-2;
  const Solution solution = solve(testing::off_centred_scene(0.0), options);
  const auto program = program_files::solved_program(solution);
  ASSERT_TRUE(program) << solution.message;
  ASSERT_TRUE(program->problem->set_point(program->answer.x));
  const double T = program->problem->eval_f();

  const Found found = found_in_file(*program, ProgramStart::Guess);

  EXPECT_EQ(found.result.status, Status::Solved) << found.result.message;
  EXPECT_NEAR(found.f, T, kSame * T);
}

}  // namespace
}  // namespace brachisto
