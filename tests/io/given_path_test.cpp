// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The section scene.path.

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <numbers>
#include <string>

#include "brachisto/io/problem_file.hpp"
#include "io/path_points.hpp"
#include "io/reading.hpp"
#include "support/scratch_directory.hpp"

namespace brachisto::io {
namespace {

using testing::ScratchDirectory;

/// A problem file with a section scene.path.
std::string problem(const std::string& path, const std::string& more = "") {
  return "scene:\n"
         "  body: {shape: cylinder, radius: 1/3, eta_m: 2/3, k: 1/2}\n"
         "  finish: {L: 3, H: 1}\n"
         "  path: " +
         path + "\n" + more;
}

/// All messages about a problem file in a directory; "" if it is good.
std::string errors_in(const ScratchDirectory& scratch,
                      const std::string& text) {
  try {
    (void)read_problem_text(text, (scratch.path() / "p.yaml").string());
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(GivenPath, IsAbsentByDefault) {
  const std::string text =
      "scene: {body: {shape: bead}, finish: {L: 3, H: 1}}\n";
  EXPECT_EQ(read_problem_text(text, "p.yaml").scene.path, nullptr);
}

TEST(GivenPath, IsReadAsItStands) {
  const auto path =
      read_problem_text(
          problem("{curve: track, shape: parabola, start_angle: 60 deg}"),
          "p.yaml")
          .scene.path;
  ASSERT_NE(path, nullptr);
  EXPECT_EQ(path->curve, GivenPath::Curve::Track);
  EXPECT_EQ(path->shape, GivenPath::Shape::Parabola);
  ASSERT_TRUE(path->start_angle);
  EXPECT_DOUBLE_EQ(*path->start_angle, std::numbers::pi / 3.0);
}

TEST(GivenPath, IsTheCentresUnlessItSaysOtherwise) {
  const auto path =
      read_problem_text(problem("{shape: straight}"), "p.yaml").scene.path;
  ASSERT_NE(path, nullptr);
  EXPECT_EQ(path->curve, GivenPath::Curve::Centre);
  EXPECT_FALSE(path->start_angle);
}

TEST(GivenPath, NeedsAShape) {
  EXPECT_NE(errors(problem("{curve: track}")).find("scene.path.shape: missing"),
            std::string::npos);
  EXPECT_NE(errors(problem("{shape: parabel}")).find("did you mean parabola?"),
            std::string::npos);
}

TEST(GivenPath, LeavesTheAngleToShapesThatHaveTheChoice) {
  EXPECT_NE(errors(problem("{shape: straight, start_angle: 1}"))
                .find("scene.path.start_angle: only a parabola"),
            std::string::npos);
}

TEST(GivenPath, OfATrackHasNoEndsOfTheCentre) {
  EXPECT_NE(
      errors(problem("{curve: track, shape: straight}", "  contact: centre\n"))
          .find("scene.path.curve: track is not allowed"),
      std::string::npos);
}

TEST(GivenPath, ReadsItsPointsBesideTheProblemFile) {
  const ScratchDirectory scratch;
  (void)scratch.file("track.csv", "x,z\r\n0,0\r\n1,0.7\n\n3,1\n");
  const std::string file = scratch.file(
      "p.yaml", problem("{curve: track, shape: points, file: track.csv}"));

  const auto path = read_problem_file(file).scene.path;

  ASSERT_NE(path, nullptr);
  ASSERT_EQ(path->points.size(), 3U);
  EXPECT_EQ(path->points[1].x, 1.0);
  EXPECT_EQ(path->points[1].z, 0.7);
}

TEST(GivenPath, RefusesPointsThatAreNone) {
  const ScratchDirectory scratch;
  const auto refusal = [&](const std::string& csv) {
    (void)scratch.file("track.csv", csv);
    return errors_in(scratch,
                     problem("{curve: track, shape: points, file: track.csv}"));
  };
  EXPECT_EQ(refusal("x,z\n0,0\n1,0.7\n3,1\n"), "");
  EXPECT_NE(refusal("0,0\n3,1\n").find("track.csv:1:"), std::string::npos);
  EXPECT_NE(refusal("x,z\n0,0\n1;2\n3,1\n").find("track.csv:3:1: \"1;2\""),
            std::string::npos);
  EXPECT_NE(refusal("x,z\n0,0\nnan,1\n3,1\n").find("track.csv:3:"),
            std::string::npos);
  EXPECT_NE(refusal("x,z\n0,0\n0,0\n3,1\n").find("repeats"), std::string::npos);
  EXPECT_NE(refusal("x,z\n").find("two points"), std::string::npos);
  EXPECT_NE(refusal("x,z\n0,0.1\n3,1\n").find("first point"),
            std::string::npos);
  EXPECT_NE(refusal("x,z\n0,0\n3,1.1\n").find("last point"), std::string::npos);
}

TEST(GivenPath, RefusesNoFileOrOneThatIsNotWanted) {
  EXPECT_EQ(errors(problem("{curve: track, shape: points}")),
            "p.yaml:4:3: scene.path.file: missing; shape: points needs a CSV "
            "file with the columns x,z");
  EXPECT_EQ(errors(problem("{shape: straight, file: none.csv}")),
            "p.yaml:4:33: scene.path.file: only shape: points has a file");
}

/// What is said of a file of points that cannot be read.
std::string failure(const std::string& name) {
  try {
    (void)read_problem_text(
        problem("{curve: track, shape: points, file: " + name + "}"), "p.yaml");
  } catch (const IoError& error) {
    return error.what();
  }
  return "";
}

TEST(GivenPath, OfPointsThatCannotBeReadIsNoMistakeOfTheFile) {
  EXPECT_EQ(failure("none.csv"),
            "p.yaml:4:45: scene.path.file: none.csv: cannot be opened: No such "
            "file or directory; the points may also stand in "
            "scene.path.points");
  const ScratchDirectory scratch;
  EXPECT_NE(failure(scratch.path().string()).find("is a directory"),
            std::string::npos);
  EXPECT_NE(failure("/dev/zero").find("is a device"), std::string::npos);
  const std::string pipe = (scratch.path() / "pipe").string();
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_NE(failure(pipe).find("is a pipe"), std::string::npos);
}

std::string points_refusal(const std::string& points) {
  try {
    (void)parse_points(points);
  } catch (const PointsError& error) {
    return error.what();
  }
  return "";
}

TEST(Points, ThatAreNoNumbersAreToldWhereAndWhy) {
  EXPECT_EQ(points_refusal("x,z\n0,0\n1,a\n"),
            "3:3: \"a\" is not a number: \"a\" has no meaning here; expected "
            "two numbers x,z in m");
  const std::string expected = "expected a point [x, z], two numbers in m";
  EXPECT_EQ(
      errors(problem(
          "{curve: track, shape: points, points: [[0, 0], [1, a], [3, 1]]}")),
      "p.yaml:4:60: scene.path.points: \"a\" is not a number: \"a\" has "
      "no meaning here; " +
          expected);
  EXPECT_EQ(
      errors(problem(
          "{curve: track, shape: points, points: [[0, 0], [1, 2, 3]]}")),
      "p.yaml:4:56: scene.path.points: a list of 3 was read; " + expected);
  EXPECT_EQ(
      errors(problem("{curve: track, shape: points, points: [[0, 0], 7]}")),
      "p.yaml:4:56: scene.path.points: a single value was read; " + expected);
}

TEST(Points, MayFollowAByteOrderMark) {
  EXPECT_EQ(parse_points("\xEF\xBB\xBFx,z\n0,0\n3,1\n").size(), 2U);
}

TEST(Points, AreBounded) {
  std::string most = "x,z\n";
  for (std::size_t i = 0; i < kMostPoints; ++i) {
    most += std::to_string(i) + ",0\n";
  }
  EXPECT_EQ(parse_points(most).size(), 100'000U);
  EXPECT_EQ(points_refusal(most + "-1,0\n"),
            "100002:1: \"-1,0\" is one point too many; 100000 are allowed");
  EXPECT_EQ(points_refusal("x,z\n" + std::string(kMaxPointsSize, '\n')),
            "1:1: longer than 16777216 bytes, which no 100000 points need");
}

TEST(GivenPath, HoldsTheEndsAgainstLAndHSeparately) {
  const ScratchDirectory scratch;
  (void)scratch.file("track.csv", "x,z\n0,0\n1,1e-6\n3,2e-6\n");

  const std::string found =
      errors_in(scratch,
                "scene: {body: {shape: bead}, finish: {L: 3, H: 1e-6},\n"
                "  path: {curve: track, shape: points, file: track.csv}}\n");

  EXPECT_NE(found.find("the last point is (3, 2e-06) and has to be (3, 1e-06)"),
            std::string::npos)
      << found;
}

}  // namespace
}  // namespace brachisto::io
