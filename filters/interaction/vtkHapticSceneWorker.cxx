// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticSceneWorker.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "vtkHapticConversion.h"

namespace
{
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
    const std::size_t bytes = built.scene->surfaces()[next++].tree->bytes();
    report += surface.name + ": " + surface.clean.summary() + "; every kept triangle is touched, through a tree of " +
              std::to_string(bytes / kibibyte) + " KiB" + (surface.refitted ? ", refitted" : "") +
              (materials[i].empty() ? "" : "; material: " + materials[i]) + "\n";
  }
  return report;
}

vtkHapticBuiltScene Build(palpate::SceneBuilder& builder, const std::vector<palpate::SurfaceInput>& inputs,
  const std::vector<std::string>& materials)
{
  const palpate::SceneBuildResult built = builder.build(inputs);
  vtkHapticBuiltScene result;
  result.Scene = built.scene;
  result.Report = Describe(built, materials);
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

std::string vtkHapticSceneWorker::Add(const std::string& name, vtkDataObject* data, vtkMatrix4x4* matrix)
{
  this->Editing = true;
  const std::uint64_t key = vtkHapticContentKey(data, nullptr);
  if (vtkHapticCheckPlacement(matrix).empty() && this->AddKnown(name, key, vtkHapticPlacementOf(matrix)))
  {
    this->ReadMaterial(data, this->Adding.back());
    return {};
  }
  vtkHapticConversionResult converted = vtkHapticToMesh(data, matrix);
  if (!converted.Mesh)
  {
    const std::string problem = name + ": " + converted.Problem;
    this->Refusals += "not touched: " + problem + "\n";
    return problem;
  }
  Kept kept;
  kept.Key = key;
  kept.Input.name = name;
  kept.Input.mesh = std::move(converted.Mesh);
  kept.Baked = vtkHapticPlacementOf(matrix);
  kept.PartPoints = std::move(converted.PartPoints);
  this->Adding.push_back(std::move(kept));
  this->ReadMaterial(data, this->Adding.back());
  return {};
}

/// The same mesh object, so that the builder keeps its tree, if all that changed is its pose.
bool vtkHapticSceneWorker::AddKnown(const std::string& name, std::uint64_t key, const vtkHapticPlacement& placement)
{
  const auto same = [&](const Kept& kept) { return kept.Key == key && kept.Input.name == name; };
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
  const auto named = [&](const Kept& kept) { return kept.Input.name == name; };
  const auto found = std::find_if(this->Adding.begin(), this->Adding.end(), named);
  if (found == this->Adding.end())
  {
    return name + ": there is no surface of that name to move; add it first";
  }
  if (const std::string problem = vtkHapticCheckPlacement(matrix); !problem.empty())
  {
    return name + ": " + problem;
  }
  this->Editing = true;
  const vtkHapticPlacement placement = vtkHapticPlacementOf(matrix);
  if (const auto pose = vtkHapticMotionBetween(found->Baked, placement))
  {
    found->Input.pose_WS = *pose;
  }
  else
  {
    Bake(*found, placement);
  }
  return {};
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
      Bake(kept, Eigen::Translation3d(pose.p) * pose.q * kept.Baked);
    }
  }
  this->Commit(this->Stamp);
}

void vtkHapticSceneWorker::Launch()
{
  std::vector<palpate::SurfaceInput> inputs;
  std::vector<std::string> materials;
  for (const Kept& kept : this->Committed)
  {
    inputs.push_back(kept.Input);
    materials.push_back(kept.MaterialNote);
  }
  this->Again = false;
  auto build = [this, inputs, materials, refusals = this->CommittedRefusals, stamp = this->Stamp]
  {
    vtkHapticBuiltScene built = Build(this->Builder, inputs, materials);
    built.Report = refusals + built.Report;
    built.Stamp = stamp;
    return built;
  };
  // What only moves waits for nobody: a pose is felt with the next snapshot.
  const std::launch how = this->Builder.knows(inputs) ? std::launch::deferred : std::launch::async;
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
  if (this->Again)
  {
    this->Launch();
    return std::nullopt;
  }
  return built;
}

std::optional<vtkHapticBuiltScene> vtkHapticSceneWorker::Wait()
{
  while (this->Running.valid())
  {
    this->Running.wait();
    if (auto built = this->Poll())
    {
      return built;
    }
  }
  return std::nullopt;
}
