// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "sweep/job.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "support/scratch_directory.hpp"

namespace brachisto::sweep {
namespace {

namespace fs = std::filesystem;
using testing::ScratchDirectory;

/// A sweep on a path of points beside the problem file.
class JobWithPoints : public ::testing::Test {
 protected:
  [[nodiscard]] Job job(const std::string& points) const {
    (void)scratch_.file("track.csv", points);
    return read_job(
        scratch_.file("p.yaml",
                      "scene:\n"
                      "  body: {shape: cylinder, radius: 1/3, k: 1/2}\n"
                      "  finish: {L: 3, H: 1}\n"
                      "  path: {curve: track, shape: points, file: track.csv}\n"
                      "sweep: {scene.body.eta_m: [0, 1/3]}\n"),
        {});
  }

  ScratchDirectory scratch_;
};

constexpr const char* kPoints = "x,z\n0,0\n1,0.7\n3,1\n";

TEST_F(JobWithPoints, NeedsNoFileOnceItIsRead) {
  const Job before = job(kPoints);
  fs::remove(scratch_.path() / "track.csv");

  const Job after = job_from_line(to_line(before));

  EXPECT_EQ(to_line(after), to_line(before));
  EXPECT_EQ(input_hash(after.file), input_hash(before.file));
  EXPECT_EQ(after.file.problem(1).scene.path->points,
            before.file.problem(1).scene.path->points);
}

TEST_F(JobWithPoints, TellsWhichPointHasChanged) {
  const Job before = job(kPoints);
  const Job moved = job("x,z\n0,0\n1,0.75\n3,1\n");
  const Job more = job("x,z\n0,0\n1,0.7\n2,1\n3,1\n");

  EXPECT_EQ(difference(before.file, moved.file),
            "it has 1,0.7 as point 2 from track.csv, which has 1,0.75 now");
  EXPECT_EQ(difference(before.file, more.file),
            "it has 3 points from track.csv, which has 4 now");
}

TEST(Job, IsAnotherOneIfTracksAreKept) {
  const auto file = [](const std::string& keep) {
    return io::read_sweep_text(
        "scene:\n  body: {shape: cylinder, radius: 1/3, k: 1/2}\n"
        "  finish: {L: 3, H: 1}\n"
        "sweep: {scene.body.eta_m: [0.1, 0.2]" +
            keep + "}\n",
        "p.yaml");
  };

  EXPECT_EQ(input_hash(file(", keep: nothing")), input_hash(file("")));
  EXPECT_NE(input_hash(file(", keep: tracks")), input_hash(file("")));
  EXPECT_EQ(difference(file(""), file(", keep: tracks")), "sweep.keep differs");
}

TEST(Job, IsNotReadFromAnythingElse) {
  const std::string deep(300'000, '[');
  for (const std::string& line :
       {std::string(""), std::string("{}"), std::string("[1]"),
        std::string(R"({"name": 1, "text": "", "overrides": []})"),
        std::string(R"({"name": "", "text": "", "overrides": 3})"),
        std::string(
            R"({"name": "", "text": "", "overrides": [], "points": [[1]]})"),
        deep, R"({"name": "", "text": "", "overrides": )" + deep}) {
    EXPECT_THROW((void)job_from_line(line), JobError) << line.substr(0, 80);
  }
}

TEST(Job, MayHaveANameOfAnyBytes) {
  const ScratchDirectory scratch;
  const Job job =
      read_job(scratch.file("\xff.yaml",
                            "scene: {body: {shape: bead}, finish: {H: 1}}\n"
                            "sweep: {scene.finish.L: [1, 2]}\n"),
               {});
  EXPECT_EQ(job_from_line(to_line(job)).file.num_scenes(), 2U);
}

}  // namespace
}  // namespace brachisto::sweep
