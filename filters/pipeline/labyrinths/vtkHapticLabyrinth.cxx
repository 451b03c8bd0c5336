// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticLabyrinth.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkHapticGallery.h"
#include "vtkHapticLabyrinthData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkHapticLabyrinth);

namespace
{
void AddField(vtkPolyData* data, const char* name, const std::vector<double>& values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(values.size()));
  array->InsertNextTuple(values.data());
  data->GetFieldData()->AddArray(array);
}

void Write(const palpate::Labyrinth& labyrinth, vtkPolyData* output)
{
  const palpate::CurveSet curves = palpate::fenced(labyrinth);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Eigen::Vector2d& p : curves.points_W)
  {
    points->InsertNextPoint(p.x(), p.y(), 0.0);
  }
  vtkNew<vtkCellArray> lines;
  for (const auto& [a, b] : curves.segments)
  {
    lines->InsertNextCell({ static_cast<vtkIdType>(a), static_cast<vtkIdType>(b) });
  }
  output->SetPoints(points);
  output->SetLines(lines);
  if (labyrinth.start_W)
  {
    AddField(output, "Start", { labyrinth.start_W->x(), labyrinth.start_W->y(), 0.0 });
  }
  if (labyrinth.exit_W)
  {
    AddField(output, "Exit", { labyrinth.exit_W->x(), labyrinth.exit_W->y(), 0.0 });
  }
  AddField(output, "Corridor", { labyrinth.corridor_u });
}
} // namespace

vtkHapticLabyrinth::vtkHapticLabyrinth()
{
  this->SetNumberOfInputPorts(0);
}

vtkHapticLabyrinth::~vtkHapticLabyrinth() = default;

int vtkHapticLabyrinth::GetNumberOfWorlds()
{
  return static_cast<int>(vtkHapticGallery::Names().size());
}

std::string vtkHapticLabyrinth::GetWorldName(int index)
{
  const std::vector<std::string> names = vtkHapticGallery::Names();
  return index >= 0 && index < static_cast<int>(names.size()) ? names[static_cast<std::size_t>(index)] : std::string();
}

int vtkHapticLabyrinth::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  const std::optional<double> corridor_u = this->Corridor > 0.0 ? std::optional(this->Corridor) : std::nullopt;
  const vtkHapticLabyrinthResult read = vtkHapticReadLabyrinth(vtkHapticGallery::FileOf(this->World), corridor_u);
  if (!read.Problem.empty())
  {
    vtkErrorMacro(<< read.Problem);
    return 0;
  }
  Write(read.Labyrinth, vtkPolyData::GetData(output));
  return 1;
}

void vtkHapticLabyrinth::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "World: " << this->World << "\n";
  os << indent << "Corridor: " << this->Corridor << "\n";
}
