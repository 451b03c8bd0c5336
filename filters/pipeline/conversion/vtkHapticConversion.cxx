// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticConversion.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <span>
#include <utility>

#include "haptics/core/WordHash.h"
#include "haptics/geometry/mesh/PolyLines.h"
#include "haptics/geometry/mesh/PolygonCut.h"
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

/// Calls visit(corners), a span of the ids of their points, for each cell.
template<class Visit>
void ForEachCell(vtkCellArray* cells, Visit visit)
{
  auto each = vtkSmartPointer<vtkCellArrayIterator>::Take(cells->NewIterator());
  for (each->GoToFirstCell(); !each->IsDoneWithTraversal(); each->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* corner = nullptr;
    each->GetCurrentCell(count, corner);
    visit(std::span<const vtkIdType>(corner, static_cast<std::size_t>(count)));
  }
}

/// Appends the triangles of polygons and strips whose points stand in the mesh from some vertex on.
class CellAppender
{
public:
  CellAppender(std::uint32_t base, palpate::TriangleMesh& mesh) : Base(base), Mesh(mesh) {}

  void Polygon(std::span<const vtkIdType> corners)
  {
    this->Corners.clear();
    std::transform(corners.begin(), corners.end(), std::back_inserter(this->Corners),
      [this](vtkIdType id) { return this->Base + static_cast<std::uint32_t>(id); });
    const palpate::PolygonCut cut = palpate::cutPolygon(this->Mesh.vertices_W, this->Corners, this->Mesh.triangles);
    this->Lasts = this->Lasts && cut.lasts;
    if (cut.holeEdges > 0)
    {
      this->HoleEdges.push_back(cut.holeEdges);
    }
  }

  void Strip(std::span<const vtkIdType> corners)
  {
    const auto at = [&](std::size_t i) { return this->Base + static_cast<std::uint32_t>(corners[i]); };
    for (std::size_t i = 0; i + 2 < corners.size(); ++i)
    {
      const std::size_t turned = i % 2;
      this->Mesh.triangles.push_back({ at(i + turned), at(i + 1 - turned), at(i + 2) });
    }
  }

  std::vector<std::size_t> HoleEdges;
  bool Lasts = true; ///< the cuts are right wherever the points go

private:
  std::uint32_t Base;
  palpate::TriangleMesh& Mesh;
  std::vector<std::uint32_t> Corners;
};

/// Turns the triangles from `first` on around.
void Mirror(palpate::TriangleMesh& mesh, std::size_t first)
{
  std::for_each(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(first), mesh.triangles.end(),
    [](std::array<std::uint32_t, 3>& t) { std::swap(t[1], t[2]); });
}

std::string AppendPoints(vtkPolyData* surface, const Placement& placement, palpate::TriangleMesh& mesh)
{
  const std::size_t base = mesh.vertices_W.size();
  const auto count = static_cast<std::size_t>(surface->GetNumberOfPoints());
  if (base + count > std::numeric_limits<std::uint32_t>::max())
  {
    return "more than 4294967295 points; touch a part of the data";
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

/// Names the polygons and strips of a surface by the ids of their corners.
std::uint64_t PolygonsOf(vtkPolyData* surface, bool mirrored)
{
  palpate::WordHash key;
  key.add(static_cast<std::uint64_t>(surface->GetNumberOfPoints()));
  key.add(std::uint64_t{ mirrored });
  for (vtkCellArray* cells : { surface->GetPolys(), surface->GetStrips() })
  {
    ForEachCell(cells,
      [&](std::span<const vtkIdType> corners)
      {
        key.add(std::uint64_t{ corners.size() });
        std::for_each(
          corners.begin(), corners.end(), [&key](vtkIdType id) { key.add(static_cast<std::uint64_t>(id)); });
      });
    key.add(std::uint64_t{ 0 });
  }
  return key.value();
}

/// Appends surfaces, each cut as it was known before where it has the same polygons.
class SurfaceAppender
{
public:
  SurfaceAppender(
    const vtkHapticCuts* known, std::vector<vtkHapticCuts::Part>& parts, std::vector<std::size_t>& holeEdges)
    : Known(known), Parts(parts), HoleEdges(holeEdges)
  {
  }

  std::string operator()(vtkDataSet* data, const Placement& placement, palpate::TriangleMesh& mesh)
  {
    const vtkHapticCuts::Part* const known = this->KnownPart();
    vtkHapticCuts::Part& part = this->Parts.emplace_back();
    part.FirstTriangle = mesh.triangles.size();
    part.FirstVertex = static_cast<std::uint32_t>(mesh.vertices_W.size());
    std::string problem;
    const vtkSmartPointer<vtkPolyData> skin = CheckedSkin(data, problem);
    if (!skin || skin->GetNumberOfPolys() + skin->GetNumberOfStrips() == 0)
    {
      return problem;
    }
    const bool mirrored = placement.Map.linear().determinant() < 0.0;
    const std::uint64_t polygons = PolygonsOf(skin, mirrored);
    problem = AppendPoints(skin, placement, mesh);
    if (!problem.empty())
    {
      return problem;
    }
    if (known && known->Polygons == polygons)
    {
      this->AppendKnown(*known, part, mesh);
      part.Polygons = polygons;
    }
    else
    {
      part.Polygons = this->AppendCut(skin, part, mirrored, mesh) ? polygons : 0;
    }
    part.Triangles = mesh.triangles.size() - part.FirstTriangle;
    return {};
  }

private:
  [[nodiscard]] const vtkHapticCuts::Part* KnownPart() const
  {
    const std::size_t index = this->Parts.size();
    const bool known = this->Known && this->Known->Mesh && index < this->Known->Parts.size();
    return known && this->Known->Parts[index].Polygons != 0 ? &this->Known->Parts[index] : nullptr;
  }

  void AppendKnown(const vtkHapticCuts::Part& known, const vtkHapticCuts::Part& part, palpate::TriangleMesh& mesh) const
  {
    const auto first = this->Known->Mesh->triangles.begin() + static_cast<std::ptrdiff_t>(known.FirstTriangle);
    const std::uint32_t shift = part.FirstVertex - known.FirstVertex; // the sums come out right although it may wrap
    std::for_each(first, first + static_cast<std::ptrdiff_t>(known.Triangles),
      [&](const std::array<std::uint32_t, 3>& t) {
        mesh.triangles.push_back({ t[0] + shift, t[1] + shift, t[2] + shift });
      });
  }

  /// False: the same polygons may have to be cut anew where their points are elsewhere.
  bool AppendCut(vtkPolyData* surface, const vtkHapticCuts::Part& part, bool mirrored, palpate::TriangleMesh& mesh)
  {
    const vtkIdType cells = surface->GetNumberOfPolys() + surface->GetNumberOfStrips();
    mesh.triangles.reserve(mesh.triangles.size() + static_cast<std::size_t>(cells));
    CellAppender append(part.FirstVertex, mesh);
    ForEachCell(surface->GetPolys(), [&append](std::span<const vtkIdType> corners) { append.Polygon(corners); });
    ForEachCell(surface->GetStrips(), [&append](std::span<const vtkIdType> corners) { append.Strip(corners); });
    if (mirrored)
    {
      Mirror(mesh, part.FirstTriangle);
    }
    this->HoleEdges.insert(this->HoleEdges.end(), append.HoleEdges.begin(), append.HoleEdges.end());
    return append.Lasts;
  }

  const vtkHapticCuts* Known;
  std::vector<vtkHapticCuts::Part>& Parts;
  std::vector<std::size_t>& HoleEdges;
};

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
  if (!problem.empty())
  {
    return problem;
  }
  ForEachCell(skin->GetLines(),
    [&](std::span<const vtkIdType> points)
    {
      std::vector<std::uint32_t>& line = curves.lines.emplace_back();
      std::transform(points.begin(), points.end(), std::back_inserter(line),
        [base](vtkIdType i) { return base + static_cast<std::uint32_t>(i); });
    });
  const palpate::TriangleMesh segments = palpate::segmentsOf(curves);
  mesh.triangles.insert(mesh.triangles.end(), segments.triangles.begin(), segments.triangles.end());
  return problem;
}

using AppendPart = std::function<std::string(vtkDataSet*, const Placement&, palpate::TriangleMesh&)>;

/// Why a data object has no surface at all.
std::string CheckKind(vtkDataObject* data)
{
  if (vtkDataSet::SafeDownCast(data) || vtkCompositeDataSet::SafeDownCast(data))
  {
    return {};
  }
  return data ? std::string("a ") + data->GetClassName() + " has no surface" : "there is no data";
}

void AppendAll(vtkDataObject* data, const Placement& placement, const AppendPart& append, palpate::TriangleMesh& mesh,
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

/// Adds an object's identity to a key: it counts through its time, which no other object has had.
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
/// `nothing`: the problem of data from which `append` takes nothing.
vtkHapticConversionResult Convert(
  vtkDataObject* data, vtkMatrix4x4* matrix, const AppendPart& append, const std::string& nothing)
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

vtkHapticConversionResult vtkHapticToMesh(vtkDataObject* data, vtkMatrix4x4* matrix, const vtkHapticCuts* known)
{
  const bool lines = vtkHapticCountLines(data) > 0;
  std::vector<vtkHapticCuts::Part> parts;
  std::vector<std::size_t> holeEdges;
  vtkHapticConversionResult result = Convert(data, matrix, SurfaceAppender(known, parts, holeEdges),
    lines ? "it has no polygons but lines; give a line radius above 0 to touch them as tubes"
          : "it has no polygons; only surfaces can be touched (apply Extract Surface or Contour)");
  result.Cuts = { result.Mesh, std::move(parts) };
  if (!result.Mesh && !holeEdges.empty())
  {
    result.Problem = "none of its polygons can be filled: it has " + palpate::describeHoles(holeEdges);
  }
  result.HoleEdges = std::move(holeEdges);
  return result;
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
