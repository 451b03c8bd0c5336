// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticNeighbourhood.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "vtkCompositeDataGeometryFilter.h"
#include "vtkHapticCellBins.h"
#include "vtkHapticCutCells.h"
#include "vtkHapticSurfacePart.h"
#include "vtkHapticWholeInput.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

vtkStandardNewMacro(vtkHapticNeighbourhood);

namespace
{
vtkSmartPointer<vtkPolyData> OneSurface(vtkDataObject* data)
{
  if (auto* const surface = vtkPolyData::SafeDownCast(data))
  {
    return surface;
  }
  vtkNew<vtkCompositeDataGeometryFilter> flat;
  flat->SetInputDataObject(data);
  flat->Update();
  return flat->GetOutput();
}

vtkBoundingBox Around(const double centre[3], double reach)
{
  return { centre[0] - reach, centre[0] + reach, centre[1] - reach, centre[1] + reach, centre[2] - reach,
    centre[2] + reach };
}
} // namespace

/// This rank's piece of the surface as it was when it was looked at last.
struct vtkHapticNeighbourhood::Looked
{
  vtkMTimeType Time = 0;
  vtkSmartPointer<vtkPolyData> Surface;
  vtkHapticCellBins Bins;
  double CellsOfAll = 0.0;
  vtkBoundingBox BoundsOfAll;

  /// All ranks ask at once: their pipelines execute together. The piece of one may be another while that of the next is
  /// not: steps that need all ranks are decided by all.
  void Look(vtkDataObject* piece)
  {
    const bool other = !this->Surface || this->Time != piece->GetMTime();
    if (other)
    {
      this->Time = piece->GetMTime();
      this->Surface = OneSurface(piece);
      this->Bins = vtkHapticCellBins(this->Surface);
    }
    if (vtkHapticHoldsOnAllRanks(!other))
    {
      return;
    }
    this->CellsOfAll = vtkHapticSumOfRanks(static_cast<double>(this->Bins.GetNumberOfCells()));
    this->BoundsOfAll = vtkHapticBoxOfRanks(this->Bins.GetBounds());
  }

  [[nodiscard]] std::vector<vtkIdType> Within(const vtkBoundingBox& box) const
  {
    std::vector<vtkIdType> cells;
    this->Bins.ForEachWithin(box, [&cells](std::uint32_t cell) { cells.push_back(cell); });
    return cells;
  }

  /// Cells of the box, whose reach is changed so that all ranks together have some and no more than the limit.
  [[nodiscard]] std::vector<vtkIdType> Fitting(const double centre[3], double& reach, double limit) const
  {
    constexpr int most = 60;                     // a factor of 2 each time: any two numbers of a scene are fewer apart
    double none = 0.0, tooMany = VTK_DOUBLE_MAX; // reaches that were tried
    for (int i = 0;; ++i)
    {
      std::vector<vtkIdType> cells = this->Within(Around(centre, reach));
      const double inAll = vtkHapticSumOfRanks(static_cast<double>(cells.size()));
      if (i == most || (inAll > 0.0 && inAll <= limit))
      {
        return cells;
      }
      (inAll > 0.0 ? tooMany : none) = reach;
      // Cells of a surface grow with the square; a little less, for none is spread evenly.
      const double smaller =
        none > 0.0 ? 0.5 * (none + tooMany) : reach * std::max(0.5, 0.9 * std::sqrt(limit / inAll));
      reach = tooMany < VTK_DOUBLE_MAX ? smaller : 2.0 * reach;
    }
  }

  /// With those that share a point with them.
  void AddNeighbours(std::vector<vtkIdType>& cells) const
  {
    const std::vector<vtkIdType> points = vtkHapticPointsOfCells(this->Surface, cells);
    vtkBoundingBox box;
    double place[3];
    for (const vtkIdType point : points)
    {
      this->Surface->GetPoint(point, place);
      box.AddPoint(place);
    }
    if (box.IsValid())
    {
      cells = this->Within(box);
      std::erase_if(cells, [&](vtkIdType cell) { return !vtkHapticSharesPoint(this->Surface, cell, points); });
    }
  }
};

vtkHapticNeighbourhood::vtkHapticNeighbourhood() : Data(std::make_unique<Looked>()) {}

vtkHapticNeighbourhood::~vtkHapticNeighbourhood() = default;

void vtkHapticNeighbourhood::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Centre: " << this->Centre[0] << " " << this->Centre[1] << " " << this->Centre[2] << "\n";
  os << indent << "Reach: " << this->Reach << "\n";
  os << indent << "Limit: " << this->Limit << "\n";
  os << indent << "Number: " << this->Number << "\n";
}

int vtkHapticNeighbourhood::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

int vtkHapticNeighbourhood::RequestData(vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  this->Data->Look(vtkDataObject::GetData(input[0]));
  vtkHapticPartInfo info;
  info.Number = this->Number;
  info.CellsOfAll = static_cast<vtkIdType>(this->Data->CellsOfAll);
  info.Whole = this->Data->CellsOfAll <= this->Limit;
  info.Reach = this->Reach;
  std::copy_n(this->Centre, 3, info.Centre.begin());
  if (this->Data->BoundsOfAll.IsValid())
  {
    this->Data->BoundsOfAll.GetBounds(info.Bounds.data());
  }
  vtkSmartPointer<vtkPolyData> piece = this->Data->Surface;
  if (!info.Whole)
  {
    std::vector<vtkIdType> cells = this->Data->Fitting(this->Centre, info.Reach, this->Limit);
    this->Data->AddNeighbours(cells);
    piece = vtkHapticCutCells(this->Data->Surface, std::move(cells));
  }
  auto* const result = vtkPolyData::GetData(output);
  vtkHapticGatherSurface(piece, result);
  vtkHapticTellPart(info, result);
  return 1;
}
