// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticImageSurface.h"

#include <sstream>
#include <stdexcept>

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkHapticFileGuards.h"
#include "vtkHapticNIfTIImage.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkReverseSense.h"
#include "vtkXMLImageDataReader.h"

namespace
{
using vtkHapticFileGuards::ThrowIf;

vtkDataArray* ScalarsOf(vtkImageData* image)
{
  vtkPointData* data = image->GetPointData();
  vtkDataArray* scalars = data->GetScalars();
  if (!scalars && data->GetNumberOfArrays() == 1)
  {
    scalars = data->GetArray(0);
  }
  if (!scalars)
  {
    std::ostringstream message;
    message << "the image has no scalar array on its points (" << data->GetNumberOfArrays() << " arrays on points, "
            << image->GetCellData()->GetNumberOfArrays() << " on cells); give its points one active scalar array";
    throw std::runtime_error(message.str());
  }
  if (scalars->GetNumberOfComponents() != 1)
  {
    throw std::runtime_error("the image has " + std::to_string(scalars->GetNumberOfComponents()) +
                             " values per point; an iso surface needs one");
  }
  return scalars;
}

void CheckIso(vtkDataArray* scalars, double iso)
{
  double range[2] = { 0.0, 0.0 };
  scalars->GetFiniteRange(range, 0);
  if (!(iso > range[0] && iso <= range[1]))
  {
    std::ostringstream message;
    message << "the iso value " << iso << " meets no surface; the image holds values from " << range[0] << " to "
            << range[1] << ", choose --iso between them";
    throw std::runtime_error(message.str());
  }
}

vtkSmartPointer<vtkPolyData> Contour(vtkImageData* image, double iso)
{
  if (image->GetDataDimension() != 3)
  {
    throw std::runtime_error("the image has only one slice; an iso surface needs at least two in each direction");
  }
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(image);
  contour->SetValue(0, iso);
  contour->ComputeNormalsOff();
  contour->ComputeScalarsOff();
  contour->Update();
  return contour->GetOutput();
}

/// A mirrored image would turn its surface inside out.
vtkSmartPointer<vtkPolyData> OutsideOut(vtkPolyData* surface, vtkImageData* image)
{
  if (image->GetDirectionMatrix()->Determinant() > 0.0)
  {
    return surface;
  }
  vtkNew<vtkReverseSense> turn;
  turn->SetInputData(surface);
  turn->Update();
  return turn->GetOutput();
}
} // namespace

vtkSmartPointer<vtkPolyData> vtkHapticImageSurface::ReadVTI(const std::string& path, double iso)
{
  ThrowIf(vtkHapticFileGuards::CheckXMLCounts(path));
  vtkNew<vtkXMLImageDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  vtkDataArray* scalars = ScalarsOf(image);
  image->GetPointData()->SetScalars(scalars);
  CheckIso(scalars, iso);
  return OutsideOut(Contour(image, iso), image);
}

vtkSmartPointer<vtkPolyData> vtkHapticImageSurface::ReadNIfTI(const std::string& path, double iso, std::string& note)
{
  const vtkHapticNIfTIHeader header = vtkHapticNIfTIImage::ReadHeader(path);
  if (header.Type.PerVoxel > 1)
  {
    throw std::runtime_error("its voxels are of NIfTI type " + std::to_string(header.Type.Code) +
                             "; an iso surface needs one real number per voxel");
  }
  const vtkSmartPointer<vtkImageData> image = vtkHapticNIfTIImage::Read(path, header, 0);
  CheckIso(ScalarsOf(image), iso);
  if (header.TimeSteps > 1)
  {
    note = "it holds " + std::to_string(header.TimeSteps) + " images; the first is touched";
  }
  return OutsideOut(Contour(image, iso), image);
}
