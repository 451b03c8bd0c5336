// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/compliance/snapshot/ComplianceSnapshot.h"

namespace palpate
{

/// A contact point and its local compliance beyond the interpolated one of the triangle's corners.
///
/// Between vertices the bilinear form of their compliance is up to 13 % too stiff (a patch of two edges), which is felt
/// as facets. The mean of the corners' own compliance is that of a patch around the point within .5 %: `own` is the
/// root of the difference, M = own own^T.
struct CompliantPoint
{
  SurfacePoint at;
  Mat3 own = Mat3::Zero();
  double patch_u = 1.0; ///< radius of the patch here
};

[[nodiscard]] CompliantPoint compliantPoint(const ComplianceSnapshot& snapshot, const SurfacePoint& at) noexcept;

/// Displacement of `a` per force on `b` [u/N]. For any set of points this is a positive semidefinite matrix, and points
/// that coincide share one compliance: the local part decays with distance by a kernel that is positive
/// definite also for unequal patches.
[[nodiscard]] Mat3 complianceBetween(
  const ComplianceSnapshot& snapshot, const CompliantPoint& a, const CompliantPoint& b) noexcept;

/// Overlap of two points, from 1 for one and the same to 0 far away: about exp(-(d/a)^2) where their
/// patches have the radius a. For any set of points a positive semidefinite matrix.
[[nodiscard]] double sharedBy(const CompliantPoint& a, const CompliantPoint& b) noexcept;

/// The spring in series at a point, interpolated between the vertices'.
[[nodiscard]] SubgridSpring springAt(const ComplianceSnapshot& snapshot, const SurfacePoint& at) noexcept;

} // namespace palpate
