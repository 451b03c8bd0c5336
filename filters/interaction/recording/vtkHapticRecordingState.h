// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticRecordingState_h
#define vtkHapticRecordingState_h

#include <string>

/// What is recorded of a session, and the last recording that is whole.
struct vtkHapticRecordingState
{
  std::string File;   ///< the last that is whole
  bool Saved = false; ///< under a name that the person gave
  double Begun_s = 0.0;
  double Seconds = 0.0;
  std::string Text;
};

#endif
