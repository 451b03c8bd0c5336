// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>

#include "haptics/core/Types.h"
#include "vtkDataArray.h"
#include "vtkImageCurves.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

namespace palpate::testing
{

/// An image of these points, its values a function of where they are.
inline vtkSmartPointer<vtkImageData> imageOf(
  std::array<int, 6> extent, const std::function<double(const Vec3&)>& value,
  const std::function<void(vtkImageData*)>& place = [](vtkImageData*) {}, int type = VTK_DOUBLE, int components = 1)
{
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(extent.data());
  place(image);
  image->AllocateScalars(type, components);
  vtkDataArray* values = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    Vec3 p_W;
    image->GetPoint(i, p_W.data());
    for (int component = 0; component < components; ++component)
    {
      values->SetComponent(i, component, value(p_W));
    }
  }
  return image;
}

inline vtkSmartPointer<vtkImageData> squareImage(
  int size, const std::function<double(const Vec3&)>& value, int type = VTK_DOUBLE, int components = 1)
{
  return imageOf(
    { 0, size - 1, 0, size - 1, 0, 0 }, value, [](vtkImageData*) {}, type, components);
}

inline vtkSmartPointer<vtkImageCurves> filterOf(vtkImageData* image, int kind = vtkImageCurves::Contour)
{
  const auto filter = vtkSmartPointer<vtkImageCurves>::New();
  filter->SetInputData(image);
  filter->SetKind(kind);
  return filter;
}

} // namespace palpate::testing
