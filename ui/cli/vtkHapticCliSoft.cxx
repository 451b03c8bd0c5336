// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticCliSoft.h"

#include <iostream>

#include "vtkHapticBodyFile.h"
#include "vtkHapticCliProblem.h"
#include "vtkHapticSoftBodyData.h"

namespace
{
/// Tells what a person is to know of how the body was filled.
vtkHapticTetraFillResult ReadBody(const std::string& file)
{
  vtkHapticTetraFillResult body = vtkHapticReadBody(file, {});
  if (!body.Grid)
  {
    throw vtkHapticCliProblem(body.Problem);
  }
  if (!body.Note.empty())
  {
    std::cerr << "palpate: " << file << ": " << body.Note << '\n';
  }
  return body;
}

/// What a soft body is not felt with would be lost.
void CheckBodyAlone(const vtkHapticCliTouchOptions& options)
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
  CheckBodyAlone(options);
  const std::string& file = options.Files.front();
  std::string problem;
  const vtkHapticTetraFillResult read = ReadBody(file);
  vtkHapticSoftMaterial material{ *options.Soft.Young_Pa, options.Soft.Poisson, palpate::ElasticModel::Linear,
    1.0 / options.Settings.Number("Scale") };
  (void)vtkHapticModelOf(options.Soft.Model, material.Model); // the command line knows no other names
  std::unique_ptr<palpate::BodyMaker> body;
  if (vtkHapticFixBody(*read.Grid, options.Soft.Fixed, read.Rough, problem) &&
      vtkHapticDescribeBody(*read.Grid, material, "", problem))
  {
    body = palpate::BodyMaker::make(*vtkHapticToSoftBody(read.Grid).Input, file, 0, problem);
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
