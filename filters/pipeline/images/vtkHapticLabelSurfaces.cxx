// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticLabelSurfaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <stdexcept>

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkHapticPieces.h"
#include "vtkHapticWholeInput.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkReverseSense.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindowedSincPolyDataFilter.h"

vtkStandardNewMacro(vtkHapticLabelSurfaces);

namespace
{
using SurfacePointer = vtkSmartPointer<vtkPolyData>;

/// The voxels that a label lies within, both ends included.
struct Extent
{
  std::array<int, 3> Low;
  std::array<int, 3> High;

  void Include(const std::array<int, 3>& voxel)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->Low[axis] = std::min(this->Low[axis], voxel[axis]);
      this->High[axis] = std::max(this->High[axis], voxel[axis]);
    }
  }
};

/// Calls visit(voxel, number of it) from `low` to `high`, both ends included.
template<class Visit>
void ForEachVoxel(const std::array<int, 3>& low, const std::array<int, 3>& high, vtkImageData* image, Visit visit)
{
  for (int k = low[2]; k <= high[2]; ++k)
  {
    for (int j = low[1]; j <= high[1]; ++j)
    {
      for (int i = low[0]; i <= high[0]; ++i)
      {
        std::array<int, 3> voxel = { i, j, k };
        visit(voxel, image->ComputePointId(voxel.data()));
      }
    }
  }
}

Extent WholeOf(vtkImageData* image)
{
  int extent[6];
  image->GetExtent(extent);
  return { { extent[0], extent[2], extent[4] }, { extent[1], extent[3], extent[5] } };
}

/// Where each value is; throws the fault of an image that is no label map.
std::map<double, Extent> ExtentsOf(vtkImageData* image, vtkDataArray* labels, double background)
{
  constexpr std::size_t most = 4096; // atlases have a few hundred, an image of densities any number
  std::map<double, Extent> extents;
  const Extent whole = WholeOf(image);
  ForEachVoxel(whole.Low, whole.High, image,
    [&](const std::array<int, 3>& voxel, vtkIdType id)
    {
      const double value = labels->GetComponent(id, 0);
      if (value == background || std::isnan(value))
      {
        return;
      }
      if (value != std::floor(value))
      {
        throw std::runtime_error("the values are not integers; a label map has one integer per part");
      }
      extents.try_emplace(value, Extent{ voxel, voxel }).first->second.Include(voxel);
      if (extents.size() > most)
      {
        throw std::runtime_error("it has more than " + std::to_string(most) + " values; not a label map");
      }
    });
  return extents;
}

/// The surface of one label in voxels of the image, from a copy of its box with a rim of other voxels.
SurfacePointer SurfaceOf(vtkImageData* image, vtkDataArray* labels, double value, const Extent& extent)
{
  vtkNew<vtkImageData> part;
  part->SetExtent(extent.Low[0] - 1, extent.High[0] + 1, extent.Low[1] - 1, extent.High[1] + 1, extent.Low[2] - 1,
    extent.High[2] + 1);
  part->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* inside = vtkUnsignedCharArray::SafeDownCast(part->GetPointData()->GetScalars());
  inside->FillValue(0);
  ForEachVoxel(extent.Low, extent.High, image,
    [&](std::array<int, 3> voxel, vtkIdType id)
    { inside->SetValue(part->ComputePointId(voxel.data()), labels->GetComponent(id, 0) == value ? 1 : 0); });
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(part);
  contour->SetValue(0, 0.5);
  contour->ComputeNormalsOff();
  contour->ComputeScalarsOff();
  contour->Update();
  return contour->GetOutput();
}

SurfacePointer Smoothed(vtkPolyData* surface, int rounds)
{
  constexpr double passBand = 0.1; // of the frequencies of the mesh: steps of a voxel go, wider features stay
  vtkNew<vtkWindowedSincPolyDataFilter> smoother;
  smoother->SetInputData(surface);
  smoother->SetNumberOfIterations(rounds);
  smoother->SetPassBand(passBand);
  smoother->NormalizeCoordinatesOn();
  smoother->Update();
  return smoother->GetOutput();
}

/// From voxels to the space of the image, outside out.
SurfacePointer Placed(vtkPolyData* surface, vtkImageData* image)
{
  vtkNew<vtkTransform> transform;
  transform->SetMatrix(image->GetIndexToPhysicalMatrix());
  vtkNew<vtkTransformPolyDataFilter> place;
  place->SetTransform(transform);
  place->SetInputData(surface);
  place->Update();
  if (image->GetIndexToPhysicalMatrix()->Determinant() > 0.0)
  {
    return place->GetOutput();
  }
  vtkNew<vtkReverseSense> turn;
  turn->SetInputData(place->GetOutput());
  turn->Update();
  return turn->GetOutput();
}

void AddLabel(vtkPolyData* surface, double value)
{
  vtkNew<vtkDoubleArray> label;
  label->SetName("Label");
  label->SetNumberOfValues(surface->GetNumberOfCells());
  label->FillValue(value);
  surface->GetCellData()->AddArray(label);
}

vtkDataArray* LabelsOf(vtkImageData* image)
{
  vtkDataArray* const labels = image->GetPointData()->GetScalars();
  if (!labels || labels->GetNumberOfComponents() != 1)
  {
    throw std::runtime_error("the image has no active array with one value per voxel");
  }
  return labels;
}
} // namespace

vtkHapticLabelSurfaces::vtkHapticLabelSurfaces() = default;

vtkHapticLabelSurfaces::~vtkHapticLabelSurfaces() = default;

void vtkHapticLabelSurfaces::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Background: " << this->Background << '\n';
  os << indent << "Smoothing: " << this->Smoothing << '\n';
}

int vtkHapticLabelSurfaces::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkHapticLabelSurfaces::RequestUpdateExtent(vtkInformation*, vtkInformationVector** input, vtkInformationVector*)
{
  vtkHapticAskForWholeImage(input[0]);
  return 1;
}

int vtkHapticLabelSurfaces::RequestData(vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  if (const std::string refusal = vtkHapticRefusePieces(output); !refusal.empty())
  {
    vtkErrorMacro("Nothing is measured: " << refusal);
    return 0;
  }
  if (vtkHapticRank() > 0)
  {
    return 1; // the first rank has the surfaces
  }
  vtkImageData* const image = vtkImageData::GetData(input[0]);
  vtkMultiBlockDataSet* const blocks = vtkMultiBlockDataSet::GetData(output);
  try
  {
    vtkDataArray* const labels = LabelsOf(image);
    const std::map<double, Extent> extents = ExtentsOf(image, labels, this->Background);
    unsigned int number = 0;
    for (const auto& [value, extent] : extents)
    {
      this->UpdateProgress(static_cast<double>(number) / static_cast<double>(extents.size()));
      SurfacePointer surface = SurfaceOf(image, labels, value, extent);
      surface = Placed(this->Smoothing > 0 ? Smoothed(surface, this->Smoothing) : surface, image);
      AddLabel(surface, value);
      std::ostringstream name;
      name << "label " << value;
      blocks->SetBlock(number, surface);
      blocks->GetMetaData(number++)->Set(vtkCompositeDataSet::NAME(), name.str().c_str());
    }
  }
  catch (const std::runtime_error& problem)
  {
    vtkErrorMacro("The image gives no surfaces of labels: " << problem.what());
    return 0;
  }
  return 1;
}
