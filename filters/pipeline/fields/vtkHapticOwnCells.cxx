// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticOwnCells.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "vtkCellDataToPointData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkHapticImageField.h"
#include "vtkHapticVtkVersions.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUniformGrid.h"
#include "vtkUnsignedCharArray.h"

using palpate::CellCorners;
using palpate::FieldCells;
using palpate::Vec3;

namespace
{
constexpr std::size_t mostAtATime = vtkHapticOwnCells::mostBytes / FieldCells::bytesACell;

/// Which of a cell's points are the eight corners; null: it is of another kind.
const std::array<int, 8>* CornersOfType(int type)
{
  static constexpr std::array<int, 8> voxel{ 0, 1, 2, 3, 4, 5, 6, 7 }, hexahedron{ 0, 1, 3, 2, 4, 5, 7, 6 },
    wedge{ 0, 1, 2, 2, 3, 4, 5, 5 }, pyramid{ 0, 1, 3, 2, 4, 4, 4, 4 }, tetrahedron{ 0, 1, 2, 2, 3, 3, 3, 3 };
  switch (type)
  {
    case VTK_VOXEL:
      return &voxel;
    case VTK_HEXAHEDRON:
      return &hexahedron;
    case VTK_WEDGE:
      return &wedge;
    case VTK_PYRAMID:
      return &pyramid;
    case VTK_TETRA:
      return &tetrahedron;
    default:
      return nullptr;
  }
}

bool FillsSpace(int type)
{
  return vtkHapticCellDimension(static_cast<unsigned char>(type)) == 3;
}

/// With its values at points.
vtkSmartPointer<vtkDataSet> AtPoints(vtkDataSet* part, const std::string& name)
{
  if (part->GetPointData()->GetArray(name.c_str()))
  {
    return part;
  }
  vtkNew<vtkCellDataToPointData> toPoints;
  toPoints->SetInputDataObject(part);
  toPoints->PassCellDataOn(); // the array that hides cells is one of their values
  toPoints->Update();
  return vtkDataSet::SafeDownCast(toPoints->GetOutputDataObject(0));
}

bool IsHidden(vtkUnsignedCharArray* ghosts, vtkIdType i, int marks)
{
  return ghosts && (ghosts->GetValue(i) & marks) != 0;
}

/// How far a place is from a box, along the axis of most.
float DistanceTo(const std::array<float, 6>& box, const std::array<float, 3>& p)
{
  float far = 0.0F;
  for (std::size_t k = 0; k < 3; ++k)
  {
    far = std::max(far, std::max(box[2 * k] - p[k], p[k] - box[2 * k + 1]));
  }
  return far;
}
} // namespace

std::unique_ptr<const vtkHapticOwnCells> vtkHapticOwnCells::Of(
  vtkDataObject* data, const vtkHapticFieldArrays& arrays, const palpate::FieldBlockGrid& lattice, std::string& why)
{
  const std::vector<vtkHapticFieldPart> felt = vtkHapticFieldParts(arrays);
  if (felt.empty() || felt.front().Role != palpate::FieldBlockRole::Scalar)
  {
    return nullptr;
  }
  why = arrays.Smoothing > 0 ? "its values are smoothed" : "";
  auto own = std::make_unique<vtkHapticOwnCells>();
  own->Offset = felt.front().Offset;
  for (vtkDataSet* part : vtkHapticFieldSets(data))
  {
    why = why.empty() ? own->Add(part, felt.front()) : why;
    if (!why.empty())
    {
      return nullptr;
    }
  }
  own->FirstPoint.push_back(static_cast<std::uint32_t>(own->Values.size()));
  own->Local.assign(own->Values.size(), FieldCells::none);
  const double edge_u = 2.0 * lattice.spacing_u.minCoeff();
  own->Flat = !own->IsLevel(edge_u);
  const bool tooMany = own->Cells.size() > mostAtATime && !own->Holes && !own->Flat;
  return own->Cells.empty() || tooMany ? nullptr : std::move(own);
}

/// "", or why its cells are none that can be walked through.
std::string vtkHapticOwnCells::Add(vtkDataSet* part, const vtkHapticFieldPart& scalar)
{
  if (vtkUniformGrid::SafeDownCast(part))
  {
    return "grids of several levels overlap";
  }
  const std::size_t first = this->Values.size();
  if (this->Cells.size() + static_cast<std::size_t>(part->GetNumberOfCells()) > mostCells ||
      first + static_cast<std::size_t>(part->GetNumberOfPoints()) >= FieldCells::none)
  {
    return "there are more than 4 million cells; extract a part with Clip or Threshold";
  }
  const vtkSmartPointer<vtkDataSet> with = AtPoints(part, scalar.Name);
  vtkDataArray* const array = with->GetPointData()->GetArray(scalar.Name.c_str());
  if (!array)
  {
    return "";
  }
  std::vector<float> values(static_cast<std::size_t>(with->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < with->GetNumberOfPoints(); ++i)
  {
    vtkHapticKeepTuple(array, i, scalar, values);
    float& value = values[static_cast<std::size_t>(i)];
    value = IsHidden(with->GetPointGhostArray(), i, vtkDataSetAttributes::HIDDENPOINT) ? std::nanf("") : value;
    this->Holes = this->Holes || !std::isfinite(value);
  }
  const auto number = static_cast<std::uint32_t>(this->Parts.size());
  for (vtkIdType i = 0; i < with->GetNumberOfCells(); ++i)
  {
    const int type = with->GetCellType(i);
    const bool hidden =
      type == VTK_EMPTY_CELL ||
      IsHidden(with->GetCellGhostArray(), i, vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::REFINEDCELL);
    this->Holes = this->Holes || hidden;
    if (!hidden && CornersOfType(type))
    {
      std::array<double, 6> bounds{};
      with->GetCellBounds(i, bounds.data());
      Box box{};
      for (std::size_t k = 0; k < 6; ++k)
      {
        const float out = std::numeric_limits<float>::infinity();
        box[k] = std::nextafter(static_cast<float>(bounds[k]), k % 2 == 0 ? -out : out);
      }
      this->Boxes.push_back(box);
      this->Cells.push_back({ number, static_cast<std::uint32_t>(i) });
    }
    else if (!hidden && FillsSpace(type))
    {
      return "some cells are polyhedra or quadratic; apply the filter Tetrahedralize";
    }
  }
  this->FirstPoint.push_back(static_cast<std::uint32_t>(first));
  this->Values.insert(this->Values.end(), values.begin(), values.end());
  this->Parts.push_back(with);
  return "";
}

/// Whether no cell is less than half as wide as the mean one is long.
bool vtkHapticOwnCells::IsLevel(double edge_u) const
{
  return std::all_of(this->Boxes.begin(), this->Boxes.end(),
    [edge_u](const Box& box) {
      return std::min({ box[1] - box[0], box[3] - box[2], box[5] - box[4] }) > 0.5 * edge_u;
    });
}

CellCorners vtkHapticOwnCells::CornersOf(const Cell& cell) const
{
  vtkNew<vtkIdList> points;
  vtkDataSet* const part = this->Parts[cell.Part];
  part->GetCellPoints(cell.Id, points);
  const std::array<int, 8>& order = *CornersOfType(part->GetCellType(cell.Id));
  CellCorners corners;
  std::transform(order.begin(), order.end(), corners.begin(),
    [&](int i) { return this->FirstPoint[cell.Part] + static_cast<std::uint32_t>(points->GetId(i)); });
  return corners;
}

Vec3 vtkHapticOwnCells::PointOf(std::uint32_t point) const
{
  const auto after = std::upper_bound(this->FirstPoint.begin(), this->FirstPoint.end(), point);
  const auto part = static_cast<std::size_t>(after - this->FirstPoint.begin()) - 1;
  Vec3 p_W;
  this->Parts[part]->GetPoint(static_cast<vtkIdType>(point - this->FirstPoint[part]), p_W.data());
  return p_W;
}

std::shared_ptr<const FieldCells> vtkHapticOwnCells::Around(const Vec3& centre_W) const
{
  if (this->All)
  {
    return this->All;
  }
  std::vector<std::uint32_t> cells(this->Cells.size());
  std::iota(cells.begin(), cells.end(), 0U);
  if (cells.size() <= mostAtATime)
  {
    return this->All = this->Make(cells, Vec3::Zero(), std::numeric_limits<double>::infinity());
  }
  const std::array<float, 3> p{ static_cast<float>(centre_W.x()), static_cast<float>(centre_W.y()),
    static_cast<float>(centre_W.z()) };
  std::vector<float> far(cells.size());
  std::transform(
    this->Boxes.begin(), this->Boxes.end(), far.begin(), [&p](const Box& box) { return DistanceTo(box, p); });
  std::vector<float> sorted = far;
  std::nth_element(sorted.begin(), sorted.begin() + mostAtATime, sorted.end());
  const float reach = sorted[mostAtATime];
  std::erase_if(cells, [&](std::uint32_t i) { return !(far[i] < reach); });
  return this->Make(cells, centre_W, reach);
}

std::shared_ptr<const FieldCells> vtkHapticOwnCells::Make(
  const std::vector<std::uint32_t>& cells, const Vec3& centre_W, double reach_u) const
{
  palpate::CellParts made;
  made.centre_W = centre_W;
  made.reach_u = reach_u;
  made.offset = this->Offset;
  std::vector<std::uint32_t> used;
  for (const std::uint32_t cell : cells)
  {
    CellCorners corners = this->CornersOf(this->Cells[cell]);
    for (std::uint32_t& corner : corners)
    {
      if (this->Local[corner] == FieldCells::none)
      {
        this->Local[corner] = static_cast<std::uint32_t>(used.size());
        used.push_back(corner);
        made.points_W.push_back(this->PointOf(corner));
        made.values.push_back(this->Values[corner]);
      }
      corner = this->Local[corner];
    }
    made.corners.push_back(corners);
  }
  std::for_each(used.begin(), used.end(), [this](std::uint32_t point) { this->Local[point] = FieldCells::none; });
  return FieldCells::make(std::move(made));
}
