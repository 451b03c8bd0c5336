// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticMeasuredSurface.h"

#include "haptics/geometry/mesh/TriangleMesh.h"
#include "vtkHapticConversion.h"

std::shared_ptr<const palpate::SurfaceTree> vtkHapticMeasuredSurface(vtkDataObject* data, std::string& problem)
{
  const vtkHapticConversionResult converted = vtkHapticToMesh(data);
  problem = converted.Problem;
  if (!converted.Mesh)
  {
    return nullptr;
  }
  palpate::CleanResult clean = palpate::cleanMesh(*converted.Mesh);
  problem = clean.refusal;
  return clean.ok() ? std::make_shared<const palpate::SurfaceTree>(std::move(clean.mesh)) : nullptr;
}
