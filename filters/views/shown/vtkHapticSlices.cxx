// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticSlices.h"

#include <functional>

#include "haptics/core/WordHash.h"
#include "vtkHapticMessageCapture.h"
#include "vtkImageCurves.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPVImageSliceMapper.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace
{
/// Null: it is coloured by no array of points.
const char* ColouredBy(vtkPVImageSliceMapper& mapper)
{
  return mapper.GetScalarMode() == VTK_SCALAR_MODE_USE_POINT_FIELD_DATA ? mapper.GetArrayName() : nullptr;
}

vtkImageData* ImageOf(vtkPVImageSliceMapper& mapper)
{
  return vtkImageData::SafeDownCast(mapper.GetInputDataObject(0, 0));
}
} // namespace

vtkHapticShape vtkHapticSliceOf(vtkPVImageSliceMapper* mapper)
{
  vtkHapticShape result;
  vtkImageData* const image = ImageOf(*mapper);
  const char* const array = ColouredBy(*mapper);
  if (!array || !image->GetPointData()->GetArray(array))
  {
    result.Problem = "a slice is felt by the contour of the array that colours it; colour it by an array of points";
    return result;
  }
  if (mapper->GetUseXYPlane())
  {
    result.Problem = "the slice is drawn in the plane of x and y, not in its place; switch Use XY Plane off";
    return result;
  }
  vtkNew<vtkImageCurves> curves;
  curves->SetInputData(image);
  curves->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, array);
  const vtkHapticMessageCapture messages;
  curves->Update();
  if (!messages.FirstError().empty())
  {
    result.Problem = messages.FirstError();
    return result;
  }
  result.Data = curves->GetOutput();
  return result;
}

std::uint64_t vtkHapticSliceKey(vtkPVImageSliceMapper* mapper)
{
  palpate::WordHash hash;
  const char* const array = ColouredBy(*mapper);
  vtkImageData* const image = ImageOf(*mapper);
  hash.add(static_cast<std::uint64_t>(std::hash<std::string>()(array ? array : "")));
  hash.add(static_cast<std::uint64_t>(mapper->GetUseXYPlane()));
  hash.add(static_cast<std::uint64_t>(reinterpret_cast<std::uintptr_t>(image)));
  hash.add(static_cast<std::uint64_t>(image->GetMTime()));
  return hash.value();
}
