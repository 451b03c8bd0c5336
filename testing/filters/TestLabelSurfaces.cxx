// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "VtkScenes.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkFeatureEdges.h"
#include "vtkHapticConversion.h"
#include "vtkHapticLabelSurfaces.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

namespace palpate::testing::labels
{
namespace
{

template<class Value>
vtkSmartPointer<vtkImageData> image(int size, Value value)
{
  auto made = vtkSmartPointer<vtkImageData>::New();
  made->SetDimensions(size, size, size);
  made->AllocateScalars(VTK_SHORT, 1);
  for (int k = 0; k < size; ++k)
  {
    for (int j = 0; j < size; ++j)
    {
      for (int i = 0; i < size; ++i)
      {
        made->SetScalarComponentFromDouble(i, j, k, 0, value(i, j, k));
      }
    }
  }
  return made;
}

vtkIdType openEdges(vtkPolyData* surface)
{
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(surface);
  edges->FeatureEdgesOff();
  edges->ManifoldEdgesOff();
  edges->Update();
  return edges->GetOutput()->GetNumberOfCells();
}

vtkPolyData* block(vtkHapticLabelSurfaces* filter, unsigned int number)
{
  return vtkPolyData::SafeDownCast(filter->GetOutput()->GetBlock(number));
}

double volume(vtkPolyData* surface)
{
  return enclosedVolume(*vtkHapticToMesh(surface).Mesh);
}

/// Two boxes that touch, one of them at the border of the image.
vtkSmartPointer<vtkImageData> twoBoxes()
{
  return image(8,
    [](int i, int j, int k)
    {
      const bool within = j >= 2 && j <= 5 && k >= 1 && k <= 3;
      return !within ? 0 : i <= 3 ? 4 : i <= 5 ? 9 : 0;
    });
}

TEST(LabelSurfaces, AreOneClosedSurfaceALabelHalfAVoxelOutsideOfItsVoxels)
{
  vtkNew<vtkHapticLabelSurfaces> filter;
  filter->SetInputData(twoBoxes());
  filter->SetSmoothing(0);
  filter->Update();
  ASSERT_EQ(filter->GetOutput()->GetNumberOfBlocks(), 2u);
  const std::array<std::array<double, 6>, 2> bounds = { { { -0.5, 3.5, 1.5, 5.5, 0.5, 3.5 },
    { 3.5, 5.5, 1.5, 5.5, 0.5, 3.5 } } };
  for (unsigned int n = 0; n < 2; ++n)
  {
    EXPECT_EQ(openEdges(block(filter, n)), 0);
    const double* found = block(filter, n)->GetBounds();
    for (std::size_t end = 0; end < 6; ++end)
    {
      EXPECT_EQ(found[end], bounds[n][end]) << n << end;
    }
    EXPECT_GT(volume(block(filter, n)), 0.0);
    EXPECT_EQ(block(filter, n)->GetCellData()->GetArray("Label")->GetComponent(0, 0), n == 0 ? 4.0 : 9.0);
  }
  EXPECT_STREQ(filter->GetOutput()->GetMetaData(1u)->Get(vtkCompositeDataSet::NAME()), "label 9");
}

TEST(LabelSurfaces, StandWhereAMirroredImageIsAndStayOutsideOut)
{
  const auto boxes = twoBoxes();
  boxes->SetOrigin(100, 0, 0);
  boxes->SetSpacing(2, 2, 2);
  boxes->SetDirectionMatrix(-1, 0, 0, 0, 1, 0, 0, 0, 1);
  vtkNew<vtkHapticLabelSurfaces> filter;
  filter->SetInputData(boxes);
  filter->SetSmoothing(0);
  filter->Update();
  EXPECT_EQ(block(filter, 1)->GetBounds()[0], 100 - 2 * 5.5);
  EXPECT_EQ(block(filter, 1)->GetBounds()[1], 100 - 2 * 3.5);
  EXPECT_GT(volume(block(filter, 1)), 0.0);
}

TEST(LabelSurfaces, SmoothingBringsAVoxelBallNearerToTheBallAndKeepsItsVolume)
{
  const double radius = 12.0;
  const auto ball =
    image(32, [=](int i, int j, int k) { return std::hypot(i - 15.5, j - 15.5, k - 15.5) <= radius ? 1 : 0; });
  const auto judge = [&](int rounds)
  {
    vtkNew<vtkHapticLabelSurfaces> filter;
    filter->SetInputData(ball);
    filter->SetSmoothing(rounds);
    filter->Update();
    vtkPolyData* surface = block(filter, 0);
    double sum2 = 0.0;
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      const double off = (Vec3(surface->GetPoint(i)) - Vec3::Constant(15.5)).norm() - radius;
      sum2 += off * off;
    }
    EXPECT_EQ(openEdges(surface), 0);
    EXPECT_NEAR(volume(surface), 4.0 / 3.0 * M_PI * std::pow(radius, 3), 0.03 * 4.0 / 3.0 * M_PI * std::pow(radius, 3));
    return std::sqrt(sum2 / static_cast<double>(surface->GetNumberOfPoints()));
  };
  EXPECT_LT(judge(20), 0.7 * judge(0));
}

TEST(LabelSurfaces, AnImageThatIsNoLabelMapIsRefused)
{
  vtkNew<vtkImageData> densities;
  densities->SetDimensions(3, 3, 3);
  densities->AllocateScalars(VTK_FLOAT, 1);
  for (int i = 0; i < 27; ++i)
  {
    densities->SetScalarComponentFromDouble(i % 3, i / 3 % 3, i / 9, 0, 0.5 * i);
  }
  vtkNew<vtkImageData> none;
  none->SetDimensions(3, 3, 3);
  const auto every = image(20, [](int i, int j, int k) { return i + 20 * j + 400 * k; });
  for (const auto& [input, says] : { std::pair<vtkImageData*, const char*>{ densities, "not integers" },
         std::pair<vtkImageData*, const char*>{ none, "no active array" },
         std::pair<vtkImageData*, const char*>{ every.Get(), "more than 4096 values" } })
  {
    vtkNew<vtkHapticLabelSurfaces> filter;
    filter->SetInputData(input);
    const auto errors = errorsOf(filter);
    ASSERT_FALSE(errors.empty());
    EXPECT_NE(errors.front().find(says), std::string::npos) << errors.front();
  }
}

} // namespace
} // namespace palpate::testing::labels
