// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticPieces.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkStreamingDemandDrivenPipeline.h"

std::string vtkHapticRefusePieces(vtkInformationVector* output)
{
  vtkInformation* const info = output->GetInformationObject(0);
  const auto pieces = vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES();
  const int count = info->Has(pieces) ? info->Get(pieces) : 1;
  return count <= 1 ? ""
                    : "the data are spread over " + std::to_string(count) +
                        " processes, and a part of them cannot be measured; open them with a server of one process";
}
