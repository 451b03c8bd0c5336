// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticCheckState_h
#define vtkHapticCheckState_h

#include "devices/calibration/SelfTestRun.h"

#include <string>

/// The check of a device, and its last report.
struct vtkHapticCheckState
{
  palpate::SelfTestRun Run;
  bool Begun = false; ///< a check was started
  bool Twin = false;  ///< of a device that had a twin then
  std::string Ask;
  std::string Result;
};

#endif
