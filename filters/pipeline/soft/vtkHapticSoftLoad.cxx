// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticSoftLoad.h"

#include <cmath>

#include "vtkDoubleArray.h"
#include "vtkHapticSoftBodyData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

namespace
{
/// A quarter of each tetrahedron's weight is on each of its corners.
void AddWeight(const palpate::SoftBodyInput& input, const palpate::Vec3& gravity, vtkDoubleArray& load)
{
  const double kg_per_u3 = input.density_kg_per_m3 * std::pow(input.unit_m, 3);
  for (const palpate::Tetra& t : input.mesh.tetras)
  {
    const palpate::Vec3 quarter_N = 0.25 * kg_per_u3 * std::abs(palpate::volumeOf(input.mesh, t)) * gravity;
    for (const std::uint32_t v : t)
    {
      load.SetTuple(v, palpate::Vec3(palpate::Vec3(load.GetTuple3(v)) + quarter_N).data());
    }
  }
}
} // namespace

bool vtkHapticLoadBody(
  vtkUnstructuredGrid& body, const palpate::Vec3& gravity, const std::string& loadArray, std::string& problem)
{
  const vtkSmartPointer<vtkDataArray> given =
    loadArray.empty() ? nullptr : body.GetPointData()->GetArray(loadArray.c_str());
  body.GetPointData()->RemoveArray(vtkHapticLoadName); // an array of the input, not a load that was asked for
  const vtkHapticSoftBodyResult read = vtkHapticToSoftBody(&body);
  const bool isLoad = loadArray.empty() || (given && given->GetNumberOfComponents() == 3);
  const bool weighs = gravity.allFinite() && read.Input && read.Input->density_kg_per_m3 > 0.0 &&
                      std::isfinite(read.Input->density_kg_per_m3);
  problem = !read.Input ? read.Problem
            : !isLoad   ? "load: '" + loadArray + "' is not a point array with three components [N]"
            : !weighs   ? "gravity must be finite [m/s2], and the density above 0 [kg/m3]"
                        : "";
  if (!problem.empty() || (!given && gravity.isZero(0.0)))
  {
    return problem.empty();
  }
  vtkNew<vtkDoubleArray> load;
  load->SetName(vtkHapticLoadName);
  load->SetNumberOfComponents(3);
  load->SetNumberOfTuples(body.GetNumberOfPoints());
  load->Fill(0.0);
  for (vtkIdType i = 0; given && i < body.GetNumberOfPoints(); ++i)
  {
    load->SetTuple(i, given->GetTuple3(i));
  }
  AddWeight(*read.Input, gravity, *load);
  body.GetPointData()->AddArray(load);
  return true;
}
