// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <filesystem>
#include <string>
#include <variant>

#include <gtest/gtest.h>

#include "haptics/recording/way/Trajectory.h"

namespace palpate::trajectories
{
namespace
{

Recording readGood(const std::string& path)
{
  auto read = readRecording(path);
  EXPECT_TRUE(std::holds_alternative<Recording>(read)) << std::get<std::string>(read);
  return std::get<Recording>(std::move(read));
}

TEST(Trajectory, IsWhereTheReplayHasHandProxyAndForce)
{
  for (const auto& file : std::filesystem::directory_iterator(PALPATE_FIXTURES))
  {
    if (file.path().extension() != ".palpate")
    {
      continue;
    }
    const Recording recording = readGood(file.path().string());
    const std::vector<TrajectoryPoint> points = trajectoryOf(recording);
    std::size_t next = 0;
    const ReplayResult replayed = replay(recording, {}, 1,
      [&](const TickOutput& output)
      {
        if (output.state.held)
        {
          return;
        }
        ASSERT_LT(next, points.size());
        const TrajectoryPoint& point = points[next++];
        EXPECT_EQ(point.tick, output.state.tick);
        EXPECT_EQ(point.hand_W, output.state.device_W.p);
        EXPECT_EQ(point.proxy_W, output.state.proxy_W.p);
        EXPECT_EQ(point.contacts, output.state.contacts);
        if (!output.state.deviceHolds)
        {
          EXPECT_EQ(point.force_W, output.state.force_W) << file.path() << " tick " << point.tick;
        }
      });
    EXPECT_EQ(replayed.difference, "");
    EXPECT_EQ(next, points.size()) << file.path();
    EXPECT_GT(next, 50u) << file.path();
  }
}

TickRecord tickAt(std::uint64_t number, const Vec3& p_D, double dt_s)
{
  TickRecord tick;
  tick.tick = number;
  tick.dt_s = dt_s;
  tick.sample.pose_D.p = p_D;
  tick.proxy_W.p = Vec3(1, 2, 3);
  tick.wrench_D.force = Vec3(0, 0, 2);
  return tick;
}

TEST(Trajectory, FollowsTheMapAndCountsMissedPeriodsAndTicksWithoutASample)
{
  Recording recording;
  recording.parameters.map.scale_u_per_m = 10.0;
  recording.entries.emplace_back(tickAt(1, Vec3(0.1, 0, 0), 1e-3));
  recording.entries.emplace_back(tickAt(2, Vec3(0.1, 0, 0), 4e-3)); // three periods were missed
  RecordedChange change;
  change.parameters = recording.parameters;
  change.parameters->map.q_WD = Quat(Eigen::AngleAxisd(EIGEN_PI / 2, Vec3::UnitX())); // y to z, z to -y
  change.parameters->map.offset_W = Vec3(5, 0, 0);
  recording.entries.emplace_back(change);
  TickRecord held = tickAt(3, Vec3(0, 0, 0), 1e-3);
  HapticState without;
  without.held = true;
  held.flags = recordFlags(without);
  recording.entries.emplace_back(held);
  recording.entries.emplace_back(tickAt(4, Vec3(0, 0.2, 0), 1e-3));

  const std::vector<TrajectoryPoint> points = trajectoryOf(recording);
  ASSERT_EQ(points.size(), 3u);
  EXPECT_EQ(points[0].hand_W, Vec3(1, 0, 0));
  EXPECT_EQ(points[0].depth_u(), std::sqrt(13.0)); // from (1, 0, 0) to (1, 2, 3)
  EXPECT_EQ(points[0].time_s, 0.0);
  EXPECT_EQ(points[0].lateness_s, 0.0);
  EXPECT_DOUBLE_EQ(points[1].time_s, 4e-3);
  EXPECT_DOUBLE_EQ(points[1].lateness_s, 3e-3);
  EXPECT_NEAR((points[2].hand_W - Vec3(5, 0, 2)).norm(), 0.0, 1e-14);
  EXPECT_NEAR((points[2].force_W - Vec3(0, -2, 0)).norm(), 0.0, 1e-14);
  EXPECT_EQ(points[2].tick, 4u);
  EXPECT_DOUBLE_EQ(points[2].time_s, 6e-3);
}

} // namespace
} // namespace palpate::trajectories
