// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticResampledField.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkCellDataToPointData.h"
#include "vtkCompositeDataProbeFilter.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkHapticConversionAhead.h"
#include "vtkHapticFieldError.h"
#include "vtkHapticFinerField.h"
#include "vtkHapticImageField.h"
#include "vtkHapticLevelScan.h"
#include "vtkHapticTetraField.h"
#include "vtkHapticVtkVersions.h"
#include "vtkImageData.h"
#include "vtkLinearKernel.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointInterpolator.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

using palpate::Vec3;

namespace
{
/// Bounds and counts of cells that lay out a lattice.
struct Extent
{
  vtkBoundingBox Bounds;
  vtkIdType Solid = 0; ///< cells that fill space
  vtkIdType Flat = 0;  ///< faces and lines
  vtkIdType Points = 0;

  void Add(vtkDataSet& part)
  {
    std::array<double, 6> bounds{};
    part.GetBounds(bounds.data());
    this->Bounds.AddBounds(bounds.data());
    this->Points += part.GetNumberOfPoints();
    for (vtkIdType i = 0; i < part.GetNumberOfCells(); ++i)
    {
      const int type = part.GetCellType(i);
      const int dimension = vtkHapticCellDimension(static_cast<unsigned char>(type));
      this->Solid += dimension == 3 || type == VTK_EMPTY_CELL; // as a blanked one of a curvilinear grid says it is
      this->Flat += dimension == 1 || dimension == 2;
    }
  }
};

Extent ExtentOf(const std::vector<vtkDataSet*>& parts)
{
  Extent extent;
  for (vtkDataSet* part : parts)
  {
    extent.Add(*part);
  }
  return extent;
}

/// Half of the mean length of the cells that fill the bounds: then the lattice's own error is half of the data's.
palpate::FieldBlockGrid LatticeOver(const vtkBoundingBox& bounds, vtkIdType count)
{
  std::array<double, 3> lengths{};
  bounds.GetLengths(lengths.data());
  const double edge_u = std::cbrt(lengths[0] * lengths[1] * lengths[2] / static_cast<double>(count));
  palpate::FieldBlockGrid lattice;
  bounds.GetMinPoint(lattice.pose_W.p.data());
  constexpr double mostPoints = 1e6; // along an axis: a sliver of a data set
  for (int k = 0; k < 3; ++k)
  {
    const double cells = std::clamp(std::ceil(2.0 * lengths[k] / edge_u), 1.0, mostPoints);
    lattice.size[k] = static_cast<int>(cells) + 1;
    lattice.spacing_u[k] = lengths[k] / cells;
  }
  return lattice;
}

/// Cells that another rank has too are felt: VTK's probe passes them over, as if that rank probed as well.
void ForgetDuplicates(vtkDataObject* data)
{
  const char* const name = vtkDataSetAttributes::GhostArrayName();
  for (vtkDataSet* part : vtkHapticFieldSets(data))
  {
    for (vtkDataSetAttributes* attributes : { static_cast<vtkDataSetAttributes*>(part->GetPointData()),
           static_cast<vtkDataSetAttributes*>(part->GetCellData()) })
    {
      auto* const marks = vtkUnsignedCharArray::SafeDownCast(attributes->GetArray(name));
      vtkNew<vtkUnsignedCharArray> kept;
      bool any = false;
      for (vtkIdType i = 0; marks && i < marks->GetNumberOfValues(); ++i)
      {
        const auto mark = static_cast<unsigned char>(marks->GetValue(i) & ~vtkDataSetAttributes::DUPLICATECELL);
        kept->InsertNextValue(mark);
        any = any || mark != 0;
      }
      kept->SetName(name);
      any ? static_cast<void>(attributes->AddArray(kept)) : attributes->RemoveArray(name);
    }
  }
}

class ResampledField : public palpate::FieldSource
{
public:
  ResampledField(
    vtkSmartPointer<vtkDataObject> data, vtkHapticFieldArrays arrays, palpate::FieldBlockGrid lattice, bool cloud)
    : Data(std::move(data)), Arrays(std::move(arrays)), Lattice(std::move(lattice)), Cloud(cloud)
  {
  }

  palpate::MadeFieldBlock brickAround(const palpate::FieldBlockWish& wish) const override
  {
    if (!this->Sizes)
    {
      // Of a cloud each value is a mean over twice the distance of its points everywhere: nothing is finer.
      const std::vector<vtkDataSet*> none;
      this->Sizes.emplace(this->Cloud ? none : vtkHapticFieldSets(this->Data), vtkHapticFieldBounds(this->Data));
      this->Own =
        this->Cloud ? nullptr : vtkHapticOwnCells::Of(this->Data, this->Arrays, this->Lattice, this->WhyNoCells);
    }
    std::optional<palpate::FieldBlockGrid> probed;
    vtkSmartPointer<vtkImageData> image;
    const auto cells = [&](const vtkHapticFieldPart& part, const palpate::FieldBlockGrid& grid)
    {
      if (!probed || probed->size != grid.size || probed->spacing_u != grid.spacing_u ||
          probed->pose_W.p != grid.pose_W.p)
      {
        image = this->Probe(grid);
        probed = grid;
      }
      return this->Values(*image, part);
    };
    palpate::MadeFieldBlock made =
      vtkHapticFieldBlockWithFiner(this->Lattice, this->Arrays, cells, *this->Sizes, this->Own.get(), wish);
    made.whyNoCells = this->WhyNoCells.empty() ? made.whyNoCells : this->WhyNoCells;
    made.error = made.brick ? this->ErrorOf(made.brick->finestAt(wish.centre_W)) : 0.0;
    this->Levels.Tell(made, wish, this->Lattice, this->Arrays,
      [&](const vtkHapticFieldPart& part, const vtkHapticFieldWindow& window)
      { return cells(part, vtkHapticGridOf(this->Lattice, window)); });
    return made;
  }

private:
  /// Of the first block: to probe once more takes nearly as long as to probe a block.
  double ErrorOf(const palpate::FieldBlock& brick) const
  {
    if (!this->Error)
    {
      const auto cells = [this](const vtkHapticFieldPart& part, const palpate::FieldBlockGrid& grid)
      { return this->Values(*this->Probe(grid), part); };
      this->Error = vtkHapticFieldError(brick, vtkHapticFieldParts(this->Arrays).front(), cells);
    }
    return *this->Error;
  }

  vtkSmartPointer<vtkImageData> Probe(const palpate::FieldBlockGrid& grid) const
  {
    vtkNew<vtkImageData> places;
    places->SetDimensions(grid.size.data());
    places->SetOrigin(grid.pose_W.p.data());
    places->SetSpacing(grid.spacing_u.data());
    return this->Cloud ? this->Interpolate(places) : this->Resample(places);
  }

  /// Without vtkResampleToImage, in whose place a factory of ParaView's puts one that waits for other ranks.
  vtkSmartPointer<vtkImageData> Resample(vtkImageData* places) const
  {
    vtkNew<vtkCellDataToPointData> toPoints;
    toPoints->SetInputDataObject(this->Data);
    toPoints->PassCellDataOn(); // the array that hides cells is one of their values
    vtkNew<vtkCompositeDataProbeFilter> probe;
    probe->SetInputData(places);
    probe->SetSourceConnection(toPoints->GetOutputPort());
    probe->PassPartialArraysOn();
    probe->Update();
    return vtkImageData::SafeDownCast(probe->GetOutput());
  }

  vtkSmartPointer<vtkImageData> Interpolate(vtkImageData* places) const
  {
    vtkNew<vtkLinearKernel> kernel;
    kernel->SetRadius(4.0 * this->Lattice.spacing_u.maxCoeff()); // twice the distance of the points
    vtkNew<vtkPointInterpolator> interpolate;
    interpolate->SetInputData(places);
    interpolate->SetSourceData(vtkDataSet::SafeDownCast(this->Data));
    interpolate->SetKernel(kernel);
    interpolate->SetNullPointsStrategyToMaskPoints();
    interpolate->SetValidPointsMaskArrayName(Mask);
    interpolate->Update();
    return vtkImageData::SafeDownCast(interpolate->GetOutput());
  }

  std::vector<float> Values(vtkImageData& image, const vtkHapticFieldPart& part) const
  {
    const int kept = palpate::componentsOf(part.Role);
    const auto points = static_cast<std::size_t>(image.GetNumberOfPoints());
    std::vector<float> values(points * static_cast<std::size_t>(kept), std::numeric_limits<float>::quiet_NaN());
    vtkDataArray* const array = image.GetPointData()->GetArray(part.Name.c_str());
    vtkDataArray* const mask = image.GetPointData()->GetArray(Mask);
    for (vtkIdType i = 0; array && i < image.GetNumberOfPoints(); ++i)
    {
      if (!mask || mask->GetComponent(i, 0) != 0.0)
      {
        vtkHapticKeepTuple(array, i, part, values);
      }
    }
    return values;
  }

  static constexpr const char* Mask = "vtkValidPointMask"; ///< as vtkProbeFilter calls it

  vtkSmartPointer<vtkDataObject> Data;
  vtkHapticFieldArrays Arrays;
  palpate::FieldBlockGrid Lattice;
  bool Cloud;
  mutable std::optional<double> Error; ///< asked for by one thread at a time
  mutable std::optional<vtkHapticCellSizes> Sizes;
  mutable std::unique_ptr<const vtkHapticOwnCells> Own;
  mutable std::string WhyNoCells; ///< "": there are some, or the lattice tells the same
  vtkHapticLevelScan Levels;
};
} // namespace

vtkHapticFieldResult vtkHapticResampled(
  vtkDataObject* data, const std::vector<vtkDataSet*>& parts, const vtkHapticFieldArrays& arrays)
{
  const Extent extent = ExtentOf(parts);
  const bool cloud = extent.Solid == 0 && extent.Flat == 0;
  if (extent.Solid == 0 && !cloud)
  {
    return { nullptr,
      "the data consist of faces or lines, but a field needs a volume: choose the volume they were cut from" };
  }
  if (cloud && !vtkDataSet::SafeDownCast(data))
  {
    return { nullptr, "the points are in several blocks: apply Merge Blocks first" };
  }
  std::array<double, 3> lengths{};
  extent.Bounds.GetLengths(lengths.data());
  if (!(lengths[0] > 0.0 && lengths[1] > 0.0 && lengths[2] > 0.0))
  {
    return { nullptr, "the data are flat, but a field needs a volume" };
  }
  const vtkSmartPointer<vtkDataObject> kept = vtkHapticSharedCopy(data);
  ForgetDuplicates(kept);
  const palpate::FieldBlockGrid lattice = LatticeOver(extent.Bounds, cloud ? extent.Points : extent.Solid);
  if (vtkHapticIsTetraField(kept, arrays) && !cloud)
  {
    return { std::make_shared<vtkHapticTetraField>(vtkUnstructuredGrid::SafeDownCast(kept), arrays, lattice), "" };
  }
  return { std::make_shared<ResampledField>(kept, arrays, lattice, cloud), "" };
}
