// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticCliScene.h"

#include <algorithm>
#include <thread>

#include "haptics/session/path/PathRunner.h"
#include "vtkHapticCliProblem.h"
#include "vtkHapticPathData.h"
#include "vtkHapticReaders.h"

vtkSmartPointer<vtkPolyData> vtkHapticCliReadData(const std::string& file, std::optional<double> iso)
{
  const vtkHapticReadResult read = vtkHapticReadSurface(file, iso);
  if (!read.Surface)
  {
    throw vtkHapticCliProblem(read.Problem);
  }
  vtkHapticCliNote(file, read.Note);
  return read.Surface;
}

std::vector<palpate::PathSurface> vtkHapticCliReadSurface(
  const std::string& file, std::optional<double> iso, const vtkHapticMaterialSettings& materials, bool curves)
{
  std::string problem;
  const vtkSmartPointer<vtkPolyData> data = vtkHapticCliReadData(file, iso);
  std::vector<palpate::PathSurface> surfaces = vtkHapticToPathSurfaces(*data, file, materials, curves, problem);
  if (surfaces.empty())
  {
    throw vtkHapticCliProblem(file + ": " + problem);
  }
  return surfaces;
}

void vtkHapticCliCheckIsoIsUsed(const std::vector<std::string>& files, std::optional<double> iso)
{
  if (iso && std::none_of(files.begin(), files.end(), vtkHapticIsImageFile))
  {
    throw vtkHapticCliProblem(files.front() + ": a mesh has no isovalue; omit --iso");
  }
}

void vtkHapticCliCheckWhole(const palpate::WholeScene& whole)
{
  if (!whole.refusal.empty())
  {
    throw vtkHapticCliProblem(whole.refused + ": cannot be touched: " + whole.refusal);
  }
}

std::shared_ptr<const palpate::Scene> vtkHapticCliBuild(const std::vector<palpate::SurfaceInput>& inputs)
{
  const palpate::WholeScene whole = palpate::wholeScene(inputs, std::thread::hardware_concurrency());
  vtkHapticCliCheckWhole(whole);
  for (const std::string& note : palpate::cleaningNotes(whole.reports))
  {
    vtkHapticCliNote("", note);
  }
  return whole.scene;
}
