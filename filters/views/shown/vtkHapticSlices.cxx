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
#include "vtkPoints.h"
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
/// Which index of the image the mapper takes for x, for y and for z where it draws in the plane of x and y: those of
/// spacing, origin and direction stay, so that it may be drawn longer than it is.
const int* TakenFor(vtkImageData& image)
{
  static constexpr int acrossZ[] = { 0, 1, 2 }, acrossX[] = { 1, 2, 0 }, acrossY[] = { 2, 0, 1 };
  const int* const e = image.GetExtent();
  return e[4] == e[5] ? acrossZ : e[0] == e[1] ? acrossX : acrossY;
}

/// From their place to where the mapper draws them with Use XY Plane.
void PutFlat(vtkPoints& points, vtkImageData& image)
{
  const int* const taken = TakenFor(image);
  for (vtkIdType point = 0; point < points.GetNumberOfPoints(); ++point)
  {
    double p[3], index[3];
    image.TransformPhysicalPointToContinuousIndex(points.GetPoint(point), index);
    const double flat[3] = { index[taken[0]], index[taken[1]], index[taken[2]] };
    image.TransformContinuousIndexToPhysicalPoint(flat, p);
    points.SetPoint(point, p[0], p[1], 0.0);
  }
}
} // namespace

vtkHapticShape vtkHapticSliceOf(vtkPVImageSliceMapper* mapper)
{
  vtkHapticShape result;
  vtkImageData* const image = ImageOf(*mapper);
  const char* const array = ColouredBy(*mapper);
  if (!array || !image->GetPointData()->GetArray(array))
  {
    result.Problem = "a slice is touched by the contour of its colour array; colour the slice by a point array";
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
  if (mapper->GetUseXYPlane())
  {
    PutFlat(*curves->GetOutput()->GetPoints(), *image);
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
