// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticMarksSource.h"

#include "vtkHapticMarkRecords.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkHapticMarksSource);

vtkHapticMarksSource::vtkHapticMarksSource()
{
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(2);
}

vtkHapticMarksSource::~vtkHapticMarksSource()
{
  this->SetText(nullptr);
}

void vtkHapticMarksSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Text: " << (this->Text ? this->Text : "(none)") << '\n';
}

int vtkHapticMarksSource::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkTable");
  return 1;
}

int vtkHapticMarksSource::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  vtkHapticMarkRecords marks;
  if (const std::string problem = marks.FromText(this->Text ? this->Text : ""); !problem.empty())
  {
    vtkErrorMacro(<< problem);
    return 0;
  }
  marks.FillPoints(vtkPolyData::GetData(output, 0));
  marks.FillTable(vtkTable::GetData(output, 1));
  return 1;
}
