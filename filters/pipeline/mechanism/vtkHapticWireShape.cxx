// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticWireShape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "haptics/core/Across.h"
#include "haptics/core/PoseMath.h"
#include "vtkCellArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

namespace
{
constexpr int Around = 8; ///< points of a ring
} // namespace

std::vector<palpate::Vec3> vtkHapticWireRings(std::span<const palpate::Vec3> nodes_W, double radius_u)
{
  std::vector<palpate::Vec3> points;
  palpate::Vec3 along = palpate::Vec3::UnitX(), across = palpate::Vec3::UnitY();
  for (std::size_t i = 0; i < nodes_W.size(); ++i)
  {
    const std::size_t last = nodes_W.size() - 1;
    const palpate::Vec3 way = nodes_W[std::min(i + 1, last)] - nodes_W[i > 0 ? i - 1 : 0];
    const palpate::Vec3 next = way.norm() > 0.0 ? palpate::Vec3(way.normalized()) : along;
    across = i == 0 ? palpate::acrossOf(next) : palpate::Vec3(palpate::shortestTurn(along, next) * across);
    along = next;
    for (int k = 0; k < Around; ++k)
    {
      const double angle = 2.0 * std::numbers::pi * k / Around;
      points.emplace_back(nodes_W[i] + radius_u * (std::cos(angle) * across + std::sin(angle) * along.cross(across)));
    }
  }
  return points;
}

std::vector<palpate::Vec3> vtkHapticWireAtFirst(const palpate::WirePlan& plan)
{
  const palpate::WirePlaces places_M = palpate::placesInSheath(plan);
  std::vector<palpate::Vec3> nodes_W;
  for (int i = 0; i < plan.wire.nodes(); ++i)
  {
    nodes_W.emplace_back(plan.mouth_W * places_M[static_cast<std::size_t>(i)].p);
  }
  return nodes_W;
}

vtkSmartPointer<vtkPolyData> vtkHapticWireShape(const palpate::WirePlan& plan)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkIdTypeArray> numbers;
  numbers->SetName("vtkOriginalPointIds");
  for (const palpate::Vec3& p : vtkHapticWireRings(vtkHapticWireAtFirst(plan), plan.radius_u))
  {
    numbers->InsertNextValue(points->InsertNextPoint(p.data()));
  }
  vtkNew<vtkCellArray> faces;
  for (vtkIdType beam = 0; beam < plan.wire.count; ++beam)
  {
    for (vtkIdType k = 0; k < Around; ++k)
    {
      const vtkIdType first = beam * Around, second = first + Around, next = (k + 1) % Around;
      faces->InsertNextCell({ first + k, first + next, second + next, second + k });
    }
  }
  auto tube = vtkSmartPointer<vtkPolyData>::New();
  tube->SetPoints(points);
  tube->SetPolys(faces);
  tube->GetPointData()->AddArray(numbers);
  return tube;
}
