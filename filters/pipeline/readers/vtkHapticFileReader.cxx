// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticFileReader.h"

#include <optional>

#include "vtkHapticReaders.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkHapticFileReader);

vtkHapticFileReader::vtkHapticFileReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkHapticFileReader::~vtkHapticFileReader()
{
  this->SetFileName(nullptr);
}

int vtkHapticFileReader::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  if (!this->FileName)
  {
    vtkErrorMacro("A file name is needed");
    return 0;
  }
  const vtkHapticReadResult result = vtkHapticReadSurface(this->FileName, std::nullopt);
  if (!result.Surface)
  {
    vtkErrorMacro(<< result.Problem);
    return 0;
  }
  vtkPolyData::GetData(outputVector)->ShallowCopy(result.Surface);
  return 1;
}

void vtkHapticFileReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << '\n';
}
