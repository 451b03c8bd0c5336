// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticContactState_h
#define vtkHapticContactState_h

#include "haptics/tick/base/HapticState.h"
#include "vtkHapticMarkRecords.h"
#include "vtkHapticSourceProbe.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// The data of the last look-up at the contact, and the marks.
struct vtkHapticContactState
{
  std::optional<palpate::HapticState>
    Last; ///< with the last contact in this scene, of the present touch or the last one
  std::optional<vtkHapticMarkRecord> Found; ///< found at the contact
  std::string Text;
  std::string Arrays;
  double Position[3] = { 0.0, 0.0, 0.0 };
  double Normal[3] = { 0.0, 0.0, 0.0 };
  double Curvature[2] = { 0.0, 0.0 };
  vtkHapticSourceProbe Probe;

  vtkHapticMarkRecords Marks;
  std::string SavedMarks;      ///< the text of those that were written or read last
  std::vector<int> MarkStates; ///< one a mark
  std::string MarksNote;       ///< of those that are stale
  std::uint32_t MarkButtons =
    ~0u; ///< that were down at the last reading; a button down at the first reading was not pressed
};

#endif
