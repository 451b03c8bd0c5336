// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces as scanners and modellers leave them, under a random hand on both sides, in metres and in millimetres.
// data/get fetches them; those that are not there are not in the list. PALPATE_TEST_COUNT=1000000 is the whole of it:
// so many ticks on each surface in each unit.
#include <array>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <optional>
#include <stdexcept>

#include <gtest/gtest.h>

#include "testing/support/LongRun.h"
#include "testing/support/Meshes.h"
#include "vtkHapticConversion.h"
#include "vtkHapticReaders.h"
#include "vtkPolyData.h"

namespace palpate::test
{
namespace
{

struct RealSurface
{
  const char* file;
  std::optional<double> iso;
  double extent_mm; ///< 0: the file is in millimetres; else the length that its largest extent stands for
};

constexpr std::array surfaces = { RealSurface{ "skull.vtp", {}, 0.0 }, RealSurface{ "brain.nii.gz", 60.0, 0.0 },
  RealSurface{ "aneurysm.stl", {}, 60.0 }, RealSurface{ "armadillo.off", {}, 150.0 },
  RealSurface{ "dragon.off", {}, 150.0 } };

std::filesystem::path pathOf(const RealSurface& surface)
{
  const char* elsewhere = std::getenv("PALPATE_DATA");
  return std::filesystem::path(elsewhere != nullptr ? elsewhere : PALPATE_DATA_CACHE) / surface.file;
}

std::vector<RealSurface> those()
{
  std::vector<RealSurface> found;
  for (const RealSurface& surface : surfaces)
  {
    if (std::filesystem::exists(pathOf(surface)))
    {
      found.push_back(surface);
    }
  }
  return found;
}

double extentOf(const TriangleMesh& mesh)
{
  Vec3 low = mesh.vertices_W.at(0), high = low;
  for (const Vec3& v : mesh.vertices_W)
  {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  return (high - low).maxCoeff();
}

/// In millimetres, cleaned.
TriangleMesh read(const RealSurface& surface)
{
  const vtkHapticReadResult file = vtkHapticReadSurface(pathOf(surface), surface.iso);
  if (!file.Surface)
  {
    throw std::runtime_error(file.Problem);
  }
  const vtkHapticConversionResult converted = vtkHapticToMesh(file.Surface);
  if (!converted.Mesh)
  {
    throw std::runtime_error(converted.Problem);
  }
  const TriangleMesh mesh = cleanMesh(*converted.Mesh).mesh;
  return surface.extent_mm > 0.0 ? scaled(mesh, surface.extent_mm / extentOf(mesh)) : mesh;
}

class Real : public ::testing::TestWithParam<RealSurface>
{
};

TEST_P(Real, IsNeverPassedAndNeverHoldsAFreeBall)
{
  const TriangleMesh inMillimetres = read(GetParam());
  for (const double unitsPerMillimetre : { 1.0, 1e-3 })
  {
    const JudgedMesh touched(cleanMesh(scaled(inMillimetres, unitsPerMillimetre)).mesh);
    RunTask task;
    task.scene = sceneOf(touched.mesh);
    task.touched = &touched;
    task.size_u = extentOf(touched.mesh);
    task.seed = testSeed(2501);
    RunFigures figures;
    for (const double r_mm : { 0.0, 0.25, 1.0, 2.0 })
    {
      for (const bool inside : { false, true })
      {
        task.plan.radius_u = r_mm * unitsPerMillimetre;
        task.inside = inside;
        task.seed += 17;
        LongRun run(task);
        ASSERT_TRUE(run.placed()) << "no room for a ball of " << r_mm << " mm";
        run.run(testCount(10000) / 8);
        EXPECT_TRUE(run.figures().clean()) << "radius " << r_mm << " mm, " << (inside ? "inside" : "outside") << ", "
                                           << unitsPerMillimetre << " units a mm: " << run.figures().text() << "\n"
                                           << run.figures().first;
        figures += run.figures();
      }
    }
    std::cout << GetParam().file << ", " << touched.mesh.triangles.size() << " triangles, "
              << (unitsPerMillimetre == 1.0 ? "mm: " : "m: ") << figures.text() << std::endl;
    EXPECT_GT(figures.touching, figures.ticks / 10);
  }
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Real);
INSTANTIATE_TEST_SUITE_P(RealSurfaces, Real, ::testing::ValuesIn(those()),
  [](const auto& info) { return std::filesystem::path(info.param.file).stem().stem().string(); });

} // namespace
} // namespace palpate::test
