// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticResampledField_h
#define vtkHapticResampledField_h

#include "vtkHapticFieldData.h"

class vtkDataSet;

/// Any data set but an image, probed by VTK on a lattice whose spacing is half of the length of its cells, or half of
/// the distance of its points where it has no cells. `parts` are its data sets; the arrays are known to be there.
vtkHapticFieldResult vtkHapticResampled(
  vtkDataObject* data, const std::vector<vtkDataSet*>& parts, const vtkHapticFieldArrays& arrays);

#endif
