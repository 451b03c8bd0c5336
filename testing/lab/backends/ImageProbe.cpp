// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/lab/backends/ImageProbe.h"

#ifdef PALPATE_LAB_PROBE
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkImageInterpolator.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#endif

namespace palpate::lab
{
namespace
{

#ifdef PALPATE_LAB_PROBE
ImageProbe probeOf(const GridIndex& size, const std::vector<float>& values)
{
  vtkNew<vtkFloatArray> array;
  constexpr int kept = 1; // VTK reads it and frees nothing
  array->SetArray(const_cast<float*>(values.data()), static_cast<vtkIdType>(values.size()), kept);
  vtkNew<vtkImageData> image;
  image->SetDimensions(size.data());
  image->GetPointData()->SetScalars(array);
  auto interpolator = vtkSmartPointer<vtkImageInterpolator>::New();
  interpolator->SetInterpolationModeToLinear();
  interpolator->Initialize(image);
  interpolator->Update();
  return [interpolator](const Vec3& index)
  {
    double value = 0.0;
    interpolator->InterpolateIJK(index.data(), &value);
    return value;
  };
}

constexpr ImageProbeMaker made = probeOf;
#else
constexpr ImageProbeMaker made = nullptr;
#endif

} // namespace

ImageProbeMaker imageProbe()
{
  return made;
}

} // namespace palpate::lab
