// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticContactForce.h"

#include "haptics/geometry/measure/ContactPlace.h"
#include "haptics/session/mechanism/MechanismBodies.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cstddef>

namespace
{
/// The held mesh goes without saying; a wire is pressed by its own vessel.
std::string NameOf(const palpate::FoundPress& press, const palpate::Mechanism& mechanism)
{
  const auto& mesh = mechanism.bodies[static_cast<std::size_t>(press.mesh)];
  const auto& body = mechanism.bodies[static_cast<std::size_t>(press.body)];
  return mesh.kind == palpate::MechanismBodyKind::Held || press.mesh == press.body ? body.name
                                                                                   : mesh.name + " on " + body.name;
}
} // namespace

std::vector<vtkHapticContactForce> vtkHapticToolForces(
  const palpate::HapticState& state, const palpate::Scene& scene, double scale_u_per_m)
{
  std::vector<vtkHapticContactForce> forces;
  for (int i = 0; i < state.tool.active; ++i)
  {
    const palpate::ToolPress& press = state.tool.presses[static_cast<std::size_t>(i)];
    const auto place = palpate::placeOf(scene, press.p_W, press.p_W - press.n_W);
    const double force_N = state.stiffness_N_per_m * press.push_u / scale_u_per_m;
    forces.push_back({ press.p_W, force_N * press.n_W, place ? place->surface : "?" });
  }
  return forces;
}

std::vector<vtkHapticContactForce> vtkHapticFoundForces(
  const palpate::MechanismNow& now, const palpate::MechanismInputs& inputs)
{
  std::vector<vtkHapticContactForce> forces;
  const auto bodies = static_cast<int>(inputs.mechanism.bodies.size());
  std::for_each_n(now.found.begin(), now.touching,
    [&](const palpate::FoundPress& press)
    {
      if (std::max(press.mesh, press.body) < bodies) // another mechanism may have been chosen since that tick
      {
        forces.push_back({ press.at_W, press.force_W, NameOf(press, inputs.mechanism) });
      }
    });
  return forces;
}

void vtkHapticPutForces(const std::vector<vtkHapticContactForce>& forces, vtkPolyData& points)
{
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("Force");
  vectors->SetNumberOfComponents(3);
  vtkNew<vtkStringArray> names;
  names->SetName("Touched");
  vtkNew<vtkIntArray> pairs;
  pairs->SetName("Pair");
  std::vector<std::string> known;
  for (const vtkHapticContactForce& force : forces)
  {
    places->InsertNextPoint(force.At_W.data());
    vectors->InsertNextTuple(force.Force_N.data());
    names->InsertNextValue(force.Touched);
    const auto pair = std::find(known.begin(), known.end(), force.Touched);
    pairs->InsertNextValue(static_cast<int>(pair - known.begin()));
    if (pair == known.end())
    {
      known.push_back(force.Touched);
    }
  }
  points.Initialize();
  points.SetPoints(places);
  points.GetPointData()->AddArray(vectors);
  points.GetPointData()->AddArray(names);
  points.GetPointData()->AddArray(pairs);
}
