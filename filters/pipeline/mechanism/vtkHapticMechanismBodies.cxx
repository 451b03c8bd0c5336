// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticMechanismBodies.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "haptics/core/PoseMath.h"
#include "vtkDataSetTriangleFilter.h"
#include "vtkHapticBodyFile.h"
#include "vtkHapticConversion.h"
#include "vtkHapticReaders.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

namespace
{
constexpr int UsualCells = 8;     // along the longest side of a box
constexpr double MostCells = 2e5; // of a box: beyond, memory of the factor decides

/// A box of cells, each of which VTK cuts into five tetrahedra.
vtkSmartPointer<vtkUnstructuredGrid> BoxOf(const vtkHapticSoftDescription& description, std::string& problem)
{
  const palpate::Vec3& size = description.BoxSize_u;
  const double edge = description.Edge_u > 0.0 ? description.Edge_u : size.maxCoeff() / UsualCells;
  if (!(size.minCoeff() > 0.0) || !(edge > 0.0))
  {
    problem = "the sizes of a box and the edge of its cells must be above 0";
    return nullptr;
  }
  const palpate::Vec3 cells = (size / edge).array().round().max(1.0);
  if (!(cells.prod() <= MostCells))
  {
    problem = "a box has at most 200000 cells: use a longer edge";
    return nullptr;
  }
  vtkNew<vtkImageData> image;
  image->SetDimensions(
    static_cast<int>(cells.x()) + 1, static_cast<int>(cells.y()) + 1, static_cast<int>(cells.z()) + 1);
  const palpate::Vec3 spacing = size.cwiseQuotient(cells), low = description.BoxMiddle_W - 0.5 * size;
  image->SetSpacing(spacing.data());
  image->SetOrigin(low.data());
  vtkNew<vtkDataSetTriangleFilter> cut;
  cut->SetInputData(image);
  cut->Update();
  return cut->GetOutput();
}
} // namespace

vtkHapticDescribedSoft vtkHapticMakeSoft(const vtkHapticSoftDescription& description, const std::string& folder)
{
  vtkHapticDescribedSoft made;
  vtkHapticTetraFillResult body;
  if (description.File.empty())
  {
    body.Grid = BoxOf(description, body.Problem);
  }
  else
  {
    palpate::TetraSizes sizes;
    sizes.edge_u = description.Edge_u;
    body = vtkHapticReadBody((std::filesystem::path(folder) / description.File).string(), sizes);
  }
  made.Grid = body.Grid;
  made.Problem = body.Problem;
  if (made.Grid && vtkHapticFixBody(*made.Grid, description.Fixed, body.Rough, made.Problem) &&
      vtkHapticDescribeBody(*made.Grid, description.Material, "", made.Problem))
  {
    const vtkHapticSoftBodyResult described = vtkHapticToSoftBody(made.Grid);
    made.Input = described.Input;
    made.Problem = described.Problem;
  }
  return made;
}

palpate::Outcome<std::shared_ptr<const palpate::SidedSurface>> vtkHapticReadRigidMesh(
  const std::string& file, const std::string& folder, const palpate::Pose& place_W)
{
  const std::string path = (std::filesystem::path(folder) / file).string();
  const vtkHapticReadResult read = vtkHapticReadSurface(path, {});
  if (!read.Surface)
  {
    return { nullptr, read.Problem };
  }
  const vtkHapticConversionResult converted = vtkHapticToMesh(read.Surface);
  if (!converted.Mesh)
  {
    return { nullptr, path + ": " + converted.Problem };
  }
  palpate::TriangleMesh mesh = *converted.Mesh;
  std::ranges::transform(mesh.vertices_W, mesh.vertices_W.begin(), [&](const palpate::Vec3& p) { return place_W * p; });
  auto made = palpate::makeRigidMesh(mesh);
  made.problem = made.ok() ? "" : path + ": " + made.problem;
  return made;
}
