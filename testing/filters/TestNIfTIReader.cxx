// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>

#include <gtest/gtest.h>

#include "NIfTIBytes.h"
#include "VtkScenes.h"
#include "testing/support/Random.h"
#include "testing/support/TemporaryFolder.h"
#include "vtkDataArray.h"
#include "vtkHapticNIfTIReader.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMatrix4x4.h"
#include "vtkNIFTIImageReader.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

namespace palpate::testing::nifti
{
namespace
{

struct Form
{
  int version;
  bool bigEndian;
};
constexpr std::array forms = { Form{ 1, false }, Form{ 1, true }, Form{ 2, false }, Form{ 2, true } };

/// The image in a file, and the reader's errors if there is none.
struct Read
{
  vtkNew<vtkHapticNIfTIReader> reader;
  std::vector<std::string> errors;

  explicit Read(const std::string& path)
  {
    this->reader->SetFileName(path.c_str());
    this->errors = errorsOf(this->reader);
  }
  [[nodiscard]] vtkImageData* image() { return this->reader->GetOutput(); }
  [[nodiscard]] vtkDataArray* values() { return this->image()->GetPointData()->GetScalars(); }
  [[nodiscard]] std::string problem() const { return this->errors.empty() ? "" : this->errors.front(); }
};

template<class Value>
void expectReadsExactly(std::int16_t code, int vtkType)
{
  using Limits = std::numeric_limits<Value>;
  const std::array<Value, 6> stored = { Limits::min(), Limits::max(), Value{ 0 }, Value{ 1 }, Value{ 77 },
    static_cast<Value>(Limits::max() / 3) };
  const test::TemporaryFolder folder;
  for (const Form& form : forms)
  {
    NIfTIBytes file(form.version, form.bigEndian);
    file.setDim({ 1, 2, 3 });
    file.setType(code);
    for (const Value value : stored)
    {
      file.add(value);
    }
    file.write(folder.file("a.nii"));
    Read read(folder.file("a.nii"));
    ASSERT_TRUE(read.values()) << read.problem();
    ASSERT_EQ(read.values()->GetDataType(), vtkType) << code;
    for (std::size_t i = 0; i < stored.size(); ++i)
    {
      const Value got = static_cast<const Value*>(read.values()->GetVoidPointer(0))[i];
      EXPECT_EQ(got, stored[i]) << "type " << code << " version " << form.version << " big " << form.bigEndian;
    }
  }
}

TEST(NIfTIReader, EveryTypeOfNumberIsReadToTheBitInBothVersionsAndByteOrders)
{
  expectReadsExactly<std::uint8_t>(2, VTK_UNSIGNED_CHAR);
  expectReadsExactly<std::int16_t>(4, VTK_SHORT);
  expectReadsExactly<std::int32_t>(8, VTK_INT);
  expectReadsExactly<float>(16, VTK_FLOAT);
  expectReadsExactly<double>(64, VTK_DOUBLE);
  expectReadsExactly<std::int8_t>(256, VTK_SIGNED_CHAR);
  expectReadsExactly<std::uint16_t>(512, VTK_UNSIGNED_SHORT);
  expectReadsExactly<std::uint32_t>(768, VTK_UNSIGNED_INT);
  expectReadsExactly<long long>(1024, VTK_LONG_LONG);
  expectReadsExactly<unsigned long long>(1280, VTK_UNSIGNED_LONG_LONG);
}

TEST(NIfTIReader, ColoursAndComplexNumbersAreComponents)
{
  struct Case
  {
    std::int16_t code;
    int components;
    int bytes;
  };
  const test::TemporaryFolder folder;
  for (const Case& each : { Case{ 128, 3, 1 }, Case{ 2304, 4, 1 }, Case{ 32, 2, 4 }, Case{ 1792, 2, 8 } })
  {
    NIfTIBytes file(1, true);
    file.setDim({ 2, 1, 1 });
    file.setType(each.code);
    file.setSlope(each.bytes == 1 ? 3.0 : 0.0, 5.0); // no colour is rescaled
    for (int i = 0; i < 2 * each.components; ++i)
    {
      each.bytes == 1   ? file.add(static_cast<std::uint8_t>(10 + i))
      : each.bytes == 4 ? file.add(static_cast<float>(10 + i))
                        : file.add(static_cast<double>(10 + i));
    }
    file.write(folder.file("a.nii"));
    Read read(folder.file("a.nii"));
    ASSERT_TRUE(read.values()) << read.problem();
    ASSERT_EQ(read.values()->GetNumberOfComponents(), each.components);
    for (int i = 0; i < 2 * each.components; ++i)
    {
      EXPECT_EQ(read.values()->GetComponent(i / each.components, i % each.components), 10 + i);
    }
  }
}

TEST(NIfTIReader, ValuesAreSlopeTimesWhatIsStoredPlusIntercept)
{
  const test::TemporaryFolder folder;
  for (const Form& form : forms)
  {
    NIfTIBytes file(form.version, form.bigEndian);
    file.setDim({ 3, 1, 1 });
    file.setType(4);
    file.setSlope(0.25, -1024.0);
    for (const std::int16_t value : { -32768, 0, 4096 })
    {
      file.add(value);
    }
    file.write(folder.file("a.nii"));
    Read read(folder.file("a.nii"));
    ASSERT_TRUE(read.values()) << read.problem();
    EXPECT_EQ(read.values()->GetComponent(0, 0), -0.25 * 32768 - 1024); // all of these are floats
    EXPECT_EQ(read.values()->GetComponent(1, 0), -1024);
    EXPECT_EQ(read.values()->GetComponent(2, 0), 0);
  }
}

TEST(NIfTIReader, ASlopeOfZeroMeansWhatIsStored)
{
  const test::TemporaryFolder folder;
  NIfTIBytes file;
  file.setDim({ 1 });
  file.setType(2);
  file.setSlope(0.0, 100.0);
  file.add(std::uint8_t{ 7 });
  file.write(folder.file("a.nii"));
  Read read(folder.file("a.nii"));
  ASSERT_TRUE(read.values()) << read.problem();
  EXPECT_EQ(read.values()->GetComponent(0, 0), 7);
}

NIfTIBytes oneByteEach(const Form& form, const std::array<int, 3>& size)
{
  NIfTIBytes file(form.version, form.bigEndian);
  file.setDim({ size[0], size[1], size[2] });
  file.setType(2);
  for (int i = 0; i < size[0] * size[1] * size[2]; ++i)
  {
    file.add(static_cast<std::uint8_t>(i));
  }
  return file;
}

void expectVoxelsAt(vtkImageData* image, const Mat3& linear, const Vec3& shift, double tolerance)
{
  for (const Vec3& ijk : { Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 3, 0), Vec3(0, 0, 2), Vec3(4, 3, 2) })
  {
    Vec3 at;
    image->TransformContinuousIndexToPhysicalPoint(ijk.data(), at.data());
    const double scale = linear.norm() * ijk.norm() + shift.norm();
    EXPECT_NEAR((at - linear * ijk - shift).norm(), 0.0, tolerance * scale) << ijk.transpose();
  }
}

TEST(NIfTIReader, VoxelsLieWhereAnyInvertibleSFormPutsThemAndItGoesBeforeTheQForm)
{
  const test::TemporaryFolder folder;
  test::Random random(test::testSeed(15));
  for (int round = 0; round < static_cast<int>(test::testCount(20)); ++round)
  {
    for (const Form& form : forms)
    {
      Mat3 linear = Mat3::Identity() * 3.0;
      Vec3 shift;
      for (int k = 0; k < 9; ++k)
      {
        linear(k / 3, k % 3) += random.uniform(-1.0, 1.0); // diagonally dominant: invertible, and sheared
      }
      shift = Vec3(random.uniform(-100, 100), random.uniform(-100, 100), random.uniform(-100, 100));
      linear.col(round % 3) *= round % 2 == 0 ? 1.0 : -1.0;
      NIfTIBytes file = oneByteEach(form, { 5, 4, 3 });
      file.setQForm(Quat(1, 0, 0, 0), Vec3::Zero(), 1.0);
      file.setSForm(linear, shift);
      file.write(folder.file("a.nii"));
      Read read(folder.file("a.nii"));
      ASSERT_EQ(read.errors, std::vector<std::string>());
      expectVoxelsAt(read.image(), linear, shift, form.version == 1 ? 1e-6 : 1e-14);
    }
  }
}

TEST(NIfTIReader, VoxelsLieWhereTheQuaternionTurnsThemWithTheThirdAxisMirroredByANegativeQFac)
{
  const test::TemporaryFolder folder;
  test::Random random(test::testSeed(16));
  const Vec3 spacing(0.5, 1.5, 2.5), shift(10, -20, 30);
  for (int round = 0; round < static_cast<int>(test::testCount(20)); ++round)
  {
    for (const Form& form : forms)
    {
      Quat turn(random.uniform(0, 1), random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
      turn.normalize(); // the file keeps b, c, d; a is not negative
      const double qfac = round % 2 == 0 ? 1.0 : -1.0;
      NIfTIBytes file = oneByteEach(form, { 5, 4, 3 });
      file.setSpacing(spacing);
      file.setQForm(turn, shift, qfac);
      file.write(folder.file("a.nii"));
      Read read(folder.file("a.nii"));
      ASSERT_EQ(read.errors, std::vector<std::string>());
      const Mat3 linear = turn.toRotationMatrix() * Vec3(spacing.x(), spacing.y(), qfac * spacing.z()).asDiagonal();
      // a = sqrt(1 - |bcd|^2) of floats is known to the root of their rounding
      expectVoxelsAt(read.image(), linear, shift, form.version == 1 ? 1e-3 : 1e-7);
    }
  }
}

TEST(NIfTIReader, WithoutAFormSpacingAloneSaysWhereVoxelsAre)
{
  const test::TemporaryFolder folder;
  NIfTIBytes file = oneByteEach({ 1, false }, { 5, 4, 3 });
  file.setSpacing(Vec3(2.0, -3.0, 0.0)); // a sign says nothing, and no length counts as 1
  file.write(folder.file("a.nii"));
  Read read(folder.file("a.nii"));
  ASSERT_EQ(read.errors, std::vector<std::string>());
  expectVoxelsAt(read.image(), Vec3(2, 3, 1).asDiagonal(), Vec3::Zero(), 1e-15);
}

TEST(NIfTIReader, APackedFileIsReadAsWhatIsInIt)
{
  const test::TemporaryFolder folder;
  oneByteEach({ 2, true }, { 9, 8, 3 }).writePacked(folder.file("sub-01.T1.nii.gz"));
  Read read(folder.file("sub-01.T1.nii.gz"));
  ASSERT_TRUE(read.values()) << read.problem();
  ASSERT_EQ(read.values()->GetNumberOfTuples(), 216);
  for (int i = 0; i < 216; ++i)
  {
    EXPECT_EQ(read.values()->GetComponent(i, 0), i);
  }
}

TEST(NIfTIReader, TheFourthDimensionIsTimeAndTheFifthAreComponents)
{
  const test::TemporaryFolder folder;
  NIfTIBytes file;
  file.setDim({ 2, 1, 1, 3, 2 }); // 2 voxels, 3 times, 2 vectors: the fifth is stored slowest
  file.setType(4);
  file.setPixDim(4, 250.0);
  file.setTimeOffset(1000.0);
  file.setUnits(2 + 16); // mm, ms
  const auto valueOf = [](int voxel, int time, int vector) { return voxel + 10 * time + 100 * vector; };
  for (int i = 0; i < 12; ++i)
  {
    file.add(static_cast<std::int16_t>(valueOf(i % 2, i / 2 % 3, i / 6)));
  }
  file.write(folder.file("a.nii"));
  Read read(folder.file("a.nii"));
  ASSERT_TRUE(read.values()) << read.problem();
  vtkInformation* info = read.reader->GetOutputInformation(0);
  const auto timeSteps = vtkStreamingDemandDrivenPipeline::TIME_STEPS();
  ASSERT_EQ(info->Length(timeSteps), 3);
  for (int time = 0; time < 3; ++time)
  {
    EXPECT_DOUBLE_EQ(info->Get(timeSteps, time), 1.0 + 0.25 * time);
    read.reader->UpdateTimeStep(info->Get(timeSteps, time));
    for (int i = 0; i < 4; ++i)
    {
      EXPECT_EQ(read.values()->GetComponent(i / 2, i % 2), valueOf(i / 2, time, i % 2)) << time;
    }
  }
}

TEST(NIfTIReader, ABrainIsWhatVtksReaderSeesAtTheSamePlaces)
{
  const char* elsewhere = std::getenv("PALPATE_DATA");
  const std::string path =
    (std::filesystem::path(elsewhere != nullptr ? elsewhere : PALPATE_DATA_CACHE) / "brain.nii.gz").string();
  if (!std::filesystem::exists(path))
  {
    return; // data/get fetches it
  }
  Read read(path);
  ASSERT_TRUE(read.values()) << read.problem();
  vtkNew<vtkNIFTIImageReader> theirs;
  theirs->SetFileName(path.c_str());
  theirs->Update();
  ASSERT_EQ(theirs->GetOutput()->GetNumberOfPoints(), read.image()->GetNumberOfPoints());
  vtkMatrix4x4* place = theirs->GetSFormMatrix() ? theirs->GetSFormMatrix() : theirs->GetQFormMatrix();
  ASSERT_TRUE(place);
  std::size_t bright = 0;
  for (vtkIdType i = 0; i < read.image()->GetNumberOfPoints(); i += 101)
  {
    double their[4] = { 0, 0, 0, 1 };
    theirs->GetOutput()->GetPoint(i, their);
    place->MultiplyPoint(their, their);
    Vec3 at(their[0], their[1], their[2]), index;
    read.image()->TransformPhysicalPointToContinuousIndex(at.data(), index.data());
    const Vec3 nearest = index.array().round();
    ASSERT_LT((index - nearest).norm(), 1e-3);
    const std::array<int, 3> ijk = { static_cast<int>(nearest[0]), static_cast<int>(nearest[1]),
      static_cast<int>(nearest[2]) };
    const vtkIdType ours = read.image()->ComputePointId(const_cast<int*>(ijk.data()));
    const double value = theirs->GetOutput()->GetPointData()->GetScalars()->GetComponent(i, 0);
    ASSERT_EQ(read.values()->GetComponent(ours, 0), value) << i;
    bright += value > 0.0 ? 1 : 0;
  }
  EXPECT_GT(bright, 1000u);
}

void expectRefused(const NIfTIBytes& file, const std::string& says)
{
  const test::TemporaryFolder folder;
  file.write(folder.file("a.nii"));
  const Read read(folder.file("a.nii"));
  EXPECT_NE(read.problem().find(folder.file("a.nii") + ": "), std::string::npos) << read.problem();
  EXPECT_NE(read.problem().find(says), std::string::npos) << read.problem();
}

TEST(NIfTIReader, WhatCannotBeReadIsRefusedWithTheFileAndTheReason)
{
  const auto good = [] { return oneByteEach({ 1, false }, { 5, 4, 3 }); };
  const auto with = [&](const auto& change)
  {
    NIfTIBytes file = good();
    change(file);
    return file;
  };
  expectRefused(with([](NIfTIBytes& f) { f.setDim({ 5, 4, 300 }); }), "promises an image of 5 x 4 x 300");
  expectRefused(with([](NIfTIBytes& f) { f.setDim({ 5, -4, 3 }); }), "promises -4 voxels along an axis");
  expectRefused(with([](NIfTIBytes& f) { f.setDim(0, 9); }), "promises 9 dimensions");
  expectRefused(with([](NIfTIBytes& f) { f.setDim({ 5, 4, 3, 1, 1, 2 }); }), "more than five dimensions");
  expectRefused(with([](NIfTIBytes& f) { f.setType(1536); }), "NIfTI type 1536");
  expectRefused(with([](NIfTIBytes& f) { f.setVoxOffset(12.0); }), "cannot begin at byte 12");
  expectRefused(with([](NIfTIBytes& f) { f.setSForm(Mat3::Zero(), Vec3::Zero()); }), "is singular");
  expectRefused(with([](NIfTIBytes& f) { f.put(344, 'x'); }), "neither the mark n+1 nor n+2");
  expectRefused(with([](NIfTIBytes& f) { f.put(345, 'i'); }), "in another file");
  expectRefused(with([](NIfTIBytes& f) { f.put(0, 349); }), "not a NIfTI image");
}

TEST(NIfTIReader, AFileCutShortAnywhereIsRefusedInOneLine)
{
  const test::TemporaryFolder folder;
  for (const Form& form : forms)
  {
    const std::vector<char> whole = oneByteEach(form, { 5, 4, 3 }).bytes();
    for (std::size_t length = 0; length < whole.size(); length += 7)
    {
      std::ofstream(folder.file("a.nii"), std::ios::binary).write(whole.data(), static_cast<std::streamsize>(length));
      const Read read(folder.file("a.nii"));
      ASSERT_NE(read.problem().find("a.nii: "), std::string::npos) << length << read.problem();
    }
  }
}

} // namespace
} // namespace palpate::testing::nifti
