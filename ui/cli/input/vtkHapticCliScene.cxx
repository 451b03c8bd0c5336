// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticCliScene.h"

#include <algorithm>
#include <iostream>
#include <thread>

#include "vtkHapticCliProblem.h"
#include "vtkHapticConversion.h"
#include "vtkHapticReaders.h"
#include "vtkPolyData.h"

namespace
{
void Note(const std::string& file, const std::string& note)
{
  if (!note.empty())
  {
    std::cerr << "palpate: " << file << ": " << note << '\n';
  }
}

std::shared_ptr<const palpate::MaterialFields> PerSceneUnit(
  const std::shared_ptr<const palpate::MaterialFields>& fields, double scale_u_per_m)
{
  if (!fields)
  {
    return nullptr;
  }
  auto scaled = std::make_shared<palpate::MaterialFields>(*fields);
  for (double& stiffness : scaled->stiffness_N_per_m)
  {
    stiffness /= scale_u_per_m;
  }
  return scaled;
}

/// What the arrays of one surface, or of the lines in a file, give.
struct NamedMaterial
{
  std::string Name;
  vtkHapticMaterialResult Material;
};

/// An array that is in none of the files is a mistake of a person; in some of many files it may be missing.
void CheckMaterials(const std::vector<NamedMaterial>& materials)
{
  const auto broken = [](const NamedMaterial& one) { return !one.Material.Problem.empty(); };
  if (std::all_of(materials.begin(), materials.end(), broken))
  {
    throw vtkHapticCliProblem(materials.front().Name + ": " + materials.front().Material.Problem);
  }
  for (const NamedMaterial& one : materials)
  {
    Note(one.Name, one.Material.Note);
  }
}

void CheckIsoIsUsed(const std::vector<std::string>& files, std::optional<double> iso)
{
  if (iso && std::none_of(files.begin(), files.end(), vtkHapticIsImageFile))
  {
    throw vtkHapticCliProblem(files.front() + ": it is a mesh and has no iso value; leave out --iso");
  }
}

/// Says what cleaning took from surfaces.
void NoteCleaning(const std::vector<palpate::SurfaceReport>& reports)
{
  for (const palpate::SurfaceReport& report : reports)
  {
    if (report.clean.trianglesOut < report.clean.trianglesIn || !report.holeEdges.empty())
    {
      Note(report.name, report.summary());
    }
  }
}
} // namespace

vtkHapticCliSurface vtkHapticCliReadSurface(
  const std::string& file, std::optional<double> iso, const vtkHapticMaterialSettings& materials, bool lines)
{
  const vtkHapticReadResult read = vtkHapticReadSurface(file, iso);
  if (!read.Surface)
  {
    throw vtkHapticCliProblem(read.Problem);
  }
  Note(file, read.Note);
  vtkHapticCliSurface surface;
  if (lines && vtkHapticCountLines(read.Surface) > 0)
  {
    const vtkHapticConversionResult converted = vtkHapticToLines(read.Surface);
    surface.Lines = converted.Mesh;
    surface.LineMaterial = vtkHapticToMaterial(read.Surface, converted.PartPoints, materials);
  }
  if (surface.Lines && read.Surface->GetNumberOfPolys() + read.Surface->GetNumberOfStrips() == 0)
  {
    surface.Input.name = file;
    return surface;
  }
  vtkHapticConversionResult converted = vtkHapticToMesh(read.Surface);
  if (!converted.Mesh)
  {
    throw vtkHapticCliProblem(file + ": " + converted.Problem);
  }
  surface.Material = vtkHapticToMaterial(read.Surface, converted.PartPoints, materials);
  surface.Input = { file, std::move(converted.Mesh), palpate::Material(), surface.Material.Fields };
  surface.Input.holeEdges = std::move(converted.HoleEdges);
  return surface;
}

std::shared_ptr<const palpate::Scene> vtkHapticCliBuildScene(const std::vector<std::string>& files,
  std::optional<double> iso, const vtkHapticMaterialSettings& materials, double scale_u_per_m, double lineRadius_u)
{
  CheckIsoIsUsed(files, iso);
  std::vector<NamedMaterial> read;
  std::vector<palpate::SurfaceInput> inputs;
  const auto add = [&](palpate::SurfaceInput input, const vtkHapticMaterialResult& material)
  {
    read.push_back({ input.name, material });
    input.fields = PerSceneUnit(input.fields, scale_u_per_m);
    inputs.push_back(std::move(input));
  };
  for (const std::string& file : files)
  {
    const vtkHapticCliSurface surface =
      vtkHapticCliReadSurface(file, vtkHapticIsImageFile(file) ? iso : std::nullopt, materials, lineRadius_u > 0.0);
    if (surface.Input.mesh)
    {
      add(surface.Input, surface.Material);
    }
    if (surface.Lines)
    {
      add(vtkHapticCliTubesOf(file, surface, lineRadius_u), surface.LineMaterial);
    }
  }
  const auto isTubes = [](const palpate::SurfaceInput& input) { return input.lineRadius_u.has_value(); };
  if (lineRadius_u > 0.0 && std::none_of(inputs.begin(), inputs.end(), isTubes))
  {
    throw vtkHapticCliProblem(files.front() + ": it has no lines; leave out --line-radius");
  }
  CheckMaterials(read);
  return vtkHapticCliBuild(inputs);
}

palpate::SurfaceInput vtkHapticCliTubesOf(
  const std::string& file, const vtkHapticCliSurface& surface, double lineRadius_u)
{
  const palpate::LineSurface tubes =
    palpate::tubesOf({ file, surface.Lines, surface.LineMaterial.Fields }, lineRadius_u);
  if (!tubes.input)
  {
    throw vtkHapticCliProblem(file + ": " + tubes.problem);
  }
  return *tubes.input;
}

void vtkHapticCliCheckWhole(const palpate::WholeScene& whole)
{
  if (!whole.refusal.empty())
  {
    throw vtkHapticCliProblem(whole.refused + ": it cannot be touched: " + whole.refusal);
  }
}

std::shared_ptr<const palpate::Scene> vtkHapticCliBuild(const std::vector<palpate::SurfaceInput>& inputs)
{
  const palpate::WholeScene whole = palpate::wholeScene(inputs, std::thread::hardware_concurrency());
  vtkHapticCliCheckWhole(whole);
  NoteCleaning(whole.reports);
  return whole.scene;
}
