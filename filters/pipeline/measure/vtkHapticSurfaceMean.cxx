// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticSurfaceMean.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkHapticWholeInput.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTriangle.h"
#include "vtkTriangleFilter.h"

namespace
{
/// Integrals over what has been looked at.
struct Sums
{
  double Weight = 0.0; ///< area, or number of points
  double First = 0.0;  ///< of the value
  double Second = 0.0; ///< of its square
  double Maximum = -std::numeric_limits<double>::infinity();

  void AddPoint(double value)
  {
    if (std::isfinite(value))
    {
      this->Weight += 1.0;
      this->First += value;
      this->Second += value * value;
      this->Maximum = std::max(this->Maximum, value);
    }
  }

  /// Integrals of the linear function with these values at the corners.
  void AddTriangle(const std::array<double, 3>& value, double area)
  {
    const auto [a, b, c] = value;
    if (!(area > 0.0) || !std::isfinite(area) || !std::isfinite(a + b + c))
    {
      return;
    }
    this->Weight += area;
    this->First += area * (a + b + c) / 3.0;
    this->Second += area * (a * a + b * b + c * c + a * b + b * c + c * a) / 6.0;
    this->Maximum = std::max({ this->Maximum, a, b, c });
  }

  [[nodiscard]] vtkHapticMean OfRanks() const
  {
    const double weight = vtkHapticSumOfRanks(this->Weight);
    const double first = vtkHapticSumOfRanks(this->First), second = vtkHapticSumOfRanks(this->Second);
    const double maximum = vtkHapticLargestOfRanks(this->Maximum);
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    return weight > 0.0 ? vtkHapticMean{ first / weight, std::sqrt(second / weight), maximum }
                        : vtkHapticMean{ none, none, none };
  }
};

bool IsGhost(vtkPolyData* surface, vtkIdType cell)
{
  vtkDataArray* const ghosts = surface->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName());
  return ghosts && ghosts->GetComponent(cell, 0) != 0.0;
}

Sums OfTriangles(vtkPolyData* surface, vtkDataArray* values)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(surface);
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  triangles->Update();
  vtkPolyData* const made = triangles->GetOutput();
  Sums sums;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < made->GetNumberOfCells(); ++cell)
  {
    made->GetCellPoints(cell, corners);
    if (IsGhost(made, cell))
    {
      continue;
    }
    std::array<double, 3> value{};
    std::array<std::array<double, 3>, 3> corner{};
    for (int i = 0; i < 3; ++i)
    {
      value[i] = values->GetComponent(corners->GetId(i), 0);
      made->GetPoint(corners->GetId(i), corner[i].data());
    }
    sums.AddTriangle(value, vtkTriangle::TriangleArea(corner[0].data(), corner[1].data(), corner[2].data()));
  }
  return sums;
}

Sums OfPoints(vtkDataArray* values)
{
  Sums sums;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    sums.AddPoint(values->GetComponent(i, 0));
  }
  return sums;
}
} // namespace

vtkHapticMean vtkHapticMeanOver(vtkPolyData* surface, vtkDataArray* values)
{
  const Sums sums = OfTriangles(surface, values);
  const bool hasArea = vtkHapticSumOfRanks(sums.Weight) > 0.0;
  return (hasArea ? sums : OfPoints(values)).OfRanks();
}
