// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// discretisation_keys() and solver_keys(): how a scene is solved.

#include <cstdint>
#include <limits>

#include "io/key_sections.hpp"

namespace brachisto::io {

namespace {

constexpr double kMaxInt = std::numeric_limits<int>::max();

}  // namespace

std::vector<KeySpec> discretisation_keys() {
  return {
      {.path = "discretisation",
       .type = KeyType::Map,
       .description = "wanted accuracy, or a fixed mesh"},
      {.path = "discretisation.formulation",
       .type = KeyType::Choice,
       .fallback = "rolling_time",
       .description = "how the problem is made finite. rolling_time: "
                      "collocation; arc_length: the paper's variables, on "
                      "straight pieces, of order 2",
       .choices = {{"rolling_time",
                    [](ProblemFile& p) {
                      p.options.discretisation.formulation =
                          Formulation::RollingTime;
                    }},
                   {"arc_length",
                    [](ProblemFile& p) {
                      p.options.discretisation.formulation =
                          Formulation::ArcLength;
                    }}}},
      {.path = "discretisation.tolerance",
       .type = KeyType::Number,
       .fallback = "1e-10",
       .bounds = "from 1e-13 to 1e-1",
       .description = "wanted relative error of the transit time; the mesh "
                      "follows unless it is fixed. arc_length: 1e-9 or more, "
                      "1e-6 if absent",
       .interval = {kSmallestTolerance, kLargestTolerance},
       .set = [](ProblemFile& p,
                 double v) { p.options.discretisation.tolerance = v; }},
      {.path = "discretisation.degree",
       .type = KeyType::Integer,
       .fallback = "follows the tolerance, 5 on a fixed mesh",
       .bounds = "from 1 to 8",
       .description = "p, polynomial degree of an element; not for arc_length",
       .interval = {kMinDegree, kMaxDegree},
       .set =
           [](ProblemFile& p, double v) {
             p.options.discretisation.degree = static_cast<int>(v);
           }},
      {.path = "discretisation.elements",
       .type = KeyType::Integer,
       .bounds = "from 1 to 10 million",
       .description = "N, number of elements, of straight pieces for "
                      "arc_length; fixes the mesh",
       .interval = {1, kMaxElements},
       .set =
           [](ProblemFile& p, double v) {
             p.options.discretisation.elements = static_cast<int>(v);
           }},
      {.path = "discretisation.nodes",
       .type = KeyType::Integer,
       .bounds = "from 2 to 80000001, and N p + 1",
       .description = "number of nodes, N p + 1, or N + 1 for arc_length; "
                      "fixes the mesh in place of elements. With method: "
                      "fsolve any n ≥ 3, 100 if absent",
       .interval = {2, kMaxNodes},
       .set =
           [](ProblemFile& p, double v) {
             p.options.discretisation.nodes = static_cast<int>(v);
           }},
  };
}

std::vector<KeySpec> solver_keys() {
  return {
      {.path = "solver",
       .type = KeyType::Map,
       .description = "how the finite problem is solved"},
      {.path = "solver.method",
       .type = KeyType::Choice,
       .fallback = "ipopt",
       .description =
           "ipopt: collocation and a nonlinear program; newton_kkt: "
           "the same by Newton's method on its optimality conditions, "
           "from the continuation; extremal: "
           "Pontryagin's conditions by multiple shooting; fsolve: "
           "the paper's discrete system, for comparison, never "
           "verified",
       .choices =
           {{"ipopt", [](ProblemFile& p) { p.options.method = Method::Ipopt; }},
            {"newton_kkt",
             [](ProblemFile& p) { p.options.method = Method::NewtonKkt; }},
            {"extremal",
             [](ProblemFile& p) { p.options.method = Method::Extremal; }},
            {"fsolve",
             [](ProblemFile& p) { p.options.method = Method::Fsolve; }}}},
      {.path = "solver.linear_solver",
       .type = KeyType::Choice,
       .fallback = "auto",
       .description =
           "what factorises the KKT matrix. chain: along the chain "
           "of elements; mumps: a general sparse solver; auto: chain "
           "where it is possible, mumps otherwise",
       .choices = {{"auto",
                    [](ProblemFile& p) {
                      p.options.linear_solver = LinearSolver::Auto;
                    }},
                   {"mumps",
                    [](ProblemFile& p) {
                      p.options.linear_solver = LinearSolver::Mumps;
                    }},
                   {"chain",
                    [](ProblemFile& p) {
                      p.options.linear_solver = LinearSolver::Chain;
                    }}}},
      {.path = "solver.tolerance",
       .type = KeyType::Number,
       .fallback = "1e-12",
       .bounds = "from 1e-14 to 1e-6",
       .description = "largest scaled KKT residual of a solution",
       .interval = {kSmallestResidual, kLargestResidual},
       .set = [](ProblemFile& p, double v) { p.options.tolerance = v; }},
      {.path = "solver.search",
       .type = KeyType::Choice,
       .fallback = "principal",
       .description = "which extremal is the answer. principal: the one that "
                      "continues from the cycloid as η_m grows from 0; "
                      "global: of the smooth contacts that a search finds the "
                      "fastest verified and feasible one",
       .choices =
           {{"principal",
             [](ProblemFile& p) { p.options.search = Search::Principal; }},
            {"global",
             [](ProblemFile& p) { p.options.search = Search::Global; }}}},
      {.path = "solver.polish",
       .type = KeyType::Choice,
       .fallback = "true",
       .description = "last digits by Newton's method on the optimality "
                      "conditions and the contact together",
       .choices = {{"true", [](ProblemFile& p) { p.options.polish = true; }},
                   {"false",
                    [](ProblemFile& p) { p.options.polish = false; }}}},
      {.path = "solver.certify",
       .type = KeyType::Choice,
       .fallback = "none",
       .description = "extremal: solve once more by multiple shooting and "
                      "compare",
       .choices =
           {{"none", [](ProblemFile& p) { p.options.certify = Certify::None; }},
            {"extremal",
             [](ProblemFile& p) { p.options.certify = Certify::Extremal; }}}},
      {.path = "solver.guess",
       .type = KeyType::Choice,
       .fallback = "cycloid",
       .description = "where a cold start begins; straight and random are "
                      "tried in addition and reported, the answer does not "
                      "depend on them",
       .choices = {{"cycloid",
                    [](ProblemFile& p) { p.options.guess = Guess::Cycloid; }},
                   {"straight",
                    [](ProblemFile& p) { p.options.guess = Guess::Straight; }},
                   {"random",
                    [](ProblemFile& p) { p.options.guess = Guess::Random; }}}},
      {.path = "solver.seed",
       .type = KeyType::Integer,
       .fallback = "1",
       .bounds = "≥ 0",
       .description = "of the random guess",
       .interval = {0, kMaxInt},
       .set = [](ProblemFile& p,
                 double v) { p.options.seed = static_cast<std::uint64_t>(v); }},
      {.path = "solver.limits",
       .type = KeyType::Map,
       .description = "bounds on the work"},
      {.path = "solver.limits.iterations",
       .type = KeyType::Integer,
       .fallback = "500",
       .bounds = "≥ 1",
       .description = "of the solver, in all passes together",
       .interval = {1, kMaxInt},
       .set =
           [](ProblemFile& p, double v) {
             p.options.limits.iterations = static_cast<int>(v);
           }},
      {.path = "solver.limits.seconds",
       .type = KeyType::Number,
       .unit = "s",
       .fallback = "3600",
       .bounds = "> 0",
       .description = "wall-clock time",
       .interval = {.lower = 0.0, .lower_allowed = false},
       .set = [](ProblemFile& p, double v) { p.options.limits.seconds = v; }},
  };
}

}  // namespace brachisto::io
