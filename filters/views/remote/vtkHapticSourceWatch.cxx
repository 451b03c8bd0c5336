// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticSourceWatch.h"

#include "vtkCommand.h"
#include "vtkSMSourceProxy.h"

vtkHapticSourceWatch::vtkHapticSourceWatch(vtkSMSourceProxy* source)
  : Source(source), Observer(source->AddObserver(vtkCommand::UpdateDataEvent, this, &vtkHapticSourceWatch::Change))
{
}

vtkHapticSourceWatch::~vtkHapticSourceWatch()
{
  if (this->Source)
  {
    this->Source->RemoveObserver(this->Observer);
  }
}

vtkSMSourceProxy* vtkHapticSourceWatch::GetSource() const
{
  return this->Source;
}
