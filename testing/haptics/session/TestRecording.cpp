// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "devices/FedDevice.h"
#include "haptics/geometry/mesh/PolyLines.h"
#include "haptics/geometry/scene/SceneMotion.h"
#include "haptics/recording/Recording.h"
#include "haptics/session/HapticSession.h"
#include "haptics/session/LoopReport.h"
#include "testing/haptics/recording/RecordingChecks.h"
#include "testing/support/Meshes.h"
#include "testing/support/TemporaryFolder.h"

namespace palpate
{
namespace
{

/// Gone in the end.
struct TemporaryFile
{
  const test::TemporaryFolder folder;
  const std::string path = this->folder.file("recording");
};

std::vector<SurfaceInput> threeSurfaces(int levels)
{
  std::vector<SurfaceInput> inputs;
  for (int i = 0; i < 3; ++i)
  {
    inputs.push_back({ "ball " + std::to_string(i),
      std::make_shared<TriangleMesh>(test::shifted(test::makeIcosphere(levels, 0.05), Vec3(0.08 * i, 0, 0))), {} });
  }
  return inputs;
}

/// A hand that strokes the middle one of three overlapping spheres for `ticks`, the scene replaced every 200 ticks and
/// the parameters changed once; recorded in virtual time.
void record(const std::string& path, int ticks, double radius_u)
{
  SceneBuilder builder;
  const auto coarse = builder.build(threeSurfaces(3)).scene, fine = builder.build(threeSurfaces(4)).scene;
  HapticSession session;
  HapticParameters parameters;
  parameters.contact.radius_u = radius_u;
  parameters.safety.engageRamp_s = 0.1;
  ASSERT_EQ(session.setParameters(parameters), "");
  session.setScene(coarse);
  SessionOptions options;
  options.virtualTime = true;
  options.recordFile = path;
  ASSERT_EQ(session.start(std::make_unique<FedDevice>(), options), "");
  for (int tick = 0; tick < ticks; ++tick)
  {
    const double s = 1e-3 * tick;
    DeviceSample sample;
    sample.pose_D.p =
      tick == 0 ? Vec3(0.08, 0, 0.07) : Vec3(0.08 + 0.012 * std::sin(0.7 * s), 0.01 * std::sin(5 * s), 0.047);
    static_cast<FedDevice*>(session.device())->feed(sample);
    if (tick > 0 && tick % 200 == 0)
    {
      session.setScene(tick % 400 == 0 ? coarse : fine);
    }
    if (tick == ticks / 2)
    {
      parameters.stiffness_N_per_m = 700.0;
      ASSERT_EQ(session.setParameters(parameters), "");
      session.mark();
    }
    ASSERT_EQ(session.step(1), 1);
  }
  EXPECT_GT(session.report().contactTicks, static_cast<std::uint64_t>(ticks) / 2);
  EXPECT_EQ(session.stop(), "");
}

Recording readGood(const std::string& path)
{
  auto read = readRecording(path);
  EXPECT_TRUE(std::holds_alternative<Recording>(read)) << std::get<std::string>(read);
  return std::get<Recording>(std::move(read));
}

void expectBitForBit(const ReplayResult& result, int ticks)
{
  EXPECT_EQ(result.problem, "");
  EXPECT_EQ(result.difference, "");
  EXPECT_EQ(result.ticks, static_cast<std::uint64_t>(ticks));
}

std::string problemOf(const std::vector<char>& bytes)
{
  const auto read = parseRecording(bytes, "the file");
  const auto* problem = std::get_if<std::string>(&read);
  return problem != nullptr ? *problem : "";
}

// Row 55. 60 s with PALPATE_TEST_COUNT=60000.
TEST(Recording, WithSceneSwapsReplaysBitForBitWithOneTwoAndFourBuilders)
{
  const char* const count = std::getenv("PALPATE_TEST_COUNT");
  const int ticks = count != nullptr ? std::atoi(count) : 4000;
  for (const double radius : { 0.0, 0.001 })
  {
    const TemporaryFile file;
    record(file.path, ticks, radius);
    const Recording recording = readGood(file.path);
    EXPECT_EQ(recording.scenes.size(), 2U) << "each scene is stored once";
    for (const unsigned workers : { 1U, 2U, 4U })
    {
      expectBitForBit(replay(recording, {}, workers), ticks);
    }
  }
}

/// A fed hand under friction, recorded in virtual time.
class RecordedHand
{
public:
  HapticSession session;

  void start(const std::string& path, double radius_u)
  {
    HapticParameters parameters;
    parameters.contact.radius_u = radius_u;
    parameters.contact.friction = { 0.4, 0.3 };
    ASSERT_EQ(this->session.setParameters(parameters), "");
    SessionOptions options;
    options.virtualTime = true;
    options.recordFile = path;
    ASSERT_EQ(this->session.start(std::make_unique<FedDevice>(), options), "");
  }

  void tickAt(const Vec3& p_D)
  {
    DeviceSample sample;
    sample.pose_D.p = p_D;
    static_cast<FedDevice*>(this->session.device())->feed(sample);
    ASSERT_EQ(this->session.step(1), 1);
  }

  void stopAfter(int ticks)
  {
    EXPECT_GT(this->session.report().contactTicks, static_cast<std::uint64_t>(ticks) / 2);
    EXPECT_EQ(this->session.stop(), "");
  }
};

/// The same hand over a surface, the second, that swings and turns under it: a new snapshot of its pose every 16 ticks.
void recordMoving(const std::string& path, int ticks, double radius_u, const std::vector<SurfaceInput>& surfaces)
{
  constexpr int ticksPerSnapshot = 16;
  const auto still = SceneBuilder().build(surfaces).scene;
  const auto poseAt = [](double t) {
    return Pose{ { 0.01 * std::sin(9 * t), 0, 0.004 * std::sin(21 * t) }, Quat(Eigen::AngleAxisd(t, Vec3::UnitX())) };
  };
  RecordedHand hand;
  hand.start(path, radius_u);
  for (int tick = 0; tick < ticks; ++tick)
  {
    const double s = 1e-3 * tick;
    if (tick % ticksPerSnapshot == 0)
    {
      std::vector<Surface> surfaces = still->surfaces();
      const double period_s = 1e-3 * ticksPerSnapshot;
      surfaces[1].motion = { poseAt(s), poseAt(s + period_s) };
      hand.session.setScene(std::make_shared<const Scene>(1 + tick, std::move(surfaces), period_s));
    }
    hand.tickAt(tick == 0 ? Vec3(0.08, 0, 0.09) : Vec3(0.08 + 0.01 * std::sin(3 * s), 0, 0.046));
  }
  hand.stopAfter(ticks);
}

TEST(Recording, OfSurfacesThatMoveStoresTheirMeshesOnceAndReplaysBitForBit)
{
  for (const double radius : { 0.0, 0.001 })
  {
    const TemporaryFile file;
    recordMoving(file.path, 1600, radius, threeSurfaces(3));
    const Recording recording = readGood(file.path);
    EXPECT_EQ(recording.scenes.size(), 1U);
    EXPECT_EQ(recording.motions.size(), 100U);
    expectBitForBit(replay(recording), 1600);
  }
}

/// The second of three surfaces is curves.
std::vector<SurfaceInput> surfacesAndCurves()
{
  std::vector<SurfaceInput> inputs = threeSurfaces(3);
  PolyLines curves;
  curves.points_W = { { 0.05, 0, 0 }, { 0.08, 0.01, 0.002 }, { 0.12, 0, 0 }, { 0.08, -0.05, 0 }, { 0.08, 0.05, 0 } };
  curves.lines = { { 0, 1, 2 }, { 3, 4 } };
  inputs[1].mesh = std::make_shared<const TriangleMesh>(segmentsOf(curves));
  inputs[1].lineRadius_u = 0.05;
  return inputs;
}

// A texture is left out on curves, and with it all effect of their arrays.
TEST(Recording, OfCurvesWithATextureReplaysBitForBit)
{
  std::vector<SurfaceInput> inputs = surfacesAndCurves();
  MaterialFields fields;
  fields.height_u = { 0.0, 0.001, 0.002, 0.001, 0.0 };
  inputs[1].fields = std::make_shared<const MaterialFields>(fields);
  const TemporaryFile file;
  recordMoving(file.path, 200, 0.001, inputs);
  expectBitForBit(replay(readGood(file.path)), 200);
}

TEST(Recording, OfCurvesThatMoveReplaysBitForBit)
{
  for (const double radius : { 0.0, 0.001 })
  {
    const TemporaryFile file;
    recordMoving(file.path, 1600, radius, surfacesAndCurves());
    const Recording recording = readGood(file.path);
    ASSERT_EQ(recording.scenes.size(), 1U);
    EXPECT_EQ(recording.scenes[0].surfaces.at(1).lineRadius_u, 0.05);
    EXPECT_EQ(recording.scenes[0].surfaces.at(0).lineRadius_u, std::nullopt);
    expectBitForBit(replay(recording), 1600);
  }
}

/// A hand on a sphere that breathes while its other half stands, and swings and turns by `swing` (0: it stays); the
/// recording begins with a tree that was refitted.
void recordBending(const std::string& path, int ticks, double radius_u, double swing)
{
  constexpr int ticksPerSnapshot = 16;
  SceneBuilder builder;
  const auto sphereAt = [swing](double t)
  {
    TriangleMesh mesh = test::makeIcosphere(3, 0.05);
    for (Vec3& v : mesh.vertices_W)
    {
      v *= 1.0 + 0.1 * std::sin(9 * t) + 0.1 * std::sin(5 * t) * v.x() / 0.05;
    }
    SurfaceInput sphere{ "it", std::make_shared<TriangleMesh>(std::move(mesh)), {} };
    sphere.pose_WS = { swing * Vec3(0.01 * std::sin(9 * t), 0, 0.004 * std::sin(21 * t)),
      Quat(Eigen::AngleAxisd(swing * t, Vec3::UnitX())) };
    return sphere;
  };
  auto felt = builder.build({ sphereAt(-0.1) }).scene;
  felt = builder.build({ sphereAt(0) }).scene;
  RecordedHand hand;
  hand.session.setScene(felt);
  hand.start(path, radius_u);
  for (int tick = 0; tick < ticks; ++tick)
  {
    const double s = 1e-3 * tick;
    if (tick % ticksPerSnapshot == 0 && tick % 112 != 0) // one in seven comes late
    {
      const double share =
        hand.session.state().sceneRevision == felt->revision() ? felt->shareAt(hand.session.state().sceneAge_s) : 0.0;
      felt = movingFrom(*felt, share, builder.build({ sphereAt(s) }, felt.get()).scene, 0.021);
      ASSERT_TRUE(felt->bends());
      hand.session.setScene(felt);
    }
    hand.tickAt(tick < 2 ? Vec3(0, 0, 0.09) : Vec3(0.01 * std::sin(3 * s), 0, 0.042));
  }
  hand.stopAfter(ticks);
}

TEST(Recording, OfVerticesOnTheirWayReplaysBitForBit)
{
  for (const double radius : { 0.0, 0.001 })
  {
    const TemporaryFile file;
    recordBending(file.path, 800, radius, 0.0);
    expectBitForBit(replay(readGood(file.path)), 800);
  }
}

TEST(Recording, OfVerticesOnTheirWayInAFrameThatMovesReplaysBitForBit)
{
  for (const double radius : { 0.0, 0.001 })
  {
    const TemporaryFile file;
    recordBending(file.path, 800, radius, 1.0);
    const Recording recording = readGood(file.path);
    ASSERT_FALSE(recording.motions.empty());
    EXPECT_NE(recording.motions.back().starts.at(0), nullptr);
    EXPECT_TRUE(recording.motions.back().motions.at(0).moves());
    expectBitForBit(replay(recording), 800);
  }
}

TEST(Recording, OfASurfaceAndOneThatStandsForItKeepsTheirBoundAndReplaysBitForBit)
{
  constexpr int ticks = 800;
  constexpr double bound_u = 0.0005; // more than a facet of the coarser sphere is below it
  const auto sphere = [](int levels) {
    return Surface{ "it", std::make_shared<const SurfaceTree>(cleanMesh(test::makeIcosphere(levels, 0.05)).mesh), {} };
  };
  Surface full = sphere(4), coarse = sphere(3);
  coarse.standsFor = { full.tree->contentHash(), bound_u };
  for (const double radius : { 0.0, 0.001 })
  {
    const TemporaryFile file;
    RecordedHand hand;
    hand.session.setScene(std::make_shared<const Scene>(1, std::vector<Surface>{ full }));
    hand.start(file.path, radius);
    for (int tick = 0; tick < ticks; ++tick)
    {
      if (tick % 50 == 49)
      {
        const std::vector<Surface> felt{ tick % 100 == 49 ? coarse : full };
        hand.session.setScene(std::make_shared<const Scene>(tick, felt));
      }
      hand.tickAt(tick < 2 ? Vec3(0, 0, 0.09) : Vec3(0.003 * std::sin(3e-3 * tick), 0, 0.0495 + radius));
    }
    hand.stopAfter(ticks);
    const Recording recording = readGood(file.path);
    ASSERT_EQ(recording.scenes.size(), 2U);
    EXPECT_EQ(recording.scenes[0].surfaces.at(0).standsFor.full, 0U);
    EXPECT_EQ(recording.scenes[1].surfaces.at(0).standsFor.full, full.tree->contentHash());
    EXPECT_EQ(recording.scenes[1].surfaces.at(0).standsFor.bound_u, bound_u);
    expectBitForBit(replay(recording), ticks);
  }
}

TEST(Recording, ReplayNamesTheFirstTickThatDiffers)
{
  const TemporaryFile file;
  record(file.path, 600, 0.0);
  Recording recording = readGood(file.path);
  int seen = 0;
  for (RecordedEntry& entry : recording.entries)
  {
    if (auto* tick = std::get_if<TickRecord>(&entry); tick != nullptr && ++seen == 500)
    {
      tick->wrench_D.force.x() = std::nextafter(tick->wrench_D.force.x(), 1e9);
    }
  }
  EXPECT_EQ(replay(recording).difference, "tick 500: force differs");
}

TEST(Recording, WithoutItsScenesAsksForThemAndTakesThemByContent)
{
  const TemporaryFile file;
  record(file.path, 600, 0.0);
  Recording recording = readGood(file.path);
  recording.scenes.clear();
  EXPECT_NE(replay(recording).problem.find("--scene"), std::string::npos);
  SceneBuilder builder;
  const auto fine = builder.build(threeSurfaces(4)).scene, coarse = builder.build(threeSurfaces(3)).scene;
  const ReplayResult result = replay(recording, { fine, coarse });
  EXPECT_EQ(result.problem + result.difference, "");
}

TEST(Recording, EveryPlaceWhereAFileMayBeCutGivesOneSentence)
{
  const TemporaryFile file;
  record(file.path, 20, 0.0);
  const std::vector<char> whole = test::bytesOf(file.path);
  ASSERT_EQ(problemOf(whole), "");
  for (std::size_t length = 0; length < whole.size(); length += 1 + whole.size() / 997)
  {
    const std::string problem = problemOf({ whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length) });
    EXPECT_EQ(problem.rfind("the file ", 0), 0U) << length;
    EXPECT_EQ(problem.find('\n'), std::string::npos);
  }
}

TEST(Recording, AnyDamagedByteIsSurvived)
{
  const TemporaryFile file;
  record(file.path, 20, 0.0);
  const std::vector<char> whole = test::bytesOf(file.path);
  for (std::size_t at = 0; at < whole.size(); at += 1 + whole.size() / 1499)
  {
    std::vector<char> damaged = whole;
    damaged[at] = static_cast<char>(~damaged[at]);
    static_cast<void>(parseRecording(damaged, "the file")); // a sentence or a recording, never a crash
  }
}

TEST(Recording, OfAnotherVersionIsRefusedByNumber)
{
  const std::string other = "PALPATE-RECORDING 99\nend\n";
  EXPECT_NE(problemOf({ other.begin(), other.end() }).find("format 99"), std::string::npos);
  const std::string strange = "solid cube";
  EXPECT_NE(problemOf({ strange.begin(), strange.end() }).find("not a recording"), std::string::npos);
}

TEST(Recording, ThatCannotBeWrittenKeepsTheSessionFromStarting)
{
  HapticSession session;
  SessionOptions options;
  options.virtualTime = true;
  options.recordFile = "/nonexistent-folder/x.palpate";
  const std::string problem = session.start(std::make_unique<FedDevice>(), options);
  EXPECT_NE(problem.find("/nonexistent-folder/x.palpate"), std::string::npos);
  EXPECT_FALSE(session.running());
}

} // namespace
} // namespace palpate
