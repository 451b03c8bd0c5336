// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include <gtest/gtest.h>

#include "NIfTIBytes.h"
#include "VtkScenes.h"
#include "haptics/core/Types.h"
#include "testing/support/TemporaryFolder.h"
#include "vtkHapticConversion.h"
#include "vtkHapticReaders.h"
#include "vtkPolyData.h"

using palpate::Mat3;
using palpate::Quat;
using palpate::Vec3;
using palpate::testing::NIfTIBytes;

namespace
{
constexpr std::array<int, 3> size = { 12, 10, 8 };
/// The only bright part: a box of voxels well off the middle along every axis, so that no mirror maps it to itself.
constexpr std::array<int, 3> low = { 2, 1, 4 };
constexpr std::array<int, 3> high = { 4, 5, 5 };

NIfTIBytes headerOf(const Vec3& spacing_mm)
{
  NIfTIBytes header;
  header.setDim({ size[0], size[1], size[2] });
  header.setType(2); // unsigned char
  header.setSpacing(spacing_mm);
  return header;
}

bool inside(int i, int j, int k)
{
  return i >= low[0] && i <= high[0] && j >= low[1] && j <= high[1] && k >= low[2] && k <= high[2];
}

void write(NIfTIBytes file, const std::string& path)
{
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        file.add(inside(i, j, k) ? std::uint8_t{ 200 } : std::uint8_t{ 0 });
      }
    }
  }
  file.write(path);
}

/// The iso surface of half the brightness lies half a voxel outside the box on all sides, so its bounds have the
/// middle of the box as their centre wherever `linear`, a signed permutation times spacing, puts them.
void expectAt(const NIfTIBytes& header, const Mat3& linear, const Vec3& shift)
{
  const palpate::test::TemporaryFolder folder;
  write(header, folder.file("box.nii"));
  const vtkHapticReadResult result = vtkHapticReadSurface(folder.file("box.nii"), 100.0);
  ASSERT_TRUE(result.Surface) << result.Problem;
  double bounds[6];
  result.Surface->GetBounds(bounds);
  const Vec3 middle(0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1]), 0.5 * (low[2] + high[2]));
  const Vec3 extent(high[0] - low[0] + 1, high[1] - low[1] + 1, high[2] - low[2] + 1);
  const Vec3 centre = linear * middle + shift;
  const Vec3 length = linear.cwiseAbs() * extent;
  constexpr double singlePrecision = 1e-4; // the header's matrix and VTK's points are floats, lengths about 100 mm
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR(0.5 * (bounds[2 * axis] + bounds[2 * axis + 1]), centre[axis], singlePrecision) << "axis " << axis;
    EXPECT_NEAR(bounds[2 * axis + 1] - bounds[2 * axis], length[axis], singlePrecision) << "axis " << axis;
  }
  EXPECT_GT(palpate::testing::enclosedVolume(*vtkHapticToMesh(result.Surface).Mesh), 0.0) << "it is inside out";
}

const Vec3 spacing(1.5, 2.0, 2.5);
const Vec3 shift(-90.0, -126.0, 72.0);
} // namespace

TEST(NIfTIOrientation, AnSFormPutsVoxelsWhereItsRowsSay)
{
  NIfTIBytes header = headerOf(spacing);
  const Mat3 linear = spacing.asDiagonal();
  header.setSForm(linear, shift);
  expectAt(header, linear, shift);
}

TEST(NIfTIOrientation, LeftStaysLeftWhenVoxelsAreStoredFromRightToLeft)
{
  NIfTIBytes header = headerOf(spacing);
  const Mat3 linear = Vec3(-spacing.x(), spacing.y(), spacing.z()).asDiagonal();
  header.setSForm(linear, Vec3(90.0, -126.0, -72.0));
  expectAt(header, linear, Vec3(90.0, -126.0, -72.0));
}

TEST(NIfTIOrientation, ATurnedSFormSwapsTheAxes)
{
  NIfTIBytes header = headerOf(spacing);
  Mat3 linear = Mat3::Zero(); // voxel i runs along z, j along -x, k along y
  linear(2, 0) = spacing.x();
  linear(0, 1) = -spacing.y();
  linear(1, 2) = spacing.z();
  header.setSForm(linear, shift);
  expectAt(header, linear, shift);
}

TEST(NIfTIOrientation, AQFormPutsVoxelsWhereItsQuaternionSays)
{
  NIfTIBytes header = headerOf(spacing);
  header.setQForm(Quat(1.0, 0.0, 0.0, 0.0), shift, 1.0);
  expectAt(header, spacing.asDiagonal(), shift);
}

TEST(NIfTIOrientation, LeftStaysLeftForAQFormWithANegativeQFac)
{
  NIfTIBytes header = headerOf(spacing);
  // half a turn around y maps (x, y, z) to (-x, y, -z); qfac -1 turns the third axis back: only x is mirrored
  header.setQForm(Quat(0.0, 0.0, 1.0, 0.0), shift, -1.0);
  expectAt(header, Vec3(-spacing.x(), spacing.y(), spacing.z()).asDiagonal(), shift);
}

TEST(NIfTIOrientation, TheSFormIsTakenWhenThereAreBoth)
{
  NIfTIBytes header = headerOf(spacing);
  const Mat3 linear = Vec3(-spacing.x(), spacing.y(), spacing.z()).asDiagonal();
  header.setQForm(Quat(1.0, 0.0, 0.0, 0.0), Vec3::Zero(), 1.0);
  header.setSForm(linear, shift);
  expectAt(header, linear, shift);
}
