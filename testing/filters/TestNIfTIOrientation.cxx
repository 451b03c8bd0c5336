// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cstring>
#include <fstream>

#include <gtest/gtest.h>

#include "haptics/core/Types.h"
#include "testing/support/TemporaryFolder.h"
#include "vtkHapticReaders.h"
#include "vtkPolyData.h"

using palpate::Mat3;
using palpate::Quat;
using palpate::Vec3;

namespace
{
/// Where NIfTI-1 (Cox et al., nifti1.h) puts what is needed here, in bytes from the start of the header.
enum Offset : std::size_t
{
  SizeOfHeader = 0,
  Dim = 40,
  DataType = 70,
  BitPix = 72,
  PixDim = 76,
  VoxOffset = 108,
  SclSlope = 112,
  QFormCode = 252,
  SFormCode = 254,
  Quatern = 256,
  QOffset = 268,
  SRows = 280,
  Magic = 344,
  EndOfHeader = 352,
};

constexpr std::array<int, 3> size = { 12, 10, 8 };
/// The only bright part: a box of voxels well off the middle along every axis, so that no mirror maps it to itself.
constexpr std::array<int, 3> low = { 2, 1, 4 };
constexpr std::array<int, 3> high = { 4, 5, 5 };

struct Header
{
  std::array<char, EndOfHeader> bytes{};

  template<class Value>
  void put(std::size_t at, Value value)
  {
    std::memcpy(this->bytes.data() + at, &value, sizeof(value));
  }

  explicit Header(const Vec3& spacing_mm)
  {
    this->put(SizeOfHeader, std::int32_t{ 348 });
    this->put(Dim, std::int16_t{ 3 });
    this->put(DataType, std::int16_t{ 2 }); // unsigned char
    this->put(BitPix, std::int16_t{ 8 });
    this->put(VoxOffset, 352.0f);
    this->put(SclSlope, 1.0f);
    std::memcpy(this->bytes.data() + Magic, "n+1", 4);
    this->put(PixDim, 1.0f);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->put(Dim + 2 * (axis + 1), static_cast<std::int16_t>(size[axis]));
      this->put(PixDim + 4 * (axis + 1), static_cast<float>(spacing_mm[static_cast<int>(axis)]));
    }
    for (std::size_t more = 4; more < 8; ++more)
    {
      this->put(Dim + 2 * more, std::int16_t{ 1 });
    }
  }

  void setSForm(const Mat3& linear, const Vec3& shift)
  {
    this->put(SFormCode, std::int16_t{ 1 });
    for (int row = 0; row < 3; ++row)
    {
      for (int column = 0; column < 4; ++column)
      {
        const double value = column < 3 ? linear(row, column) : shift[row];
        this->put(
          SRows + 16 * static_cast<std::size_t>(row) + 4 * static_cast<std::size_t>(column), static_cast<float>(value));
      }
    }
  }

  void setQForm(const Quat& q, const Vec3& shift, float qfac)
  {
    this->put(QFormCode, std::int16_t{ 1 });
    this->put(PixDim, qfac);
    const std::array<double, 3> imaginary = { q.x(), q.y(), q.z() };
    for (std::size_t k = 0; k < 3; ++k)
    {
      this->put(Quatern + 4 * k, static_cast<float>(imaginary[k]));
      this->put(QOffset + 4 * k, static_cast<float>(shift[static_cast<int>(k)]));
    }
  }
};

bool inside(int i, int j, int k)
{
  return i >= low[0] && i <= high[0] && j >= low[1] && j <= high[1] && k >= low[2] && k <= high[2];
}

void write(const Header& header, const std::string& path)
{
  std::ofstream file(path, std::ios::binary);
  file.write(header.bytes.data(), header.bytes.size());
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        file.put(inside(i, j, k) ? static_cast<char>(200) : char{ 0 });
      }
    }
  }
}

/// The iso surface of half the brightness lies half a voxel outside the box on all sides, so its bounds have the
/// middle of the box as their centre wherever `linear`, a signed permutation times spacing, puts them.
void expectAt(const Header& header, const Mat3& linear, const Vec3& shift)
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
}

const Vec3 spacing(1.5, 2.0, 2.5);
const Vec3 shift(-90.0, -126.0, 72.0);
} // namespace

TEST(NIfTIOrientation, AnSFormPutsVoxelsWhereItsRowsSay)
{
  Header header(spacing);
  const Mat3 linear = spacing.asDiagonal();
  header.setSForm(linear, shift);
  expectAt(header, linear, shift);
}

TEST(NIfTIOrientation, LeftStaysLeftWhenVoxelsAreStoredFromRightToLeft)
{
  Header header(spacing);
  const Mat3 linear = Vec3(-spacing.x(), spacing.y(), spacing.z()).asDiagonal();
  header.setSForm(linear, Vec3(90.0, -126.0, -72.0));
  expectAt(header, linear, Vec3(90.0, -126.0, -72.0));
}

TEST(NIfTIOrientation, ATurnedSFormSwapsTheAxes)
{
  Header header(spacing);
  Mat3 linear = Mat3::Zero(); // voxel i runs along z, j along -x, k along y
  linear(2, 0) = spacing.x();
  linear(0, 1) = -spacing.y();
  linear(1, 2) = spacing.z();
  header.setSForm(linear, shift);
  expectAt(header, linear, shift);
}

TEST(NIfTIOrientation, AQFormPutsVoxelsWhereItsQuaternionSays)
{
  Header header(spacing);
  header.setQForm(Quat(1.0, 0.0, 0.0, 0.0), shift, 1.0f);
  expectAt(header, spacing.asDiagonal(), shift);
}

TEST(NIfTIOrientation, LeftStaysLeftForAQFormWithANegativeQFac)
{
  Header header(spacing);
  // half a turn around y maps (x, y, z) to (-x, y, -z); qfac -1 turns the third axis back: only x is mirrored
  header.setQForm(Quat(0.0, 0.0, 1.0, 0.0), shift, -1.0f);
  expectAt(header, Vec3(-spacing.x(), spacing.y(), spacing.z()).asDiagonal(), shift);
}

TEST(NIfTIOrientation, TheSFormIsTakenWhenThereAreBoth)
{
  Header header(spacing);
  const Mat3 linear = Vec3(-spacing.x(), spacing.y(), spacing.z()).asDiagonal();
  header.setQForm(Quat(1.0, 0.0, 0.0, 0.0), Vec3::Zero(), 1.0f);
  header.setSForm(linear, shift);
  expectAt(header, linear, shift);
}
