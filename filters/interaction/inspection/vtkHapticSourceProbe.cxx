// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticSourceProbe.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkHapticConversion.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStaticCellLocator.h"

namespace
{
constexpr const char* OriginalCells = "vtkOriginalCellIds";

/// A cell of a data set, and how much each of its points counts at a place.
struct Found
{
  vtkDataSet* Data = nullptr;
  vtkIdType Cell = -1;
  vtkSmartPointer<vtkIdList> Points;
  std::vector<double> Weights;
  palpate::Vec3 Nearest = palpate::Vec3::Zero();
  double Distance = 0.0;
};

Found FoundAt(vtkDataSet* data, vtkIdType id, const palpate::Vec3& at)
{
  vtkNew<vtkGenericCell> cell;
  data->GetCell(id, cell);
  Found found{ data, id, cell->GetPointIds(), std::vector<double>(static_cast<std::size_t>(cell->GetNumberOfPoints())),
    at };
  double local[3] = { 0.0, 0.0, 0.0 }, distance2 = 0.0;
  int part = 0;
  const int side =
    cell->EvaluatePosition(at.data(), found.Nearest.data(), part, local, distance2, found.Weights.data());
  found.Distance = side < 0 ? std::numeric_limits<double>::infinity() : std::sqrt(distance2);
  return found;
}

std::string NameOf(vtkDataArray* array, int component)
{
  const std::string name = array->GetName();
  return array->GetNumberOfComponents() == 1 ? name : name + "_" + std::to_string(component);
}

/// Arrays with a name that are not VTK's own bookkeeping.
template<class ValueOf>
void AddArrays(vtkFieldData* arrays, ValueOf valueOf, vtkHapticProbed& probed)
{
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* const array = arrays->GetArray(i);
    if (!array || !array->GetName() || std::string_view(array->GetName()).starts_with("vtk"))
    {
      continue;
    }
    for (int component = 0; component < array->GetNumberOfComponents(); ++component)
    {
      probed.Values.emplace_back(NameOf(array, component), valueOf(array, component));
    }
  }
}

vtkIdType Original(vtkFieldData* arrays, const char* name, vtkIdType id)
{
  vtkDataArray* const originals = arrays->GetArray(name);
  return originals ? static_cast<vtkIdType>(originals->GetComponent(id, 0)) : id;
}

/// The cells of a data set that have that id where they come from.
std::vector<vtkIdType> CellsOf(vtkDataSet& set, vtkIdType original)
{
  vtkDataArray* const originals = set.GetCellData()->GetArray(OriginalCells);
  if (!originals)
  {
    return original >= 0 && original < set.GetNumberOfCells() ? std::vector<vtkIdType>{ original }
                                                              : std::vector<vtkIdType>();
  }
  std::vector<vtkIdType> cells;
  for (vtkIdType cell = 0; cell < set.GetNumberOfCells(); ++cell)
  {
    if (static_cast<vtkIdType>(originals->GetComponent(cell, 0)) == original)
    {
      cells.push_back(cell);
    }
  }
  return cells;
}

vtkHapticProbed Read(const Found& found)
{
  vtkHapticProbed probed;
  probed.Nearest = found.Nearest;
  vtkPointData* const points = found.Data->GetPointData();
  vtkCellData* const cells = found.Data->GetCellData();
  const auto most = std::max_element(found.Weights.begin(), found.Weights.end()) - found.Weights.begin();
  probed.Cell = Original(cells, OriginalCells, found.Cell);
  probed.Point = Original(points, "vtkOriginalPointIds", found.Points->GetId(most));
  const auto interpolated = [&found](vtkDataArray* array, int component)
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < found.Weights.size(); ++i)
    {
      sum += found.Weights[i] * array->GetComponent(found.Points->GetId(static_cast<vtkIdType>(i)), component);
    }
    return sum;
  };
  AddArrays(points, interpolated, probed);
  AddArrays(
    cells, [&found](vtkDataArray* array, int component) { return array->GetComponent(found.Cell, component); }, probed);
  return probed;
}
} // namespace

vtkHapticSourceProbe::vtkHapticSourceProbe() = default;

vtkHapticSourceProbe::~vtkHapticSourceProbe() = default;

vtkStaticCellLocator* vtkHapticSourceProbe::LocatorOf(vtkDataSet* data)
{
  Known& known = this->Sets[data];
  known.Used = true;
  if (!known.Locator || known.MTime != data->GetMTime())
  {
    known.Locator = vtkSmartPointer<vtkStaticCellLocator>::New();
    known.Locator->SetDataSet(data);
    known.Locator->BuildLocator();
    known.MTime = data->GetMTime();
  }
  return known.Locator;
}

void vtkHapticSourceProbe::Forget()
{
  std::erase_if(this->Sets, [](const auto& each) { return !each.second.Used; });
  for (auto& each : this->Sets)
  {
    each.second.Used = false;
  }
}

vtkHapticProbed vtkHapticSourceProbe::Look(vtkDataObject* data, const palpate::Vec3& at)
{
  double least2 = std::numeric_limits<double>::infinity();
  Found found;
  vtkHapticForEachDataSet(data,
    [&](vtkDataSet& set)
    {
      if (set.GetNumberOfCells() == 0)
      {
        return;
      }
      palpate::Vec3 nearest;
      vtkIdType cell = -1;
      int part = 0;
      double distance2 = 0.0;
      vtkNew<vtkGenericCell> room;
      this->LocatorOf(&set)->FindClosestPoint(at.data(), nearest.data(), room, cell, part, distance2);
      if (cell >= 0 && distance2 < least2)
      {
        least2 = distance2;
        found = FoundAt(&set, cell, at);
      }
    });
  return found.Data ? Read(found) : vtkHapticProbed();
}

bool vtkHapticSourceProbe::Holds(vtkDataObject* data, vtkIdType cell, const palpate::Vec3& at)
{
  constexpr double rounding = 1e-6; // of numbers in single precision and of results from them, as a share
  bool holds = false;
  vtkHapticForEachDataSet(data,
    [&](vtkDataSet& set)
    {
      const double within = rounding * (set.GetLength() + at.norm());
      for (const vtkIdType each : CellsOf(set, cell))
      {
        holds = holds || FoundAt(&set, each, at).Distance <= within;
      }
    });
  return holds;
}
