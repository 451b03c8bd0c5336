// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticPointBalls.h"

#include <limits>

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkHapticCellChecks.h"
#include "vtkHapticSurfacePlacement.h"
#include "vtkIdList.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
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

/// Calls `visit` with each vertex cell, which poly data has before all others, and each of its points.
template<typename Visit>
void ForEachPoint(vtkPolyData& cloud, Visit visit)
{
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < cloud.GetVerts()->GetNumberOfCells(); ++cell)
  {
    cloud.GetVerts()->GetCellAtId(cell, ids);
    for (const vtkIdType id : *ids)
    {
      visit(cell, id);
    }
  }
}

void AddBalls(vtkPolyData& cloud, const vtkHapticPlacement& placement, double radius_u, palpate::TriangleMesh& mesh)
{
  ForEachPoint(cloud, [&](vtkIdType, vtkIdType id) { AddBall(placement * Vec3(cloud.GetPoint(id)), radius_u, mesh); });
}

vtkSmartPointer<vtkPolyData> ArraysOf(vtkPolyData& cloud)
{
  auto balls = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> vertices;
  vtkPointData* const ofPoints = balls->GetPointData();
  vtkCellData* const ofCells = balls->GetCellData();
  ofPoints->CopyAllocate(cloud.GetPointData());
  ofCells->CopyAllocate(cloud.GetCellData());
  ForEachPoint(cloud,
    [&](vtkIdType cell, vtkIdType id)
    {
      const vtkIdType first = points->InsertNextPoint(cloud.GetPoint(id));
      const vtkIdType both[] = { first, points->InsertNextPoint(cloud.GetPoint(id)) };
      ofPoints->CopyData(cloud.GetPointData(), id, both[0]);
      ofPoints->CopyData(cloud.GetPointData(), id, both[1]);
      ofCells->CopyData(cloud.GetCellData(), cell, vertices->InsertNextCell(2, both));
    });
  balls->SetPoints(points);
  balls->SetVerts(vertices);
  return balls;
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
    result.Problem = "more than 2147483647 points; touch a part of the data";
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
          const std::size_t before = mesh.vertices_W.size();
          AddBalls(*cloud, placement, radius_u, mesh);
          result.PartPoints.push_back(mesh.vertices_W.size() - before);
        }
      }
    });
  result.Problem = result.Problem.empty() && mesh.triangles.empty() ? "it has no visible points" : result.Problem;
  if (result.Problem.empty())
  {
    result.Mesh = std::make_shared<const palpate::TriangleMesh>(std::move(mesh));
  }
  return result;
}

vtkSmartPointer<vtkMultiBlockDataSet> vtkHapticBallArrays(vtkDataObject* data)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New(); // they may have other arrays
  vtkHapticForEachDataSet(data,
    [&](vtkDataSet& set)
    {
      if (auto* const cloud = vtkPolyData::SafeDownCast(&set))
      {
        blocks->SetBlock(blocks->GetNumberOfBlocks(), ArraysOf(*cloud));
      }
    });
  return blocks;
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
