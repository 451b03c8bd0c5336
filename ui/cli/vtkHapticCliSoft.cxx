// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticCliSoft.h"

#include <iostream>

#include "vtkDataSet.h"
#include "vtkHapticCliProblem.h"
#include "vtkHapticReaders.h"
#include "vtkHapticSoftBodyData.h"
#include "vtkHapticTetraFill.h"
#include "vtkPolyData.h"

namespace
{
/// Tetrahedra of a volume, or what fills a closed surface.
vtkSmartPointer<vtkUnstructuredGrid> ReadBody(const std::string& file, double& rough, std::string& problem)
{
  if (vtkHapticIsVolumeFile(file))
  {
    const vtkHapticReadVolumeResult read = vtkHapticReadVolume(file);
    if (!read.Volume)
    {
      throw vtkHapticCliProblem(read.Problem);
    }
    return vtkHapticTetrahedra(read.Volume, problem);
  }
  const vtkHapticReadResult read = vtkHapticReadSurface(file, {});
  if (!read.Surface)
  {
    throw vtkHapticCliProblem(read.Problem);
  }
  const vtkHapticTetraFillResult made = vtkHapticFillSurface(*read.Surface, {}, palpate::always);
  problem = made.Problem;
  rough = made.Rough;
  if (!made.Note.empty() && made.Grid)
  {
    std::cerr << "palpate: " << file << ": " << made.Note << '\n';
  }
  return made.Grid;
}

palpate::ElasticModel ModelOf(const std::string& name)
{
  return name == "linear"         ? palpate::ElasticModel::Linear
         : name == "corotational" ? palpate::ElasticModel::CoRotational
                                  : palpate::ElasticModel::NeoHookean;
}

/// What a soft body is not felt with would be lost.
void CheckNothingElse(const vtkHapticCliTouchOptions& options)
{
  const std::string asked = options.TwoD                                     ? "--two-d"
                            : !options.Materials.Empty()                     ? "an array of the material"
                            : options.Settings.Number("ForceShading") != 0.0 ? "--shading"
                            : options.Settings.Number("LineRadius") != 0.0   ? "--line-radius"
                            : !options.Tool.File.empty()                     ? "--tool"
                            : options.Field.Any()                            ? "--field"
                            : options.Iso                                    ? "--iso"
                                                                             : "";
  if (!asked.empty())
  {
    throw vtkHapticCliProblem(asked + ": a soft body is not felt with it; leave out this or --young");
  }
}
} // namespace

std::unique_ptr<palpate::BodyMaker> vtkHapticCliBodyOf(const vtkHapticCliTouchOptions& options)
{
  if (!options.Soft.Young_Pa)
  {
    return nullptr;
  }
  CheckNothingElse(options);
  const std::string& file = options.Files.front();
  std::string problem;
  double rough = 0.0;
  const auto grid = ReadBody(file, rough, problem);
  const vtkHapticSoftMaterial material{ *options.Soft.Young_Pa, options.Soft.Poisson, ModelOf(options.Soft.Model),
    1.0 / options.Settings.Number("Scale") };
  std::unique_ptr<palpate::BodyMaker> body;
  if (grid && vtkHapticFixBody(*grid, options.Soft.Fixed, rough, problem) &&
      vtkHapticDescribeBody(*grid, material, "", problem))
  {
    body = palpate::BodyMaker::make(*vtkHapticToSoftBody(grid).Input, file, 0, problem);
  }
  if (!body)
  {
    throw vtkHapticCliProblem(file + ": it cannot give way: " + problem);
  }
  if (const std::string left = body->checked().report.summary(); !left.empty())
  {
    std::cerr << "palpate: " << file << ": " << left << '\n';
  }
  return body;
}
