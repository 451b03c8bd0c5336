// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticConversion.h"

#include <algorithm>
#include <limits>

#include "haptics/core/WordHash.h"
#include "haptics/geometry/PolyLines.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkGeometryFilter.h"
#include "vtkHapticCellChecks.h"
#include "vtkHapticSurfacePlacement.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTriangleFilter.h"
#include "vtkUnstructuredGrid.h"

namespace
{
/// p_W = Map p.
struct Placement
{
  vtkHapticPlacement Map;
  bool Identity;
};

/// Poly data as it is, the outer faces of anything else.
vtkSmartPointer<vtkPolyData> SkinOf(vtkDataSet* data)
{
  if (auto* surface = vtkPolyData::SafeDownCast(data))
  {
    return surface;
  }
  vtkNew<vtkGeometryFilter> skin;
  skin->SetInputData(data);
  skin->Update();
  return skin->GetOutput();
}

/// Poly data whose cells can be trusted, or null with a problem.
vtkSmartPointer<vtkPolyData> CheckedSkin(vtkDataSet* data, std::string& problem)
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  problem = grid ? vtkHapticCellChecks::CheckGrid(grid) : "";
  if (!problem.empty())
  {
    return nullptr;
  }
  vtkSmartPointer<vtkPolyData> surface = SkinOf(data);
  problem = vtkHapticCellChecks::CheckPolyData(surface);
  return problem.empty() ? surface : nullptr;
}

/// Triangles of a data set; null with a problem. The points are those of its skin.
vtkSmartPointer<vtkPolyData> Triangulated(vtkDataSet* data, std::string& problem)
{
  const vtkSmartPointer<vtkPolyData> surface = CheckedSkin(data, problem);
  if (!surface)
  {
    return nullptr;
  }
  vtkNew<vtkTriangleFilter> filter;
  filter->SetInputData(surface);
  filter->PassLinesOff();
  filter->PassVertsOff();
  filter->Update();
  return filter->GetOutput();
}

void AppendTriangles(vtkPolyData* surface, bool mirrored, std::uint32_t base, palpate::TriangleMesh& mesh)
{
  auto each = vtkSmartPointer<vtkCellArrayIterator>::Take(surface->GetPolys()->NewIterator());
  for (each->GoToFirstCell(); !each->IsDoneWithTraversal(); each->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* corner = nullptr;
    each->GetCurrentCell(count, corner);
    const auto at = [&](int i) { return base + static_cast<std::uint32_t>(corner[i]); };
    mesh.triangles.push_back({ at(0), at(mirrored ? 2 : 1), at(mirrored ? 1 : 2) });
  }
}

std::string AppendPoints(vtkPolyData* surface, const Placement& placement, palpate::TriangleMesh& mesh)
{
  const std::size_t base = mesh.vertices_W.size();
  const auto count = static_cast<std::size_t>(surface->GetNumberOfPoints());
  if (base + count > std::numeric_limits<std::uint32_t>::max())
  {
    return "it has more than 4294967295 points; touch a part of it";
  }
  mesh.vertices_W.reserve(base + count);
  for (std::size_t i = 0; i < count; ++i)
  {
    palpate::Vec3 p;
    surface->GetPoint(static_cast<vtkIdType>(i), p.data());
    mesh.vertices_W.push_back(placement.Identity ? p : placement.Map * p);
  }
  return {};
}

std::string AppendSurface(vtkDataSet* data, const Placement& placement, palpate::TriangleMesh& mesh)
{
  std::string problem;
  const vtkSmartPointer<vtkPolyData> surface = Triangulated(data, problem);
  if (!surface || surface->GetNumberOfPolys() == 0)
  {
    return problem;
  }
  const auto base = static_cast<std::uint32_t>(mesh.vertices_W.size());
  problem = AppendPoints(surface, placement, mesh);
  if (problem.empty())
  {
    mesh.triangles.reserve(mesh.triangles.size() + static_cast<std::size_t>(surface->GetNumberOfPolys()));
    AppendTriangles(surface, placement.Map.linear().determinant() < 0.0, base, mesh);
  }
  return problem;
}

std::string AppendLines(vtkDataSet* data, const Placement& placement, palpate::TriangleMesh& mesh)
{
  std::string problem;
  const vtkSmartPointer<vtkPolyData> skin = CheckedSkin(data, problem);
  if (!skin || skin->GetNumberOfLines() == 0)
  {
    return problem;
  }
  const auto base = static_cast<std::uint32_t>(mesh.vertices_W.size());
  problem = AppendPoints(skin, placement, mesh);
  palpate::PolyLines curves;
  auto each = vtkSmartPointer<vtkCellArrayIterator>::Take(skin->GetLines()->NewIterator());
  for (each->GoToFirstCell(); problem.empty() && !each->IsDoneWithTraversal(); each->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* point = nullptr;
    each->GetCurrentCell(count, point);
    curves.lines.emplace_back();
    std::for_each(
      point, point + count, [&](vtkIdType i) { curves.lines.back().push_back(base + static_cast<std::uint32_t>(i)); });
  }
  const palpate::TriangleMesh segments = palpate::segmentsOf(curves);
  mesh.triangles.insert(mesh.triangles.end(), segments.triangles.begin(), segments.triangles.end());
  return problem;
}

using AppendPart = std::string (*)(vtkDataSet*, const Placement&, palpate::TriangleMesh&);

/// Why a data object has no surface at all.
std::string CheckKind(vtkDataObject* data)
{
  if (vtkDataSet::SafeDownCast(data) || vtkCompositeDataSet::SafeDownCast(data))
  {
    return {};
  }
  return data ? std::string("a ") + data->GetClassName() + " has no surface" : "there is no data";
}

void AppendAll(vtkDataObject* data, const Placement& placement, AppendPart append, palpate::TriangleMesh& mesh,
  vtkHapticConversionResult& result)
{
  vtkHapticForEachDataSet(data,
    [&](vtkDataSet& set)
    {
      if (result.Problem.empty())
      {
        const std::size_t before = mesh.vertices_W.size();
        result.Problem = append(&set, placement, mesh);
        result.PartPoints.push_back(mesh.vertices_W.size() - before);
      }
    });
}

/// What a key is made of: an object's identity counts through its time, which no other object has had.
void AddGeometry(vtkDataSet& set, palpate::WordHash& key)
{
  auto* surface = vtkPolyData::SafeDownCast(&set);
  if (!surface)
  {
    key.add(std::uint64_t{ set.GetMTime() });
    return;
  }
  key.add(std::uint64_t{ surface->GetPoints() ? surface->GetPoints()->GetMTime() : 0 });
  for (vtkCellArray* cells : { surface->GetPolys(), surface->GetStrips(), surface->GetLines() })
  {
    key.add(std::uint64_t{ cells->GetMTime() });
  }
}
} // namespace

void vtkHapticForEachDataSet(vtkDataObject* data, const std::function<void(vtkDataSet&)>& visit)
{
  if (auto* set = vtkDataSet::SafeDownCast(data))
  {
    visit(*set);
  }
  auto* composite = vtkCompositeDataSet::SafeDownCast(data);
  if (!composite)
  {
    return;
  }
  auto each = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (each->InitTraversal(); !each->IsDoneWithTraversal(); each->GoToNextItem())
  {
    if (auto* block = vtkDataSet::SafeDownCast(each->GetCurrentDataObject()))
    {
      visit(*block);
    }
  }
}

std::vector<vtkSmartPointer<vtkPolyData>> vtkHapticSurfaceParts(
  vtkDataObject* data, const std::vector<std::size_t>& partPoints)
{
  std::vector<vtkSmartPointer<vtkPolyData>> parts;
  std::size_t next = 0;
  bool fits = true;
  vtkHapticForEachDataSet(data,
    [&](vtkDataSet& set)
    {
      const std::size_t points = next < partPoints.size() ? partPoints[next] : 0;
      fits = fits && next++ < partPoints.size();
      if (fits && points > 0)
      {
        parts.push_back(SkinOf(&set));
        fits = static_cast<std::size_t>(parts.back()->GetNumberOfPoints()) == points;
      }
    });
  return fits ? parts : std::vector<vtkSmartPointer<vtkPolyData>>();
}

namespace
{
/// `nothing`: the problem of data without what `append` takes.
vtkHapticConversionResult Convert(
  vtkDataObject* data, vtkMatrix4x4* matrix, AppendPart append, const std::string& nothing)
{
  vtkHapticConversionResult result;
  result.Problem = vtkHapticCheckPlacement(matrix);
  result.Problem = result.Problem.empty() ? CheckKind(data) : result.Problem;
  if (!result.Problem.empty())
  {
    return result;
  }
  auto mesh = std::make_shared<palpate::TriangleMesh>();
  const Placement placement{ vtkHapticPlacementOf(matrix), !matrix || matrix->IsIdentity() };
  AppendAll(data, placement, append, *mesh, result);
  if (result.Problem.empty() && mesh->triangles.empty())
  {
    result.Problem = nothing;
  }
  if (result.Problem.empty())
  {
    result.Mesh = std::move(mesh);
  }
  return result;
}
} // namespace

vtkHapticConversionResult vtkHapticToMesh(vtkDataObject* data, vtkMatrix4x4* matrix)
{
  const bool lines = vtkHapticCountLines(data) > 0;
  return Convert(data, matrix, AppendSurface,
    lines ? "it has no polygons but lines; give a line radius above 0 to touch them as tubes"
          : "it has no polygons; only surfaces can be touched (apply Extract Surface or Contour)");
}

vtkHapticConversionResult vtkHapticToLines(vtkDataObject* data, vtkMatrix4x4* matrix)
{
  return Convert(data, matrix, AppendLines, "it has no lines");
}

std::size_t vtkHapticCountLines(vtkDataObject* data)
{
  vtkIdType lines = 0;
  vtkHapticForEachDataSet(data,
    [&lines](vtkDataSet& set)
    {
      auto* surface = vtkPolyData::SafeDownCast(&set);
      lines += surface ? surface->GetNumberOfLines() : 0;
    });
  return static_cast<std::size_t>(lines);
}

vtkSmartPointer<vtkPolyData> vtkHapticToPolyData(const palpate::TriangleMesh& mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.vertices_W.size()));
  for (std::size_t i = 0; i < mesh.vertices_W.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), mesh.vertices_W[i].data());
  }
  vtkNew<vtkCellArray> polys;
  polys->AllocateExact(
    static_cast<vtkIdType>(mesh.triangles.size()), 3 * static_cast<vtkIdType>(mesh.triangles.size()));
  for (const auto& [a, b, c] : mesh.triangles)
  {
    polys->InsertNextCell({ a, b, c });
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(polys);
  return surface;
}

std::uint64_t vtkHapticContentKey(vtkDataObject* data, vtkMatrix4x4* matrix)
{
  palpate::WordHash key;
  vtkHapticForEachDataSet(data, [&key](vtkDataSet& set) { AddGeometry(set, key); });
  for (int i = 0; matrix && i < 16; ++i)
  {
    key.add(matrix->GetData()[i]);
  }
  return key.value();
}
