// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticSessionPart.h"

vtkHapticSessionPart::vtkHapticSessionPart(vtkHapticSession& session) : Session(&session)
{
  this->InitializeObjectBase();
}

vtkHapticSessionPart::~vtkHapticSessionPart() = default;
