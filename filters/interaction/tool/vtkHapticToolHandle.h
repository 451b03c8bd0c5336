// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticToolHandle_h
#define vtkHapticToolHandle_h

/// What of a tool is where the hand is: the numbers of the property ToolHandle.
enum class vtkHapticToolHandle
{
  Centre, ///< of mass
  Origin, ///< of its data
  Handle, ///< a point that is given
};

#endif
