// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticMechanism.h"

#include <filesystem>
#include <utility>

#include "haptics/session/mechanism/MechanismTouch.h"
#include "vtkHapticMechanismData.h"
#include "vtkHapticWholeInput.h"
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
  os << indent << "Text: " << this->Text << '\n';
}

/// The same name reads the file again: it may be another one by now.
void vtkHapticMechanism::SetFileName(const std::string& file)
{
  this->FileName = file;
  this->OnlyMoves = false;
  this->Modified();
}

void vtkHapticMechanism::ShowMoved(vtkPolyData* moved)
{
  this->Moved = moved;
  this->OnlyMoves = this->AtFirst != nullptr;
  this->Modified();
}

vtkSmartPointer<vtkPolyData> vtkHapticMechanism::Make(std::string& problem)
{
  this->Text.clear();
  const vtkHapticMechanismResult read = vtkHapticReadMechanism(this->FileName);
  problem = read.Problem;
  const auto bodies = read.Inputs ? palpate::MechanismBodies::make(read.Inputs->soft, problem) : nullptr;
  if (!bodies)
  {
    return nullptr;
  }
  const palpate::MechanismCheck check = palpate::checkMechanism(
    read.Inputs->mechanism, bodies->atRest(), palpate::gripOf(palpate::usualHold(read.Inputs->unit_m)));
  problem = palpate::faultsOf(check);
  for (const std::string& line : vtkHapticMechanismText(*read.Inputs, check))
  {
    this->Text += line + '\n';
  }
  const vtkSmartPointer<vtkPolyData> shapes = vtkHapticMechanismShapes(read);
  vtkHapticDescribeMechanism(*shapes, read.Text, std::filesystem::path(this->FileName).parent_path().string());
  return problem.empty() ? shapes : nullptr;
}

int vtkHapticMechanism::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  std::string problem;
  if (!std::exchange(this->OnlyMoves, false))
  {
    this->Moved = nullptr;
    this->AtFirst = this->Make(problem);
  }
  if (!problem.empty())
  {
    vtkErrorMacro("There is no such mechanism: " << problem);
    // A source of one piece is not asked on the other ranks, which go on, and would wait for this one.
    return vtkHapticRanks() > 1 ? 1 : 0;
  }
  vtkPolyData::GetData(output)->ShallowCopy(this->Moved ? this->Moved : this->AtFirst);
  return 1;
}
