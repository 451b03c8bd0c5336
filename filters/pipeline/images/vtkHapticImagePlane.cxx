// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticImagePlane.h"

#include <sstream>
#include <stdexcept>

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkImageExtractComponents.h"
#include "vtkImageLuminance.h"
#include "vtkNew.h"
#include "vtkPointData.h"

namespace
{
/// The two axes along which the image extends.
void FlatAxes(vtkImageData* image, int axes[2])
{
  const int* size = image->GetDimensions();
  int found = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (size[axis] > 1)
    {
      if (found == 2)
      {
        throw std::runtime_error("the image is a volume of " + std::to_string(size[0]) + " x " +
                                 std::to_string(size[1]) + " x " + std::to_string(size[2]) +
                                 " points; cut out one slice first (Extract Subset)");
      }
      axes[found++] = axis;
    }
  }
  if (found < 2)
  {
    throw std::runtime_error("the image is not flat: it has fewer than two rows or columns");
  }
}

void CheckValues(vtkImageData* image, vtkDataArray* values, bool coloursCount)
{
  if (!values)
  {
    throw std::runtime_error(image->GetCellData()->GetNumberOfArrays() > 0
                               ? "the image has values on its cells only; use Cell Data to Point Data first"
                               : "the image has no values on its points");
  }
  const int components = values->GetNumberOfComponents();
  const bool colour = components == 3 || components == 4;
  if (components != 1 && !(colour && coloursCount))
  {
    std::ostringstream message;
    message << "the image has " << components << " values per pixel; "
            << (coloursCount ? "curves need one, or three or four that are colours" : "a label map needs one");
    throw std::runtime_error(message.str());
  }
}

/// One value a pixel from a colour, its transparency left aside.
vtkSmartPointer<vtkDataArray> Luminance(vtkImageData* pixels)
{
  vtkNew<vtkImageExtractComponents> colour;
  colour->SetInputData(pixels);
  colour->SetComponents(0, 1, 2);
  vtkNew<vtkImageLuminance> luminance;
  luminance->SetInputConnection(colour->GetOutputPort());
  luminance->Update();
  return luminance->GetOutput()->GetPointData()->GetScalars();
}
} // namespace

vtkHapticImagePlane::vtkHapticImagePlane(vtkImageData* image, vtkDataArray* values, bool coloursCount)
  : Image(image), Values(values)
{
  FlatAxes(image, this->Axes);
  CheckValues(image, values, coloursCount);
  for (int i = 0; i < 2; ++i)
  {
    this->Size[i] = static_cast<std::uint32_t>(image->GetDimensions()[this->Axes[i]]);
  }
  if (values->GetNumberOfComponents() > 1)
  {
    vtkNew<vtkImageData> pixels;
    pixels->SetDimensions(static_cast<int>(this->Size[0]), static_cast<int>(this->Size[1]), 1);
    pixels->GetPointData()->SetScalars(values);
    this->Values = Luminance(pixels);
  }
}

double vtkHapticImagePlane::GetValue(std::int64_t i, std::int64_t j) const
{
  return this->Values->GetComponent(static_cast<vtkIdType>(j * this->Size[0] + i), 0);
}

void vtkHapticImagePlane::GetRange(double range[2]) const
{
  this->Values->GetFiniteRange(range, 0);
  if (!(range[0] < range[1]))
  {
    std::ostringstream message;
    message << (range[0] == range[1] ? "the image has one colour: all its values are "
                                     : "no value of the image is finite");
    if (range[0] == range[1])
    {
      message << range[0];
    }
    throw std::runtime_error(message.str());
  }
}

palpate::Vec3 vtkHapticImagePlane::ToWorld(double i, double j) const
{
  const int* extent = this->Image->GetExtent();
  double index[3] = { static_cast<double>(extent[0]), static_cast<double>(extent[2]), static_cast<double>(extent[4]) };
  index[this->Axes[0]] += i;
  index[this->Axes[1]] += j;
  palpate::Vec3 p_W;
  this->Image->TransformContinuousIndexToPhysicalPoint(index, p_W.data());
  return p_W;
}

double vtkHapticImagePlane::GetSpacing(int axis) const
{
  return this->Image->GetSpacing()[this->Axes[axis]];
}
