// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticCliScene.h"

#include <algorithm>
#include <iostream>
#include <thread>

#include "vtkHapticCliProblem.h"
#include "vtkHapticConversion.h"
#include "vtkHapticMessageCapture.h"
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

void CheckIsoIsUsed(const std::vector<std::string>& files, std::optional<double> iso)
{
  if (iso && std::none_of(files.begin(), files.end(), vtkHapticIsImageFile))
  {
    throw vtkHapticCliProblem(files.front() + ": it is a mesh and has no iso value; leave out --iso");
  }
}

/// Names every surface that cannot be touched, and says what cleaning took from the others.
void CheckReports(const std::vector<palpate::SurfaceReport>& reports)
{
  for (const palpate::SurfaceReport& report : reports)
  {
    if (!report.refusal.empty())
    {
      throw vtkHapticCliProblem(report.name + ": it cannot be touched: " + report.refusal);
    }
    if (report.clean.trianglesOut < report.clean.trianglesIn)
    {
      Note(report.name, report.clean.summary());
    }
  }
}
} // namespace

palpate::SurfaceInput vtkHapticCliReadSurface(const std::string& file, std::optional<double> iso)
{
  const vtkHapticReadResult read = vtkHapticReadSurface(file, iso);
  if (!read.Surface)
  {
    throw vtkHapticCliProblem(read.Problem);
  }
  Note(file, read.Note);
  const vtkHapticMessageCapture messages;
  const vtkHapticConversionResult converted = vtkHapticToMesh(read.Surface);
  if (!converted.Mesh)
  {
    throw vtkHapticCliProblem(file + ": " + converted.Problem);
  }
  Note(file, messages.FirstError().empty() ? messages.FirstWarning() : messages.FirstError());
  return { file, converted.Mesh, palpate::Material() };
}

std::shared_ptr<const palpate::Scene> vtkHapticCliBuildScene(
  const std::vector<std::string>& files, std::optional<double> iso)
{
  CheckIsoIsUsed(files, iso);
  std::vector<palpate::SurfaceInput> inputs;
  inputs.reserve(files.size());
  for (const std::string& file : files)
  {
    inputs.push_back(vtkHapticCliReadSurface(file, vtkHapticIsImageFile(file) ? iso : std::nullopt));
  }
  const palpate::SceneBuildResult built = palpate::SceneBuilder(std::thread::hardware_concurrency()).build(inputs);
  CheckReports(built.reports);
  return built.scene;
}
