// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticPointBalls.h"

#include <limits>

#include "vtkCellArray.h"
#include "vtkDataSet.h"
#include "vtkHapticCellChecks.h"
#include "vtkHapticSurfacePlacement.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

namespace
{
using palpate::Vec3;

constexpr double Share = 1e-6; // of the radius

void AddBall(const Vec3& p_W, double radius_u, palpate::TriangleMesh& mesh)
{
  const auto first = static_cast<std::uint32_t>(mesh.vertices_W.size());
  const Vec3 half_W = 0.5 * Share * radius_u * Vec3::UnitX();
  mesh.vertices_W.push_back(p_W - half_W);
  mesh.vertices_W.push_back(p_W + half_W);
  mesh.triangles.push_back({ first, first + 1, first + 1 });
}

void AddBalls(vtkPolyData& cloud, const vtkHapticPlacement& placement, double radius_u, palpate::TriangleMesh& mesh)
{
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < cloud.GetVerts()->GetNumberOfCells(); ++cell)
  {
    cloud.GetVerts()->GetCellAtId(cell, ids);
    for (const vtkIdType id : *ids)
    {
      AddBall(placement * Vec3(cloud.GetPoint(id)), radius_u, mesh);
    }
  }
}
} // namespace

vtkHapticConversionResult vtkHapticToBalls(vtkDataObject* data, vtkMatrix4x4* matrix, double radius_u)
{
  vtkHapticConversionResult result;
  result.Problem = vtkHapticCheckPlacement(matrix);
  if (!result.Problem.empty())
  {
    return result;
  }
  if (vtkHapticCountPoints(data) > std::numeric_limits<std::uint32_t>::max() / 2)
  {
    result.Problem = "it has more than 2147483647 points; touch a part of it";
    return result;
  }
  palpate::TriangleMesh mesh;
  const vtkHapticPlacement placement = vtkHapticPlacementOf(matrix);
  vtkHapticForEachDataSet(data,
    [&](vtkDataSet& set)
    {
      auto* const cloud = vtkPolyData::SafeDownCast(&set);
      if (cloud && result.Problem.empty())
      {
        result.Problem = vtkHapticCellChecks::CheckPolyData(cloud);
        if (result.Problem.empty())
        {
          AddBalls(*cloud, placement, radius_u, mesh);
        }
      }
    });
  result.Problem =
    result.Problem.empty() && mesh.triangles.empty() ? "it has no points that are shown" : result.Problem;
  if (result.Problem.empty())
  {
    result.Mesh = std::make_shared<const palpate::TriangleMesh>(std::move(mesh));
  }
  return result;
}

std::size_t vtkHapticCountPoints(vtkDataObject* data)
{
  vtkIdType points = 0;
  vtkHapticForEachDataSet(data,
    [&points](vtkDataSet& set)
    {
      auto* const cloud = vtkPolyData::SafeDownCast(&set);
      points += cloud ? cloud->GetVerts()->GetNumberOfConnectivityIds() : 0;
    });
  return static_cast<std::size_t>(points);
}
