// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticFieldShape_h
#define vtkHapticFieldShape_h

#include "haptics/field/FieldBlock.h"
#include "haptics/field/proxy/FieldPlan.h"

class vtkPolyData;

/// The field within some cells around the proxy, for drawing: the patch of the isosurface as triangles; the streamline
/// that is followed, a square along the level of a detent, and a cross at the place that the hand snaps to, with the
/// line there [u].
void vtkHapticFieldShape(const palpate::FieldBlock& brick, const palpate::FieldPlan& plan, const palpate::Vec3& hand_W,
  const palpate::Vec3& proxy_W, vtkPolyData* shape);

#endif
