// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes as scanners leave them, as tool and as scene. data/get fetches them, data/implant.py makes implant.vtp beside
// skull.vtp; those that are not there are not in the list. PALPATE_TEST_FULL=1 is the whole of it.
#include <array>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include <gtest/gtest.h>

#include "ImplantRun.h"
#include "Tools.h"
#include "vtkHapticConversion.h"
#include "vtkHapticReaders.h"
#include "vtkPolyData.h"

namespace palpate::test
{
namespace
{

struct RealPair
{
  const char *tool, *scene;
};

constexpr std::array wanderers = { RealPair{ "dragon.off", "armadillo.off" } };
constexpr std::array largeWanderers = { RealPair{ "aneurysm.stl", "skull.vtp" } };
constexpr std::array implants = { RealPair{ "implant.vtp", "skull.vtp" } };

bool full()
{
  return std::getenv("PALPATE_TEST_FULL") != nullptr;
}

std::filesystem::path pathOf(const char* file)
{
  const char* elsewhere = std::getenv("PALPATE_DATA");
  return std::filesystem::path(elsewhere != nullptr ? elsewhere : PALPATE_DATA_CACHE) / file;
}

template<class Pairs>
std::vector<RealPair> those(const Pairs& pairs)
{
  std::vector<RealPair> found;
  for (const RealPair& pair : pairs)
  {
    if (std::filesystem::exists(pathOf(pair.tool)) && std::filesystem::exists(pathOf(pair.scene)))
    {
      found.push_back(pair);
    }
  }
  return found;
}

TriangleMesh read(const char* file)
{
  const vtkHapticReadResult read = vtkHapticReadSurface(pathOf(file), {});
  if (!read.Surface)
  {
    throw std::runtime_error(read.Problem);
  }
  const vtkHapticConversionResult converted = vtkHapticToMesh(read.Surface);
  if (!converted.Mesh)
  {
    throw std::runtime_error(converted.Problem);
  }
  return cleanMesh(*converted.Mesh).mesh;
}

/// About the origin, of that extent.
TriangleMesh centred(const TriangleMesh& mesh, double extent_mm)
{
  Eigen::AlignedBox3d bounds;
  for (const Vec3& v : mesh.vertices_W)
  {
    bounds.extend(v);
  }
  return scaled(shifted(mesh, -bounds.center()), extent_mm / bounds.sizes().maxCoeff());
}

std::string nameOf(const testing::TestParamInfo<RealPair>& info)
{
  return std::filesystem::path(info.param.tool).stem().string() + "On" +
         std::filesystem::path(info.param.scene).stem().string();
}

class RealTool : public testing::TestWithParam<RealPair>
{
};
class RealImplant : public testing::TestWithParam<RealPair>
{
};

TEST_P(RealTool, ThatWandersOverARealSurfaceMeetsNothingRow33)
{
  constexpr double tool_mm = 40.0, scene_mm = 100.0;
  Random random(testSeed(3310));
  JudgedTool judged(centred(read(GetParam().tool), tool_mm), centred(read(GetParam().scene), scene_mm), 2);
  judged.judge.sparse(full() ? 5 : 20);
  ASSERT_EQ(judged.move.place({ Vec3(110, 0, 0), Quat::Identity() }), "");
  const std::size_t touching = wander(judged, random, testCount(full() ? 2000 : 30), 55.0, 20000);
  std::cout << touching << " updates touch, " << judged.judge.judged() << " poses judged\n";
  EXPECT_EQ(judged.judge.found(), 0u) << "of " << judged.judge.judged();
  EXPECT_GT(judged.judge.judged(), 3u);
  EXPECT_GT(touching, 10u);
}

TEST_P(RealImplant, LedToItsSeatAndTurnedAboutMeetsNothingGivesNoEnergyAndReplaysBitForBit)
{
  ImplantTask task{ read(GetParam().scene), read(GetParam().tool) };
  task.seconds = full() ? 60.0 : 3.0;
  task.judgedEach = 100;
  const ImplantFigures seen = playImplant(task);
  std::cout << describe(seen) << '\n';
  EXPECT_EQ(seen.problem, "");
  EXPECT_EQ(seen.crossings, 0u);
  EXPECT_LE(seen.excess_J, 5e-3 * 8.5 / 3.0) << "5 mJ for a device of 3 N";
  EXPECT_GT(seen.touching, seen.ticks / 5);
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(RealTool);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(RealImplant);
INSTANTIATE_TEST_SUITE_P(RealTools, RealTool, testing::ValuesIn(those(wanderers)), nameOf);
INSTANTIATE_TEST_SUITE_P(
  LargeRealTools, RealTool, testing::ValuesIn(full() ? those(largeWanderers) : std::vector<RealPair>()), nameOf);
INSTANTIATE_TEST_SUITE_P(RealTools, RealImplant, testing::ValuesIn(those(implants)), nameOf);

} // namespace
} // namespace palpate::test
