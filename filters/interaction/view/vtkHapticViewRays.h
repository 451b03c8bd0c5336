// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticViewRays_h
#define vtkHapticViewRays_h

#include "haptics/core/Types.h"
#include "vtkRenderer.h"
#include "vtkWeakPointer.h"

/// From the near to the far plane of a camera [u].
struct vtkHapticRay
{
  palpate::Vec3 Near;
  palpate::Vec3 Far;

  palpate::Vec3 Along() const { return (this->Far - this->Near).normalized(); }
};

/// Points of the scene as the camera of a renderer sees them.
class vtkHapticViewRays
{
public:
  vtkWeakPointer<vtkRenderer> Renderer; ///< watched, not kept; all below needs one that is in a window

  /// The ray through a point of the screen [pixels from the lower left corner of the window], or through one of the
  /// scene.
  vtkHapticRay At(double x, double y) const;
  vtkHapticRay Through(const palpate::Vec3& p_W) const;
  palpate::Vec3 EyeOn(const palpate::Vec3& p_W) const;
  double DepthOf(const palpate::Vec3& p_W) const;
  palpate::Vec3 AtDepth(const vtkHapticRay& ray, double depth) const;
};

#endif
