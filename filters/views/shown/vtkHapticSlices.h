// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticSlices_h
#define vtkHapticSlices_h

#include <cstdint>

#include "vtkHapticShape.h"
#include "vtkHapticViewsModule.h" // for the export macro

class vtkPVImageSliceMapper;

/// The image slice that a mapper draws, where it draws it, as lines: the contour half way between the least and the
/// largest value of the array that colours it (vtkImageCurves).
[[nodiscard]] VTKHAPTICVIEWS_EXPORT vtkHapticShape vtkHapticSliceOf(vtkPVImageSliceMapper* mapper);

/// Names all that these curves depend on: equal keys mean equal curves.
[[nodiscard]] VTKHAPTICVIEWS_EXPORT std::uint64_t vtkHapticSliceKey(vtkPVImageSliceMapper* mapper);

#endif
