// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// docs/problem-files.md says what the program does.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "brachisto/report/result.hpp"
#include "brachisto/study/solve.hpp"
#include "io/expression.hpp"
#include "io/key_spec.hpp"
#include "io/reading.hpp"
#include "io/sweep_reading.hpp"
#include "study/answer_kinds.hpp"

namespace brachisto::io {
namespace {

std::string documentation(const std::string& page = "problem-files.md") {
  std::ifstream file(BRACHISTO_SOURCE_DIR "/docs/" + page);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// What stands between two marks behind `from`; "" if they are not there.
std::string between(const std::string& text, const std::string& begin,
                    const std::string& end, std::size_t from = 0) {
  const std::size_t first = text.find(begin, from);
  if (first == std::string::npos) return "";
  const std::size_t start = first + begin.size();
  return text.substr(start, text.find(end, start) - start);
}

TEST(Documentation, QuotesTheTableOfKeys) {
  EXPECT_EQ(between(documentation(), "<!-- begin key reference -->\n",
                    "<!-- end key reference -->"),
            key_reference_markdown());
}

TEST(Documentation, QuotesTheTableOfResults) {
  EXPECT_EQ(
      between(documentation("results.md"), "<!-- begin key reference -->\n",
              "<!-- end key reference -->"),
      report::result_reference_markdown());
}

TEST(Documentation, ExampleIsRead) {
  const std::string example = between(documentation(), "```yaml\n", "```");

  ASSERT_FALSE(example.empty());
  EXPECT_EQ(errors(example), "");
}

TEST(Documentation, ExampleHasEveryKey) {
  const std::string example = between(documentation(), "```yaml\n", "```");
  const std::string paths = between(documentation(), "## Given paths", "\n## ");
  const std::string limits = between(documentation(), "## Limits", "\n## ");
  const std::string worlds =
      between(documentation(), "## Other worlds", "\n## ");

  for (const KeySpec& spec : key_table()) {
    if (spec.type() == KeyType::Reserved) continue;
    if (spec.type() == KeyType::Sweep) continue;  // makes it another file
    // A given path makes it another problem, and so do limits and other worlds,
    // each of which has an example of its own.
    const std::string& place = spec.path.starts_with("scene.path") ? paths
                               : spec.path.starts_with("scene.limits") ||
                                       spec.path.starts_with("scene.contact.")
                                   ? limits
                               : spec.path.starts_with("scene.field") ||
                                       spec.path.starts_with("scene.start") ||
                                       spec.path.starts_with("scene.air") ||
                                       spec.path.starts_with("scene.losses")
                                   ? worlds
                                   : example;
    EXPECT_NE(place.find(std::string(spec.name()) + ":"), std::string::npos)
        << spec.path;
  }
}

TEST(Documentation, LimitsAreRead) {
  const std::string example = between(
      between(documentation(), "## Limits", "\n## "), "```yaml\n", "```");

  ASSERT_FALSE(example.empty());
  EXPECT_EQ(errors(example), "");
}

TEST(Documentation, LossesAreRead) {
  const std::string example = between(
      between(documentation(), "### Losses", "\n## "), "```yaml\n", "```");

  ASSERT_FALSE(example.empty());
  EXPECT_EQ(errors(example), "");
}

TEST(Documentation, OtherWorldsAreRead) {
  const std::string example = between(
      between(documentation(), "## Other worlds", "\n## "), "```yaml\n", "```");

  ASSERT_FALSE(example.empty());
  EXPECT_EQ(errors(example), "");
}

TEST(Documentation, SweepsAreRead) {
  const std::string text = documentation();
  const std::string sweeps = between(text, "## Sweeps\n", "\n## ");
  std::vector<std::size_t> scenes;

  for (std::size_t at = sweeps.find("```yaml\n"); at != std::string::npos;
       at = sweeps.find("```yaml\n", at + 1)) {
    std::string example = between(sweeps, "```yaml\n", "```", at);
    if (!example.starts_with("scene:")) example = kCylinder + example;
    EXPECT_EQ(sweep_text_errors(example), "") << example;
    scenes.push_back(read_sweep_text(example, "example").num_scenes());
  }

  EXPECT_EQ(scenes, (std::vector<std::size_t>{41 * 61, 10, 2 * 3, 100}));
}

TEST(Documentation, ComparisonsAreRead) {
  const std::string section =
      between(documentation(), "## Work and precision\n", "\n## ");
  const std::string example = between(section, "```yaml\n", "```");

  ASSERT_FALSE(example.empty());
  const ProblemFile stated = read(kCylinder + example);
  const ProblemFile silent = read(kCylinder);
  EXPECT_EQ(stated.work_precision.methods, silent.work_precision.methods);
  EXPECT_EQ(stated.work_precision.meshes, silent.work_precision.meshes);
}

TEST(Documentation, ScenesOfComparisonsAreReady) {
  int count = 0;
  for (const auto& file : std::filesystem::directory_iterator(
           BRACHISTO_SOURCE_DIR "/problems/work_precision")) {
    const ProblemFile problem = read_problem_file(file.path());
    // Six degrees; under limits those and the adaptive line, else six others.
    EXPECT_EQ(problem.work_precision.methods.size(),
              problem.scene.limits.any() ? 7U : 12U)
        << file.path();
    EXPECT_GE(problem.work_precision.meshes.size(), 5U) << file.path();
    ++count;
  }
  EXPECT_EQ(count, 7);
}

TEST(Documentation, ErrorsAreThoseOfTheProgram) {
  const std::string text = documentation();
  const std::size_t section = text.find("## Errors");
  ASSERT_NE(section, std::string::npos);
  const std::string bad = between(text, "```yaml\n", "```", section);
  const std::string shown = between(text, "```text\n", "```", section);

  try {
    static_cast<void>(read_problem_text(bad, "bad.yaml"));
    FAIL() << "must not be read";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()) + "\n", shown);
  }
}

TEST(Documentation, NamesTheParts) {
  EXPECT_NE(documentation().find(expression_grammar()), std::string::npos)
      << expression_grammar();
}

/// All numbers and words of a problem, defaults that stand elsewhere included.
std::string effective(const ProblemFile& p) {
  std::ostringstream text;
  const Body& body = p.scene.body;
  const auto program = p.options.or_default<Collocation>();
  const Discretisation& mesh = program.discretisation;
  text.precision(17);
  text << static_cast<int>(body.shape) << ' ' << body.radius << ' '
       << body.eta_m << ' ' << body.theta_m << ' ' << body.k << ' '
       << body.mass.value_or(0.0) << ' ' << p.scene.L << ' ' << p.scene.H << ' '
       << p.scene.gravity << ' ' << static_cast<int>(p.scene.contact) << ' '
       << static_cast<int>(mesh.formulation) << ' '
       << mesh.tolerance.value_or(kDefaultTolerance) << ' '
       << mesh.degree.value_or(kDefaultDegree) << ' '
       << mesh.elements.value_or(0) << ' ' << mesh.nodes.value_or(0) << ' '
       << p.options.method.index() << ' ' << static_cast<int>(program.solver)
       << ' ' << static_cast<int>(program.linear_solver) << ' '
       << program.threads << ' ' << program.tolerance << ' '
       << static_cast<int>(program.search) << ' ' << program.polish << ' '
       << static_cast<int>(program.certify) << ' '
       << static_cast<int>(program.sensitivities) << ' '
       << static_cast<int>(program.guess) << ' ' << program.seed << ' '
       << p.options.limits.iterations << ' ' << p.options.limits.seconds;
  const auto system = p.options.or_default<DiscreteSystem>();
  text << ' ' << system.nodes << ' ' << static_cast<int>(system.solver) << ' '
       << static_cast<int>(system.reading.quadrature) << ' '
       << static_cast<int>(system.reading.datum) << ' '
       << static_cast<int>(system.reading.slopes) << ' '
       << system.reading.epsilon << ' '
       << p.options.or_default<Shooting>().tolerance;
  for (const ComparedMethod& method : p.work_precision.methods) {
    text << ' ' << static_cast<int>(method.kind) << ' ' << method.degree << ' '
         << static_cast<int>(method.arm);
  }
  for (const int size : p.work_precision.meshes) text << ' ' << size;
  for (const double wanted : p.work_precision.tolerances) text << ' ' << wanted;
  text << ' ' << p.work_precision.repetitions << ' '
       << p.work_precision.seconds_per_point;
  return text.str();
}

TEST(KeyTable, DefaultsAreThoseOfTheProgram) {
  const std::string plain = cylinder("radius: 1/3, k: 1/2");

  for (const KeySpec& spec : key_table()) {
    if (spec.fallback.empty()) continue;
    if (spec.fallback.starts_with("follows")) continue;  // see below
    const std::string change =
        std::string(spec.path) + "=" + std::string(spec.fallback);
    std::vector<std::string> before, after{change};
    if (spec.path.starts_with("scene.path")) {
      before = {"scene.path={shape: parabola}"};
    } else if (spec.path.starts_with("design.max_grip")) {
      before = {"design.max_grip.mu=1"};
    }
    after.insert(after.begin(), before.begin(), before.end());
    EXPECT_EQ(effective(read(plain, after)), effective(read(plain, before)))
        << change;
  }
}

TEST(KeyTable, TheDegreeOfAFixedMeshIsTheOneItTells) {
  const KeySpec* degree = find_key("discretisation.degree");
  ASSERT_NE(degree, nullptr);
  SolveOptions fixed;
  fixed.use<Collocation>().discretisation.elements = 12;
  Scene bead;
  bead.body = Body::bead();
  bead.L = 3.0;
  bead.H = 1.0;

  const Solution solution = solve(bead, fixed);

  ASSERT_TRUE(trajectory_of(solution));
  EXPECT_EQ(degree->fallback, "follows the tolerance, 5 on a fixed mesh");
  EXPECT_EQ(find_key("discretisation.nodes")->fallback,
            "follows the tolerance, 100 with method: fsolve");
  EXPECT_EQ(DiscreteSystem{}.nodes, 100);
  EXPECT_EQ(trajectory_of(solution)->curve().mesh().degree, 5);
}

TEST(KeyTable, IsComplete) {
  for (const KeySpec& spec : key_table()) {
    if (spec.type() == KeyType::Reserved) continue;
    const bool number = spec.type() == KeyType::Number ||
                        spec.type() == KeyType::Angle ||
                        spec.type() == KeyType::Integer;
    EXPECT_FALSE(spec.description.empty()) << spec.path;
    EXPECT_EQ(spec.value.put != nullptr || spec.value.put_text != nullptr,
              number || spec.type() == KeyType::Choice ||
                  spec.type() == KeyType::Text)
        << spec.path;
    EXPECT_EQ(spec.value.put_list != nullptr, spec.type() == KeyType::List)
        << spec.path;
    EXPECT_EQ(spec.value.words.empty(), spec.type() != KeyType::Choice)
        << spec.path;
    EXPECT_TRUE(spec.parent().empty() || find_key(spec.parent()) != nullptr)
        << spec.path;
  }
}

}  // namespace
}  // namespace brachisto::io
