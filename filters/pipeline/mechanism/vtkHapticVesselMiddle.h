// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticVesselMiddle_h
#define vtkHapticVesselMiddle_h

#include "haptics/core/Types.h"
#include "vtkHapticPipelineModule.h" // for the export macro

class vtkPolyData;

/// The middle of a vessel's section through a point and across a direction, as the circle of least squares through
/// places of the wall all around (Kasa 1976). A point on the wall counts as on the side where the wall is around it.
/// The same point where no wall is all around, or the circle's middle is outside of the wall.
[[nodiscard]] VTKHAPTICPIPELINE_EXPORT palpate::Vec3 vtkHapticVesselMiddle(
  vtkPolyData& vessel, const palpate::Vec3& point_W, const palpate::Vec3& direction_W);

#endif
