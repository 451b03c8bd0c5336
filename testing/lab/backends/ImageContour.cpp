// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/lab/backends/ImageContour.h"

#ifdef PALPATE_LAB_FILTERS
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkImageCurves.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#endif

namespace palpate::lab
{
namespace
{

#ifdef PALPATE_LAB_FILTERS
std::vector<std::vector<Vec3>> curvesOf(vtkPolyData* data)
{
  std::vector<std::vector<Vec3>> curves;
  vtkIdType count = 0;
  const vtkIdType* points = nullptr;
  for (data->GetLines()->InitTraversal(); data->GetLines()->GetNextCell(count, points);)
  {
    curves.emplace_back(static_cast<std::size_t>(count));
    for (vtkIdType i = 0; i < count; ++i)
    {
      data->GetPoint(points[i], curves.back()[static_cast<std::size_t>(i)].data());
    }
  }
  return curves;
}

std::vector<std::vector<Vec3>> contour(int size, const std::function<double(double, double)>& field, double tolerance_u)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(size, size, 1);
  vtkNew<vtkDoubleArray> values;
  for (int y = 0; y < size; ++y)
  {
    for (int x = 0; x < size; ++x)
    {
      values->InsertNextValue(field(x, y));
    }
  }
  image->GetPointData()->SetScalars(values);
  vtkNew<vtkImageCurves> curves;
  curves->SetInputData(image);
  curves->UseMiddleOff();
  curves->SetValue(0.0);
  curves->SetTolerance(tolerance_u);
  curves->Update();
  return curvesOf(curves->GetOutput());
}

constexpr ImageContour ours = contour;
#else
constexpr ImageContour ours = nullptr;
#endif

} // namespace

ImageContour imageContour()
{
  return ours;
}

} // namespace palpate::lab
