// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "plot/thinning.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "plot/tables.hpp"

namespace brachisto::plot {
namespace {

using testing::Incline;

TEST(KeptTrack, IsOffByNoMoreThanItSays) {
  const Incline incline;
  const Body body = incline.scene().body;
  const Point down{std::cos(incline.slope), std::sin(incline.slope)};

  const report::Json track =
      kept_track(TrajectoryTable::read(incline.csv(401)), body);

  EXPECT_EQ(track["of_rows"], 401);
  const double error = track["path_error"];
  EXPECT_LE(error, kKeptError * incline.scene().L);
  const auto rows = read_kept_track(track, body);
  ASSERT_TRUE(rows);
  EXPECT_LE(rows->size(), 8u);  // a parabola needs no more
  EXPECT_LT(track.dump().size(), 500u);
  for (int i = 0; i <= 400; ++i) {
    const double t = incline.time * i / 400.0;
    const double s = 0.5 * incline.acceleration * t * t;
    const Point contact = rows->pose(t).contact(body);
    EXPECT_LE(std::hypot(contact.x - s * down.x, contact.z - s * down.z), error)
        << t;
  }
}

TEST(KeptTrack, TurnsTheBodyAsItRolls) {
  const Incline incline;
  const Body body = incline.scene().body;

  const auto rows = read_kept_track(
      kept_track(TrajectoryTable::read(incline.csv(401)), body), body);

  // θ = s/r, to its step: a hundred-thousandth of the range, rounded down.
  const double turned =
      0.5 * incline.acceleration * incline.time * incline.time / body.radius;
  EXPECT_NEAR(rows->pose(rows->time().back()).theta, turned, 1e-5 * turned);
}

TEST(KeptTrack, TellsBetweenWhichTimesTheBodyWouldLiftOff) {
  Incline incline;
  incline.normal = [](int row) { return std::abs(row - 200) - 50.5; };

  const report::Json track =
      kept_track(TrajectoryTable::read(incline.csv(401)), incline.scene().body);

  // R_n is linear on either side.
  const double step = incline.time / 400.0;
  ASSERT_EQ(track["lifts"].size(), 1u);
  EXPECT_NEAR(track["lifts"][0][0], 149.5 * step, 1e-12);
  EXPECT_NEAR(track["lifts"][0][1], 250.5 * step, 1e-12);
}

TEST(KeptTrack, MayLiftOffFromTheStartToTheEnd) {
  Incline incline;
  incline.normal = [](int row) { return -1.0 - row; };

  const report::Json track =
      kept_track(TrajectoryTable::read(incline.csv(41)), incline.scene().body);

  EXPECT_EQ(track["lifts"], report::Json({{0.0, incline.time}}));
}

TEST(KeptTrack, OfABeadHasNoAngleOfTheBody) {
  const Incline incline;

  const report::Json track =
      kept_track(TrajectoryTable::read(incline.csv(40)), Body::bead());

  EXPECT_EQ(track["rows"].size(), 5u);
  EXPECT_TRUE(read_kept_track(track, Body::bead()));
  EXPECT_FALSE(read_kept_track(track, incline.scene().body));
}

TEST(KeptTrack, IsNotReadFromAnythingElse) {
  const Incline incline;
  const Body body = incline.scene().body;
  const report::Json good =
      kept_track(TrajectoryTable::read(incline.csv(40)), body);
  const auto readable = [&](auto change) {
    report::Json track = good;
    change(track);
    return read_kept_track(track, body).has_value();
  };

  EXPECT_TRUE(readable([](report::Json&) {}));
  EXPECT_FALSE(readable([](report::Json& track) { track = nullptr; }));
  EXPECT_FALSE(readable([](report::Json& track) { track.erase("steps"); }));
  EXPECT_FALSE(readable([](report::Json& track) { track["rows"][2] = "x"; }));
  EXPECT_FALSE(
      readable([](report::Json& track) { track["rows"][1].erase(0); }));
  EXPECT_FALSE(readable([](report::Json& track) { track["rows"][0][1] = 0; }));
}

}  // namespace
}  // namespace brachisto::plot
