// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticSceneWorker.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "vtkHapticConversion.h"

namespace
{
void Extend(std::array<double, 6>& bounds, const palpate::TriangleMesh& mesh)
{
  for (const palpate::Vec3& p_W : mesh.vertices_W)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double x = p_W[static_cast<int>(axis)];
      bounds[2 * axis] = std::min(bounds[2 * axis], x);
      bounds[2 * axis + 1] = std::max(bounds[2 * axis + 1], x);
    }
  }
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
    const std::size_t bytes = built.scene->surfaces()[next++].tree->bytes();
    report += surface.name + ": " + surface.clean.summary() + "; every kept triangle is touched, through a tree of " +
              std::to_string(bytes / kibibyte) + " KiB" + (materials[i].empty() ? "" : "; material: " + materials[i]) +
              "\n";
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
    const palpate::Vec3 first_W = built.scene->surfaces().front().tree->mesh().vertices_W.front();
    result.Bounds = { first_W.x(), first_W.x(), first_W.y(), first_W.y(), first_W.z(), first_W.z() };
    for (const palpate::Surface& surface : built.scene->surfaces())
    {
      Extend(result.Bounds, surface.tree->mesh());
    }
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
  const std::uint64_t key = vtkHapticContentKey(data, matrix);
  const auto same = [&](const Kept& kept) { return kept.Key == key && kept.Input.name == name; };
  const auto known = std::find_if(this->Committed.begin(), this->Committed.end(), same);
  if (known != this->Committed.end())
  {
    this->Adding.push_back(*known); // the same mesh object: the builder keeps its tree
    this->ReadMaterial(data, this->Adding.back());
    return {};
  }
  vtkHapticConversionResult converted = vtkHapticToMesh(data, matrix);
  if (!converted.Mesh)
  {
    return name + ": " + converted.Problem;
  }
  this->Adding.push_back(
    { key, { name, std::move(converted.Mesh), palpate::Material() }, std::move(converted.PartPoints), 0, {}, {} });
  this->ReadMaterial(data, this->Adding.back());
  return {};
}

void vtkHapticSceneWorker::Commit()
{
  this->Committed = this->Adding;
  if (this->Running.valid())
  {
    this->Again = true;
    return;
  }
  this->Launch();
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
  this->Running = std::async(std::launch::async, [this, inputs = std::move(inputs), materials = std::move(materials)]
    { return Build(this->Builder, inputs, materials); });
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
