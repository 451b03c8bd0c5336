// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticStrokeProfile_h
#define vtkHapticStrokeProfile_h

#include <optional>
#include <vector>

#include "haptics/geometry/mesh/TriangleMesh.h"

/// The frame of a cut: s runs along Along, h along Up, both unit and orthogonal.
struct vtkHapticCutFrame
{
  palpate::Vec3 Origin_W;
  palpate::Vec3 Along_W;
  palpate::Vec3 Up_W;
};

/// Heights h [u] of the profile over places s = First + i Step [u].
struct vtkHapticHeights
{
  double First = 0.0;
  double Step = 1.0;
  std::vector<double> Height;

  [[nodiscard]] double At(std::size_t i) const { return this->First + static_cast<double>(i) * this->Step; }
};

/// The outermost point of the cut surface over each place; -infinity where nothing is cut. Empty if the plane misses
/// the mesh, or if there would be more than `most` places.
[[nodiscard]] std::optional<vtkHapticHeights> vtkHapticCutProfile(
  const palpate::TriangleMesh& mesh, const vtkHapticCutFrame& frame, double step, std::size_t most);

/// The longest run of places that are cut and rise or fall by at most `cliff` from one to the next; the first of
/// equals.
[[nodiscard]] vtkHapticHeights vtkHapticLongestRun(const vtkHapticHeights& profile, double cliff);

/// The middle `reach` (0..1] of a profile.
[[nodiscard]] vtkHapticHeights vtkHapticMiddle(const vtkHapticHeights& profile, double reach);

/// Erosion and mean over 2 half + 1 places (fewer at the ends): smooth, and nowhere above the input.
[[nodiscard]] std::vector<double> vtkHapticSmoothBelow(const std::vector<double>& heights, std::size_t half);

#endif
