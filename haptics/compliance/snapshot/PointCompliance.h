// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/compliance/snapshot/ComplianceSnapshot.h"

namespace palpate
{

/// A contact point and its local compliance beyond the interpolated one of the triangle's corners.
///
/// Between vertices the bilinear form of their compliance is up to 13 % too stiff (a patch of two edges), which is felt
/// as facets. The mean of the corners' own compliance is that of a patch around the point within .5 %: `own` makes up
/// the difference, M = own own^T.
struct CompliantPoint
{
  SurfacePoint at;
  Mat3 own = Mat3::Zero();
  double patch_u = 1.0; ///< radius of the patch here
};

[[nodiscard]] CompliantPoint compliantPoint(const ComplianceSnapshot& snapshot, const SurfacePoint& at) noexcept;

/// How `a` answers to a force on `b` [u/N]. Of any set of points this is a positive semidefinite matrix, and points
/// that coincide share one compliance: the local part decays with distance by a kernel that is positive
/// definite though patches are not alike.
[[nodiscard]] Mat3 complianceBetween(
  const ComplianceSnapshot& snapshot, const CompliantPoint& a, const CompliantPoint& b) noexcept;

/// How much of a place two points are, from 1 for one and the same to 0 far away: about exp(-(d/a)^2) where their
/// patches have the radius a. Of any set of points a positive semidefinite matrix.
[[nodiscard]] double sharedBy(const CompliantPoint& a, const CompliantPoint& b) noexcept;

/// The spring in series at a point, between the vertices'.
[[nodiscard]] SubgridSpring springAt(const ComplianceSnapshot& snapshot, const SurfacePoint& at) noexcept;

} // namespace palpate
