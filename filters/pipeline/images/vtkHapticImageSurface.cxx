// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticImageSurface.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkHapticFileGuards.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMatrix4x4.h"
#include "vtkNIFTIImageReader.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"
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

/// The header's line from stored to real values.
struct Rescale
{
  double Slope = 1.0;
  double Intercept = 0.0;
};

void CheckIso(vtkDataArray* scalars, double storedIso, const Rescale& rescale)
{
  double range[2] = { 0.0, 0.0 };
  scalars->GetFiniteRange(range, 0);
  if (!(storedIso > range[0] && storedIso <= range[1]))
  {
    const double ends[2] = { rescale.Slope * range[0] + rescale.Intercept,
      rescale.Slope * range[1] + rescale.Intercept };
    std::ostringstream message;
    message << "the iso value " << rescale.Slope * storedIso + rescale.Intercept
            << " meets no surface; the image holds values from " << std::min(ends[0], ends[1]) << " to "
            << std::max(ends[0], ends[1]) << ", choose --iso between them";
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

void CheckRoom(vtkAlgorithm* reader, const std::string& path, double bytesPerVoxel, bool compressed)
{
  int extent[6] = { 0, -1, 0, -1, 0, -1 };
  reader->GetOutputInformation(0)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  const int dimensions[3] = { extent[1] - extent[0] + 1, extent[3] - extent[2] + 1, extent[5] - extent[4] + 1 };
  ThrowIf(vtkHapticFileGuards::CheckImageBytes(path, dimensions, bytesPerVoxel, compressed));
}

/// Where the header says the image is: voxel coordinates of the reader to the space of the scanner or atlas.
vtkSmartPointer<vtkPolyData> Place(vtkPolyData* surface, vtkMatrix4x4* matrix)
{
  vtkNew<vtkTransform> transform;
  transform->SetMatrix(matrix);
  vtkNew<vtkTransformPolyDataFilter> filter;
  filter->SetTransform(transform);
  filter->SetInputData(surface);
  filter->Update();
  return filter->GetOutput();
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
  CheckIso(scalars, iso, Rescale());
  return Contour(image, iso);
}

vtkSmartPointer<vtkPolyData> vtkHapticImageSurface::ReadNIfTI(const std::string& path, double iso, std::string& note)
{
  ThrowIf(vtkHapticFileGuards::CheckNIfTIType(path));
  vtkNew<vtkNIFTIImageReader> reader;
  if (!reader->CanReadFile(path.c_str()))
  {
    throw std::runtime_error("it is not a NIfTI image, or its header is cut short");
  }
  reader->SetFileName(path.c_str());
  reader->UpdateInformation();
  const double voxelBytes = vtkDataArray::GetDataTypeSize(reader->GetDataScalarType()) *
                            static_cast<double>(reader->GetNumberOfScalarComponents());
  CheckRoom(reader, path, voxelBytes, path.ends_with(".gz") || path.ends_with(".GZ"));
  reader->Update();
  vtkDataArray* scalars = ScalarsOf(reader->GetOutput());
  const double slope = reader->GetRescaleSlope();
  const Rescale rescale{ slope != 0.0 ? slope : 1.0, slope != 0.0 ? reader->GetRescaleIntercept() : 0.0 };
  const double storedIso = (iso - rescale.Intercept) / rescale.Slope;
  CheckIso(scalars, storedIso, rescale);
  if (reader->GetTimeDimension() > 1)
  {
    note = "it holds " + std::to_string(reader->GetTimeDimension()) + " images; the first is touched";
  }
  vtkSmartPointer<vtkPolyData> surface = Contour(reader->GetOutput(), storedIso);
  vtkMatrix4x4* matrix = reader->GetSFormMatrix() ? reader->GetSFormMatrix() : reader->GetQFormMatrix();
  return matrix ? Place(surface, matrix) : surface;
}
