// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticLabyrinthData.h"

#include "haptics/labyrinth/CorridorWidth.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkHapticConversion.h"
#include "vtkHapticReaders.h"
#include "vtkPolyData.h"

namespace
{
std::optional<Eigen::Vector2d> Place(vtkDataObject* data, const char* name)
{
  vtkDataArray* const array = data->GetFieldData() ? data->GetFieldData()->GetArray(name) : nullptr;
  if (!array || array->GetNumberOfTuples() < 1 || array->GetNumberOfComponents() < 2)
  {
    return std::nullopt;
  }
  return Eigen::Vector2d(array->GetComponent(0, 0), array->GetComponent(0, 1));
}

/// As the data say; else measured along the path; else, for a structure or without a visible path, a twentieth of the
/// longer side, which makes the disc a hundredth of it.
double Corridor(vtkDataObject* data, const palpate::Labyrinth& labyrinth)
{
  vtkDataArray* const array = data->GetFieldData() ? data->GetFieldData()->GetArray("Corridor") : nullptr;
  if (array && array->GetNumberOfValues() > 0)
  {
    return array->GetComponent(0, 0);
  }
  const std::optional<double> width_u = palpate::corridorWidth(labyrinth);
  const palpate::PlaneBox box = palpate::fence(labyrinth);
  return width_u ? *width_u : 0.05 * (box.high_W - box.low_W).maxCoeff();
}
} // namespace

vtkHapticLabyrinthResult vtkHapticToLabyrinth(
  vtkDataObject* data, const std::string& name, std::optional<double> corridor_u)
{
  vtkHapticLabyrinthResult result;
  result.Labyrinth.name = name;
  const vtkHapticConversionResult lines = vtkHapticToLines(data);
  if (!lines.Mesh)
  {
    result.Problem = name + ": " + lines.Problem;
    return result;
  }
  palpate::PlaneCurves plane = palpate::curvesInPlane(*lines.Mesh);
  if (!plane.refusal.empty())
  {
    result.Problem = name + ": " + plane.refusal;
    return result;
  }
  result.Labyrinth.curves = std::move(plane.curves);
  result.Labyrinth.start_W = Place(data, "Start");
  result.Labyrinth.exit_W = Place(data, "Exit");
  result.Labyrinth.corridor_u = corridor_u ? *corridor_u : Corridor(data, result.Labyrinth);
  result.Problem = palpate::refuseWorld(result.Labyrinth);
  return result;
}

vtkHapticLabyrinthResult vtkHapticReadLabyrinth(const std::string& file, std::optional<double> corridor_u)
{
  const vtkHapticReadResult read = vtkHapticReadSurface(file, std::nullopt);
  if (!read.Surface)
  {
    vtkHapticLabyrinthResult result;
    result.Labyrinth.name = file;
    result.Problem = read.Problem;
    return result;
  }
  vtkHapticLabyrinthResult result = vtkHapticToLabyrinth(read.Surface, file, corridor_u);
  result.Note = read.Note;
  return result;
}
