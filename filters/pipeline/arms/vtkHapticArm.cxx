// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticArm.h"

#include "haptics/arm/ArmSkeleton.h"
#include "haptics/arm/ArmWorkSpaceMap.h"
#include "haptics/arm/file/ArmFile.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkHapticArm);

namespace
{
void DrawLinks(const palpate::Arm& arm, const palpate::JointVector& q, double scale, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (const std::vector<palpate::Vec3>& line : palpate::skeletonOf(arm, q))
  {
    lines->InsertNextCell(static_cast<int>(line.size()));
    for (const palpate::Vec3& p : line)
    {
      lines->InsertCellPoint(points->InsertNextPoint(scale * p.x(), scale * p.y(), scale * p.z()));
    }
  }
  output->SetPoints(points);
  output->SetLines(lines);
}

vtkDoubleArray* Add(vtkPolyData* output, const char* name)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  output->GetPointData()->AddArray(array);
  return array; // the output keeps it
}

void DrawWorkSpace(const palpate::Arm& arm, int steps, double scale, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  vtkDoubleArray* const condition = Add(output, "Condition");
  vtkDoubleArray* const force = Add(output, "LargestForce");
  vtkDoubleArray* const mass = Add(output, "ApparentMass");
  for (const palpate::ArmPlace& place : palpate::mapWorkSpace(arm, steps))
  {
    if (!place.reached || !(place.measures.condition < arm.plan().maxCondition))
    {
      continue;
    }
    const vtkIdType id = points->InsertNextPoint(scale * place.p_D.x(), scale * place.p_D.y(), scale * place.p_D.z());
    vertices->InsertNextCell(1, &id);
    condition->InsertNextValue(place.measures.condition);
    force->InsertNextValue(place.measures.leastForce_N);
    mass->InsertNextValue(place.measures.mostMass_kg);
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
  output->GetPointData()->SetActiveScalars("Condition");
}
} // namespace

vtkHapticArm::vtkHapticArm()
{
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(2);
}

vtkHapticArm::~vtkHapticArm() = default;

void vtkHapticArm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Arm: " << this->Arm << '\n';
}

int vtkHapticArm::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  const palpate::Outcome<palpate::ArmPlan> plan = palpate::armNamed(this->Arm);
  if (!plan.ok())
  {
    vtkErrorMacro(<< plan.problem);
    return 0;
  }
  const palpate::Arm arm(plan.value);
  const palpate::Vec3 hand_D = plan.value.workSpace.centre_D + palpate::Vec3(this->Hand);
  if (const std::optional<palpate::JointVector> q = arm.inverse(hand_D))
  {
    DrawLinks(arm, *q, this->Scale, vtkPolyData::GetData(output, 0));
  }
  else
  {
    vtkWarningMacro(<< this->Arm << ": the hand is out of the arm's reach, so that no links are drawn");
  }
  DrawWorkSpace(arm, this->Steps, this->Scale, vtkPolyData::GetData(output, 1));
  return 1;
}
