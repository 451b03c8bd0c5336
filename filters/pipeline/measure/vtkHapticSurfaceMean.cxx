// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticSurfaceMean.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "haptics/geometry/mesh/TriangleMesh.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkHapticConversion.h"
#include "vtkHapticWholeInput.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace
{
/// Integrals over the visited cells or points.
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

/// The surface itself if it has no ghosts.
vtkSmartPointer<vtkPolyData> WithoutGhosts(vtkPolyData* surface)
{
  vtkDataArray* const ghosts = surface->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName());
  if (!ghosts)
  {
    return surface;
  }
  auto own = vtkSmartPointer<vtkPolyData>::New();
  own->DeepCopy(surface);
  own->BuildCells();
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    if (ghosts->GetComponent(cell, 0) != 0.0)
    {
      own->DeleteCell(cell);
    }
  }
  own->RemoveDeletedCells(); // points keep their numbers
  return own;
}

Sums OfTriangles(vtkPolyData* surface, vtkDataArray* values)
{
  Sums sums;
  const vtkHapticConversionResult converted = vtkHapticToMesh(WithoutGhosts(surface));
  if (!converted.Mesh)
  {
    return sums; // there are no polygons
  }
  const palpate::TriangleMesh& mesh = *converted.Mesh;
  for (const auto& [a, b, c] : mesh.triangles) // vertices are numbered as the points
  {
    const palpate::Vec3 &p = mesh.vertices_W[a], &q = mesh.vertices_W[b], &r = mesh.vertices_W[c];
    sums.AddTriangle({ values->GetComponent(a, 0), values->GetComponent(b, 0), values->GetComponent(c, 0) },
      0.5 * (q - p).cross(r - p).norm());
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
