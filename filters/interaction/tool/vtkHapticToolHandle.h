// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticToolHandle_h
#define vtkHapticToolHandle_h

/// Point of the tool that coincides with the hand: the numbers of the property ToolHandle.
enum class vtkHapticToolHandle
{
  Centre, ///< of mass
  Origin, ///< of its data
  Handle, ///< a point that is given
};

#endif
