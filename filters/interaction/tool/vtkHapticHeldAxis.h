// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticHeldAxis_h
#define vtkHapticHeldAxis_h

#include "haptics/core/Types.h"

/// Where a thing in the hand points, in its own frame B, whose origin is in the hand.
struct vtkHapticHeldAxis
{
  palpate::Vec3 Tip_B;                          ///< the point that a person aims with [u]
  palpate::Vec3 Along_B;                        ///< the axis along which the thing is advanced, a unit vector
  palpate::Quat Begin_WB{ 1.0, 0.0, 0.0, 0.0 }; ///< how the thing is turned when it is taken
};

#endif
