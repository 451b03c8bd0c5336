// SPDX-License-Identifier: GPL-3.0-or-later
// Reads VTK data for a scene, ahead or now: polygons, lines as tubes or walls, points as balls.
#include <algorithm>

#include "haptics/geometry/curves/CurveSet.h"
#include "haptics/session/scene/TouchedData.h"
#include "vtkHapticConversion.h"
#include "vtkHapticPointBalls.h"
#include "vtkHapticSceneSurfaces.h"

namespace
{
/// Not that of its lines.
std::uint64_t BallsKey(vtkDataObject* data, vtkMatrix4x4* matrix)
{
  return ~vtkHapticContentKey(data, matrix);
}

std::string BallsName(const std::string& name)
{
  return name + " (points)";
}
} // namespace

vtkHapticConversionAhead::Reading vtkHapticSceneSurfaces::ReadingOf(Part part) const
{
  if (part == Part::Lines)
  {
    return vtkHapticToLines;
  }
  return [radius_u = this->PointRadius_u](vtkDataObject* data, vtkMatrix4x4* matrix)
  { return vtkHapticToBalls(data, matrix, radius_u); };
}

vtkHapticConversionResult vtkHapticSceneSurfaces::Read(Part part, vtkDataObject* data, vtkMatrix4x4* matrix)
{
  std::optional<vtkHapticConversionResult> ahead = this->Ahead.Take(part, data, matrix);
  return ahead ? std::move(*ahead) : this->ReadingOf(part)(data, matrix);
}

vtkHapticConversionResult vtkHapticSceneSurfaces::ReadFaces(
  const std::string& name, vtkDataObject* data, vtkMatrix4x4* matrix)
{
  std::optional<vtkHapticConversionResult> ahead = this->Ahead.Take(Part::Faces, data, matrix);
  return ahead ? std::move(*ahead) : vtkHapticToMesh(data, matrix, this->CutsOf(name));
}

bool vtkHapticSceneSurfaces::Prepare(const std::string& name, vtkDataObject* data, vtkMatrix4x4* matrix)
{
  if (!this->OfSources.Of(name).Touched || !vtkHapticCheckPlacement(matrix).empty())
  {
    return true;
  }
  const bool faces = this->PrepareFaces(name, data, matrix), lines = this->PrepareLines(name, data, matrix);
  return this->PreparePoints(name, data, matrix) && faces && lines;
}

bool vtkHapticSceneSurfaces::PrepareFaces(const std::string& name, vtkDataObject* data, vtkMatrix4x4* matrix)
{
  const std::uint64_t key = vtkHapticContentKey(data, nullptr);
  const vtkHapticCuts* const known = this->CutsOf(name);
  return this->FindKnown(name, key, vtkHapticPlacementOf(matrix), std::nullopt).first ||
         this->Ahead.Ready(Part::Faces, data, matrix,
           [cuts = known ? *known : vtkHapticCuts()](vtkDataObject* copy, vtkMatrix4x4* place)
           { return vtkHapticToMesh(copy, place, cuts.Mesh ? &cuts : nullptr); });
}

bool vtkHapticSceneSurfaces::PrepareLines(const std::string& name, vtkDataObject* data, vtkMatrix4x4* matrix)
{
  if ((this->LineRadius_u == 0.0 && !this->PlaneWorld) || vtkHapticCountLines(data) == 0)
  {
    return true;
  }
  const std::uint64_t key = vtkHapticContentKey(data, nullptr);
  return this->FindKnown(name, key, vtkHapticPlacementOf(matrix), this->LineRadius_u).first ||
         this->FindWalls(name, data, matrix) ||
         this->Ahead.Ready(Part::Lines, data, matrix, this->ReadingOf(Part::Lines));
}

bool vtkHapticSceneSurfaces::PreparePoints(const std::string& name, vtkDataObject* data, vtkMatrix4x4* matrix)
{
  return this->PointRadius_u == 0.0 || vtkHapticCountPoints(data) == 0 || this->FindBalls(name, data, matrix) ||
         this->Ahead.Ready(Part::Points, data, matrix, this->ReadingOf(Part::Points));
}

const vtkHapticSceneSurfaces::Kept* vtkHapticSceneSurfaces::FindCommitted(
  const std::function<bool(const Kept&)>& sought) const
{
  const auto found = std::find_if(this->Committed.begin(), this->Committed.end(), sought);
  return found == this->Committed.end() ? nullptr : &*found;
}

const vtkHapticSceneSurfaces::Kept* vtkHapticSceneSurfaces::FindBalls(
  const std::string& name, vtkDataObject* data, vtkMatrix4x4* matrix) const
{
  return this->FindCommitted(
    [&, key = BallsKey(data, matrix)](const Kept& kept)
    {
      return kept.Key == key && kept.Surface.input.name == BallsName(name) &&
             kept.Surface.input.lineRadius_u == this->PointRadius_u;
    });
}

const vtkHapticSceneSurfaces::Kept* vtkHapticSceneSurfaces::FindWalls(
  const std::string& name, vtkDataObject* data, vtkMatrix4x4* matrix) const
{
  return this->FindCommitted(
    [&, key = vtkHapticContentKey(data, matrix)](const Kept& kept) {
      return kept.Key == key && kept.Name == name && kept.Surface.plane_WP && kept.WallRadius_u == this->WallRadius_u;
    });
}

std::string vtkHapticSceneSurfaces::AddBalls(const std::string& name, vtkDataObject* data, vtkMatrix4x4* matrix)
{
  if (const Kept* const known = this->FindBalls(name, data, matrix))
  {
    this->Adding.push_back(*known);
    this->ReadMaterial(data, this->Adding.back());
    return {};
  }
  vtkHapticConversionResult balls = this->Read(Part::Points, data, matrix);
  std::string problem = balls.Mesh ? palpate::refuseSegments(balls.Mesh->triangles.size()) : balls.Problem;
  if (problem.empty())
  {
    Kept kept;
    kept.Key = BallsKey(data, matrix);
    kept.Name = name;
    kept.Surface.input.name = BallsName(name);
    kept.Surface.input.mesh = std::move(balls.Mesh);
    kept.Surface.input.lineRadius_u = this->PointRadius_u;
    kept.Baked = vtkHapticPlacementOf(matrix);
    kept.PartPoints = std::move(balls.PartPoints);
    kept.Balls = true;
    this->Adding.push_back(std::move(kept));
    this->ReadMaterial(data, this->Adding.back());
  }
  return problem;
}

std::string vtkHapticSceneSurfaces::AddWalls(const std::string& name, vtkDataObject* data, vtkMatrix4x4* matrix)
{
  if (const Kept* const known = this->FindWalls(name, data, matrix))
  {
    this->Adding.push_back(*known);
    this->NoteWithoutArrays(this->Adding.back());
    return {};
  }
  const vtkHapticConversionResult lines = this->Read(Part::Lines, data, matrix);
  const palpate::LineSurface walls =
    lines.Mesh ? palpate::wallsAcross({ name, lines.Mesh }, this->WallRadius_u) : palpate::LineSurface{};
  if (!walls.input)
  {
    return lines.Mesh ? walls.problem : lines.Problem;
  }
  Kept kept;
  kept.Key = vtkHapticContentKey(data, matrix);
  kept.Name = name;
  kept.Surface.input = *walls.input;
  kept.Baked = vtkHapticPlacementOf(matrix);
  kept.Surface.plane_WP = walls.plane_WP;
  kept.WallRadius_u = this->WallRadius_u;
  this->NoteWithoutArrays(kept);
  this->Adding.push_back(std::move(kept));
  return {};
}

void vtkHapticSceneSurfaces::NoteWithoutArrays(Kept& walls) const
{
  walls.Surface.materialNote = this->Materials.Empty() ? "" : "its own, because walls have no arrays";
}
