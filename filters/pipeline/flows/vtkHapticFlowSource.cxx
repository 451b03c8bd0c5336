// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticFlowSource.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "vtkAlgorithm.h"
#include "vtkDoubleArray.h"
#include "vtkHapticFlows.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkHapticFlowSource);

using Pipeline = vtkStreamingDemandDrivenPipeline;
using palpate::Vec3;

namespace
{
constexpr double secondsPerStep = 0.05;
constexpr double mostVoxels = 1e7; // that are cut into tetrahedra: some 2.5 GB

/// The six tetrahedra round the diagonal of a voxel: each goes along the axes in another order, so that neighbours
/// share whole faces.
constexpr int orders[6][3] = { { 0, 1, 2 }, { 1, 2, 0 }, { 2, 0, 1 }, { 0, 2, 1 }, { 2, 1, 0 }, { 1, 0, 2 } };

/// Corners of a tetrahedron, turned so that it is not inside out.
std::array<vtkIdType, 4> Corners(vtkIdType low, const int order[3], const vtkIdType strides[3], bool turned)
{
  std::array<vtkIdType, 4> corners{ low };
  for (std::size_t i = 0; i < 3; ++i)
  {
    corners[i + 1] = corners[i] + strides[order[i]];
  }
  if (turned)
  {
    std::swap(corners[0], corners[1]);
  }
  return corners;
}
} // namespace

vtkHapticFlowSource::vtkHapticFlowSource()
{
  this->SetNumberOfInputPorts(0);
}

void vtkHapticFlowSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Flow: " << vtkHapticFlows::All()[static_cast<std::size_t>(this->Flow)].Name << '\n';
  os << indent << "Cells: " << (this->Cells == Image ? "image" : "tetrahedra") << '\n';
  os << indent << "Resolution: " << this->Resolution << '\n';
}

int vtkHapticFlowSource::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataSet");
  return 1;
}

int vtkHapticFlowSource::RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  vtkDataObject* const had = vtkDataObject::GetData(output);
  if (!had || had->IsA("vtkImageData") != (this->Cells == Image))
  {
    vtkSmartPointer<vtkDataObject> made;
    if (this->Cells == Image)
    {
      made = vtkSmartPointer<vtkImageData>::New();
    }
    else
    {
      made = vtkSmartPointer<vtkUnstructuredGrid>::New();
    }
    output->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(), made);
  }
  return 1;
}

void vtkHapticFlowSource::WholeExtent(int extent[6]) const
{
  const vtkHapticFlow& flow = vtkHapticFlows::All()[static_cast<std::size_t>(this->Flow)];
  const Vec3 edges = flow.High - flow.Low;
  for (int k = 0; k < 3; ++k)
  {
    extent[2 * k] = 0;
    extent[2 * k + 1] =
      std::max(1, static_cast<int>(std::lround((this->Resolution - 1) * edges[k] / edges.maxCoeff())));
  }
}

int vtkHapticFlowSource::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  vtkInformation* const info = output->GetInformationObject(0);
  int extent[6];
  this->WholeExtent(extent);
  info->Set(Pipeline::WHOLE_EXTENT(), extent, 6);
  info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  info->Remove(Pipeline::TIME_STEPS());
  info->Remove(Pipeline::TIME_RANGE());
  if (const double duration = vtkHapticFlows::All()[static_cast<std::size_t>(this->Flow)].Duration; duration > 0.0)
  {
    std::vector<double> times;
    for (int i = 0; i <= std::lround(duration / secondsPerStep); ++i)
    {
      times.push_back(secondsPerStep * i);
    }
    double range[2] = { 0.0, duration };
    info->Set(Pipeline::TIME_STEPS(), times.data(), static_cast<int>(times.size()));
    info->Set(Pipeline::TIME_RANGE(), range, 2);
  }
  return 1;
}

void vtkHapticFlowSource::FillImage(const int extent[6], double time, vtkImageData* image) const
{
  const vtkHapticFlow& flow = vtkHapticFlows::All()[static_cast<std::size_t>(this->Flow)];
  int whole[6];
  this->WholeExtent(whole);
  image->SetExtent(const_cast<int*>(extent));
  image->SetOrigin(flow.Low.data());
  image->SetSpacing((flow.High.x() - flow.Low.x()) / whole[1], (flow.High.y() - flow.Low.y()) / whole[3],
    (flow.High.z() - flow.Low.z()) / whole[5]);
  vtkNew<vtkDoubleArray> velocity, speed;
  velocity->SetName("Velocity");
  velocity->SetNumberOfComponents(3);
  speed->SetName("Speed");
  for (vtkDoubleArray* array : { velocity.Get(), speed.Get() })
  {
    array->SetNumberOfTuples(image->GetNumberOfPoints());
    image->GetPointData()->AddArray(array);
  }
  image->GetPointData()->SetActiveVectors("Velocity");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const Vec3 v = flow.Velocity(Vec3(image->GetPoint(i)), time);
    velocity->SetTuple(i, v.data());
    speed->SetValue(i, v.norm());
  }
}

void vtkHapticFlowSource::FillTetrahedra(vtkImageData* image, vtkUnstructuredGrid* grid)
{
  const int* const size = image->GetDimensions();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    points->SetPoint(i, image->GetPoint(i));
  }
  grid->SetPoints(points);
  grid->GetPointData()->ShallowCopy(image->GetPointData());
  grid->Allocate(6 * image->GetNumberOfCells());
  const vtkIdType strides[3] = { 1, size[0], static_cast<vtkIdType>(size[0]) * size[1] };
  for (int k = 0; k + 1 < size[2]; ++k)
  {
    for (int j = 0; j + 1 < size[1]; ++j)
    {
      for (int i = 0; i + 1 < size[0]; ++i)
      {
        for (int order = 0; order < 6; ++order)
        {
          const auto corners = Corners(i + j * strides[1] + k * strides[2], orders[order], strides, order >= 3);
          grid->InsertNextCell(VTK_TETRA, 4, corners.data());
        }
      }
    }
  }
}

int vtkHapticFlowSource::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  vtkInformation* const info = output->GetInformationObject(0);
  vtkDataObject* const data = vtkDataObject::GetData(output);
  const double time = info->Has(Pipeline::UPDATE_TIME_STEP()) ? info->Get(Pipeline::UPDATE_TIME_STEP()) : 0.0;
  data->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
  if (auto* const image = vtkImageData::SafeDownCast(data))
  {
    this->FillImage(info->Get(Pipeline::UPDATE_EXTENT()), time, image);
    return 1;
  }
  if (info->Get(Pipeline::UPDATE_PIECE_NUMBER()) > 0)
  {
    return 1; // the first piece has all of them
  }
  int whole[6];
  this->WholeExtent(whole);
  const double voxels = static_cast<double>(whole[1]) * whole[3] * whole[5];
  if (voxels > mostVoxels)
  {
    vtkErrorMacro("There is no flow: " << 6.0 * voxels << " tetrahedra are too many; use a lower resolution.");
    return 0;
  }
  vtkNew<vtkImageData> image;
  this->FillImage(whole, time, image);
  this->FillTetrahedra(image, vtkUnstructuredGrid::SafeDownCast(data));
  return 1;
}
