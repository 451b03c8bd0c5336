// SPDX-License-Identifier: GPL-3.0-or-later
// Loose bodies along a path. Judge: the friction of a block of which the mass is known.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "haptics/session/path/PathRunner.h"
#include "testing/haptics/session/LooseStones.h"

namespace palpate::test
{
namespace
{

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr double pathStep_m = 2e-4; ///< faster than a small ball can be at thirty answers a second
constexpr int pathTicks = 1500;     ///< the last third of which are without a trace of the first impact

/// A ball that pushes the stone along x at a constant speed.
PathInputs ballAmongStones(double friction)
{
  PathInputs inputs;
  inputs.settings.put("Scale", 1.0);
  inputs.settings.put("Radius", fingertip_m);
  inputs.settings.put("FrictionStatic", friction);
  inputs.settings.put("FrictionKinetic", friction);
  for (const SurfaceInput& surface : { floorInput(), stoneInput() })
  {
    inputs.surfaces.push_back({ surface.name, surface.mesh });
  }
  inputs.surfaces.back().density_kg_per_m3 = stone_kg_per_m3;
  const double from_m = -half_m.x() - fingertip_m - 1e-3;
  for (int i = 0; i < pathTicks; ++i)
  {
    inputs.path.push_back({ handTick_s * i, { Vec3(from_m + pathStep_m * i, 0, half_m.z()), Quat::Identity() } });
  }
  return inputs;
}

TEST(LooseAlongPath, ABallPushesTheStoneByItsFrictionAndTheRowsHaveItsPlace)
{
  constexpr double friction = 0.3;
  PathRunner runner(ballAmongStones(friction));
  ASSERT_EQ(runner.report().refusal, "");
  const std::vector<PathColumn> columns = runner.columns();
  ASSERT_EQ(columns.size(), 5U);
  EXPECT_EQ(columns[3].name, "Place of stone");
  EXPECT_EQ(columns[4].name, "Turn of stone");
  double sum_N = 0.0;
  Vec3 place_W = Vec3::Zero();
  const auto take = [&](std::size_t i, const PathSample&, const PathTick& tick)
  {
    sum_N -= i >= 1000 ? tick.wrench_W.force.x() : 0.0;
    place_W = Vec3(tick.more[8], tick.more[9], tick.more[10]);
  };
  EXPECT_TRUE(runner.run([](double) { return true; }, take));
  EXPECT_NEAR(sum_N / 500.0, friction * weight_N, 0.01 * friction * weight_N);
  EXPECT_NEAR(place_W.x(), pathStep_m * (pathTicks - 1) - 1e-3, 5e-4);
  EXPECT_NEAR(place_W.z(), half_m.z(), 1e-6);
}

TEST(LooseAlongPath, InputsThatCannotBeAreNamedWithTheRemedy)
{
  const auto refusal = [](const PathInputs& inputs) { return PathRunner(inputs).report().refusal; };
  PathInputs point = ballAmongStones(0.0), open = point, heavy = point, large = point, textured = point;
  point.settings.put("Radius", 0.0);
  EXPECT_THAT(refusal(point), AllOf(HasSubstr("{Radius}"), HasSubstr("add a tool")));
  TriangleMesh mesh = *stoneInput().mesh;
  mesh.triangles.pop_back();
  open.surfaces.back().mesh = std::make_shared<const TriangleMesh>(mesh);
  EXPECT_THAT(refusal(open), StartsWith("stone: cannot be loose: the mesh is open"));
  heavy.surfaces.back().density_kg_per_m3 = 1e9;
  EXPECT_THAT(refusal(heavy), StartsWith("stone: cannot be loose: its density"));
  large.surfaces.back().mesh = std::make_shared<const TriangleMesh>(scaled(*stoneInput().mesh, 1000.0));
  EXPECT_THAT(refusal(large),
    AllOf(HasSubstr("Body \"stone\""), HasSubstr("one unit is taken as 1 m"), HasSubstr("{Scale}, which is 1000")));
  textured.settings.put("TextureArray", "height");
  EXPECT_THAT(refusal(textured), HasSubstr("{TextureArray} has no effect on a hand among loose bodies"));
}

} // namespace
} // namespace palpate::test
