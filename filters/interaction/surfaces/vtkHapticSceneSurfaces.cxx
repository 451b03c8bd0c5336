// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticSceneSurfaces.h"

#include <algorithm>
#include <set>
#include <utility>

#include "haptics/core/PoseMath.h"
#include "haptics/core/WordHash.h"
#include "haptics/geometry/curves/CurveSet.h"
#include "haptics/session/scene/SceneWorker.h"
#include "haptics/session/scene/TouchedData.h"
#include "vtkHapticConversion.h"
#include "vtkHapticPointBalls.h"

namespace
{
/// Names the frame that vertices are in which were placed so.
std::uint64_t FrameOf(const vtkHapticPlacement& baked)
{
  palpate::WordHash hash;
  std::for_each(
    baked.matrix().data(), baked.matrix().data() + baked.matrix().size(), [&hash](double number) { hash.add(number); });
  return hash.value();
}
} // namespace

void vtkHapticSceneSurfaces::Clear()
{
  this->Adding.clear();
  this->Refusals.clear();
  this->Editing = true;
}

void vtkHapticSceneSurfaces::SetMaterials(const vtkHapticMaterialSettings& settings)
{
  this->Materials = settings;
}

/// Unless they are those that were read before: the arrays of a million points take a while.
void vtkHapticSceneSurfaces::ReadMaterial(vtkDataObject* data, Kept& kept) const
{
  const std::uint64_t key = this->Materials.Empty() ? 0 : vtkHapticArraysKey(data);
  if (kept.Settings == this->Materials && kept.ArraysKey == key)
  {
    return;
  }
  const vtkSmartPointer<vtkDataObject> arrays = kept.Balls ? vtkHapticBallArrays(data).Get() : data;
  vtkHapticMaterialResult material = vtkHapticToMaterial(arrays, kept.PartPoints, this->Materials);
  kept.Surface.input.fields = std::move(material.Fields);
  kept.Surface.materialNote = std::move(material.Note);
  kept.Settings = this->Materials;
  kept.ArraysKey = key;
}

void vtkHapticSceneSurfaces::SetLineRadius(double radius_u)
{
  this->LineRadius_u = radius_u;
}

void vtkHapticSceneSurfaces::SetPointRadius(double radius_u)
{
  if (radius_u != this->PointRadius_u)
  {
    this->PointRadius_u = radius_u;
    this->Ahead.Forget(); // balls of another size are being read
  }
}

void vtkHapticSceneSurfaces::SetPlaneWorld(bool on, double radius_u)
{
  this->PlaneWorld = on;
  this->WallRadius_u = radius_u;
}

std::string vtkHapticSceneSurfaces::Add(const std::string& name, vtkDataObject* data, vtkMatrix4x4* matrix)
{
  const vtkHapticSourceStyle style = this->OfSources.Of(name);
  if (!style.Touched)
  {
    this->Editing = true;
    this->Refusals += "not touched: " + name + ": the source is switched off\n";
    return {};
  }
  const std::size_t before = this->Adding.size();
  std::string problem = this->AddParts(name, data, matrix);
  if (before < this->Adding.size())
  {
    const vtkSmartPointer<vtkDataObject> copy = vtkHapticSharedCopy(data);
    for (std::size_t i = before; i < this->Adding.size(); ++i)
    {
      this->Adding[i].Data = copy;
      this->Adding[i].Surface.input.material = style.Material;
    }
  }
  return problem;
}

std::string vtkHapticSceneSurfaces::AddLinesAndFaces(const std::string& name, vtkDataObject* data, vtkMatrix4x4* matrix)
{
  const std::size_t lines = vtkHapticCountLines(data);
  const bool raised = lines > 0 && this->PlaneWorld && vtkHapticCheckPlacement(matrix).empty();
  const std::string ofWalls = raised ? this->AddWalls(name, data, matrix) : "";
  std::string problem = this->AddPart(name, data, matrix, std::nullopt);
  if (raised && ofWalls.empty())
  {
    return {}; // polygons beside them are touched as well, where there are any
  }
  if (raised && this->LineRadius_u == 0.0 && !problem.empty())
  {
    problem = ofWalls;
  }
  if (lines > 0 && this->LineRadius_u != 0.0)
  {
    const std::string ofLines = this->AddPart(name, data, matrix, this->LineRadius_u);
    this->Refusals += problem.empty() && !ofLines.empty() ? "not touched: " + name + ": " + ofLines + "\n" : "";
    problem = problem.empty() ? problem : ofLines;
  }
  else if (lines > 0 && problem.empty())
  {
    this->Refusals += "not touched: " + name + ": " + std::to_string(lines) + " lines; their radius is 0\n";
  }
  return problem;
}

std::string vtkHapticSceneSurfaces::AddParts(const std::string& name, vtkDataObject* data, vtkMatrix4x4* matrix)
{
  this->Editing = true;
  std::string problem = this->AddLinesAndFaces(name, data, matrix);
  if (this->PointRadius_u > 0.0 && vtkHapticCountPoints(data) > 0)
  {
    const std::string ofBalls = this->AddBalls(name, data, matrix);
    this->Refusals += problem.empty() && !ofBalls.empty() ? "not touched: " + name + ": " + ofBalls + "\n" : "";
    problem = problem.empty() ? problem : ofBalls; // a cloud has no polygons
  }
  if (!problem.empty())
  {
    problem = name + ": " + problem;
    this->Refusals += "not touched: " + problem + "\n";
  }
  return problem;
}

std::string vtkHapticSceneSurfaces::AddPart(
  const std::string& name, vtkDataObject* data, vtkMatrix4x4* matrix, std::optional<double> lineRadius_u)
{
  const std::uint64_t key = vtkHapticContentKey(data, nullptr);
  if (vtkHapticCheckPlacement(matrix).empty() && this->AddKnown(name, key, vtkHapticPlacementOf(matrix), lineRadius_u))
  {
    this->ReadMaterial(data, this->Adding.back());
    return {};
  }
  vtkHapticConversionResult converted =
    lineRadius_u ? this->Read(Part::Lines, data, matrix) : this->ReadFaces(name, data, matrix);
  if (!converted.Mesh)
  {
    return converted.Problem;
  }
  Kept kept;
  kept.Key = key;
  kept.Name = name;
  kept.Surface.input.name = this->PartNumber > 0 ? name + " (part " + std::to_string(this->PartNumber) + ")" : name;
  kept.Surface.input.mesh = converted.Mesh;
  if (lineRadius_u)
  {
    const palpate::LineSurface tubes = palpate::tubesOf({ name, converted.Mesh }, *lineRadius_u);
    if (!tubes.input)
    {
      return tubes.problem;
    }
    kept.Surface.input = *tubes.input;
  }
  kept.Baked = vtkHapticPlacementOf(matrix);
  kept.Cuts = std::move(converted.Cuts);
  kept.PartPoints = std::move(converted.PartPoints);
  kept.Surface.input.holeEdges = std::move(converted.HoleEdges);
  this->KeepFrame(kept);
  this->Adding.push_back(std::move(kept));
  this->ReadMaterial(data, this->Adding.back());
  return {};
}

void vtkHapticSceneSurfaces::KeepFrame(Kept& kept) const
{
  const auto same = [&kept](const Kept& was)
  {
    return was.Name == kept.Name && !was.Surface.plane_WP &&
           was.Surface.input.lineRadius_u == kept.Surface.input.lineRadius_u &&
           was.Surface.input.mesh->triangles == kept.Surface.input.mesh->triangles;
  };
  const auto was = std::find_if(this->Committed.begin(), this->Committed.end(), same);
  const auto pose = was != this->Committed.end() ? vtkHapticMotionBetween(was->Baked, kept.Baked) : std::nullopt;
  if (!pose)
  {
    return;
  }
  constexpr double rounding = 1e-12;
  if (!was->Baked.isApprox(kept.Baked, rounding))
  {
    const vtkHapticPlacement back = (Eigen::Translation3d(pose->p) * pose->q).inverse(Eigen::Isometry);
    kept.Surface.input.mesh =
      std::make_shared<const palpate::TriangleMesh>(vtkHapticPlaced(*kept.Surface.input.mesh, back));
    kept.Surface.input.pose_WS = *pose;
  }
  kept.Baked = was->Baked;
}

const vtkHapticCuts* vtkHapticSceneSurfaces::CutsOf(const std::string& name) const
{
  const auto known = std::find_if(this->Committed.begin(), this->Committed.end(),
    [&name](const Kept& kept) { return kept.Name == name && kept.Cuts.Mesh; });
  return known != this->Committed.end() ? &known->Cuts : nullptr;
}

std::pair<const vtkHapticSceneSurfaces::Kept*, palpate::Pose> vtkHapticSceneSurfaces::FindKnown(const std::string& name,
  std::uint64_t key, const vtkHapticPlacement& placement, std::optional<double> lineRadius_u) const
{
  const auto same = [&](const Kept& kept)
  {
    return kept.Key == key && kept.Name == name && !kept.Surface.plane_WP &&
           kept.Surface.input.lineRadius_u == lineRadius_u;
  };
  const auto known = std::find_if(this->Committed.begin(), this->Committed.end(), same);
  const auto pose = known != this->Committed.end() ? vtkHapticMotionBetween(known->Baked, placement) : std::nullopt;
  return { pose ? &*known : nullptr, pose.value_or(palpate::Pose()) };
}

/// The same mesh object, so that the builder keeps its tree, if all that changed is its pose.
bool vtkHapticSceneSurfaces::AddKnown(
  const std::string& name, std::uint64_t key, const vtkHapticPlacement& placement, std::optional<double> lineRadius_u)
{
  const auto [known, pose] = this->FindKnown(name, key, placement, lineRadius_u);
  if (known)
  {
    this->Adding.push_back(*known);
    this->Adding.back().Surface.input.pose_WS = pose;
  }
  return known != nullptr;
}

std::string vtkHapticSceneSurfaces::Place(const std::string& name, vtkMatrix4x4* matrix)
{
  const auto named = [&](const Kept& kept) { return kept.Name == name; };
  if (std::none_of(this->Adding.begin(), this->Adding.end(), named))
  {
    return name + ": no surface of that name exists; add the surface first";
  }
  if (const std::string problem = vtkHapticCheckPlacement(matrix); !problem.empty())
  {
    return name + ": " + problem;
  }
  this->Editing = true;
  for (Kept& kept : this->Adding)
  {
    if (named(kept))
    {
      MoveTo(kept, vtkHapticPlacementOf(matrix));
    }
  }
  return {};
}

void vtkHapticSceneSurfaces::MoveTo(Kept& kept, const vtkHapticPlacement& placement)
{
  if (const auto pose = vtkHapticMotionBetween(kept.Baked, placement))
  {
    kept.Surface.input.pose_WS = *pose;
  }
  else
  {
    kept.Surface.plane_WP.reset(); // walls that are sheared stand across nothing
    Bake(kept, placement);
  }
}

void vtkHapticSceneSurfaces::Bake(Kept& kept, const vtkHapticPlacement& placement)
{
  kept.Surface.input.mesh = std::make_shared<const palpate::TriangleMesh>(
    vtkHapticPlaced(*kept.Surface.input.mesh, placement * kept.Baked.inverse()));
  kept.Surface.input.pose_WS = {};
  kept.Baked = placement;
}

void vtkHapticSceneSurfaces::Commit(palpate::SceneWorker& worker, double stamp_s)
{
  this->Editing = false;
  this->Stamp = stamp_s;
  this->Committed = this->Adding;
  this->Ahead.Forget();
  ++this->CommitCount;
  std::vector<palpate::SceneSurface> surfaces;
  for (const Kept& kept : this->Committed)
  {
    surfaces.push_back(kept.Surface);
    surfaces.back().input.frame = FrameOf(kept.Baked);
  }
  worker.commit(std::move(surfaces), this->Refusals, stamp_s, this->ScenePart);
}

std::optional<vtkHapticSceneSurfaces::Origin> vtkHapticSceneSurfaces::OriginWhere(
  const std::function<bool(const Kept&)>& sought) const
{
  const auto found = std::find_if(this->Committed.begin(), this->Committed.end(), sought);
  if (found == this->Committed.end() || !found->Data)
  {
    return std::nullopt;
  }
  const palpate::Pose& pose_WS = found->Surface.input.pose_WS;
  return Origin{ found->Name, found->Data, Eigen::Translation3d(pose_WS.p) * pose_WS.q * found->Baked };
}

std::optional<vtkHapticSceneSurfaces::Origin> vtkHapticSceneSurfaces::OriginOf(const std::string& surface) const
{
  return this->OriginWhere([&surface](const Kept& kept) { return kept.Surface.input.name == surface; });
}

std::optional<vtkHapticSceneSurfaces::Origin> vtkHapticSceneSurfaces::SourceNamed(const std::string& name) const
{
  return this->OriginWhere([&name](const Kept& kept) { return kept.Name == name; });
}

std::string vtkHapticSceneSurfaces::MissingArrays() const
{
  std::set<std::string> there;
  for (const Kept& kept : this->Committed)
  {
    const std::vector<std::string> names = vtkHapticArrayNames(kept.Data);
    there.insert(names.begin(), names.end());
  }
  std::string missing;
  for (const auto& [what, array] :
    { std::pair{ "Stiffness", this->Materials.Stiffness.Array },
      std::pair{ "Friction", this->Materials.Friction.Array }, std::pair{ "Texture", this->Materials.Texture.Array } })
  {
    if (!array.empty() && !this->Committed.empty() && there.count(array) == 0)
    {
      missing += std::string(what) + " is set from the array '" + array +
                 "', but no touchable source has this array: choose another one (page Material)\n";
    }
  }
  return missing;
}

void vtkHapticSceneSurfaces::Settle(palpate::SceneWorker& worker)
{
  if (this->Editing || worker.building())
  {
    return;
  }
  for (Kept& kept : this->Adding)
  {
    const palpate::Pose pose = kept.Surface.input.pose_WS;
    if (pose.p != palpate::Vec3::Zero() || pose.q.coeffs() != palpate::Quat::Identity().coeffs())
    {
      if (std::optional<palpate::Pose>& plane_WP = kept.Surface.plane_WP)
      {
        plane_WP = pose * *plane_WP;
      }
      Bake(kept, Eigen::Translation3d(pose.p) * pose.q * kept.Baked);
    }
  }
  worker.forget();
  this->Commit(worker, this->Stamp);
}
