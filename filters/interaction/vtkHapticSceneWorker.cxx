// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticSceneWorker.h"

#include <algorithm>
#include <chrono>
#include <sstream>
#include <utility>

#include "haptics/contact/RadiusLimit.h"
#include "haptics/contact/view/PlanFor.h"
#include "haptics/core/WordHash.h"
#include "haptics/geometry/curves/CurveSet.h"
#include "vtkHapticConversion.h"
#include "vtkHapticPlaneWalls.h"

namespace
{
std::string DescribeTubes(const palpate::SurfaceTree& tree, const palpate::Scene& scene)
{
  std::ostringstream text;
  text << "segment is touched as a tube of " << tree.coat_u() << " u, by a point as by a ball of "
       << palpate::planFor(scene, {}).radius_u << " u";
  return text.str();
}

/// `materials`: a note for each report, or "".
std::string Describe(const palpate::SceneBuildResult& built, const std::vector<std::string>& materials)
{
  constexpr std::size_t kibibyte = 1024;
  std::string report;
  std::size_t next = 0; // refused surfaces are not in the scene
  for (std::size_t i = 0; i < built.reports.size(); ++i)
  {
    const palpate::SurfaceReport& surface = built.reports[i];
    if (!surface.refusal.empty())
    {
      report += surface.name + ": refused: " + surface.refusal + "\n";
      continue;
    }
    const palpate::SurfaceTree& tree = *built.scene->surfaces()[next++].tree;
    report += surface.name + ": " + surface.summary() + "; every kept " +
              (surface.clean.segments ? DescribeTubes(tree, *built.scene) : "triangle is touched") +
              ", through a tree of " + std::to_string(tree.bytes() / kibibyte) + " KiB" +
              (surface.refitted ? ", refitted" : "") + (materials[i].empty() ? "" : "; material: " + materials[i]) +
              "\n";
  }
  return report;
}

/// Names the frame that vertices are in which were placed so.
std::uint64_t FrameOf(const vtkHapticPlacement& baked)
{
  palpate::WordHash hash;
  std::for_each(
    baked.matrix().data(), baked.matrix().data() + baked.matrix().size(), [&hash](double number) { hash.add(number); });
  return hash.value();
}

double LargestRadius(const palpate::Scene* scene)
{
  return scene ? palpate::radiusLimit(*scene, {}).largest_u : std::numeric_limits<double>::infinity();
}

/// `planes_WP`: across which an input stands, if it is walls.
vtkHapticBuiltScene Build(palpate::SceneBuilder& builder, const std::vector<palpate::SurfaceInput>& inputs,
  const palpate::Scene* felt, const std::vector<std::string>& materials,
  const std::vector<std::optional<palpate::Pose>>& planes_WP)
{
  const palpate::SceneBuildResult built = builder.build(inputs, felt);
  vtkHapticBuiltScene result;
  result.Scene = built.scene;
  result.Report = Describe(built, materials);
  for (std::size_t i = 0; i < built.reports.size(); ++i)
  {
    if (built.reports[i].refusal.empty())
    {
      result.Traits.deforms.push_back(built.reports[i].refitted);
      result.Traits.walls_WP.push_back(planes_WP[i]);
    }
  }
  if (built.scene)
  {
    const palpate::Box& box = built.scene->surfaceTree().bounds;
    const palpate::Vec3 &low_W = box.low_W, &high_W = box.high_W;
    result.Bounds = { low_W.x(), high_W.x(), low_W.y(), high_W.y(), low_W.z(), high_W.z() };
  }
  return result;
}
} // namespace

vtkHapticSceneWorker::~vtkHapticSceneWorker()
{
  this->Wait();
}

void vtkHapticSceneWorker::Clear()
{
  this->Adding.clear();
  this->Refusals.clear();
  this->Editing = true;
}

void vtkHapticSceneWorker::SetMaterials(const vtkHapticMaterialSettings& settings)
{
  this->Materials = settings;
}

/// Unless they are what was read before: the arrays of a million points take a while.
void vtkHapticSceneWorker::ReadMaterial(vtkDataObject* data, Kept& kept) const
{
  const std::uint64_t key = this->Materials.Empty() ? 0 : vtkHapticArraysKey(data);
  if (kept.Settings == this->Materials && kept.ArraysKey == key)
  {
    return;
  }
  vtkHapticMaterialResult material = vtkHapticToMaterial(data, kept.PartPoints, this->Materials);
  kept.Input.fields = std::move(material.Fields);
  kept.MaterialNote = std::move(material.Note);
  kept.Settings = this->Materials;
  kept.ArraysKey = key;
}

void vtkHapticSceneWorker::SetLineRadius(double radius_u)
{
  this->LineRadius_u = radius_u;
}

void vtkHapticSceneWorker::SetPlaneWorld(bool on, double radius_u)
{
  this->PlaneWorld = on;
  this->WallRadius_u = radius_u;
}

std::string vtkHapticSceneWorker::AddWalls(const std::string& name, vtkDataObject* data, vtkMatrix4x4* matrix)
{
  const std::uint64_t key = vtkHapticContentKey(data, matrix);
  const auto same = [&](const Kept& kept)
  { return kept.Key == key && kept.Name == name && kept.Plane_WP && kept.WallRadius_u == this->WallRadius_u; };
  if (const auto known = std::find_if(this->Committed.begin(), this->Committed.end(), same);
      known != this->Committed.end())
  {
    this->Adding.push_back(*known);
    this->NoteWithoutArrays(this->Adding.back());
    return {};
  }
  vtkHapticPlaneWalls walls = vtkHapticRaiseLines(data, matrix, this->WallRadius_u);
  if (!walls.Mesh)
  {
    return walls.Problem;
  }
  Kept kept;
  kept.Key = key;
  kept.Name = name;
  kept.Input.name = name + " (walls)";
  kept.Input.mesh = std::move(walls.Mesh);
  kept.Baked = vtkHapticPlacementOf(matrix);
  kept.Plane_WP = walls.Plane_WP;
  kept.WallRadius_u = this->WallRadius_u;
  this->NoteWithoutArrays(kept);
  this->Adding.push_back(std::move(kept));
  return {};
}

void vtkHapticSceneWorker::NoteWithoutArrays(Kept& walls) const
{
  walls.MaterialNote = this->Materials.Empty() ? "" : "its own, for walls are felt without arrays";
}

std::optional<palpate::Pose> vtkHapticSceneWorker::CommittedPlane() const
{
  std::optional<palpate::Pose> all_WP;
  for (const Kept& kept : this->Committed)
  {
    if (!kept.Plane_WP)
    {
      return std::nullopt;
    }
    const palpate::Pose &moved = kept.Input.pose_WS, &plane = *kept.Plane_WP;
    const palpate::Pose one{ moved.p + moved.q * plane.p, moved.q * plane.q };
    const double size_u = kept.Input.mesh->vertices_W.front().cwiseAbs().maxCoeff();
    all_WP = all_WP ? vtkHapticOnePlane(*all_WP, one, size_u) : one;
    if (!all_WP)
    {
      return std::nullopt;
    }
  }
  return all_WP;
}

std::string vtkHapticSceneWorker::Add(const std::string& name, vtkDataObject* data, vtkMatrix4x4* matrix)
{
  this->Editing = true;
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
  if (!problem.empty())
  {
    problem = name + ": " + problem;
    this->Refusals += "not touched: " + problem + "\n";
  }
  return problem;
}

std::string vtkHapticSceneWorker::AddPart(
  const std::string& name, vtkDataObject* data, vtkMatrix4x4* matrix, std::optional<double> lineRadius_u)
{
  const std::uint64_t key = vtkHapticContentKey(data, nullptr);
  if (vtkHapticCheckPlacement(matrix).empty() && this->AddKnown(name, key, vtkHapticPlacementOf(matrix), lineRadius_u))
  {
    this->ReadMaterial(data, this->Adding.back());
    return {};
  }
  vtkHapticConversionResult converted =
    lineRadius_u ? vtkHapticToLines(data, matrix) : vtkHapticToMesh(data, matrix, this->CutsOf(name));
  if (!converted.Mesh)
  {
    return converted.Problem;
  }
  if (const std::string many = lineRadius_u ? palpate::refuseSegments(converted.Mesh->triangles.size()) : "";
      !many.empty())
  {
    return many;
  }
  Kept kept;
  kept.Key = key;
  kept.Name = name;
  kept.Input.name = lineRadius_u ? name + " (lines)" : name;
  kept.Input.mesh = std::move(converted.Mesh);
  kept.Input.lineRadius_u = lineRadius_u;
  kept.Baked = vtkHapticPlacementOf(matrix);
  kept.Cuts = std::move(converted.Cuts);
  kept.PartPoints = std::move(converted.PartPoints);
  kept.Input.holeEdges = std::move(converted.HoleEdges);
  this->KeepFrame(kept);
  this->Adding.push_back(std::move(kept));
  this->ReadMaterial(data, this->Adding.back());
  return {};
}

void vtkHapticSceneWorker::KeepFrame(Kept& kept) const
{
  const auto same = [&kept](const Kept& was)
  {
    return was.Name == kept.Name && !was.Plane_WP && was.Input.lineRadius_u == kept.Input.lineRadius_u &&
           was.Input.mesh->triangles == kept.Input.mesh->triangles;
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
    kept.Input.mesh = std::make_shared<const palpate::TriangleMesh>(vtkHapticPlaced(*kept.Input.mesh, back));
    kept.Input.pose_WS = *pose;
  }
  kept.Baked = was->Baked;
}

const vtkHapticCuts* vtkHapticSceneWorker::CutsOf(const std::string& name) const
{
  const auto known = std::find_if(this->Committed.begin(), this->Committed.end(),
    [&name](const Kept& kept) { return kept.Name == name && kept.Cuts.Mesh; });
  return known != this->Committed.end() ? &known->Cuts : nullptr;
}

/// The same mesh object, so that the builder keeps its tree, if all that changed is its pose.
bool vtkHapticSceneWorker::AddKnown(
  const std::string& name, std::uint64_t key, const vtkHapticPlacement& placement, std::optional<double> lineRadius_u)
{
  const auto same = [&](const Kept& kept)
  { return kept.Key == key && kept.Name == name && !kept.Plane_WP && kept.Input.lineRadius_u == lineRadius_u; };
  const auto known = std::find_if(this->Committed.begin(), this->Committed.end(), same);
  const auto pose = known != this->Committed.end() ? vtkHapticMotionBetween(known->Baked, placement) : std::nullopt;
  if (pose)
  {
    this->Adding.push_back(*known);
    this->Adding.back().Input.pose_WS = *pose;
  }
  return pose.has_value();
}

std::string vtkHapticSceneWorker::Place(const std::string& name, vtkMatrix4x4* matrix)
{
  const auto named = [&](const Kept& kept) { return kept.Name == name; };
  if (std::none_of(this->Adding.begin(), this->Adding.end(), named))
  {
    return name + ": there is no surface of that name to move; add it first";
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

void vtkHapticSceneWorker::MoveTo(Kept& kept, const vtkHapticPlacement& placement)
{
  if (const auto pose = vtkHapticMotionBetween(kept.Baked, placement))
  {
    kept.Input.pose_WS = *pose;
  }
  else
  {
    kept.Plane_WP.reset(); // walls that are sheared stand across nothing
    Bake(kept, placement);
  }
}

void vtkHapticSceneWorker::Bake(Kept& kept, const vtkHapticPlacement& placement)
{
  kept.Input.mesh =
    std::make_shared<const palpate::TriangleMesh>(vtkHapticPlaced(*kept.Input.mesh, placement * kept.Baked.inverse()));
  kept.Input.pose_WS = {};
  kept.Baked = placement;
}

void vtkHapticSceneWorker::Commit(double stamp_s)
{
  this->Editing = false;
  this->Stamp = stamp_s;
  this->Committed = this->Adding;
  this->CommittedRefusals = this->Refusals;
  if (this->Running.valid())
  {
    this->Again = true;
    return;
  }
  this->Launch();
}

void vtkHapticSceneWorker::Settle()
{
  if (this->Editing || this->Running.valid())
  {
    return;
  }
  for (Kept& kept : this->Adding)
  {
    const palpate::Pose& pose = kept.Input.pose_WS;
    if (pose.p != palpate::Vec3::Zero() || pose.q.coeffs() != palpate::Quat::Identity().coeffs())
    {
      if (kept.Plane_WP)
      {
        kept.Plane_WP = palpate::Pose{ pose.p + pose.q * kept.Plane_WP->p, pose.q * kept.Plane_WP->q };
      }
      Bake(kept, Eigen::Translation3d(pose.p) * pose.q * kept.Baked);
    }
  }
  this->Felt.reset(); // nothing comes from elsewhere any more
  this->Commit(this->Stamp);
}

void vtkHapticSceneWorker::Follow(std::shared_ptr<const palpate::Scene> felt)
{
  this->Felt = std::move(felt);
  this->Resume();
}

void vtkHapticSceneWorker::Resume()
{
  if (this->Again && !this->Running.valid())
  {
    this->Launch();
  }
}

void vtkHapticSceneWorker::Launch()
{
  std::vector<palpate::SurfaceInput> inputs;
  std::vector<std::string> materials;
  std::vector<std::optional<palpate::Pose>> planes_WP;
  for (const Kept& kept : this->Committed)
  {
    inputs.push_back(kept.Input);
    inputs.back().frame = FrameOf(kept.Baked);
    materials.push_back(kept.MaterialNote);
    planes_WP.push_back(kept.Plane_WP);
  }
  this->Again = false;
  // What only moves waits for nobody: a pose is felt with the next snapshot, and balls stay as large as they may be.
  const std::launch how = this->Builder.knows(inputs, this->Felt.get()) ? std::launch::deferred : std::launch::async;
  auto build = [this, how, inputs, materials, planes_WP, felt = this->Felt, refusals = this->CommittedRefusals,
                 stamp = this->Stamp, plane = this->CommittedPlane(), largest = this->LargestRadius_u]
  {
    vtkHapticBuiltScene built = Build(this->Builder, inputs, felt.get(), materials, planes_WP);
    built.Report = refusals + built.Report;
    built.Stamp = stamp;
    built.Plane_WP = plane;
    built.LargestRadius_u = how == std::launch::deferred ? largest : LargestRadius(built.Scene.get());
    return built;
  };
  this->Running = std::async(how, std::move(build));
  if (how == std::launch::deferred)
  {
    this->Running.wait();
  }
}

std::optional<vtkHapticBuiltScene> vtkHapticSceneWorker::Poll()
{
  if (!this->Running.valid() || this->Running.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
  {
    return std::nullopt;
  }
  vtkHapticBuiltScene built = this->Running.get();
  this->LargestRadius_u = built.LargestRadius_u;
  return built;
}

std::optional<vtkHapticBuiltScene> vtkHapticSceneWorker::Wait()
{
  std::optional<vtkHapticBuiltScene> newest;
  while (this->Running.valid())
  {
    this->Running.wait();
    newest = this->Poll();
    this->Resume();
  }
  return newest;
}

std::uint64_t vtkHapticSceneWorker::TakeRevision()
{
  return this->Builder.takeRevision();
}
