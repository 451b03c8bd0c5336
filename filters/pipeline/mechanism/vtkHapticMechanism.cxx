// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticMechanism.h"

#include <filesystem>
#include <utility>

#include "haptics/session/mechanism/MechanismTouch.h"
#include "vtkHapticMechanismData.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkHapticMechanism);

vtkHapticMechanism::vtkHapticMechanism()
{
  this->SetNumberOfInputPorts(0);
}

vtkHapticMechanism::~vtkHapticMechanism() = default;

void vtkHapticMechanism::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << '\n';
  os << indent << "Problem: " << this->Problem << '\n';
  os << indent << "Text: " << this->Text << '\n';
}

void vtkHapticMechanism::SetFileName(const std::string& file)
{
  this->FileName = file;
  this->ReadAgain();
}

void vtkHapticMechanism::ReadAgain()
{
  this->AskAgain();
  this->Modified();
}

void vtkHapticMechanism::ShowMoved(vtkPolyData* moved)
{
  this->Moved = moved;
  this->Modified();
}

vtkHapticMechanismResult vtkHapticMechanism::ReadScene()
{
  return vtkHapticReadMechanism(this->FileName);
}

vtkSmartPointer<vtkPolyData> vtkHapticMechanism::Make()
{
  this->Text.clear();
  const std::string folder = std::filesystem::path(this->FileName).parent_path().string();
  const vtkHapticMechanismResult read = this->ReadScene();
  this->Problem = read.Problem;
  const auto bodies = read.Inputs ? palpate::MechanismBodies::make(read.Inputs->soft, this->Problem) : nullptr;
  if (!bodies)
  {
    return nullptr;
  }
  const palpate::MechanismCheck check = palpate::checkMechanism(
    read.Inputs->mechanism, bodies->atRest(), palpate::gripOf(palpate::usualHold(read.Inputs->unit_m)));
  const std::string faults = palpate::faultsOf(check);
  this->Problem = faults.empty() || this->FileName.empty() ? faults : this->FileName + ": " + faults;
  for (const std::string& line : vtkHapticMechanismText(*read.Inputs, check))
  {
    this->Text += line + '\n';
  }
  const vtkSmartPointer<vtkPolyData> shapes = vtkHapticMechanismShapes(read);
  vtkHapticDescribeMechanism(*shapes, read.Text, folder);
  if (read.VesselGiven)
  {
    vtkHapticDescribeVessel(*shapes);
  }
  return this->Problem.empty() ? shapes : nullptr;
}

/// Files are read when they are asked for and not for another picture: a refusal is told once.
int vtkHapticMechanism::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  if (std::exchange(this->Asked, false))
  {
    this->Moved = nullptr;
    this->AtFirst = this->Make();
    if (!this->Problem.empty())
    {
      vtkErrorMacro(<< this->Refusal << this->Problem);
    }
  }
  vtkPolyData* const shown = this->Moved ? this->Moved : this->AtFirst;
  shown ? vtkPolyData::GetData(output)->ShallowCopy(shown) : vtkPolyData::GetData(output)->Initialize();
  return 1;
}
