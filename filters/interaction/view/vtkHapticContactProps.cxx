// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticContactProps.h"

#include "vtkArrowSource.h"
#include "vtkHapticSession.h"
#include "vtkHapticSight.h"
#include "vtkLookupTable.h"

namespace
{
/// Colours that are told apart by those who do not see red or green either (Okabe and Ito 2008).
constexpr double Colours[][3] = { { 0.84, 0.37, 0.0 }, { 0.0, 0.45, 0.70 }, { 0.0, 0.62, 0.45 }, { 0.80, 0.47, 0.65 },
  { 0.94, 0.89, 0.26 }, { 0.34, 0.71, 0.91 } };
constexpr int Count = static_cast<int>(std::size(Colours));
constexpr int arrowResolution = 16;
} // namespace

vtkHapticContactProps::vtkHapticContactProps()
{
  vtkNew<vtkArrowSource> arrow;
  arrow->SetTipResolution(arrowResolution);
  arrow->SetShaftResolution(arrowResolution);
  vtkNew<vtkLookupTable> colours;
  colours->SetNumberOfTableValues(Count);
  for (int i = 0; i < Count; ++i)
  {
    colours->SetTableValue(i, Colours[i][0], Colours[i][1], Colours[i][2]);
  }
  colours->SetTableRange(-0.5, Count - 0.5);
  this->Mapper->SetInputData(this->Forces);
  this->Mapper->SetSourceConnection(arrow->GetOutputPort());
  this->Mapper->SetOrientationArray("Force");
  this->Mapper->SetOrientationModeToDirection();
  this->Mapper->SetScaleArray("Force");
  this->Mapper->SetScaleModeToScaleByMagnitude();
  this->Mapper->SetScalarModeToUsePointFieldData();
  this->Mapper->SelectColorArray("Pair");
  this->Mapper->SetLookupTable(colours);
  this->Mapper->UseLookupTableScalarRangeOn();
  this->Arrows->SetMapper(this->Mapper);
}

void vtkHapticContactProps::UpdateFrom(vtkHapticSession* session, double perNewton)
{
  const bool wanted = session->IsOn("ShowContactForces");
  if (wanted)
  {
    session->GetSight()->GetContactForces(this->Forces);
    this->Mapper->SetScaleFactor(perNewton);
  }
  this->Arrows->SetVisibility(wanted && this->Forces->GetNumberOfPoints() > 0);
}
